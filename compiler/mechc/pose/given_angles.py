"""Angles as the description gives them: of which two lines, and with which constant.

The algebra knows one form of a sine, sin(theta + 60°) = cos(theta − 30°), whatever is drawn. What
is written for a reader has the angle that two of the given lines make.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache, partial

from ..algebra.angle import QUARTER, Angle, Rational
from ..algebra.from_formula import to_angle
from ..base.frozen import replace
from ..formula.rewriting import Quarter, as_cofunction, plus_first, rewritten
from ..formula.tree import Formula, Implicit, System
from ..model.mechanism import Arrow, Turn
from .pose import Pose, PoseDefinition, Vector, reverse

RIGHT = 90
"""The degrees of a right angle."""


class GivenLines:
    """The lines of a pose, the x axis among them, and the directions of vectors as written.

    ``constants`` are the angles that are numbers; without them those between ``arrows`` are meant,
    and those that these have with the x axis.
    """

    def __init__(
        self,
        lines: Iterable[Angle],
        arrows: Iterable[Angle],
        constants: "Constants | None" = None,
        written: Iterable[Angle] = (),
    ):
        """Take the lines, vectors as written, constants, and angles that have ``written`` ones."""
        lines, arrows = [*lines], [*arrows]
        self._written = {_size(a.degrees, 180) for a in written if a.degrees % RIGHT}
        self._lines, self._arrows = _Directions(lines, 180), _Directions(arrows, 360)
        self._constants = constants or Constants(lines, arrows)

    def quarter(self, argument: Formula) -> int:
        """Return by how many degrees an angle is to be turned to be one between two lines.

        0 where it is one, or becomes none by a quarter turn.
        """
        angle = to_angle(argument)
        if angle is None or not angle.degrees % 90:
            return 0
        if not angle.terms:
            return self._constants.quarter(angle.degrees)
        if _size(angle.degrees, 180) in self._written:
            return 0
        if self._lines.are_at(angle):
            return self._as_written(angle)
        near = [angle + Angle.constant(turn) for turn in (90, -90)]
        chosen = min(filter(self._lines.are_at, near), key=self._rank, default=angle)
        return int(chosen.degrees - angle.degrees)

    def _as_written(self, angle: Angle) -> int:
        """Return by how much an angle between lines is turned to have a constant as it is given.

        What has a place at 90° by its guide makes 70° with an arm at 20°: 20° is read.
        """
        turns = (turn for turn in (-90, 90) if _size(angle.degrees + turn, 180) in self._written)
        return min(turns, key=partial(_turned_size, angle), default=0)

    def _rank(self, angle: Angle) -> tuple[bool, float]:
        """Return a smaller value for angles between arrows as they are written, and small ones."""
        return not self._arrows.are_at(angle), abs(float(angle.degrees))


class _Directions:
    """Directions that differ, but for multiples of a turn, indexed once."""

    def __init__(self, angles: Iterable[Angle], turn: int):
        self._turn = turn
        self._known = frozenset(_within(angle, turn) for angle in angles)

    def are_at(self, angle: Angle) -> bool:
        """Return whether two of them are at an angle, from either to the other."""
        return any(_within(known + angle, self._turn) in self._known for known in self._known)


class Constants:
    """The angles of a drawing that are numbers, those first that its text has as they are.

    A direction, ``AB = @ 47 deg`` or ``along 47 deg``, is the angle with an axis, and means one
    where something lies along an axis; then come angles between two links, between any two lines,
    and what an obtuse direction has with the nearest axis. Lines along an axis make no angles of
    their own: what another line has with the y axis is 90° less what it is given by.
    """

    def __init__(
        self,
        arms: Iterable[Angle],
        arrows: Iterable[Angle],
        others: Iterable[Angle] = (),
        corners: Iterable[Angle] = (),
    ) -> None:
        """Take the directions of links, as they are written too, of guides and loads, angles."""
        arms, arrows, others = [*arms], [*arrows], [*others]
        directions = [angle for angle in (*arrows, *others) if not angle.terms]
        has_axis = any(not line.degrees % RIGHT for line in (*arms, *directions) if not line.terms)
        sizes = {_size(angle.degrees, 360) for angle in directions if has_axis or not others}
        given = {size for size in sizes if size < RIGHT}
        given |= {_size(corner.degrees, 360) for corner in corners if not corner.terms}
        beyond = {_size(size, RIGHT) for size in sizes if size > RIGHT}
        as_drawn = _Directions(_tilted(arrows), 360)
        tilted, whole = (_Directions(_tilted(found), 180) for found in (arms, (*arms, *others)))
        self._kinds: Sequence[Callable[[Rational], bool]] = (
            lambda degrees: _size(degrees, 360) in given,
            lambda degrees: as_drawn.are_at(Angle.constant(degrees)),
            lambda degrees: tilted.are_at(Angle.constant(degrees)),
            lambda degrees: whole.are_at(Angle.constant(degrees)),
            lambda degrees: _size(degrees, 180) in beyond,
        )

    def quarter(self, degrees: Rational) -> int:
        """Return by how many degrees an angle is to be turned to be one that is given."""
        return min((0, 90, -90), key=lambda turn: self._key(degrees, turn))

    def _key(self, degrees: Rational, turn: int) -> tuple[int, bool, float]:
        """Return a smaller value for what is given more plainly, then as it is, then for small."""
        return self._rank(degrees + turn), turn != 0, abs(float(degrees + turn))

    def _rank(self, degrees: Rational) -> int:
        """Return a smaller number for an angle that is given in a plainer way."""
        kinds = (rank for rank, is_of in enumerate(self._kinds) if is_of(degrees))
        return next(kinds, len(self._kinds))


def _tilted(angles: Iterable[Angle]) -> Iterator[Angle]:
    """Yield the directions that lie along no axis."""
    return (angle for angle in angles if angle.terms or angle.degrees % 90)


def _size(degrees: Rational, turn: int) -> Rational:
    """Return the size of an angle that is the same in either sense, and after a turn.

    >>> [_size(degrees, 180) for degrees in (47, -47, 133, 313)], _size(313, 360)
    ([47, 47, 47, 47], 47)
    """
    within: Rational = degrees % turn
    return min(within, turn - within)


def _turned_size(angle: Angle, turn: int) -> float:
    return abs(float(angle.degrees + turn))


def _within(angle: Angle, turn: int) -> Angle:
    return Angle(angle.terms, angle.degrees % turn)


def given_lines(pose: Pose) -> Quarter | None:
    """Return the quarter turns that bring angles to those between given lines, None without any.

    Lines across other ones, or along the y axis, are none: an angle from there is 90° less one
    that is given.
    """
    between = (vector for ends, vector in pose.vectors.items() if all(ends))
    arms = {arm.angle for vector in between for arm in vector}
    others = [*pose.guides.values(), *pose.lines.values()]
    lines = {Angle(), *arms}
    known = {_within(line, 180) for line in lines}
    for angle in others:
        if _within(angle + QUARTER, 180) not in known:
            lines.add(angle)
            known.add(_within(angle, 180))
    lines = {angle for angle in lines if angle.terms or angle.degrees % 180 != 90}
    if not any(angle.degrees % 90 for angle in lines):
        return None
    arrows = {arm.angle for vector in _as_written(pose) for arm in vector}
    corners = [*_corners(pose)]
    constants = Constants(arms, arrows, others, corners)
    return cache(GivenLines(lines, {*arrows, Angle()}, constants, corners).quarter)


def _corners(pose: Pose) -> Iterator[Angle]:
    """Yield the angles that are given between two arms of a link."""
    turns = (item for item in pose.mechanism.geometry if isinstance(item, Turn))
    found = (to_angle(turn.angle) for turn in turns)
    yield from (angle for angle in found if angle is not None)


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
            return as_cofunction(formula, quarter)
        system = formula.system
        if system not in systems:
            equations = tuple(plus_first(rewritten(e, turned)) for e in system.equations)
            systems[system] = replace(system, equations=equations)
        return replace(formula, system=systems[system])

    def written(definitions: Iterable[PoseDefinition]) -> tuple[PoseDefinition, ...]:
        return tuple(
            PoseDefinition(n, plus_first(rewritten(formula, turned))) for n, formula in definitions
        )

    return replace(
        pose,
        definitions=written(pose.definitions),
        closing=written(pose.closing),
        put_in=written(pose.put_in),
    )
