"""Jumps of a function, by hand: of which size, at which place, and what is none."""

import pytest

from mechc.formula.jumps import Jump, is_steady, jumps
from mechc.formula.roots import spaced

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
