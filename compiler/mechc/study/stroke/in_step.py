"""Whether the directions given follow the drive as rods, wheels and guides demand.

A direction that is given and not closed stays where it is when the drive moves, unless its
formula has the drive in it. All links must turn along the stroke as the velocities say.
"""

import math
from collections.abc import Iterator, Mapping

from ...algebra.angle import Angle
from ...base.named import NamedTuple
from ...diagnostics import Report
from ...diagnostics import stroke as messages
from ...formula.walk import symbols
from ...kinematics.plan import Plan
from ...model.entries import direction_matters, points_of
from ...model.mechanism import Arrow, Link, Mechanism, Slider
from ...pose.pose import Pose, Vector, evaluate_vector
from ..pose_sweep import PoseCode, PoseSweep
from ..tolerances import DIFFERENCE, SAME_RATE

LinkRates = Mapping[str, float]
"""How fast each link turns."""


class LinkOutOfStep(NamedTuple):
    """A link that does not turn as the drive demands, or in which an angle changes."""

    link: Link
    bent: str
    """The angle in it that changes, by three pins, the middle one at its vertex; '' for none."""


def remark(plan: Plan, report: Report) -> tuple[Link, ...]:
    """Return the links that do not follow the drive at its default, with W591 or W592.

    Of links whose directions loops give and others, the others are the cause: they alone are named.
    """
    mechanism = plan.graph.pose.mechanism
    if mechanism.drive is None:
        return ()
    found = [x for x in out_of_step(plan) if direction_matters(x.link, mechanism)]
    drive = mechanism.drive.parameter
    own = [x for x in found if x.bent or _is_given(x.link, mechanism)]
    for link, bent in own or found:
        if bent:
            report.add(messages.link_bends(link.span, link.name, bent, drive))
        else:
            guided = _guided_anywhere(link, mechanism)
            report.add(messages.direction_stays(link.span, link.name, drive, guided))
    return tuple(one.link for one in found)


def _guided_anywhere(link: Link, mechanism: Mechanism) -> str:
    """Return the point of a link whose guide is a direction without a place, '' for none."""
    guides = (s for s in mechanism.each(Slider) if not s.through and s.point in link.points)
    return next((s.point for s in guides), "")


def _is_given(link: Link, mechanism: Mechanism) -> bool:
    """Return whether the description gives a direction in a link, by a vector or an angle."""
    for entry in mechanism.geometry:
        points = {*link.points} & {*points_of(entry)}
        is_length = isinstance(entry, Arrow) and entry.direction is None
        if len(points) > 1 and not is_length:
            return True
    return False


def out_of_step(plan: Plan) -> tuple[LinkOutOfStep, ...]:
    """Return the links that do not follow the drive at its default, whether it matters or not."""
    found = at_default(plan)
    return tuple(links_out_of_step(plan, *found)) if found else ()


def at_default(plan: Plan) -> tuple[PoseSweep, float] | None:
    """Return the default pose as a value of the drive, None where nothing is to be seen there."""
    pose = plan.graph.pose
    drive = pose.mechanism.drive
    if drive is None or drive.reshapes or plan.mobility != 1:
        return None
    along = PoseSweep(PoseCode(plan), drive.parameter)
    x = along.defaults.get(drive.parameter)
    if x is None or not _mentioned(pose) <= along.names:
        return None
    steps = (-2 * DIFFERENCE, -DIFFERENCE, 0, DIFFERENCE, 2 * DIFFERENCE)
    stands = not any(along.trouble(x + step) for step in steps)
    return (along, x) if stands and _is_smooth(pose, along, x) else None


def _is_smooth(pose: Pose, along: PoseSweep, x: float) -> bool:
    """Return whether differences show how fast links turn: next to the end of a loop they do not.

    One over twice the step is then the same.
    """
    links = pose.mechanism.links
    near, far = (
        [_turning(pose, link, along, x, step) for link in links]
        for step in (DIFFERENCE, 2 * DIFFERENCE)
    )
    fastest = max(map(abs, near), default=0.0)
    return all(abs(b - a) <= SAME_RATE * fastest for a, b in zip(near, far, strict=True))


