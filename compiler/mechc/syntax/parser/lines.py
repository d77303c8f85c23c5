"""Logical lines: one statement each, with the comments above and the remark behind it.

A statement goes on in the next line while a bracket is open or the line ends in an
operator or a comma. A line that begins with a statement's word ends it in any case,
so that one forgotten bracket does not swallow the rest of the file, and so does a vector
(``AB = …``) or a place (``A at …``), so that an operator without its right side, or a bracket
that is not closed, is found where it stands.
"""

from collections.abc import Iterator

from ...base.named import NamedTuple
from .grammar import statement_words
from .lalr import Token

OPERATORS = "PLUS MINUS PLUSMINUS TIMES_SIGN OVER CIRCUMFLEX COMMA EQUAL AT_SIGN COMPARISON"
GOES_ON = frozenset(OPERATORS.split())

OPERAND_ENDS = frozenset({"NAME", "NUMBER", "RIGHT"})
"""An operand ends with one of these, and another one cannot stand behind it."""


class SourceLine(NamedTuple):
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
        """Return whether the end of the line ends the statement."""
        return self.open_brackets <= 0 and self.tokens[-1].type not in GOES_ON

    def line(self) -> SourceLine:
        """Return the gathered line."""
        return SourceLine(self.tokens, tuple(self.comments), " ".join(self.remarks))


def begins(before: Token, token: Token, following: Token | None) -> bool:
    """Return whether a line that begins so is a statement whatever stands above it.

    Behind a comma a list goes on, in which names have values, too.
    """
    behind = str(following) if token.type == "NAME" and following is not None else ""
    assigned = behind == "=" and before.type != "COMMA"
    placed = behind == "at" and before.type in OPERAND_ENDS
    return assigned or placed or str(token) in statement_words()


def lines(found: list[Token]) -> Iterator[SourceLine]:
    """Group tokens into logical lines."""
    gathered, line_begins = Gathered(), True
    for token, following in zip(found, [*found[1:], None], strict=False):
        if token.type == "NEWLINE":
            line_begins = True
            if gathered.tokens and gathered.complete():
                yield gathered.line()
                gathered = Gathered()
            continue
        if line_begins and gathered.tokens and begins(gathered.tokens[-1], token, following):
            yield gathered.line()
            gathered = Gathered()
        line_begins = False
        gathered.take(token)
    yield gathered.line()
