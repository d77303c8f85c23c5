"""A bond let go: the mechanism with one freedom more, along which a reaction does work.

By the principle of released constraints the force of a bond becomes a load once the bond
is taken away. With the driving loads held still, what is left has one freedom, and the
balance of power in it gives that force alone, as short as k itself.

A bond is a *pin* of a link on what it meets there, a point on the *ground* (a pivot, a
guide), or a *touch* (slot, contact). Let go along a direction, it keeps everything else:
a pin does not part across it, a pivot moves along it only.
"""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import NamedTuple, assert_never

from ..algebra.angle import Angle
from ..algebra.from_formula import to_product
from ..algebra.product import Product
from ..diagnostics import MechcError, Report
from ..formula.tree import PI
from ..frozen import frozen, replace
from ..model.mechanism import Force, ForcePair, Link, Load, Mechanism, Telescope, Torque
from ..pose.pose import PointContact, Pose
from ..source import Source, Span
from .builder import Builder
from .forms import QUARTER, combined, leaving, parting, projection, scaled, spin, subtract
from .graph import Form, Graph, Relation, Rule
from .plan import Plan, Speeds
from .planning import plan_of


class JointRef(NamedTuple):
    """What is let go at a point: ``pin`` of a link, ``ground``, guide of a ``slide``, ``touch``.

    ``of`` is the name of the link or slide. A ``gear`` or ``belt`` has the pivot of its first
    wheel for a point, a ``rack`` or ``screw`` its slider.
    """

    kind: str
    point: str
    of: str = ""

    @property
    def loose(self) -> str:
        """Return the name of the link's own point, once it has left the pin."""
        return f"{self.point} of {self.of}" if self.kind == "pin" else self.point


def held_end(mechanism: Mechanism, link: Link) -> str:
    """Return an end of a rod that something else holds: its last one, if that is.

    At an end where a load acts on the rod itself the pin gives not all of the force along it.
    """
    loaded = {k.point for k in mechanism.loads if isinstance(k, Force) and k.link == link.name}
    for pair in (k for k in mechanism.loads if isinstance(k, ForcePair)):
        ends = (pair.first_link, pair.first), (pair.second_link, pair.second)
        loaded |= {point for name, point in ends if name == link.name}

    def is_held(point: str) -> bool:
        if point in loaded:
            return False
        others = sum(point in k.points for k in mechanism.links) > 1
        joints = {p.point for p in mechanism.pivots} | {s.point for s in mechanism.sliders}
        touching = {s.point for s in mechanism.slots} | {c.point for c in mechanism.contacts}
        slides = any(point in s.points for s in mechanism.slides)
        return others or slides or point in joints | touching

    return next((p for p in reversed(link.points) if is_held(p)), link.points[-1])


Measure = Callable[[Graph], Form]
"""A speed that is read off a graph, as a linear form in its unknowns."""


@frozen
class Released:
    """A pose with a bond let go, the speed at which it parts, and what still holds there."""

    pose: Pose
    parting: Measure
    holding: tuple[Measure, ...] = ()


@frozen
class ReleasedLinkage:
    """The plan of a mechanism with a bond let go, and the speed at which the bond parts."""

    plan: Plan
    parting: Speeds


Share = tuple[Product, Load]
"""A load by how much of it there is for a unit of the free load that it is tied to."""


def released_linkage(
    pose: Pose,
    joint: JointRef,
    along: Angle,
    held: Iterable[Sequence[Share]],
    taken: frozenset[str],
) -> ReleasedLinkage | None:
    """Return the motions that are left with a bond let go along a direction.

    Each free load in ``held`` does no work in them, with all that are tied to it. None where
    nothing moves: then other bonds do the same as this one. Long sums get names that are not
    ``taken``.
    """
    let_go = _released(pose, joint, along)
    moved = {load.name: load for load in let_go.pose.mechanism.loads}
    shares = [[(part, moved[load.name]) for part, load in free] for free in held]
    measures = [*let_go.holding, *map(work_of, shares)]
    graph = _held_still(Builder(let_go.pose).graph(), measures, pose.mechanism.span)
    try:
        plan = plan_of(graph, Report(Source("", "")), taken)
    except MechcError:
        return None
    return ReleasedLinkage(plan, plan.value(let_go.parting(graph)))


def work_of(shares: Sequence[Share]) -> Measure:
    """Return the speed with which a free load does its work, with all that are tied to it."""
    if len(shares) == 1:
        return _speed_of(shares[0][1])
    measures = [(part, _speed_of(load)) for part, load in shares]
    return lambda graph: combined((part, measure(graph)) for part, measure in measures)


def _speed_of(load: Load) -> Measure:
    match load:
        case Force(name, point):
            return lambda graph: projection(graph.velocities[point], graph.pose.lines[name])
        case ForcePair(name):
            return lambda graph: parting(graph, load, graph.pose.lines[name])
        case Torque(_, link):
            return lambda graph: spin(graph, link)
        case _:
            assert_never(load)


