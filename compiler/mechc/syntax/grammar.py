"""The parser made of ``grammar/mechc.lark``, and what can be read off its tables."""

from collections.abc import Callable, Iterable, Iterator
from functools import cache
from types import SimpleNamespace
from typing import Any, Literal, cast, get_args

from lark import Lark, Token
from lark.lexer import PatternStr
from lark.parsers.lalr_interactive_parser import InteractiveParser

from ..data import data
from . import tables
from .tree import rules

Start = Literal[
    "statement",
    "expression",
    "direction",
    "vector",
    "range",
    "result",
    "condition",
    "expectation",
]
"""What a text may be read as: a whole statement, or what one YAML scalar holds."""

STARTS = [*get_args(Start), "between"]


def children_apart(make: Callable[..., object]) -> Callable[[list[Any]], object]:
    """Return a callback for Lark, which hands over the children as one list."""
    return lambda children: make(*children)


@cache
def parser() -> Lark:
    """Return the parser, made once per process; it makes nodes while it reads."""
    callbacks = SimpleNamespace(**{rule: children_apart(make) for rule, make in rules().items()})
    # Lark looks callbacks up by name and asks for nothing else of a transformer.
    return tables.parser(STARTS, cast(tables.Builder, callbacks))


def lexed(text: str) -> Iterator[Token]:
    """Return the tokens as the grammar's terminals cut them; STRANGE is all that is left."""
    return parser().lex(text)


def reading(start: Start) -> InteractiveParser:
    """Return a parser in its first state, to be fed token by token."""
    return parser().parse_interactive(start=start)


def accepted(at: InteractiveParser) -> set[str]:
    """Return the names of the terminals that may come next."""
    return cast(set[str], at.accepts())  # type: ignore[no-untyped-call]


@cache
def spelling() -> dict[str, str]:
    """Return the text of each terminal that has only one: words and signs."""
    return {
        terminal.name: terminal.pattern.value
        for terminal in parser().terminals
        if isinstance(terminal.pattern, PatternStr)
    }


@cache
def keywords() -> frozenset[str]:
    """Return the reserved words: those that the grammar quotes."""
    return frozenset(word for word in spelling().values() if word.isalpha())


@cache
def statement_words() -> tuple[str, ...]:
    """Return the words that statements begin with."""
    first: Iterable[str] = accepted(reading("statement"))
    return tuple(sorted(spelling()[name] for name in first if name in spelling()))


if __name__ == "__main__":
    (data("grammar") / "tables.json").write_text(tables.written(STARTS), "utf-8")
