"""The languages of reports by their codes, loaded when they are used.

A language is one folder here, whose ``LOCALE`` it is, and one line below.
"""

from importlib import import_module
from typing import cast

from .locale import Locale

LANGUAGES = {"en": "English", "uk": "Ukrainian", "ru": "Russian"}
"""What languages are called; the code is the name of the folder."""


def locale(language: str) -> Locale:
    r"""Return all words of a language, and how its books write formulas.

    LookupError where there is no such language.

    >>> print(locale("uk").functions["tan"])
    \operatorname{tg}
    """
    if language not in LANGUAGES:
        raise LookupError(f"no language is called {language!r}; there are {', '.join(LANGUAGES)}")
    return cast(Locale, import_module(f".{language}", __package__).LOCALE)
