"""Places of tokens and of nodes that are made of several."""

from ..source import Span
from .lalr import Token

NOWHERE = Span(0, 0)
"""What a statement carries until the reader of its line gives it its span."""


def span_of(token: Token) -> Span:
    """Return the place of a token in the user's text."""
    return Span(token.start_pos, token.end_pos)
