"""What figure equal sides make of a loop: its directions follow by that, and by no law."""

from collections.abc import Collection, Iterator
from itertools import combinations

from ...algebra.angle import HALF_TURN, Angle, principal
from ...algebra.from_formula import to_angle
from ...algebra.product import Product
from ...base.frozen import replace
from ...base.named import NamedTuple
from ...formula.walk import symbols
from ...model.mechanism import Arrow
from ...pose.pose import Pose
from ...pose.tolerances import SAME_PLACE
from ..steps import PositionStep

Corners = tuple[str, ...]
"""The points of a triangle, its apex in the middle, or of a quadrilateral, one after another."""

TRIANGLE = 3
"""How many points a triangle has."""


class _Side(NamedTuple):
    """A vector of one length between two points."""

    tail: str
    head: str
    length: Product
    angle: Angle

    @property
    def ends(self) -> frozenset[str]:
        """Return both points."""
        return frozenset((self.tail, self.head))


def with_figure(step: PositionStep, found: Collection[frozenset[str]], pose: Pose) -> PositionStep:
    """Return the step of a loop of equal lengths as that of the figure that these make.

    That is an isosceles triangle, a parallelogram or a rhombus; it stays as it is where none of
    these is seen. One through other points than the loop has all vectors that are ``found``, given
    by their ends, for its sides.
    """
    sides = [*_sides(pose)]
    if len(step.points) == TRIANGLE:
        apex = next(_isosceles([side for side in sides if side.ends <= {*step.points}]), None)
        return replace(step, kind="isosceles", points=_as_given(apex, pose)) if apex else step
    figures = [*_parallelograms(sides)]
    own = [corners for corners in figures if {*corners} == {*step.points}]
    others = [corners for corners in figures if found and {*found} <= {*_edges(corners)}]
    if not own + others:
        return step
    corners = (own + others)[0]
    around = [side for side in sides if side.ends in _edges(corners)]
    is_rhombus = any(_isosceles(around))
    return replace(step, kind="rhombus" if is_rhombus else "parallelogram", points=corners)


def _sides(pose: Pose) -> Iterator[_Side]:
    """Yield the vectors that are one arm, with their directions by the angles that these are."""
    known: dict[str, Angle] = {}
    for definition in pose.definitions:
        if angle := to_angle(definition.formula):
            known[definition.name] = angle.put(known)
    for (tail, head), vector in pose.vectors.items():
        if tail and len(vector) == 1:
            yield _Side(tail, head, vector[0].length, vector[0].angle.put(known))


def _isosceles(sides: Collection[_Side]) -> Iterator[Corners]:
    """Yield the ends of each pair of equally long sides, their common point in the middle."""
    for one, other in combinations(sides, 2):
        if len(apex := one.ends & other.ends) == 1 and _is_as_long(one, other):
            first, last = sorted(one.ends ^ other.ends)
            yield first, *apex, last


def _as_given(corners: Corners, pose: Pose) -> Corners:
    """Return a triangle the way round in which its first side is written in the description."""
    arrows = [entry for entry in pose.mechanism.geometry if isinstance(entry, Arrow)]
    is_written = any((arrow.tail, arrow.head) == corners[:2] for arrow in arrows)
    return corners if is_written else corners[::-1]


def _parallelograms(sides: Collection[_Side]) -> Iterator[Corners]:
    """Yield the corners of each parallelogram two sides of which are parallel and equally long."""
    for one, other in combinations(sides, 2):
        if one.ends & other.ends or not _is_as_long(one, other):
            continue
        turn = principal(one.angle - other.angle)
        if turn == Angle():
            yield one.tail, one.head, other.head, other.tail
        elif turn == principal(HALF_TURN):
            yield one.tail, one.head, other.tail, other.head


def _edges(corners: Corners) -> list[frozenset[str]]:
    return [frozenset(ends) for ends in zip(corners, (*corners[1:], corners[0]), strict=True)]


def _is_as_long(one: _Side, other: _Side) -> bool:
    """Return whether two lengths are one and the same, or numbers that are equal."""
    if one.length == other.length:
        return True
    if symbols(one.length.formula(), other.length.formula()):
        return False
    sizes = [abs(side.length.evaluate({})) for side in (one, other)]
    return max(sizes) - min(sizes) <= SAME_PLACE * max(sizes)
