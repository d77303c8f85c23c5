"""How a mistake inside one statement or one scalar leaves the parser; mistakes of a whole text."""

from collections.abc import Sequence
from unicodedata import category

from ..diagnostics import Diagnostic, Report, syntax, syntax_limits
from ..source import Source, Span
from . import ast, limits

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
"""What is said once in a file, and its word."""


class Fault(Exception):
    """A diagnostic that ends the reading of one statement; the next one is still read."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic
        super().__init__(diagnostic.message)


def note(diagnostic: Diagnostic, report: Report) -> None:
    """Report an error; raise :class:`MechcError` when there are too many to go on."""
    report.add(diagnostic)
    if len(report.diagnostics) >= limits.FAULTS:
        span = diagnostic.span or Span(0, 0)
        raise report.fail(syntax_limits.too_many_errors(span, limits.FAULTS))


def _is_unprintable(character: str) -> bool:
    """Return whether it is a control character, half of a character, or no character."""
    if category(character) == "Cc":
        return character not in "\t\n\f\r\x85"
    return category(character) == "Cs" or character in "\ufffe\uffff"


def check_characters(text: str, span: Span | None, report: Report) -> None:
    """Report a character that no text has; ``span`` is the text's place, None for a whole file."""
    if found := set(filter(_is_unprintable, set(text))):
        at = min(map(text.index, found))
        note(syntax.unprintable_character(span or Span(at, at + 1), text[at]), report)


def check_length(source: Source, report: Report) -> None:
    """Raise :class:`MechcError` for a text too long to read."""
    if len(source.text) > limits.CHARACTERS:
        found = len(source.text)
        raise report.fail(syntax_limits.text_too_long(Span(0, 0), found, limits.CHARACTERS))


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
