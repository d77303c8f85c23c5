"""What is to be plotted, as a person writes it."""

from typing import Literal

from ..frozen import frozen
from ..model.mechanism import Mechanism
from ..model.values import defaults, range_of
from ..named import NamedTuple
from ..routine.steps import Routine

POINTS = 101
"""How many rows the table has where nothing else is asked for."""

Given = str | float


Sign = Literal["<=", ">="]
SIGNS: tuple[Sign, ...] = ("<=", ">=")


class Condition(NamedTuple):
    """What holds in a zone."""

    name: str
    sign: Sign
    bound: str


def condition(text: str) -> Condition:
    """Return a condition that is written as text; ValueError where it is none.

    >>> condition("gamma >= 1.5 rad")
    Condition(name='gamma', sign='>=', bound='1.5 rad')
    """
    for sign in SIGNS:
        name, found, bound = (part.strip() for part in text.partition(sign))
        if name and found and bound:
            return Condition(name, sign, bound)
    raise ValueError(f"{text!r} is not NAME >= VALUE, as in 'gamma >= 1.5 rad'")


@frozen
class Query:
    """Results ``ys`` against ``x``, once for each setting of the ``family``.

    Values are in SI and radians, or texts with their units. Without ``x`` the drive varies,
    without ``ys`` the first result is shown; ``paths`` are points whose paths are shown instead,
    ``ends`` a range other than that of the description. The
    ``zone`` in which conditions hold is marked.
    """

    x: str = ""
    ys: tuple[str, ...] = ()
    family: tuple[tuple[str, tuple[Given, ...]], ...] = ()
    ends: tuple[Given, Given] | None = None
    paths: tuple[str, ...] = ()
    zone: tuple[Condition, ...] = ()
    points: int = POINTS


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
    drive = mechanism.drive_name
    return sorted(free, key=lambda name: name != drive)
