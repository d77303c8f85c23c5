"""What every joint and load exerts on the bodies that are cut free."""

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import chain, pairwise
from typing import assert_never

from ..algebra.angle import HALF_TURN, QUARTER, Angle, rational
from ..algebra.from_formula import to_product
from ..algebra.product import ONE, Product
from ..algebra.sums import add
from ..base.named import NamedTuple
from ..formula.tree import PI
from ..formula.walk import symbols
from ..model.mechanism import (
    Contact,
    Joint,
    Link,
    Load,
    Pivot,
    Rack,
    Rope,
    Screw,
    Slider,
    Slot,
    WheelPair,
)
from ..pose.pose import Arm, PointContact, Vector, gathered
from ..power.loads import owners
from ..power.numbers import pose_values
from .actions import Action, Cutting, X, Y, unit
from .equilibrium import JointForce

ActionOnBody = tuple[str, Action]
"""The body that something acts on, and what acts; a pivot stands for the ground there."""


class Exerted(NamedTuple):
    """A force to be found, and how it, or each of its components, acts on bodies."""

    force: JointForce
    actions: tuple[ActionOnBody, ...]


def by_joints(cut: Cutting) -> Iterator[Exerted]:
    """Yield what rods, pins, guides, contacts and all other joints exert, in this order."""
    yield from (_rod(link, cut) for link in cut.mechanism.links if link.name not in cut.rigid)
    for point in dict.fromkeys(p for points in cut.rigid.values() for p in points):
        yield from _pin(point, cut)
    touched = Counter(contact.point for contact in cut.pose.contacts)
    for point, guide in cut.pose.guides.items():
        name = f"N_{point}_guide" if touched[point] else f"N_{point}"
        force = JointForce("guide", (name,), (point,))
        yield _exerted(force, _on_pin(force.names[0], point, guide + QUARTER, (point,), cut))
    for contact in cut.pose.contacts:
        of = contact.point if touched[contact.point] == 1 else f"{contact.point}_{contact.body}"
        yield _contact(contact, f"N_{of}", cut)
    for joint in cut.mechanism.joints:
        if (exerted := _passed_on(joint, cut)) is not None:
            yield exerted


def by_loads(cut: Cutting) -> Iterator[ActionOnBody]:
    """Yield the loads, each under the name of the one that it is tied to."""
    tied_to = owners(cut.mechanism)
    for load in cut.mechanism.loads:
        owner, part = tied_to[load.name]
        yield from _load(load, owner, part.scaled(rational(load.times)), cut)


def _exerted(force: JointForce, *actions: Iterable[ActionOnBody]) -> Exerted:
    return Exerted(force, tuple(action for several in actions for action in several))


# ------------------------------------------------------------------------------ rods and pins


def _rod(rod: Link, cut: Cutting) -> Exerted:
    tail, head = rod.points
    name = f"N_{rod.name}"
    actions = [
        action
        for part, along in unit(cut.pose.vector(rod.name, tail, head))
        for point, size in ((tail, part), (head, -part))
        for action in _on_pin(name, point, along, rod.points, cut, size)
    ]
    return _exerted(JointForce("rod", (name,), (rod.name,)), actions)


def _pin(point: str, cut: Cutting) -> Iterator[Exerted]:
    """Yield the forces that hold the bodies of a pin, but for the one that carries it."""
    host = cut.host(point)
    others = [name for name in cut.on(point) if name != host]
    for body in others:
        of = point if len(others) == 1 else f"{point}_{body}"
        force, lines = _force_at_pin(body, point, of, host, cut)
        actions = [
            action
            for name, along in zip(force.names, lines, strict=True)
            for action in (
                (body, _at(name, along, cut.pose.frames[body][point], pin=point)),
                *_on_pin(name, point, along, cut.rigid[body], cut, Product(-1)),
            )
        ]
        yield _exerted(force, actions)


def _force_at_pin(
    body: str, point: str, of: str, host: str, cut: Cutting
) -> tuple[JointForce, tuple[Angle, Angle]]:
    """Return the force on a body at a pin, by its components, and the lines of these."""
    if not host:
        return JointForce("pivot", (f"X_{of}", f"Y_{of}"), (body, point)), (X, Y)
    arm, lines = _components(point, (body, host), cut)
    names = (f"R_{of}_n", f"R_{of}_t") if arm else (f"X_{of}", f"Y_{of}")
    return JointForce("pin", names, (body, point, arm)), lines


