"""YAML text to nodes with places, refusing what a description never needs.

PyYAML's events are read, not its objects: they keep positions, duplicate keys and the
text of every scalar. Depth and number are counted while reading, before any recursion.
"""

from collections.abc import Iterator

import yaml

from ...base.frozen import frozen
from ...base.named import NamedTuple
from ...diagnostics import Diagnostic, MechcError, Report, syntax_limits, syntax_yaml
from ...source import Span
from .. import limits
from ..fault import check_characters, note
from . import slips


@frozen
class Scalar:
    """A single value as text; ``quoted`` where it may not stand for 'nothing'."""

    text: str
    span: Span
    quoted: bool = False

    @property
    def empty(self) -> bool:
        """Return whether nothing was written."""
        return not self.quoted and self.text in ("", "~", "null")


@frozen
class Listing:
    """A list."""

    items: tuple["YamlNode", ...]
    span: Span


@frozen
class Mapping:
    """A mapping; its keys are scalars, in the order of the text, doubles included."""

    entries: tuple[tuple[Scalar, "YamlNode"], ...]
    span: Span


YamlNode = Scalar | Listing | Mapping


class OpenNode(NamedTuple):
    """A list or mapping whose end has not been read yet."""

    event: yaml.SequenceStartEvent | yaml.MappingStartEvent
    children: list[YamlNode]


OPENED = (" flow ", "quoted scalar")
"""What was opened and is not closed, in the words of the reader of YAML."""


def compose(report: Report) -> YamlNode | None:
    """Return the document's root, or None if it is empty.

    Raises :class:`MechcError`: after an error in YAML's own syntax nothing can be trusted.
    """
    roots: list[YamlNode] = []
    stack: list[OpenNode] = []
    for count, event in enumerate(events(report)):
        if count > limits.YAML_NODES:
            raise too_large(event, "values", limits.YAML_NODES, report)
        refuse_foreign(event, report)
        match event:
            case yaml.SequenceStartEvent() | yaml.MappingStartEvent():
                stack.append(OpenNode(event, []))
                if len(stack) > limits.YAML_DEPTH:
                    raise too_large(event, "levels", limits.YAML_DEPTH, report)
            case yaml.DocumentStartEvent() if roots:
                raise report.fail(syntax_yaml.one_document(span_of(event)))
            case yaml.ScalarEvent(value=text):
                check_characters(text, span_of(event), report)
                (stack[-1].children if stack else roots).append(scalar(event))
            case yaml.SequenceEndEvent() | yaml.MappingEndEvent():
                node = closed(stack.pop(), event, report)
                (stack[-1].children if stack else roots).append(node)
    return roots[0] if roots else None


def events(report: Report) -> Iterator[yaml.Event]:
    """Return PyYAML's events; its errors become ours."""
    try:
        yield from yaml.parse(report.source.text, Loader=yaml.SafeLoader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        at = mark.index if mark else 0
        problem = (error.problem or "").replace("'<stream end>'", "the end of the text")
        in_brackets = error.context is not None and any(w in error.context for w in OPENED)
        opened = error.context_mark.index if in_brackets and error.context_mark else None
        raise report.fail(not_yaml(at, problem, report.source.text, opened)) from None
    except yaml.reader.ReaderError as error:
        character = report.source.text[error.position : error.position + 1]
        problem = f"the character {character!r} is not allowed"
        raise report.fail(not_yaml(error.position, problem, report.source.text)) from None
    except (ValueError, OverflowError):
        # PyYAML passes on what chr() and int() say of absurd escapes and versions.
        raise report.fail(not_yaml(0, "an escape or a directive is out of range", "")) from None


def not_yaml(at: int, problem: str, text: str, opened: int | None = None) -> Diagnostic:
    """Return the error about text that is no YAML, with a hint for the known habits."""
    slip = slips.of_text(text, at, problem, opened)
    span = Span(slip.at, min(slip.at + 1, len(text)) if text else slip.at)
    return syntax_yaml.not_yaml(span, problem, slip.hint)


def refuse_foreign(event: yaml.Event, report: Report) -> None:
    """Refuse aliases, anchors and tags."""
    if isinstance(event, yaml.AliasEvent):
        raise report.fail(syntax_yaml.alias_refused(span_of(event), f"the alias '*{event.anchor}'"))
    if getattr(event, "anchor", None):
        name = getattr(event, "anchor", "")
        raise report.fail(syntax_yaml.alias_refused(span_of(event), f"the anchor '&{name}'"))
    tag = getattr(event, "tag", None)
    if tag and not isinstance(event, yaml.DocumentStartEvent):
        short = tag.replace("tag:yaml.org,2002:", "!!")
        raise report.fail(syntax_yaml.tag_refused(span_of(event), short))


def too_large(event: yaml.Event, what: str, limit: int, report: Report) -> MechcError:
    """Return the error that stops the reading of a text too deep or too long."""
    return report.fail(syntax_limits.yaml_too_large(span_of(event), what, limit))


def span_of(event: yaml.Event) -> Span:
    """Return the place of an event."""
    assert event.start_mark is not None
    assert event.end_mark is not None
    return Span(event.start_mark.index, event.end_mark.index)


def scalar(event: yaml.Event) -> Scalar:
    """Return the node of a scalar."""
    assert isinstance(event, yaml.ScalarEvent)
    return Scalar(event.value, span_of(event), quoted=bool(event.style))


def closed(opened: OpenNode, event: yaml.Event, report: Report) -> YamlNode:
    """Return a list or mapping whose end was read.

    In block style YAML's end mark lies before the next entry; the last child's end is
    what people see as the end.
    """
    start = span_of(opened.event)
    last = opened.children[-1].span.end if opened.children else start.end
    span = Span(start.start, span_of(event).end if opened.event.flow_style else last)
    if isinstance(opened.event, yaml.SequenceStartEvent):
        return Listing(tuple(opened.children), span)
    keys, values = opened.children[::2], opened.children[1::2]
    return Mapping(tuple(pairs(keys, values, report)), span)


def glued(name: Scalar, value: YamlNode) -> bool:
    """Return whether a key has swallowed its value: YAML wants a space behind the colon."""
    return ":" in name.text and not name.quoted and isinstance(value, Scalar) and value.empty


def pairs(
    keys: list[YamlNode], values: list[YamlNode], report: Report
) -> Iterator[tuple[Scalar, YamlNode]]:
    """Return keys with values; a key that stands twice keeps its first value."""
    first: dict[str, Scalar] = {}
    for name, value in zip(keys, values, strict=True):
        if not isinstance(name, Scalar):
            found = "a list or mapping as a key"
            note(syntax_yaml.wrong_shape(name.span, found, "a name as a key"), report)
        elif glued(name, value):
            note(syntax_yaml.colon_without_space(name.span, name.text), report)
        elif name.text in first:
            span = first[name.text].span
            note(syntax_yaml.duplicate_key(name.span, name.text, span), report)
        else:
            first[name.text] = name
            yield name, value
