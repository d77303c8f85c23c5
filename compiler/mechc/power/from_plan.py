"""Virtual power: from the plan to what was asked for."""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, assert_never

from ..algebra.product import Product
from ..algebra.sums import canonical
from ..diagnostics import Diagnostic, Report
from ..diagnostics import power as messages
from ..formula.tree import Formula, Symbol, product, total
from ..formula.walk import symbols
from ..frozen import replace
from ..kinematics.graph import Kind
from ..kinematics.plan import Plan
from ..model.mechanism import (
    Axial,
    Efficiency,
    Find,
    LoadForm,
    LoadRatio,
    Mechanism,
    Normal,
    Reaction,
    Speed,
    SpeedRatio,
    WithFriction,
)
from ..model.result import Definition, Result
from ..source import Span
from ..units import ANGLE, FORCE, FREQUENCY, VELOCITY, Dimension
from .balance import Balance, Solved
from .definitions import intermediates, open_lengths, resting_on
from .equations import equations_of
from .loads import given_size, terms
from .loose import looseness
from .numbers import checked
from .reading import Reading
from .speeds import magnitude, speed

if TYPE_CHECKING:
    from .reactions import Reactions


def balance(plan: Plan, report: Report) -> Balance:
    """Return the power equations and what was asked for without friction.

    Reports E501 … E508 where a result is not determined or not finite at the default
    pose, W501 … W504 for loads without work, zero and negative ratios, idle degrees of freedom.
    """
    return _Asked(plan, report).balance()


