"""The parser made of ``grammar/mechc.lark``, and what can be read off its tables.

The tables are made once and shipped: making them takes longer than a compilation.
``made_tables`` names the grammar that it was made from; where that differs the tables are
made anew, so an outdated file costs time and nothing else. It is Python, as compiled Python is
read a third as long as JSON.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from importlib import import_module
from typing import Literal, cast, get_args
from zlib import crc32

from ...data_folders import data
from ..vocabulary import LANGUAGES
from .lalr import Parser, ParserState, ParserTables, Token, span_of
from .tree import rules

__all__ = [
    "ParserState",
    "Start",
    "keywords",
    "lexed",
    "parser",
    "reading",
    "spelling",
    "statement_words",
]


Start = Literal[
    "statement",
    "expression",
    "direction",
    "vector",
    "range",
    "result",
    "condition",
    "expectation",
    "reported",
    "end",
    "rim",
    "route",
    "measure",
    "let_value",
    "row",
    "unit",
]
"""What a text may be read as: a whole statement, or what one YAML scalar holds."""

STARTS = [*get_args(Start), "between"]


def grammar() -> str:
    """Return the text of the grammar."""
    return (data("grammar") / "mechc.lark").read_text("utf-8")


def checksum(text: str) -> int:
    """Return the checksum of the grammar that tables were made from."""
    return crc32("\n".join([text, *STARTS]).encode())


def tables() -> ParserTables:
    """Return the tables, the shipped ones if they are of this grammar."""
    text = grammar()
    made = import_module(f"{__package__}.made_tables")
    if checksum(text) == made.MADE_FROM:
        return cast(ParserTables, made.TABLES)
    return cast(ParserTables, import_module(f"{__package__}.make_tables").make(text, STARTS))


@cache
def parser() -> Parser:
    """Return the parser, made once per process; it makes nodes while it reads."""
    return Parser(tables(), rules())


def lexed(text: str) -> Iterator[Token]:
    """Return the tokens as the grammar's terminals cut them; STRANGE is all that is left."""
    return parser().lex(text)


def reading(start: Start) -> ParserState:
    """Return a parser in its first state, to be fed token by token."""
    return ParserState(parser(), start)


def spelling() -> dict[str, str]:
    """Return the text of each terminal that has only one: words and signs."""
    return parser().tables.texts


ANYWHERE, EACH, AHEAD = -1, -2, -3
"""The first of a word behind the name of a statement, wherever that is; or each of them; or each
that a value follows, before which no name can stand."""

VALUE = frozenset({"NAME", "NUMBER", "LEFT"})
"""What a value begins with, but for a sign."""

SOFT: Mapping[str, frozenset[tuple[str, int]]] = {
    "load": frozenset({("load", 0)}),
    "intensity": frozenset({("load", 2)}),
    "radius": frozenset(
        {("slot", 6), ("rack", AHEAD), ("gear", AHEAD), ("belt", AHEAD), ("rim", AHEAD)}
    ),
    "speed": frozenset({("drive", ANYWHERE)}),
    "rope": frozenset({("rope", 0), ("friction", 1)}),
    "wrap": frozenset({("friction rope", ANYWHERE)}),
    "drum": frozenset({("friction rope", ANYWHERE)}),
    "pin": frozenset({("friction", 1)}),
    "pins": frozenset({("friction", 1)}),
    "collar": frozenset({("friction", 1)}),
    "mean": frozenset({("friction collar", ANYWHERE)}),
    "outer": frozenset({("friction collar", ANYWHERE)}),
    "wear": frozenset({("friction collar", ANYWHERE)}),
    "pressure": frozenset({("friction collar", ANYWHERE)}),
    "thrust": frozenset({("friction collar", ANYWHERE)}),
    "faces": frozenset({("friction collar", ANYWHERE)}),
    "sheet": frozenset({("sheet", 0)}),
    "table": frozenset({("table", 0)}),
    "list": frozenset({("list", 0)}),
    "use": frozenset({("use", 0)}),
    "turned": frozenset({("use", ANYWHERE)}),
    "joining": frozenset({("use", ANYWHERE)}),
    "without": frozenset({("use", ANYWHERE)}),
    "translate": frozenset({("translate", 0)}),
    **dict.fromkeys(LANGUAGES, frozenset({("translate", ANYWHERE)})),
    "report": frozenset({("report", 0)}),
    "plot": frozenset({("report", EACH), ("reported", EACH)}),
    "over": frozenset({("report", EACH), ("reported", EACH)}),
    "next": frozenset({("let", 3), ("let_value", 0)}),
    "exactly": frozenset({("let", AHEAD), ("let_value", AHEAD)}),
}
"""Words that are names but in one kind of statement, by its first word or two, at one place in it.

A value of YAML stands by what it is read as, in place of a first word.
"""


HEADINGS = frozenset({"mechanism", "sheet"})
"""What a description begins with: any word behind it is its name, which no line refers to."""


def with_names(line: Sequence[Token], start: Start) -> list[Token]:
    """Return a line with what only looks like a word of the language made a name.

    >>> line = list(lexed("param radius = load"))
    >>> [token.type for token in with_names(line, "statement") if token.type != "WS"]
    ['PARAM', 'NAME', 'EQUAL', 'NAME']
    """
    begun = (line[0], " ".join(line[:2])) if line and start == "statement" else (start,)
    return [
        Token("NAME", token, *span_of(token)) if _names(token, place, begun, line) else token
        for place, token in enumerate(line)
    ]


def _names(token: str, place: int, begun: Sequence[str], line: Sequence[Token]) -> bool:
    """Return whether a word that the grammar knows is a name where it stands."""
    if place == 1 and begun[0] in HEADINGS:
        return token.isalpha()
    return token in SOFT and not _stands(token, place, begun, line)


def _stands(word: str, place: int, begun: Sequence[str], line: Sequence[Token]) -> bool:
    """Return whether a soft word at a place of a statement is a word of the language there."""
    if any((first, at) in SOFT[word] for first in begun for at in (place, EACH)):
        return True
    is_ahead = place + 1 < len(line) and _begins_value(line[place + 1])
    if is_ahead and any((first, AHEAD) in SOFT[word] for first in begun):
        return True
    anywhere = any((first, ANYWHERE) in SOFT[word] for first in begun)
    return anywhere and place > 1 and word not in line[2:place]


def _begins_value(token: Token) -> bool:
    return token.type in VALUE or token in SOFT


@cache
def keywords() -> frozenset[str]:
    """Return the reserved words: those that the grammar quotes and that are never names."""
    return frozenset(word for word in spelling().values() if word.isalpha()) - SOFT.keys()


@cache
def statement_words() -> tuple[str, ...]:
    """Return the words that statements begin with."""
    first = reading("statement").accepted()
    return tuple(sorted(spelling()[name] for name in first if name in spelling()))
