"""Friction: ``friction …``, ``motion …``, ``efficiency …``."""

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import assert_never

from ...diagnostics.model import collars as collar_messages
from ...diagnostics.model import friction as messages
from ...diagnostics.model import reactions as reactions_messages
from ...formula.tree import Call, Formula, number, product, total
from ...source import Span
from ...syntax import ast
from ...units import LENGTH, NUMBER
from ..formulas.expressions import Reader
from ..mechanism import (
    Force,
    Load,
    Mechanism,
    Mesh,
    Rack,
    Screw,
    Slot,
    WheelPair,
)
from ..names.scope import DESCRIPTION, NameScope
from ..parts.friction import (
    CollarFriction,
    FaceFriction,
    Friction,
    GuideFriction,
    JointFriction,
    ThreadFriction,
    WheelFriction,
)
from ..statements import every, only
from . import collars, pulleys
from .coefficients import (
    LOSS,
    checked,
    coefficient,
    positive_length,
    shared_coefficients,
    value_of,
)
from .pins import Pins, remark_on_pairs

TransmissionFriction = (
    ast.GearFriction | ast.BeltFriction | ast.RackFriction | ast.ScrewFriction | ast.CollarFriction
)

FLATTEST, STEEPEST = 0.1, 40.0
"""Degrees below and beyond which hardly a thread climbs: a fast one of several starts has 36."""


def _kind_and_point(joint: JointFriction) -> tuple[object, ...]:
    """Return the kind and the point of a friction: one line alone may state it."""
    return type(joint), getattr(joint, "kind", ""), joint.point


def read_friction(file: ast.File, built: Mechanism, scope: NameScope) -> Friction:
    """Return the friction of all joints; report what names no joint, or names one twice."""
    points = [s.point for s in every(file, ast.PinFriction) if s.point]
    named = {point.text for point in points if scope.points.acting(point)}
    pins = Pins(named, built, scope)
    scope.shared = shared_coefficients(file.statements)
    found: dict[tuple[object, ...], JointFriction] = {}
    for statement in file.statements:
        joints = {_kind_and_point(j): j for j in _read(statement, file, pins, built, scope)}
        if again := next((key for key in joints if key in found), None):
            place, first = joints[again].span, found[again].span
            scope.report.add(messages.friction_again(place, joints[again].point, first))
        found |= joints
    _check_halves(found.values(), built, scope)
    _remark_on_blocks(found.values(), built, scope)
    motion, efficiency = only(file, ast.Motion), _efficiency(file, scope)
    sense = motion.sense if motion else "tightening"
    everywhere = any(s.point is None for s in every(file, ast.PinFriction))
    friction = Friction(tuple(found.values()), sense, efficiency, everywhere)
    if everywhere:
        remark_on_pairs(built, scope)
        _remark_on_slots(friction, built, scope)
    if motion and friction.is_ideal:
        scope.report.add(messages.motion_for_nothing(motion.span))
    return friction


def _remark_on_slots(friction: Friction, built: Mechanism, scope: NameScope) -> None:
    """Say which pins slide in slots without friction, though every pin is said to have it."""
    rough = {joint.point for joint in friction.joints if isinstance(joint, FaceFriction)}
    slots = [(slot.point, slot.span) for slot in built.each(Slot)]
    slots += [(link.points[1], link.arc.span) for link in built.links if link.arc]
    for point, span in slots:
        if point not in rough:
            scope.report.add(messages.slot_without_friction(span, point))


def _remark_on_blocks(joints: Iterable[JointFriction], built: Mechanism, scope: NameScope) -> None:
    """Say that the couple which a block passes on gives no friction of its own."""
    guiding = {slot.point: slot.guided for slot in built.each(Slot) if slot.guided}
    for joint in joints:
        if isinstance(joint, FaceFriction) and joint.point in guiding:
            scope.report.add(messages.couple_without_friction(joint.span, guiding[joint.point]))


def _check_halves(joints: Iterable[JointFriction], built: Mechanism, scope: NameScope) -> None:
    """Remark on guides whose side forces cancel, or would in a whole that is drawn by half."""
    for joint in joints:
        if isinstance(joint, GuideFriction) and joint.point in built.shared:
            scope.report.add(messages.halves_cancel(joint.span, joint.point))
        elif isinstance(joint, GuideFriction) and not built.shared:
            _check_half(joint, built, scope)


def _check_half(joint: GuideFriction, built: Mechanism, scope: NameScope) -> None:
    """Refuse a guide that halves would share: what acts on it counts less often than the rest.

    A guide with the load that counts most is the half's own. One without a load is open.
    """
    body = next((slide.points for slide in built.slides_at(joint.point)), (joint.point,))
    own = [k for k in built.loads if isinstance(k, Force) and k.point in body]
    counted = [k for k in built.loads if k.times != 1]
    if not own and counted:
        scope.report.add(messages.perhaps_a_half(joint.span, joint.point, counted[0].name))
    if own:
        here, most = min(own, key=_times), max(built.loads, key=_times)
        if most.times > here.times:
            share = most.times / here.times
            found = messages.half_of_a_whole(joint.span, joint.point, here.name, most.name, share)
            scope.report.add(found)


