"""Pairs of surfaces that have friction, and a unit of friction between them as a load."""

import math
from collections.abc import Iterator
from typing import Literal, assert_never

from ..base.frozen import frozen
from ..formula.evaluate import evaluate
from ..formula.tree import Formula
from ..model.mechanism import (
    ArcSlot,
    CollarFriction,
    FaceFriction,
    GuideFriction,
    JointFriction,
    PinFriction,
    PivotFriction,
    Rack,
    Rope,
    RopeFriction,
    Screw,
    ThreadFriction,
    WheelFriction,
    WheelPair,
)
from ..pose.pose import PointContact, evaluate_vector
from .assembly import GROUND, Action, Couple, Plane, PointForce, Wrench, direction
from .transfers import rope_forces
from .unfold import Unfolding


@frozen
class FrictionSurfaces:
    """Two surfaces: a unit of friction between them as a load, by what they are pressed.

    They are pressed by the forces of body ``by`` on pin ``on``, or on its own body; and by a
    friction of 1 in pairs ``besides``, as it acts, by so much more. Where there is a ``thrust``,
    that is all that presses them.
    """

    kind: Literal["pin", "guide", "face", "transmission", "rope"]
    name: str
    actions: tuple[Action, ...]
    by: str
    on: str
    factor: float
    besides: tuple[tuple[str, float], ...] = ()
    thrust: Formula | None = None


def pairs_of(unfolding: Unfolding) -> Iterator[FrictionSurfaces]:
    """Yield the pairs of surfaces that have friction."""
    for given in unfolding.pose.mechanism.friction.joints:
        yield from _of_joint(given, unfolding)


def _of_joint(given: JointFriction, unfolding: Unfolding) -> Iterator[FrictionSurfaces]:
    """Yield the pairs of surfaces of one joint with friction."""
    match given:
        case PinFriction():
            yield from _on_pin(given, unfolding)
        case GuideFriction(point, factor_):
            yield from _guide(point, evaluate(factor_, unfolding.values), unfolding)
        case WheelFriction(joint, factor=factor_):
            size = evaluate(factor_, unfolding.values)
            yield FrictionSurfaces("transmission", joint, _rim(joint, unfolding), joint, "", size)
        case ThreadFriction(joint, factor=factor_, thread=thread):
            size, diameter = (evaluate(f, unfolding.values) for f in (factor_, thread))
            actions = _along_thread(joint, diameter, unfolding)
            yield FrictionSurfaces("transmission", joint, actions, joint, "", size)
        case CollarFriction(joint, factor=factor_, radius=radius):
            size, arm = (evaluate(f, unfolding.values) for f in (factor_, radius))
            actions = _on_collar(joint, arm, unfolding)
            more = tuple(_thrusts(joint, unfolding))
            yield FrictionSurfaces(
                "transmission", f"collar of {joint}", actions, joint, "", size, more
            )
        case PivotFriction(point, link, factor_, radius, thrust):
            size, arm = (evaluate(f, unfolding.values) for f in (factor_, radius))
            name, couples = f"collar on {point}", unfolding.couple(link, arm)
            yield FrictionSurfaces("transmission", name, couples, link, point, size, thrust=thrust)
        case RopeFriction(joint, point, factor=factor_):
            size, forces = evaluate(factor_, unfolding.values), _around(given, unfolding)
            more = tuple(_along(given, unfolding))
            yield FrictionSurfaces("rope", f"pulley on {point}", forces, joint, "", size, more)
        case FaceFriction(point, factor_):
            yield _face(point, evaluate(factor_, unfolding.values), unfolding)
        case _:
            assert_never(given)


def _on_pin(given: PinFriction, unfolding: Unfolding) -> Iterator[FrictionSurfaces]:
    """Yield a pair for each body that turns on a pin, but for the one that the pin is fixed to."""
    point, carrier = given.point, given.carrier
    size = evaluate(given.radius, unfolding.values)
    for body in unfolding.turning_on(point):
        if body != carrier:
            couples = unfolding.turning(body, point, 1.0)
            back = unfolding.turning(carrier, point, -1.0) if carrier else ()
            yield FrictionSurfaces(
                "pin", f"pin {point} {body}", (*couples, *back), body, point, size
            )


def _thrusts(joint: str, unfolding: Unfolding) -> Iterator[tuple[str, float]]:
    """Yield by how much a friction of 1 in a screw's thread pushes the nut along the axis."""
    for given in unfolding.pose.mechanism.friction.joints:
        if isinstance(given, ThreadFriction) and given.joint == joint:
            diameter = evaluate(given.thread, unfolding.values)
            yield joint, _slope_of_thread(joint, diameter, unfolding)


def _along(given: RopeFriction, unfolding: Unfolding) -> Iterator[tuple[str, float]]:
    """Yield the part of the mean tension here from a friction of 1 on another pulley of a rope.

    Half of it pulls more behind that pulley, half of it less in front.
    """
    for other in unfolding.pose.mechanism.friction.joints:
        if isinstance(other, RopeFriction) and other.joint == given.joint and other != given:
            yield f"pulley on {other.point}", 0.5 if given.place > other.place else -0.5


def _guide(point: str, size: float, unfolding: Unfolding) -> Iterator[FrictionSurfaces]:
    """Yield a guide, but not one that copies share: their side forces cancel around the axis.

    On one that mirrored halves share they cancel by themselves, as both are there.
    """
    copies = unfolding.pose.mechanism.copies
    if copies and point in copies.sharing:
        return
    body = next((s.name for s in unfolding.pose.mechanism.slides_at(point)), point)
    push = unfolding.push(point, unfolding.direction_of_guide(point))
    yield FrictionSurfaces("guide", f"guide {point}", push, "guide", body, size)


