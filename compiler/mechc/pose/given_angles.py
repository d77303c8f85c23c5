"""Angles as the description gives them: of which two lines, and with which constant.

The algebra knows one form of a sine, sin(theta + 60°) = cos(theta − 30°), whatever is drawn. What
is written for a reader has the angle that two of the given lines make.
"""

from collections.abc import Iterable, Iterator
from functools import cache

from ..algebra.angle import Angle
from ..algebra.from_formula import to_angle
from ..formula.facing import Quarter, led, quarter_turned, rewritten
from ..formula.tree import Formula, Implicit, System
from ..frozen import replace
from ..model.mechanism import Arrow, Turn
from .pose import Definition, Pose, Vector, reverse


class GivenLines:
    """The lines of a pose, the x axis among them, and the directions of vectors as written.

    Constant angles are those between vectors alone, which stay when the whole drawing is turned.
    """

    def __init__(self, lines: Iterable[Angle], arms: Iterable[Angle], arrows: Iterable[Angle]):
        self._lines, self._arms = (_Directions(found, 180) for found in (lines, arms))
        self._arrows = _Directions(arrows, 360)

    def quarter(self, argument: Formula) -> int:
        """Return by how many degrees an angle is to be turned to be one between two lines.

        0 where it is one, or becomes none by a quarter turn.
        """
        angle = to_angle(argument)
        if angle is None or not angle.degrees % 90 or self._are_at(angle):
            return 0
        near = [angle + Angle.constant(turn) for turn in (90, -90)]
        chosen = min(filter(self._are_at, near), key=self._rank, default=angle)
        return int(chosen.degrees - angle.degrees)

    def _rank(self, angle: Angle) -> tuple[bool, float]:
        """Return a smaller value for angles between arrows as they are written, and small ones."""
        return not self._arrows.are_at(angle), abs(float(angle.degrees))

    def _are_at(self, angle: Angle) -> bool:
        """Return whether two of the lines are at an angle."""
        return (self._lines if angle.terms else self._arms).are_at(angle)


class _Directions:
    """Directions that differ, but for multiples of a turn, indexed once."""

    def __init__(self, angles: Iterable[Angle], turn: int):
        self._turn = turn
        self._known = frozenset(_within(angle, turn) for angle in angles)

    def are_at(self, angle: Angle) -> bool:
        """Return whether two of them are at an angle, from either to the other."""
        return any(_within(known + angle, self._turn) in self._known for known in self._known)


def _within(angle: Angle, turn: int) -> Angle:
    return Angle(angle.terms, angle.degrees % turn)


def given_lines(pose: Pose) -> Quarter | None:
    """Return the quarter turns that bring angles to those between given lines, None without any.

    Lines across other ones, or along the y axis, are none: an angle from there is 90° less one
    that is given.
    """
    between = (vector for ends, vector in pose.vectors.items() if all(ends))
    arms = {arm.angle for vector in between for arm in vector}
    lines = {Angle(), *arms}
    known = {_within(line, 180) for line in lines}
    for angle in (*pose.guides.values(), *pose.lines.values()):
        if _within(angle + Angle.constant(90), 180) not in known:
            lines.add(angle)
            known.add(_within(angle, 180))
    lines = {angle for angle in lines if angle.terms or angle.degrees % 180 != 90}
    if not any(angle.degrees % 90 for angle in lines):
        return None
    arrows = {arm.angle for vector in _as_written(pose) for arm in vector}
    return cache(GivenLines(lines, arms, {*arrows, Angle()}).quarter)


def _as_written(pose: Pose) -> Iterator[Vector]:
    """Yield vectors from where their directions are written, the arms of turns from its vertex."""
    for item in pose.mechanism.geometry:
        ends = [(item.tail, item.head)] if isinstance(item, Arrow) else []
        if isinstance(item, Turn):
            ends = [(item.vertex, item.first), (item.vertex, item.second)]
        for tail, head in ends:
            known = pose.vectors.get((tail, head))
            yield reverse(pose.vectors.get((head, tail), ())) if known is None else known


def in_given_angles(pose: Pose) -> Pose:
    """Return a pose whose definitions are written by the angles between given lines."""
    quarter = given_lines(pose) if pose.closing else None
    if quarter is None:
        return pose
    systems: dict[System, System] = {}

    def turned(formula: Formula) -> Formula | None:
        if not isinstance(formula, Implicit):
            return quarter_turned(formula, quarter)
        system = formula.system
        if system not in systems:
            equations = tuple(led(rewritten(e, turned)) for e in system.equations)
            systems[system] = replace(system, equations=equations)
        return replace(formula, system=systems[system])

    def written(definitions: Iterable[Definition]) -> tuple[Definition, ...]:
        return tuple(Definition(n, led(rewritten(formula, turned))) for n, formula in definitions)

    return replace(
        pose,
        definitions=written(pose.definitions),
        closing=written(pose.closing),
        put_in=written(pose.put_in),
    )