def _times(load: Load) -> Fraction:
    return load.times


def _read(
    statement: ast.Statement, file: ast.File, pins: Pins, built: Mechanism, scope: NameScope
) -> Iterator[JointFriction]:
    """Yield the friction that a statement gives to joints, none of a statement of other kinds."""
    match statement:
        case ast.PinFriction():
            yield from pins.read(statement)
        case ast.GuideFriction():
            yield from _guide(statement, built, scope)
        case ast.RollerFriction():
            yield from _roller(statement, built, scope)
        case ast.ContactFriction():
            yield from _face(statement, scope)
        case ast.CollarFriction(point=point) if point.text in scope.points.fixed:
            if collar := collars.read_collar(statement, built, scope):
                yield collar
        case ast.RopeFriction():
            if rope := pulleys.read_rope_friction(statement, built, scope):
                yield rope
        case (
            ast.GearFriction()
            | ast.BeltFriction()
            | ast.RackFriction()
            | ast.ScrewFriction()
            | ast.CollarFriction()
        ):
            yield from _transmission(statement, file, built, scope)
        case _:
            return


# ------------------------------------------------------------ guides, rollers, faces


def _guide(
    statement: ast.GuideFriction, built: Mechanism, scope: NameScope
) -> Iterator[JointFriction]:
    """Yield the friction of a guide, larger where the slider is tilted."""
    f = coefficient(statement.coefficient, statement.point.text, scope)
    if not _is_guided(statement.point, built, scope) or f is None:
        return
    tilt: Formula | None = number(1)
    if statement.length and statement.overhang:
        tilt = _tilt(statement, (statement.overhang, statement.length), scope)
    if tilt is not None:
        factor = product([(f, 1), (tilt, 1)])
        yield GuideFriction(statement.point.text, factor, statement.span)


def _tilt(
    statement: ast.GuideFriction, lengths: tuple[ast.Expr, ast.Expr], scope: NameScope
) -> Formula | None:
    """Return by what a plunger that tilts in its guide presses harder than its side force.

    With x the overhang over the length of the guide, taken from its middle: ``couple`` is
    the couple part of a linear pressure, 3x; ``linear`` all of it, 3x + 1/(12x) once the
    pressure reaches both sides (x > 1/6); ``edges`` contact at both ends, 2x once x > 1/2.
    """
    overhang = positive_length(lengths[0], "the overhang of a plunger", scope)
    length = positive_length(lengths[1], "the length of a guide", scope)
    if length is None or overhang is None:
        return None
    point = statement.point.text
    overhang = scope.named("l", point, overhang, LENGTH, lengths[0].span)
    length = scope.named("L", point, length, LENGTH, lengths[1].span)
    x = product([(overhang, 1), (length, -1)])
    share = value_of(x, scope)
    match statement.law:
        case "linear":
            wide = x if share and share > 1 / 6 else Call("max", (x, number(Fraction(1, 6))))
            couple = product([(number(3), 1), (wide, 1)])
            return total([couple, product([(number(12), -1), (wide, -1)])])
        case "edges":
            twice = product([(number(2), 1), (x, 1)])
            return twice if share and share > 1 / 2 else Call("max", (twice, number(1)))
        case _:
            if share is not None and share < 1 / 3:
                scope.report.add(messages.less_than_plain(statement.span, share))
            return product([(number(3), 1), (x, 1)])


def _roller(
    statement: ast.RollerFriction, built: Mechanism, scope: NameScope
) -> Iterator[JointFriction]:
    """Yield the friction of a roller: that of its axle, as much smaller as the axle is."""
    f = coefficient(statement.coefficient, statement.point.text, scope)
    axle = positive_length(statement.axle, "the diameter of an axle", scope)
    wheel = positive_length(statement.wheel, "the diameter of a roller", scope)
    point = statement.point.text
    if not _is_guided(statement.point, built, scope) or f is None or axle is None or wheel is None:
        return
    thick, wide = value_of(axle, scope), value_of(wheel, scope)
    if thick is not None and wide is not None and thick >= wide:
        scope.report.add(messages.axle_fills_roller(statement.axle.span, thick, wide))
        return
    axle = scope.named("d", point, axle, LENGTH, statement.axle.span, "axle")
    wheel = scope.named("D", point, wheel, LENGTH, statement.wheel.span, "wheel")
    factor = product([(f, 1), (axle, 1), (wheel, -1)])
    yield GuideFriction(statement.point.text, factor, statement.span)


def _face(statement: ast.ContactFriction, scope: NameScope) -> Iterator[JointFriction]:
    """Yield the friction of a pin in the one slot or contact that it has."""
    f = coefficient(statement.coefficient, statement.point.text, scope)
    if not scope.points.acting(statement.point) or f is None:
        return
    point = statement.point
    touching = scope.points.touching[point.text]
    if touching == 1:
        yield FaceFriction(point.text, f, statement.span)
    elif touching:
        scope.report.add(reactions_messages.several_in_contact(point.span, point.text))
    else:
        scope.report.add(messages.nothing_in_contact(point.span, point.text))


