"""Jumps of a function, by hand: of which size, at which place, and what is none."""

import math

import pytest

from mechc.formula.numeric.jumps import Jump, is_steady, jumps, side
from mechc.formula.numeric.roots import spaced

GRID = spaced(0.0, 1.0, 40)


def test_a_jump_has_the_values_of_its_two_sides() -> None:
    (found,) = jumps(lambda x: 1.0 + x if x < 0.3 else 2.0 + x, GRID)
    assert found.x == pytest.approx(0.3, abs=1e-10)
    assert found.bracket <= 1e-11
    assert (found.before, found.after) == pytest.approx((1.3, 2.3), abs=1e-6)


def test_a_jump_over_zero_is_narrowed_by_the_sign() -> None:
    """Beside the pole at 0.24 values are far from those of both sides of the jump."""
    (found,) = jumps(lambda x: 0.02 / (x - 0.24) if x < 0.26 else -0.3, [0.0, 0.1, 0.25, 0.5])
    assert found.x == pytest.approx(0.26, abs=1e-10)
    assert found.before > 0 > found.after


@pytest.mark.parametrize(
    "function",
    [
        lambda x: 1.0 / (x - 0.31),  # a pole
        lambda x: abs(x - 0.31),  # a kink
        lambda x: (x - 0.31) * 5.0,  # a zero
        lambda x: 1.0 if x < 0.3 else 1.0 + 1e-9,  # rounding
    ],
)
def test_what_is_no_jump(function) -> None:
    assert jumps(function, GRID) == []


def test_sides_that_still_rise_are_those_of_a_pole() -> None:
    steep = Jump(0.5, 1e-11, -1.0e8, 1.0e8)
    assert not is_steady(lambda x: 1.0 / (x - 0.5), steep, 1.0)
    assert is_steady(lambda x: -1.0 if x < 0.5 else 1.0, Jump(0.5, 1e-11, -1.0, 1.0), 1.0)


def test_a_side_is_seen_from_as_far_as_rounding_asks() -> None:
    """Next to the jump the rounding of what is divided by next to nothing is in the fifth digit."""
    noise = lambda x: 1e-12 * math.sin(1e9 * x) / x  # noqa: E731
    assert side(lambda x: 2 + 3 * x + x * x + noise(x), 0.0, 1e-8) == pytest.approx(2, abs=1e-6)
    assert side(lambda x: 2 + 3 * x + x * x, 0.0, -1e-8) == pytest.approx(2, abs=1e-14)


def test_a_side_with_no_values_farther_away_is_seen_from_where_there_is_one() -> None:
    assert side(lambda x: 2.0 if x < 1e-6 else math.nan, 0.0, 1e-8) == 2.0


def test_a_side_is_seen_no_farther_than_two_distances_agree() -> None:
    looked_at: list[float] = []

    def straight(x: float) -> float:
        looked_at.append(x)
        return 2 + 3 * x

    assert side(straight, 0.0, 1e-8) == pytest.approx(2, abs=1e-14)
    assert max(looked_at) < 1e-6
