"""What is to be plotted, as a person writes it."""

import math
from typing import Literal

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..model.mechanism import Mechanism
from ..model.values import defaults, range_of
from ..routine.steps import Routine
from ..units import ANGLE, size_of

USUAL_ROWS = 101
"""How many rows the table has where nothing else is asked for."""

GivenSetting = str | float


Sign = Literal["<=", ">="]
SIGNS: tuple[Sign, ...] = ("<=", ">=")


class ZoneCondition(NamedTuple):
    """What holds in a zone."""

    name: str
    sign: Sign
    bound: str


def condition(text: str) -> ZoneCondition:
    """Return a condition that is written as text; ValueError where it is none.

    >>> condition("gamma >= 1.5 rad")
    ZoneCondition(name='gamma', sign='>=', bound='1.5 rad')
    """
    for sign in SIGNS:
        name, found, bound = (part.strip() for part in text.partition(sign))
        if name and found and bound:
            return ZoneCondition(name, sign, bound)
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
    family: tuple[tuple[str, tuple[GivenSetting, ...]], ...] = ()
    ends: tuple[GivenSetting, GivenSetting] | None = None
    paths: tuple[str, ...] = ()
    zone: tuple[ZoneCondition, ...] = ()
    points: int = USUAL_ROWS


ROWS = 11
"""How many rows the table of a report has about, and has where no step is round."""

FEWEST, MOST = 8, 20
"""Between how many rows a table has for the sake of round steps."""

ROUND_STEPS = (1.0, 2.0, 2.5, 4.0, 5.0)
"""Round steps, but for powers of ten."""

STEP_ROUNDING = 1e-9
"""By what part of it a step that was computed may be off."""

DEGREES = (1.0, 2.0, 3.0, 4.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0)
"""Round steps of an angle in degrees."""


def rows(x: str, mechanism: Mechanism) -> int:
    """Return the rows of a table over a parameter: so many that their steps are round."""
    ends, parameter = range_of(x, mechanism), mechanism.parameter(x)
    if ends is None:
        return ROWS
    unit = parameter.unit or ("deg" if parameter.dimension == ANGLE else "")
    width = (ends[1] - ends[0]) / (size_of(unit) if unit else 1.0)
    counts = sorted(range(FEWEST, MOST + 1), key=lambda n: (abs(n - ROWS), -n))
    return next((n for n in counts if _is_round(width / (n - 1), unit)), ROWS)


def _is_round(step: float, unit: str) -> bool:
    """Return whether a person would take a step.

    >>> _is_round(30.0, "deg"), _is_round(36.0, "deg"), _is_round(0.25, "mm"), _is_round(0.3, "mm")
    (True, False, True, False)
    """
    if step <= 0:
        return False
    power = 10.0 ** math.floor(math.log10(step) + STEP_ROUNDING)
    known = DEGREES if unit == "deg" else [size * power for size in ROUND_STEPS]
    return any(math.isclose(step, one, rel_tol=STEP_ROUNDING) for one in known)


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
            return Query(x, ys, points=rows(x, mechanism))
    return None


def _ranged(mechanism: Mechanism) -> list[str]:
    """Return the drive, and the parameters that have a range."""
    free = [p.name for p in mechanism.parameters if not p.dependent and range_of(p.name, mechanism)]
    drive = mechanism.drive_name
    return sorted(free, key=lambda name: name != drive)
