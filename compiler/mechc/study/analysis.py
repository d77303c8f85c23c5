"""A result as people read it, with what follows from it."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Literal

from ..base.frozen import contents, frozen, replace
from ..base.named import NamedTuple
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Require
from ..model.result import Definition, FrictionResult, Result
from ..units import Dimension
from .locking_intervals import EfficiencyRange, Locking, Range
from .tolerances import SAME_FIGURE, SAME_RATIO, SAME_TURN


class Acted(NamedTuple):
    """What a load acts on: a point, the link of a couple, or the distance of two points."""

    name: str
    is_distance: bool = False


class DeadCentre(NamedTuple):
    """What one load acts on stands ``still`` while what the other acts on is ``moving``."""

    still: Acted
    moving: Acted


NoCentre = Literal["perpendicular load", "other"]

Cause = DeadCentre | NoCentre
"""Why a ratio of loads is zero or infinite."""


class Vanishing(NamedTuple):
    """A condition ``factor = 0`` under which a result is zero, or infinite.

    ``at`` solves it: ``(symbol, value)``, exact where the factor allows, else None. ``within``
    are all such values within the symbol's range, in their order; if they are many it is the
    first, and they come again by a ``period``.
    ``cause`` is a dead centre or a load perpendicular to its point's velocity. It is
    ``outside`` where it is proved that the factor does not vanish within the ranges given, and
    ``absent`` where that is proved for the values given of what has no range. Where one of
    ``except_where`` is zero, too, it is not known what the result does.
    """

    factor: Formula
    at: tuple[str, Formula] | None
    cause: Cause
    outside: bool = False
    except_where: tuple[Formula, ...] = ()
    within: tuple[Formula, ...] = ()
    period: Formula | None = None
    absent: bool = False


class Break(NamedTuple):
    """A condition ``factor = 0`` under which ``name``, found by closing loops, is infinite.

    A point that a result rests on is infinitely far away there: the result may jump, and nothing
    is said of it.
    """

    name: str
    factor: Formula


class Extreme(NamedTuple):
    """A value of a parameter, and that of a result there, in SI; it is so ``again`` elsewhere."""

    x: float
    value: float
    again: tuple[float, ...] = ()


def least_and_greatest(found: Sequence[Extreme]) -> tuple[Extreme | None, Extreme | None]:
    """Return the extremes of all that were found, each with every place at which it is met.

    A small value is not met wherever another one is small relative to the greatest.

    >>> low, high = least_and_greatest([Extreme(1.0, 2.0), Extreme(3.0, 2.0), Extreme(2.0, 5.0)])
    >>> low, high
    (Extreme(x=1.0, value=2.0, again=(3.0,)), Extreme(x=2.0, value=5.0, again=()))
    >>> least_and_greatest([Extreme(1.0, 2.0), Extreme(2.0, 2.01), Extreme(3.0, 1e9)])[0]
    Extreme(x=1.0, value=2.0, again=())
    """
    if not found:
        return None, None
    size = max(abs(each.value) for each in found)
    width = max(each.x for each in found) - min(each.x for each in found)

    def met(best: Extreme) -> Extreme:
        near = SAME_RATIO * abs(best.value) + SAME_FIGURE * size
        alike = (each.x for each in found if abs(each.value - best.value) <= near)
        places: list[float] = []
        for x in sorted(alike):
            if not places or x - places[-1] > SAME_TURN * width:
                places.append(x)
        return Extreme(places[0], best.value, tuple(places[1:]))

    low, high = (pick(found, key=lambda each: each.value) for pick in (min, max))
    return met(low), met(high)


@frozen
class Extent:
    """The values of a result as one parameter runs over a range, the others at their values.

    It is found by sampling and refined. ``least`` and ``greatest`` are None where it is infinite
    or undetermined somewhere; they are shown in the unit ``scale``. Zeros and poles are
    ``looked`` for, or are not; on ``zero_intervals`` the result is zero throughout. One that
    ``is_monotone`` is proved to rise or fall, so that it is least and greatest at the ends.
    Of each zero, and of each pole, there is the factor that ``vanishes`` there, by its place, where
    only one of those does under which the result is zero, or infinite.
    """

    parameter: str
    unit: str
    range: Range
    zeros: tuple[float, ...]
    poles: tuple[float, ...]
    least: Extreme | None
    greatest: Extreme | None
    scale: str
    looked: bool
    zero_intervals: tuple[Range, ...] = ()
    is_monotone: bool = False
    vanishes: Mapping[float, Formula] = MappingProxyType({})

    @property
    def is_zero(self) -> bool:
        """Return whether the result is zero throughout the range."""
        return self.zero_intervals == (self.range,)


class NumericSlope(NamedTuple):
    """A derivative in numbers, in SI, and the unit that a description gives lengths in."""

    value: float
    dimension: Dimension
    unit: str = ""


class Multiple(NamedTuple):
    """An earlier ratio, and the factor of one sign by which another one is so many times it."""

    name: str
    factor: Formula
    is_negative: bool


Trend = Literal[
    "rises", "falls", "rises between poles", "falls between poles", "constant", "turns", "unknown"
]
"""``between poles``: on each side of the values at which a result is infinite, not across them."""

ClaimScope = Literal["always", "ranges", "ranges, rest as given", "rest as given", "as given"]
"""For which values a trend is proved.

