"""Vectors between points that are placed already: they must fit, and then say nothing new."""

import math
from collections.abc import Iterable, Iterator

from ...algebra.angle import Angle, principal
from ...diagnostics import Diagnostic
from ...diagnostics import pose as messages
from ...formula.tree import Call
from ..pose import Arm, LoopKind, PoseDefinition, Vector, components, evaluate_vector, gathered
from ..tolerances import LOOP_GAP, SAME_PLACE
from ..vector_graph import Cycle, NameSet, loop_name, mentioned, points_around
from .dyad_sides import common_turn
from .dyads import Closure
from .recognition import familiar, recognised
from .state import LoopState


def check_fit(name: str, cycle: Cycle, state: LoopState) -> Diagnostic | None:
    """Take the one unknown of a loop, or return the error of a loop that does not close.

    The data may agree for all lengths (a parallelogram's third bar), or for those given.
    """
    known = gathered(a for e in cycle for a in e.arms if name not in mentioned((a,)))
    moving = [a for e in cycle for a in e.arms if name in mentioned((a,))]
    if name in state.angles:
        gaps = [_length_gap(known, moving, name, values) for values in _whole(known, state)]
    else:
        gaps = [_side_gap(known, moving, values) for values in _whole(known, state)]
    size, gap = gaps[0]
    if abs(gap) > LOOP_GAP * size:
        edge = max((e for e in cycle if name in mentioned(e.arms)), key=lambda e: e.span.start)
        points = loop_name(cycle)
        used = mentioned(tuple(a for e in cycle for a in e.arms))
        brought = sorted(used & state.mechanism.brought_angles)
        shown = f"{abs(gap) * 1000:.4g} mm"
        return messages.loop_does_not_close(edge.span, points, shown, brought)
    unknown = frozenset({name})
    closure = closure_of(name, known, moving, state)
    closure = recognised(closure, unknown, familiar(cycle, state), state)
    kind: LoopKind = "equal" if closure.alike else "vector"
    state.take(closure, unknown, [], kind, points_around(cycle))
    return None


def _whole(known: Vector, state: LoopState) -> Iterator[dict[str, float]]:
    """Yield the poses at which all that is known has a value, the default one first."""
    for values in (state.base, *state.values):
        if mentioned(known) <= values.keys():
            yield values


def _length_gap(
    known: Vector, moving: list[Arm], name: str, values: dict[str, float]
) -> tuple[float, float]:
    """Return the size of the known side, and what the turning one is too long by."""
    turned = tuple(Arm(a.length, a.angle) for a in moving)
    x, y = evaluate_vector(turned, {**values, name: 0.0})
    size = math.hypot(*evaluate_vector(known, values))
    return max(size, math.hypot(x, y)), math.hypot(x, y) - size


def _side_gap(known: Vector, moving: list[Arm], values: dict[str, float]) -> tuple[float, float]:
    """Return the longest arm of the known side, and the distance of its end from the line.

    The side itself may come to nothing, but for rounding.
    """
    x, y = evaluate_vector(known, values)
    theta = moving[0].angle.evaluate(values)
    longest = max((abs(arm.length.evaluate(values)) for arm in known), default=0.0)
    return longest, y * math.cos(theta) - x * math.sin(theta)


def joined(closure: Closure, wanted: NameSet, cycle: Cycle, state: LoopState) -> Closure:
    """Return a closure one of whose two directions is that of another vector all the way.

    The other vector joins points that are placed then. The law of the loop would put it into
    the other closure beyond a pose where the two meet: a parallelogram's coupler is parallel to
    its frame on either side of the pose where all of it lies flat.
    """
    others = wanted - closure.alike.keys()
    if not closure.alike or len(others) != 1 or not others <= state.angles:
        return closure
    (name,) = others
    arms = [Arm(a.length, a.angle.put(closure.alike)) for e in cycle for a in e.arms]
    known = _present((a for a in arms if name not in mentioned((a,))), state)
    moving = [a for a in arms if name in mentioned((a,))]
    if not known:
        return closure
    own = tuple(d for d in closure.definitions if d.name in closure.alike)
    put = {n: a for n, a in closure.directions.items() if n in closure.alike}
    rest = closure_of(name, known, moving, state)
    directions = {**put, **rest.directions}
    return closure._replace(definitions=(*own, *rest.definitions), directions=directions)


def _present(arms: Iterable[Arm], state: LoopState) -> Vector:
    """Return a vector without arms that vanish by the numbers given, such as ``OA − QB``."""
    sums = gathered(arms)
    poses = [v for v in (state.base, *state.values) if mentioned(sums) <= v.keys()]
    sizes = [[abs(arm.length.evaluate(values)) for arm in sums] for values in poses]
    longest = [max(row) for row in sizes] if sums else []
    return tuple(
        arm
        for arm, *own in zip(sums, *sizes, strict=True)
        if any(size > SAME_PLACE * whole for size, whole in zip(own, longest, strict=True))
    )


def closure_of(name: str, known: Vector, moving: list[Arm], state: LoopState) -> Closure:
    """Return the unknown; what turns as one body has a direction within it, ``delta``."""
    if name not in state.angles:
        theta = moving[0].angle
        reach = components(tuple(Arm(a.length, a.angle - theta) for a in known))[0]
        return Closure((PoseDefinition(name, (-reach).formula()),), {})
    sense = int(dict(moving[0].angle.terms)[name])
    offset = moving[0].angle - Angle.of(name) * sense
    turn = common_turn(known)
    x, y = components(tuple(Arm(-a.length, a.angle - turn) for a in known))
    direction = Call("atan2", (y.formula(), x.formula()))
    if moving[0].angle == Angle.of(name) and not turn.terms:
        return Closure((PoseDefinition(name, direction),), {})
    own = state.free_name(f"{'delta' if turn.terms else 'phi'}_{name.removeprefix('phi_')}_")
    angle = principal((turn + Angle.of(own) - offset) * sense)
    if name in state.named:
        return Closure((PoseDefinition(own, direction), PoseDefinition(name, angle.formula())), {})
    return Closure((PoseDefinition(own, direction),), {name: angle})
