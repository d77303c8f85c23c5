"""What the process ends with: the class of what went wrong, as scripts ask for it."""

from collections.abc import Iterable

from ..diagnostics import Diagnostic, Severity, drawing, statics

WRONG, MISUSED, ENVIRONMENT, LIMIT, INTERNAL = 1, 2, 3, 4, 70
"""The description is wrong, the command line is (:class:`.usage.UsageError`), a file or program is,
a limit was met, mechc itself is wrong."""


def status(diagnostics: Iterable[Diagnostic]) -> int:
    """Return the exit status for a set of diagnostics: the worst class of their errors.

    >>> status([Diagnostic("E203", "x", None, "x"), Diagnostic("E801", "y", None, "y")])
    4
    """
    errors = {d.code for d in diagnostics if d.severity is Severity.ERROR}
    if not errors:
        return 0
    if errors & statics.BUGS:
        return INTERNAL
    classes = {code[1] for code in errors}
    if "9" in classes or errors & drawing.LACKING:
        return ENVIRONMENT
    if "8" in classes:
        return LIMIT
    return WRONG
