"""The statements of a file by kind, and which of them make a calculation sheet."""

from collections.abc import Iterator
from typing import TypeVar, get_args

from ..base.frozen import replace
from ..diagnostics import Report
from ..diagnostics.model import doubts, sheets
from ..syntax import ast
from .mechanism import Mechanism


def declared(statement: ast.Statement) -> Iterator[ast.Name]:
    """Yield the name that a statement declares: of a quantity, a table, a load."""
    match statement:
        case ast.Param(name=name) | ast.Let(name=name) | ast.Taken(name=name):
            yield name
        case ast.Table(name=name) | ast.Sizes(name=name):
            yield name
        case _ if isinstance(statement, ast.NamedLoad):
            yield statement.name


REPEATABLE = (
    *(ast.Find, ast.Expect, ast.Require, ast.Assembly, ast.Telescope, ast.Reported),
    ast.Slot,
    *get_args(ast.Transmission),
)
"""Statements of which no rule says that they may not stand twice."""

S = TypeVar("S", bound=ast.Statement)


def every(file: ast.File, kind: type[S]) -> list[S]:
    """Return all statements of a kind, in order."""
    return [statement for statement in file.statements if isinstance(statement, kind)]


def only(file: ast.File, kind: type[S]) -> S | None:
    """Return the statement of a kind that stands at most once (the parsers see to it)."""
    return next(iter(every(file, kind)), None)


def check_doubled(file: ast.File, report: Report) -> None:
    """Warn of a statement that says over again what one before it says."""
    first: dict[ast.Statement, ast.Statement] = {}
    for statement in file.statements:
        if isinstance(statement, REPEATABLE):
            plain = replace(statement, comments=(), remark="")
            if plain in first:
                report.add(doubts.stated_again(statement.span, first[plain].span))
            first.setdefault(plain, statement)


WRITTEN_IN_SHEETS = (
    *(ast.Version, ast.Heading, ast.SourceNote),
    *(ast.Param, ast.Table, ast.Sizes, ast.Let, ast.Taken, ast.Brought, ast.Require, ast.Expect),
    *(ast.Translate, ast.Reported),
)
"""The statements of a sheet: a description that has others describes a mechanism."""


def is_sheet(mechanism: Mechanism) -> bool:
    """Return whether a description has formulas only, and nothing that could move."""
    parts = (mechanism.links, mechanism.slides, mechanism.telescopes, mechanism.joints)
    return not (any(parts) or mechanism.loads or mechanism.finds or mechanism.spans)


def written_as_sheet(file: ast.File) -> bool:
    """Return whether a file has statements of a sheet only."""
    return all(isinstance(statement, WRITTEN_IN_SHEETS) for statement in file.statements)


def refuse_links_in_a_sheet(file: ast.File, report: Report) -> None:
    """Report the first statement of a mechanism where the heading says that it is a sheet."""
    if heading := only(file, ast.SheetHeading):
        strange = (s for s in file.statements if not isinstance(s, WRITTEN_IN_SHEETS))
        report.add(sheets.links_in_a_sheet(next(strange).span, heading.span))
