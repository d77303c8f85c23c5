"""Where a length that loops find is infinite: a result that rests on it may jump there."""

from collections.abc import Iterable, Iterator, Mapping

from ..algebra.angle import RADIAN
from ..algebra.factors import Factor, Trig
from ..algebra.from_formula import to_product
from ..algebra.product import Sum
from ..algebra.sums import Bound
from ..formula.evaluate import evaluate
from ..formula.tree import Call, Formula, Power, Product
from ..formula.tree import Sum as Terms
from ..formula.walk import symbols, walk
from ..model.result import Definition
from .analysis import Break


def breaks(where: Iterable[Definition], near: Mapping[str, float]) -> tuple[Break, ...]:
    """Return the conditions under which what loops find is infinite, each of them once."""
    found: dict[Factor, Break] = {}
    for name, formula in where:
        for factor in filter(lambda f: may_vanish(f, near), dividing_factors(formula)):
            found.setdefault(factor, Break(name, factor.formula()))
    return tuple(found.values())


def dividing_factors(formula: Formula) -> Iterator[Factor]:
    """Yield the factors that a formula as a whole is divided by."""
    for part in formula.factors if isinstance(formula, Product) else (formula,):
        if isinstance(part, Power | Call):
            yield from (f for f, exponent in to_product(part).factors.items() if exponent < 0)


def may_vanish(factor: Factor, near: Mapping[str, float]) -> bool:
    """Return whether this is a sum, or a sine or cosine of what varies: no length, no constant.

    A sum of lengths that are all positive, ``a + b``, does not vanish.
    """
    match factor:
        case Trig(angle=angle):
            return any(name != RADIAN for name, _ in angle.terms)
        case Sum():
            return not _all_positive(factor.formula(), near)
        case _:
            return isinstance(factor, Bound)


def _all_positive(formula: Formula, near: Mapping[str, float]) -> bool:
    """Return whether a sum has no functions and no term that is negative by default."""
    if not isinstance(formula, Terms) or any(isinstance(f, Call) for f in walk(formula)):
        return False
    known = symbols(formula) <= near.keys()
    return known and all(evaluate(t, near) > 0 for t in formula.terms)
