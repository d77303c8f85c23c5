"""Where a result rises and falls: signs of its derivatives over the range, proved.

The box is made of the parameters' ranges; a parameter without a range stands at its
value, and a length without a value is anything positive.
"""

import math
from collections.abc import Iterator, Sequence

from ..algebra.factors import Trig
from ..algebra.intervals import IntervalBox, NumberInterval, bounds, sign, spans_no_zero, widened
from ..algebra.product import Product, Sum
from ..formula.walk import symbols
from .analysis import Trend
from .tolerances import NARROW_RANGE, SMALLEST

PARTS = 48
"""A factor's sign is looked for on at most this many parts of the box."""


DIVISOR_CELLS = 16
"""Cells along a parameter at whose ends the sign of a divisor is looked at."""


def trend(value: Product, slope: Product, name: str, box: IntervalBox) -> Trend:
    """Return how a result moves with a parameter, from its derivative by it.

    Where the derivative keeps its sign a result still jumps from one infinity to the other
    at a pole: it rises on either side, not across. At an end of the range the derivative may
    be zero, or the result infinite: it rises from there, or up to there.
    """
    if not slope:
        return "constant"
    ends = {sign(slope, _corner(box, name, end)) for end in (0, 1)}
    if ends == {1, -1}:
        return "turns"
    way = (ends - {None} or {sign(slope, _corner(box))}).pop()
    if way is None or not _keeps_sign(slope, name, box):
        return "unknown"
    divisors = [d for d in _divisors(value) if name in symbols(d.formula())]
    if all(_is_free_inside(d, name, box) for d in divisors):
        return "rises" if way == 1 else "falls"
    if any(_changes_sign(d, name, box) for d in divisors):
        return "rises between poles" if way == 1 else "falls between poles"
    return "unknown"


def _divisors(product: Product) -> Iterator[Product]:
    """Yield the divisors of a product, in its sums, too: nothing else makes it infinite."""
    for factor, exponent in product.factors.items():
        if exponent < 0:
            yield Product.of(factor)
        if isinstance(factor, Sum):
            for term in factor.terms:
                yield from _divisors(term)


def _changes_sign(divisor: Product, name: str, box: IntervalBox) -> bool:
    """Return whether a divisor is proved to vanish along a parameter, others in the middle."""
    if name not in box:
        return False
    low, high = box[name]
    grid = [low + (high - low) * i / DIVISOR_CELLS for i in range(DIVISOR_CELLS + 1)]
    signs = {sign(divisor, {**_corner(box, name, 0), name: widened(x, x)}) for x in grid}
    return {1, -1} <= signs


def _corner(box: IntervalBox, name: str = "", end: int = 0) -> IntervalBox:
    """Return one end of a parameter's range, the others standing in the middle of theirs.

    Without a parameter all of them do.
    """
    middles = {n: (low + high) / 2 for n, (low, high) in box.items() if math.isfinite(high)}
    at = {n: middles.get(n, 1.0) for n in box}
    if name in middles:
        at[name] = box[name][end]
    return {n: widened(x, x) for n, x in at.items()}


def _keeps_sign(slope: Product, name: str, box: IntervalBox) -> bool:
    """Return whether no factor that could change sign does so along a parameter in the box."""
    odd = (Product(1, {f: 1}) for f, e in slope.factors.items() if e % 2)
    return all(_is_free_inside(factor, name, box) for factor in odd)


def _is_free_inside(factor: Product, name: str, box: IntervalBox) -> bool:
    """Return whether a factor is proved to have no zero but at the ends of a parameter's range.

    A sine whose angle moves with the parameter, and stays within a half turn from zero to zero,
    has none, wherever the others stand.
    """
    if is_free_of_zeros(factor, box):
        return True
    low, high = box.get(name, (0.0, 0.0))
    return high - low > NARROW_RANGE and all(
        isinstance(f, Trig) and name in f.angle.names and spans_no_zero(f, box)
        for f in factor.factors
    )


def is_free_of_zeros(
    factor: Product, box: IntervalBox, where: Sequence[tuple[str, Product]] = ()
) -> bool:
    """Return whether a factor is proved to have no zero in a box, halved where needed.

    ``where`` are definitions of names that the box has not, each by the box and those before it.
    """
    waiting = [box]
    for _ in range(PARTS):
        if not waiting:
            return True
        part = waiting.pop()
        if sign(factor, _with_defined(part, where)) is None:
            name = _widest(part)
            if name is None:
                return False
            waiting.extend(_halves(part, name))
    return not waiting


def _with_defined(box: IntervalBox, where: Sequence[tuple[str, Product]]) -> IntervalBox:
    """Return a box that has the bounds of what is defined, too."""
    found = dict(box)
    for name, value in where:
        found[name] = bounds(value, found)
    return found


def _widest(box: IntervalBox) -> str | None:
    """Return the parameter with the widest finite range, relative to its size."""
    widths = {
        name: (high - low) / max(abs(low), abs(high), SMALLEST)
        for name, (low, high) in box.items()
        if math.isfinite(high - low)
    }
    name = max(widths, key=lambda n: widths[n], default=None)
    return name if name is not None and widths[name] > NARROW_RANGE else None


def _halves(box: IntervalBox, name: str) -> Iterator[IntervalBox]:
    low, high = box[name]
    middle = (low + high) / 2
    for half in (NumberInterval(low, middle), NumberInterval(middle, high)):
        yield {**box, name: half}
