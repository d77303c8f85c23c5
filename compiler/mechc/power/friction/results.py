"""Ratios and loads with friction in them, and their efficiency."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from ...algebra.product import ONE, Product
from ...algebra.sums import canonical
from ...diagnostics import Report
from ...diagnostics import friction as words
from ...formula.tree import Symbol, product, quotient
from ...frozen import replace
from ...kinematics.plan import Plan
from ...model.mechanism import Efficiency, Find, LoadForm, LoadRatio, Sense, WithFriction
from ...model.result import Definition, Result
from ...units import NUMBER
from ..definitions import bound_sums, intermediates
from ..equations import Equations
from .bodies import Entangled, Task
from .chain import Chain
from .exact import Named, exact, first_order
from .pressing import Pressed, Undetermined, press
from .rubs import Rub, rubs
from .signs import AtAnyPose

SIGNS: Mapping[Sense, int] = {"tightening": 1, "releasing": -1}
"""The sign with which friction adds to the driving load."""


class Case(NamedTuple):
    """A result without friction: which load drives, by how much what is asked exceeds it."""

    ideal: Result
    driving: str
    factor: Product
    given: Mapping[str, Product]


class FrictionResults:
    """Finds what friction does to one result after another."""

    def __init__(self, plan: Plan, equations: Equations, report: Report) -> None:
        self._plan, self._equations, self._report = plan, equations, report
        self._mechanism = plan.graph.pose.mechanism
        self._rubs: tuple[Rub, ...] = rubs(plan.graph.pose)
        self._pressed: dict[str, tuple[Pressed, ...] | None] = {}

    def find(self, find: Find, ideal: Result) -> Result | None:
        """Return the result with friction; None where an error was reported."""
        match find.target:
            case WithFriction(of, sense, order):
                named = self._solve(find, self._case(of, ideal), sense, order)
                return named and self._result(find, ideal, named)
            case Efficiency(of, sense):
                return self._efficiency(find, ideal, of, sense)
            case _:
                return None

    def _case(self, of: LoadRatio | LoadForm, ideal: Result) -> Case:
        match of:
            case LoadRatio(above, below):
                upper, factor = self._equations.owner(above)
                lower, share = self._equations.owner(below)
                return Case(ideal, upper, factor, {lower: ONE / share})
            case LoadForm(load):
                others = [n for n in self._equations.columns if n != load]
                return Case(ideal, load, ONE, {n: Product.symbol(n) for n in others})

    # ------------------------------------------------------------------------- solving

    def _solve(self, find: Find, case: Case, sense: Sense, order: str) -> Named | None:
        sign, efficiency = SIGNS[sense], self._mechanism.friction.efficiency
        if efficiency is not None:
            return Named(product([(case.ideal.formula, 1), (efficiency, -sign)]), ())
        pressed = self._press(find, case)
        if pressed is None:
            return None
        if order == "first":
            return first_order(case.ideal.formula, pressed, sign)
        return self._closed(case, pressed, sign) or exact(
            case.ideal.formula, pressed, sign, self._taken()
        )

    def _closed(self, case: Case, pressed: Sequence[Pressed], sense: int) -> Named | None:
        """Return the closed form; None where the bodies do not follow one from another."""
        loads = self._mechanism.loads
        owners = {load.name: self._equations.owner(load.name) for load in loads}
        task = Task(self._plan.graph.pose, case.driving, case.given, owners, pressed)
        for cranks in (False, True):
            signs = AtAnyPose()
            try:
                load = Chain(task, cranks, signs, sense).solve()
            except Entangled:
                continue
            formula = canonical(load * case.factor).formula()
            return Named(formula, tuple(signs.definitions))
        return None

    def _press(self, find: Find, case: Case) -> tuple[Pressed, ...] | None:
        if case.ideal.name not in self._pressed:
            self._pressed[case.ideal.name] = self._try(find, case)
        return self._pressed[case.ideal.name]

    def _try(self, find: Find, case: Case) -> tuple[Pressed, ...] | None:
        if self._equations.number != 1:
            self._report.add(words.several_freedoms(find.span, self._equations.number))
            return None
        plan, given = self._plan, case.given
        try:
            pressed = press(plan, self._equations, case.driving, self._rubs, given)
        except Undetermined as found:
            self._report.add(words.pressed_how_hard(find.span, found.rub.bond.point))
            return None
        return tuple(replace(p, slip=p.slip * case.factor) for p in pressed)

    def _taken(self) -> set[str]:
        mechanism = self._mechanism
        pose = self._plan.graph.pose
        named = (*mechanism.parameters, *mechanism.loads, *mechanism.finds, *mechanism.lets)
        return {item.name for item in (*named, *pose.definitions)}

    # ------------------------------------------------------------------------- results

    def _result(self, find: Find, ideal: Result, named: Named) -> Result:
        pressed = self._pressed.get(ideal.name) or ()
        formulas = [named.formula, *(d.formula for d in named.where)]
        known = [*intermediates(self._plan, formulas), *self._sums(pressed), *ideal.where]
        where = tuple(dict.fromkeys((*known, *named.where)))
        return Result(
            find.name, find.target, ideal.dimension, named.formula, where, ideal.coefficients
        )

    def _sums(self, pressed: Sequence[Pressed]) -> Iterable[Definition]:
        """Return the named sums that slips and pressing forces rest on."""
        yield from bound_sums(self._plan, [p.slip for p in pressed])
        for each in pressed:
            for plan, component in zip(each.plans, each.components, strict=True):
                yield from bound_sums(plan, [component.ideal, *component.by.values()])

    def _efficiency(
        self, find: Find, ideal: Result, of: LoadRatio | LoadForm, sense: Sense
    ) -> Result | None:
        named = self._solve(find, self._case(of, ideal), sense, "exact")
        if named is None:
            return None
        whole = self._result(find, ideal, named)
        name = f"{ideal.name}_f"
        real = Symbol(name)
        sides = (ideal.formula, real) if sense == "tightening" else (real, ideal.formula)
        where = (*whole.where, Definition(name, named.formula))
        return replace(whole, formula=quotient(*sides), where=where, dimension=NUMBER)
