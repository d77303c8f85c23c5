"""The syntax tree to YAML, one canonical text for each tree, made from the table of sections.

YAML orders by sections: the statements of a section keep their order, and several of one
name stand together; :func:`in_yaml_order` is the tree that reading the text gives back.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import Any

from . import ast, text
from .to_dsl import commented, given
from .yaml.section_table import ORDER, SECTIONS
from .yaml.sections import EntryKey, EntryShape, SectionEntry, ValueKind, YamlSection
from .yaml.text import scalar
from .yaml.text import text as text_scalar

Statements = Sequence[ast.Statement]


def in_yaml_order(file: ast.File) -> ast.File:
    """Return the tree with its statements in the order in which YAML has them."""
    groups = [
        [statement for same in named(section, found) for statement in same]
        for section, found in sections(file)
    ]
    return ast.File(tuple(s for group in groups for s in group), file.trailing)


def to_yaml(file: ast.File) -> str:
    r"""Return the canonical YAML text of a description.

    >>> from mechc.source import Span
    >>> nowhere = Span(0, 0)
    >>> pivots = tuple(ast.Pivot(nowhere, ast.Name(point, nowhere)) for point in "OC")
    >>> to_yaml(ast.File(pivots))
    'pivots: [O, C]\n'
    """
    lines: list[str] = []
    for section, found in sections(file):
        lines += section_lines(section, found)
    lines += [commented(comment) for comment in file.trailing]
    return "".join(f"{line}\n" for line in lines)


def sections(file: ast.File) -> Iterator[tuple[YamlSection, list[ast.Statement]]]:
    """Yield the sections that have statements, in their order."""
    ordered = sorted(file.statements, key=lambda statement: ORDER[type(statement)])
    for number, found in groupby(ordered, key=lambda statement: ORDER[type(statement)]):
        yield SECTIONS[number], list(found)


def named(section: YamlSection, found: Statements) -> list[list[ast.Statement]]:
    """Bring statements with the same name together, where a name is a key."""
    if section.shape is not EntryShape.NAMED or keeps_doubles(section):
        return [[statement] for statement in found]
    groups: dict[str, list[ast.Statement]] = {}
    for statement in found:
        groups.setdefault(subject_text(statement), []).append(statement)
    return list(groups.values())


def keeps_doubles(section: YamlSection) -> bool:
    """Return whether a list would mean coordinates, so that doubles stay two (wrong) keys."""
    short = section.entries[0].short
    return short is not None and short.kind in (
        ValueKind.VECTOR,
        ValueKind.CARTESIAN,
        ValueKind.ROWS,
        ValueKind.SIZES,
    )


def section_lines(section: YamlSection, found: Statements) -> list[str]:
    """Return the lines of a section."""
    match section.shape:
        case EntryShape.ONE:
            return [line for statement in found for line in one_lines(section, statement)]
        case EntryShape.NAMED:
            return [f"{section.name}:", *named_lines(section, found)]
        case EntryShape.LISTED:
            return [f"{section.name}:", *value_lines(found, 2)]
        case EntryShape.BARE:
            return bare_lines(section, found)
        case EntryShape.EITHER:
            return either_lines(section, found)


def one_lines(section: YamlSection, statement: ast.Statement) -> list[str]:
    """Return the lines of a section that is one entry, with the keys that go with it."""
    lines = with_comments(f"{section.name}: {value_text(statement, False)}", statement, 0)
    for beside in section.beside:
        value = fields_of(statement, beside)
        if any(map(given, value)):
            lines.append(f"{beside.name}: {kind_text(beside.kind, value, False)}")
    return lines


def named_lines(section: YamlSection, found: Statements) -> Iterator[str]:
    """Yield ``name: value`` for each name, a list where a name has several values."""
    for same in named(section, found):
        subject = subject_text(same[0])
        if len(same) > 1:
            yield f"  {subject}:"
            yield from value_lines(same, 4)
        else:
            yield from with_comments(f"  {subject}: {value_text(same[0], False)}", same[0], 2)


def value_lines(found: Iterable[ast.Statement], indent: int) -> Iterator[str]:
    """Yield the values of one name, or entries without a name, as a list."""
    for statement in found:
        line = f"{' ' * indent}- {value_text(statement, False)}"
        yield from with_comments(line, statement, indent)


def bare_lines(section: YamlSection, found: Statements) -> list[str]:
    """Return a section of names: in one line if nothing else is said of them."""
    valued = [has_value(statement) for statement in found]
    subjects = [subject_text(statement) for statement in found]
    if not any(valued) and not any(s.comments or s.remark for s in found):
        return [f"{section.name}: [{', '.join(subjects)}]"]
    mapping = all(valued) and len(set(subjects)) == len(subjects)
    lines = [f"{section.name}:"]
    for statement, subject, value in zip(found, subjects, valued, strict=True):
        item = f"{subject}: {value_text(statement, False)}" if value else subject
        lines += with_comments(f"  {item}" if mapping else f"  - {item}", statement, 2)
    return lines


def either_lines(section: YamlSection, found: Statements) -> list[str]:
    """Return results: named ones as a mapping, otherwise a list."""
    names = [s.name.text for s in found if isinstance(s, ast.Find) and s.name]
    if len(set(names)) == len(found):
        return [f"{section.name}:", *result_lines(found)]
    if not names and not any(s.comments or s.remark for s in found):
        texts = [scalar(text.result(s), flow=True) for s in found if isinstance(s, ast.Find)]
        return [f"{section.name}: [{', '.join(texts)}]"]
    return [f"{section.name}:", *value_lines(found, 2)]


def result_lines(found: Statements) -> Iterator[str]:
    """Yield ``k: P/F``."""
    for statement in found:
        assert isinstance(statement, ast.Find)
        assert statement.name is not None
        nameless = ast.Find(statement.span, statement.target, None, statement.on)
        value = scalar(text.result(nameless))
        yield from with_comments(f"  {scalar(statement.name.text)}: {value}", statement, 2)


def with_comments(line: str, statement: ast.Statement, indent: int) -> list[str]:
    """Return a line with the comments above it and the remark behind it."""
    above = [f"{' ' * indent}{commented(comment)}" for comment in statement.comments]
    return [*above, f"{line}  # {statement.remark}" if statement.remark else line]


def entry_of(statement: ast.Statement) -> SectionEntry:
    """Return the entry of the table of sections that a statement is printed by."""
    section = SECTIONS[ORDER[type(statement)]]
    return next(entry for entry in section.entries if entry.node is type(statement))


def subject_text(statement: ast.Statement) -> str:
    """Return the key under which a statement stands."""
    subject = entry_of(statement).subject
    assert subject is not None
    name = getattr(statement, subject.fields[0])
    return "pins" if name is None else scalar(name.text)


def fields_of(statement: ast.Statement, key: EntryKey) -> list[Any]:
    """Return the values of the fields that a key fills."""
    return [getattr(statement, field) for field in key.fields]


def has_value(statement: ast.Statement) -> bool:
    """Return whether a statement says more than its name."""
    short = entry_of(statement).short
    return short is not None and any(map(given, fields_of(statement, short)))


def value_text(statement: ast.Statement, flow: bool) -> str:
    """Return the value behind a statement's key, plain where its other keys are empty."""
    entry = entry_of(statement)
    filled = [key for key in entry.keys if any(map(given, fields_of(statement, key)))]
    if entry.short and all(set(key.fields) <= set(entry.short.fields) for key in filled):
        return kind_text(entry.short.kind, fields_of(statement, entry.short), flow)
    parts = [other_text(statement, key) for key in entry.others]
    parts += [f"{k.name}: {kind_text(k.kind, fields_of(statement, k), True)}" for k in filled]
    return "{" + ", ".join(parts) + "}"


