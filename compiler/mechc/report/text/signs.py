"""The signs and words of the terminal's character sets."""

from collections.abc import Mapping
from types import MappingProxyType

from ...frozen import frozen

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
class Signs:
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


UNICODE = Signs(True, " · ", "", "−", "°", "π", {"<=": "≤", ">=": "≥", "!=": "≠"})
ASCII = Signs(False, " * ", "*", "-", " deg", "pi", {})
