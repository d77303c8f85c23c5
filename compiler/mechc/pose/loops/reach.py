"""Where in the stroke a mechanism can be assembled: stretches of the driving coordinate.

A stretch ends where the margin of a loop vanishes. Where the drive turns one side of a
triangle, or the arm of a rod on a guide, that is ``acos`` or ``asin`` of lengths; elsewhere it
is the zero of the margin, halved to the last bits.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise

from ...algebra.angle import Angle
from ...algebra.factors import Factor, Trig
from ...algebra.product import Product, Sum
from ...algebra.sums import add
from ...base.named import NamedTuple
from ...diagnostics import open_loops as messages
from ...formula.evaluate import evaluate
from ...formula.numeric.roots import roots
from ...formula.to_text import text
from ...formula.tree import Call, Formula, Number, negative, total
from ...formula.walk import constants, symbols, walk
from ...model.values import following
from ...units import ANGLE, Dimension
from ..pose import Limit
from .dyads import Closure
from .rated import moved_by
from .state import LoopState

STROKE_PLACES = 720
"""Places along the stroke that are tried: every half degree of a full turn."""

LONGEST_LIMIT = 80
"""A limit of more characters than this is given as a number only."""


class PossibleEnd(NamedTuple):
    """A value at which a stretch may end, and its formula, '' where there is none."""

    x: float
    exact: str = ""


def reach_of(
    state: LoopState, closure: Closure, limit: Limit | None
) -> "list[messages.AssemblyRange]":
    """Return the stretches of the drive in which a group closes, empty without a drive."""
    drive = state.mechanism.drive
    if drive is None:
        return []
    parameter = state.mechanism.parameter(drive.parameter)
    low, high = limits_of_drive(state, parameter.dimension)
    reach = _Reach(state, closure, drive.parameter)
    limits = [*state.limits, *([limit] if limit else [])]
    ends = reach.ends([m for one in limits for m in one.margins], low, high)
    found: list[messages.AssemblyRange] = []
    for start, end in pairwise(ends):
        if not reach.closes((start.x + end.x) / 2):
            continue
        if found and found[-1].high == start.x:
            start = PossibleEnd(found[-1].low, found[-1].low_exact)
            found.pop()
        found.append(
            messages.AssemblyRange(start.x, end.x, parameter.dimension, start.exact, end.exact)
        )
    return found


def limits_of_drive(state: LoopState, dimension: Dimension) -> tuple[float, float]:
    """Return the ends of the stroke, or of what the drive may be where none is given."""
    drive = state.mechanism.drive
    assert drive is not None
    if drive.low is not None and drive.high is not None:
        ends = evaluate(drive.low, state.base), evaluate(drive.high, state.base)
        return min(ends), max(ends)
    if dimension == ANGLE:
        return -math.pi, math.pi
    return 0.0, 2 * state.base[drive.parameter]


class _Reach:
    """The loops closed so far and one more, along the drive."""

    def __init__(self, state: LoopState, closure: Closure, drive: str) -> None:
        definitions = (*state.definitions, *closure.definitions)
        self._chain = following(state.mechanism, definitions)
        self._given = {n: v for n, v in state.base.items() if n not in self._chain.names}
        self._drive = drive
        self._moving = moved_by(drive, definitions)

    def _values(self, x: float) -> dict[str, float]:
        return self._chain.complete({**self._given, self._drive: x})

    def closes(self, x: float) -> bool:
        """Return whether everything has a value."""
        return all(map(math.isfinite, self._values(x).values()))

    def ends(self, margins: Iterable[Product], low: float, high: float) -> list[PossibleEnd]:
        """Return ``low``, where a margin vanishes, and ``high``, in ascending order.

        All are values of the drive in SI, rad or m.
        """
        inner = [e for m in margins for e in self._zeros(m, low, high) if low < e.x < high]
        return [PossibleEnd(low), *sorted(inner), PossibleEnd(high)]

    def _zeros(self, margin: Product, low: float, high: float) -> Iterator[PossibleEnd]:
        """Yield where a margin is zero along the drive, in closed form if it has one."""
        known = self._values(low)
        forms = _closed_forms(margin, self._drive, self._moving)
        exact = [(i, c) for i, c in forms if symbols(total([i, c.formula()])) <= known.keys()]
        for inverse, constant in exact:
            x = evaluate(total([inverse, constant.formula()]), known)
            for turn in _turns(x, low, high):
                whole = total([inverse, (constant + Angle.constant(360 * turn)).formula()])
                yield PossibleEnd(x + turn * 2 * math.pi, _shown(whole))
        if not exact:
            grid = [low + (high - low) * i / STROKE_PLACES for i in range(STROKE_PLACES + 1)]
            yield from (PossibleEnd(root.x) for root in roots(self._function(margin), grid))

    def _function(self, margin: Product) -> Callable[[float], float]:
        def at(x: float) -> float:
            try:
                return margin.evaluate(self._values(x))
            except (KeyError, ZeroDivisionError):
                return math.nan

        return at


def _turns(x: float, low: float, high: float) -> range:
    """Return the full turns by which an angle comes between two others."""
    if not math.isfinite(x):
        return range(0)
    first = math.ceil((low - x) / (2 * math.pi))
    return range(first, math.floor((high - x) / (2 * math.pi)) + 1)


def _closed_forms(
    margin: Product, drive: str, moving: frozenset[str]
) -> Iterator[tuple[Formula, Angle]]:
    """Yield the drive where a margin ``A + B·cos(φ + γ)`` vanishes: an arc cosine and the rest."""
    found = _moving_term(margin, moving)
    if found is None:
        return
    trig, term, others = found
    sense = dict(trig.angle.terms).get(drive, 0)
    rest = trig.angle - Angle(((drive, sense),))
    if abs(sense) != 1 or term.factors[trig] != 1 or not moving.isdisjoint(rest.names):
        return
    ratio = -(others * Product.of(trig) / term)
    inverse = Call("acos" if trig.function == "cos" else "asin", (ratio.formula(),))
    half = Angle.constant(0 if trig.function == "cos" else 180)
    for sign, start in ((1, Angle()), (-1, half)):
        turned = inverse if sign * sense > 0 else negative(inverse)
        yield turned, (start - rest) * sense


def _moving_term(margin: Product, moving: frozenset[str]) -> tuple[Trig, Product, Product] | None:
    """Return the sine or cosine that alone moves in a margin, its term, and the others' sum."""

    def moves(part: Factor | Product) -> bool:
        return not moving.isdisjoint(symbols(part.formula()))

    varying = list(filter(moves, margin.factors))
    if len(varying) != 1 or not isinstance(varying[0], Sum):
        return None
    terms = varying[0].terms
    moved = list(filter(moves, terms))
    trigs = [f for t in moved for f in t.factors if moves(f)]
    if len(moved) != 1 or len(trigs) != 1 or not isinstance(trigs[0], Trig):
        return None
    return trigs[0], moved[0], add(t for t in terms if t is not moved[0])


def _shown(formula: Formula) -> str:
    """Return a limit as a formula in the user's lengths, '' where it has figures in it."""
    numbers = [n.value for n in walk(formula) if isinstance(n, Number)]
    if (
        not symbols(formula)
        or constants([formula])
        or any(max(abs(n.numerator), n.denominator) > 9 for n in numbers)
    ):
        return ""
    shown = text(formula)
    return shown if len(shown) <= LONGEST_LIMIT else ""
