"""Coordinates of points, directions of links, and how both change with the drive."""

from collections import deque
from collections.abc import Collection, Iterator, Sequence
from typing import Literal

from ..algebra.trigonometry import cosine, sine
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..formula.names import split_points
from ..formula.tree import ONE, ZERO, Call, Formula, Symbol, total
from ..formula.walk import constants
from ..model.mechanism import Link, Parameter
from ..units import ACCELERATION, ANGLE, FREQUENCY, LENGTH, VELOCITY, Dimension
from .pose import Pose, PoseDefinition, Vector, gathered, measured_by, reverse
from .rates import NameRates, Titles, first_rates, second_rates, titled
from .vector_graph import mentioned
from .vectors import start_of

MotionKind = Literal["place", "slope", "velocity", "acceleration"]


class MotionQuantity(NamedTuple):
    """One number of a motion: ``x_C``, ``phi_BC``, ``dx_C_dphi``, for people ``dx_C/dphi``.

    ``of`` is the point, or the link, whose it is, ``axis`` x or y, of a link empty.
    """

    name: str
    shown: str
    kind: MotionKind
    of: str
    axis: str
    dimension: Dimension
    formula: Formula

    @property
    def is_named(self) -> bool:
        """Return whether it is what the pose, or the description, calls by its name."""
        return isinstance(self.formula, Symbol) and self.formula.name == self.name


@frozen
class Motion:
    """Coordinates of points, directions of links, and how they change with the drive.

    Without a speed of the drive these are the slopes along it, with one velocities and
    accelerations. ``definitions`` are what they rest on besides the definitions of the pose.
    """

    quantities: tuple[MotionQuantity, ...]
    definitions: tuple[PoseDefinition, ...]


def motion(pose: Pose, lagging: Collection[str] = ()) -> Motion | None:
    """Return the motion along the drive; None where there is no drive, or nothing has a place.

    Nothing is said of links and points that are ``lagging``: they do not follow the drive as
    they are given.
    """
    drive = pose.mechanism.drive
    if drive is None or drive.reshapes:
        return None
    places = (*_points(pose, lagging), *_links(pose, lagging))
    titles = Titles("t" if drive.speed else drive.parameter, _taken(pose))
    first = first_rates(pose, drive.speed or ONE, titles, [p.formula for p in places])
    if drive.speed is None:
        parameter = pose.mechanism.parameter(drive.parameter)
        slopes = (_slope(place, first, parameter) for place in places)
        quantities = (*places, *(s for s in slopes if s))
        return _whole(pose, quantities, first)
    velocities = _rates(places, first, "velocity")
    second = second_rates(first, titles)
    accelerations = _rates(velocities, second, "acceleration")
    return _whole(pose, (*places, *velocities, *accelerations), first, second)


def _taken(pose: Pose) -> Iterator[str]:
    yield from (name for name, _ in (*pose.closing, *pose.definitions))
    yield from (parameter.name for parameter in pose.mechanism.parameters)


def _whole(pose: Pose, quantities: Sequence[MotionQuantity], *rates: NameRates) -> Motion | None:
    """Return a motion, its names distinct from those of the pose; None without quantities."""
    numbers = {c.name for c in constants(q.formula for q in quantities)}
    taken, kept = {*_taken(pose), *numbers}, {name for name, _ in pose.definitions}
    closing = [d for d in pose.closing if d.name not in kept]
    named = [d for found in rates for d in found.named.values()]
    apart: list[MotionQuantity] = []
    for quantity in quantities:
        while quantity.name in taken and not quantity.is_named:
            quantity = quantity._replace(name=f"{quantity.name}_")
        apart.append(quantity)
    return Motion(tuple(apart), (*closing, *named)) if apart else None


def _points(pose: Pose, lagging: Collection[str]) -> Iterator[MotionQuantity]:
    """Yield the coordinates of every point that has a place."""
    lost = [link for link in pose.mechanism.links if link.name in lagging]
    for point, vector in paths(pose, lost).items():
        if point in lagging:
            continue
        for axis, formula in zip("xy", _components(vector), strict=True):
            yield _named(f"{axis}_{point}", "place", point, axis, LENGTH, formula)


def _links(pose: Pose, lagging: Collection[str]) -> Iterator[MotionQuantity]:
    """Yield the direction of every link: of its second point from its first."""
    for link in (link for link in pose.mechanism.rigid_links if link.name not in lagging):
        first, second, *_ = link.points
        vector = pose.vector(link.name, first, second)
        if vector:
            name = f"phi_{first}{second}"
            yield _named(name, "place", link.name, "", ANGLE, _direction(vector))


