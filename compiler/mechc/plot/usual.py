"""What a report plots of a mechanism where nobody says it: its first result over its range."""

from ..model.mechanism import Mechanism
from ..model.values import defaults, range_of
from ..routine.steps import Routine
from .query import Query

ROWS = 11
"""How many rows the table of a report has."""


def usual(mechanism: Mechanism, routine: Routine) -> Query | None:
    """Return the first result, also with friction, over the stroke or over the first range.

    None where nothing with a value depends on what has a range.
    """
    known = defaults(mechanism)
    whole = {f.name: f for f in routine.functions if {i.name for i in f.inputs} <= known.keys()}
    for x in _ranged(mechanism):
        varying = [n for n, f in whole.items() if x in {i.name for i in f.inputs}]
        if varying:
            with_friction = f"{varying[0]}_f"
            ys = (varying[0], *([with_friction] if with_friction in varying else []))
            return Query(x, ys, points=ROWS)
    return None


def _ranged(mechanism: Mechanism) -> list[str]:
    """Return the drive, and the parameters that have a range."""
    free = [p.name for p in mechanism.parameters if not p.dependent and range_of(p.name, mechanism)]
    drive = mechanism.drive.parameter if mechanism.drive else ""
    return sorted(free, key=lambda name: name != drive)