def _components(point: str, bodies: Iterable[str], cut: Cutting) -> tuple[str, tuple[Angle, Angle]]:
    """Return the arm of a body along which and across which its force at a pin is taken.

    About the other end of a crank the force along it has no moment. '' is for x and y. One that
    turns about a pivot comes first.
    """
    rigid = filter(cut.rigid.__contains__, bodies)
    for body in sorted(rigid, key=lambda body: cut.mechanism.fixed.isdisjoint(cut.rigid[body])):
        points = cut.rigid[body]
        ends = [p for p in points if p in cut.mechanism.fixed] or [
            p for p in points if len(points) == 2 and p != point
        ]
        arm = cut.pose.vector(body, ends[0], point) if ends else ()
        if len(arm) == 1 and body not in cut.pose.slides:
            return ends[0] + point, (arm[0].angle, arm[0].angle + QUARTER)
    return "", (X, Y)


# ------------------------------------------------------------------------------- other joints


def _contact(contact: PointContact, name: str, cut: Cutting) -> Exerted:
    """Return the force with which a body pushes a pin, and the pin the body."""
    body = contact.body
    both = (contact.point, *cut.points(body))
    at = (*cut.pose.frames[body][contact.tail], *contact.reach)
    often = cut.repeats(cut.points(body), both)
    return _exerted(
        JointForce("contact", (name,), (contact.point, body)),
        _on_pin(name, contact.point, contact.normal, both, cut),
        [(body, _at(name, contact.normal, at, Product(-often)))],
    )


def _passed_on(joint: Joint, cut: Cutting) -> Exerted | None:
    """Return the forces that a joint passes on, but for those at its points; None without any."""
    match joint:
        case WheelPair():
            return _wheels(joint, cut)
        case Rack():
            return _rack(joint, cut)
        case Screw():
            return _thread(joint, cut)
        case Rope():
            return _rope(joint, cut)
        case Slot(point=point, link=link, guided=guided) if guided:
            name = f"M_{point}"
            couples = _couple(name, guided, ONE), _couple(name, link, Product(-1))
            return _exerted(JointForce("couple", (name,), (guided, link)), *couples)
        case Pivot() | Slider() | Slot() | Contact():
            return None
        case _:
            assert_never(joint)


def _wheels(pair: WheelPair, cut: Cutting) -> Exerted:
    """Return the force at two rims that push each other along, their centres the arm.

    Of gears on an arm it acts at the pitch point; else the centres may have no place.
    """
    force = _force_of_rims(pair, cut)
    (name,) = force.names
    first = cut.pose.radii[pair.first_radius]
    second = cut.pose.radii[pair.second_radius].scaled(-1 if pair.same else 1)
    if (along := _to_pitch_point(pair, cut)) is not None:
        sides = zip(pair.wheels, pair.points, (first, -second), (ONE, Product(-1)), strict=True)
        actions = [
            (link, _at(name, along + QUARTER, _from(link, point, Arm(radius, along), cut), size))
            for link, point, radius, size in sides
            if link
        ]
        return _exerted(force, actions)
    return _exerted(
        force,
        _couple(name, pair.first_link, first),
        _couple(name, pair.second_link, second),
        _couple(name, pair.arm, -first),
        _couple(name, pair.arm, -second),
    )


def _to_pitch_point(pair: WheelPair, cut: Cutting) -> Angle | None:
    """Return the direction in which gears on an arm mesh from the first centre; None for others.

    It is that to the second centre, but for a gear inside a larger one: that meshes behind itself.
    None, too, where the sizes are open that say which of two gears is inside the other.
    """
    centres = cut.pose.vector(pair.arm, pair.first, pair.second) if pair.arm else ()
    if pair.kind != "gear" or len(centres) != 1:
        return None
    ((length, along),) = centres
    if pair.same:
        first, second = (cut.pose.radii[r] for r in (pair.first_radius, pair.second_radius))
        is_ahead = _is_positive(length * add((first, -second)), cut)
    else:
        is_ahead = _is_positive(length, cut) is not False
    if is_ahead is None:
        return None
    return along if is_ahead else along + HALF_TURN


def _is_positive(size: Product, cut: Cutting) -> bool | None:
    """Return whether a size is positive at the default pose; None where it has no value there."""
    values = pose_values(cut.pose)
    return size.evaluate(values) > 0 if symbols(size.formula()) <= values.keys() else None


def _from(link: str, point: str, arm: Arm, cut: Cutting) -> Vector:
    """Return where an arm from a point of a link ends, from the point that its moments are of."""
    return (*cut.pose.frames[link][point], arm)


