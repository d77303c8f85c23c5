"""A closed form: as code takes it, and as it is printed."""

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from fractions import Fraction
from itertools import combinations
from typing import Protocol

from ..algebra.factors import Factor, Trig
from ..algebra.product import Product, Sum
from ..algebra.sums import add, canonical
from ..base.frozen import frozen
from ..formula.evaluate import evaluate
from ..formula.operations import count_operations
from ..formula.tree import Formula, number, product, total
from ..formula.walk import Substitution, symbols
from ..kinematics.plan import Plan
from ..model.boxes import allowed_box, with_angles
from ..model.result import Definition
from ..model.values import Chain, completed, user_defined
from ..power.numbers import default_values, values_near_default
from .chain_bodies import EquationsCoupled
from .naming import Meanings, OwnNames, renamed
from .signs.at_any_pose import AtAnyPose
from .signs.at_one_pose import SignsAtOnePose
from .signs.conditions import Operator, SignCondition, conditions, positive
from .signs.names import SignSymbols
from .solution import FrictionStep
from .tolerances import AWAY_FROM_POSE, STAYS_ZERO


@frozen
class PrintedFormula:
    """A formula for the signs of one pose, and the conditions under which they stay.

    What is ``positive`` must stay so as well, or nothing balances as the formula says.
    """

    formula: Formula
    where: tuple[Definition, ...]
    holds: tuple[tuple[Formula, Operator], ...]
    steps: tuple[FrictionStep, ...] = ()
    positive: tuple[Formula, ...] = ()


@frozen
class DefinedFormula:
    """A formula and what it rests on, each definition after those it needs.

    What is ``positive`` must stay so, or the formula has no meaning, and the one that
    ``elsewhere`` makes takes its place. ``case`` is the same as it is printed; ``steps`` are how
    it was found where there is none. Names ``inside`` are the coefficients of a system, of which
    people read the structure only.
    """

    formula: Formula
    where: tuple[Definition, ...] = ()
    positive: tuple[Formula, ...] = ()
    case: PrintedFormula | None = None
    steps: tuple[FrictionStep, ...] = ()
    inside: frozenset[str] = frozenset()
    elsewhere: "Callable[[], DefinedFormula] | None" = None


class ClosedFormSolver(Protocol):
    """A way to solve for the driving load, and what its formula takes for granted then."""

    conditions: list[SignCondition]

    @property
    def steps(self) -> Sequence[FrictionStep]:
        """Return the steps taken so far."""
        ...

    def solve(self) -> Sequence[Product]:
        """Return the parts that the driving load is the sum of.

        Raises :class:`~.chain_bodies.EquationsCoupled` where there is no closed form.
        """
        ...


def closed_form(
    way: Callable[[SignSymbols], ClosedFormSolver], factor: Product, signs: AtAnyPose
) -> DefinedFormula:
    """Return the driving load times a factor, with signs that follow from the pose."""
    solver = way(signs)
    formula = shortest(solver.solve(), factor)
    return DefinedFormula(formula, tuple(signs.definitions), positive(solver.conditions))


def printed_form(
    way: Callable[[SignSymbols], ClosedFormSolver], factor: Product, signs: SignsAtOnePose
) -> PrintedFormula:
    """Return the driving load times a factor, for the signs of one pose."""
    solver = way(signs)
    formula = shortest(solver.solve(), factor)
    where, steps = tuple(signs.definitions), tuple(solver.steps)
    return PrintedFormula(formula, where, conditions(signs), steps, positive(solver.conditions))


def power(times: Fraction, factor: Formula, force: Formula, slip: Formula) -> Formula:
    """Return the part of the driving load that frictions add which are there so many times."""
    return product([(number(times), 1), (factor, 1), (force, 1), (slip, 1)])


def shortest(parts: Sequence[Product], factor: Product) -> Formula:
    """Return a sum of parts times a factor, each apart or with the first, as is shorter.

    Over one line are a thread and its load, next to them a collar: d·tan(ψ + ρ)/2 + f·r.
    """
    first, *others = parts
    places = range(len(others))
    ways = [c for n in reversed((*places, len(others))) for c in combinations(places, n)]
    return min((_apart(first, others, way, factor) for way in ways), key=count_operations)


def _apart(
    first: Product, others: Sequence[Product], together: Sequence[int], factor: Product
) -> Formula:
    """Return a sum in which some of the others are put together with the first."""
    whole = add((first, *(others[i] for i in together)))
    rest = (part for i, part in enumerate(others) if i not in together)
    return total(readable(canonical(part * factor)) for part in (whole, *rest))


