"""The statements of a file by kind."""

from typing import TypeVar

from ..diagnostics import Report
from ..diagnostics.model import names as messages
from ..frozen import replace
from ..syntax import ast

REPEATABLE = (
    *(ast.Find, ast.Expect, ast.Require, ast.Assembly, ast.Telescope, ast.Reported),
    *(ast.Slot, ast.Contact, ast.Gear, ast.Belt, ast.Rack, ast.Screw, ast.Rope),
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
                report.add(messages.stated_again(statement.span, first[plain].span))
            first.setdefault(plain, statement)
