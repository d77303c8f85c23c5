"""Places of tokens and of nodes that are made of several."""

from lark import Token

from ..source import Span

NOWHERE = Span(0, 0)
"""What a statement carries until the reader of its line tells it its place."""


def span_of(token: Token) -> Span:
    """Return the place of a token in the user's text."""
    assert token.start_pos is not None
    assert token.end_pos is not None
    return Span(token.start_pos, token.end_pos)
