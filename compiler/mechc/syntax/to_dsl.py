"""The syntax tree to the line notation, one canonical text for each tree.

Statements keep their order; a blank line stands where the subject changes; ``=`` signs
and remarks are aligned within such a paragraph. The comments of a statement stand above it.
"""

import re
from collections.abc import Sequence
from itertools import groupby
from typing import Any, get_args

from ..base.later import pattern
from . import ast, text
from .examples import ALL_PINS, LINES, ONE_PIN
from .vocabulary import LANGUAGES, NAME

QUOTED = frozenset({"title", "text", "label", "about", "source", *LANGUAGES})

SUBJECTS: tuple[tuple[type[ast.Statement], ...], ...] = (
    (ast.Version, ast.Heading, ast.SheetHeading, ast.SourceNote),
    (ast.Param, ast.Drive),
    (ast.Table, ast.Sizes),
    (
        *(ast.Pivot, ast.Slider, ast.Link, ast.Slide, ast.Slot, ast.Telescope),
        *get_args(ast.Transmission),
    ),
    (ast.Drawn, ast.Vector, ast.Turn, ast.Assembly),
    (ast.Mirror, ast.Copies),
    (*get_args(ast.Load), ast.Gravity),
    (*get_args(ast.Friction), ast.Motion, ast.Efficiency),
    (ast.Use, ast.Let, ast.Find, ast.Require, ast.Expect),
    (ast.Reported,),
    (ast.Translate,),
)
SUBJECT = {node: number for number, nodes in enumerate(SUBJECTS) for node in nodes}

OPTIONAL = pattern(r"\[([^\]]*)\]")
FIELD = pattern(r"\{(\w+)\}")

STOP = "\0"
"""Where a row may be aligned: a character that no text has (E129)."""


def to_dsl(file: ast.File) -> str:
    r"""Return the canonical ``.mech`` text of a description.

    >>> from mechc.diagnostics import Report
    >>> from mechc.source import Source
    >>> from mechc.syntax.from_dsl import parse
    >>> source = Source("a.mech", "let   k=(a+b) # sum")
    >>> to_dsl(parse(source, Report(source)))
    'let k = a + b  # sum\n'
    """
    paragraphs = [
        paragraph(list(group))
        for _, group in groupby(file.statements, key=lambda node: SUBJECT[type(node)])
    ]
    if file.trailing:
        paragraphs.append([commented(comment) for comment in file.trailing])
    return "\n".join("".join(f"{line}\n" for line in lines) for lines in paragraphs)


def paragraph(statements: Sequence[ast.Statement]) -> list[str]:
    """Return the lines of statements on one subject, aligned."""
    rows = aligned([line(statement) for statement in statements])
    remarked = [row for row, node in zip(rows, statements, strict=True) if node.remark]
    column = max(map(len, remarked), default=0)
    lines: list[str] = []
    for row, statement in zip(rows, statements, strict=True):
        lines += [commented(comment) for comment in statement.comments]
        lines.append(f"{row:{column}}  # {statement.remark}" if statement.remark else row)
    return lines


def commented(comment: str) -> str:
    """Return a comment line."""
    return f"# {comment}".rstrip()


def aligned(rows: list[str]) -> list[str]:
    """Bring the first ``|`` of all rows that have one to the same column, as a space."""
    column = max((row.index(STOP) for row in rows if STOP in row), default=0)
    return [
        f"{left:{column}} {right}" if stop else left
        for left, stop, right in (row.partition(STOP) for row in rows)
    ]


def line(statement: ast.Statement) -> str:
    """Return the text of one statement, :data:`STOP` where it may be aligned."""
    match statement:
        case ast.Find():
            return f"find {text.result(statement)}"
        case ast.Reported():
            return f"report {text.reported(statement)}"
        case ast.Rope(start=start, falls=falls):
            return f"rope {text.route(start, falls)}"
        case ast.Require():
            return f"require {text.condition(statement)}"
        case ast.Expect():
            return f"expect {text.expectation(statement)}"
        case ast.PinFriction(point=point):
            return filled(ONE_PIN if point else ALL_PINS, statement)
        case _:
            return filled(LINES[type(statement)], statement)


def filled(template: str, statement: ast.Statement) -> str:
    """Fill a template of :data:`LINES` with the statement's fields."""

    def present(optional: re.Match[str]) -> str:
        names = FIELD.findall(optional[1])
        return optional[1] if all(given(getattr(statement, name)) for name in names) else ""

    def field(name: re.Match[str]) -> str:
        return written(name[1], getattr(statement, name[1]))

    return FIELD.sub(field, OPTIONAL.sub(present, template).replace("|", STOP))


def given(value: object) -> bool:
    """Return whether a field was written: not None, '', () or False."""
    return value is not None and value != "" and value != () and value is not False


def written(field: str, value: Any) -> str:
    """Return a field's value as it stands in a line."""
    match value:
        case True:
            return field
        case str():
            return quoted(value) if field in QUOTED else value
        case tuple() if field == "rows":
            return ", ".join(map(text.row, value))
        case tuple() if field == "given":
            return text.settings(value)
        case tuple() if field == "joining":
            return text.joints(value)
        case tuple() if field == "without":
            return ", ".join(name.text for name in value)
        case tuple() if field == "sizes":
            return ", ".join(map(text.expression, value))
        case tuple():
            return " ".join(name.text for name in value)
        case ast.Choice() | ast.Lookup() | ast.NextSize():
            return text.let_value(value)
        case ast.Name(text=name):
            return quoted(name) if field == "used" and not NAME.fullmatch(name) else name
        case ast.Polar() | ast.Cartesian():
            return text.vector(value)
        case _:
            return text.direction(value)


def quoted(value: str) -> str:
    r"""Return a text in quotes; :func:`mechc.syntax.parser.builders.unquoted` takes them off again.

    >>> quoted('a "b"')
    '"a \\"b\\""'
    """
    escaped = value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'
