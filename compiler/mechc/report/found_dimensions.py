"""What the names on the way to a result measure, that no line of the description declares."""

from collections.abc import Iterable, Mapping

from ..formula.layout import is_angle
from ..formula.tree import Formula, Implicit, Symbol
from ..formula.walk import constants, substitute, symbols, walk
from ..model.result import Definition
from ..units import ANGLE, LENGTH, Dimension
from .homogeneous import dimension_of


def found_dimension(
    definition: Definition,
    angles: Iterable[str],
    values: Mapping[str, float],
    dimensions: Mapping[str, Dimension],
) -> Dimension | None:
    """Return the dimension of what a loop or friction defines; None if it is not known."""
    if definition.name.startswith("len_"):
        return LENGTH
    if is_angle(definition.formula, set(angles)):
        return ANGLE
    names = names_in(definition.formula)
    if is_solved(definition.formula) or not names <= dimensions.keys() & values.keys():
        return None
    return dimension_of(
        with_symbols(definition.formula),
        {name: values[name] for name in names},
        {name: dimensions[name] for name in names},
    )


def is_solved(formula: Formula) -> bool:
    """Return whether the solution of a system is in a formula."""
    return any(isinstance(part, Implicit) for part in walk(formula))


def names_in(formula: Formula) -> frozenset[str]:
    """Return all names of a formula, those of numbers too."""
    return symbols(formula) | {c.name for c in constants([formula])}


def with_symbols(formula: Formula) -> Formula:
    """Return a formula in which named numbers are symbols, to be put in like all others."""
    return substitute(formula, {c.name: Symbol(c.name) for c in constants([formula])})