def links_out_of_step(plan: Plan, along: PoseSweep, x: float) -> Iterator[LinkOutOfStep]:
    """Yield the links that do not follow the drive at a value of it."""
    pose = plan.graph.pose
    drawn = {link.name: _turning(pose, link, along, x) for link in pose.mechanism.links}
    demanded, doubled = (_demanded(plan, along.values(x), size) for size in (1.0, 2.0))
    leader = _leader(pose, drawn)
    if not demanded or not demanded.get(leader):
        return
    pace = drawn[leader] / demanded[leader]
    for link in pose.mechanism.links:
        here, there = drawn[link.name], demanded[link.name] * pace
        if not math.isclose(demanded[link.name], doubled[link.name], rel_tol=SAME_RATE):
            # Its length is open: only whether it turns is known.
            here, there = float(abs(here) > SAME_RATE), float(abs(there) > SAME_RATE)
        fastest = max(abs(there), *map(abs, drawn.values()))
        bent = _bent(pose, link, along, x, fastest)
        if bent or abs(here - there) > SAME_RATE * fastest:
            yield LinkOutOfStep(link, bent)


def _mentioned(pose: Pose) -> set[str]:
    """Return the names that the links' vectors rest on: all must have values."""
    vectors = (vector for frame in pose.frames.values() for vector in frame.values())
    return {
        name
        for vector in vectors
        for arm in vector
        for name in (*symbols(arm.length.formula()), *arm.angle.names)
    }


def _turning(pose: Pose, link: Link, along: PoseSweep, x: float, step: float = DIFFERENCE) -> float:
    """Return how fast a link turns in the drawing, per unit of the drive.

    The point that turns fastest counts: others may stand for what a part touches just now.
    """
    before, after = along.values(x - step), along.values(x + step)
    first, *others = link.points
    turns = [_turn(pose.vector(link.name, first, point), before, after) for point in others]
    return max(turns, key=abs) / (2 * step)


def _bent(pose: Pose, link: Link, along: PoseSweep, x: float, fastest: float) -> str:
    """Return the angle in a link that changes most, as its pins turn at different rates, else ''.

    A point that has a load alone may stand for what the link touches just now.
    """
    before, after = along.values(x - DIFFERENCE), along.values(x + DIFFERENCE)
    held = pose.mechanism.fixed | {slider.point for slider in pose.mechanism.each(Slider)}
    others = {p for body in pose.mechanism.bodies if body is not link for p in body.points}
    pins = [p for p in link.points if p in held | others]
    arms = {pin: pose.vector(link.name, pins[0], pin) for pin in pins[1:]}
    turns = {pin: _turn(arm, before, after) / (2 * DIFFERENCE) for pin, arm in arms.items() if arm}
    if len(turns) < 2:
        return ""
    slowest, quickest = min(turns, key=turns.__getitem__), max(turns, key=turns.__getitem__)
    is_bent = turns[quickest] - turns[slowest] > SAME_RATE * fastest
    return f"{slowest}{pins[0]}{quickest}" if is_bent else ""


def _turn(arm: Vector, before: Mapping[str, float], after: Mapping[str, float]) -> float:
    """Return the angle from where a vector was to where it is."""
    (a, b), (c, d) = evaluate_vector(arm, before), evaluate_vector(arm, after)
    return math.atan2(a * d - b * c, a * c + b * d)


def _demanded(plan: Plan, known: Mapping[str, float], size: float) -> LinkRates:
    """Return how fast the links turn by the joints, lengths that are not given being ``size``."""
    values = {**known, **dict.fromkeys(plan.graph.pose.placeholders, size)}
    try:
        for name, value in plan.bindings:
            values[name] = value.evaluate(values)
        return plan.spins_at(values)
    except (KeyError, ZeroDivisionError):
        return {}


def _leader(pose: Pose, drawn: LinkRates) -> str:
    """Return the link that the drive turns: the crank, else the one that turns fastest.

    The crank's direction is the drive itself. Where no link's is, one counts whose formula has the
    drive in it.
    """
    drive = pose.mechanism.drive
    assert drive is not None
    crank = Angle.of(drive.parameter)
    angles = {
        name: {arm.angle for vector in frame.values() for arm in vector}
        for name, frame in pose.frames.items()
        if name in drawn
    }
    led = [n for n, found in angles.items() if any(drive.parameter in dict(a.terms) for a in found)]
    cranks = [name for name in led if crank in angles[name]] or led
    return max(cranks or drawn, key=lambda name: abs(drawn[name]), default="")