def _named(
    shown: str, kind: MotionKind, of: str, axis: str, dimension: Dimension, formula: Formula
) -> MotionQuantity:
    return MotionQuantity(shown.replace("'", "p"), shown, kind, of, axis, dimension, formula)


def _components(vector: Vector) -> tuple[Formula, Formula]:
    x, y = (total((a.length * part(a.angle)).formula() for a in vector) for part in (cosine, sine))
    return x, y


def _direction(vector: Vector) -> Formula:
    """Return the angle of a vector, which runs on over full turns where it is a single arm."""
    if len(vector) == 1:
        return vector[0].angle.formula()
    x, y = _components(vector)
    return Call("atan2", (y, x))


def _slope(place: MotionQuantity, slopes: NameRates, drive: Parameter) -> MotionQuantity | None:
    """Return the slope of a coordinate or a direction along the drive, None where it has none."""
    slope = slopes.of(place.formula)
    if slope is None or slope == ZERO:
        return None
    return place._replace(
        name=titled(place.name, drive.name),
        shown=f"d{place.shown}/d{drive.name}",
        kind="slope",
        dimension=place.dimension.over(drive.dimension),
        formula=slope,
    )


def _rates(
    quantities: Sequence[MotionQuantity], rates: NameRates, kind: MotionKind
) -> tuple[MotionQuantity, ...]:
    """Return the velocities of places, or the accelerations of what has a velocity."""
    linear, angular = ("V", "omega") if kind == "velocity" else ("a", "epsilon")
    made: list[MotionQuantity] = []
    for of in quantities:
        rate = rates.of(of.formula)
        if rate is not None and (rate != ZERO or kind == "acceleration"):
            shown = f"{linear}_{of.of}_{of.axis}" if of.axis else f"{angular}_{of.of}"
            dimension = _dimension(kind, of.axis)
            made.append(_named(shown, kind, of.of, of.axis, dimension, rate))
    return tuple(made)


def _dimension(kind: MotionKind, axis: str) -> Dimension:
    if kind == "velocity":
        return VELOCITY if axis else FREQUENCY
    return ACCELERATION if axis else FREQUENCY.scaled(2)


def paths(pose: Pose, lagging: Collection[Link] = ()) -> dict[str, Vector]:
    """Return the vector from the origin to every point that the description gives a place.

    Without a place of any pivot the origin is at the first pivot. A point is left out to which
    only vectors of open length lead, and one that stands for the place of a guide.
    Links that are ``lagging`` lead nowhere: what is said of their directions holds at one pose.
    """
    ways: dict[str, dict[str, Vector]] = {}
    for tail, head, vector in _given(pose, lagging):
        ways.setdefault(tail, {}).setdefault(head, vector)
        ways.setdefault(head, {}).setdefault(tail, reverse(vector))
    start = start_of(pose.mechanism, ways)
    found: dict[str, Vector] = {start: ()}
    waiting = deque([start])
    while waiting:
        here = waiting.popleft()
        for there, vector in ways.get(here, {}).items():
            if there not in found:
                found[there] = gathered((*found[here], *vector))
                waiting.append(there)
    return {point: vector for point, vector in found.items() if split_points(point)}


def _given(pose: Pose, lagging: Collection[Link]) -> Iterator[tuple[str, str, Vector]]:
    """Yield the vectors whose length and direction are known, by their points."""
    known = {name: value for name, value in pose.placeholders.items() if value is not None}
    closed = {name for name, _ in (*pose.closing, *pose.definitions)}
    values = closed | {parameter.name for parameter in pose.mechanism.parameters} | known.keys()
    lost = [set(link.points) for link in lagging]
    for tail, head, vector in _vectors(pose):
        if any({tail, head} <= points for points in lost):
            continue
        if mentioned(vector) <= values:
            yield tail, head, measured_by(vector, known)


def _vectors(pose: Pose) -> Iterator[tuple[str, str, Vector]]:
    for (tail, head), vector in pose.vectors.items():
        yield tail, head, vector
    for frame in pose.frames.values():
        first, *others = frame
        yield from ((first, point, frame[point]) for point in others if frame[point])
    for contact in pose.contacts:
        if contact.reach:
            yield contact.tail, contact.point, contact.reach
