"""A graph as far as it is drawn: unknown speeds, who carries which point, what must agree."""

from collections.abc import Sequence

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import ONE
from ..algebra.trigonometry import sine
from ..model.mechanism import Link
from ..pose.pose import Pose
from ..source import Span
from .forms import projection, subtract
from .graph import Flow, Graph, LinearForm, Relation, Rule, SpeedKind, UnknownSpeed, Velocity

MOST_VELOCITY_PARTS = 3
"""A velocity of more parts than this gets unknowns of its own before a link is based on it."""


class Draft:
    """The unknowns, velocities, spins and relations of one pose that are known by now."""

    def __init__(self, pose: Pose) -> None:
        self.pose, self.mechanism = pose, pose.mechanism
        self.guides = pose.guides_and_line
        self.velocities: dict[str, Velocity] = {}
        self.spins: dict[str, int] = {}
        self.relations: list[Relation] = []
        self._unknowns: list[UnknownSpeed] = []
        self._carriers: dict[str, tuple[Link, str]] = {}

    def graph(self) -> Graph:
        """Return the finished graph; a relation that always holds is left out."""
        relations = tuple(r for r in self.relations if r.form)
        return Graph(self.pose, tuple(self._unknowns), self.velocities, self.spins, relations)

    def unknown(self, kind: SpeedKind, of: str, direction: Angle | None = None) -> int:
        """Return the number of a new unknown speed."""
        self._unknowns.append(UnknownSpeed(kind, of, direction))
        return len(self._unknowns) - 1

    def spin(self, link: Link) -> int:
        """Return the number of a new unknown, the link's angular velocity."""
        self.spins[link.name] = self.unknown(SpeedKind.SPIN, link.name)
        return self.spins[link.name]

    def relate(
        self,
        rule: Rule,
        body: str,
        points: Sequence[str],
        along: Angle,
        form: LinearForm,
        span: Span,
    ) -> None:
        """Demand that a form be zero, by a rule of mechanics."""
        self.relations.append(Relation(rule, body, tuple(points), along, form, span))

    def free(self, point: str, first: Angle, second: Angle) -> None:
        """Carry a point by the projections p, q of its velocity on two directions.

        V = (p·e(θ₂ − 90°) + q·e(θ₁ + 90°))/sin(θ₂ − θ₁): then V·e(θ₁) = p and
        V·e(θ₂) = q.
        """
        p = self.unknown(SpeedKind.COMPONENT, point, first)
        q = self.unknown(SpeedKind.COMPONENT, point, second)
        scale = sine(second - first) ** -1
        self.velocities[point] = (
            Flow(scale, second - QUARTER, p),
            Flow(scale, first + QUARTER, q),
        )

    def carry(self, link: Link, point: str, velocity: Velocity, base: str = "") -> None:
        """Let a link carry a point, or relate the two if something else carries it already."""
        known = self.velocities.get(point)
        if known is None:
            self.velocities[point] = velocity
            self._carriers[point] = link, base
            return
        rule = Rule.REST if known == () else Rule.ROTATION if base else Rule.JOINT
        for direction in self._both_directions(link, base, point, velocity):
            form = subtract(projection(velocity, direction), projection(known, direction))
            self.relate(rule, link.name, _based(base, point), direction, form, link.span)

    def name_if_long(self, point: str) -> None:
        """Give a velocity with many parts two unknowns of its own, along and across a guide.

        Without this each link of a chain would carry the parts of all links before it.
        """
        velocity = self.velocities[point]
        if len(velocity) <= MOST_VELOCITY_PARTS or point not in self._carriers:
            return
        link, base = self._carriers[point]
        along = next(iter(self.guides.values()), Angle())
        flows = []
        for direction in (along, along + QUARTER):
            unknown = self.unknown(SpeedKind.COMPONENT, point, direction)
            form = subtract(projection(velocity, direction), {unknown: ONE})
            self.relate(Rule.BODY, link.name, _based(base, point), direction, form, link.span)
            flows.append(Flow(ONE, direction, unknown))
        self.velocities[point] = tuple(flows)

    def _both_directions(
        self, link: Link, base: str, point: str, velocity: Velocity
    ) -> tuple[Angle, Angle]:
        """Return the line of the link, in which its spin has no part, and the normal to it.

        Two points of a link may lie in one place, where any two directions do: the normal is then
        that of the last part of the velocity, so that this part is in one of the projections alone.
        """
        arms = self.pose.vector(link.name, base, point) if base else ()
        along = velocity[-1].direction - QUARTER if velocity else Angle()
        if arms:
            along = arms[0].angle
        return along, along + QUARTER


def _based(base: str, point: str) -> tuple[str, ...]:
    return (base, point) if base else (point,)
