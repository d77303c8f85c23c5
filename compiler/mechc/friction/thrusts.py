"""Forces along the axis of a pivot: given ones, or multiples of a load in the plane."""

from collections.abc import Mapping

from ..algebra.from_formula import to_product
from ..algebra.product import Product
from ..formula.tree import Formula
from ..formula.walk import substitute, symbols
from ..power.balance import Equations


def thrust_under(
    thrust: Formula, equations: Equations, given: Mapping[str, Product]
) -> Product | str:
    """Return a force along an axis under given loads, or the load that is not among them."""
    sizes = {}
    for load in sorted(symbols(thrust) & equations.owners.keys()):
        base, factor = equations.owner(load)
        if base not in given:
            return load
        sizes[load] = (factor * given[base]).formula()
    return to_product(substitute(thrust, sizes))
