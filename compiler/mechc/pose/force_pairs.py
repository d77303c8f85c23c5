"""The line of a pair of forces, and the distance between its points."""

import math

from ..algebra.angle import HALF_TURN, QUARTER, Angle
from ..algebra.product import Product
from ..algebra.sums import add
from ..algebra.trigonometry import sine
from ..base.named import NamedTuple
from ..diagnostics import Report
from ..diagnostics import pose as messages
from ..diagnostics import power as power_words
from ..model.mechanism import ForcePair, Mechanism, Pivot
from .pose import Arm, PoseDefinition, Vector, evaluate_vector
from .samples import is_behind, poses_nearby
from .terms import AlgebraicTerms
from .vector_graph import mentioned
from .vectors import Vectors


class Pairing(NamedTuple):
    """What it takes to place a pair: the vectors, the mirror line, where to report."""

    mechanism: Mechanism
    terms: AlgebraicTerms
    vectors: Vectors
    axis: Angle | None
    report: Report


def thrust_line(thrust: ForcePair, pairing: Pairing) -> Angle:
    """Return the direction in which a pair pushes its second point.

    Across the mirror it is the direction in which it pushes the first point away from the
    line. The distance of a spring's points becomes a definition of the pose.
    """
    if thrust.joins_twins and pairing.axis is not None:
        return _across(thrust, pairing, pairing.axis)
    vector = pairing.vectors.path(thrust.first, thrust.second)
    if not vector:
        pairs = f"{thrust.first}{thrust.second}"
        what = f"the {'spring' if thrust.spring else 'actuator'} {thrust.name}"
        unplaced = _without_place(thrust, pairing)
        pairing.report.add(messages.missing_direction(thrust.span, pairs, what, unplaced=unplaced))
        return Angle()
    if _lacks_length(thrust, vector, pairing):
        return Angle()
    if len(vector) > 1 and pairing.vectors.is_open(vector):
        pairs = f"{thrust.first}{thrust.second}"
        pairing.report.add(messages.no_direction_of_its_own(thrust.span, pairs))
        return Angle()
    if len(vector) > 1:
        pairing.vectors.straighten(thrust.first, thrust.second)
        vector = pairing.vectors.path(thrust.first, thrust.second) or vector
    (arm,) = vector
    return _along(thrust, arm, pairing)


def _without_place(thrust: ForcePair, pairing: Pairing) -> str:
    """Return a pivot without a place from which vectors lead to an end of a pair, '' for none."""
    path, pivots = pairing.vectors.path, pairing.mechanism.each(Pivot)
    for end in (thrust.first, thrust.second):
        if path(end, "") is None:
            near = next((p.point for p in pivots if path(end, p.point) is not None), "")
            if near:
                return near
    return ""


def _lacks_length(thrust: ForcePair, vector: Vector, pairing: Pairing) -> bool:
    """Report a spring whose points are at a distance that is not given."""
    if not thrust.spring or not pairing.vectors.is_open(vector):
        return False
    points = {n.removeprefix("len_") for n in mentioned(vector) & {*pairing.vectors.placeholders}}
    what = f"the spring {thrust.name}"
    pairing.report.add(power_words.length_not_given(thrust.span, what, sorted(points)))
    return True


def _along(thrust: ForcePair, arm: Arm, pairing: Pairing) -> Angle:
    """Return the direction of the arm between the points, turned if it ends behind its start."""
    poses = poses_nearby(pairing.mechanism, pairing.terms.definitions)
    behind = is_behind(arm.length, poses)
    _define_length(thrust, -arm.length if behind else arm.length, pairing)
    return arm.angle + HALF_TURN if behind else arm.angle


def _define_length(thrust: ForcePair, length: Product, pairing: Pairing) -> None:
    name = f"len_{thrust.first}{thrust.second}"
    known = {*pairing.vectors.placeholders, *(d.name for d in pairing.terms.definitions)}
    known |= {literal.name for literal in pairing.mechanism.literals}
    if thrust.spring and name not in known:
        pairing.terms.definitions.append(PoseDefinition(name, length.formula()))


def _across(thrust: ForcePair, pairing: Pairing, axis: Angle) -> Angle:
    """Return the normal of the mirror line on the side of the first point."""
    mirror = pairing.mechanism.mirror
    shared = mirror.sharing if mirror else ()
    paths = (pairing.vectors.path(point, thrust.first) for point in shared)
    vector = next((v for v in paths if v), None)
    if vector is None and not shared:
        pairing.report.add(messages.side_of_the_mirror(thrust.span, thrust.first, thrust.name))
        return axis + QUARTER
    if vector is None:
        what = f"the side of {thrust.first} on which {thrust.name} pushes it"
        pairs = f"{shared[0]}{thrust.first}"
        pairing.report.add(messages.missing_direction(thrust.span, pairs, what))
        return axis + QUARTER
    if _lacks_length(thrust, vector, pairing):
        return axis + QUARTER
    away = add(arm.length * sine(arm.angle - axis) for arm in vector)
    if _is_left(vector, axis, pairing):
        _define_length(thrust, away.scaled(2), pairing)
        return axis + QUARTER
    _define_length(thrust, away.scaled(-2), pairing)
    return axis + QUARTER + HALF_TURN


def _is_left(vector: Vector, axis: Angle, pairing: Pairing) -> bool:
    """Return on which side of the mirror line a vector ends, at the default pose."""
    poses = poses_nearby(pairing.mechanism, pairing.terms.definitions)
    open_lengths = dict.fromkeys(pairing.vectors.placeholders, 1.0)
    for values in poses:
        try:
            x, y = evaluate_vector(vector, {**open_lengths, **values})
            normal = (axis + QUARTER).evaluate(values)
        except KeyError:
            continue
        return x * math.cos(normal) + y * math.sin(normal) >= 0
    return True
