"""A bond let go: the mechanism with one freedom more, along which a reaction does work.

By the principle of released constraints the force of a bond becomes a load once the bond
is taken away. With the driving loads held still, what is left has one freedom, and the
balance of power in it gives that force alone, as short as k itself.

A bond is a *pin* of a link on what it meets there, a point on the *ground* (a pivot, a
guide), or a *touch* (slot, contact). Let go along a direction, it keeps everything else:
a pin does not part across it, a pivot moves along it only.
"""

from collections.abc import Callable, Iterable
from typing import NamedTuple

from ..algebra.angle import Angle
from ..frozen import frozen, replace
from ..model.mechanism import Link, Mechanism
from ..pose.pose import Pose, Touch
from ..source import Span
from .builder import Builder
from .forms import QUARTER, leaving, projection, subtract
from .graph import Form, Graph, Relation, Rule


class Bond(NamedTuple):
    """What is let go at a point: of a link (``of`` its name), the ground, or a touch."""

    kind: str
    point: str
    of: str = ""

    @property
    def loose(self) -> str:
        """Return the name of the link's own point, once it has left the pin."""
        return f"{self.point} of {self.of}" if self.kind == "pin" else self.point


Measure = Callable[[Graph], Form]
"""A speed that is read off a graph, as a linear form in its unknowns."""


@frozen
class Released:
    """A pose with a bond let go, the speed at which it parts, and what still holds there."""

    pose: Pose
    parting: Measure
    holding: tuple[Measure, ...] = ()


def released(pose: Pose, bond: Bond, along: Angle) -> Released:
    """Return the pose with a bond let go along a direction."""
    match bond.kind:
        case "pin":
            return _without_pin(pose, bond, along)
        case "ground":
            return _without_ground(pose, bond.point, along)
        case _:
            return _without_touch(pose, bond.point)


def graph_of(let_go: Released, held: Iterable[Measure], span: Span) -> Graph:
    """Return the graph of what is left, with the speeds in ``held`` kept at zero."""
    graph = Builder(let_go.pose).graph()
    forms = [measure(graph) for measure in (*let_go.holding, *held)]
    more = (Relation(Rule.HELD, "", (), Angle(), form, span) for form in forms if form)
    return replace(graph, relations=(*graph.relations, *more))


def _without_pin(pose: Pose, bond: Bond, along: Angle) -> Released:
    """Give the link a point of its own that parts from the pin along one direction."""
    own, point, mechanism = bond.loose, bond.point, pose.mechanism
    links = tuple(_renamed(k, point, own) if k.name == bond.of else k for k in mechanism.links)
    frame = {own if p == point else p: v for p, v in pose.frames[bond.of].items()}
    touches = tuple(
        t._replace(tail=own) if t.body == bond.of and t.tail == point else t for t in pose.touches
    )
    apart = replace(
        pose,
        mechanism=replace(_sharing(mechanism, bond), links=links),
        frames={**pose.frames, bond.of: frame},
        touches=touches,
    )

    def parting(graph: Graph, direction: Angle = along) -> Form:
        ahead, behind = (projection(graph.velocities[p], direction) for p in (own, point))
        return subtract(ahead, behind)

    return Released(apart, parting, (lambda graph: parting(graph, along + QUARTER),))


def _renamed(link: Link, point: str, own: str) -> Link:
    return replace(link, points=tuple(own if p == point else p for p in link.points))


def _sharing(mechanism: Mechanism, bond: Bond) -> Mechanism:
    """Let both halves share the link's own point where they share the whole link."""
    mirror = mechanism.mirror
    link = next(k for k in mechanism.links if k.name == bond.of)
    if mirror is None or not set(link.points) <= set(mirror.sharing):
        return mechanism
    return replace(mechanism, mirror=replace(mirror, sharing=(*mirror.sharing, bond.loose)))


def _without_ground(pose: Pose, point: str, along: Angle) -> Released:
    """Let a pivot move along one direction, or a slider leave its guide."""
    mechanism = pose.mechanism
    pivots = tuple(p for p in mechanism.pivots if p.point != point)
    sliders = tuple(s for s in mechanism.sliders if s.point != point)
    guides = {p: direction for p, direction in pose.guides.items() if p != point}
    if len(pivots) < len(mechanism.pivots):
        guides[point] = along
    free = replace(mechanism, pivots=pivots, sliders=sliders)
    return Released(
        replace(pose, mechanism=free, guides=guides),
        lambda graph: projection(graph.velocities[point], along),
    )


def _without_touch(pose: Pose, point: str) -> Released:
    touch = touch_at(pose, point)
    left = tuple(t for t in pose.touches if t is not touch)
    return Released(
        replace(pose, touches=left),
        lambda graph: leaving(graph, touch, touch.normal),
    )


def touch_at(pose: Pose, point: str) -> Touch:
    """Return the slot or contact of a point."""
    return next(t for t in pose.touches if t.point == point)
