"""The YAML notation to the syntax tree.

Every scalar is read as text, with the grammar of the line notation: YAML's own numbers
and truth values (``010`` is 8, ``1e3`` a text, ``no`` false) never come into play.

The statements stand in the order of the text, section by section.
"""

from collections.abc import Iterator
from typing import Any

from ..base.frozen import replace
from ..diagnostics import Report, syntax_yaml
from ..source import Source, Span
from . import ast
from .fault import Fault, check_length, check_once, note
from .yaml import slips
from .yaml.comments import comments, texts_cut_short, with_comments
from .yaml.entries import several, statements
from .yaml.nodes import Listing, Mapping, Scalar, YamlNode, compose
from .yaml.scalars import described
from .yaml.section_table import BY_NAME, FURTHER_KEYS
from .yaml.sections import EntryShape, YamlSection
from .yaml.values import values

Item = tuple[Scalar | None, YamlNode]


def parse(source: Source, report: Report) -> ast.File:
    """Return the tree of a YAML text.

    Errors go to the report; an entry with an error is not in the tree. Raises
    :class:`MechcError` where the text is no YAML at all, or far too large.

    >>> source = Source("a.yaml", "pivots: [O]  # left pin")
    >>> parse(source, Report(source)).statements
    (Pivot(span=Span(start=9, end=10), point=Name(text='O', ...remark='left pin'),)
    """
    check_length(source, report)
    root = compose(report)
    found_statements = list(read_root(root, report)) if root else []
    check_once(found_statements, report)
    for span in texts_cut_short(root, source) if root else ():
        report.add(syntax_yaml.text_cut_short(span, source.written(span)))
    return with_comments(found_statements, comments(root, source), source)


def read_root(root: YamlNode, report: Report) -> Iterator[ast.Statement]:
    """Yield the statements of all sections."""
    if not isinstance(root, Mapping):
        if not (isinstance(root, Scalar) and root.empty):
            expected = "a mapping with keys such as mechanism, params, links"
            note(syntax_yaml.wrong_shape(root.span, described(root), expected), report)
        return
    for name, value in root.entries:
        if name.text in BY_NAME:
            yield from read_section(BY_NAME[name.text], name, value, root, report)
        elif name.text not in FURTHER_KEYS:
            allowed = [*BY_NAME, *FURTHER_KEYS]
            hint = slips.of_section(name.text, allowed)
            place = "the description"
            note(syntax_yaml.unknown_key(name.span, name.text, place, allowed, hint), report)
        elif not {key.text for key, _ in root.entries}.intersection(FURTHER_KEYS[name.text]):
            lacking = FURTHER_KEYS[name.text][:1]
            note(syntax_yaml.missing_key(name.span, lacking, f"'{name.text}'"), report)


def read_section(
    section: YamlSection, name: Scalar, value: YamlNode, root: Mapping, report: Report
) -> Iterator[ast.Statement]:
    """Yield the statements of a section; an entry with an error is reported and left out."""
    for subject, entry in items(section, name, value, report):
        for single in several(entry, section):
            span = _place_of(single, entry, subject)
            try:
                for statement in statements(section, subject, single, span, report.source):
                    yield with_beside(statement, section, name, root, report.source)
            except Fault as fault:
                note(slips.decimal_comma(fault.diagnostic, report.source), report)


def _place_of(single: YamlNode, entry: YamlNode, subject: Scalar | None) -> Span:
    """Return where a statement stands: with its name, if no other value of the entry shares it."""
    return subject.span.to(single.span) if subject and single is entry else single.span


def with_beside(
    statement: ast.Statement, section: YamlSection, name: Scalar, root: Mapping, source: Source
) -> ast.Statement:
    """Return the statement of a section of one entry with the values of the keys beside it.

    Beside ``gravity: -y`` a top-level key ``g: 9.8 m/s^2`` is a part of the same statement. Other
    statements stay as they are.
    """
    if section.shape is not EntryShape.ONE:
        return statement
    wanted = {key.name: key for key in section.beside}
    fields: dict[str, Any] = {}
    for key, value in root.entries:
        if key.text in wanted:
            fields |= values(wanted[key.text], value, source)
    return replace(statement, span=name.span.to(statement.span), **fields)


def items(section: YamlSection, name: Scalar, value: YamlNode, report: Report) -> Iterator[Item]:
    """Yield the entries of a section with what names them, by the section's shape."""
    if isinstance(value, Scalar) and value.empty and section.shape is not EntryShape.ONE:
        return
    match section.shape, value:
        case EntryShape.ONE, _:
            yield None, value
        case ((EntryShape.NAMED | EntryShape.BARE | EntryShape.EITHER), Mapping(entries=entries)):
            yield from whole(entries, report)
        case ((EntryShape.LISTED | EntryShape.EITHER), Listing(items=listed)):
            yield from ((None, item) for item in listed)
        case EntryShape.BARE, Listing(items=listed):
            yield from bare_items(listed, report)
        case EntryShape.BARE, Scalar():
            yield from bare_items((value,), report)
        case ((EntryShape.LISTED | EntryShape.EITHER), Scalar()):
            yield None, value
        case _:
            hint = slips.of_shape(value.text) if isinstance(value, Scalar) else ""
            hint = hint or slips.written(section.name)
            expected = expected_shape(section)
            note(syntax_yaml.wrong_shape(value.span, described(value), expected, hint), report)


def expected_shape(section: YamlSection) -> str:
    """Return the shape of a section in words, as what was expected."""
    match section.shape:
        case EntryShape.LISTED:
            return f"a list ({section.name}: [{{…}}, {{…}}])"
        case EntryShape.EITHER | EntryShape.BARE:
            return "a list or a mapping"
        case EntryShape.ONE | EntryShape.NAMED:
            return f"a mapping ({section.name}: {{…: …}})"


def bare_items(listed: tuple[YamlNode, ...], report: Report) -> Iterator[Item]:
    """Yield names standing alone in a list, or with a value of their own."""
    for item in listed:
        match item:
            case Mapping(entries=entries):
                yield from whole(entries, report)
            case Scalar(span=span):
                yield item, Scalar("", Span(span.end, span.end))
            case Listing():
                hint = "the points of a link are written together: [OA, AB]"
                note(syntax_yaml.wrong_shape(item.span, "a list", "a name", hint), report)


def whole(entries: tuple[tuple[Scalar, YamlNode], ...], report: Report) -> Iterator[Item]:
    """Yield entries, unless flow style has cut a pair in round brackets in two."""
    cut = False
    for name, value in entries:
        if cut and name.text.endswith(")"):
            cut = False
            continue
        cut = isinstance(value, Scalar) and value.text.startswith("(") and ")" not in value.text
        if cut:
            note(syntax_yaml.round_brackets(value.span), report)
        else:
            yield name, value
