"""Lengths and places that are far from all others: a wrong unit, or digits too many."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from ..diagnostics import Diagnostic
from ..diagnostics.model import doubtful_sizes as messages
from ..formula.evaluate import evaluate
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..units import LENGTH
from .mechanism import Arrow, ForcePair, Mechanism, Offset, Parameter
from .values import Values

FAR = 100.0
"""How many times a length is the largest, or the smallest, of the others: 35 is met in books."""

Place = tuple[float, float]


def far_off(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the first of the lengths and places that is far from the rest."""
    found = (
        *_far_places(mechanism, values),
        *_far_parameters(mechanism, values),
        *_far_vectors(mechanism, values),
    )
    yield from found[:1]


def _far_parameters(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the parameters that are, of which the largest is first.

    Those written in place, as in ``OA = 100 mm @ x``, give the size of a mechanism, too.
    """
    given, plain = _given(mechanism, values), [size for size, _ in _plain(mechanism)]
    units = Counter(p.unit for p in given)
    if len(units) not in (1, 2):
        return
    sizes = {p.name: abs(values[p.name]) for p in given}
    alone = [p for p in given if len(units) == 1 or units[p.unit] == 1]
    for parameter in sorted(alone, key=lambda p: -sizes[p.name]):
        others = [*plain, *(s for name, s in sizes.items() if name != parameter.name)]
        if len(others) >= 3 - len(units) and _is_far(sizes[parameter.name], others):
            other = next(iter(units.keys() - {parameter.unit}), "")
            yield messages.length_far_off(parameter.given, parameter.name, parameter.unit, other)


def _given(mechanism: Mechanism, values: Values) -> list[Parameter]:
    """Return the parameters that stand in vectors, places and springs, and have a value."""
    springs = (k.tie for k in mechanism.loads if isinstance(k, ForcePair) and k.tie)
    formulas = [f for entry in mechanism.geometry for f in _lengths(entry)]
    used = {name for formula in (*formulas, *springs) for name in symbols(formula)}
    lengths = (p for p in mechanism.parameters if p.dimension == LENGTH and p.name in used)
    return [p for p in lengths if values.get(p.name) and not p.dependent]


def _far_vectors(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the vectors whose length is a number, of which one is far from the rest."""
    plain = _plain(mechanism)
    given = [abs(values[p.name]) for p in _given(mechanism, values)]
    for size, entry in sorted(plain, key=lambda pair: -pair[0]) if not mechanism.drawn else ():
        others = [*given, *(other for other, e in plain if e is not entry)]
        if len(others) > 1 and _is_far(size, others) and isinstance(entry, Arrow):
            yield messages.length_far_off(entry.span, f"{entry.tail}{entry.head}", "", "")


def _plain(mechanism: Mechanism) -> list[tuple[float, Arrow | Offset]]:
    """Return the lengths and coordinates that are numbers other than zero, and what has them."""
    written = [(f, e) for e in mechanism.geometry for f in _lengths(e)]
    sizes = [(abs(evaluate(f, {})), e) for f, e in written if not symbols(f)]
    return [(s, e) for s, e in sizes if s and isinstance(e, Arrow | Offset)]


def _lengths(entry: object) -> tuple[Formula, ...]:
    match entry:
        case Arrow(length=length) if length is not None:
            return (length,)
        case Offset(x=x, y=y):
            return (x, y)
        case _:
            return ()


def _is_far(size: float, others: Sequence[float]) -> bool:
    return size > FAR * max(others) or size * FAR < min(others)


# -------------------------------------------------------------------------- places


def _far_places(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the drawn points that are far from all others, which are near one another."""
    places = _places(mechanism, values)
    for drawn in mechanism.drawn if len(places) > 2 else ():
        here = places.get(drawn.point)
        others = [place for point, place in places.items() if point != drawn.point]
        if here is None:
            continue
        spread = max(math.dist(*pair) for pair in combinations(others, 2))
        if min(math.dist(here, other) for other in others) > FAR * spread > 0:
            yield messages.place_far_off(drawn.span, drawn.point)


def _places(mechanism: Mechanism, values: Values) -> Mapping[str, Place]:
    """Return the places that are given, of drawn points and of pivots."""
    pivots = (e for e in mechanism.geometry if isinstance(e, Offset) and not e.tail)
    given = [(d.point, d.x, d.y) for d in mechanism.drawn] + [(e.head, e.x, e.y) for e in pivots]
    known = ((p, x, y) for p, x, y in given if symbols(x) | symbols(y) <= values.keys())
    return {point: (evaluate(x, values), evaluate(y, values)) for point, x, y in known}
