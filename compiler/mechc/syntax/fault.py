"""How a mistake inside one statement or one scalar leaves the parser, and how many may."""

from ..diagnostics import Diagnostic, Report, syntax_limits
from ..source import Source, Span
from . import limits


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


def check_length(source: Source, report: Report) -> None:
    """Raise :class:`MechcError` for a text too long to read."""
    if len(source.text) > limits.CHARACTERS:
        found = len(source.text)
        raise report.fail(syntax_limits.text_too_long(Span(0, 0), found, limits.CHARACTERS))
