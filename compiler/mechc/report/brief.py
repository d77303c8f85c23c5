"""A derivation in brief, as a table of mechanisms has it: no words between the formulas."""

from collections.abc import Iterable, Iterator

from ..formula.operations import count_operations
from ..formula.tree import Formula, Sum, Symbol, product
from ..model.mechanism import LoadRatio, Mechanism
from ..model.values import is_constant
from .evaluated import Evaluated
from .sections import ReportOutline
from .sentences.remarks import asked
from .sentences.wording import EquationSides, lines
from .steps import Derivation, Equation

MOST_REPEATED_OPERATIONS = 24
"""A ratio of more operations than this is not written out a second time."""


MOST_POSITION_VALUES = 12
"""With more values than this the numbers put into those of the position would fill a page."""


def relations(derivation: Derivation) -> Iterator[EquationSides]:
    """Yield the equations of each step, solved for the new speeds where its rule is not."""
    for step in derivation.steps:
        said, hence = lines(step)
        yield from map(_at_once, hence or said)


def _at_once(sides: EquationSides) -> EquationSides:
    """Return a chain without what it goes on to behind a sum, which takes a line by itself."""
    return sides[:2] if isinstance(sides[1], Sum) else sides


def short(
    found: Iterable[Evaluated], derivation: Derivation, mechanism: Mechanism
) -> Iterator[Evaluated]:
    """Yield values, those of results with the numbers put in, of what they rest on without.

    Angles and lengths of a drawing stand as numbers among the formulas already.
    """
    results = {asked(result) for result in derivation.results}
    shown = {Symbol(p.name) for p in mechanism.parameters if is_constant(p)}
    for item in found:
        if item.left in results:
            yield item
        elif item.left not in shown:
            yield item._replace(numbers=None, formula=None)


def at_length(
    found: Iterable[Evaluated], whole: ReportOutline
) -> tuple[tuple[Evaluated, ...], tuple[Evaluated, ...]]:
    """Return values of which the numbers are not shown, and those of which they are.

    Only where they are many are those of the position among the former.
    """
    every = tuple(found)
    position = {Symbol(d.name) for section in whole.position for d in section.where}
    aside = tuple(e for e in every if len(every) > MOST_POSITION_VALUES and e.left in position)
    return aside, tuple(e for e in every if e not in aside)


def needed(derivation: Derivation) -> Iterator[Equation]:
    """Yield the load above the line of each ratio of loads: ``P = F·a/b``."""
    for result in derivation.results:
        match result.target:
            case LoadRatio(above, below) if above != below:
                is_long = count_operations(result.formula) > MOST_REPEATED_OPERATIONS
                factor: Formula = Symbol(result.name) if is_long else result.formula
                yield Equation(Symbol(above), product([(Symbol(below), 1), (factor, 1)]))
