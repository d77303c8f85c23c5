"""Logical lines: one statement each, with the comments above and the remark behind it.

A statement goes on in the next line while a bracket is open or the line ends in an
operator or a comma. A line that begins with a statement's word ends it in any case,
so that one forgotten bracket does not swallow the rest of the file.
"""

from collections.abc import Iterator
from typing import NamedTuple

from lark import Token

from .grammar import statement_words
from .spans import span_of

GOES_ON = frozenset(
    {"PLUS", "MINUS", "TIMES_SIGN", "OVER", "CIRCUMFLEX", "COMMA", "EQUAL", "AT_SIGN", "COMPARISON"}
)


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


def lines(found: list[Token]) -> Iterator[Line]:
    """Group tokens into logical lines."""
    statement: list[Token] = []
    comments: list[str] = []
    remarks: list[str] = []
    for index, token in enumerate(found):
        match token.type:
            case "COMMENT":
                (remarks if statement else comments).append(words_of(token))
            case "NEWLINE":
                if statement and not continues(statement, found, index + 1):
                    yield Line(statement, tuple(comments), " ".join(remarks))
                    statement, comments, remarks = [], [], []
            case _:
                statement.append(token)
    yield Line(statement, tuple(comments), " ".join(remarks))


def continues(statement: list[Token], found: list[Token], after: int) -> bool:
    """Tell whether the statement goes on behind this line's end."""
    brackets = sum((t.type == "LEFT") - (t.type == "RIGHT") for t in statement)
    if brackets <= 0 and statement[-1].type not in GOES_ON:
        return False
    following = next((t for t in found[after:] if t.type not in ("NEWLINE", "COMMENT")), None)
    return following is not None and str(following) not in statement_words()


def end_of(statement: list[Token]) -> int:
    """Return where a statement ends."""
    return span_of(statement[-1]).end
