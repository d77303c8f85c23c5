"""Exact tests for equality, the field they rest on, derivatives, angles from formulas."""

from fractions import Fraction
from math import isqrt

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechc.algebra.angle import Angle
from mechc.algebra.derivative import derivative
from mechc.algebra.equality import equal
from mechc.algebra.from_formula import to_angle, to_product
from mechc.algebra.matrices import independent_of
from mechc.algebra.modular import PARTS, PRIME, ModularPoint, direction
from mechc.algebra.product import Product, Sum
from mechc.algebra.sums import add, canonical
from mechc.algebra.trigonometry import cosine, sine
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import (
    Call,
    Number,
    Symbol,
    degrees,
    negative,
    number,
    power,
    product,
    quotient,
    total,
)
from product_strategies import VALUES, products

law = settings(max_examples=40, deadline=None, derandomize=True, database=None)

x, y = Symbol("x"), Symbol("y")


def call(name, *terms):
    return Call(name, (total(terms),))


def times(*factors):
    return product((f, 1) for f in factors)


half = number(Fraction(1, 2))
two, one = number(2), number(1)


def squared(f):
    return power(f, two)


IDENTITIES = [
    (total([call("sin", x), call("sin", y)]),
     times(two, Call("sin", (times(half, total([x, y])),)),
           Call("cos", (times(half, total([x, negative(y)])),)))),
    (Call("sin", (times(two, x),)), times(two, call("sin", x), call("cos", x))),
    (Call("cos", (times(number(3), x),)),
     total([times(number(4), power(call("cos", x), number(3))),
            times(number(-3), call("cos", x))])),
    (Call("tan", (times(half, x),)),
     quotient(total([one, negative(call("cos", x))]), call("sin", x))),
    (call("tan", x, degrees(45)),
     quotient(total([one, call("tan", x)]), total([one, negative(call("tan", x))]))),
    (total([squared(call("sec", x)), negative(squared(call("tan", x)))]), one),
    (times(call("sin", degrees(20)), call("sin", degrees(40)), call("sin", degrees(80))),
     times(number(Fraction(1, 4)), call("sin", degrees(60)))),
    (call("cos", degrees(36)), total([half, call("cos", degrees(72))])),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right"), IDENTITIES)
def test_identities_are_proved_and_near_misses_refuted(left, right):
    assert equal(left, right)
    assert not equal(left, times(right, Number(1 + Fraction(1, 10**9))))
    assert not equal(total([left, Number(Fraction(1, 10**30))]), right)


@pytest.mark.parametrize(("left", "right"), IDENTITIES)
def test_both_sides_of_an_identity_have_a_difference_of_zero(left, right):
    assert not add([to_product(left), -to_product(right)])


ARC = Call("asin", (times(two, x),))
SAME_ARC = Call("asin", (total([x, x]),))


def test_a_function_of_equal_arguments_is_one_quantity():
    assert equal(call("tan", y, ARC), call("tan", SAME_ARC, y))
    assert equal(call("sqrt", times(two, x)), call("sqrt", x, x))
    assert equal(call("sin", y, ARC), Call("sin", (total([y, Symbol("z")]),)), [("z", SAME_ARC)])
    assert not equal(call("tan", y, ARC), call("tan", y, Call("asin", (x,))))
    assert not equal(ARC, Call("acos", (times(two, x),)))


def test_an_arc_turned_round_is_the_opposite():
    back = Call("asin", (times(number(-2), x),))
    assert equal(call("cos", y, back), call("cos", y, negative(SAME_ARC)))
    turned = Call("acos", (times(number(-2), x),))
    assert not equal(turned, negative(Call("acos", (times(two, x),))))


def test_a_pole_everywhere_equals_nothing():
    nothing = quotient(one, total([x, negative(x), times(two, y), times(number(-2), y)]))
    assert not equal(nothing, nothing)


def test_the_field_has_every_root_of_unity_that_is_asked_for():
    assert sympy.isprime(PRIME)
    assert PRIME % (360 * PARTS) == 1
    assert isqrt(PRIME).bit_length() > 55
    for parts in (1, 2, 3, 9000, 90 * PARTS):
        root, order = direction(parts), 4 * parts
        assert pow(root, order, PRIME) == 1
        assert all(pow(root, order // q, PRIME) != 1 for q in sympy.primefactors(order))


@law
@given(products(), products(), st.sampled_from(["alpha", "beta", "a"]))
def test_derivatives_agree_with_differences(above, below, name):
    assume(abs(below.evaluate(VALUES)) > 1e-2)
    whole = canonical(add([above, below * above]) / below)
    step = 1e-5
    ahead, behind = (whole.evaluate({**VALUES, name: VALUES[name] + s}) for s in (step, -step))
    slope = derivative(whole, name).evaluate(VALUES)
    assert slope == pytest.approx((ahead - behind) / (2 * step), rel=1e-5, abs=1e-5)


@law
@given(products(), products(), st.sampled_from(["alpha", "beta", "a"]))
def test_the_rule_of_products_holds_exactly(p, q, name):
    sides = derivative(p * q, name), add([derivative(p, name) * q, p * derivative(q, name)])
    point = ModularPoint(1)
    assert sides[0].residue(point) == sides[1].residue(point)


ANGLES = {
    "12.3456789": degrees(Fraction("12.3456789")),
    "40": degrees(40),
    "0.3 rad": number(Fraction(3, 10)),
    "half": times(half, Symbol("alpha")),
    "triple": times(number(3), Symbol("alpha")),
    "million": times(number(10**6), Symbol("alpha")),
    "mixed": total([Symbol("alpha"), degrees(45), number(Fraction(-1, 3)), negative(Symbol("a"))]),
}


@pytest.mark.parametrize("name", ANGLES)
def test_an_angle_keeps_its_value(name):
    angle = to_angle(ANGLES[name])
    assert angle is not None
    expected = evaluate(ANGLES[name], VALUES)
    assert angle.evaluate(VALUES) == pytest.approx(expected, rel=1e-14)
    assert evaluate(angle.formula(), VALUES) == pytest.approx(expected, rel=1e-14)
    assert to_angle(angle.formula()) == angle


def test_a_coefficient_that_no_field_has_is_not_an_angle():
    assert to_angle(times(number(Fraction(1, 7919)), Symbol("alpha"))) is None
    assert equal(*[Call("sin", (times(number(Fraction(1, 7919)), Symbol("alpha")),))] * 2)


def test_angles_add_like_vectors():
    a, b = Angle.of("alpha") * 2, Angle.of("beta") + Angle.constant(Fraction(1, 3))
    assert a + b == b + a
    assert (a + b) - b == a
    assert (a + b) * 3 == a * 3 + b * 3
    assert (a + b).half() * 2 == a + b
    assert a * 0 == Angle()


# --------------------------------------------------------------------- known to be canonical


@law
@given(products(), products())
def test_what_is_known_to_be_canonical_stays_as_it_is(p, q):
    assume(q)
    found = canonical(p / q)
    for one in (found, -found, found.scaled(Fraction(-2, 3)), found * Product(3)):
        assert canonical(one) == canonical(Product(one.coefficient, one.factors)) == one
        assert one.is_canonical == found.is_canonical


def test_a_product_of_what_is_canonical_may_cancel():
    alpha = Angle.of("alpha")
    single, double = sine(alpha), canonical(sine(alpha * 2) * sine(Angle.of("beta")))
    assert double.is_canonical
    quotient = double / single
    assert not quotient.is_canonical
    assert canonical(quotient) == (cosine(alpha) * sine(Angle.of("beta"))).scaled(2)


def test_one_row_is_independent_unless_it_vanishes():
    alpha, beta = Angle.of("alpha"), Angle.of("beta")
    nothing = Product.of(Sum((sine(alpha), sine(alpha).scaled(-1))))
    assert independent_of([{0: nothing, 3: sine(beta)}]) == [True]
    assert independent_of([{0: nothing}]) == independent_of([{}]) == [False]
    assert independent_of([{0: sine(alpha)}, {0: sine(beta)}]) == [True, False]
