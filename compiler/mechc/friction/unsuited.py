"""What is asked for and has no answer with friction, whatever the pose."""

from collections.abc import Iterable, Iterator

from ..diagnostics import Diagnostic
from ..diagnostics import friction as messages
from ..diagnostics import reactions as reaction_messages
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..kinematics.joint_refs import unclear
from ..model.mechanism import Efficiency, Find, LoadRatio, Mechanism, PinFriction, WithFriction
from ..power.balance import Equations
from .pairs import FrictionPair


def unsuited(
    find: Find,
    driving: str,
    pairs: Iterable[FrictionPair],
    mechanism: Mechanism,
    equations: Equations,
) -> Iterator[Diagnostic]:
    """Yield an error for each pair of surfaces that is pressed as no result can say."""
    pressed_on = unclear(mechanism)
    lines = {k.point: k.span for k in mechanism.friction.joints if isinstance(k, PinFriction)}
    for pair in pairs:
        point = pair.joint.point
        if pair.thrust is not None:
            yield from _thrust(find, driving, point, pair.thrust, equations)
        elif pair.joint.kind == "pin" and point in pressed_on:
            yield reaction_messages.transmission_presses(
                lines.get(point, find.span), point, has_friction=True
            )


def _thrust(
    find: Find, driving: str, point: str, thrust: Formula, equations: Equations
) -> Iterator[Diagnostic]:
    """Yield an error for a thrust that spoils a ratio, or that the driving load itself makes."""
    loads = symbols(thrust) & equations.owners.keys()
    if any(equations.owner(load)[0] == driving for load in loads):
        yield messages.thrust_of_the_drive(find.span, point, driving)
    elif not loads and _is_ratio(find):
        given = f"the given thrust at {point}"
        yield messages.another_load_presses(find.span, given, find.name)


def _is_ratio(find: Find) -> bool:
    """Return whether a ratio of two loads is asked for with friction."""
    target = find.target
    return isinstance(target, WithFriction | Efficiency) and isinstance(target.of, LoadRatio)
