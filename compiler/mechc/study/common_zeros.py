"""Which factors of a ratio vanish in one pose with others, along what moves.

Sines of angles that loops find may all be zero where the whole linkage lies on one line: each by
itself is a zero or a pole of the ratio, together they are none.
"""

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from functools import cached_property, partial
from itertools import pairwise, product

from ..algebra.factors import Trig
from ..algebra.product import Product
from ..formula.evaluate import evaluate
from ..formula.numeric import roots
from ..formula.tree import Call, Formula, is_call
from ..formula.walk import reached, symbols, walk
from ..model.mechanism import Mechanism
from ..model.values import Chain, Values, range_of
from ..pose.pose import Arm, Limit, Pose, evaluate_vector
from ..pose.tolerances import SAME_PLACE
from ..pose.vector_graph import mentioned
from .tolerances import SAME_RATIO, VANISHES_TOO
from .variables import last, moving_first, turns

SIGN_CELLS = 37
"""Cells in which changes of sign are looked for."""

BEYOND_RANGE = 0.01
"""The part of a range by which it is looked at beyond its ends, where factors may vanish."""

ANYWHERE = 1.0
"""An angle at which neither sine nor cosine is special, in radians."""


class CommonZeros:
    """The sines of a ratio that vanish with others, looked for when they are first asked for."""

    def __init__(
        self, value: Product, defined: Mapping[str, Formula], near: Values, mechanism: Mechanism
    ) -> None:
        """Take the ratio, what is ``defined`` in it, and the values given."""
        self._value, self._defined, self._mechanism = value, defined, mechanism
        self._given = {name: x for name, x in near.items() if name not in defined}

    def across(self, sine: Trig, side: int) -> frozenset[Trig]:
        """Return those on the other side of the line that a sine vanishes with.

        ``side`` is that of the sine, 1 above the line and -1 below it. It may be a part of a
        factor, as cos x is of sin 2x. Loops find angles in it, or in the other one.
        """
        if sine in self._value.factors:
            return frozenset().union(*(pair - {sine} for pair in self._pairs if sine in pair))
        factors = self._value.factors.items()
        others = [f for f, e in factors if isinstance(f, Trig) and e * side < 0]
        return frozenset().union(*self._common_zeros([sine, *others])) - {sine}

    @cached_property
    def _pairs(self) -> Set[frozenset[Trig]]:
        """Return the pairs on either side of the line that vanish together."""
        factors = self._value.factors
        found = [f for f in factors if isinstance(f, Trig)]
        on_both_sides = len({factors[f] > 0 for f in found}) > 1
        pairs = self._common_zeros(found) if on_both_sides else ()
        return frozenset(p for p in pairs if len({factors[f] > 0 for f in p}) > 1)

    def _common_zeros(self, sines: Sequence[Trig]) -> Set[frozenset[Trig]]:
        """Return the pairs of sines that pass zero at one value of the parameter that moves first.

        Sines of given angles alone are not looked at: their zeros are known from their formulas.
        """
        name = next((n for n in moving_first(self._mechanism) if n in self._given), "")
        ends = self._ends(name) if name else None
        if ends is None or len(sines) < 2 or all(map(self._is_given, sines)):
            return frozenset()
        formulas = [f.formula() for f in sines]
        pairs = pairs_of_common_zeros(formulas, self._defined, self._given, name, ends)
        return frozenset(frozenset((sines[i], sines[j])) for i, j in pairs)

    def _is_given(self, factor: Trig) -> bool:
        return factor.angle.names.isdisjoint(self._defined)

    def _ends(self, name: str) -> tuple[float, float] | None:
        """Return the range of a parameter, a whole turn of an angle without one."""
        here = self._given[name]
        turn = (here - math.pi, here + math.pi) if turns(name, self._mechanism) else None
        return range_of(name, self._mechanism) or turn


