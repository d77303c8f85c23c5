"""From a place in a scalar's value to the place in the YAML text, quotes and folds included."""

from ..source import Source
from .yaml_nodes import Scalar

ESCAPES = {"x": 4, "u": 6, "U": 10}
"""Length of the numeric escapes of double-quoted scalars."""


def places(scalar: Scalar, source: Source) -> list[int]:
    """Return, for each character of the value, its offset in the text.

    >>> from mechc.source import Span
    >>> places(Scalar("it's", Span(2, 9), True), Source("a.yaml", "a:'it''s' "))
    [3, 4, 5, 7]
    """
    start, end = scalar.span
    raw = source.text[start:end]
    if raw == scalar.text:
        return list(range(start, end))
    style, at = raw[:1], opening(raw)
    found: list[int] = []
    for character in scalar.text:
        at = skipped_fold(raw, at, character)
        found.append(start + min(at, len(raw) - 1))
        at += width(raw, at, style)
    return found


def opening(raw: str) -> int:
    """Return where the value begins: behind a quote, or behind the line of ``|`` or ``>``."""
    match raw[:1]:
        case "'" | '"':
            return 1
        case "|" | ">":
            return raw.find("\n") + 1
        case _:
            return 0


def skipped_fold(raw: str, at: int, character: str) -> int:
    """Skip what folding took away: line ends and indentation before a visible character."""
    if character.isspace():
        return at
    while raw[at : at + 1].isspace():
        at += 1
    return at


def width(raw: str, at: int, style: str) -> int:
    """Return how many characters of the text one character of the value took."""
    if style == "'" and raw[at : at + 2] == "''":
        return 2
    if style == '"' and raw[at : at + 1] == "\\":
        return ESCAPES.get(raw[at + 1 : at + 2], 2)
    return 1
