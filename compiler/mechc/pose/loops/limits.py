"""Where the two closures of a loop meet: functions of the pose that are zero there.

A triangle of sides d, p, q closes where d lies between |p − q| and p + q, a rod where it
reaches its guide. What is left over is a margin: positive where there are two closures,
zero where they are one and the loop lies flat, negative where there is none.
"""

from collections.abc import Iterable
from typing import TypeAlias

from ...algebra.from_formula import to_product
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine
from ...formula.derivative import derivative as slope
from ...formula.walk import symbols
from ..pose import Definition, Vector

Margins: TypeAlias = tuple[Product, ...]


def of_triangle(side: Vector, p: Product, q: Product) -> Margins:
    """Return the margins against the stretched and against the folded position."""
    square, both = _square(side), (p * q).scaled(2)
    outer = add([p * p, both, q * q, -square])
    inner = add([square, -(p * p), both, -(q * q)])
    return outer, inner


def of_guide(size: Product, height: Product) -> Margins:
    """Return the margins of a rod that reaches a line on either side of its hinge."""
    return add([size, -height]), add([size, height])


def of_slide(side: Vector, across: Product) -> Margins:
    """Return the margin of a pin that a line passes at a distance."""
    return (add([_square(side), -(across * across)]),)


def _square(side: Vector) -> Product:
    return add(a.length * b.length * cosine(a.angle - b.angle) for a in side for b in side)


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