def _transmission(
    statement: TransmissionFriction,
    file: ast.File,
    built: Mechanism,
    scope: NameScope,
) -> Iterator[JointFriction]:
    """Return the friction of a pair by its first wheel, of a rack or screw by its slider."""
    slides = isinstance(statement, ast.ScrewFriction | ast.CollarFriction)
    f = coefficient(statement.coefficient, statement.point.text, scope, "" if slides else LOSS)
    point = statement.point
    if not scope.points.acting(point) or f is None:
        return
    word, begun, joints = _transmissions(statement, file, built)
    here = [joint for joint in joints if joint.points[0] == point.text]
    if not here and point.text in begun:
        return  # what is wrong with that line was reported
    if not here:
        there = sorted(joint.points[0] for joint in joints)
        what = "collar" if isinstance(statement, ast.CollarFriction) else word
        scope.report.add(messages.no_transmission(point.span, word, what, point.text, there))
    elif len(here) > 1:
        scope.report.add(messages.several_transmissions(point.span, word, point.text))
    elif not isinstance(here[0], Screw):
        yield WheelFriction(here[0].id, here[0].kind, point.text, f, statement.span)
    elif isinstance(statement, ast.ScrewFriction):
        yield from _in_thread(statement, here[0], f, scope)
    elif isinstance(statement, ast.CollarFriction):
        yield from _on_collar(statement, here[0], f, scope)


def _in_thread(
    statement: ast.ScrewFriction, screw: Screw, f: Formula, scope: NameScope
) -> Iterator[JointFriction]:
    point, span = statement.point.text, statement.span
    thread = positive_length(statement.thread, "the mean diameter of a thread", scope)
    if thread is not None:
        _remark_on_lead(screw, thread, statement.thread.span, scope)
        thread = scope.named("d", point, thread, LENGTH, span, "thread")
        yield ThreadFriction(screw.id, point, f, thread, span)


def _on_collar(
    statement: ast.CollarFriction, screw: Screw, f: Formula, scope: NameScope
) -> Iterator[JointFriction]:
    point = statement.point.text
    radius = collars.collar_radius(statement, scope)
    if statement.thrust is not None:
        scope.report.add(collar_messages.thrust_of_a_screw(statement.thrust.span, point))
    elif radius is not None:
        yield CollarFriction(screw.id, point, f, radius, statement.span)


def _remark_on_lead(screw: Screw, thread: Formula, span: Span, scope: NameScope) -> None:
    """Say that a thread climbs more steeply, or less, than any usual one."""
    pitch, diameter = value_of(screw.pitch, scope), value_of(thread, scope)
    if pitch is None or diameter is None:
        return
    climb = math.degrees(math.atan2(abs(pitch), math.pi * diameter))
    if climb > STEEPEST or 0 < climb < FLATTEST:
        bound = f"less than {STEEPEST:g}" if climb > STEEPEST else f"more than {FLATTEST:g}"
        scope.report.add(messages.strange_thread(span, screw.point, climb, diameter, bound))


def _transmissions(
    statement: TransmissionFriction,
    file: ast.File,
    built: Mechanism,
) -> tuple[str, set[str], Sequence[Mesh]]:
    """Return the word for a kind, the points at which its lines begin, and the sound ones."""
    pairs = built.each(WheelPair)
    match statement:
        case ast.GearFriction():
            begun = {s.first.text for s in every(file, ast.Gear)}
            return "gear", begun, [pair for pair in pairs if pair.kind == "gear"]
        case ast.BeltFriction():
            begun = {s.first.text for s in every(file, ast.Belt)}
            return "belt", begun, [pair for pair in pairs if pair.kind == "belt"]
        case ast.RackFriction():
            return "rack", {s.point.text for s in every(file, ast.Rack)}, built.each(Rack)
        case ast.ScrewFriction() | ast.CollarFriction():
            return "screw", {s.point.text for s in every(file, ast.Screw)}, built.each(Screw)
        case _:
            assert_never(statement)


def _is_guided(point: ast.Name, built: Mechanism, scope: NameScope) -> bool:
    """Return whether a point is on a guide that something presses; report where it is not."""
    if not scope.points.acting(point):
        return False
    if any(point.text in slide for slide in scope.points.slides):
        return True
    if point.text in scope.points.guided:
        held = scope.points.carried.keys() | scope.points.touching.keys()
        is_loaded = point.text in held or any(point.text in k.points for k in built.loads)
        if not is_loaded:
            scope.report.add(messages.nothing_presses(point.span, point.text))
        return is_loaded
    slotted = {slot.point for slot in built.each(Slot)} | scope.points.arcs.keys()
    in_slot = point.text in slotted
    scope.report.add(messages.not_guided(point.span, point.text, in_slot))
    return False


def _efficiency(file: ast.File, scope: NameScope) -> Formula | None:
    statement = only(file, ast.Efficiency)
    if statement is None:
        return None
    what, value = "an efficiency", statement.value
    formula = Reader(scope, DESCRIPTION).wanted(value, NUMBER, what)
    return checked(formula, value.span, what, lambda v: 0 < v <= 1, scope)
