"""Which names move with the drive, and how fast those that the user made to."""

from collections.abc import Iterable, Mapping

from ...algebra.from_formula import to_product
from ...algebra.product import Product
from ...algebra.sums import add
from ...formula.derivative import derivative as slope
from ...formula.tree import Formula
from ...formula.walk import symbols
from ..pose import Definition


def given_rates(definitions: Iterable[Definition], drive: str) -> dict[str, Product]:
    """Return the rates of what the user made to move with the drive, itself included."""
    rates = {drive: Product(1)}
    for name, formula in definitions:
        if not symbols(formula).isdisjoint(rates):
            rates[name] = rate_of(formula, rates)
    return rates


def rate_of(formula: Formula, rates: Mapping[str, Product]) -> Product:
    """Return the rate of a formula by the chain rule."""
    parts = sorted(symbols(formula) & rates.keys())
    return add(to_product(slope(formula, n)) * rates[n] for n in parts)


def moved_by(drive: str, definitions: Iterable[Definition]) -> frozenset[str]:
    """Return the names that move with the drive, itself included."""
    moving = {drive}
    for name, formula in definitions:
        if not moving.isdisjoint(symbols(formula)):
            moving.add(name)
    return frozenset(moving)
