"""Which names move with the drive, and how fast those that the user made to."""

from collections.abc import Iterable

from ...algebra.from_formula import to_product
from ...algebra.product import Product
from ...algebra.sums import add
from ...formula.derivative import derivative as slope
from ...formula.walk import symbols
from ..pose import Definition


def given_rates(definitions: Iterable[Definition], drive: str) -> dict[str, Product]:
    """Return the rates of what the user made to move with the drive, itself included."""
    rates = {drive: Product(1)}
    for name, formula in definitions:
        parts = sorted(symbols(formula) & rates.keys())
        if parts:
            rates[name] = add(to_product(slope(formula, n)) * rates[n] for n in parts)
    return rates


def moved_by(drive: str, definitions: Iterable[Definition]) -> frozenset[str]:
    """Return the names that move with the drive, itself included."""
    moving = {drive}
    for name, formula in definitions:
        if not moving.isdisjoint(symbols(formula)):
            moving.add(name)
    return frozenset(moving)
