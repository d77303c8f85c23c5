"""The speeds that are asked for: signed where a sign is defined, magnitudes elsewhere."""

import math
from fractions import Fraction

from ..algebra.angle import Angle, Rational
from ..algebra.formula import Call
from ..algebra.product import ZERO, Opaque, Product, cosine
from ..algebra.sums import add
from ..kinematics.forms import QUARTER
from ..kinematics.plan import Plan, Speeds
from ..model.mechanism import Speed
from ..pose.pose import Vector


def speed(plan: Plan, wanted: Speed) -> Speeds:
    """Return a speed per unit of each drive.

    A link's is counter-clockwise; a point's is signed along its guide, counter-clockwise
    about its link's pivot, and a magnitude elsewhere.
    """
    if wanted.kind == "link":
        return plan.spin(wanted.of)
    guides = plan.graph.pose.guides
    if wanted.of in guides:
        return plan.component(wanted.of, guides[wanted.of])
    return _about_pivot(plan, wanted.of) or _magnitude(plan, wanted.of)


def _about_pivot(plan: Plan, point: str) -> Speeds | None:
    pose = plan.graph.pose
    fixed = {p.point for p in pose.mechanism.pivots}
    for link in pose.mechanism.links:
        pivot = next((p for p in link.points if p in fixed), None)
        if pivot and point in link.points and point != pivot:
            reach = length(pose.vector(link.name, pivot, point))
            return tuple(w * reach for w in plan.spin(link.name))
    return None


def length(vector: Vector) -> Product:
    """Return the length of a vector: an arm as it stands, else a root."""
    if len(vector) == 1:
        return vector[0].length
    square = add(a.length * b.length * cosine(a.angle - b.angle) for a in vector for b in vector)
    return root(square)


def root(square: Product) -> Product:
    """Return the square root of a product: even powers outside, the rest under the root."""
    outside = Product(1, {f: e // 2 for f, e in square.factors.items() if e % 2 == 0})
    inside = {f: e for f, e in square.factors.items() if e % 2}
    coefficient: Rational = 1
    parts = (square.coefficient.numerator, square.coefficient.denominator)
    whole = [math.isqrt(n) for n in parts]
    if [n * n for n in whole] == list(parts):
        outside = outside.scaled(Fraction(*whole))
    else:
        coefficient = square.coefficient
    if coefficient == 1 and not inside:
        return outside
    under = Product(coefficient, inside).formula()
    return outside * Product.of(Opaque(Call("sqrt", (under,))))


def _magnitude(plan: Plan, point: str) -> Speeds:
    """Return |V| per unit of the one drive that moves a point (its sign is lost)."""
    parts = [plan.component(point, d) for d in (Angle(), QUARTER)]
    squares = [add([x * x, y * y]) for x, y in zip(*parts, strict=True)]
    return tuple(root(s) if s else ZERO for s in squares)
