"""What a report of a mechanism holds: ``report scheme, k, plot k over alpha``."""

from collections.abc import Iterator, Sequence

from ...diagnostics import near_miss
from ...diagnostics.model import results as messages
from ...syntax import ast
from ..mechanism import Mechanism, Reported
from ..names.scope import NameScope
from ..statements import is_sheet
from ..values import range_of

PICTURES = ("scheme", "bodies", "plans", "stroke")
"""What a report may hold besides results and plots."""


def checked(
    parts: Sequence[ast.Reported], mechanism: Mechanism, scope: NameScope
) -> tuple[Reported, ...]:
    """Return the parts of the report, in order; reject those that the mechanism does not have."""
    if is_sheet(mechanism):
        scope.report.add(messages.parts_of_a_sheet(parts[0].span))
        return ()
    return tuple(_checked(parts, mechanism, scope))


def _checked(
    parts: Sequence[ast.Reported], mechanism: Mechanism, scope: NameScope
) -> Iterator[Reported]:
    """Yield the parts of a report; report names of nothing that it could show."""
    found = {find.name for find in mechanism.finds}  # a load that is asked for is one of them
    entries = scope.entries.items()
    results = [n for n, entry in entries if n in found or entry.kind in ("result", "let")]
    ranged = [p.name for p in mechanism.parameters if range_of(p.name, mechanism)]
    for part in parts:
        name, over = part.name, part.over
        known = results if over else [*PICTURES, *results]
        if name.text not in known:
            hint = near_miss(name.text, known)
            scope.report.add(messages.no_part_of_a_report(name.span, name.text, known, hint))
        elif over and over.text not in ranged:
            hint = near_miss(over.text, ranged)
            scope.report.add(messages.plot_over_no_range(over.span, over.text, ranged, hint))
        elif name.text == "stroke" and mechanism.drive is None:
            scope.report.add(messages.stroke_without_drive(name.span))
        else:
            yield Reported(name.text, over.text if over else "")
