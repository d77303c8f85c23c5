"""Closures as people write them: with angles that stay near, and directions that are known."""

import math
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction

from ...algebra.angle import Angle
from ...algebra.from_formula import to_angle
from ...formula.evaluate import evaluate
from ...formula.tree import Call, Formula, Sum, degrees, is_call, negative, total
from ...formula.walk import symbols
from ..pose import Arm, PoseDefinition, Vector
from ..samples import Values
from ..tolerances import SAME_ANGLE
from ..vector_graph import Cycle, NameSet
from .dyads import Closure, DyadLoop
from .state import LoopState

MOST_OF_THEM = 3
"""The default pose, and one of each pair of poses around it."""


def unwound(closure: Closure, state: LoopState) -> Closure:
    """Return a closure with each angle of the user's within half a turn of the default pose.

    Where it stands in a multiple that is no whole one, or in a length, it may not jump by
    a turn where the direction that it is found by passes 180°. Other directions are within
    a turn there.
    """
    here = dict(state.tried(closure, state.base))
    definitions = []
    for name, formula in closure.definitions:
        kept = formula
        if name in state.angles and math.isfinite(here.get(name, math.nan)):
            # What is defined before may have been turned back: this follows it.
            kept = _unwound(name, formula, evaluate(formula, here), state)
            here[name] = evaluate(kept, here)
        definitions.append(PoseDefinition(name, kept))
    return closure._replace(definitions=tuple(definitions))


def _unwound(name: str, formula: Formula, value: float, state: LoopState) -> Formula:
    is_within, turns = -math.pi < value < math.tau, round(value / math.tau)
    if all(_turns_whole(name, arm) for edge in state.graph.edges for arm in edge.arms):
        return turned_back(formula, turns if name in state.named or not is_within else 0)
    if name not in state.named:
        return formula
    middle = degrees(90 * round(math.remainder(value, math.tau) / (math.pi / 2)))
    apart = total([formula, negative(middle)])
    return total([middle, Call("atan2", (Call("sin", (apart,)), Call("cos", (apart,))))])


def familiar(cycle: Cycle, state: LoopState) -> list[Angle]:
    """Return the directions of the vectors of a loop, and of those that hang on its points."""
    points = {p for edge in cycle for p in (edge.tail, edge.head)}
    around = (e for e in state.graph.edges if not points.isdisjoint((e.tail, e.head)))
    return list(dict.fromkeys(arm.angle for edge in (*cycle, *around) for arm in edge.arms))


def in_known_angles(
    closure: Closure, loop: DyadLoop, around: Iterable[Angle], state: LoopState
) -> Closure:
    """Return a closure without its law, where its lengths are equal: else the closure.

    Its directions are those of other vectors, or those of its known arms, mirrored in the side
    that these make: of a kite, and of a crossed parallelogram.
    """
    alike = recognised(closure, loop.unknown, around, state)
    if alike.alike:
        return alike
    mirror = recognised(closure, loop.unknown, _mirrored(closure, loop.known), state)
    return mirror if loop.unknown <= mirror.alike.keys() else closure


def _mirrored(closure: Closure, known: Vector) -> list[Angle]:
    """Return the directions of the arms of a loop's known side, mirrored in this side."""
    sides = (d.name for d in closure.definitions if is_call(d.formula, "atan2"))
    side = next((name for name in sides if name.startswith("phi_")), None)
    if side is None or len(known) < 2:
        return []
    return [Angle.of(side) * 2 - arm.angle for arm in known]


def recognised(
    closure: Closure, unknown: NameSet, around: Iterable[Angle], state: LoopState
) -> Closure:
    """Return a closure with each direction that is one of those ``around`` written as that one.

    A parallelogram's coupler stays parallel to its frame: the numbers at several poses
    show it, each with other lengths. Near a pose where closures meet, those on this side
    of it do.
    """
    poses = [state.tried(closure, values) for values in state.values]
    known = [a for a in around if state.graph.sought.isdisjoint(a.names)]
    for name in sorted(unknown & state.angles):
        if same := next((s for a in known if (s := _alike(name, a, poses))), None):
            closure = _rewritten(closure, name, same, name in state.named)
    return closure


def _turns_whole(name: str, arm: Arm) -> bool:
    """Return whether a vector is the same where an angle is a full turn greater."""
    factor = dict(arm.angle.terms).get(name, Fraction(0))
    return factor.denominator == 1 and name not in symbols(arm.length.formula())


def _alike(name: str, angle: Angle, poses: Iterable[Values]) -> Angle | None:
    """Return an angle, or its opposite, turned by quarters, if the unknown is it at most poses."""
    known = [v for v in poses if name in v and angle.names <= v.keys()]
    for sense in (1, -1):
        gaps = [values[name] - sense * angle.evaluate(values) for values in known]
        if (quarters := _quarters(gaps)) is not None:
            return angle * sense + Angle.constant(quarters % 4 * 90)
    return None


def _quarters(gaps: Sequence[float]) -> int | None:
    """Return how many quarters of a turn most gaps are, the first among them; None of others.

    Beyond a pose where closures meet the gaps are those of another motion, or there are none.
    """
    if not gaps or not math.isfinite(gaps[0]):
        return None
    quarters = round(gaps[0] / (math.pi / 2))
    alike = [gap for gap in gaps if _is_turned(gap, quarters)]
    return quarters if gaps[0] in alike and len(alike) >= MOST_OF_THEM else None


def _is_turned(gap: float, quarters: int) -> bool:
    if not math.isfinite(gap):
        return False
    return abs(math.remainder(gap - quarters * math.pi / 2, 2 * math.pi)) <= SAME_ANGLE


def _rewritten(closure: Closure, name: str, angle: Angle, keep: bool) -> Closure:
    """Return a closure in which a direction is another one."""
    others = tuple(d for d in closure.definitions if d.name != name)
    directions = {n: a for n, a in closure.directions.items() if n != name}
    alike = {**closure.alike, name: angle}
    if keep:
        others = (*others, PoseDefinition(name, angle.formula()))
        return closure._replace(definitions=others, directions=directions, alike=alike)
    put: Callable[[Angle], Angle] = lambda a: a.put({name: angle})  # noqa: E731
    put_in = {**{n: put(a) for n, a in directions.items()}, name: angle}
    return closure._replace(definitions=others, directions=put_in, alike=alike)


def turned_back(formula: Formula, turns: int) -> Formula:
    """Return an angle less full turns, which are gathered with its own constants.

    >>> from ...formula.to_text import text
    >>> from ...formula.tree import Symbol
    >>> text(turned_back(total([Symbol("mu_B"), degrees(90)]), 1))
    'mu_B - 3*pi/2'
    """
    if not turns:
        return formula
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    known = [(term, to_angle(term)) for term in terms]
    rest = [term for term, angle in known if angle is None or angle.terms]
    constant = sum(angle.degrees for _, angle in known if angle and not angle.terms)
    return total([*rest, degrees(constant - 360 * turns)])