def _held_still(graph: Graph, measures: Iterable[Measure], span: Span) -> Graph:
    forms = (measure(graph) for measure in measures)
    more = (Relation(Rule.HELD, "", (), Angle(), form, span) for form in forms if form)
    return replace(graph, relations=(*graph.relations, *more))


def _released(pose: Pose, joint: JointRef, along: Angle) -> Released:
    match joint.kind:
        case "pin":
            return _without_pin(pose, joint, along)
        case "ground":
            return _without_ground(pose, joint.point, along)
        case "slide":
            return _without_slide(pose, joint, along)
        case "gear" | "belt" | "rack" | "screw":
            return _without_transmission(pose, joint)
        case _:
            return _without_touch(pose, joint.point)


def _without_pin(pose: Pose, joint: JointRef, along: Angle) -> Released:
    """Give the link a point of its own that parts from the pin along one direction.

    What acts on the link there goes with it. A telescope holds its ends at no distance, so
    that its own point moves like a body.
    """
    own, point, mechanism = joint.loose, joint.point, pose.mechanism
    links = tuple(_renamed(k, point, own) if k.name == joint.of else k for k in mechanism.links)
    frame = {own if p == point else p: v for p, v in pose.frames[joint.of].items()}
    frames = {**pose.frames, joint.of: frame}
    touches = tuple(
        t._replace(tail=own) if t.body == joint.of and t.tail == point else t for t in pose.touches
    )
    racks = tuple(
        replace(r, pivot=own) if (r.link, r.pivot) == (joint.of, point) else r
        for r in mechanism.racks
    )
    apart = replace(
        pose,
        mechanism=replace(
            _sharing(mechanism, joint), links=links, racks=racks, loads=_carried(mechanism, joint)
        ),
        frames=frames,
        touches=touches,
    )
    apart = _with_pin(_with_pin(apart, point), own)

    def gap(graph: Graph, direction: Angle = along) -> Form:
        ahead, behind = (projection(graph.velocities[p], direction) for p in (own, point))
        return subtract(ahead, behind)

    return Released(apart, gap, (lambda graph: gap(graph, along + QUARTER),))


def _carried(mechanism: Mechanism, joint: JointRef) -> tuple[Load, ...]:
    """Return the loads, those on a link itself at the point that it has for itself now."""

    def moved(load: Load) -> Load:
        there = (joint.of, joint.point)
        match load:
            case Force() if (load.link, load.point) == there:
                return replace(load, point=joint.loose)
            case ForcePair() if (load.first_link, load.first) == there:
                return replace(load, first=joint.loose)
            case ForcePair() if (load.second_link, load.second) == there:
                return replace(load, second=joint.loose)
            case _:
                return load

    return tuple(map(moved, mechanism.loads))


def _with_pin(pose: Pose, point: str) -> Pose:
    """Let a pin be a body of its own where nothing is left that holds it."""
    if any(point in held for held in _holding(pose)):
        return pose
    mechanism = pose.mechanism
    pin = Link(f"pin {point}", (point,), mechanism.span)
    with_pin = replace(mechanism, links=(*mechanism.links, pin))
    return replace(pose, mechanism=with_pin, frames={**pose.frames, pin.name: {point: ()}})


def _holding(pose: Pose) -> Iterator[Collection[str]]:
    """Yield the points of whatever gives a point its velocity."""
    mechanism = pose.mechanism
    yield {pivot.point for pivot in mechanism.pivots}
    yield pose.guides.keys()
    yield from (link.points for link in mechanism.links)
    yield from (slide.points for slide in mechanism.slides)


def _renamed(link: Link, point: str, own: str) -> Link:
    return replace(link, points=tuple(own if p == point else p for p in link.points))


def _sharing(mechanism: Mechanism, joint: JointRef) -> Mechanism:
    """Let both halves share the link's own point where they share the whole link."""
    mirror = mechanism.mirror
    bodies: list[Link | Telescope] = [*mechanism.links, *mechanism.cylinders]
    points = next(b.points for b in bodies if b.name == joint.of)
    if mirror is None or not set(points) <= set(mirror.sharing):
        return mechanism
    return replace(mechanism, mirror=replace(mirror, sharing=(*mirror.sharing, joint.loose)))


def _without_ground(pose: Pose, point: str, along: Angle) -> Released:
    """Let a pivot move along one direction, or a slider leave its guide."""
    mechanism = pose.mechanism
    pivots = tuple(p for p in mechanism.pivots if p.point != point)
    sliders = tuple(s for s in mechanism.sliders if s.point != point)
    guides = {p: direction for p, direction in pose.guides.items() if p != point}
    left = {p: direction for p, direction in pose.guides.items() if p not in guides}
    if len(pivots) < len(mechanism.pivots):
        guides[point] = along
    free = replace(mechanism, pivots=pivots, sliders=sliders)
    return Released(
        _with_pin(replace(pose, mechanism=free, guides=guides, left=left), point),
        lambda graph: projection(graph.velocities[point], along),
    )


