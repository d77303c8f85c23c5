r"""Text of the user's, made safe for every TeX engine.

No character of a title can start a command, end a group or form a ligature that was
not meant. Greek letters are set in mathematics, which every engine has; runs of
Cyrillic are marked ``\mechccyr{…}``, which switches the font encoding under pdfTeX;
a character that no standard font covers is given with its code point,
``\mechcchar{U+4E2D}{中}``, so that pdfTeX prints the code and the others the character.
"""

import re
import unicodedata
from itertools import groupby

from ...formula.names import GREEK

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
    "\u00a0": "~",
    "\u200b": r"\allowbreak{}",
    "\u200c": r"\kern0pt{}",
} | {
    letter: rf"\ensuremath{{\{'o' if name == 'omicron' else name}}}"
    for name, letter in GREEK.items()
    if name != "omicron"
}

_LATIN = re.compile("[ -~¡-ſ]")
_CYRILLIC = re.compile("[Ѐ-џҐґ]")
_LIGATURE = re.compile("([-',])(?=[-',])")
"""Characters that fonts join when they follow one another, such as ``--``."""

_LONG = re.compile("([^ ]{24})(?=[^ ])")
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
    return "".join(_run(kind, "".join(run)) for kind, run in groupby(broken, _kind))


def has_cyrillic(text: str) -> bool:
    """Return whether a text needs a font with Cyrillic letters."""
    return bool(_CYRILLIC.search(text))


def _printable(character: str) -> str:
    """Turn every kind of white space into a space and drop control characters."""
    if character.isspace() and character != "\u00a0":
        return " "
    return "" if unicodedata.category(character) in {"Cc", "Cf", "Cs", "Co", "Cn"} else character


def _kind(character: str) -> str:
    if character in _SPECIAL:
        return "special"
    if _CYRILLIC.match(character):
        return "cyrillic"
    return "latin" if _LATIN.match(character) else "other"


def _run(kind: str, run: str) -> str:
    match kind:
        case "special":
            return "".join(_SPECIAL[c] for c in run)
        case "cyrillic":
            return rf"\mechccyr{{{run}}}"
        case "latin":
            return run
        case _:
            return "".join(rf"\mechcchar{{U+{ord(c):04X}}}{{{c}}}" for c in run)
