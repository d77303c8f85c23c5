"""Comments of a YAML text: found between its scalars and given to the statements.

A comment behind a statement is its remark; one on a line of its own, or behind the name
of a section, stands above the next statement; what is left stands at the end.
"""

from collections.abc import Iterator, Sequence

from ...base.frozen import replace
from ...base.later import pattern
from ...base.named import NamedTuple
from ...source import Source, Span
from .. import ast
from ..vocabulary import LANGUAGES
from .nodes import Listing, Mapping, Scalar, YamlNode

CUT = pattern(r"[ \t]+(#\w[^\n]*)")

COMMENT = pattern(r"(?:(?<=\s)|(?<![\s\S]))#([^\n]*)")


class Comment(NamedTuple):
    """A comment, where it begins, and whether it has its line for itself."""

    at: int
    text: str
    alone: bool


def comments(root: YamlNode | None, source: Source) -> Iterator[Comment]:
    """Yield the comments of a text, in order."""
    text = source.text
    taken = sorted(scalar_spans(root)) if root else []
    spans = iter(taken)
    start, end = next(spans, (len(text), len(text)))
    at = 0
    while found := COMMENT.search(text, at):
        while end <= found.start():
            start, end = next(spans, (len(text) + 1, len(text) + 1))
        if start <= found.start():
            at = end
            continue
        before = text[text.rfind("\n", 0, found.start()) + 1 : found.start()]
        alone = not before.strip().strip("\ufeff")
        yield Comment(found.start(), found[1].removeprefix(" ").rstrip(), alone)
        at = found.end()


def scalar_spans(node: YamlNode) -> Iterator[tuple[int, int]]:
    """Yield the places of all scalars: a ``#`` inside one is no comment."""
    match node:
        case Scalar(span=span):
            yield span
        case Listing(items=items):
            for item in items:
                yield from scalar_spans(item)
        case Mapping(entries=entries):
            for key, value in entries:
                yield key.span
                yield from scalar_spans(value)


TEXTS = frozenset({"title", "source", "label", "about", "text", *LANGUAGES})
"""Keys whose values people write in their own words."""


def texts_cut_short(node: YamlNode, source: Source) -> Iterator[Span]:
    """Yield the comments without a space behind their ``#`` that cut a text: ``title: Jack #2``."""
    match node:
        case Listing(items=items):
            for item in items:
                yield from texts_cut_short(item, source)
        case Mapping(entries=entries):
            for key, value in entries:
                if key.text not in TEXTS or not isinstance(value, Scalar):
                    yield from texts_cut_short(value, source)
                elif not value.quoted and (found := CUT.match(source.text, value.span.end)):
                    yield Span(found.start(1), found.end(1))


def with_comments(
    statements: Sequence[ast.Statement], found: Iterator[Comment], source: Source
) -> ast.File:
    """Give every comment to its statement; the statements are in the order of the text."""
    above: list[list[str]] = [[] for _ in range(len(statements) + 1)]
    remarks: list[list[str]] = [[] for _ in statements]
    following = 0
    for comment in found:
        while following < len(statements) and statements[following].span.start < comment.at:
            following += 1
        before = statements[following - 1] if following else None
        inside = before is not None and comment.at < before.span.end
        beside = before is not None and same_line(before, comment, source)
        if not comment.alone and (inside or beside):
            remarks[following - 1].append(comment.text)
        else:
            above[following - 1 if inside else following].append(comment.text)
    commented = zip(statements, above, remarks, strict=False)
    return ast.File(
        tuple(replace(s, comments=tuple(a), remark=" ".join(r)) for s, a, r in commented),
        tuple(above[-1]),
    )


def same_line(statement: ast.Statement, comment: Comment, source: Source) -> bool:
    """Return whether a comment stands on the line where a statement ends."""
    ends = source.position(max(statement.span.start, statement.span.end - 1)).line
    return ends == source.position(comment.at).line
