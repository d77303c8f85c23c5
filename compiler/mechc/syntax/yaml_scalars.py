"""A single YAML value: what it is, and its text read as the line notation is."""

from typing import Any

from ..diagnostics import Diagnostic, syntax, syntax_yaml
from ..source import Source, Span
from . import parse as parser
from .fault import Fault
from .grammar import Start
from .spans import span_of
from .tokens import tokens
from .yaml_nodes import Listing, Node, Scalar
from .yaml_nodes import Mapping as Table
from .yaml_places import places


def described(node: Node) -> str:
    """Say what was found."""
    match node:
        case Table():
            return "a mapping"
        case Listing():
            return "a list"
        case Scalar(empty=True):
            return "nothing"
        case Scalar(text=text):
            return f"'{text if len(text) < 40 else text[:40] + '…'}'"


def scalar_of(node: Node, expected: str) -> Scalar:
    """Return a plain value; refuse lists, mappings and nothing."""
    if isinstance(node, Scalar) and not node.empty:
        return node
    hint = "a value stands without brackets" if isinstance(node, Listing) else ""
    raise Fault(syntax_yaml.wrong_shape(node.span, described(node), expected, hint))


def parsed(start: Start, expected: str, node: Node, source: Source) -> Any:
    """Read a scalar with the project's own grammar, as the line notation would."""
    scalar = scalar_of(node, expected)
    at = places(scalar, source)
    end = (at[-1] + 1) if at else scalar.span.start
    found = tokens(scalar.text, lambda i: at[i] if i < len(at) else end)
    line = [token for token in found if token.type != "NEWLINE"]
    for token in line:
        if token.type == "COMMENT":
            span = span_of(token)
            raise Fault(syntax.unexpected_character(Span(span.start, span.start + 1), "#", ""))
    return parser.parse(line, start, end)


def one_of(words: tuple[str, ...], node: Node) -> str:
    """Read one of a few words."""
    scalar = scalar_of(node, syntax.listed(f"'{word}'" for word in words))
    if scalar.text not in words:
        raise Fault(wrong_word(scalar, words))
    return scalar.text


def wrong_word(scalar: Scalar, words: tuple[str, ...]) -> Diagnostic:
    """Return the error about a word that is none of those that may stand here."""
    expected = [f"'{word}'" for word in words]
    return syntax.unexpected_text(scalar.span, f"'{scalar.text}'", expected)