def other_text(statement: ast.Statement, key: EntryKey) -> str:
    """Return ``O1: r1``."""
    point, *value = fields_of(statement, key)
    return f"{point.text}: {kind_text(key.kind, value, True)}"


SCALARS: Mapping[ValueKind, Callable[..., str]] = {
    ValueKind.RANGE: text.range_of,
    ValueKind.RIM: text.rim,
    ValueKind.ROUTE: text.route,
    ValueKind.MEASURE: text.measure,
    ValueKind.LET_VALUE: text.let_value,
    ValueKind.RESULT: lambda target, name, on: text.result(ast.Find(target.span, target, name, on)),
    ValueKind.CONDITION: lambda operands, operators: text.condition(
        ast.Require(operands[0].span, operands, operators)
    ),
    ValueKind.REPORTED: lambda name, over: text.reported(ast.Reported(name.span, name, over)),
    ValueKind.EXPECTATION: lambda subject, *fields: text.expectation(
        ast.Expect(subject.span, subject, *fields)
    ),
}
"""Values that YAML has as the DSL's own words, in one scalar."""


def kind_text(kind: ValueKind, fields: list[Any], flow: bool) -> str:
    """Return a value by its kind, the reverse of the reader's table."""
    if kind in SCALARS:
        return scalar(SCALARS[kind](*fields), flow)
    match kind, fields:
        case ValueKind.TEXT, [value]:
            return text_scalar(value, flow)
        case ValueKind.USED, [used]:
            return text_scalar(used.text, flow)
        case ValueKind.FLAG, [value]:
            return "true" if value else "false"
        case ValueKind.PAIR, [first, first_link, second, second_link]:
            return _list([text.end(first, first_link), text.end(second, second_link)])
        case ValueKind.SHARED, [points]:
            return _list(point.text for point in points)
        case ValueKind.NAMES, [names]:
            return _list(scalar(name.text, True) for name in names)
        case ValueKind.SIZES, [sizes]:
            return _expressions(sizes)
        case ValueKind.ROWS, [rows]:
            return _list(map(_expressions, rows))
        case ValueKind.GIVEN, [settings]:
            return f"{{{', '.join(_setting(*setting) for setting in settings)}}}"
        case ValueKind.JOINTS, [joined]:
            return f"{{{', '.join(f'{there.text}: {here.text}' for there, here in joined)}}}"
        case _, [value]:
            return value_of(value, flow)
        case _:
            raise AssertionError(f"{kind} has no text")


def _setting(name: ast.Name, value: ast.Expr) -> str:
    return f"{scalar(name.text, True)}: {scalar(text.expression(value), True)}"


def _list(items: Iterable[str]) -> str:
    return f"[{', '.join(items)}]"


def _expressions(values: Iterable[ast.Expr]) -> str:
    return _list(scalar(text.expression(value), True) for value in values)


def value_of(value: Any, flow: bool) -> str:
    """Return a name, a word, a vector, a direction or an expression."""
    match value:
        case str():
            return value
        case ast.Name(text=name):
            return scalar(name, flow)
        case ast.Cartesian(x=x, y=y):
            return f"[{scalar(text.expression(x), True)}, {scalar(text.expression(y), True)}]"
        case ast.Polar(length=None, direction=towards) if towards is not None:
            return f"{{angle: {scalar(text.direction(towards), True)}}}"
        case ast.Polar():
            return scalar(text.vector(value), flow)
        case _:
            return scalar(text.direction(value), flow)