def _without_slide(pose: Pose, joint: JointRef, along: Angle) -> Released:
    """Let a translating body leave its guide; it still does not turn."""
    mechanism = pose.mechanism
    slide = next(s for s in mechanism.slides if s.name == joint.of)
    slides = tuple(s for s in mechanism.slides if s is not slide)
    link = Link(slide.name, slide.points, slide.span)
    free = replace(mechanism, slides=slides, links=(*mechanism.links, link))
    left = dict.fromkeys(slide.points, pose.slides[slide.name])
    return Released(
        replace(pose, mechanism=free, left=left),
        lambda graph: projection(graph.velocities[joint.point], along),
        (lambda graph: spin(graph, slide.name),),
    )


def _without_transmission(pose: Pose, joint: JointRef) -> Released:
    """Let the teeth of a pair, a rack or a thread lose each other."""
    m = pose.mechanism
    free = replace(
        m,
        wheel_pairs=tuple(
            x for x in m.wheel_pairs if (x.kind, x.first) != (joint.kind, joint.point)
        ),
        racks=tuple(r for r in m.racks if (joint.kind, joint.point) != ("rack", r.point)),
        screws=tuple(s for s in m.screws if (joint.kind, joint.point) != ("screw", s.point)),
    )
    return Released(replace(pose, mechanism=free), lambda graph: slipping(graph, pose, joint))


def slipping(graph: Graph, pose: Pose, joint: JointRef) -> Form:
    """Return the speed at which rims, a rack and its wheel, or nut and thread, part."""
    for mesh in pose.mechanism.wheel_pairs:
        if (mesh.kind, mesh.first) == (joint.kind, joint.point):
            sign = -1 if mesh.same else 1
            first = scaled(spin(graph, mesh.first_link), pose.radii[mesh.first_radius])
            second = scaled(spin(graph, mesh.second_link), pose.radii[mesh.second_radius])
            return subtract(first, scaled(second, Product(-sign)))
    moved, guide = joint.point, pose.guide_of(joint.point) or Angle()
    ahead = projection(graph.velocities[moved], guide)
    racks = {r.point: r for r in (*pose.mechanism.racks, *graph.pose.mechanism.racks)}
    if joint.kind == "rack":
        rack = racks[moved]
        rim = scaled(spin(graph, rack.link), pose.radii[rack.radius])
        return subtract(subtract(ahead, rim), projection(graph.velocities[rack.pivot], guide))
    screw = next(s for s in pose.mechanism.screws if s.point == moved)
    lead = pose.radii[screw.pitch] / to_product(PI).scaled(2)
    return subtract(ahead, scaled(spin(graph, screw.link), lead))


def _without_touch(pose: Pose, point: str) -> Released:
    touch = touch_at(pose, point)
    left = tuple(t for t in pose.touches if t is not touch)
    return Released(
        replace(pose, touches=left),
        lambda graph: leaving(graph, touch, touch.normal),
    )


def unclear(mechanism: Mechanism) -> frozenset[str]:
    """Return the pivots on which wheels and screws press in directions that nothing tells.

    Teeth press across the line of centres, belts are tightened beforehand, and a screw's
    thrust is out of the plane. A rack presses along its guide.
    """
    turning = {link for m in mechanism.wheel_pairs for link in (m.first_link, m.second_link)}
    turning |= {screw.link for screw in mechanism.screws}
    fixed = {pivot.point for pivot in mechanism.pivots}
    held = (p for k in mechanism.links if k.name in turning for p in k.points)
    return frozenset(p for p in held if p in fixed)


def members(pose: Pose, joint: JointRef) -> tuple[str, ...]:
    """Return the points of all that a bond joins; it is shared by halves where they all are."""
    if joint.kind == "touch":
        return (joint.point, *pose.frames[touch_at(pose, joint.point).body])
    if joint.kind in ("gear", "belt"):
        mesh = next(m for m in pose.mechanism.wheel_pairs if (m.kind, m.first) == joint[:2])
        return (*pose.frames[mesh.first_link], *pose.frames[mesh.second_link])
    if joint.kind in ("rack", "screw"):
        links = {r.point: r.link for r in pose.mechanism.racks}
        links |= {s.point: s.link for s in pose.mechanism.screws}
        return (joint.point, *pose.frames[links[joint.point]])
    return tuple(pose.frames[joint.of]) if joint.of else (joint.point,)


def touch_at(pose: Pose, point: str) -> PointContact:
    """Return the slot or contact of a point."""
    return next(t for t in pose.touches if t.point == point)
