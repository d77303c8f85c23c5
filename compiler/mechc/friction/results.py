"""Ratios and loads with friction in them, and their efficiency."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial

from ..algebra.product import ONE, Product
from ..algebra.sums import add, canonical
from ..diagnostics import Report
from ..diagnostics import friction as messages
from ..diagnostics.power import transmission_presses
from ..formula.tree import ZERO, Formula
from ..formula.walk import symbols
from ..frozen import replace
from ..kinematics.release import unclear
from ..model.mechanism import (
    Axial,
    Efficiency,
    Find,
    LoadForm,
    LoadRatio,
    Normal,
    Reaction,
    Require,
    Sense,
    WithFriction,
)
from ..model.result import Case as PrintedCase
from ..model.result import Definition, Drive, FrictionResult, Result
from ..model.targets import SIGNS
from ..power.balance import Balance
from ..power.definitions import bound_sums, intermediates
from ..power.loads import given_size
from ..power.numbers import value_of
from ..power.speeds import magnitude
from .assumptions import asks_for_loads, assumptions
from .case import Case
from .closed_form import ClosedFormSolver, Named, Printed, closed_form, printed_form
from .coupled import Sizes, true_sizes
from .default import DefaultPose
from .efficiency import Drives
from .free_bodies import EquationsCoupled, Task
from .iterated import exact, exact_case, first_order, first_order_case
from .joint_forces import ForceWithFriction
from .linear import LinearSolver
from .naming import Endings, Meanings, with_one_meaning
from .normal_forces import Idle, LoadedByAnother, LoadedPair, Undetermined, loaded_pairs, scaled
from .pairs import FrictionPair, pairs
from .sequential import SequentialSolver
from .signs import AtAnyPose, Signs
from .solution import SolvedWithFriction
from .steps import Step


class FrictionResults:
    """Finds what friction does to one result after another."""

    def __init__(self, balance: Balance, report: Report) -> None:
        self._plan, self._equations, self._report = balance.plan, balance.equations, report
        self._driving = next(iter(balance.driving), "")
        self._mechanism = balance.plan.graph.pose.mechanism
        self._valued = dict(self._weights())
        self._pairs: tuple[FrictionPair, ...] = pairs(balance.plan.graph.pose)
        self._pressed: dict[str, tuple[LoadedPair, ...] | None] = {}
        self._known: dict[object, tuple[LoadedPair, ...] | None] = {}
        self._true: dict[tuple[int, int], Sizes] = {}
        self._in_code, self._endings = Meanings(), Endings()
        self._default = DefaultPose(balance.plan, self._valued, self._taken())

    def _weights(self) -> Iterator[tuple[str, Formula]]:
        """Yield the loads of known size, such as weights."""
        for load in self._mechanism.loads:
            size = given_size(self._mechanism, load.name)
            if size is not None and self._equations.owner(load.name)[0] == load.name:
                yield load.name, size

    def find(self, find: Find, ideal: Result) -> SolvedWithFriction | None:
        """Return the result with friction; None where an error was reported."""
        match find.target:
            case WithFriction(Reaction() | Axial() | Normal() as force, sense):
                return self._force(find, ideal, force, sense)
            case WithFriction(LoadRatio() | LoadForm() as of, sense, order):
                named = self._solve(find, self._case(of, ideal), sense, order)
                if named is None:
                    return None
                steps = named.case.steps if named.case else named.steps
                return SolvedWithFriction(self._result(find, ideal, named), steps=steps)
            case Efficiency(of, sense):
                found = self._efficiency(find, ideal, of, sense)
                return SolvedWithFriction(found) if found else None
            case _:
                return None

    def by_coefficients(self, find: Find, ideal: Result) -> FrictionResult | None:
        """Return the result that friction alone makes, whatever efficiency overrides it."""
        match find.target:
            case WithFriction(LoadRatio() | LoadForm() as of, sense):
                named = self._with_friction(find, self._case(of, ideal), sense, "exact")
                return self._result(find, ideal, named) if named else None
            case _:
                return None

    def _case(self, of: LoadRatio | LoadForm, ideal: Result) -> Case:
        match of:
            case LoadRatio(above, below):
                upper, factor = self._equations.owner(above)
                lower, share = self._equations.owner(below)
                return Case(ideal, upper, factor, {lower: ONE / share})
            case LoadForm(load):
                return Case(ideal, load, ONE, self._others(load))

    def _others(self, driving: str) -> Mapping[str, Product]:
        """Return all other free loads as they stand: one that does no work presses, too."""
        names = (*self._equations.columns, *self._equations.idle_loads)
        return {n: Product.symbol(n) for n in names if n != driving}

    # ------------------------------------------------------------------------- solving

    def _solve(self, find: Find, case: Case, sense: Sense, order: str) -> Named | None:
        efficiency = self._mechanism.friction.efficiency
        if efficiency is not None:
            return Drives(case.ideal, sense, self._plan).with_constant(find.name, efficiency)
        return self._with_friction(find, case, sense, order)

    def _with_friction(self, find: Find, case: Case, sense: Sense, order: str) -> Named | None:
        sign = SIGNS[sense]
        pressed = self._press(find, case)
        if pressed is None:
            return None
        added = scaled(pressed, case.factor)
        endings = self._endings.of(case.ideal.name, sense)
        if order == "first":
            return replace(
                first_order(case.ideal.formula, added, sign, self._mechanism),
                case=self._default.printed(
                    partial(first_order_case, find.name, case.ideal, added, sign), endings
                ),
            )
        closed = self._closed(case, pressed, sign, endings)
        self._remark_on_pins(case, exact=closed is not None)
        sizes = self._sizes_of(pressed, sign, endings)
        if closed and self._stands(find, case.ideal, closed):
            return replace(closed, elsewhere=self._anywhere(case.ideal.formula, added, sizes))
        iterated = self._iterated(case.ideal, added, sizes, endings)
        if closed and not self._stands(find, case.ideal, iterated):
            return replace(closed, elsewhere=self._anywhere(case.ideal.formula, added, sizes))
        return iterated

    def _stands(self, find: Find, ideal: Result, found: Named) -> bool:
        """Return whether a formula has a value at the default pose, as far as that has values.

        A closed form has none where friction turns a pressing force round: there it takes
        iteration. Neither has one where the drive jams.
        """
        value = value_of(self._result(find, ideal, found), self._default.values())
        return value is None or math.isfinite(value)

    def _remark_on_pins(self, case: Case, *, exact: bool) -> None:
        for remark in assumptions(self._plan.graph.pose, case.driving, case.given, exact=exact):
            self._report.add(remark)

    def _sizes_of(
        self, pressed: tuple[LoadedPair, ...], sense: int, endings: Sequence[str]
    ) -> Sizes:
        """Return the true sizes of pressing forces, once for all results that rest on them."""
        key = id(pressed), sense
        if key not in self._true:
            found = true_sizes(pressed, sense, self._taken())
            self._true[key] = with_one_meaning(
                found, (self._in_code, self._default.meanings), endings
            )
        return self._true[key]

    def _closed(
        self, case: Case, pressed: Sequence[LoadedPair], sense: int, endings: Sequence[str]
    ) -> Named | None:
        """Return the first closed form that there is; None where all equations hang together."""
        for way in self._ways(case, pressed, sense):
            try:
                signs = AtAnyPose(self._taken(), self._in_code, endings)
                found = closed_form(way, case.factor, signs)
            except EquationsCoupled:
                continue
            self._in_code.note(found.where)
            printed = partial(printed_form, way, case.factor)
            return replace(found, case=self._default.printed(printed, endings))
        return None

    def _ways(
        self, case: Case, pressed: Sequence[LoadedPair], sense: int
    ) -> Iterator[Callable[[Signs], ClosedFormSolver]]:
        loads = self._mechanism.loads
        owners = {load.name: self._equations.owner(load.name) for load in loads}
        task = Task(self._plan.graph.pose, case.driving, case.given, owners, pressed)
        yield lambda signs: SequentialSolver(task, False, signs, sense)
        yield lambda signs: SequentialSolver(task, True, signs, sense)
        ideal = self._without_friction(case)
        yield lambda signs: LinearSolver(case.driving, ideal, pressed, signs, sense)

    def _without_friction(self, case: Case) -> Product:
        """Return the driving load that balances those given."""
        columns = self._equations.columns
        works = (columns[n][0] * size for n, size in case.given.items() if n in columns)
        return canonical(-(add(works) / columns[case.driving][0]))

    def _anywhere(self, ideal: Formula, pressed: Sequence[LoadedPair], sizes: Sizes) -> Named:
        """Return the load by Newton's method, whichever way the joints are pressed."""
        positive = partial(magnitude, mechanism=self._mechanism)
        return exact(ideal, pressed, sizes, positive)

    def _iterated(
        self, ideal: Result, pressed: Sequence[LoadedPair], sizes: Sizes, endings: Sequence[str]
    ) -> Named:
        """Return the load by Newton's method, as it is printed for the default pose."""
        found = self._anywhere(ideal.formula, pressed, sizes)
        case = self._default.printed(partial(exact_case, ideal.formula, pressed, sizes), endings)
        return replace(found, case=case)

    def _press(self, find: Find, case: Case) -> tuple[LoadedPair, ...] | None:
        """Return how the pairs are pressed under the loads of a case, found once for each."""
        key = case.driving, tuple(case.given.items())
        if key not in self._known:
            self._known[key] = self._try(find, case)
        self._pressed[case.ideal.name] = self._known[key]
        return self._known[key]

    def _try(self, find: Find, case: Case) -> tuple[LoadedPair, ...] | None:
        if self._equations.number != 1:
            self._report.add(messages.several_degrees_of_freedom(find.span, self._equations.number))
            return None
        pressed_on = unclear(self._mechanism)
        for pair in self._pairs:
            if pair.joint.kind == "pin" and pair.joint.point in pressed_on:
                self._report.add(
                    transmission_presses(find.span, pair.joint.point, has_friction=True)
                )
                return None
        plan, given = self._plan, case.given
        try:
            pressed = loaded_pairs(plan, self._equations, case.driving, self._pairs, given)
        except Undetermined as found:
            self._report.add(messages.pressed_how_hard(find.span, found.pair.joint.point))
            return None
        except LoadedByAnother as found:
            self._report.add(messages.another_load_presses(find.span, found.load, find.name))
            return None
        except Idle as found:
            self._report.add(messages.slips_either_way(find.span, found.pair.joint.point))
            return None
        return pressed

    def _taken(self) -> set[str]:
        mechanism = self._mechanism
        pose = self._plan.graph.pose
        named = (
            *mechanism.parameters,
            *mechanism.literals,
            *mechanism.loads,
            *mechanism.finds,
            *mechanism.lets,
        )
        return {item.name for item in (*named, *pose.definitions)}

    # -------------------------------------------------------------------------- forces

    def _force(
        self, find: Find, ideal: Result, force: Reaction | Axial | Normal, sense: Sense
    ) -> SolvedWithFriction | None:
        """Return a force at a joint, as large as friction everywhere makes it."""
        case = Case(ideal, self._driving, ONE, self._others(self._driving))
        pressed = self._press(find, case)
        if pressed is None:
            return None
        endings = self._endings.of(ideal.name, sense)
        if not asks_for_loads(self._mechanism):
            exact = self._closed(case, pressed, SIGNS[sense], endings) is not None
            self._remark_on_pins(case, exact=exact)
        sizes = self._sizes_of(pressed, SIGNS[sense], endings)
        found = ForceWithFriction(force, self._plan, self._driving, pressed, sizes)
        if found.transmitted is None:
            return None
        named = replace(found.at_any_pose(), case=self._default.printed(found.at_one_pose, endings))
        result = self._result(find, replace(ideal, where=()), named)
        without = self._without_friction(case)
        drive = Drive(without.formula(), self._anywhere(without.formula(), pressed, sizes).formula)
        known = self._where(ideal, drive.ideal, bound_sums(self._plan, [without]))
        where = tuple(dict.fromkeys((*found.sums(), *known, *result.where)))
        result = replace(result, where=where, drive=drive)
        return SolvedWithFriction(result, steps=(Step("iterated"),))

    # ------------------------------------------------------------------------- results

    def _result(self, find: Find, ideal: Result, named: Named) -> FrictionResult:
        pressed = self._pressed.get(ideal.name) or ()
        sums = list(self._sums(pressed))
        elsewhere = self._elsewhere(find, ideal, named)
        return FrictionResult(
            find.name,
            find.target,
            ideal.dimension,
            named.formula,
            self._where(ideal, named.formula, (*sums, *named.where)),
            guards=tuple(Require(c, ">", ZERO, find.span) for c in named.positive),
            elsewhere=elsewhere,
            case=self._case_of(find, ideal, named.case) if named.case else None,
            inside=named.inside,
        )

    def _elsewhere(self, find: Find, ideal: Result, named: Named) -> Result | None:
        """Return the result for elsewhere, if all the lengths in it are given."""
        found = self._result(find, ideal, named.elsewhere) if named.elsewhere else None
        if found is None:
            return None
        formulas = [found.formula, *(d.formula for d in found.where)]
        used = frozenset[str]().union(*map(symbols, formulas))
        return found if used.isdisjoint(self._plan.graph.pose.placeholders) else None

    def _case_of(self, find: Find, ideal: Result, printed: Printed) -> PrintedCase:
        where = self._where(ideal, printed.formula, printed.where)
        holds = (Require(f, o, ZERO, find.span) for f, o in printed.holds)
        guards = tuple(Require(c, ">", ZERO, find.span) for c in printed.positive)
        return PrintedCase(printed.formula, where, tuple(holds), guards)

    def _where(
        self, ideal: Result, formula: Formula, own: Sequence[Definition]
    ) -> tuple[Definition, ...]:
        """Return definitions with those that they rest on: of the pose, of weights."""
        formulas = [formula, *(d.formula for d in own)]
        used = {name for f in formulas for name in symbols(f)}
        weights = [Definition(n, f) for n, f in self._valued.items() if n in used]
        known = [*weights, *intermediates(self._plan.graph.pose, formulas), *ideal.where]
        return tuple(dict.fromkeys((*known, *own)))

    def _sums(self, pressed: Sequence[LoadedPair]) -> Iterable[Definition]:
        """Return the named sums that slips and pressing forces rest on."""
        yield from bound_sums(self._plan, [p.slip for p in pressed])
        for each in pressed:
            for plan, component in zip(each.plans, each.components, strict=True):
                yield from bound_sums(plan, [component.ideal, *component.by.values()])

    def _efficiency(
        self, find: Find, ideal: Result, of: LoadRatio | LoadForm, sense: Sense
    ) -> FrictionResult | None:
        named = self._solve(find, self._case(of, ideal), sense, "exact")
        if named is None:
            return None
        whole = self._result(find, ideal, named)
        return Drives(ideal, sense, self._plan).efficiency(whole, find.span)
