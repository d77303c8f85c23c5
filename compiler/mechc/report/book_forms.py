"""Lengths and angles of triangles as books write them: by the laws of sines and cosines.

Code has the forms that lose no digits next to a straight toggle, an arc tangent of the root
of four factors; for readers the same is an arc cosine. Nothing is taken on trust: a form is
put in where algebra proves it equal.
"""

from collections.abc import Iterable, Iterator, Set
from fractions import Fraction

from ..algebra.angle import Angle
from ..algebra.factors import Constant, Factor, Length
from ..algebra.from_formula import is_transparent, to_angle, to_product
from ..algebra.product import Product
from ..algebra.product import Sum as FactoredSum
from ..algebra.sums import add
from ..formula.evaluate import evaluate
from ..formula.facing import quarter_turned, rewritten
from ..formula.layout import has_minus
from ..formula.operations import count_operations
from ..formula.tree import Call, Formula, Sum, is_call, negative, number, power, quotient, total
from ..formula.walk import children, rebuild, walk
from ..model.mechanism import Mechanism, Parameter
from ..model.result import Definition
from ..pose.given_angles import GivenLines
from ..units import LENGTH

LONGEST_SIDE = 3
"""The terms of the law of cosines; more of them are no law that a reader knows."""


def positive_names(mechanism: Mechanism, where: Iterable[Definition]) -> frozenset[str]:
    """Return the names of lengths that are positive wherever they have a value.

    A length that is not given at all is that of a side, and sides are positive.
    """
    given = (p.name for p in mechanism.parameters if _is_positive(p))
    found = (d.name for d in where if _is_distance(d.formula))
    return frozenset((*given, *found))


def _is_positive(parameter: Parameter) -> bool:
    if parameter.dimension != LENGTH or parameter.dependent:
        return False
    if parameter.range is not None:
        return evaluate(parameter.range.low, {}) > 0
    return parameter.value is None or evaluate(parameter.value, {}) > 0


def _is_distance(formula: Formula) -> bool:
    return is_call(formula, "hypot", "sqrt")


def book_form(formula: Formula, positive: Set[str]) -> Formula:
    """Return a formula with the sides and angles of triangles by the laws of sines and cosines.

    ``positive`` are the names of lengths that are never negative. What is no triangle stays.

    >>> from ..formula.to_text import text
    >>> from ..formula.tree import Symbol, degrees, negative, product
    >>> a, d, phi = Symbol("a"), Symbol("d"), Symbol("phi")
    >>> across = product([(a, 1), (Call("sin", (phi,)), 1)])
    >>> along = total([d, negative(product([(a, 1), (Call("cos", (phi,)), 1)]))])
    >>> text(book_form(Call("hypot", (along, across)), {"a", "d"}))
    'sqrt(a^2 + d^2 - 2*a*d*cos(phi))'
    >>> lean = total([phi, degrees(60)])
    >>> across, along = (product([(a, 1), (Call(f, (lean,)), 1)]) for f in ("sin", "cos"))
    >>> text(book_form(Call("hypot", (total([along, d]), across)), {"a", "d"}))
    'sqrt(a^2 + d^2 + 2*a*d*cos(phi + pi/3))'
    """
    parts = tuple(book_form(part, positive) for part in children(formula))
    whole = rebuild(formula, parts) if parts else formula
    match formula:
        case Call("hypot", (x, y)):
            return min((*_by_cosines(x, y), whole), key=_operations)
        case Call("atan2", (Call("sqrt", (square,)), x)) if size := _root(square, x, positive):
            return Call("acos", (_per(x, size),))
        case Call("atan2", (y, Call("sqrt", (square,)))) if size := _root(square, y, positive):
            return Call("asin", (_per(y, size),))
        case _:
            return whole


def _by_cosines(x: Formula, y: Formula) -> Iterator[Formula]:
    """Yield the length of a vector by the law of cosines, where it has two arms."""
    across, along = to_product(x), to_product(y)
    square = add([across * across, along * along])
    terms = list(_multiplied_out(square))
    if is_transparent(square) and len(terms) <= LONGEST_SIDE:
        ordered = sorted(terms, key=lambda t: (t.coefficient < 0, len(t.factors)))
        yield Call("sqrt", (_in_angles_of((x, y), total(t.formula() for t in ordered)),))


def _in_angles_of(components: Iterable[Formula], square: Formula) -> Formula:
    """Return a square by the cosine of an angle between the arms that the components have."""
    calls = (part for one in components for part in walk(one) if is_call(part, "sin", "cos"))
    found = (to_angle(call.arguments[0]) for call in calls)
    arms = {angle for angle in found if angle is not None}
    quarter = GivenLines({Angle(), *arms}, arms, {Angle(), *arms}).quarter
    return rewritten(square, lambda part: quarter_turned(part, quarter))


def _operations(distance: Formula) -> int:
    """Return the operations of a distance as it is printed, by Pythagoras."""
    match distance:
        case Call("hypot", sides):
            return _operations(Call("sqrt", (total(power(s, number(2)) for s in sides),)))
        case _:
            return count_operations(distance)


def _per(side: Formula, size: Product) -> Formula:
    """Return a side of a right triangle by its longest one, cancelled where it is one term."""
    whole = to_product(side)
    one = whole / size
    if not any(isinstance(factor, FactoredSum) for factor in one.factors):
        return one.formula()
    if isinstance(side, Sum):
        return quotient(_minus_last(side), size.formula())
    scale = 1 / abs(Fraction(whole.coefficient))
    above, below = (part.scaled(scale).formula() for part in (whole, size))
    if isinstance(opposite := negative(above), Sum):
        above = negative(opposite)
    return quotient(_minus_last(above), below)


def _minus_last(formula: Formula) -> Formula:
    if not isinstance(formula, Sum):
        return formula
    return Sum(tuple(sorted(formula.terms, key=has_minus)))


def _multiplied_out(product: Product) -> Iterator[Product]:
    """Yield the terms of a product, its sums multiplied out as long as they stand once."""
    within = next(
        (f for f, e in product.factors.items() if isinstance(f, FactoredSum) and e == 1), None
    )
    if within is None:
        yield product
        return
    rest = product / Product.of(within)
    for term in within.terms:
        yield from _multiplied_out(rest * term)


def _root(square: Formula, side: Formula, positive: Set[str]) -> Product | None:
    """Return the root of ``square + side²`` where that is the square of something positive."""
    area, leg = to_product(square), to_product(side)
    whole = add([area, leg * leg])
    root = whole.root()
    return root if root and all(_stays(f, positive) for f in root.factors) else None


def _stays(factor: Factor, positive: Set[str]) -> bool:
    """Return whether a factor is positive, by what it is made of."""
    match factor:
        case Constant(_, value):
            return evaluate(value, {}) > 0
        case Length(name):
            return name in positive
        case FactoredSum(terms=terms):
            return all(
                t.coefficient > 0 and all(_stays(f, positive) for f in t.factors) for t in terms
            )
        case _:
            return False
