"""What a result is said to do, held against dense sampling: every kind of statement.

Each function yields what sampling refutes, in words; nothing where all holds.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from random import Random
from types import CodeType

from mechc.formula.choices import IN_WORDS
from mechc.formula.evaluate import evaluate as slowly
from mechc.formula.functions import FUNCTIONS
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Formula, Implicit
from mechc.formula.walk import constants, substitute, symbols, walk
from mechc.model.mechanism import Mechanism
from mechc.model.values import bounds, defaults, dependent, independent, range_of
from mechc.study.analysis import Analysis, Break, Vanishing

Values = Mapping[str, float]
Curve = Callable[[float], float]

DENSE = 240
"""Values along a range."""

NEAR = 1e-6
"""How far from a zero or a pole the order is looked at, as a part of the range."""

CLOSE = (1e-5, 3e-5, 1e-4, 3e-4, 1e-3)
"""How near to the ends of a range a result may turn, as parts of it."""

ROUNDED_ZERO = 1e-10
"""What is smaller, in SI, is rounding of a zero: equal links lie on one another."""

CODE: dict[int, tuple[Formula, CodeType | None]] = {}
"""Formulas as code, by what is faster than their hash; kept, so that none takes another's."""


def _code(formula: Formula) -> CodeType | None:
    """Return a formula as code; None where a part of it is iterated."""
    if id(formula) not in CODE:
        is_iterated = any(_is_slow(part) for part in walk(formula))
        numbers = {c.name: c.value for c in constants([formula])}
        source = text(substitute(formula, numbers)).replace("^", "**")
        CODE[id(formula)] = (
            formula,
            None if is_iterated else compile(source, "formula", "eval"),
        )
    return CODE[id(formula)][1]


def _is_slow(part: Formula) -> bool:
    """Return whether a part is iterated, chosen or looked up, for which there is no code."""
    return isinstance(part, Implicit) or (isinstance(part, Call) and part.function in IN_WORDS)


def evaluate(formula: Formula, values: Values) -> float:
    """Return the value of a formula, faster than the interpreter does; NaN where there is none."""
    code = _code(formula)
    if code is None:
        return slowly(formula, values)
    try:
        return float(eval(code, {**FUNCTIONS, "pi": math.pi}, dict(values)))
    except (ZeroDivisionError, OverflowError, TypeError, ValueError):
        return math.nan


def poses(mechanism: Mechanism, result: Analysis, number: int, seed: int) -> Iterator[Values]:
    """Yield poses over the whole ranges; without one a parameter keeps its value."""
    dice = Random(seed)
    kept = defaults(mechanism)
    for _ in range(number):
        drawn = {
            p.name: kept[p.name] if p.name in kept and p.range is None else dice.uniform(*bounds(p))
            for p in independent(mechanism)
        }
        drawn |= {load: dice.uniform(0.5, 2) for load in _open_loads(mechanism)}
        yield with_rest(mechanism, result, drawn)


def _open_loads(mechanism: Mechanism) -> Iterator[str]:
    """Yield the loads that nothing gives a size."""
    given = {let.name for let in mechanism.lets}
    return (k.name for k in mechanism.loads if k.tie is None and k.name not in given)


def with_rest(mechanism: Mechanism, result: Analysis, values: Values) -> Values:
    """Return values with what follows from them: angles of the pose, and formulas of those."""
    found = dict(values)
    left = [*dependent(mechanism).items(), *result.where]
    while ready := [d for d in left if symbols(d[1]) <= found.keys()]:
        for name, formula in ready:
            found[name] = evaluate(formula, found)
        left = [d for d in left if d not in ready]
    return found


def value(mechanism: Mechanism, result: Analysis, values: Values) -> float:
    return evaluate(result.formula, with_rest(mechanism, result, values))


def refuted(mechanism: Mechanism, result: Analysis, seed: int = 0) -> Iterator[str]:
    """Yield every statement on a result that sampling refutes."""
    for pose in poses(mechanism, result, 3, seed):
        yield from trends(mechanism, result, pose)
        yield from proportions(mechanism, result, pose)
        yield from near_by(mechanism, result, pose)
        yield from within(mechanism, result, pose)
    yield from limits(mechanism, result, seed)


