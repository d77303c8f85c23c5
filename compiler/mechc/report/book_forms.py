"""Lengths and angles of triangles as books write them: by the laws of sines and cosines.

Code has the forms that lose no digits next to a straight toggle, an arc tangent of the root
of four factors; for readers the same is an arc cosine. Nothing is taken on trust: a form is
put in where algebra proves it equal.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from fractions import Fraction
from itertools import combinations

from ..algebra.angle import Angle
from ..algebra.factors import ConstantSymbol, Factor, Length, Opaque
from ..algebra.from_formula import is_transparent, to_angle, to_product
from ..algebra.product import Product
from ..algebra.product import Sum as FactoredSum
from ..algebra.sums import add
from ..algebra.trigonometry import cosine, sine
from ..formula.evaluate import evaluate
from ..formula.layout import has_minus
from ..formula.operations import count_operations
from ..formula.rewriting import as_cofunction, rewritten
from ..formula.tree import Call, Formula, Sum, is_call, negative, number, power, quotient, total
from ..formula.walk import children, rebuild, walk
from ..model.mechanism import Mechanism, Parameter
from ..model.result import Definition
from ..model.values import range_of
from ..pose.given_angles import GivenLines
from ..pose.pose import Arm
from ..units import ANGLE, LENGTH

HALF = Fraction(1, 2)

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


Ranges = Mapping[str, tuple[float, float]]
"""The least and the greatest value of angles, in degrees."""

NO_RANGES: Ranges = {}


def angle_ranges(mechanism: Mechanism) -> dict[str, tuple[float, float]]:
    """Return the ranges that a description gives angles; the stroke of the one that drives."""
    named = (p.name for p in mechanism.parameters if p.dimension == ANGLE)
    found = ((name, range_of(name, mechanism)) for name in named)
    return {name: (math.degrees(r[0]), math.degrees(r[1])) for name, r in found if r}


def book_form(formula: Formula, positive: Set[str], ranges: Ranges = NO_RANGES) -> Formula:
    """Return a formula with the sides and angles of triangles by the laws of sines and cosines.

    ``positive`` are the names of lengths that are never negative. What is no triangle stays.
    The sum of two equal arms halves the angle between them, wherever its ``ranges`` allow that.

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
    >>> across, along = (product([(a, 1), (Call(f, (phi,)), 1)]) for f in ("sin", "cos"))
    >>> within = {"phi": (-40.0, 40.0)}
    >>> text(book_form(Call("hypot", (total([along, a]), across)), {"a"}, within))
    '2*a*cos(phi/2)'
    >>> text(book_form(Call("atan2", (across, total([along, a]))), {"a"}, within))
    'phi/2'
    """
    parts = tuple(book_form(part, positive, ranges) for part in children(formula))
    whole = rebuild(formula, parts) if parts else formula
    match formula:
        case Call("hypot", (x, y)):
            halved = _halved(x, y, positive, ranges)
            arms = [halved.length.formula()] if halved else []
            return min((*arms, *_by_cosines(x, y, positive), whole), key=_operations)
        case Call("atan2", (y, x)) if halved := _halved(x, y, positive, ranges):
            return halved.angle.formula()
        case Call("atan2", (Call("sqrt", (square,)), x)) if size := _root(square, x, positive):
            return Call("acos", (_per(x, size),))
        case Call("atan2", (y, Call("sqrt", (square,)))) if size := _root(square, y, positive):
            return Call("asin", (_per(y, size),))
        case _:
            return whole


def has_heron(formula: Formula) -> bool:
    """Return whether an angle of a formula is found by the root of Heron's formula.

    >>> from ..formula.tree import Symbol
    >>> x, size = Symbol("x"), Call("sqrt", (Symbol("y"),))
    >>> has_heron(Call("atan2", (size, x))), has_heron(Call("acos", (x,)))
    (True, False)
    """
    angles = (part for part in walk(formula) if is_call(part, "atan2"))
    return any(is_call(side, "sqrt") for angle in angles for side in children(angle))


def _halved(x: Formula, y: Formula, positive: Set[str], ranges: Ranges) -> Arm | None:
    """Return a vector that is the sum of two equal arms as one arm.

    None where the ranges do not tell that they are less than half a turn apart, or that the
    direction is the principal one.
    """
    calls = (part for one in (x, y) for part in walk(one) if is_call(part, "sin", "cos"))
    found = (to_angle(call.arguments[0]) for call in calls)
    along, across = to_product(x), to_product(y)
    for one, other in combinations(dict.fromkeys((Angle(), *filter(None, found))), 2):
        arm = along / add([cosine(one), cosine(other)])
        is_arm = arm.coefficient > 0 and all(_stays(f, positive) for f in arm.factors)
        if not is_arm or across != arm * add([sine(one), sine(other)]):
            continue
        apart, direction = (one - other) * HALF, (one + other) * HALF
        if _is_within(apart, 90, ranges) and _is_within(direction, 180, ranges):
            return Arm(arm.scaled(2) * cosine(apart), direction)
    return None


def _is_within(angle: Angle, limit: int, ranges: Ranges) -> bool:
    """Return whether an angle is nearer to zero than a limit all over its range."""
    if not angle.names or not angle.names <= ranges.keys():
        return False
    ends = [sorted(float(c) * end for end in ranges[name]) for name, c in angle.terms]
    least, greatest = (math.fsum(side) + float(angle.degrees) for side in zip(*ends, strict=True))
    return -limit < least < greatest < limit


def _by_cosines(x: Formula, y: Formula, positive: Set[str]) -> Iterator[Formula]:
    """Yield the length of a vector by the law of cosines, where it has two arms.

    What all terms have twice stands before the root: ``a*sqrt(5 - 4*cos(phi))``.
    """
    across, along = to_product(x), to_product(y)
    square = add([across * across, along * along])
    terms = list(_multiplied_out(square))
    if is_transparent(square) and len(terms) <= LONGEST_SIDE:
        ordered = sorted(terms, key=lambda t: (t.coefficient < 0, len(t.factors)))
        yield Call("sqrt", (_in_angles_of((x, y), total(t.formula() for t in ordered)),))
        if shared := _squared_in_all(ordered, positive):
            rest = total((t / (shared * shared)).formula() for t in ordered)
            yield (
                shared * Product.of(Opaque(Call("sqrt", (_in_angles_of((x, y), rest),))))
            ).formula()


def _squared_in_all(terms: Sequence[Product], positive: Set[str]) -> Product | None:
    """Return the positive lengths of which every term has the square, None of none."""
    first, *others = terms
    found = (
        f
        for f, e in first.factors.items()
        if e == 2 and _stays(f, positive) and all(t.factors.get(f) == 2 for t in others)
    )
    shared = Product(1, dict.fromkeys(found, 1))
    return shared if shared.factors else None


def _in_angles_of(components: Iterable[Formula], square: Formula) -> Formula:
    """Return a square by the cosine of an angle between the arms that the components have."""
    calls = (part for one in components for part in walk(one) if is_call(part, "sin", "cos"))
    found = (to_angle(call.arguments[0]) for call in calls)
    arms = {angle for angle in found if angle is not None}
    quarter = GivenLines({Angle(), *arms}, {Angle(), *arms}).quarter
    return rewritten(square, lambda part: as_cofunction(part, quarter))


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
        is_twice = len({*side.terms}) < len(side.terms)
        return quotient(whole.formula() if is_twice else _minus_last(side), size.formula())
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
        case ConstantSymbol(_, value):
            return evaluate(value, {}) > 0
        case Length(name):
            return name in positive
        case FactoredSum(terms=terms):
            return all(
                t.coefficient > 0 and all(_stays(f, positive) for f in t.factors) for t in terms
            )
        case _:
            return False
