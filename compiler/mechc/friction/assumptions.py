"""Pins that are taken to be fast in a link: where another link would give another friction."""

from collections.abc import Iterator

from ..algebra.sums import add
from ..diagnostics import Diagnostic
from ..diagnostics import friction as messages
from ..formula.tree import ZERO
from ..kinematics.joint_refs import JointRef
from ..model.mechanism import (
    Load,
    LoadForm,
    LoadRatio,
    Mechanism,
    PinFriction,
    WithFriction,
)
from ..pose.pose import Pose
from ..power.reactions import Reactions
from .pairs import GivenForces


def assumptions(
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
