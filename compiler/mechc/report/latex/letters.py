r"""Characters that not every TeX engine has, spelled with what all engines have.

Letters with accents are built of letter and accent, Greek ones are set in mathematics, a
schwa is borrowed from the Cyrillic font. What cannot be spelled is printed by its code
point, so that nothing of the user's is lost.
"""

import unicodedata
from collections.abc import Iterable

from ...formula.names import GREEK

ACCENTS = {
    "\u0300": r"\`",
    "\u0301": r"\'",
    "\u0302": r"\^",
    "\u0303": r"\~",
    "\u0304": r"\=",
    "\u0306": r"\u",
    "\u0307": r"\.",
    "\u0308": r"\"",
    "\u030a": r"\r",
    "\u030b": r"\H",
    "\u030c": r"\v",
    "\u031b": r"{}\kern-0.1em\raisebox{{0.2ex}}{{\textquoteright}}",
    "\u0323": r"\d",
    "\u0326": r"\textcommabelow",
    "\u0327": r"\c",
    "\u0328": r"\k",
    "\u0331": r"\b",
}
"""Combining marks as commands of text."""

_IN_MATHEMATICS = {"\u0300": "grave", "\u0301": "acute", "\u0308": "ddot", "\u0304": "bar"}

_HORN = "\u031b"
"""The mark of Vietnamese that stands next to its letter."""


def _between(ranges: str) -> frozenset[str]:
    """Return the characters of ranges such as ``a-z``."""
    ends = (part.split("-") for part in ranges.split())
    return frozenset(chr(code) for a, z in ends for code in range(ord(a), ord(z) + 1))


# Sets, since a regular expression of such ranges takes longer to compile than a report to spell.
CYRILLIC = _between("Ѐ-џ Ґ-ғ Җ-ҝ Ҡ-ҥ Ҫ-ҫ Ү-ҳ Ҷ-һ Ӏ-ӂ Ӑ-ӟ Ӣ-Ө ө-ө Ӭ-ӵ Ӹ-ӹ")
"""Cyrillic letters of the font encoding T2A."""

LATIN = _between("!-~ ¡-ſ Ș-ț") - set("ÐÞðþĐđĦħĸĿŀŉŊŋŦŧſ") | {" "}
"""Latin letters of the font encodings T1 and T2A, either by themselves or as accents."""

_BARRED = dict(zip("ĦħŦŧƀɃɨƗƵƶǤǥɈɉ", "HhTtbBiIZzGgJj", strict=True))
"""Letters with a stroke, by the letter that is struck through."""

_WESTERN_ONLY = frozenset("ÐÞðþĐđŊŋẞ‚‹›")
"""What the font encoding T1 has, and T2A has not."""

_SPELLED = {
    "ĸ": r"\textsc{k}",
    "Ŀ": r"L\ensuremath{\cdot}",
    "ŀ": r"l\ensuremath{\cdot}",
    "ŉ": r"\textquoteright{}n",
    "ſ": "s",
    "ƒ": r"\textflorin{}",
    "Ə": r"\mechccyr{Ә}",
    "ə": r"\mechccyr{ә}",
    "Ɵ": r"\mechccyr{Ө}",
    "ɵ": r"\mechccyr{ө}",
    "ς": r"\ensuremath{\varsigma}",
    "ο": r"\ensuremath{o}",
}

_GREEK = {letter: rf"\{name}" for name, letter in GREEK.items()}
_GREEK |= dict(zip("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧ", map(r"\mathrm{{{}}}".format, "ABEZHIKMNOPTYX"), strict=True))
_GREEK["ο"] = "o"

_PLAIN = {0x2044: "/", 0x2212: "-"}
_LEVELS = {"<super>": "^", "<sub>": "_"}
_ALIKE = {"<compat>", "<font>", "<wide>", "<narrow>", "<fraction>", "<noBreak>"}


def spelled(cluster: str) -> str:
    r"""Return a letter with its marks in commands that every engine knows.

    >>> spelled("ŧ"), spelled("ẑ"), spelled("ή"), spelled("中")
    ('\\mechcbarred{t}', '\\^{z}', '\\ensuremath{\\acute{\\eta}}', '[U+4E2D]')
    """
    if cluster[0] in CYRILLIC and all(mark in ACCENTS for mark in cluster[1:]):
        return rf"\mechccyr{{{_with_marks(cluster[0], cluster[1:])}}}"
    base, *marks = list(unicodedata.normalize("NFD", cluster))
    if base in _GREEK and all(m in _IN_MATHEMATICS for m in marks):
        return rf"\ensuremath{{{_accented(_GREEK[base], marks)}}}"
    if (letter := _letter(base)) and all(mark in ACCENTS for mark in marks):
        return _with_marks(letter, marks)
    return "".join(f"[U+{ord(c):04X}]" for c in cluster)


def _accented(letter: str, marks: Iterable[str]) -> str:
    for mark in marks:
        letter = rf"\{_IN_MATHEMATICS[mark]}{{{letter}}}"
    return letter


def _with_marks(letter: str, marks: Iterable[str]) -> str:
    """Return a letter with its marks, that next to it last."""
    for mark in sorted(marks, key=_HORN.__eq__):
        letter = ACCENTS[mark].format(letter) if mark == _HORN else f"{ACCENTS[mark]}{{{letter}}}"
    return letter


def _letter(base: str) -> str:
    """Return a letter without marks; '' where nothing spells it."""
    if base.isascii() and base.isalpha():
        return base
    if base in _BARRED:
        return rf"\mechcbarred{{{_BARRED[base]}}}"
    if base in _WESTERN_ONLY:
        return rf"{{\fontencoding{{T1}}\selectfont {base}}}"
    return _SPELLED.get(base) or _by_other_letters(base)


def _by_other_letters(base: str) -> str:
    """Return a raised, lowered or joined character by the plain ones it stands for."""
    kind, *codes = unicodedata.decomposition(base).split() or [""]
    plain = "".join(chr(int(code, 16)) for code in codes).translate(_PLAIN)
    if not plain.isascii() or not all(c.isalnum() or c in "/()+-=." for c in plain):
        return ""
    if kind in _LEVELS:
        return rf"\ensuremath{{{{}}{_LEVELS[kind]}{{{plain}}}}}"
    return plain if kind in _ALIKE else ""