def readable(value: Product) -> Formula:
    """Return a product in its shortest form: a sum may be divided by a sine or cosine first.

    (sin u + c·cos u)/cos u reads better as tan u + c.
    """
    return min((value.formula(), *_divided(value)), key=count_operations)


def _divided(value: Product) -> Iterator[Formula]:
    """Yield the product with a sum divided by what stands across the line, term by term."""
    for sum_, exponent in value.factors.items():
        if not isinstance(sum_, Sum) or abs(exponent) != 1:
            continue
        others = {f: -e * exponent for f, e in value.factors.items() if e * exponent < 0}
        trigs: dict[Factor, int] = {f: e for f, e in others.items() if isinstance(f, Trig)}
        for below in (Product(1, trigs), Product(1, others)):
            rest = value * Product(1, {sum_: -exponent}) * below**exponent
            terms = total((term / below).formula() for term in sum_.terms)
            yield product([(rest.formula(), 1), (terms, exponent)])


# ------------------------------------------------------------------------------------- default pose


class DefaultPose:
    """The default pose's values; ``valued`` are loads of known size, by formula."""

    def __init__(self, plan: Plan, valued: Mapping[str, Formula], taken: Set[str]) -> None:
        self._mechanism = plan.graph.pose.mechanism
        self._plan, self._valued, self._taken = plan, valued, taken
        self.meanings = Meanings()

    def printed(
        self, way: Callable[[SignsAtOnePose], PrintedFormula], endings: Sequence[str]
    ) -> PrintedFormula | None:
        """Return the printed result at the pose; None where a value or a sign is missing."""
        values = self.values()
        box = with_angles(allowed_box(self._mechanism), self._plan.graph.pose.definitions)
        taken = values.keys() | self._taken
        try:
            found = way(
                SignsAtOnePose(taken, self.meanings, endings, values, box, OwnNames(self._own()))
            )
        except (KeyError, EquationsCoupled):
            return None
        if self._is_alone(found):
            return None
        self.meanings.note(found.where)
        return found

    def _is_alone(self, found: PrintedFormula) -> bool:
        """Return whether a sign is zero at the pose and not next to it: at a dead centre.

        What holds there holds nowhere else. A pin that is at rest all along has none as well.
        """
        zeros = [formula for formula, operator in found.holds if operator == "="]
        if not zeros:
            return False
        moved = values_near_default(self._plan.graph.pose, AWAY_FROM_POSE)
        known = completed({**self.values(), **moved}, found.where)
        return any(abs(evaluate(formula, known)) > STAYS_ZERO for formula in zeros)

    def in_free_names(self, found: DefinedFormula, endings: Sequence[str]) -> DefinedFormula:
        """Return a result of code in names that mean nothing else in what is printed."""
        taken = {*default_values(self._plan), *self._taken}
        names = renamed(found.where, self.meanings, endings, taken)
        put = Substitution(names)
        where = tuple(
            Definition(names[name].name if name in names else name, put.of(formula))
            for name, formula in found.where
        )
        self.meanings.note(where)
        return DefinedFormula(put.of(found.formula), where, tuple(map(put.of, found.positive)))

    def _own(self) -> Iterator[Definition]:
        """Yield the user's own formulas of parameters alone, each after those it needs."""
        known = {p.name for p in (*self._mechanism.parameters, *self._mechanism.literals)}
        for name, formula in Chain(user_defined(self._mechanism)).definitions:
            if symbols(formula) <= known:
                known.add(name)
                yield Definition(name, formula)

    def balances(self, printed: PrintedFormula) -> bool:
        """Return whether forces have at the pose the senses that a printed result gives them."""
        known = completed(self.values(), printed.where)
        return all(evaluate(force, known) > 0 for force in printed.positive)

    def values(self) -> dict[str, float]:
        """Return the values, with loads of unknown size near 1, none like another.

        Equal ones may cancel in a joint; the order of lines may not change them.
        """
        loads = sorted(self._mechanism.loads, key=lambda load: load.name)
        values = {load.name: 1 + i / 7 for i, load in enumerate(loads)}
        values |= default_values(self._plan)
        for name, formula in self._valued.items():
            if symbols(formula) <= values.keys():
                values[name] = evaluate(formula, values)
        return values
