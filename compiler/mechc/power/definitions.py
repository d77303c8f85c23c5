"""The names that a result mentions, and what they stand for, each after those it needs."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..algebra.product import Bound, Product, Sum
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..kinematics.plan import Plan
from ..model.mechanism import Let
from ..model.result import Definition, Result

Found = Mapping[str, Result]
Lets = Mapping[str, Let]


def resting_on(plan: Plan, formula: Formula, values: Sequence[Product]) -> tuple[Definition, ...]:
    """Return the definitions that a formula rests on: intermediate angles, bound sums.

    ``values`` is the same as algebra, in which the bound sums are found.
    """
    chosen = bound_sums(plan, values)
    return (*intermediates(plan, [formula, *(d.formula for d in chosen)]), *chosen)


def bound_sums(plan: Plan, values: Iterable[Product]) -> list[Definition]:
    """Return the named sums of a plan that products rest on, in order."""
    bound = {name for value in values for name in bound_names(value)}
    chosen: list[Definition] = []
    for binding in reversed(plan.bindings):
        if binding.name in bound:
            chosen.append(Definition(binding.name, binding.value.formula()))
            bound |= set(bound_names(binding.value))
    return chosen[::-1]


def intermediates(plan: Plan, formulas: Sequence[Formula]) -> list[Definition]:
    """Return the named angles and lengths of the pose that formulas rest on, in order."""
    if not plan.graph.pose.definitions:
        return []
    used = {s for f in formulas for s in symbols(f)}
    chosen = []
    for definition in reversed(plan.graph.pose.definitions):
        if definition.name in used:
            chosen.append(Definition(*definition))
            used |= symbols(definition.formula)
    return chosen[::-1]


def bound_names(value: Product) -> Iterator[str]:
    """Yield the bound names that a product mentions, in its sums too."""
    for factor in value.factors:
        if isinstance(factor, Bound):
            yield factor.name
        elif isinstance(factor, Sum):
            for term in factor.terms:
                yield from bound_names(term)


def let_results(plan: Plan, results: Sequence[Result]) -> Iterator[Result]:
    """Yield the formulas of the user's own, with what they use as definitions."""
    mechanism = plan.graph.pose.mechanism
    found, lets = {r.name: r for r in results}, {k.name: k for k in mechanism.lets}
    for let in mechanism.lets:
        where: dict[str, Formula] = {}
        _gather(let.value, found, lets, where)
        of_the_pose = intermediates(plan, [let.value, *where.values()])
        known = [d for d in of_the_pose if d.name not in where]
        definitions = (*known, *(Definition(n, f) for n, f in where.items()))
        yield Result(let.name, None, let.dimension, let.value, definitions)


def _gather(formula: Formula, found: Found, lets: Lets, where: dict[str, Formula]) -> None:
    """Put what a formula uses into ``where``, each definition after those it needs."""
    for name in sorted(symbols(formula) - where.keys()):
        if name in found:
            for inner in found[name].where:
                where.setdefault(inner.name, inner.formula)
            where[name] = found[name].formula
        elif name in lets:
            _gather(lets[name].value, found, lets, where)
            where[name] = lets[name].value
