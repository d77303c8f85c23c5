"""Errors of emitted code next to a straight toggle, against the formulas at 50 digits."""

import pytest

from precision import KNEES, case, errors, towards_the_knee

CLOSED = [name for name in KNEES if name != "triad_closed"]

EXACT = {"c": 0.625, "r": 0.375}
"""Sides whose sum is a number of few digits: what is known of the toggle is known exactly."""


@pytest.mark.parametrize("name", CLOSED)
def test_no_more_is_lost_than_the_lengths_leave_open(name):
    mechanism, _ = case(name)
    found = errors(mechanism, towards_the_knee(mechanism, KNEES[name], 6))
    assert max(max(e.kappa) for e in found.values()) > 1e10
    for quantity, error in found.items():
        for ulp, kappa in zip(error.ulp, error.kappa, strict=True):
            assert ulp < 2 + 2 * kappa, quantity


@pytest.mark.parametrize("bits", [10, 20, 30, 40])
def test_a_triangle_of_given_sides_loses_nothing_at_a_straight_toggle(bits):
    """The law of cosines would lose half the digits here."""
    mechanism, _ = case("oscillating_cylinder")
    found = errors(mechanism, [{**mechanism.values, **EXACT, "s": 1 - 2.0**-bits}])
    assert max(found["k"].kappa) > 2**bits / 10
    for quantity, error in found.items():
        assert max(error.ulp) < 6, quantity
