"""What is found: each result as a readable formula, and what follows from it.

It stands beside what was asked for (``mechanism.Find``): power fills it, statics judges
it, and neither needs to know of the other.

All formulas are in SI and radians and mention free parameters and the names in
``where`` only.
"""

from collections.abc import Mapping
from typing import Literal, NamedTuple

from ..formula.tree import Formula
from ..frozen import frozen, replace
from ..units import Dimension
from .locking import Course, Locking
from .mechanism import Require, Target


class Definition(NamedTuple):
    """``name = formula``: an intermediate that a result mentions."""

    name: str
    formula: Formula


class Vanishing(NamedTuple):
    """A condition ``factor = 0`` under which a result is zero, or infinite.

    ``at`` solves it: ``(symbol, value)``, exact where the factor allows, else None.
    ``kind`` tells a dead centre from a load perpendicular to its point's velocity.
    """

    factor: Formula
    at: tuple[str, Formula] | None
    kind: Literal["output still", "drive locked", "perpendicular load", "other"]


@frozen
class Case:
    """A result as it is printed: for one case of the signs of slips and forces.

    ``holds`` are the conditions, each ``formula > 0`` or ``formula < 0``.
    """

    formula: Formula
    where: tuple[Definition, ...]
    holds: tuple[Require, ...]


Trend = Literal[
    "rises", "falls", "rises between poles", "falls between poles", "constant", "turns", "unknown"
]
"""``between poles``: on each side of the values at which a result is infinite, not across them."""


@frozen
class Result:
    """One ``find`` (or ``let``), solved.

    ``formula`` is the whole result; for a load found as a linear form (``find P``)
    ``coefficients`` gives the factor of every other load and ``formula`` their sum.
    ``target`` is None for a let. ``proportional`` maps a parameter to the power in
    which the result is proportional to it; ``swaps`` are pairs that may be exchanged;
    ``trends`` say how it moves over each parameter's range (by a proof of the sign of
    the derivative, never by sampling); ``derivatives`` are the partial ones.
    ``guards`` are conditions without which the formula has no meaning. ``case`` is what is
    printed instead of a formula that takes its signs from the pose; ``holds`` are the
    conditions of a result that is such a case. ``locking`` tells of a ratio with friction
    where nothing moves, ``courses`` of an efficiency what it runs through. Names of ``where``
    that are ``inside`` a system are its many coefficients, of which people read the structure
    only. At the default pose it has the value ``default``, if any; it is ``undetermined`` where
    it is 0/0 there.
    """

    name: str
    target: Target | None
    dimension: Dimension
    formula: Formula
    where: tuple[Definition, ...] = ()
    coefficients: Mapping[str, Formula] | None = None
    zeros: tuple[Vanishing, ...] = ()
    poles: tuple[Vanishing, ...] = ()
    proportional: Mapping[str, int] | None = None
    independent: tuple[str, ...] = ()
    swaps: tuple[tuple[str, str], ...] = ()
    trends: Mapping[str, Trend] | None = None
    derivatives: Mapping[str, Formula] | None = None
    default: float | None = None
    guards: tuple[Require, ...] = ()
    case: Case | None = None
    holds: tuple[Require, ...] = ()
    locking: Locking | None = None
    courses: tuple[Course, ...] = ()
    inside: frozenset[str] = frozenset()
    undetermined: bool = False

    def printed(self) -> "Result":
        """Return the case that is printed, where the formula takes its signs from the pose."""
        if self.case is None:
            return self
        formula, where, holds = self.case.formula, self.case.where, self.case.holds
        return replace(self, formula=formula, where=where, holds=holds, case=None)
