"""Wheels at a pose: the values of their radii, and whether gears reach one another."""

import math
from collections.abc import Iterator

from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Mechanism, RopeFriction, WheelPair
from ..named import NamedTuple
from ..source import Span
from .pose import Pose, evaluate_vector
from .samples import Values
from .tolerances import CENTRE_GAP
from .vector_graph import mentioned
from .vectors import Vectors


class Misfit(NamedTuple):
    """A pair of gears, how far its centres are apart and how far its radii put them.

    ``meant`` is what they would fit as: "inner" or "outer" gears, "diameters", or ''.
    """

    at: Span
    pivots: str
    apart: float
    wanted: float
    meant: str


def radii(mechanism: Mechanism) -> Iterator[Formula]:
    """Yield the radius of every wheel, drum and circular slot and the pitch of every screw."""
    yield from (link.arc.radius for link in mechanism.links if link.arc)
    for joint in mechanism.joints:
        yield from (size.formula for size in joint.sizes)
    for friction in mechanism.friction.joints:
        if isinstance(friction, RopeFriction) and friction.reach is not None:
            yield friction.reach


def misfits(pose: Pose, vectors: Vectors, values: Values) -> Iterator[Misfit]:
    """Yield the gears whose centres have places that do not fit their radii."""
    for mesh in pose.mechanism.each(WheelPair):
        line = vectors.path(mesh.first, mesh.second)
        lengths = [pose.radii[r] for r in (mesh.first_radius, mesh.second_radius)]
        used = {s for length in lengths for s in symbols(length.formula())}
        if mesh.kind != "gear" or not line or not used | set(mentioned(line)) <= values.keys():
            continue
        first, second = (length.evaluate(values) for length in lengths)
        apart = math.hypot(*evaluate_vector(line, values))
        outer, inner = first + second, abs(first - second)
        wanted, other = (inner, outer) if mesh.same else (outer, inner)
        if not _near(apart, wanted):
            meant = ("outer" if mesh.same else "inner") if _near(apart, other) else ""
            meant = "diameters" if _near(apart, wanted / 2) else meant
            yield Misfit(mesh.span, f"{mesh.first} and {mesh.second}", apart, wanted, meant)


def _near(apart: float, wanted: float) -> bool:
    return abs(apart - wanted) <= CENTRE_GAP * apart
