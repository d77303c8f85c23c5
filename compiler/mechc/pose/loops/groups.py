"""Assur groups of higher class: loops that only close together, as systems of equations.

What dyads leave over is split into the smallest sets of loops that must be solved at once
(triads, double butterflies). The closures at the default pose are found by Newton's method
from many starts; the one that the user named becomes the start of the branch.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from random import Random

from ...algebra.angle import QUARTER, Angle
from ...algebra.factors import Length
from ...algebra.product import Product
from ...algebra.solution_order import blocks, match
from ...base.frozen import replace
from ...base.named import NamedTuple
from ...formula.tree import Call, Formula, Sum, Symbol, System, implicit, is_call
from ...formula.tree import Product as Factors
from ..pose import Arm, Limit, OpenUnknowns, PoseDefinition, Vector, components, gathered
from ..samples import Values
from ..tolerances import SAME_CLOSURE, SOLVED_GAP
from ..vector_graph import Cycle, mentioned
from .dyads import Closure
from .state import LoopState

CLOSURE_STARTS = 400
"""Random starts from which closures are looked for."""

VAIN = 40
"""Closures met again, one after another, after which no new one is expected."""

NEWTON_STEPS = 40
"""Newton steps after which a start is given up."""


class LoopGroup(NamedTuple):
    """Loops that close together: equations (a loop, 0 for x or 1 for y) and their unknowns."""

    loops: tuple[Cycle, ...]
    equations: tuple[tuple[int, int], ...]
    unknown: frozenset[str]

    @property
    def cycle(self) -> Cycle:
        """Return all edges of the loops."""
        return tuple(dict.fromkeys(e for loop in self.loops for e in loop))

    @property
    def sides(self) -> list[Vector]:
        """Return the vectors of each loop."""
        return [_side_arms(loop) for loop in self.loops]

    @property
    def limit(self) -> Limit | None:
        """Return None: where closures meet is no function of what is known."""
        return None

    def triples(self) -> list[tuple[str, str, str]]:
        """Return the pins between two unknown edges, each with the far ends of the two."""
        loose = [e for e in self.cycle if not self.unknown.isdisjoint(mentioned(e.arms))]
        found: dict[str, tuple[str, str, str]] = {}
        for first in (*loose, *(e.turned() for e in loose)):
            for second in (*loose, *(e.turned() for e in loose)):
                ends = {first.tail, first.head, second.head}
                if first.head == second.tail and len(ends) == 3 and "" not in ends:
                    found.setdefault(first.head, (first.tail, first.head, second.head))
        return list(found.values())


def remaining_blocks(state: LoopState) -> Iterator[LoopGroup]:
    """Yield the blocks of what is left, each after those that it rests on.

    A loop of one unknown is a body's, turns as a whole and says nothing.
    """
    loops = _open_loops(state)
    equations = [(i, part) for i in range(len(loops)) for part in (0, 1)]
    names, columns = _columns(loops, state)
    matched = match(columns)
    determined = _determined(columns, matched, len(names))
    kept = {u: r for u, r in matched.items() if u in determined}
    inner = [c & determined for c in columns]
    for group in blocks(inner, kept):
        chosen = [equations[kept[u]] for u in group]
        used = sorted({i for i, _ in chosen})
        rows = tuple(sorted((used.index(i), part) for i, part in chosen))
        unknown = frozenset(names[u] for u in group)
        yield LoopGroup(tuple(loops[i] for i in used), rows, unknown)


def _open_loops(state: LoopState) -> list[Cycle]:
    return [loop for loop in state.graph.fundamental() if len(_unknown(loop, state)) > 1]


def _columns(loops: Sequence[Cycle], state: LoopState) -> tuple[list[str], list[frozenset[int]]]:
    """Return the unknowns of loops, and which of them are in each equation, two a loop."""
    names = sorted({n for loop in loops for n in _unknown(loop, state)})
    number = {n: i for i, n in enumerate(names)}
    twice = [loop for loop in loops for _ in (0, 1)]
    return names, [frozenset(number[n] for n in _unknown(loop, state)) for loop in twice]


def left_open(state: LoopState) -> OpenUnknowns:
    """Return the unknowns of the loops that did not close, and how many conditions are missing."""
    names, columns = _columns(_open_loops(state), state)
    return OpenUnknowns(frozenset(names), len(names) - len(match(columns)))


def _unknown(loop: Cycle, state: LoopState) -> set[str]:
    return {n for e in loop for n in mentioned(e.arms)} & state.graph.sought


def _determined(
    columns: Sequence[frozenset[int]], matched: Mapping[int, int], size: int
) -> frozenset[int]:
    """Return the unknowns that the equations fix: no path leads to them from a free one."""
    partner = {r: u for u, r in matched.items()}
    free = [u for u in range(size) if u not in matched]
    open_ = set(free)
    while free:
        unknown = free.pop()
        for row, column in enumerate(columns):
            if unknown in column and row in partner and partner[row] not in open_:
                open_.add(partner[row])
                free.append(partner[row])
    return frozenset(range(size)) - open_


def closures(block: LoopGroup, state: LoopState, drawn: Values) -> list[Closure]:
    """Return every closure of a block that was found at the default pose.

    Where all unknowns are ``drawn``, that is the one to which Newton's method leads from there.
    """
    names = tuple(sorted(block.unknown))
    system = system_of(block, state)
    found = _solutions(rows_of(block), names, state, drawn)
    return [_closure(replace(system, start=start)) for start in found]


def system_of(block: LoopGroup, state: LoopState) -> System:
    """Return the equations of a block, without a start."""
    rows = rows_of(block)
    equations = tuple(_equation(arms, part) for arms, part in rows)
    outer = sorted({n for arms, _ in rows for n in mentioned(arms)} - block.unknown)
    anchor = tuple((n, state.base[n]) for n in outer)
    turning = tuple(n for n in outer if _is_known_but_for_turns(n, rows, state))
    return System(tuple(sorted(block.unknown)), equations, anchor, (), turning=turning)


def _is_known_but_for_turns(name: str, rows: Sequence["LoopEquation"], state: LoopState) -> bool:
    """Return whether an angle may jump by whole turns, which leave the rows as they are.

    What turns with the drive itself does so all the way, however far that goes.
    """
    arms = [arm for vector, _ in rows for arm in vector]
    if any(dict(arm.angle.terms).get(name, 0) % 1 for arm in arms):
        return False
    if any(name in mentioned((Arm(arm.length, Angle()),)) for arm in arms):
        return False
    parts = list(_summed(Symbol(name), dict(state.definitions)))
    return any(map(_has_cut, parts)) and Symbol(state.mechanism.drive_name) not in parts


def _summed(formula: Formula, defined: Mapping[str, Formula]) -> Iterator[Formula]:
    """Yield what an angle is the sum of, through the names that stand for such sums."""
    match formula:
        case Symbol(name) if name in defined:
            yield from _summed(defined[name], defined)
        case Sum(parts) | Factors(parts):
            yield from (each for part in parts for each in _summed(part, defined))
        case _:
            yield formula


def _has_cut(formula: Formula) -> bool:
    """Return whether an angle jumps by a whole turn somewhere: none of a triangle does."""
    match formula:
        case Call("atan2", (first, _)):
            return not is_call(first, "sqrt")
        case _:
            return False


def rows_of(block: LoopGroup) -> list["LoopEquation"]:
    """Return the loop and the axis of each equation."""
    return [(_side_arms(block.loops[i]), part) for i, part in block.equations]


def _closure(system: System) -> Closure:
    names = enumerate(system.unknowns)
    return Closure(tuple(PoseDefinition(n, implicit(system, i)) for i, n in names), {})


def _side_arms(loop: Cycle) -> Vector:
    return tuple(arm for edge in loop for arm in edge.arms)


def _equation(arms: Vector, part: int) -> Formula:
    """Return the sum of the arms' components along x (0) or y (1)."""
    return components(gathered(arms))[part].formula()


