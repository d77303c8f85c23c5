"""What makes a description a calculation sheet."""

from ..diagnostics import Report
from ..diagnostics.model import sheets as messages
from ..syntax import ast
from .mechanism import Mechanism
from .statements import only

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
        report.add(messages.links_in_a_sheet(next(strange).span, heading.span))