def _force_of_rims(pair: WheelPair, cut: Cutting) -> JointForce:
    """Return the name of the force between two wheels: by a link where pairs share the centres.

    It is the link that is in no other of these pairs, as the sun of a planetary gear; else both.
    """
    pairs = [j for j in cut.mechanism.joints if isinstance(j, WheelPair)]
    alike = [_wheels_of(other) for other in pairs if {*other.points} == {*pair.points}]
    if len(alike) == 1:
        return JointForce("rim", (f"T_{pair.first}{pair.second}",), pair.points)
    often, wheels = Counter(chain.from_iterable(alike)), _wheels_of(pair)
    own = next((wheel for wheel in wheels if often[wheel] == 1), "".join(wheels))
    return JointForce("rim", (f"T_{own}",), wheels)


def _wheels_of(pair: WheelPair) -> tuple[str, ...]:
    """Return the names of two wheels: of their links, of one that stands still its centre."""
    return tuple(link or point for link, point in zip(pair.wheels, pair.points, strict=True))


def _rack(rack: Rack, cut: Cutting) -> Exerted:
    name, along = f"T_{rack.point}", cut.pose.moved_along(rack.point)
    pitch_point = Arm(cut.pose.radii[rack.radius], along - QUARTER)
    at = (*cut.pose.frames[rack.link][rack.pivot], pitch_point)
    return _exerted(
        JointForce("rack", (name,), (rack.pivot, rack.point)),
        _on_pin(name, rack.point, along, cut.points(rack.link), cut),
        [(rack.link, _at(name, along, at, Product(-1)))],
    )


def _thread(screw: Screw, cut: Cutting) -> Exerted:
    name = f"T_{screw.point}"
    lead = cut.pose.radii[screw.pitch] / to_product(PI).scaled(2)
    along = cut.pose.moved_along(screw.point)
    return _exerted(
        JointForce("thread", (name,), (screw.link, screw.point)),
        _on_pin(name, screw.point, along, cut.points(screw.link), cut),
        _couple(name, screw.link, -lead),
    )


def _rope(rope: Rope, cut: Cutting) -> Exerted:
    """Return the tension that draws the ends of each fall together."""
    name = f"S_{rope.route[0]}"
    falls = zip(pairwise(rope.route), cut.pose.falls[rope.id], strict=True)
    actions = [
        action
        for (tail, head), way in falls
        for point, size in ((tail, ONE), (head, Product(-1)))
        for action in _on_pin(name, point, way, rope.points, cut, size)
    ]
    return _exerted(JointForce("rope", (name,), rope.route[:1]), actions)


# -------------------------------------------------------------------------------------- loads


def _load(load: Load, owner: str, size: Product, cut: Cutting) -> Iterator[ActionOnBody]:
    if not load.pushes:
        for link in load.links:
            yield from _couple(owner, link, size)
    by = cut.points(load.host) or tuple(push.point for push in load.pushes)
    for link, point, sense in load.pushes:
        action = Action(owner, size if sense > 0 else -size, cut.pose.lines[load.name])
        yield from _loaded(action, link, point, by, cut)


def _loaded(
    action: Action, link: str, point: str, by: Iterable[str], cut: Cutting
) -> Iterator[ActionOnBody]:
    """Yield a load on a link at a point, or on the pin there."""
    assert action.along is not None, "what acts at a point is a force"
    if link in cut.rigid:
        yield link, _at(action.name, action.along, cut.pose.frames[link][point], action.size)
    else:
        yield from _on_pin(action.name, point, action.along, by, cut, action.size)


# ------------------------------------------------------------------------ what acts on a body


def _on_pin(
    name: str, point: str, along: Angle, by: Iterable[str], cut: Cutting, size: Product = ONE
) -> Iterator[ActionOnBody]:
    """Yield what goes through some points, and acts on what carries a pin."""
    host = cut.host(point) or point
    arm = cut.pose.frames[host][point] if host in cut.rigid else ()
    often = cut.repeats(cut.rigid.get(host, (point,)), by)
    yield host, _at(name, along, arm, size.scaled(often), point)


def _at(name: str, along: Angle, at: Vector, size: Product = ONE, pin: str = "") -> Action:
    return Action(name, size, along, gathered(at), pin)


def _couple(name: str, body: str, size: Product) -> Iterator[ActionOnBody]:
    """Yield a couple on a body; the ground, '', takes it."""
    if body:
        yield body, Action(name, size, None)