# ------------------------------------------------------------------- numbers at the default pose

LoopEquation = tuple[Vector, int]


def _solutions(
    rows: Sequence[LoopEquation], names: Sequence[str], state: LoopState, drawn: Values
) -> list[tuple[float, ...]]:
    """Return the solution near the drawn one, or those that random starts lead to, each once."""
    dice = Random(state.mechanism.name)
    size = size_of(rows, names, state.base)
    slopes = [[_slope(arms, n) for n in names] for arms, _ in rows]
    if drawn.keys() == set(names):
        near = _newton(rows, slopes, names, {**state.base, **drawn}, size)
        if near is not None:
            return [tuple(near[n] for n in names)]
    found: list[tuple[float, ...]] = []
    vain = 0
    for _ in range(CLOSURE_STARTS):
        if vain > VAIN:
            break
        start = {n: draw(n in state.angles, size, dice) for n in names}
        end = _newton(rows, slopes, names, {**state.base, **start}, size)
        if end is None:
            continue
        folded = tuple(
            math.remainder(end[n], 2 * math.pi) if n in state.angles else end[n] for n in names
        )
        vain += 1
        if all(_apart(folded, known) > SAME_CLOSURE for known in found):
            found.append(folded)
            vain = 0
    return sorted(found)


def draw(is_angle: bool, size: float, dice: Random) -> float:
    """Return an angle, or a length of up to twice the size of the mechanism."""
    return dice.uniform(-math.pi, math.pi) if is_angle else dice.uniform(0, 2 * size)


