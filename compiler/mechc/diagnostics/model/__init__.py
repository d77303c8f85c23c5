"""The words of errors in what a description means (E2xx), a module for each subject."""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    WORDS = {
        *("circular_slots", "collars", "doubts", "friction", "held", "joints", "loads"),
        *("names", "quantities", "reactions", "results", "sheets", "sizes"),
        *("spread_loads", "translations", "wheels"),
    }
    __getattr__ = waiting(__name__, WORDS)
