r"""Text of the user's, made safe for every TeX engine.

No character of a title can start a command, end a group or form a ligature that was
not meant. Greek letters are set in mathematics, which every engine has; runs of
Cyrillic are marked ``\mechccyr{…}``, which switches the font encoding under pdfTeX;
what the standard fonts of pdfTeX do not cover comes with its code point and a spelling,
``\mechcchar{1E90}{Ẑ}{\^{Z}}``: engines whose font has the character print it, the others
the spelling.
"""

import re
import unicodedata
from functools import cache
from itertools import groupby

from ...base.later import pattern
from ...formula.names import GREEK
from .letters import CYRILLIC, LATIN, spelled

_SHAPES = {"phi": "varphi", "epsilon": "varepsilon"}
"""Greek letters in the shape that formulas and pictures have."""

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "`": r"\textasciigrave{}",
    "[": "{[}",
    "]": "{]}",
    "°": r"\ensuremath{{}^\circ}",
    "·": r"\ensuremath{\cdot}",
    "×": r"\ensuremath{\times}",
    "÷": r"\ensuremath{\div}",
    "±": r"\ensuremath{\pm}",
    "−": r"\ensuremath{-}",
    "≤": r"\ensuremath{\leq}",
    "≥": r"\ensuremath{\geq}",
    "≠": r"\ensuremath{\neq}",
    "≈": r"\ensuremath{\approx}",
    "∞": r"\ensuremath{\infty}",
    "√": r"\ensuremath{\surd}",
    "→": r"\ensuremath{\rightarrow}",
    "⊥": r"\ensuremath{\perp}",
    "²": r"\ensuremath{{}^2}",
    "³": r"\ensuremath{{}^3}",
    "ᵣ": r"\ensuremath{{}_r}",
    **{digit: rf"\ensuremath{{{{}}_{i}}}" for i, digit in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    "µ": r"\ensuremath{\mu}",
    "–": r"\textendash{}",
    "—": r"\textemdash{}",
    "‘": r"\textquoteleft{}",
    "’": r"\textquoteright{}",
    "“": r"\textquotedblleft{}",
    "”": r"\textquotedblright{}",
    "„": r"\quotedblbase{}",
    "«": r"\guillemotleft{}",
    "»": r"\guillemotright{}",
    "…": r"\textellipsis{}",
    "№": r"\textnumero{}",
    "‐": "-",
    "‑": "-",
    "‒": r"\textendash{}",
    "′": r"\ensuremath{{}'}",
    "″": r"\ensuremath{{}''}",
    "⌀": r"\O{}",
    "•": r"\textbullet{}",
    "€": r"\texteuro{}",
    "‰": r"\textperthousand{}",
    "†": r"\textdagger{}",
    "∆": r"\ensuremath{\Delta}",
    "∠": r"\ensuremath{\angle}",
    "∥": r"\ensuremath{\parallel}",
    "⟂": r"\ensuremath{\perp}",
    "⋅": r"\ensuremath{\cdot}",
    "∙": r"\ensuremath{\cdot}",
    "∑": r"\ensuremath{\sum}",
    "∝": r"\ensuremath{\propto}",
    "⇒": r"\ensuremath{\Rightarrow}",
    "←": r"\ensuremath{\leftarrow}",
    "↔": r"\ensuremath{\leftrightarrow}",
    "↑": r"\ensuremath{\uparrow}",
    "↓": r"\ensuremath{\downarrow}",
    "\u00a0": "~",
    "\u200b": r"\allowbreak{}",
    "\u200c": r"\kern0pt{}",
} | {
    letter: rf"\ensuremath{{\{_SHAPES.get(name, name)}}}"
    for name, letter in GREEK.items()
    if name != "omicron"
}

_PLAIN = {tex: letter for letter, tex in reversed(_SPECIAL.items()) if len(tex) > 2}

_MARKS = "\u0300-\u036f"
_CLUSTER = pattern(f".[{_MARKS}]*")
"""A character with the marks that no letter of its own has."""

_LIGATURE = pattern("([-',])(?=[-',])")
"""Characters that fonts join when they follow one another, such as ``--``."""

_LONG = pattern(f"([^ ]{{24}}[{_MARKS}]*)(?=[^ ])")
"""A word that a narrow column could not hold: it may break after so many characters."""


def escape(text: str) -> str:
    r"""Return text that prints as itself and does nothing else.

    >>> escape("50% of A&B")
    '50\\% of A\\&B'
    >>> escape("Кран λ")
    '\\mechccyr{Кран} \\ensuremath{\\lambda}'
    """
    plain = "".join(map(_printable, unicodedata.normalize("NFC", text)))
    broken = _LONG.sub("\\1\u200b", re.sub(" +", " ", plain).strip(" "))
    broken = _LIGATURE.sub("\\1\u200c", broken)
    clusters = _CLUSTER.findall(broken)
    return "".join(_run(kind, "".join(run)) for kind, run in groupby(clusters, _kind))


def plain(tex: str) -> str:
    r"""Return text that :func:`escape` has made safe as it was; punctuation keeps its backslash.

    Markdown leaves such a backslash out, and has all letters.

    >>> plain(escape("Кран λ — 50% of Ẑ"))
    'Кран λ — 50\\% of Ẑ'
    """
    return _escaped().sub(lambda found: _PLAIN.get(found[0]) or found[1] or found[2], tex)


@cache
def _escaped() -> re.Pattern[str]:
    """Return the pattern of escaped letters: plain, Cyrillic, or of few fonts."""
    longest_first = sorted(_PLAIN, key=len, reverse=True)
    return re.compile(
        rf"{'|'.join(map(re.escape, longest_first))}|\\mechccyr\{{([^{{}}]*)\}}"
        r"|\\mechcchar\{[0-9A-F]+\}\{(.)\}\{(?:[^{}]|\{[^{}]*\})*\}"
    )


_FIRST = pattern(r"(\\mechccyr\{)?([^\W\d_])(?=[^\W\d_])")
"""The first letter of a text that begins with a word of several."""


def begun(tex: str) -> str:
    r"""Return text that :func:`escape` has made safe as it begins a line: with a capital letter.

    >>> begun("force of one jaw"), begun(escape("сила")), begun("d of the bar")
    ('Force of one jaw', '\\mechccyr{Сила}', 'd of the bar')
    """
    found = _FIRST.match(tex)
    return f"{found[1] or ''}{found[2].upper()}{tex[found.end() :]}" if found else tex


def has_cyrillic(text: str) -> bool:
    """Return whether a text needs a font with Cyrillic letters."""
    return not CYRILLIC.isdisjoint(text)


def _printable(character: str) -> str:
    """Turn every kind of white space into a space and drop control characters."""
    if character.isspace() and character != "\u00a0":
        return " "
    return "" if unicodedata.category(character) in {"Cc", "Cf", "Cs", "Co", "Cn"} else character


def _kind(cluster: str) -> str:
    if cluster in _SPECIAL:
        return "special"
    if cluster in CYRILLIC:
        return "cyrillic"
    return "latin" if cluster in LATIN else "other"


def _run(kind: str, run: str) -> str:
    match kind:
        case "special":
            return "".join(_SPECIAL[c] for c in run)
        case "cyrillic":
            return rf"\mechccyr{{{run}}}"
        case "latin":
            return run
        case _:
            return "".join(map(_with_spelling, _CLUSTER.findall(run)))


def _with_spelling(cluster: str) -> str:
    return rf"\mechcchar{{{ord(cluster[0]):04X}}}{{{cluster}}}{{{spelled(cluster)}}}"
