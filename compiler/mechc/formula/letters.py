"""Numbers, units and names in the letters of a language."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Protocol

from ..base.later import pattern
from ..base.named import NamedTuple

_BEHIND_A_NUMBER = pattern(r"(?<=\d[ \u2009])[A-Za-zµ]+(?:[²³]?[*·/^][A-Za-z0-9]+)*")
_WORD = pattern(r"[^\W\d_]+")
_POINT = pattern(r"(?<=\d)\.(?=\d)")
_NAME = pattern(r"[A-Za-z][A-Za-z0-9_]+")


class Letters(NamedTuple):
    """What units and names are in a language, by what they are in the description; its comma."""

    units: Mapping[str, str]
    decimal: str
    names: Mapping[str, str] = MappingProxyType({})


LATIN = Letters({}, ".")


class Writing(Protocol):
    """How a language writes units, and decimals in mathematics: its locale."""

    @property
    def units(self) -> Mapping[str, str]:
        """Return the letters of the language by those of the unit."""
        ...

    @property
    def decimal(self) -> str:
        """Return the decimal sign, in braces where mathematics would set room behind it."""
        ...


def letters(words: Writing, texts: Mapping[str, str] = MappingProxyType({})) -> Letters:
    """Return the letters of units, the decimal sign, and the names that ``texts`` translate.

    >>> from ..report.languages.uk import LOCALE
    >>> letters(LOCALE).units["kN"], letters(LOCALE).decimal
    ('кН', ',')
    """
    names = {known: there for known, there in texts.items() if _NAME.fullmatch(known)}
    return Letters(words.units, words.decimal.strip("{}"), names)


def of_unit(unit: str, letters: Letters) -> str:
    """Return a unit in the letters of a language."""
    return _WORD.sub(lambda word: letters.units.get(word[0], word[0]), unit)


def lettered(text: str, letters: Letters) -> str:
    """Return text with its decimals, and the units behind numbers, in the letters of a language."""
    units = _BEHIND_A_NUMBER.sub(lambda found: of_unit(found[0], letters), text)
    return _POINT.sub(letters.decimal, units)