# ------------------------------------------------------------------------------ trends


def trends(mechanism: Mechanism, result: Analysis, pose: Values) -> Iterator[str]:
    ranged = {p.name: p for p in independent(mechanism) if p.range is not None}
    for name, trend in (result.trends or {}).items():
        if trend == "unknown" or name not in ranged:
            continue
        low, high = bounds(ranged[name])
        places = [low + (high - low) * (i + 0.5) / DENSE for i in range(DENSE)]
        if trend == "turns":  # perhaps just before an end
            near = [part * (high - low) for part in CLOSE]
            places = [low, *(low + d for d in near), *places, *(high - d for d in near[::-1]), high]
        at = _middle(mechanism, result, pose) if trend == "turns" else pose
        found = [evaluate(result.formula, {**at, name: x}) for x in places]
        if said := _trend_refuted(trend, found):
            yield f"{result.name} {trend} with {name}: {said}"


def _middle(mechanism: Mechanism, result: Analysis, pose: Values) -> Values:
    """Return a pose with all that has a range in the middle of it: there a result turns."""
    ranged = (p for p in independent(mechanism) if p.range is not None)
    middles = {p.name: sum(bounds(p)) / 2 for p in ranged}
    return with_rest(mechanism, result, {**free(mechanism, pose), **middles})


def near_by(mechanism: Mechanism, result: Analysis, pose: Values) -> Iterator[str]:
    """Yield what rises or falls the other way where it is said to, ranges apart."""
    given = with_rest(mechanism, result, {**pose, **defaults(mechanism)})
    for name, scope in result.scopes.items():
        trend = (result.trends or {})[name]
        if trend not in ("rises", "falls") or scope in ("ranges", "ranges, rest as given"):
            continue
        at = given if scope == "as given" else pose
        parts = (1.0, 1.0 + 1e-5) if scope == "as given" else (0.01, 0.1, 1.0, 10.0, 100.0)
        found = [evaluate(result.formula, {**at, name: part * at[name]}) for part in parts]
        if at[name] > 0 and (said := _trend_refuted(trend, found)):
            yield f"{result.name} {trend} with {name}, {scope}: {said}"


def within(mechanism: Mechanism, result: Analysis, pose: Values) -> Iterator[str]:
    """Yield conditions that are met within the ranges, and are said not to be."""
    for limit in (v for v in (*result.zeros, *result.poles) if v.outside):
        for name in symbols(limit.factor) & free(mechanism, pose).keys():
            low, high = range_of(name, mechanism) or bounds(mechanism.parameter(name))

            def factor(at: float, name: str = name, limit: Vanishing = limit) -> float:
                return evaluate(limit.factor, {**pose, name: at})

            if any(True for _ in roots(factor, low, high)):
                yield f"{result.name}: {text(limit.factor)} is zero within the range of {name}"


def _trend_refuted(trend: str, found: list[float]) -> str:
    steps = [b - a for a, b in pairwise(found)]
    slack = [1e-9 * max(abs(a), abs(b)) for a, b in pairwise(found)]
    up = sum(s > e for s, e in zip(steps, slack, strict=True))
    down = sum(s < -e for s, e in zip(steps, slack, strict=True))
    poles = sum(a * b < 0 and min(abs(a), abs(b)) > 0 for a, b in pairwise(found))
    match trend:
        case "rises":
            return f"falls {down} times" if down else ""
        case "falls":
            return f"rises {up} times" if up else ""
        case "constant":
            return "changes" if up or down else ""
        case "rises between poles":
            return f"falls {down} times, changes sign {poles} times" if down > poles else ""
        case "falls between poles":
            return f"rises {up} times, changes sign {poles} times" if up > poles else ""
        case "turns":
            return "" if up and down else "never turns"
    return ""


# ------------------------------------------------------- proportions, swaps, independence


