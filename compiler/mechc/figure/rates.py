"""A plan of velocities in numbers: how every point and link moves per unit of one drive."""

from collections.abc import Iterator, Mapping

from ..kinematics.graph import Velocity
from ..kinematics.plan import Plan, Speeds
from ..pose.places import NOWHERE, Plane, direction
from .figure import Contact, Figure, Link, Slot
from .velocities import Sliding, Velocities

Values = Mapping[str, float]


def rates(plan: Plan, figure: Figure, given: Values, drive: int) -> Velocities:
    """Return velocities per unit of a drive; KeyError where something has no value there.

    ZeroDivisionError where the drive can't move the mechanism.
    """
    values = dict(given)
    for name, value in plan.bindings:
        values[name] = value.evaluate(values)

    def number(speeds: Speeds) -> float:
        return speeds[drive].evaluate(values)

    unknowns = {unknown: number(speeds) for unknown, speeds in plan.speeds.items()}
    points = {
        point: _velocity(flows, unknowns, values)
        for point, flows in plan.graph.velocities.items()
        if point in figure.points
    }
    spins = {link: number(plan.spin(link)) for link in _links(plan, figure, points)}
    return Velocities("", points, spins, tuple(_slidings(figure, points, spins)))


def _velocity(flows: Velocity, unknowns: Mapping[int, float], values: Values) -> Plane:
    found = NOWHERE
    for size, along, unknown in flows:
        speed = size.evaluate(values) * unknowns[unknown]
        found = found.plus(direction(along.evaluate(values)).times(speed))
    return found


def _links(plan: Plan, figure: Figure, points: Mapping[str, Plane]) -> Iterator[str]:
    """Yield the links of the half that is described."""
    frames = plan.graph.pose.frames
    links = (part for part in figure.parts if isinstance(part, Link) and part.name in frames)
    for link in links:
        if points.keys() >= {*link.points}:
            yield link.name


def _slidings(
    figure: Figure, points: Mapping[str, Plane], spins: Mapping[str, float]
) -> Iterator[Sliding]:
    """Yield how pins move in slots, and points along the links that they touch."""
    tails = {part.name: part.points[0] for part in figure.parts if isinstance(part, Link)}
    for part in figure.parts:
        if isinstance(part, Slot | Contact) and part.point in points and part.body in spins:
            tail = tails[part.body]
            arm = figure.points[part.point].minus(figure.points[tail])
            under = points[tail].plus(arm.turned().times(spins[part.body]))
            yield Sliding(part.point, part.body, points[part.point].minus(under))
