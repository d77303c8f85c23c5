"""A number that is rounding alone is printed as 0; one that is small is not."""

import math
from fractions import Fraction
from random import Random

import pytest

from mechc.cli.check import report
from mechc.driver import compile_source
from mechc.formula.rounding import EPS, Rounding
from mechc.formula.tree import Call, Symbol, degrees, negative, number, power, product, total
from mechc.source import Source

LEVER = """\
mechanism lever
param l = 1 m
param alpha = {angle}
pivot O
link OA
OA = l @ alpha
torque M on OA
weight W mass 3 kg at A
find M
let F2 = M/l
"""
X, Y = Symbol("x"), Symbol("y")


def default(angle: str) -> float:
    return compile_source(Source("m.mech", LEVER.format(angle=angle))).results[0].default


@pytest.mark.parametrize("angle", ["90 deg", "-90 deg", "270 deg", "450 deg", "7290 deg"])
def test_the_weight_above_the_pivot_needs_no_torque(angle):
    assert str(default(angle)) == "0.0"
    printed = "\n".join(report(compile_source(Source("m.mech", LEVER.format(angle=angle))), False))
    assert "= 0 N*m at the default pose" in printed
    assert "= 0 N at the default pose" in printed
    assert "e-1" not in printed


def test_what_is_small_but_known_stays():
    assert default("89.9999999 deg") == pytest.approx(29.41995 * math.radians(1e-7), rel=1e-6)


@pytest.mark.parametrize("turns", range(-40, 40, 7))
def test_zeros_of_sines_and_differences_are_seen(turns):
    half = Call("sin", (degrees(180 * turns),))
    assert Rounding({}).of(half).is_zero
    squares = [power(Call(f, (X,)), number(2)) for f in ("sin", "cos")]
    one = total([*squares, number(-1)])
    assert Rounding({"x": 0.1 + turns}).of(one).is_zero


def test_zero_over_zero_is_no_number():
    nil = Call("cos", (degrees(90),))
    assert math.isnan(
        Rounding({}).of(product([(nil, 1), (Call("sin", (degrees(180),)), -1)])).value
    )


@pytest.mark.parametrize("seed", range(200))
def test_the_bound_holds_the_error(seed):
    """(x + y) - x and its like, against exact sums: the error is below its bound."""
    dice = Random(seed)
    x, y = dice.uniform(-1, 1) * 10 ** dice.uniform(-6, 6), dice.uniform(-1, 1)
    found = Rounding({"x": x, "y": y}).of(
        total(
            [product([(X, 1), (Y, 1)]), X, negative(product([(X, 1), (total([Y, number(1)]), 1)]))]
        )
    )
    assert abs(found.value) <= found.error
    assert found.error <= 64 * EPS * abs(x)
    product_ = Rounding({"x": x, "y": y}).of(product([(X, 2), (Y, 1)]))
    exact = Fraction(x) ** 2 * Fraction(y)
    assert abs(Fraction(product_.value) - exact) <= Fraction(product_.error)
