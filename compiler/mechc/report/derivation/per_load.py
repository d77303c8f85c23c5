"""A ratio of loads by forces per unit of the load below the line, not by ratios of speeds.

Where the ratio is long it rests on named ratios of speeds, ``i_AB``. Sums of forces and moments
know nothing of these: there it is written by the forces that they give, each divided by the load.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ...base.frozen import replace
from ...equilibrium.equilibrium import Equilibrium, LoadTerms
from ...formula.names import another
from ...formula.tree import Formula, Symbol, product, quotient, total
from ...formula.walk import symbols
from ...friction.solution import FrictionSolution
from ...model.mechanism import LoadRatio
from ...model.result import Definition
from ...power.definitions import intermediates
from ...study.analysis import Analysis
from ..kinds import SentenceKind
from ..sentences.order import positive_first
from ..steps import Equation, Explanation, Paragraph


def by_forces(
    solution: FrictionSolution,
    loads: Iterable[Equilibrium],
    results: Sequence[Analysis],
    explanations: Iterable[Explanation],
) -> tuple[tuple[Analysis, ...], tuple[Explanation, ...]]:
    """Return results and their explanations, ratios by forces where they rest on those of speeds.

    An explanation ends in what these forces are divided by.
    """
    speeds = {ratio.name for ratio in solution.balance.reading.ratios.values()}
    by_name = {equilibrium.result: equilibrium for equilibrium in loads}
    taken = {name for result in results for name in _names(result)}
    found, ends = list[Analysis](), dict[str, Paragraph]()
    for result in results:
        equilibrium = by_name.get(result.name)
        if equilibrium is None or speeds.isdisjoint(d.name for d in result.where):
            found.append(result)
            continue
        written = _by_forces(result, equilibrium, solution, taken)
        found.append(written[0] if written else result)
        ends |= {result.name: written[1]} if written else {}
    return tuple(found), tuple(_with_ends(explanations, ends))


def _with_ends(
    explanations: Iterable[Explanation], ends: Mapping[str, Paragraph]
) -> Iterator[Explanation]:
    for each in explanations:
        more = tuple(ends[name] for name in each.results if name in ends)
        yield replace(each, paragraphs=(*each.paragraphs, *more)) if more else each


def _by_forces(
    result: Analysis, equilibrium: Equilibrium, solution: FrictionSolution, taken: Set[str]
) -> tuple[Analysis, Paragraph] | None:
    """Return a ratio by forces, and what they are; None where they rest on more than one load."""
    target = result.target
    if not isinstance(target, LoadRatio) or equilibrium.load != target.above:
        return None
    steps = [found for step in equilibrium.steps for found in step.found]
    *forces, last = steps
    names = {force.name: _free(force.name, taken) for force in forces}
    if last.name != target.above or not all(
        force.terms.keys() <= {*names, target.below} for force in steps
    ):
        return None
    own = [Definition(names[force.name], _divided(force.terms, names)) for force in forces]
    formula = _divided(last.terms, names)
    used = symbols(formula, *(definition.formula for definition in own))
    where = (*intermediates(solution.plan.graph.pose, used), *own)
    per = [
        Equation(Symbol(name), quotient(Symbol(force), Symbol(target.below)))
        for force, name in names.items()
    ]
    paragraph = Paragraph(
        SentenceKind.FORCES_PER_LOAD, tuple(per), formulas={"load": Symbol(target.below)}
    )
    return replace(result, formula=formula, where=where), paragraph


def _divided(terms: LoadTerms, names: Mapping[str, str]) -> Formula:
    """Return a sum of forces divided by the load that all of them are proportional to."""
    return total(
        positive_first(
            product([(part.formula(), 1), *([(Symbol(names[name]), 1)] if name in names else [])])
            for name, part in terms.items()
        )
    )


def _free(force: str, taken: Set[str]) -> str:
    """Return a name for a force divided by a load: ``n_AB`` for ``N_AB``.

    >>> _free("N_AB", set()), _free("X_O", set()), _free("N_AB", {"n_AB"})
    ('n_AB', 'n_XO', 'n_AB_2')
    """
    head, _, rest = force.partition("_")
    name = f"n_{rest}" if head == "N" else f"n_{force.replace('_', '')}"
    while name in taken:
        name = another(name)
    return name


def _names(result: Analysis) -> Iterator[str]:
    yield result.name
    yield from symbols(result.formula)
    for definition in result.where:
        yield definition.name
        yield from symbols(definition.formula)
