"""How formulas are turned to be read: as a person writes the angles in them."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from functools import cache, partial

from ..algebra.from_formula import to_product
from ..algebra.intervals import IntervalBox, sign
from ..base.frozen import replace
from ..formula.differences import (
    MOST_READ_OPERATIONS,
    LazyValues,
    differences_as_in,
    positive_sines,
    with_positive_sines,
    zero_as_written,
)
from ..formula.layout import over_line
from ..formula.operations import count_operations
from ..formula.rewriting import plus_first, rewritten, without_sign
from ..formula.tree import (
    ONE,
    ZERO,
    Call,
    Formula,
    Product,
    Sum,
    is_call,
    negative,
    number,
    product,
    total,
)
from ..formula.walk import symbols, walk
from ..formula.ways_round import Difference, ways_round, written_round
from ..kinematics.plan import Plan
from ..model.boxes import given_box, size_box, with_angles
from ..model.mechanism import Mechanism, Require, WithFriction
from ..model.result import Definition
from ..model.values import completed
from ..pose.given_angles import given_lines
from ..pose.pose import Pose
from ..power.numbers import default_values
from ..study.analysis import Analysis, Vanishing
from .definitions import plus_condition
from .sentences.order import geometry_first

_SIGN_OF = {">": 1, "<": -1}
"""The sign of what is compared with zero, by the operators that ask for one."""


def _without_bars(formula: Formula, ranges: Callable[[], IntervalBox]) -> Formula:
    """Return a formula in which no bars stand about factors of one sign over the ranges.

    Outside them the formula may have another sign: that is for readers of pages, who have the
    ranges.

    >>> from ..algebra.intervals import NumberInterval
    >>> from ..formula.tree import Symbol
    >>> beta, force = Call("cos", (Symbol("beta"),)), Symbol("F")
    >>> size = Call("abs", (product([(beta, 1), (force, 1)]),))
    >>> _without_bars(size, lambda: {"beta": NumberInterval(0.1, 0.7)}) == product(
    ...     [(beta, 1), (Call("abs", (force,)), 1)]
    ... )
    True
    """

    def bare(whole: Formula) -> Formula | None:
        match whole:
            case Call("abs", (inner,)):
                factors = inner.factors if isinstance(inner, Product) else (inner,)
                senses = [(f, sign(to_product(f), ranges()) or 0) for f in factors]
                open_ = product((f, 1) for f, sense in senses if not sense)
                known = [(product([(number(sense), 1), (f, 1)]), 1) for f, sense in senses if sense]
                left = [] if open_ == ONE else [(Call("abs", (open_,)), 1)]
                return product([*known, *left]) if known else None
        return None

    is_barred = any(is_call(part, "abs") for part in walk(formula))
    return rewritten(formula, bare) if is_barred else formula


def _terms(formula: Formula) -> frozenset[Formula]:
    """Return the terms of a sum, whatever their order; none of what is no sum."""
    return frozenset(formula.terms) if isinstance(formula, Sum) else frozenset()


class ReadableFormulas:
    """Writes formulas as :func:`with_positive_sines` does, at the default pose of a plan."""

    def __init__(
        self,
        plan: Plan,
        turns: Set[str] = frozenset(),
        box: Callable[[Mechanism], IntervalBox] = given_box,
    ) -> None:
        """Take the angles by which friction ``turns`` forces: they stand behind others.

        In the ``box`` of a mechanism's values signs are looked for that need no bars.
        """
        self._turns = turns
        self._ways: Set[Difference] = frozenset()
        pose = plan.graph.pose
        self._found = {definition.name for definition in pose.definitions}
        self._values: LazyValues = cache(partial(default_values, plan))
        self._quarter = given_lines(pose)
        self._ranges = cache(lambda: with_angles(box(pose.mechanism), pose.definitions))
        self._loads = {load.name for load in pose.mechanism.loads}

    def of(self, formula: Formula, longer: int = 0) -> Formula:
        """Return a formula with its sines of differences turned, its sums led by a plus.

        Its quotients have whole numbers, not decimals, and nothing stands between bars that has one
        sign in the box of values. For an angle that is given it may grow
        ``longer`` by so many operations.
        """
        formula = _without_bars(formula, self._ranges)
        written = over_line(with_positive_sines(formula, self._values, self._quarter, longer))
        if count_operations(written) > MOST_READ_OPERATIONS:
            return written
        if not self._turns.isdisjoint(symbols(formula)):
            written = geometry_first(written, self._turns)
        return plus_first(written_round(written, self._ways, self._turns))

    def sines(self, formulas: Iterable[Formula]) -> Sequence[Formula]:
        """Return the sines of differences that are written in formulas as a person has them."""
        return positive_sines(formulas, self._values)

    def zero(self, limit: Vanishing, formula: Formula) -> Vanishing:
        """Return a condition under which a formula is zero or infinite as the formula has it."""
        conditions = (limit.factor, *limit.except_where)
        factor, *others = (self._condition(f, formula) for f in conditions)
        return limit._replace(factor=factor, except_where=tuple(others))

    def _condition(self, factor: Formula, formula: Formula) -> Formula:
        """Return a factor that is zero as a formula has it, else as it would be written alone."""
        if factor in walk(formula):
            return factor
        turned = zero_as_written(factor, self._values, self._quarter)
        both = (factor, turned)
        opposite = (total(map(negative, s.terms)) for s in both if isinstance(s, Sum))
        shown = [without_sign(differences_as_in(one, formula)) for one in (*both, *opposite)]
        sums = {frozenset(s.terms): s for s in walk(formula) if isinstance(s, Sum)}
        ordered = (sums.get(_terms(one), one) for one in shown)
        return next((one for one in ordered if one in walk(formula)), turned)

    def result(self, result: Analysis) -> Analysis:
        """Return a result; what is said of its formula mentions the same parts as that does."""
        formula = self.of(result.formula)
        zeros = tuple(self.zero(limit, formula) for limit in result.zeros)
        poles = tuple(self.zero(limit, formula) for limit in result.poles)
        slopes = result.derivatives
        derivatives = slopes and {
            n: differences_as_in(self.of(s), formula) for n, s in slopes.items()
        }
        where = tuple(d._replace(formula=self._defined(d)) for d in result.where)
        holds = tuple(h for h in map(self._held, result.holds) if not self._is_given(h))
        result = replace(result, where=where, holds=holds, derivatives=derivatives)
        return replace(result, formula=formula, zeros=zeros, poles=poles)

    def results(self, results: Sequence[Analysis]) -> tuple[Analysis, ...]:
        """Return results, at values with those of the definitions that they rest on.

        Their differences of angles are one way round, as are those of what is written later.
        """
        self._values = cache(partial(_with_definitions, self._values, results))
        shown = tuple(map(self.result, results))
        self._ways = ways_round(self._formulas(shown), self._values, self._turns)
        return tuple(map(self.result, shown))

    def _formulas(self, results: Iterable[Analysis]) -> Iterator[Formula]:
        """Yield the formulas of results and of what they rest on, but for what loops give."""
        for result in results:
            yield result.formula
            yield from (d.formula for d in result.where if d.name not in self._found)
            yield from (condition.left for condition in result.holds)

    def _held(self, condition: Require) -> Require:
        """Return a condition as results are written; what has a minus is turned round."""
        return plus_condition(replace(condition, left=self.of(condition.left)))

    def _is_given(self, condition: Require) -> bool:
        """Return whether a condition is one of loads alone, and their sizes given meet it."""
        names, right = symbols(condition.left), condition.right
        if not names or not names <= self._loads or right != ZERO:
            return False
        return _SIGN_OF.get(condition.operator) == sign(to_product(condition.left), self._ranges())

    def _defined(self, definition: Definition) -> Formula:
        """Return a definition as results are written; one that loops give is so already."""
        formula = definition.formula
        return self._turned(formula) if definition.name in self._found else self.of(formula)

    def _turned(self, formula: Formula) -> Formula:
        """Return a formula with an angle of friction in front as it is written, else as it is."""
        if self._turns.isdisjoint(symbols(formula)):
            return formula
        return formula if geometry_first(formula, self._turns) == formula else self.of(formula)


def _with_definitions(values: LazyValues, results: Iterable[Analysis]) -> Mapping[str, float]:
    """Return values with those of the angles and forces that results with friction rest on."""
    known = dict(values())
    for result in results:
        known |= completed(known, (d for d in result.stated if d.name not in known))
    return known


def readable_results(plan: Plan, results: Sequence[Analysis]) -> tuple[Analysis, ...]:
    """Return the results of a plan as pages have them, but valid beyond the ranges given."""
    face = ReadableFormulas(plan, turns_of_friction(results, plan.graph.pose), size_box)
    return face.results(results)


def turns_of_friction(results: Sequence[Analysis], pose: Pose) -> Set[str]:
    """Return the names of angles by which friction turns a force, none that loops give."""
    of_loops = {definition.name for definition in pose.definitions}
    found = (d for r in results if isinstance(r.target, WithFriction) for d in r.where)
    turned = {d.name for d in found if is_call(d.formula, "asin", "atan")}
    return pose.mechanism.friction.parameters | (turned - of_loops)