def _face(point: str, size: float, unfolding: Unfolding) -> FrictionSurfaces:
    """Return the pair that pushes the pin along a face, and the body under it back there."""
    if found := unfolding.pose.mechanism.arc_at(point):
        rod, arc = found
        return _arc(point, size, rod.name, arc, unfolding)
    touch = next(t for t in unfolding.pose.contacts if t.point == point)
    along = direction(touch.normal.evaluate(unfolding.values)).turned()
    return FrictionSurfaces(
        "face", f"face {point}", _apart(touch, along, unfolding), touch.body, point, size
    )


def _arc(point: str, size: float, rod: str, arc: ArcSlot, unfolding: Unfolding) -> FrictionSurfaces:
    """Return the pair that turns a pin in a circular slot about the centre, and the link back.

    The wall gives N and μN across it: together R = N·√(1 + μ²), at r·μ/√(1 + μ²) of the centre.
    """
    couples = unfolding.turning(rod, arc.centre, 1.0), unfolding.turning(arc.link, arc.centre, -1.0)
    reach = evaluate(arc.radius, unfolding.values) * size / math.hypot(1.0, size)
    return FrictionSurfaces(
        "pin", f"face {point}", (*couples[0], *couples[1]), rod, arc.centre, reach
    )


# ---------------------------------------------------- a friction of 1, as it acts


def _rim(joint: str, unfolding: Unfolding) -> tuple[Action, ...]:
    """Return a unit force on the rim of a pair's first wheel, or on a rack, by the id."""
    match unfolding.pose.mechanism.joint(joint):
        case WheelPair(first_link=link, first_radius=radius, arm=arm):
            moment = evaluate(radius, unfolding.values)
            back = unfolding.couple(arm or GROUND, -moment)
            return (*unfolding.couple(link or GROUND, moment), *back)
        case Rack(point, link=link):
            return _by_link(link, point, unfolding.direction_of_guide(point), unfolding)
        case other:
            raise AssertionError(f"{other.id} has no rim")


def _along_thread(joint: str, diameter: float, unfolding: Unfolding) -> tuple[Action, ...]:
    """Return the friction on a thread that an axial force of 1 times 1 gives, on nut and screw.

    F/cos ψ along the thread, whose slope is tan ψ = p/(πd): F·tan ψ along the axis, and
    F·d/2 about it.
    """
    screw = _screw(joint, unfolding)
    slope = _slope_of_thread(joint, diameter, unfolding)
    along = unfolding.direction_of_guide(screw.point).times(slope)
    push = _by_link(screw.link, screw.point, along, unfolding)
    return (*push, *unfolding.couple(screw.link, diameter / 2))


def _on_collar(joint: str, radius: float, unfolding: Unfolding) -> tuple[Action, ...]:
    """Return the couple on a screw of a friction of 1 at the mean radius of its collar."""
    return unfolding.couple(_screw(joint, unfolding).link, radius)


def _around(friction: RopeFriction, unfolding: Unfolding) -> tuple[Action, ...]:
    """Return a friction of 1 on a pulley: half a pull more behind it, half less in front.

    A drum takes the moment of both.
    """
    rope = unfolding.pose.mechanism.joint(friction.joint)
    assert isinstance(rope, Rope), "friction of a rope is on a rope"
    tensions = [-0.5 if i < friction.place else 0.5 for i in range(len(rope.ways))]
    half = tuple(rope_forces(unfolding, rope, tensions))
    if friction.reach is not None:
        half = (*half, Couple(friction.link, evaluate(friction.reach, unfolding.values)))
    if unfolding.axis is None or all(map(unfolding.acts_on_shared, half)):
        return half
    return (*half, *map(unfolding.mirrored, half))


def _slope_of_thread(joint: str, diameter: float, unfolding: Unfolding) -> float:
    """Return tan ψ = p/(πd) of a thread."""
    return evaluate(_screw(joint, unfolding).pitch, unfolding.values) / (math.pi * diameter)


def _screw(joint: str, unfolding: Unfolding) -> Screw:
    screw = unfolding.pose.mechanism.joint(joint)
    assert isinstance(screw, Screw), "threads and collars are on screws"
    return screw


def _by_link(link: str, point: str, force: Plane, unfolding: Unfolding) -> tuple[Action, ...]:
    """Return a force on a point by each of the links that drive it: both halves may share it.

    The link of one of several copies gives the whole of it, whoever else pushes the point.
    """
    if unfolding.axis is None:
        return (PointForce(point, force.times(unfolding.part_of(link))),)
    if unfolding.is_shared(link):
        return unfolding.push(point, force)
    return PointForce(point, force), PointForce(unfolding.twin(point), unfolding.reflected(force))


def _apart(touch: PointContact, along: Plane, unfolding: Unfolding) -> tuple[Action, ...]:
    """Return a unit force on a pin and its reaction on the body under it, in both halves."""
    first = next(iter(unfolding.pose.frames[touch.body]))
    base = unfolding.arm(touch.body, first, touch.tail)
    reach = evaluate_vector(touch.reach, unfolding.values)
    x, y = base.x + reach[0], base.y + reach[1]
    back = Wrench(touch.body, along.times(-1), y * along.x - x * along.y)
    push: tuple[Action, ...] = (PointForce(touch.point, along), back)
    if unfolding.axis is None or all(map(unfolding.is_shared, (touch.point, touch.body))):
        return push
    return (*push, *map(unfolding.mirrored, push))
