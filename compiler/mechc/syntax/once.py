"""What holds for a file as a whole: some things are said once, the version first."""

from collections.abc import Sequence

from ..diagnostics import Report, syntax
from . import ast
from .fault import note

ONCE: dict[type[ast.Statement], str] = {
    ast.Version: "mechc",
    ast.Heading: "mechanism",
    ast.SourceNote: "source",
    ast.Gravity: "gravity",
    ast.Mirror: "mirror",
    ast.Copies: "copies",
    ast.Motion: "motion",
    ast.Efficiency: "efficiency",
}


def check_once(statements: Sequence[ast.Statement], report: Report) -> None:
    """Report what is stated twice, and a version that is not the first statement."""
    first: dict[type[ast.Statement], ast.Statement] = {}
    for statement in statements:
        kind = ast.Heading if isinstance(statement, ast.Heading) else type(statement)
        if kind in ONCE and kind in first:
            what = _called(statement, first[kind])
            note(syntax.stated_twice(statement.span, what, first[kind].span), report)
        first.setdefault(kind, statement)
    for statement in statements[1:]:
        if isinstance(statement, ast.Version) and statement is first[ast.Version]:
            note(syntax.version_not_first(statement.span), report)


def _called(statement: ast.Statement, first: ast.Statement) -> str:
    """Return the word of what is stated twice; a sheet has a heading of its own."""
    match first, statement:
        case ast.SheetHeading(), ast.SheetHeading():
            return "sheet"
        case (ast.SheetHeading(), _) | (_, ast.SheetHeading()):
            return "mechanism or sheet"
        case _:
            return ONCE[type(first)]
