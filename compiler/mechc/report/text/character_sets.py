"""The signs and words of the terminal's character sets."""

from collections.abc import Mapping
from types import MappingProxyType

from ...base.frozen import frozen
from ...base.later import pattern

RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
"""Digits as they stand above the line."""

_EXPONENT = pattern(r"((?<![\d.])1|(?<=\d))e([+−-]?)0*(\d+)")
"""What stands behind the figures of a large or a small number: ``1.5e+06``."""

WRITTEN: Mapping[str, str] = MappingProxyType(
    {
        "case": "{value} when {condition}",
        "other": "else {value}",
        "of table": "{name} at {asked}",
        "of row": "{name} at exactly {asked}",
        "of list": "next {asked} in {name}",
    }
)
"""The words of choices, tables and lists as a description has them."""


@frozen
class TextSigns:
    """The signs of one character set; ``fancy`` when it has Greek letters and raised digits.

    ``functions`` are called otherwise in the language: tg, ctg; ``choices`` are the words of cases,
    tables and lists, and ``between`` stands between arguments. So are the ``subscripts`` that
    mechc gives; the user's ``own`` names keep theirs, but for what ``texts`` translates.
    """

    fancy: bool
    times: str
    joint: str
    minus: str
    degree: str
    pi: str
    relations: Mapping[str, str]
    angles: frozenset[str] = frozenset()
    couples: frozenset[str] = frozenset()
    guided: frozenset[str] = frozenset()
    functions: Mapping[str, str] = MappingProxyType({})
    choices: Mapping[str, str] = WRITTEN
    between: str = ", "
    subscripts: Mapping[str, str] = MappingProxyType({})
    own: frozenset[str] = frozenset()
    texts: Mapping[str, str] = MappingProxyType({})


UNICODE = TextSigns(True, " · ", "", "−", "°", "π", {"<=": "≤", ">=": "≥", "!=": "≠"})
ASCII = TextSigns(False, " * ", "*", "-", " deg", "pi", {})


def tens(said: str, signs: TextSigns) -> str:
    """Return numbers with powers of ten as they are written by hand.

    >>> tens("1.5e+06 N", UNICODE), tens("1.5e-06 N", ASCII), tens("-1e+12", UNICODE)
    ('1.5·10⁶ N', '1.5*10^-6 N', '-10¹²')
    """
    return _EXPONENT.sub(lambda found: _ten(found[1], found[2], found[3], signs), said)


def _ten(one: str, sign: str, exponent: str, signs: TextSigns) -> str:
    """Return a power of ten behind its figures, or alone where these are ``one``."""
    power = ("" if sign in ("", "+") else "-") + exponent
    ten = f"10{power.translate(RAISED)}" if signs.fancy else f"10^{power}"
    return ten if one else f"{'·' if signs.fancy else '*'}{ten}"