def proportions(mechanism: Mechanism, result: Analysis, pose: Values) -> Iterator[str]:
    k = value(mechanism, result, free(mechanism, pose))
    for name, power in (result.proportional or {}).items():
        more = {**free(mechanism, pose), name: 3 * pose[name]}
        if not _close(value(mechanism, result, more), 3**power * k):
            yield f"{result.name} is not proportional to {name}^{power}"
    for name in result.independent:
        if name in pose:
            other = {**free(mechanism, pose), name: 1.1 * pose[name] + 0.01}
            if not _close(value(mechanism, result, other), k):
                yield f"{result.name} depends on {name}"
    for a, b in result.swaps:
        swapped = {**free(mechanism, pose), a: pose[b], b: pose[a]}
        if not _close(value(mechanism, result, swapped), k):
            yield f"{result.name} changes with {a}, {b} exchanged"


def free(mechanism: Mechanism, pose: Values) -> Values:
    names = (*(p.name for p in independent(mechanism)), *_open_loads(mechanism))
    return {name: pose[name] for name in names if name in pose}


def _close(a: float, b: float) -> bool:
    return not math.isfinite(a) or not math.isfinite(b) or math.isclose(a, b, rel_tol=1e-6)


# ----------------------------------------------------------------------- zeros and poles


def limits(mechanism: Mechanism, result: Analysis, seed: int) -> Iterator[str]:
    """Yield the zeros and poles that are none."""
    for pose, name, low, high in sweeps(mechanism, result, seed):

        def curve(x: float, name: str = name, pose: Values = pose) -> Values:
            return with_rest(mechanism, result, {**free(mechanism, pose), name: x})

        for limit in (*result.zeros, *result.poles):
            yield from _at_refuted(mechanism, result, limit, pose)
        yield from _roots_refuted(result, name, curve, low, high)
    for limit in (*result.zeros, *result.poles):
        yield from _left_out(mechanism, result, limit)


def _side(result: Analysis, limit: Vanishing) -> int:
    return 1 if limit in result.zeros else -1


def _at_refuted(
    mechanism: Mechanism, result: Analysis, limit: Vanishing, pose: Values
) -> Iterator[str]:
    if limit.at is None or limit.at[0] not in {p.name for p in independent(mechanism)}:
        return
    name, *formulas = *limit.at, *limit.within
    if result.where and symbols(limit.at[1]) - free(mechanism, pose).keys():
        return
    for formula in formulas:
        yield from _place_refuted(mechanism, result, limit, pose, (name, evaluate(formula, pose)))


def _place_refuted(
    mechanism: Mechanism,
    result: Analysis,
    limit: Vanishing,
    pose: Values,
    place: tuple[str, float],
) -> Iterator[str]:
    name, x = place

    def curve(at: float) -> Values:
        return with_rest(mechanism, result, {**free(mechanism, pose), name: at})

    if meets_another(limit, {**free(mechanism, pose), name: x}):
        return
    found = _order_at(result, curve, x, 1.0)
    if found is None or _is_rounding(result, curve, x, 1.0):
        return
    if found * _side(result, limit) < 0.5:
        yield f"{result.name} has order {found:.2f} at {name} = {math.degrees(x):.4f}°"


def _left_out(mechanism: Mechanism, result: Analysis, limit: Vanishing) -> Iterator[str]:
    """Yield where a factor vanishes within a range and is not said to, others as given."""
    pose, name = defaults(mechanism), limit.at[0] if limit.at else ""
    given = range_of(name, mechanism) if name else None
    if given is None or not symbols(limit.factor) <= pose.keys():
        return
    listed = [evaluate(place, pose) for place in limit.within]
    if limit.period and listed:
        step = evaluate(limit.period, pose)
        listed = [listed[0] + i * step for i in range(int((given[1] - listed[0]) / step) + 1)]
    for x in roots(lambda at: evaluate(limit.factor, {**pose, name: at}), *given):
        if not any(math.isclose(x, place, abs_tol=NEAR) for place in listed):
            yield f"{result.name}: {text(limit.factor)} is zero at {name} = {x}: not listed"


def meets_another(limit: Vanishing, there: Values) -> bool:
    """Return whether one of the conditions holds that a limit leaves out."""
    known = (f for f in limit.except_where if symbols(f) <= there.keys())
    return any(abs(evaluate(f, there)) < NEAR for f in known)