def pairs_of_common_zeros(
    factors: Sequence[Formula],
    defined: Mapping[str, Formula],
    given: Values,
    name: str,
    ends: tuple[float, float],
) -> Iterator[tuple[int, int]]:
    """Yield the places of two factors that pass zero at one value of a parameter.

    ``defined`` are the names in them, by those ``given`` and by one another.

    >>> from ..formula.tree import Call, Symbol, number, product
    >>> t, twice = Symbol("t"), product([(number(2), 1), (Symbol("t"), 1)])
    >>> sines = [Call("sin", (t,)), Call("sin", (Symbol("u"),)), Call("cos", (t,))]
    >>> list(pairs_of_common_zeros(sines, {"u": twice}, {}, "t", (-1.0, 2.0)))
    [(0, 1), (1, 2)]
    """
    own = {_place(i): factor for i, factor in enumerate(factors)}
    needed = reached(symbols(*factors), defined)
    chain = Chain({n: f for n, f in defined.items() if n in needed} | own)
    code = chain.completion(frozenset((*given, name)))

    def at(x: float) -> list[float]:
        found = code.complete({**given, name: x})
        return [found.get(place, 1.0) for place in own]

    def is_as_before(i: int, sense: float, x: float) -> bool:
        return at(x)[i] * sense > 0

    beyond = BEYOND_RANGE * (ends[1] - ends[0])
    rows = [(x, at(x)) for x in roots.spaced(ends[0] - beyond, ends[1] + beyond, SIGN_CELLS)]
    for (a, before), (b, after) in pairwise(rows):
        passing = [i for i, (u, v) in enumerate(zip(before, after, strict=True)) if u * v < 0]
        for i in passing if len(passing) > 1 else ():
            here = at(last(partial(is_as_before, i, before[i]), a, b))
            yield from ((i, j) for j in passing if j > i and abs(here[j]) < VANISHES_TOO)


def _place(number: int) -> str:
    """Return a name that no description has."""
    return f"={number}"


# ------------------------------------------------------------- where loops lie flat or fold


def flat_sides(pose: Pose, near: Values) -> Iterator[Set[str]]:
    """Yield the names in the angles of each four-bar that may lie flat."""
    for limit in pose.limits:
        if may_lie_flat(limit, near):
            points = set(limit.loop.split("-"))
            given = {name for arm in limit.side for name in arm.angle.names}
            solved = (s.names for s in pose.solved if points.issuperset(s.points))
            yield given.union(*solved)


def may_lie_flat(limit: Limit, near: Mapping[str, float]) -> bool:
    """Return whether the four sides of a loop may all lie on one line, for the values given.

    They do where the longest and the shortest are together as long as the others (Grashof).
    """
    turning: dict[object, list[Arm]] = {}
    for arm in limit.side:
        turning.setdefault(arm.angle.terms, []).append(arm)
    names = mentioned(limit.side).union(*(symbols(size.formula()) for size in limit.sizes))
    if limit.group != "triangle" or len(turning) != 2 or not names <= near.keys():
        return False
    sides = [math.hypot(*evaluate_vector(tuple(arms), near)) for arms in turning.values()]
    sides += [abs(size.evaluate(near)) for size in limit.sizes]
    first, *others = sides
    senses = product((1, -1), repeat=len(others))
    gaps = (first + sum(s * size for s, size in zip(each, others, strict=True)) for each in senses)
    return any(abs(gap) <= SAME_PLACE * sum(sides) for gap in gaps)


def is_fold(formula: Formula, near: Mapping[str, float]) -> bool:
    """Return whether an angle is the arcsine of a sine, or of a cosine, for the values given."""
    if not isinstance(formula, Call) or formula.function not in ("asin", "acos"):
        return False
    (argument,) = formula.arguments
    for turn in walk(argument):
        if is_call(turn, "sin", "cos"):
            values = {**near, **dict.fromkeys(symbols(turn), ANYWHERE)}
            if symbols(argument) <= values.keys():
                sizes = (abs(evaluate(f, values)) for f in (argument, turn))
                return math.isclose(*sizes, rel_tol=SAME_RATIO)
    return False


def is_between_sides(trig: Trig, names: Set[str]) -> bool:
    """Return whether a sine is that of an angle between the sides that some names belong to."""
    return trig.function == "sin" and trig.angle.names <= names and not trig.angle.degrees % 180
