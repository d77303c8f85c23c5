"""Builds the graph: who carries each point, which unknowns that takes, what must agree.

Every moving point gets one *carrier* that defines its velocity: the ground (pivots), a
link that turns about a pivot, a guide, a body that floats, or, for a pin that only rods
hold, its projections on two of them. Everything else that holds the point becomes a
relation.
"""

from collections import defaultdict
from collections.abc import Iterator

from ..algebra.angle import Angle
from ..algebra.product import ONE, Product
from ..algebra.trigonometry import sine
from ..model.mechanism import Link, Pivot, Slider
from ..pose.pose import Pose, Vector
from ..source import Span
from .contacts import relations, spinning
from .forms import QUARTER, projection, subtract, turned
from .graph import Flow, Graph, Kind, Relation, Rule, Unknown, Velocity

LONGEST = 3
"""A velocity of more parts than this gets unknowns of its own before a link is based on it."""


class Builder:
    """Gathers unknowns, velocities and relations of one pose."""

    def __init__(self, pose: Pose) -> None:
        self._pose = pose
        self._mechanism = pose.mechanism
        self._unknowns: list[Unknown] = []
        self._velocities: dict[str, Velocity] = {}
        self._spins: dict[str, int] = {}
        self._relations: list[Relation] = []
        self._carriers: dict[str, tuple[Link, str]] = {}
        self._links_at: dict[str, list[Link]] = defaultdict(list)
        for link in self._mechanism.links:
            for point in link.points:
                self._links_at[point].append(link)
        self._spinning = spinning(pose)
        self._guides = pose.guides_and_line

    def graph(self) -> Graph:
        """Return the graph."""
        self._rest_pivots()
        pivoted, floating = self._split_links()
        for link in pivoted:
            self._turn_about_pivot(link)
        self._move_slides()
        self._guide_sliders()
        rods = self._carry_bodies(floating)
        self._carry_free_pins(rods)
        self._carry_loose_pins()
        for rod in rods:
            self._relate_rod(rod)
        self._relations.extend(relations(self._pose, self._velocities, self._spins))
        return Graph(
            self._pose,
            tuple(self._unknowns),
            self._velocities,
            self._spins,
            tuple(r for r in self._relations if r.form),
        )

    # ------------------------------------------------------------------- carriers

    def _rest_pivots(self) -> None:
        for pivot in self._mechanism.each(Pivot):
            self._velocities[pivot.point] = ()

    def _split_links(self) -> tuple[list[Link], list[Link]]:
        at_rest = self._mechanism.fixed
        pivoted = [k for k in self._mechanism.links if not at_rest.isdisjoint(k.points)]
        return pivoted, [k for k in self._mechanism.links if at_rest.isdisjoint(k.points)]

    def _turn_about_pivot(self, link: Link) -> None:
        at_rest = [p for p in link.points if self._velocities.get(p) == ()]
        spin = self._spin_of(link)
        for point in link.points:
            if point != at_rest[0]:
                self._carry(
                    link, point, turned(self._pose.vector(link.name, at_rest[0], point), spin)
                )

    def _move_slides(self) -> None:
        """Give all points of a body that only translates one speed."""
        for slide in self._mechanism.slides:
            along = self._pose.slides[slide.name]
            unknown = self._unknown(Unknown(Kind.SLIDE, slide.points[0], along))
            for point in slide.points:
                velocity = (Flow(ONE, along, unknown),)
                known = self._velocities.setdefault(point, velocity)
                if known != velocity:
                    self._relate_points(slide.name, point, velocity, along, slide.span)

    def _relate_points(
        self, body: str, point: str, velocity: Velocity, along: Angle, span: Span
    ) -> None:
        """Let a point that something else carries have the velocity of a translating body too."""
        for direction in (along, along + QUARTER):
            known = projection(self._velocities[point], direction)
            form = subtract(projection(velocity, direction), known)
            self._relations.append(Relation(Rule.JOINT, body, (point,), direction, form, span))

    def _guide_sliders(self) -> None:
        for point, direction in self._guides.items():
            velocity = self._velocities.get(point)
            if velocity is None:
                slide = self._unknown(Unknown(Kind.SLIDE, point, direction))
                self._velocities[point] = (Flow(ONE, direction, slide),)
            else:
                self._relate_guide(point, velocity, direction)

    def _carry_bodies(self, floating: list[Link]) -> list[Link]:
        """Give links with a spin of their own their velocities; return the others, the rods.

        A body with points whose velocity is known comes first, so that it can be based on
        one of them.
        """
        waiting = [k for k in floating if not self._is_rod(k)]
        rods = [k for k in floating if self._is_rod(k)]
        while waiting:
            link = max(waiting, key=self._known_points)
            waiting.remove(link)
            self._float(link, rods)
        return rods

    def _is_rod(self, link: Link) -> bool:
        """Return whether a link is held at both of its two ends, so that its spin is not needed."""
        held = len(link.points) == 2 and all(self._is_held(link, p) for p in link.points)
        return held and link.name not in self._spinning

    def _is_held(self, link: Link, point: str) -> bool:
        return point in self._velocities or len(self._links_at[point]) > 1

    def _known_points(self, link: Link) -> int:
        return sum(p in self._velocities for p in link.points)

    def _float(self, link: Link, rods: list[Link]) -> None:
        """Express a body's points by the velocity of one of them and the body's spin."""
        known = [p for p in link.points if p in self._velocities]
        base = known[0] if known else self._loosen(link, rods)
        self._name_if_long(base)
        spin = self._spin_of(link)
        for point in link.points:
            if point != base:
                arms = self._pose.vector(link.name, base, point)
                velocity = (*self._velocities[base], *turned(arms, spin))
                self._carry(link, point, velocity, base)

    def _loosen(self, link: Link, rods: list[Link]) -> str:
        """Give one point of a body that nothing known touches two unknown components."""
        for point in link.points:
            for rod in rods:
                if point in rod.points:
                    self._free(point, self._direction(rod), self._direction(rod) + QUARTER)
                    return point
        self._free(link.points[0], Angle(), QUARTER)
        return link.points[0]

    def _carry_free_pins(self, rods: list[Link]) -> None:
        for rod in rods:
            for point in rod.points:
                if point not in self._velocities:
                    first, second = self._two_directions(point)
                    self._free(point, first, second)

    def _carry_loose_pins(self) -> None:
        """Let a pin that has left its guide, and that no body has, move in its slot and off it."""
        for touch in self._pose.touches:
            if touch.point not in self._velocities:
                self._free(touch.point, touch.normal, touch.normal + QUARTER)

    def _two_directions(self, point: str) -> tuple[Angle, Angle]:
        """Return the directions of two rods at a point that are not always parallel."""
        first, *others = (self._direction(k) for k in self._links_at[point])
        for other in others:
            if sine(other - first):
                return first, other
        return first, first + QUARTER

    def _free(self, point: str, first: Angle, second: Angle) -> None:
        """Carry a point by the projections p, q of its velocity on two directions.

        V = (p·e(θ₂ − 90°) + q·e(θ₁ + 90°))/sin(θ₂ − θ₁): then V·e(θ₁) = p and
        V·e(θ₂) = q.
        """
        p = self._unknown(Unknown(Kind.COMPONENT, point, first))
        q = self._unknown(Unknown(Kind.COMPONENT, point, second))
        scale = sine(second - first) ** -1
        self._velocities[point] = (
            Flow(scale, second - QUARTER, p),
            Flow(scale, first + QUARTER, q),
        )

    # ------------------------------------------------------------------ relations

    def _carry(self, link: Link, point: str, velocity: Velocity, base: str = "") -> None:
        """Let a link carry a point, or relate the two if something else carries it already."""
        known = self._velocities.get(point)
        if known is None:
            self._velocities[point] = velocity
            self._carriers[point] = link, base
            return
        rule = Rule.REST if known == () else Rule.ROTATION if base else Rule.JOINT
        points = (base, point) if base else (point,)
        for direction in self._both_directions(link, base, point, velocity):
            form = subtract(projection(velocity, direction), projection(known, direction))
            self._relations.append(Relation(rule, link.name, points, direction, form, link.span))

    def _name_if_long(self, point: str) -> None:
        """Give a velocity with many parts two unknowns of its own, along and across a guide.

        Without this each link of a chain would carry the parts of all links before it.
        """
        velocity = self._velocities[point]
        if len(velocity) <= LONGEST or point not in self._carriers:
            return
        link, base = self._carriers[point]
        along = next(iter(self._guides.values()), Angle())
        flows = []
        for direction in (along, along + QUARTER):
            unknown = self._unknown(Unknown(Kind.COMPONENT, point, direction))
            form = subtract(projection(velocity, direction), {unknown: ONE})
            points = (base, point) if base else (point,)
            self._relations.append(
                Relation(Rule.BODY, link.name, points, direction, form, link.span)
            )
            flows.append(Flow(ONE, direction, unknown))
        self._velocities[point] = tuple(flows)

    def _both_directions(
        self, link: Link, base: str, point: str, velocity: Velocity
    ) -> Iterator[Angle]:
        """Yield the line of the link, in which its spin has no part, and the normal to it.

        Two points of a link may lie in one place: then any two directions do.
        """
        arms = self._pose.vector(link.name, base, point) if base else ()
        along = velocity[-1].direction - QUARTER if velocity else Angle()
        if arms:
            along = arms[0].angle
        yield along
        yield along + QUARTER

    def _relate_guide(self, point: str, velocity: Velocity, direction: Angle) -> None:
        across = direction + QUARTER
        form = projection(velocity, across)
        span = self._span_of_guide(point)
        self._relations.append(Relation(Rule.GUIDE, "", (point,), across, form, span))

    def _span_of_guide(self, point: str) -> Span:
        spans = {s.point: s.span for s in self._mechanism.each(Slider)}
        return spans.get(
            point, self._mechanism.mirror.span if self._mechanism.mirror else Span(0, 0)
        )

    def _relate_rod(self, rod: Link) -> None:
        tail, head = rod.points
        along = self._direction(rod)
        if len(self._pose.vector(rod.name, tail, head)) == 1:
            form = subtract(
                projection(self._velocities[tail], along), projection(self._velocities[head], along)
            )
        else:
            form = self._rate_of_distance(rod)
        relation = Relation(Rule.PROJECTION, rod.name, (tail, head), along, form, rod.span)
        self._relations.append(relation)

    def _rate_of_distance(self, rod: Link) -> dict[int, Product]:
        """Return (V_A − V_B)·AB for a rod whose vector is a sum of several arms."""
        tail, head = rod.points
        arms = self._pose.vector(rod.name, tail, head)
        return dict(
            subtract(_dot(self._velocities[tail], arms), _dot(self._velocities[head], arms))
        )

    # -------------------------------------------------------------------- helpers

    def _direction(self, rod: Link) -> Angle:
        return self._pose.vector(rod.name, rod.points[0], rod.points[1])[0].angle

    def _spin_of(self, link: Link) -> int:
        self._spins[link.name] = self._unknown(Unknown(Kind.SPIN, link.name))
        return self._spins[link.name]

    def _unknown(self, unknown: Unknown) -> int:
        self._unknowns.append(unknown)
        return len(self._unknowns) - 1


def _dot(velocity: Velocity, arms: Vector) -> dict[int, Product]:
    """Return the scalar product of a velocity and a vector."""
    along_each = (
        Flow(flow.size * arm.length, flow.direction - arm.angle, flow.unknown)
        for flow in velocity
        for arm in arms
    )
    return dict(projection(tuple(along_each), Angle()))
