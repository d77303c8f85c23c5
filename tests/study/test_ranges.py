"""Narrowing down where something ceases to hold: by halves, with a measure or without."""

import math
import random
from collections.abc import Callable

import pytest

from mechc.study.tolerances import EXACT, NEARLY
from mechc.study.variables import last, spans

SignedMeasure = Callable[[float], float]


def measures(end: float) -> dict[str, SignedMeasure]:
    """Functions that are positive before an end and negative beyond, or infinite there."""
    return {
        "straight": lambda x: 3 * (end - x),
        "bent": lambda x: math.expm1(end - x),
        "flat": lambda x: (end - x) ** 3,
        "steep": lambda x: math.copysign(abs(end - x) ** 0.2, end - x),
        "a jump": lambda x: 2.0 if x < end else -1.0,
        "without a value beyond": lambda x: end - x if x < end else -math.inf,
        "no measure of it": lambda x: math.cos(40 * x),
        "unknown": lambda x: math.nan,
    }


@pytest.mark.parametrize("name", measures(0.0))
@pytest.mark.parametrize("width", [EXACT, NEARLY])
def test_a_measure_changes_nothing_but_how_much_is_tried(name: str, width: float) -> None:
    chance = random.Random(name)
    for _ in range(200):
        good, bad = (chance.uniform(-2, 2) for _ in range(2))
        end = good + (bad - good) * chance.random()
        sign = 1 if good < bad else -1

        def holds(x: float, end: float = end, sign: int = sign) -> bool:
            return sign * (end - x) > 0

        measure = measures(sign * end)[name]
        found = last(holds, good, bad, width, lambda x, s=sign, m=measure: m(s * x))
        assert found == last(holds, good, bad, width)


def test_an_end_at_the_end_itself_is_found_with_few_tries() -> None:
    """The measure is zero there but for rounding: cos 90° is 6e-17."""
    tried = []

    def holds(x: float) -> bool:
        tried.append(x)
        return math.cos(x) > 1e-14

    good, bad = 1.5, math.pi / 2
    plain = last(holds, good, bad)
    by_halves = len(tried)
    tried.clear()
    assert last(holds, good, bad, measure=math.cos) == plain
    assert len(tried) < by_halves / 2


def test_few_values_are_tried_where_a_measure_is_smooth() -> None:
    tried = []

    def measure(x: float) -> float:
        tried.append(x)
        return math.cos(x) - 0.3

    found = last(lambda x: measure(x) > 0, 0.0, 2.0, EXACT, measure)
    assert found == pytest.approx(math.acos(0.3), abs=3e-13)
    assert len(set(tried)) < 20


def test_stretches_end_where_the_measure_changes_its_sign() -> None:
    grid = [0.5 * i for i in range(14)]
    plain = [*spans(grid, lambda x: math.cos(x) > 0.5)]
    first, second = spans(grid, lambda x: math.cos(x) > 0.5, lambda x: math.cos(x) - 0.5)
    assert [first, second] == plain
    assert first == pytest.approx((0.0, math.pi / 3))
    assert second == pytest.approx((5 * math.pi / 3, 6.5))
