"""What a balance promises, as a check for tests and for whoever solves power equations."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ..algebra.matrices import independent
from ..algebra.modular import ModularPoint
from ..algebra.product import Product
from ..formula.evaluate import evaluate
from ..formula.tree import Formula, Implicit, Symbol
from ..formula.walk import substitute, symbols, walk
from ..model.mechanism import LoadRatio, Mechanism, Parameter, Torque
from ..model.result import Definition, Result
from ..units import Dimension
from .balance import AlgebraicResult, Balance, PowerEquations
from .numbers import default_values
from .tolerances import SAME_IN_OTHER_UNITS, SAME_RESULT

SCALES = (2.0, 3.0, 5.0)
"""What the units of length, mass and time are multiplied by to see a dimension."""


def broken_promises(balance: Balance) -> list[str]:
    """Return a sentence for each promise of this folder that a balance breaks."""
    found = [*_terms(balance), *_columns(balance)]
    for solved in balance.solved:
        found += _names(solved.result, balance.plan.graph.pose.mechanism)
        found += _linear(solved.result, balance)
        found += _balanced(solved, balance.equations)
        found += _dimension(solved.result, balance)
    return found


def _terms(balance: Balance) -> Iterator[str]:
    """Yield in what the terms of the power equation do not fit loads and degrees of freedom."""
    mechanism, mobility = balance.plan.graph.pose.mechanism, balance.plan.mobility
    if [t.load.name for t in balance.terms] != [k.name for k in mechanism.loads]:
        yield "the terms are not those of the loads in declared order"
    for term in balance.terms:
        if len(term.speed) != mobility:
            yield f"{term.load.name} has no speed for each of {mobility} motions"
        if isinstance(term.load, Torque) != (term.line is None):
            yield f"{term.load.name} has a line that its kind does not have"
    columns = balance.equations.columns
    yield from (
        f"{name} drives and does no work" for name in balance.driving if name not in columns
    )


# -------------------------------------------------------- at a random point of a field


def _columns(balance: Balance) -> Iterator[str]:
    """Yield the faults of the columns: each is the power of its load and those tied to it."""
    equations, point = balance.equations, ModularPoint()
    sums = {name: [0] * balance.plan.mobility for name, _ in equations.owners.values()}
    for term in balance.terms:
        owner, factor = equations.owners[term.load.name]
        for i, power in enumerate(term.power):
            sums[owner][i] += (power * factor).residue(point)
    for name, parts in sums.items():
        whole = [p.residue(point) for p in equations.powers.get(name, [])] or [0] * len(parts)
        if [part % point.prime for part in parts] != whole:
            yield f"the column of {name} is not the power of what is tied to it"
        if (name in equations.powers) == (name in equations.idle_loads):
            yield f"{name} is neither idle nor does it work"
    for name, column in equations.columns.items():
        kept = [p for i, p in enumerate(equations.powers[name]) if i not in equations.idle_motions]
        if column != kept:
            yield f"the column of {name} is of other motions than those that move loads"


def _balanced(solved: AlgebraicResult, equations: PowerEquations) -> Iterator[str]:
    """Yield a ratio of loads with which the power equations do not vanish."""
    if not isinstance(solved.result.target, LoadRatio) or solved.value is None:
        return
    (above, factor), (below, other) = map(equations.owner, (solved.above, solved.below))
    if above == below or not solved.value:
        return
    loads = {above: solved.value * other / factor, below: Product(1)}
    rest = [name for name in equations.columns if name not in loads]
    rows = [*(_residues(equations, {name: Product(1)}) for name in rest)]
    if independent([*rows, _residues(equations, loads)])[-1]:
        yield f"{solved.result.name} does not balance {solved.above} and {solved.below}"


def _residues(equations: PowerEquations, loads: Mapping[str, Product]) -> dict[int, int]:
    """Return the power of some loads in each independent motion, without zeros."""
    point = ModularPoint()
    sums = {
        i: sum((size * equations.columns[n][i]).residue(point) for n, size in loads.items())
        for i in range(equations.number)
    }
    return {i: found % point.prime for i, found in sums.items() if found % point.prime}


# ---------------------------------------------------------------------------- formulas


def _names(result: Result, mechanism: Mechanism) -> Iterator[str]:
    """Yield the names without a definition in a result, and the loads in its coefficients."""
    loads = {load.name for load in mechanism.loads}
    known = {p.name for p in mechanism.parameters} | loads
    yield from undefined(result.name, result.formula, result.where, known)
    if result.coefficients is None:
        return
    for load, coefficient in result.coefficients.items():
        if load not in loads:
            yield f"{result.name} has a coefficient of {load}, which is no load"
        yield from (f"the coefficient of {load} in {result.name} uses load {n}"
                    for n in sorted(symbols(coefficient) & loads))  # fmt: skip


def undefined(
    name: str, formula: Formula, where: Sequence[Definition], given: Set[str]
) -> Iterator[str]:
    """Yield the names that a result uses too early, defines twice, or leaves without meaning."""
    known, defined = set(given), set[str]()
    for step, value in where:
        yield from (f"{step} of {name} uses {n} too early" for n in sorted(symbols(value) - known))
        if step in defined:
            yield f"{step} of {name} is defined twice"
        defined.add(step)
        known.add(step)
    yield from (f"{name} uses {n}" for n in sorted(symbols(formula) - known))


def _linear(result: Result, balance: Balance) -> Iterator[str]:
    """Yield a load that is not the sum of the others, each by its coefficient."""
    if result.coefficients is None:
        return
    values = _with_loads(balance)
    _complete(values, result.where)
    if not symbols(result.formula) <= values.keys():
        return
    parts = (evaluate(c, values) * values[n] for n, c in result.coefficients.items())
    whole, summed = evaluate(result.formula, values), math.fsum(parts)
    if not math.isclose(whole, summed, rel_tol=SAME_RESULT, abs_tol=SAME_RESULT):
        yield f"{result.name} is {whole:.9g}, by its coefficients {summed:.9g}"


def _dimension(result: Result, balance: Balance) -> Iterator[str]:
    """Yield a result that other units of length, mass and time change as its dimension does not.

    The formulas of systems that are solved by iteration are left out: their guesses are numbers.
    """
    where = [Definition(n, _as_symbols(f, balance)) for n, f in result.where]
    formulas = [_as_symbols(result.formula, balance), *(d.formula for d in where)]
    if any(isinstance(part, Implicit) for f in formulas for part in walk(f)):
        return
    before, after = _with_loads(balance), _scaled(balance)
    for values in (before, after):
        _complete(values, where)
        if not symbols(formulas[0]) <= values.keys():
            return
    found, expected = (evaluate(formulas[0], values) for values in (after, before))
    expected *= _factor(result.dimension)
    if not math.isnan(found) and not math.isclose(
        found, expected, rel_tol=SAME_IN_OTHER_UNITS, abs_tol=SAME_RESULT
    ):
        yield f"{result.name} does not have its dimension"


def _as_symbols(formula: Formula, balance: Balance) -> Formula:
    """Return a formula in which the numbers under names are open."""
    literals = balance.plan.graph.pose.mechanism.literals
    return substitute(formula, {p.name: Symbol(p.name) for p in literals})


def _with_loads(balance: Balance) -> dict[str, float]:
    """Return the numbers of the default pose, of each literal, and one of each load."""
    mechanism = balance.plan.graph.pose.mechanism
    loads = {load.name: 1 + i / 7 for i, load in enumerate(mechanism.loads)}
    literals = {p.name: evaluate(p.value, {}) for p in mechanism.literals if p.value}
    return {**loads, **literals, **default_values(balance.plan)}


def _scaled(balance: Balance) -> dict[str, float]:
    """Return the default pose and loads in other units; what follows is left to be found anew."""
    mechanism, values = balance.plan.graph.pose.mechanism, _with_loads(balance)
    parameters: Iterable[Parameter] = (*mechanism.parameters, *mechanism.literals)
    dimensions = {p.name: p.dimension for p in parameters}
    dimensions |= {load.name: load.dimension for load in mechanism.loads}
    return {n: values[n] * _factor(d) for n, d in dimensions.items() if n in values}


def _factor(dimension: Dimension) -> float:
    exponents = dimension[: len(SCALES)]
    powers = (math.pow(scale, e) for scale, e in zip(SCALES, exponents, strict=True))
    return math.prod(powers)


def _complete(values: dict[str, float], where: Iterable[Definition]) -> None:
    """Add what follows; what has a number already, such as a load of known size, keeps it."""
    for name, formula in where:
        if name not in values and symbols(formula) <= values.keys():
            values[name] = evaluate(formula, values)