def order(size: Curve, x: float, near: float) -> float | None:
    """Return the order of a zero (positive) or pole; None where rounding hides it."""
    a, b = size(x + near), size(x + near / 2)
    if not (math.isfinite(a) and math.isfinite(b) and a > 1e-250 and b > 1e-250):
        return None
    return math.log2(a / b)


def _roots_refuted(
    result: Analysis, name: str, curve: Callable[[float], Values], low: float, high: float
) -> Iterator[str]:
    for limit in (*result.zeros, *result.poles):

        def factor(at: float, limit: Vanishing = limit) -> float:
            return evaluate(limit.factor, curve(at))

        for x in roots(factor, low, high):
            own = order(lambda at: abs(factor(at)), x, NEAR * (high - low))
            if own is None or own < 0.5 or _is_open(result, curve, x, high - low):
                continue
            beside = [curve(x + part * NEAR * (high - low)) for part in (-0.1, 0.0, 0.1)]
            if any(abs(evaluate(f, at)) < NEAR for f in limit.except_where for at in beside):
                continue
            found = _order_at(result, curve, x, high - low)
            if found is None or _is_rounding(result, curve, x, high - low):
                continue
            if found * _side(result, limit) < 0.5:
                yield f"{result.name} has order {found:.2f} at {name} = {x} where a factor vanishes"


def _order_at(
    result: Analysis, curve: Callable[[float], Values], x: float, wide: float
) -> float | None:
    return order(lambda at: abs(evaluate(result.formula, curve(at))), x, NEAR * wide)


def missing(mechanism: Mechanism, result: Analysis, seed: int = 0) -> Iterator[str]:
    """Yield the zeros and poles within the ranges that no statement is about."""
    for pose, name, low, high in sweeps(mechanism, result, seed):

        def curve(x: float, name: str = name, pose: Values = pose) -> Values:
            return with_rest(mechanism, result, {**free(mechanism, pose), name: x})

        for x in roots(lambda at: evaluate(result.formula, curve(at)), low, high):
            found = _order_at(result, curve, x, high - low)
            if (
                found is not None
                and abs(found) > 0.5
                and not _is_open(result, curve, x, high - low)
                and not _is_rounding(result, curve, x, high - low)
            ):
                stated = result.zeros if found > 0 else result.poles
                if not any(_is_near_zero(v, curve, x, high - low) for v in stated):
                    yield f"{result.name} has order {found:.2f} at {name} = {x}: not stated"


def _is_rounding(result: Analysis, curve: Callable[[float], Values], x: float, wide: float) -> bool:
    """Return whether a result is zero on one side of a place, but for rounding."""
    sides = (evaluate(result.formula, curve(x + h * wide)) for h in (-1e-3, 1e-3))
    return any(abs(side) < ROUNDED_ZERO for side in sides)


def sweeps(
    mechanism: Mechanism, result: Analysis, seed: int
) -> Iterator[tuple[Values, str, float, float]]:
    ranged = [p for p in independent(mechanism) if p.range is not None]
    for pose in poses(mechanism, result, 2, seed + 1):
        for p in ranged:
            yield pose, p.name, *bounds(p)


def _is_open(result: Analysis, curve: Callable[[float], Values], x: float, wide: float) -> bool:
    """Tell a place of which nothing is said, as something that loops find is infinite there."""
    return any(_is_near_zero(b, curve, x, wide) for b in result.breaks)


def _is_near_zero(
    limit: Vanishing | Break, curve: Callable[[float], Values], x: float, wide: float
) -> bool:
    here, there = (abs(evaluate(limit.factor, curve(x + h * wide))) for h in (0, 1e-3))
    return here < 1e-4 * there or here < 1e-9


def roots(curve: Curve, low: float, high: float) -> Iterator[float]:
    """Yield where a curve changes its sign, through zero or infinity."""
    places = [low + (high - low) * (i + 0.5) / DENSE for i in range(DENSE)]
    values = [curve(x) for x in places]
    for i in range(DENSE - 1):
        if values[i] * values[i + 1] < 0:
            a, b, at_a = places[i], places[i + 1], values[i]
            while (middle := (a + b) / 2) not in (a, b):
                here = curve(middle)
                if here * at_a > 0:
                    a = middle
                else:
                    b = middle
            yield (a + b) / 2
