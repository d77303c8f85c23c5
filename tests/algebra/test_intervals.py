"""Bounds of angles over ranges, by hand."""

import math

import pytest

from mechc.algebra.angle import Angle
from mechc.algebra.intervals import Interval, angle_bounds

BOX = {"alpha": Interval(0.1, 0.3), "beta": Interval(-0.2, 0.5)}
ALPHA, BETA = Angle.of("alpha"), Angle.of("beta")


@pytest.mark.parametrize(
    ("angle", "low", "high"),
    [
        (ALPHA, 0.1, 0.3),
        (ALPHA + BETA, -0.1, 0.8),
        (ALPHA - BETA, -0.4, 0.5),
        (ALPHA + ALPHA - BETA + Angle.constant(30), 0.2 - 0.5 + math.pi / 6, 0.8 + math.pi / 6),
        (Angle.constant(90), math.pi / 2, math.pi / 2),
    ],
)
def test_the_bounds_of_a_sum_are_sums_of_bounds(angle: Angle, low: float, high: float) -> None:
    found = angle_bounds(angle, BOX)
    assert found == (pytest.approx(low, rel=1e-12), pytest.approx(high, rel=1e-12))
    assert found.low <= low
    assert found.high >= high


def test_an_angle_without_a_range_may_be_any() -> None:
    assert angle_bounds(ALPHA + Angle.of("gamma"), BOX) == (-math.inf, math.inf)
