"""Singular poses: where a ratio of loads is zero or infinite, and what stands still there."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Literal

from ..formula.roots import Function, Root, roots
from ..formula.tree import Formula, degrees, number, product, total
from ..formula.walk import evaluate, symbols
from ..model.result import Result, Vanishing
from .along import Along
from .stroke import Branch, Kind, Singular, Stretch

Value = Literal["0", "infinite"]

SAME = 1e-9
"""A zero and a pole closer than this part of the stroke are one place: k is undetermined."""

BESIDE = 1e-6
"""Zeros and poles closer to a branch point than this part of the stroke lie on it.

Angles of a triangle that is nearly flat have half the digits.
"""

STEP = 1e-6
"""The part of a stretch from its end at which is seen what a factor does there."""


def singular_poses(
    result: Result, drive: str, along: Along, stretch: Stretch, places: Sequence[float]
) -> Iterator[Singular]:
    """Yield the singular poses of a ratio of loads on a stretch, by zeros, then by poles."""
    conditions: list[tuple[Vanishing, Value]] = [(v, "0") for v in result.zeros]
    conditions += [(v, "infinite") for v in result.poles]
    for vanishing, value in conditions:
        for root in places_of(result, vanishing, along, stretch, places):
            exact = _exact(vanishing, drive, along, root)
            yield Singular(result.name, value, vanishing.kind, *root, exact)


def places_of(
    result: Result, vanishing: Vanishing, along: Along, stretch: Stretch, places: Sequence[float]
) -> Iterator[Root]:
    """Yield where on a stretch a result's factor vanishes."""

    def factor(place: float) -> float:
        return along.of(vanishing.factor, result, place)

    yield from roots(factor, places)
    yield from _at_the_ends(factor, stretch)


def _at_the_ends(factor: Function, stretch: Stretch) -> Iterator[Root]:
    """Yield the ends beyond which nothing can be assembled, where the factor goes to zero.

    It does so as a square root: it halves where the distance from the end is quartered.
    """
    step = STEP * (stretch.high - stretch.low)
    ends = ((stretch.low, stretch.before, step), (stretch.high, stretch.after, -step))
    for end, why, inwards in ends:
        if why and abs(factor(end + inwards)) < 0.7 * abs(factor(end + 4 * inwards)):
            yield Root(end, math.ulp(end))


def _exact(vanishing: Vanishing, drive: str, along: Along, root: Root) -> Formula | None:
    """Return the drive as a constant formula, turned by half turns to the place found."""
    if vanishing.at is None or vanishing.at[0] != drive:
        return None
    formula = vanishing.at[1]
    if symbols(formula) - along.defaults.keys():
        return None
    value = evaluate(formula, along.values(root.place))
    turns = round((root.place - value) / math.pi)
    shifted = total([formula, product([(number(turns), 1), (degrees(180), 1)])])
    return shifted if math.isclose(value + turns * math.pi, root.place, abs_tol=1e-9) else None


def told_apart(
    found: Iterable[Singular], branches: Sequence[Branch], range_: float
) -> tuple[Singular, ...]:
    """Return singular poses in their order, those left out that only a branch point makes.

    A zero and a pole at one place that is no branch point leave the result undetermined.
    """
    beside = BESIDE * range_
    kept: list[Singular] = []
    on_a_branch: dict[tuple[str, Branch], list[Singular]] = {}
    for one in sorted(found, key=lambda s: s.drive):
        branch = next((b for b in branches if abs(one.drive - b.drive) <= beside), None)
        if branch is None:
            kept.append(one)
        else:
            on_a_branch.setdefault((one.result, branch), []).append(one)
    for (_, branch), ones in on_a_branch.items():
        if len({one.value for one in ones}) == 1:
            kept.append(ones[0]._replace(drive=branch.drive, bracket=branch.bracket))
    return tuple(_merged(sorted(kept, key=lambda s: s.drive), SAME * range_))


def _merged(found: Sequence[Singular], width: float) -> Iterator[Singular]:
    """Yield singular poses, a zero and a pole at one place as a branch point."""
    kept: list[Singular] = []
    for one in found:
        last = kept[-1] if kept else None
        if last and last.result == one.result and one.drive - last.drive <= width:
            if last.value != one.value:
                kind: Kind = "branch point"
                kept[-1] = last._replace(value="undetermined", kind=kind)
            continue
        kept.append(one)
    yield from kept
