"""How pictures write numbers and units in a language."""

from ...drawing.letters import Letters
from .locale import Locale


def letters(locale: Locale) -> Letters:
    """Return the letters of units and the decimal sign.

    >>> from .uk import LOCALE
    >>> letters(LOCALE).units["kN"], letters(LOCALE).decimal
    ('кН', ',')
    """
    return Letters(locale.units, locale.decimal.strip("{}"))
