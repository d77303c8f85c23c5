"""How pictures write numbers and units in a language."""

from collections.abc import Mapping
from types import MappingProxyType

from ...drawing.letters import Letters
from ...patterns import pattern
from .locale import Locale

_NAME = pattern(r"[A-Za-z][A-Za-z0-9_]+")


def letters(locale: Locale, texts: Mapping[str, str] = MappingProxyType({})) -> Letters:
    """Return the letters of units, the decimal sign, and the names that ``texts`` translate.

    >>> from .uk import LOCALE
    >>> letters(LOCALE).units["kN"], letters(LOCALE).decimal
    ('кН', ',')
    """
    names = {known: there for known, there in texts.items() if _NAME.fullmatch(known)}
    return Letters(locale.units, locale.decimal.strip("{}"), names)
