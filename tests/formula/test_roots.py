"""Zeros of functions of the drive: crossed, touched, and what is only rounding."""

import math

import pytest

from mechc.formula.roots import roots

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
