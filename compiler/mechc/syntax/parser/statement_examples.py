"""How each statement is written: an example by its word, for hints."""

from collections.abc import Sequence
from typing import Final

from ..examples import WRITTEN
from .grammar import spelling
from .lalr import Token

OPENING: Final = frozenset({"=", "..", "@"})
"""Signs that belong to a statement, not to an expression in it."""


def example(line: Sequence[Token], allowed: set[str]) -> str:
    """Return how the statement is written, '' within an expression, where no word is missing.

    >>> from .grammar import lexed
    >>> example(list(lexed("slider K 90")), {"ALONG"})
    'it is written: slider K along 90 deg'
    """
    may_follow = {spelling().get(name, "") for name in allowed}
    if not (allowed <= {"NAME"} or any(w.isalpha() or w in OPENING for w in may_follow)):
        return ""
    return whole_example(line)


def whole_example(line: Sequence[Token]) -> str:
    """Return how a statement is written, '' where no example is known."""
    meant = _example(line)
    return f"it is written: {meant}" if meant else ""


def words_behind(line: Sequence[Token]) -> list[str]:
    """Return the words and signs of the statement's example, but for the one it begins with."""
    return _example(line).split()[1:]


def _example(line: Sequence[Token]) -> str:
    """Return the example that shares most words with a line from its beginning."""
    words = [str(token) for token in line]
    for name in sorted(WRITTEN, key=lambda name: -name.count(" ")):
        first, *others = name.split()
        if words[:1] == [first] and set(others) <= set(words):
            return WRITTEN[name]
    return ""
