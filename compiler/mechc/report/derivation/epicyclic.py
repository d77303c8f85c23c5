"""Wheels whose centres an arm carries, by the method of Willis: as seen from the arm."""

from ...algebra.from_formula import to_product
from ...algebra.product import ONE, Product
from ...formula.layout import has_minus
from ...formula.tree import product
from ...kinematics.forms import scaled
from ...kinematics.graph import Graph, Relation
from ...kinematics.meshes import turning
from ...model.mechanism import WheelPair
from ..steps import Equation
from .notation import Names, linear


def seen_from_arm(relation: Relation, graph: Graph, names: Names) -> Equation | None:
    """Return ``z₁(ω₁ - ω_arm) = z₂(ω₂ + ω_arm)``: equal speeds of rims relative to the arm.

    Factors that both radii have, such as the module, are left out. None for other relations, and
    where a speed that is zero has no name.
    """
    if not relation.joint:
        return None
    pair = graph.pose.mechanism.joint(relation.joint)
    if not isinstance(pair, WheelPair) or not pair.arm:
        return None
    own, other = (turning(graph, link, pair.arm) for link in pair.wheels)
    if not {*own, *other} <= names.keys():
        return None
    if not pair.same:
        other = scaled(other, -ONE)
    if has_minus(linear(own, names)):
        own, other = scaled(own, -ONE), scaled(other, -ONE)
    first, second = _without_common(to_product(pair.first_radius), to_product(pair.second_radius))
    return Equation(
        product([(first.formula(), 1), (linear(own, names), 1)]),
        product([(second.formula(), 1), (linear(other, names), 1)]),
    )


def _without_common(first: Product, second: Product) -> tuple[Product, Product]:
    """Return two products without the factors that both have."""
    share = first / second
    above = {f: e for f, e in share.factors.items() if e > 0}
    below = {f: -e for f, e in share.factors.items() if e < 0}
    return (
        Product(share.coefficient.numerator, above),
        Product(share.coefficient.denominator, below),
    )
