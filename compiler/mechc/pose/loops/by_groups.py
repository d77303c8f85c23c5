"""Closing one group of loops after another.

Group by group, as Assur groups hang on one another: first the triangles inside bodies,
then loops of two unknowns (dyads, in closed form), and what is left over together, as
systems that are solved by iteration. Every unknown becomes a definition of the pose, or is
put in where it is a sum of named angles.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from ...algebra.from_formula import is_transparent, to_product
from ...algebra.product import Product, Sum
from ...algebra.sums import put
from ...base.frozen import replace
from ...diagnostics import Report
from ...diagnostics import open_loops as messages
from ...formula.tree import ONE, Call, Formula, Implicit, Symbol, negative, total
from ...formula.walk import symbols, walk
from ...model.mechanism import Assembly, Link, Mechanism
from ...model.values import following
from ...units import LENGTH
from ..directions import Directions
from ..pose import OF_A_TRIANGLE, Closed, ClosedLoop, Limit, LoopKind, PoseDefinition
from ..vector_graph import Cycle, NameSet, loop_name, mentioned, points_around
from ..vectors import Vectors
from . import branches
from .choosing import AssemblyChoice, lengths_around
from .drawn import start
from .dyad_closures import dyad
from .dyad_sides import DyadSides
from .dyads import Closure, DyadLoop
from .groups import closures, left_open, remaining_blocks
from .recognition import familiar, in_known_angles, unwound
from .redundant import check_fit, joined
from .state import LoopState


def closed(state: LoopState, directions: Directions, vectors: Vectors, report: Report) -> Closed:
    """Close what is sought, and put the directions in."""
    idle = _GroupClosing(state, report).run()
    report.stop_on_errors()
    put_in = _put_in(state, directions, vectors)
    return Closed(
        mechanism=_with_solved(state.mechanism, state, report),
        found=frozenset(state.found),
        rates=state.rated.rates,
        limits=tuple(state.limits),
        loops=tuple(state.loops),
        left=left_open(state),
        idle=idle,
        put_in=put_in,
        solved=tuple(state.solved),
    )


def _put_in(state: LoopState, directions: Directions, vectors: Vectors) -> NameSet:
    """Put what was found into directions and vectors; return the lengths that vanish so."""
    directions.put(state.directions)
    vectors.lay(state.laid())
    short = _in_one_term(state)
    vectors.put(state.directions, short)
    vectors.placeholders[:] = [n for n in vectors.placeholders if n not in state.found]
    return frozenset(short)


def _in_one_term(state: LoopState) -> dict[str, Product]:
    """Return the lengths that closing found as one product, such as ``g/cos(phi)``."""
    found: dict[str, Product] = {}
    for name, formula in state.definitions:
        if name in state.found - state.angles - state.named:
            length = put(to_product(formula), found)
            if is_transparent(length) and not any(isinstance(f, Sum) for f in length.factors):
                found[name] = length
    return found


def _with_solved(mechanism: Mechanism, state: LoopState, report: Report) -> Mechanism:
    """Return the mechanism with the parameters that loops gave; W303 names one with a range."""
    solved: dict[str, Formula] = {
        d.name: d.formula for d in state.definitions if d.name in state.named
    }
    for parameter in mechanism.parameters:
        if parameter.name in solved and parameter.range:
            report.add(messages.range_of_found(parameter.span, parameter.name))
    parameters = tuple(
        replace(p, value=solved[p.name], range=None, dependent=True) if p.name in solved else p
        for p in mechanism.parameters
    )
    return replace(mechanism, parameters=parameters)


class _GroupClosing:
    """Finds one group after another."""

    def __init__(self, state: LoopState, report: Report) -> None:
        self._state, self._report = state, report
        self._choice = AssemblyChoice(state, report)
        self._fixed = state.mechanism.fixed

    def run(self) -> tuple[Assembly, ...]:
        """Close all that can be closed; return the assembly lines that decided nothing."""
        for link in self._state.mechanism.links:
            self._close_body(link)
        steps = (self._close_next, self._close_loose_triangle, self._close_block)
        while self._state.is_open and any(close() for close in steps):
            pass
        return self._choice.unused

    def _close_block(self) -> bool:
        """Close a group of class III or higher, as a system; False where none is left."""
        if not self._state.open_angles:
            return False
        block = next(remaining_blocks(self._state), None)
        if block is None:
            return False
        self._check_values(block.cycle)
        found = closures(block, self._state, start(block, self._state))
        if not found:
            self._report.stop_on_errors()
            span = max((e.span for e in block.cycle), key=lambda s: s.start)
            loop, drive = loop_name(block.cycle), self._state.mechanism.drive
            reach = branches.branches(block, self._state)
            name = drive.parameter if drive else ""
            lengths = lengths_around(block.cycle, self._state.mechanism)
            message = messages.cannot_assemble(span, loop, name, reach, lengths, True)
            raise self._report.fail(message)
        chosen = self._choice.choose(found, block)
        loop = loop_name(block.cycle)
        self._state.limits.append(Limit(loop, "system", (), ()))
        self._state.loops.append(iterated(loop, chosen.definitions))
        self._state.take(chosen, block.unknown, block.sides, "system", points_around(block.cycle))
        return True

    def _close_loose_triangle(self) -> bool:
        """Close a triangle of three bodies that turns as a whole; False where none is left.

        A cylinder between two links of one pin makes one: its length gives the angle between
        them, wherever they stand. One of the directions is what the others are found from.
        """
        state = self._state
        drawn = frozenset().union(*(mentioned(edge.arms) for edge in state.graph.edges))
        for reference in sorted(state.open_angles & drawn, key=self._place_of_reference):
            with self._as_known(reference):
                for wanted, cycle in list(state.graph.pairs()):
                    if _turns_as_a_whole(cycle, wanted, reference, state) and self._close(
                        wanted, cycle, self._bodies_around(cycle)
                    ):
                        return True
        return False

    def _place_of_reference(self, name: str) -> tuple[bool, tuple[int, str]]:
        """Return where an unknown stands among those that others may be found from."""
        return name not in self._state.named, self._place(name)

    @contextmanager
    def _as_known(self, name: str) -> Iterator[None]:
        """Take a direction for known meanwhile, another one at each pose."""
        state = self._state
        state.graph.sought.discard(name)
        for i, values in enumerate(state.values):
            values[name] = 0.3 * i
        yield
        for values in state.values:
            del values[name]
        state.graph.sought.add(name)

    def _bodies_around(self, cycle: Cycle) -> NameSet:
        """Return the points of the bodies that a loop goes through."""
        points = frozenset(points_around(cycle))
        bodies = (frozenset(body.points) for body in self._state.mechanism.bodies)
        return points.union(*(body for body in bodies if len(body & points) > 1))

    def _check_values(self, cycle: Cycle) -> None:
        """Stop at a loop with a length that has no value: how it closes is not known."""
        mechanism, named = self._state.mechanism, self._state.named
        open_ = [
            p
            for p in mechanism.parameters
            if p.value is None and p.dimension == LENGTH and p.name not in named
        ]
        if not open_:
            return
        used = {name for edge in cycle for name in mentioned(edge.arms)}
        used |= following(mechanism, self._state.definitions).needed_by(used)
        missing = [p for p in open_ if p.name in used]
        for parameter in missing:
            fault = messages.length_without_value(parameter.span, parameter.name)
            self._report.add(fault)
        if missing:
            self._report.stop_on_errors()

    def _close_body(self, link: Link) -> None:
        """Close the triangles of a body whose sides are given, one direction apart."""
        points, state = frozenset(link.points), self._state
        inside = {
            name
            for edge in state.graph.edges
            if {edge.tail, edge.head} <= points
            for name in mentioned(edge.arms) & state.open_angles
        }
        if len(inside) < 2:
            return
        with self._as_known(min(inside, key=self._place)):
            while self._close_next(points):
                pass

    def _place(self, name: str) -> tuple[int, str]:
        """Return where an unknown first stands in the description."""
        edges = [e for e in self._state.graph.edges if name in mentioned(e.arms)]
        return min(e.span.start for e in edges), name

    def _close_next(self, within: NameSet | None = None) -> bool:
        """Close one cycle; False where none is left that two unknowns close."""
        pairs = list(self._state.graph.pairs(within))
        turning = [pair for pair in pairs if not pair[0].isdisjoint(self._state.angles)]
        return any(self._close(*pair, within) for pair in (*turning, *pairs))

    def _close(self, wanted: NameSet, cycle: Cycle, within: NameSet | None) -> bool:
        """Close a cycle for the unknowns wanted; False where it does not give them."""
        if len(wanted) == 1:
            return self._fit(next(iter(wanted)), cycle)
        state = self._state
        name, base, found = state.free_name, state.base, state.definitions
        sides = DyadSides(name, state.named, self._fixed, base, state.signed, found, state.twice)
        loop = DyadLoop.of(cycle, wanted)
        group = dyad(loop, sides)
        if group is None:
            return False
        self._check_values(cycle)
        around = familiar(cycle, state)
        known = [in_known_angles(c, loop, around, state) for c in group.closures]
        candidates = [joined(c, wanted, cycle, state) for c in known]
        chosen = self._choice.choose(candidates, group, within)
        is_new = not sides.again
        state.limits += [group.limit] if group.limit and is_new else []
        if group.root is not None and is_new and any(chosen is each for each in group.closures):
            state.loops.append(in_closed_form(loop_name(cycle), chosen.definitions, group.root))
        kind = _how(chosen, group.kind)
        points = group.triples()[0] if kind in OF_A_TRIANGLE else points_around(cycle)
        side = tuple(arm for edge in cycle for arm in edge.arms)
        place = self._choice.place(candidates, group, chosen) if kind == "guide" else None
        state.take(unwound(chosen, state), wanted, [side], kind, points, sides.again, place)
        return True

    def _fit(self, name: str, cycle: Cycle) -> bool:
        """Take a vector between placed points; a loop inside one body turns as a whole."""
        if all(name in mentioned((arm,)) for edge in cycle for arm in edge.arms):
            return False
        fault = check_fit(name, cycle, self._state)
        if fault:
            self._report.stop_on_errors()
            raise self._report.fail(fault)
        return True


def _turns_as_a_whole(cycle: Cycle, wanted: NameSet, reference: str, state: LoopState) -> bool:
    """Return whether a loop is a triangle that keeps its shape whatever direction it has.

    None of its other directions is one that the user named: what names it has rests on the
    reference, which is found later.
    """
    angles = {*wanted, reference}
    if len(wanted) < 2 or not wanted <= state.angles - state.named:
        return False
    turns = (
        sum(factor for name, factor in arm.angle.terms if name in angles)
        for edge in cycle
        for arm in edge.arms
    )
    return all(turn == 1 for turn in turns)


def _how(closure: Closure, kind: LoopKind) -> LoopKind:
    """Return how a loop of a kind is solved: without its law where its lengths are equal."""
    if not closure.alike:
        return kind
    own = {d.name for d in closure.definitions}
    by_side = any(not own.isdisjoint(angle.names) for angle in closure.alike.values())
    return "mirrored" if by_side else "equal"


def in_closed_form(loop: str, definitions: Sequence[PoseDefinition], root: Call) -> ClosedLoop:
    """Return a loop whose definitions rest on a root, or on an arc sine.

    One of which a direction turned out to be another one all the way has no margin: it closes
    wherever that one does, as what vanishes over a part of the stroke vanishes over the whole.
    """
    return ClosedLoop(loop, _resting_on(root, definitions), _margin(root))


def _margin(root: Call) -> Formula:
    """Return the expression that is not negative where a root or an arc sine has a value."""
    (inner,) = root.arguments
    return inner if root.function == "sqrt" else total([ONE, negative(Call("abs", (inner,)))])


def _resting_on(root: Call, definitions: Sequence[PoseDefinition]) -> frozenset[str]:
    names = set[str]()
    for name, formula in definitions:
        if root in walk(formula) or not names.isdisjoint(symbols(formula)):
            names.add(name)
    return frozenset(names)


def iterated(loop: str, definitions: Sequence[PoseDefinition]) -> ClosedLoop:
    """Return a loop that is closed by iteration: what it finds is NaN where the branch ends."""
    names = sorted(name for name, formula in definitions if isinstance(formula, Implicit))
    return ClosedLoop(loop, frozenset(names), Call("abs", (Symbol(names[0]),)))
