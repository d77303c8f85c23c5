"""Remarks on what friction takes for granted: a pin's link, a joint at rest that has none."""

from collections.abc import Iterable, Iterator, Mapping
from types import UnionType
from typing import Final

from ..algebra.sums import add
from ..diagnostics import Diagnostic
from ..diagnostics import friction as messages
from ..formula.evaluate import evaluate
from ..formula.tree import ZERO
from ..formula.walk import symbols
from ..kinematics.joint_refs import JointRef
from ..kinematics.plan import Plan
from ..model.dependence import in_geometry
from ..model.mechanism import Load, LoadForm, LoadRatio, Mechanism, WithFriction
from ..model.parts.friction import (
    CollarFriction,
    FaceFriction,
    GuideFriction,
    JointFriction,
    PinFriction,
    PivotFriction,
    RopeFriction,
    ThreadFriction,
    WheelFriction,
)
from ..model.values import completed
from ..pose.pose import Pose
from ..power.numbers import default_values
from ..power.reactions import Reactions
from ..source import Span
from . import at_rest
from .friction_pairs import FrictionPair, GivenForces, LoadedPair
from .signs.senses import sense_of

AT_REST: Final[Mapping[str, tuple[type[JointFriction] | UnionType, str]]] = {
    "guide": (GuideFriction, "the joint at {} does not slide"),
    "face": (FaceFriction, "the joint at {} does not slide"),
    "gear": (WheelFriction, "the gear at {} does not turn"),
    "belt": (WheelFriction, "the belt at {} does not move"),
    "rack": (WheelFriction, "the rack at {} does not move"),
    "screw": (ThreadFriction, "the screw at {} does not turn"),
    "collar": (CollarFriction | PivotFriction, "the collar at {} does not turn"),
    "rope": (RopeFriction, "the rope at {} does not slide"),
}
"""What is said of a pair without slip, by what its name ends in: a pin's ends in a link, if any."""


def remarks_on_fast_pins(
    pose: Pose, driving: str, given: GivenForces, *, exact: bool
) -> Iterator[Diagnostic]:
    """Yield a remark on each pin whose friction depends on the link that it is fast in.

    Between two links it does not where they press the pin alike, however both turn: then the
    formula is ``exact`` for either of them. A pair of forces that is said to have no pins where
    all others have friction (W243) is not spoken of again.
    """
    mechanism = pose.mechanism
    known = mechanism.pairs_at_pins() if mechanism.friction.everywhere else ()
    for pin in mechanism.friction.joints:
        if not isinstance(pin, PinFriction) or not pin.assumed or pin.radius == ZERO:
            continue
        bodies = mechanism.turning_at(pin.point)
        others = bool([t for t in pose.contacts if t.point == pin.point])
        acting = [load for load in mechanism.loads if acts_on_pin(load, pin.point)]
        if len(bodies) + others > 2 and not acting:
            yield messages.pin_fast_in(pin.span, pin.point, pin.carrier, bodies)
        elif acting and not (exact and len(bodies) == 2 and _alike(pin, pose, driving, given)):
            for load in (load for load in acting if load not in known):
                yield messages.load_on_a_pin(load.span, load.name, pin.point, pin.carrier, bodies)


def asks_for_loads(mechanism: Mechanism) -> bool:
    """Return whether a load or a ratio with friction is asked for, which remarks on pins itself."""
    targets = (find.target for find in mechanism.finds)
    return any(
        isinstance(t, WithFriction) and isinstance(t.of, LoadRatio | LoadForm) for t in targets
    )


def acts_on_pin(load: Load, point: str) -> bool:
    """Return whether a load acts on a pin, and on none of the bodies there."""
    return ("", point) in load.ends


def _alike(pin: PinFriction, pose: Pose, driving: str, given: GivenForces) -> bool:
    """Return whether two links press a pin equally hard, whatever the pose."""
    reactions = Reactions(pose, (driving,))
    squares = []
    for body in pose.mechanism.turning_at(pin.point):
        found = reactions.of(JointRef("pin", pin.point, body))
        if found is None:
            return False
        parts = [
            add(push.amounts[n] * size for n, size in given.items() if n in push.amounts)
            for push in found.force_terms
        ]
        squares.append(add(part * part for part in parts))
    first, second = squares
    return not add((first, -second))


def remarks_on_pairs_at_rest(loaded: Iterable[LoadedPair], plan: Plan) -> Iterator[Diagnostic]:
    """Yield a remark on each pressed pair that does not slip at the only pose there is.

    Where a drive or an angle moves the links a slip that is zero is so at any pose, or is seen to
    be zero at one of them alone.
    """
    mechanism = plan.graph.pose.mechanism
    moving = in_geometry(mechanism).intersection(at_rest.followed(mechanism))
    if mechanism.drive is not None or moving or not mechanism.links:
        return
    known = completed(default_values(plan), [(b.name, b.value.formula()) for b in plan.bindings])
    for each in loaded:
        sense = sense_of(each.slip)
        if symbols(sense) <= known.keys() and evaluate(sense, known) == 0:
            at, said = _place(each.pair, mechanism)
            crank = _crank(mechanism) if mechanism.drawn else ""
            yield messages.no_slip_as_drawn(at, said, crank)


def _place(pair: FrictionPair, mechanism: Mechanism) -> tuple[Span, str]:
    """Return where friction of a pair is given, and what is said of the pair."""
    point, _, surface = pair.name.partition("_")
    kinds, said = AT_REST.get(surface, (PinFriction, "the pin at {} does not turn"))
    joints = mechanism.friction.joints
    given = next(k for k in joints if k.point == point and isinstance(k, kinds))
    return given.span, said.format(point)


def _crank(mechanism: Mechanism) -> str:
    """Return two points of a link on a pivot, that first, else of any link."""
    fixed = mechanism.fixed
    link = min(mechanism.links, key=lambda link: fixed.isdisjoint(link.points))
    return "".join(sorted(link.points, key=lambda point: point not in fixed)[:2])
