"""Why a loop has no pose, and in which units a refuted expectation shows where: by hand."""

import math

import pytest

from mechc.base.frozen import replace
from mechc.formula.tree import Call, Symbol, System, implicit, negative, number, power, total
from mechc.model.mechanism import Parameter
from mechc.study.expectations import _in_units
from mechc.study.pose_sweep import NOT_ASSEMBLED, NOT_REACHED, why_open
from mechc.units import LENGTH
from small_poses import HERE, slider_crank

A, X = Symbol("a"), Symbol("x")
ROOT = System(("x",), (total([power(X, number(2)), A, number(-1)]),), (("a", 0.0),), (1.0,))
"""x² = 1 − a, from x = 1 at a = 0: the branch ends at a = 1."""

FOLLOWED = implicit(ROOT, 0)
CLOSED = Call("sqrt", (total([number(1), negative(A)]),))
NAN = math.nan


@pytest.mark.parametrize(
    ("definitions", "values", "why"),
    [
        ({"x": FOLLOWED}, {"x": 0.8}, ""),
        ({"x": FOLLOWED}, {"x": NAN}, NOT_REACHED),
        ({"x": CLOSED}, {"x": NAN}, NOT_ASSEMBLED),
        ({"x": FOLLOWED, "y": CLOSED}, {"x": 0.8, "y": NAN}, NOT_REACHED),
        ({"y": CLOSED, "x": FOLLOWED}, {"y": NAN, "x": NAN}, NOT_ASSEMBLED),
        ({"y": CLOSED, "z": CLOSED, "x": FOLLOWED}, {"y": 1.0, "z": NAN}, NOT_ASSEMBLED),
        ({"y": CLOSED, "x": FOLLOWED}, {"y": 1.0, "x": NAN}, NOT_REACHED),
    ],
)
def test_what_is_followed_up_to_the_first_without_a_value_says_why(definitions, values, why):
    """A pose may be on another branch where what has none, or rests on something, is followed."""
    assert why_open(definitions, {"a": 2.0, **values}) == why


def test_values_are_shown_in_the_units_written_and_loads_in_those_of_the_si():
    mechanism = slider_crank().mechanism
    written = Parameter("h", LENGTH, HERE, number(1), unit="mm")
    mechanism = replace(mechanism, parameters=(*mechanism.parameters, written))
    found = _in_units({"h": 0.0125, "M": 2.5, "F": 300.0}, mechanism)
    assert found == {"h": "12.5 mm", "M": "2.5 N*m", "F": "300 N"}
