"""Zeros of functions of the drive: crossed, touched, and what is only rounding."""

import math

import pytest

from mechc.formula.numeric.roots import narrowed, roots

PLACES = [i / 720 for i in range(721)]


@pytest.mark.parametrize("zero", [0.25, 1 / 3, 0.7312])
def test_a_zero_is_found_whether_crossed_or_touched(zero):
    for power in (1, 2, 3):
        (found,) = roots(lambda x, power=power: (x - zero) ** power, PLACES)
        assert found.x == pytest.approx(zero, abs=1e-7 if power == 2 else 1e-12)


def test_rounding_is_no_zero_and_costs_nothing():
    """What is the same everywhere but for its last digits is asked about once at each place."""
    asked = []

    def rounded(x: float) -> float:
        asked.append(x)
        return 3.0 + 2e-15 * math.sin(1e6 * x)

    assert not roots(rounded, PLACES)
    assert len(asked) < 2 * len(PLACES)


@pytest.mark.parametrize(("function", "most"), [(lambda x: x**3 - 2, 8), (math.cos, 10)])
def test_a_smooth_function_is_divided_where_three_values_say(function, most):
    """Halves alone would take more than fifty values; none is asked for outside the interval."""
    asked = []

    def counted(x: float) -> float:
        asked.append(x)
        return function(x)

    found = narrowed(counted, 1.0, 2.0)
    assert abs(function(found.x)) < 1e-15
    assert len(asked) <= most
    assert all(1.0 <= x <= 2.0 for x in asked)