class _Asked:
    """Solves one find after another."""

    def __init__(self, plan: Plan, report: Report) -> None:
        self._plan, self._report = plan, report
        self._mechanism = plan.graph.pose.mechanism
        self._terms = terms(plan)
        self._equations = equations_of(self._terms)
        self._reading = Reading(plan)
        self._loads = {load.name: load for load in self._mechanism.loads}
        self._solved_so_far: list[Solved] = []
        self._without_lengths: set[Span] = set()
        self._undecided_at: set[Span] = set()

    def balance(self) -> Balance:
        """Return the whole."""
        self._warn_of_idle_motions()
        solved = self._solved_so_far
        for find in self._mechanism.finds:
            if (found := self._find(find)) is not None:
                solved.append(found)
        self._warn_of_idle_loads()
        self._report.stop_on_errors()
        read, driving = self._reading.plan, self._driving()
        balanced = Balance(self._plan, self._terms, self._equations, driving, tuple(solved), read)
        return replace(balanced, solved=checked(balanced, self._report))

    def _warn_of_idle_loads(self) -> None:
        """Warn of loads without work, but not in a frame, nor where friction or a find has them."""
        if self._mechanism.friction.joints or not self._plan.mobility:
            return
        shown = [let.value for let in self._mechanism.lets]
        for solved in self._solved_so_far:
            shown += [solved.result.formula, *(d.formula for d in solved.result.where)]
        seen = {name for formula in shown for name in symbols(formula)}
        for name in self._equations.idle_loads:
            if name not in seen:
                span, held = self._loads[name].span, _held_drives(self._mechanism)
                self._report.add(messages.load_does_no_work(span, name, held))

    def _warn_of_idle_motions(self) -> None:
        """Name what the idle motions are measured by: links that turn, points that move."""
        asks_for_loads = any(not isinstance(f.target, SpeedRatio) for f in self._mechanism.finds)
        if not self._equations.idle_motions or not asks_for_loads:
            return
        graph = self._plan.graph
        drives = [graph.unknowns[self._plan.drives[i]] for i in self._equations.idle_motions]
        spans = {f"link {k.name}": k.span for k in self._mechanism.links}
        spans |= {f"point {p}": span for p, span in self._mechanism.spans.items()}
        named = [f"{'link' if d.kind is Kind.SPIN else 'point'} {d.of}" for d in drives]
        what = sorted(dict.fromkeys(named), key=lambda name: spans[name])
        self._report.add(messages.idle_freedom(spans[what[0]], what))

    def _find(self, find: Find) -> Solved | None:
        match find.target:
            case LoadRatio(above, below):
                return self._ratio(find, above, below)
            case LoadForm(load):
                return self._form(find, load)
            case SpeedRatio(above, below):
                return self._speeds(find, above, below)
            case Reaction() | Axial() | Normal() as target:
                return self._force(find, target)
            case WithFriction() | Efficiency():
                return None
            case _:
                assert_never(find.target)

    # -------------------------------------------------------------------------- loads

    def _ratio(self, find: Find, above: str, below: str) -> Solved | None:
        (upper, factor), (lower, below_factor) = map(self._equations.owner, (above, below))
        factor = factor / below_factor
        if upper == lower:
            return self._solved(find, factor, above, below)
        columns = self._equations.columns
        others = [n for n in columns if n not in (upper, lower)]
        unknown = [upper, *others]
        if upper not in columns:
            self._report.add(
                messages.load_not_balanced(find.span, below, above, _held_drives(self._mechanism))
            )
            return None
        if len(unknown) < self._equations.number:
            number = self._equations.number
            loose = looseness(self._mechanism)
            self._report.add(messages.unknown_loads_do_not_match(find.span, unknown, number, loose))
            return None
        if len(unknown) > self._equations.number or not self._equations.determines(unknown):
            others = others or [lower]
            self._report.add(
                messages.ratio_not_determined(find.span, above, below, others, self._weights())
            )
            return None
        if lower not in columns:
            return self._solved(find, Product(0), above, below)
        value = canonical(factor * self._equations.solve(upper, unknown, lower))
        shown = self._reading.of(value, lambda e: factor * e.solve(upper, unknown, lower))
        return self._solved(find, value, above, below, shown)

    def _solved(
        self, find: Find, value: Product, above: str, below: str, read: Product | None = None
    ) -> Solved:
        dimension = self._dimension(above).over(self._dimension(below))
        shown = value if read is None else read
        result = self._result(find, shown.formula(), dimension, [shown])
        return Solved(result, value, above, below)

    def _form(self, find: Find, load: str) -> Solved | None:
        asked = [f.target.load for f in self._mechanism.finds if isinstance(f.target, LoadForm)]
        unknown = asked if len(asked) == self._equations.number else [load]
        if len(unknown) != self._equations.number:
            number = self._equations.number
            loose = looseness(self._mechanism)
            self._report.add(messages.unknown_loads_do_not_match(find.span, asked, number, loose))
            return None
        if not self._equations.determines(unknown):
            self._report.add(
                messages.load_not_balanced(
                    find.span, "the other loads", load, _held_drives(self._mechanism)
                )
            )
            return None
        known = [n for n in self._equations.columns if n not in unknown]
        values = {n: self._equations.solve(load, unknown, n) for n in known}
        return Solved(self._linear(find, load, values), None, load)

    def _linear(self, find: Find, load: str, values: dict[str, Product]) -> Result:
        coefficients = {n: v.formula() for n, v in values.items() if v}
        formula = total(product([(c, 1), (Symbol(n), 1)]) for n, c in coefficients.items())
        result = self._result(find, formula, self._dimension(load), list(values.values()))
        given = [Definition(n, f) for n in values if (f := self._given(n)) is not None]
        found = intermediates(self._plan.graph.pose, [*(g.formula for g in given), formula])
        where = dict.fromkeys((*found, *result.where, *given))
        return replace(result, where=tuple(where), coefficients=coefficients)

    def _given(self, load: str) -> Formula | None:
        return given_size(self._mechanism, load)

    def _weights(self) -> set[str]:
        """Return the loads whose size the description gives, so that they can't be tied."""
        return {name for name in self._loads if self._given(name) is not None}

    def _dimension(self, load: str) -> Dimension:
        return self._loads[load].dimension

    # ------------------------------------------------------------------------- forces

    def _force(self, find: Find, target: Reaction | Axial | Normal) -> Solved | None:
        from ..kinematics.release import unclear
        from .joint_forces import called, find_force, joint_of

        point = joint_of(target, self._plan.graph.pose).point
        if not isinstance(target, Normal) and point in unclear(self._mechanism):
            self._report.add(messages.transmission_presses(find.span, point, has_friction=False))
            return None
        if self._undecided:
            if find.span not in self._undecided_at:
                shown = called(target), self._undecided, self._equations.number
                self._report.add(messages.which_load_follows(find.span, *shown))
            self._undecided_at.add(find.span)
            return None
        found = find_force(target, self._plan.graph.pose, self._reactions)
        if found is None:
            self._report.add(self._open(find.span, called(target)))
            return None
        where = [d for p in found.plans for d in resting_on(p, found.formula, found.values)]
        loads = (*self._equations.columns, *self._equations.idle_loads)
        given = [Definition(n, f) for n in loads if (f := self._given(n))]
        used = symbols(found.formula)
        given = [g for g in given if g.name in used]
        before = intermediates(self._plan.graph.pose, [*(g.formula for g in given), found.formula])
        self._check_lengths(find, [found.formula, *(d.formula for d in where)])
        coefficients = found.coefficients
        dimension = ANGLE if getattr(target, "part", "") == "direction" else FORCE
        result = Result(
            find.name,
            target,
            dimension,
            found.formula,
            tuple(dict.fromkeys((*before, *where, *given))),
            None if coefficients is None else {n: c.formula() for n, c in coefficients.items()},
        )
        return Solved(result, releases=found.releases)

    def _open(self, at: Span, force: str) -> Diagnostic:
        """Return why a force at a joint is open: no load holds the mechanism, or too much does."""
        needed, holding = self._equations.number, len(self._driving())
        if holding < needed:
            return messages.nothing_holds(at, force, needed, holding)
        return messages.reaction_undetermined(at, force)

    @cached_property
    def _reactions(self) -> "Reactions":
        from .reactions import Reactions

        return Reactions(self._plan.graph.pose, self._driving(), known=(self._plan,))

    def _driving(self) -> tuple[str, ...]:
        """Return the loads that follow from the others: those asked for, else those left."""
        return (*self._asked_for, *self._left)[: self._equations.number]

    @cached_property
    def _asked_for(self) -> tuple[str, ...]:
        """Return the loads that are asked for, and do work."""
        targets = [f.target for f in self._mechanism.finds]
        asked = [t.above for t in targets if isinstance(t, LoadRatio)]
        asked += [t.load for t in targets if isinstance(t, LoadForm)]
        owners = dict.fromkeys(self._equations.owner(n)[0] for n in asked)
        return tuple(name for name in owners if name in self._equations.columns)

    @cached_property
    def _left(self) -> tuple[str, ...]:
        """Return the loads that work, have no size, and are not asked for."""
        columns = self._equations.columns
        return tuple(n for n in columns if not self._given(n) and n not in self._asked_for)

    @cached_property
    def _undecided(self) -> tuple[str, ...]:
        """Return the loads of which nothing says which ones follow from the others."""
        open_ = self._equations.number - len(self._asked_for)
        if open_ < 0:
            return self._asked_for
        return self._left if 0 < open_ < len(self._left) else ()

    # ------------------------------------------------------------------------- speeds

    def _speeds(self, find: Find, above: Speed, below: Speed) -> Solved | None:
        (upper, signed), (lower, signed_below) = (speed(self._plan, s) for s in (above, below))
        moving = [i for i, v in enumerate(lower) if v]
        if not moving:
            self._report.add(messages.speed_vanishes(find.span, below.name))
            return None
        if len(moving) > 1 or any(v for i, v in enumerate(upper) if i not in moving):
            ratio = f"{above.name}/{below.name}"
            self._report.add(messages.speeds_independent(find.span, ratio))
            return None
        value = canonical(upper[moving[0]] / lower[moving[0]])
        if not (signed and signed_below):
            value = magnitude(value, self._mechanism)
        dimension = _rate(above).over(_rate(below))
        return Solved(self._result(find, value.formula(), dimension, [value]), value)

    # ------------------------------------------------------------------------ results

    def _result(
        self, find: Find, formula: Formula, dimension: Dimension, values: Sequence[Product]
    ) -> Result:
        where = resting_on(self._reading.plan, formula, values)
        self._check_lengths(find, [formula, *(d.formula for d in where)])
        return Result(find.name, find.target, dimension, formula, where)

    def _check_lengths(self, find: Find, formulas: Sequence[Formula]) -> None:
        missing = open_lengths(self._plan, formulas)
        if missing and find.span not in self._without_lengths:
            self._report.add(messages.length_not_given(find.span, find.name, missing))
            self._without_lengths.add(find.span)


def _rate(wanted: Speed) -> Dimension:
    return FREQUENCY if wanted.kind == "link" else VELOCITY


def _held_drives(mechanism: Mechanism) -> str:
    """Return the drives that are held, as a message names them; '' where there are none."""
    return ", ".join("".join(d.ends) if d.ends else d.parameter for d in mechanism.held)
