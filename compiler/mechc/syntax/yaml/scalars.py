"""A single YAML value: what it is, its text read as the line notation is, and where that stands."""

from typing import Any

from ...diagnostics import Diagnostic, near_miss, syntax, syntax_yaml
from ...source import Source, Span
from ..fault import Fault
from ..parser import parse as parser
from ..parser.grammar import Start
from ..parser.lalr import span_of
from ..parser.tokens import tokens
from .nodes import Listing, Scalar, YamlNode
from .nodes import Mapping as Table

ESCAPES = {"x": 4, "u": 6, "U": 10}
"""Length of the numeric escapes of double-quoted scalars."""


def described(node: YamlNode) -> str:
    """Return a node in words, as what was found."""
    match node:
        case Table():
            return "a mapping"
        case Listing():
            return "a list"
        case Scalar(empty=True):
            return "nothing"
        case Scalar(text=text):
            return f"'{text if len(text) < 40 else text[:40] + '…'}'"


def scalar_of(node: YamlNode, expected: str) -> Scalar:
    """Return a plain value; refuse lists, mappings and nothing."""
    if isinstance(node, Scalar) and not node.empty:
        return node
    hint = "a value stands without brackets" if isinstance(node, Listing) else ""
    raise Fault(syntax_yaml.wrong_shape(node.span, described(node), expected, hint))


HASH = "a remark begins with a space and #"


def parsed(start: Start, expected: str, node: YamlNode, source: Source) -> Any:
    """Read a scalar with the project's own grammar, as the line notation would."""
    scalar = scalar_of(node, expected)
    at = places(scalar, source)
    end = (at[-1] + 1) if at else scalar.span.start
    found = tokens(scalar.text, lambda i: at[i] if i < len(at) else end)
    line = [token for token in found if token.type != "NEWLINE"]
    for token in line:
        if token.type == "COMMENT":
            span = span_of(token)
            raise Fault(syntax.unexpected_character(Span(span.start, span.start + 1), "#", HASH))
    return parser.parse(line, start, end)


def one_of(words: tuple[str, ...], node: YamlNode) -> str:
    """Read one of a few words."""
    scalar = scalar_of(node, syntax.listed(f"'{word}'" for word in words))
    if scalar.text not in words:
        raise Fault(wrong_word(scalar, words))
    return scalar.text


def wrong_word(scalar: Scalar, words: tuple[str, ...]) -> Diagnostic:
    """Return the error about a word that is none of those that may stand here."""
    expected = [f"'{word}'" for word in words]
    hint = near_miss(scalar.text, words)
    return syntax.unexpected_text(scalar.span, f"'{scalar.text}'", expected, hint)


# ------------------------------------------------------------------------ places in the text


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
    style, at = raw[:1], _opening(raw)
    found: list[int] = []
    for character in scalar.text:
        at = _skipped_fold(raw, at, character)
        found.append(start + min(at, len(raw) - 1))
        at += _width(raw, at, style)
    return found


def _opening(raw: str) -> int:
    """Return where the value begins: behind a quote, or behind the line of ``|`` or ``>``."""
    match raw[:1]:
        case "'" | '"':
            return 1
        case "|" | ">":
            return raw.find("\n") + 1
        case _:
            return 0


def _skipped_fold(raw: str, at: int, character: str) -> int:
    """Skip what folding took away: line ends and indentation before a visible character."""
    if character.isspace():
        return at
    while raw[at : at + 1].isspace():
        at += 1
    return at


def _width(raw: str, at: int, style: str) -> int:
    """Return how many characters of the text one character of the value took."""
    if style == "'" and raw[at : at + 2] == "''":
        return 2
    if style == '"' and raw[at : at + 1] == "\\":
        return ESCAPES.get(raw[at + 1 : at + 2], 2)
    return 1
