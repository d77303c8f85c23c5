"""The names that a result mentions, and what they stand for, each after those it needs."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache, partial

from ..algebra.product import Product, Sum
from ..algebra.sums import BoundSum
from ..base.frozen import on_demand, replace
from ..diagnostics import Report
from ..diagnostics import power as messages
from ..diagnostics import reactions as reaction_messages
from ..formula.tree import Formula
from ..formula.walk import reached, symbols
from ..kinematics.plan import Plan
from ..model.mechanism import Let, LoadForm, Mechanism
from ..model.result import Definition, Result
from ..model.values import Chain, user_defined
from ..pose.pose import Pose

Needed = dict[str, Formula]

MOST_STEPS = 100_000
"""Definitions that all lets together may rest on: some 450 lets, each made of the one before."""


def resting_on(plan: Plan, formula: Formula, values: Sequence[Product]) -> tuple[Definition, ...]:
    """Return the definitions that a formula rests on: intermediate angles, bound sums.

    ``values`` is the same as algebra, in which the bound sums are found.
    """
    chosen = bound_sums(plan, values)
    names = symbols(formula, *(d.formula for d in chosen))
    return (*intermediates(plan.graph.pose, names), *chosen)


def bound_sums(plan: Plan, values: Iterable[Product]) -> list[Definition]:
    """Return the named sums of a plan that products rest on, in order."""
    bound = {name for value in values for name in bound_names(value)}
    chosen: list[Definition] = []
    for binding in reversed(plan.bindings):
        if binding.name in bound:
            chosen.append(Definition(binding.name, binding.value.formula()))
            bound |= set(bound_names(binding.value))
    return chosen[::-1]


def intermediates(pose: Pose, names: Iterable[str]) -> list[Definition]:
    """Return the named angles and lengths of the pose that names rest on, in order."""
    used = set(names)
    chosen = []
    for definition in reversed(pose.definitions):
        if definition.name in used:
            chosen.append(Definition(*definition))
            used |= symbols(definition.formula)
    return chosen[::-1]


def open_lengths(plan: Plan, formulas: Iterable[Formula]) -> list[str]:
    """Return the lengths that the description leaves open and formulas depend on: ``AB``."""
    lengths = plan.graph.pose.placeholders
    used = symbols(*formulas) if lengths else ()
    return [n.removeprefix("len_") for n in lengths if n in used]


def bound_names(value: Product) -> Iterator[str]:
    """Yield the bound names that a product mentions, in its sums too."""
    for factor in value.factors:
        if isinstance(factor, BoundSum):
            yield factor.name
        elif isinstance(factor, Sum):
            for term in factor.terms:
                yield from bound_names(term)


def let_results(pose: Pose, results: Sequence[Result], report: Report) -> Iterator[Result]:
    """Yield the formulas of the user's own, with what they use as definitions.

    E831 where so many of them rest on one another that nothing can be done with them, E515
    where one rests on loads each of which is found from the other.
    """
    mechanism = pose.mechanism
    lets = _tied(mechanism, results) | user_defined(mechanism)
    needs = _needs(results, lets)
    if sum(map(len, needs.values())) > MOST_STEPS:
        longest = max(mechanism.lets, key=lambda let: len(needs[let.name]))
        raise report.fail(
            messages.too_many_lets(longest.span, longest.name, len(needs[longest.name]))
        )
    _refuse_circles(mechanism.lets, needs, results, report)
    other = cache(lambda: _needs([r.elsewhere or r for r in results], lets))
    for let in mechanism.lets:
        used = [r for r in results if r.name in needs[let.name]]
        found = _let(let, pose, needs[let.name], used)
        there = partial(_elsewhere, let, pose, used, other)
        yield replace(found, elsewhere=on_demand(there)) if used else found


def _elsewhere(
    let: Let, pose: Pose, used: Sequence[Result], other: Callable[[], Mapping[str, Needed]]
) -> Result | None:
    """Return a formula of the user's own with the other forms of the results that it uses."""
    if not any(r.elsewhere for r in used):
        return None
    return _let(let, pose, other()[let.name], [r.elsewhere or r for r in used])


def _tied(mechanism: Mechanism, results: Iterable[Result]) -> dict[str, Formula]:
    """Return the formulas of loads that have one, such as weights, and are not found otherwise."""
    found = {result.name for result in results}
    return {k.name: k.tie for k in mechanism.loads if k.tie is not None and k.name not in found}


def _refuse_circles(
    lets: Sequence[Let], needs: Mapping[str, Needed], results: Sequence[Result], report: Report
) -> None:
    """Report every formula that rests on a load which is found from what is found from it."""
    loads = [r.name for r in results if isinstance(r.target, LoadForm)]
    for let in lets:
        defined = {**needs[let.name], let.name: let.value}
        for load in (name for name in loads if name in defined):
            if through := _back_to(load, defined):
                report.add(reaction_messages.found_from_itself(let.span, let.name, load, through))
                break
    report.stop_on_errors()


def _back_to(name: str, defined: Needed) -> list[str]:
    """Return the names in a definition that rest on the definition itself."""
    first = sorted(symbols(defined[name]) & defined.keys())
    return [other for other in first if name in reached([other], defined)]


def _let(let: Let, pose: Pose, where: Needed, used: Sequence[Result]) -> Result:
    """Return a formula of the user's own; it stands where the results stand that it uses."""
    of_the_pose = intermediates(pose, symbols(let.value, *where.values()))
    known = [d for d in of_the_pose if d.name not in where]
    definitions = (*known, *(Definition(n, f) for n, f in where.items()))
    guards = tuple(dict.fromkeys(g for r in used for g in r.guards))
    return Result(
        let.name, None, let.dimension, let.value, definitions, guards=guards, label=let.label
    )


def _needs(results: Sequence[Result], lets: Mapping[str, Formula]) -> dict[str, Needed]:
    """Return the definitions under each let, each after those it needs."""
    whole = {r.name: {**{d.name: d.formula for d in r.where}, r.name: r.formula} for r in results}
    needs: dict[str, Needed] = {}
    for name, formula in Chain(lets).definitions:
        used = [whole[s] for s in sorted(symbols(formula)) if s in whole]
        needs[name] = {n: f for part in used for n, f in part.items()}
        whole[name] = {**needs[name], name: formula}
    return needs
