"""What stands behind *where*: the names that a result mentions, each told once."""

from collections.abc import Container

from ..formula.tree import Formula, Number, Product, Symbol
from ..model.mechanism import GRAVITY
from ..model.result import Definition, Result

FREE_FALL = Symbol("g")
"""The letter of :data:`GRAVITY`; where a description has weights, no other quantity bears it."""


def definitions(result: Result, told: Container[str] = ()) -> tuple[Definition, ...]:
    """Return a result's definitions but those ``told`` before, g in weights by its letter."""
    return tuple(
        Definition(name, by_letter(formula)) for name, formula in result.where if name not in told
    )


def by_letter(formula: Formula) -> Formula:
    """Return a weight as ``m·g``; any other formula as it is.

    >>> from ..formula.tree import product
    >>> from ..formula.to_text import text
    >>> text(by_letter(product([(Symbol("m"), 1), (GRAVITY, 1)])))
    'm*g'
    """
    match formula:
        case Product((Number(value), *factors)) if value == GRAVITY.value:
            return Product((*factors, FREE_FALL))
        case _:
            return formula


def is_by_letter(formula: Formula) -> bool:
    """Return whether a formula is a weight that :func:`by_letter` has shortened."""
    return isinstance(formula, Product) and formula.factors[-1] == FREE_FALL
