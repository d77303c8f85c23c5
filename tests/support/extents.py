"""What a ratio is said to come to along a stroke or range, held against dense sampling."""

import math
from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise

import numpy as np

from mechc.compilation import Compilation
from mechc.routine.evaluate import evaluate
from mechc.study.analysis import Extent
from statements import DENSE

Samples = Callable[[list[float]], Iterable[float]]
"""The values of a ratio at values of a parameter."""

BESIDE = 1e-6
"""How far from a zero or a pole it is looked at, as a part of the range."""


ROUNDED = (1e-14, 1e-12, 1e-10, 1e-8)
"""How far inside of its place an extremum is looked for, too, as parts of the range.

A loop that is solved by iteration has no value any more so near its end: there two solutions are
no farther apart than the root of that.
"""


def along(compilation: Compilation) -> Iterator[str]:
    """Yield what a report says of ratios along the stroke and over ranges, and code refutes."""
    for result in compilation.reported.results:
        for extent in result.extents:
            said = refuted(extent, curve(compilation, result.name, extent.parameter))
            yield from (f"{result.name} over {extent.parameter}: {text}" for text in said)


def curve(compilation: Compilation, name: str, parameter: str) -> Samples:
    """Return the values of a result, as code gives them, along a parameter."""
    function = next(f for f in compilation.routine.functions if f.name == name)
    given = {i.name: i.default for i in function.inputs}

    def at(places: list[float]) -> list[float]:
        found = evaluate(function, {**given, parameter: np.array(places)})
        return list(np.broadcast_to(found, len(places)).tolist())

    return at


def refuted(extent: Extent, curve: Samples, number: int = 4 * DENSE) -> Iterator[str]:
    """Yield what a curve comes to that is not said to; where it has no value nothing is."""
    low, high = extent.range
    cell = (high - low) / number
    places = [low + cell * (i + 0.5) for i in range(number)]
    values = list(curve(places))
    sizes = sorted(abs(v) for v in values if math.isfinite(v))
    usual = sizes[len(sizes) // 2] if sizes else 0.0
    slack = 1e-9 * usual
    yield from _beyond(extent, zip(places, values, strict=True), slack)
    stated = (*extent.zeros, *extent.poles)
    for (x, a), (_, b) in pairwise(zip(places, values, strict=True)):
        is_stated = any(x - cell <= place <= x + 2 * cell for place in stated)
        if extent.looked and a * b < 0 and min(abs(a), abs(b)) > slack and not is_stated:
            yield f"changes its sign between {x} and {x + cell}"
    yield from _not_there(extent, curve, usual)


def _beyond(extent: Extent, found: Iterable[tuple[float, float]], slack: float) -> Iterator[str]:
    least = extent.least.value - slack if extent.least else -math.inf
    greatest = extent.greatest.value + slack if extent.greatest else math.inf
    for x, value in found:
        if value < least or value > greatest:
            yield f"{value} at {x}, not {extent.least} to {extent.greatest}"


def _not_there(extent: Extent, curve: Samples, usual: float) -> Iterator[str]:
    """Yield the extrema, zeros and poles at which a curve has none."""
    middle = (extent.range[0] + extent.range[1]) / 2
    for extreme in filter(None, (extent.least, extent.greatest)):
        # the end of a closure is rounded: the last place may have no value any more
        inwards = [extreme.x + part * (middle - extreme.x) for part in ROUNDED]
        found = list(curve([extreme.x, *inwards]))
        size = max(usual, abs(extreme.value))
        if not any(abs(value - extreme.value) <= 1e-6 * size for value in found):
            yield f"{found[0]} at {extreme.x}, not {extreme.value}"
    far = BESIDE * (extent.range[1] - extent.range[0])
    for way, places in ((1, extent.zeros), (-1, extent.poles)):
        for x in places:
            sizes = [abs(v) for v in curve([x - far, x + far, x - 8 * far, x + 8 * far])]
            near, away = sizes[:2], sizes[2:]
            if all(math.isfinite(v) and v for v in sizes) and not any(
                (b / a) ** way > 1.3 for a, b in zip(near, away, strict=True)
            ):
                yield f"{near} beside {x}, {away} farther away: no {'zero' if way > 0 else 'pole'}"
