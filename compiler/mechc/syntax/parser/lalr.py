"""Reading by tables: a text to tokens with their spans, and tokens to nodes, one after another.

Lark makes the tables out of the grammar (see ``make_tables``); to read by them takes so
little that a compilation does not import Lark, which would double its time to start.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any

from ...base.named import NamedTuple
from ...source import Span

END = "$END"
"""The type of the token behind the last one."""


class Token(str):
    """A piece of text, its terminal's name and its place."""

    __slots__ = ("end_pos", "start_pos", "type")

    type: str
    start_pos: int
    end_pos: int

    def __new__(cls, type: str, text: str, start_pos: int = 0, end_pos: int = 0) -> "Token":
        """Return the token."""
        token = super().__new__(cls, text)
        token.type, token.start_pos, token.end_pos = type, start_pos, end_pos
        return token


class Refused(Exception):
    """A token that cannot stand where it does."""


class Reduction(NamedTuple):
    """A reduction: the values that it takes off the stack, and the one that it makes of them.

    ``children`` are the places of the parts that the node gets; ``~place`` is a list put
    in part by part, None a part that was left out. A rule that ``collapses`` hands on an
    only part as it is.
    """

    origin: str
    size: int
    name: str
    children: list[int | None]
    collapses: bool


class ParserTables(NamedTuple):
    """A grammar made ready for reading.

    ``terminals`` are tried in order; ``words`` decides of what a terminal matched whether it
    is a terminal of its own. A state maps what comes next to a state, or to ``~rule``.
    """

    terminals: list[tuple[str, str]]
    words: dict[str, dict[str, str]]
    texts: dict[str, str]
    ignored: list[str]
    rules: list[Reduction]
    states: list[dict[str, int]]
    starts: dict[str, tuple[int, int]]


class Parser:
    """A lexer and a parser of one grammar; ``builders`` make the nodes, by the rules' names."""

    def __init__(self, tables: ParserTables, builders: Mapping[str, Callable[..., object]]) -> None:
        self.tables = tables
        self.builders = builders

    def lex(self, text: str) -> Iterator[Token]:
        """Yield the tokens; the grammar's terminals must cover every text."""
        words, ignored = self.tables.words, self.tables.ignored
        for found in self._scanner.finditer(text):
            name = found.lastgroup or ""
            if name not in ignored:
                piece = found[0]
                name = words.get(name, {}).get(piece, name)
                yield Token(name, piece, *found.span())

    @cached_property
    def _scanner(self) -> re.Pattern[str]:
        return re.compile("|".join(f"(?P<{name}>{how})" for name, how in self.tables.terminals))


class ParserState:
    """A parser at one place in a line, fed token by token."""

    def __init__(self, parser: Parser, start: str) -> None:
        self._rules, self._table = parser.tables.rules, parser.tables.states
        self._builders = parser.builders
        first, self._last = parser.tables.starts[start]
        self._states = [first]
        self._values: list[Any] = []

    def feed(self, token: Token) -> object:
        """Take in a token; behind the END return what was read. Raises :class:`Refused`."""
        while (action := self._table[self._states[-1]].get(token.type)) is not None:
            if action >= 0:
                self._states.append(action)
                self._values.append(token)
                return None
            rule = self._rules[~action]
            self._goto(self._states, rule)
            rest = len(self._values) - rule.size
            self._values[rest:] = [self._built(rule, self._values[rest:])]
            if token.type == END and self._states[-1] == self._last:
                return self._values[-1]
        raise Refused(token)

    def accepted(self) -> set[str]:
        """Return the names of the terminals that may come next."""
        return {name for name in self._table[self._states[-1]] if self._takes(name)}

    def _takes(self, name: str) -> bool:
        states = list(self._states)
        while (action := self._table[states[-1]].get(name)) is not None:
            if action >= 0:
                return name.isupper()
            self._goto(states, self._rules[~action])
            if name == END and states[-1] == self._last:
                return True
        return False

    def _goto(self, states: list[int], rule: Reduction) -> None:
        del states[len(states) - rule.size :]
        states.append(self._table[states[-1]][rule.origin])

    def _built(self, rule: Reduction, parts: list[Any]) -> object:
        """Return a rule's node, or its parts as a list where another rule takes them in."""
        children: list[Any] = []
        for place in rule.children:
            if place is None:
                children.append(None)
            elif place < 0 and not children:
                children = parts[~place]  # that list is no one else's, and may be long
            elif place < 0:
                children += parts[~place]
            else:
                children.append(parts[place])
        if rule.collapses and len(children) == 1:
            return children[0]
        return children if rule.name.startswith("_") else self._builders[rule.name](*children)


NOWHERE = Span(0, 0)
"""What a statement carries until the reader of its line gives it its span."""


def span_of(token: Token) -> Span:
    """Return the place of a token in the user's text."""
    return Span(token.start_pos, token.end_pos)
