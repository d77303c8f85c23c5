"""The parser made of ``grammar/mechc.lark``, and what can be read off its tables."""

from collections.abc import Iterator
from functools import cache

from .lalr import Parser, Reading, Token
from .tables import Start, tables
from .tree import rules

__all__ = [
    "Reading",
    "Start",
    "keywords",
    "lexed",
    "parser",
    "reading",
    "spelling",
    "statement_words",
]


@cache
def parser() -> Parser:
    """Return the parser, made once per process; it makes nodes while it reads."""
    return Parser(tables(), rules())


def lexed(text: str) -> Iterator[Token]:
    """Return the tokens as the grammar's terminals cut them; STRANGE is all that is left."""
    return parser().lex(text)


def reading(start: Start) -> Reading:
    """Return a parser in its first state, to be fed token by token."""
    return Reading(parser(), start)


def spelling() -> dict[str, str]:
    """Return the text of each terminal that has only one: words and signs."""
    return parser().tables.texts


@cache
def keywords() -> frozenset[str]:
    """Return the reserved words: those that the grammar quotes."""
    return frozenset(word for word in spelling().values() if word.isalpha())


@cache
def statement_words() -> tuple[str, ...]:
    """Return the words that statements begin with."""
    first = reading("statement").accepted()
    return tuple(sorted(spelling()[name] for name in first if name in spelling()))
