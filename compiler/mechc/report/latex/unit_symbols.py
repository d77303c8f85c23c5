"""Units behind their numbers, as LaTeX, in the letters of a language."""

import re
from collections.abc import Mapping
from typing import Protocol

from ...units import SPELLINGS

MICRO = r"\textmu m"


class UnitLetters(Protocol):
    """What knows the letters of units in a language: its locale, or its notation."""

    @property
    def units(self) -> Mapping[str, str]:
        """Return the letters of the language by those of the unit."""
        ...


def unit_symbol(unit: str, words: UnitLetters) -> str:
    r"""Return a unit behind its number.

    >>> from ..languages.uk import LOCALE
    >>> unit_symbol("m/s^2", LOCALE), unit_symbol("1/m", LOCALE)
    ('\\,\\text{м}/\\text{с}^2', '\\,\\text{м}^{-1}')
    """
    if not unit:
        return ""
    if unit in ("deg", "°"):
        return r"^\circ"
    unit = re.sub(r"^1/([A-Za-z]+)(?:\^(\d+))?", lambda m: f"{m[1]}^{{-{m[2] or 1}}}", unit)
    letters = re.sub(r"[^\W\d]+|[\"°]", lambda m: rf"\text{{{_word(m[0], words)}}}", unit)
    return r"\," + letters.replace("*", r"\cdot ")


def _word(unit: str, words: UnitLetters) -> str:
    """Return a unit of one word in letters of the language, micrometres with their sign."""
    usual = SPELLINGS.get(unit, unit)
    return words.units.get(usual, MICRO if usual == "um" else usual)
