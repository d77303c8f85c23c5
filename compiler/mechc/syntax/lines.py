"""Logical lines: one statement each, with the comments above and the remark behind it.

A statement goes on in the next line while a bracket is open or the line ends in an
operator or a comma. A line that begins with a statement's word ends it in any case,
so that one forgotten bracket does not swallow the rest of the file.
"""

from collections.abc import Iterator
from typing import NamedTuple

from .grammar import statement_words
from .lalr import Token

OPERATORS = "PLUS MINUS PLUSMINUS TIMES_SIGN OVER CIRCUMFLEX COMMA EQUAL AT_SIGN COMPARISON"
GOES_ON = frozenset(OPERATORS.split())


class Line(NamedTuple):
    """The tokens of one statement and its comments; without tokens, the file's last comments."""

    tokens: list[Token]
    comments: tuple[str, ...]
    remark: str


def words_of(comment: Token) -> str:
    """Return a comment without its sign and the space behind it.

    >>> words_of(Token("COMMENT", "# arm OB "))
    'arm OB'
    """
    return str(comment)[1:].removeprefix(" ").rstrip()


class Gathered:
    """The statement that is being gathered."""

    def __init__(self) -> None:
        self.tokens: list[Token] = []
        self.comments: list[str] = []
        self.remarks: list[str] = []
        self.open_brackets = 0

    def take(self, token: Token) -> None:
        """Take in a token of the statement or a comment."""
        if token.type == "COMMENT":
            (self.remarks if self.tokens else self.comments).append(words_of(token))
            return
        self.tokens.append(token)
        self.open_brackets += (token.type == "LEFT") - (token.type == "RIGHT")

    def complete(self) -> bool:
        """Tell whether the end of the line ends the statement."""
        return self.open_brackets <= 0 and self.tokens[-1].type not in GOES_ON

    def line(self) -> Line:
        """Return what was gathered."""
        return Line(self.tokens, tuple(self.comments), " ".join(self.remarks))


def lines(found: list[Token]) -> Iterator[Line]:
    """Group tokens into logical lines."""
    gathered, line_begins = Gathered(), True
    for token in found:
        if token.type == "NEWLINE":
            line_begins = True
            if gathered.tokens and gathered.complete():
                yield gathered.line()
                gathered = Gathered()
            continue
        if line_begins and gathered.tokens and str(token) in statement_words():
            yield gathered.line()
            gathered = Gathered()
        line_begins = False
        gathered.take(token)
    yield gathered.line()