def _apart(one: Sequence[float], other: Sequence[float]) -> float:
    return max(abs(math.remainder(a - b, 2 * math.pi)) for a, b in zip(one, other, strict=True))


def size_of(rows: Sequence[LoopEquation], names: Sequence[str], values: Values) -> float:
    """Return the largest known arm."""
    return max(_sizes(rows, names, values), default=1.0)


def _sizes(rows: Sequence[LoopEquation], names: Sequence[str], values: Values) -> Iterator[float]:
    for arms, _ in rows:
        for arm in arms:
            if not any(Length(n) in arm.length.factors for n in names):
                yield abs(arm.length.evaluate(values))


def _newton(
    rows: Sequence[LoopEquation],
    slopes: Sequence[Sequence[Vector]],
    names: Sequence[str],
    values: Values,
    size: float,
) -> Values | None:
    """Return values at which all rows vanish, None where the start leads nowhere."""
    for _ in range(NEWTON_STEPS):
        gaps = [_component(arms, part, values) for arms, part in rows]
        if max(map(abs, gaps)) < SOLVED_GAP * size:
            return values
        matrix = [
            [_component(arms, part, values) for arms in slope]
            for slope, (_, part) in zip(slopes, rows, strict=True)
        ]
        step = eliminate(matrix, gaps)
        if step is None or not all(map(math.isfinite, step)):
            return None
        values = {**values, **{n: values[n] - s for n, s in zip(names, step, strict=True)}}
    return None


def _component(arms: Vector, part: int, values: Values) -> float:
    return math.fsum(
        a.length.evaluate(values) * (math.sin if part else math.cos)(a.angle.evaluate(values))
        for a in arms
    )


def _slope(arms: Vector, name: str) -> Vector:
    """Return the derivative of a vector by an unknown angle or length."""
    turned: list[Arm] = []
    for length, angle in arms:
        sense = dict(angle.terms).get(name, 0)
        if sense:
            turned.append(Arm(length.scaled(sense), angle + QUARTER))
        if Length(name) in length.factors:
            turned.append(Arm(length / Product.symbol(name), angle))
    return tuple(turned)


def eliminate(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float] | None:
    """Solve a small dense system, the largest pivot first; None where it is singular.

    >>> eliminate([[2.0, 1.0], [0.0, 4.0]], [4.0, 8.0])
    [1.0, 2.0]
    """
    rows = [[*row, r] for row, r in zip(matrix, right, strict=True)]
    size = len(rows)
    for i in range(size):
        pivot = max(range(i, size), key=lambda r: abs(rows[r][i]))
        if not abs(rows[pivot][i]) > 0:
            return None
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for row in rows[i + 1 :]:
            factor = row[i] / rows[i][i]
            for j in range(i, size + 1):
                row[j] -= factor * rows[i][j]
    found = [0.0] * size
    for i in reversed(range(size)):
        rest = math.fsum(rows[i][j] * found[j] for j in range(i + 1, size))
        found[i] = (rows[i][size] - rest) / rows[i][i]
    return found