``always``: for all positive values of what has neither value nor range; ``ranges``: over all
ranges; ``rest as given``: what has a value and no range stands at its value; ``as given``: so does
the parameter itself.
"""


@frozen
class Analysis(Result):
    """A result as it is printed, with where it vanishes, how it moves, where friction locks."""

    zeros: tuple[Vanishing, ...] = ()
    poles: tuple[Vanishing, ...] = ()
    breaks: tuple[Break, ...] = ()
    proportional: Mapping[str, int] | None = None
    """The power in which the result is proportional to a parameter, by its name."""

    independent: tuple[str, ...] = ()
    """The names that the result does not depend on."""

    swaps: tuple[tuple[str, str], ...] = ()
    """Pairs of names that may be exchanged."""

    trends: Mapping[str, Trend] | None = None
    """How the result moves with a parameter: by the sign of the derivative, proved, not sampled."""

    scopes: Mapping[str, ClaimScope] = MappingProxyType({})
    """For which values a trend is proved."""

    derivatives: Mapping[str, Formula] | None = None
    """The partial derivatives."""

    slopes: Mapping[str, NumericSlope] = MappingProxyType({})
    """The same at the default pose."""

    holds: tuple[Require, ...] = ()
    """The conditions of a result that is printed for one case."""

    holds_as: str = ""
    """An earlier result that has the same conditions, if it is named instead of them."""

    same_as: str = ""
    """An earlier ratio that this one equals: then no more is said of it."""

    inverse_of: str = ""
    """A ratio of which this is the inverse: then only how what is said of that is to be read."""

    multiple_of: Multiple | None = None
    """A ratio of which this is a multiple, likewise."""

    inside: frozenset[str] = frozenset()
    """The names of its ``where`` that are coefficients of a system."""

    locking: Locking | None = None
    """Where nothing moves, of a ratio with friction."""

    driven: bool | None = None
    """Whether the other loads drive the motion at the default pose; None where it is not known."""

    fails_here: bool = False
    """Whether the formula does not hold at the default pose: its value there is another form's."""

    efficiency_ranges: tuple[EfficiencyRange, ...] = ()
    """The values that an efficiency runs through."""

    extents: tuple[Extent, ...] = ()
    """The values of a ratio along the stroke, in a report."""

    @property
    def stated(self) -> tuple[Definition, ...]:
        """Return the definitions that the result rests on, without coefficients of systems."""
        return tuple(d for d in self.where if d.name not in self.inside)

    @property
    def iterated(self) -> frozenset[str]:
        """Return the names inside systems that the formula mentions: forces found by iteration."""
        return symbols(self.formula) & self.inside


def as_printed(result: Result) -> Analysis:
    """Return a result as people read it: one with friction for the case of the default pose."""
    analysis = Analysis(**contents(result, Result))
    if not isinstance(result, FrictionResult):
        return analysis
    if result.case is None:
        return replace(analysis, inside=result.inside, driven=result.driven)
    case = result.case
    shown = {"formula": case.formula, "where": case.where, "holds": case.holds}
    analysis = replace(analysis, **shown, guards=case.guards)
    return replace(analysis, inside=result.inside, driven=result.driven)
