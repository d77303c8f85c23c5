"""How products are read: the same value, in few operations, by fixed rules."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import mechc
from mechc.algebra.angle import Angle
from mechc.algebra.equality import equal
from mechc.algebra.product import Product
from mechc.algebra.sums import add, canonical
from mechc.algebra.trigonometry import cosine, sine
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text
from mechc.formula.tree import quotient, total
from product_strategies import products

law = settings(max_examples=40, deadline=None, derandomize=True, database=None)
A, B, C = map(Angle.of, ["alpha", "beta", "gamma"])
a, b, c = map(Product.symbol, "abc")


@law
@given(st.lists(products(), min_size=1, max_size=3), st.lists(products(), min_size=1, max_size=3))
def test_what_is_read_has_the_value_of_the_product(above, below):
    upper, lower = add(above), add(below)
    if lower:
        found = canonical(upper / lower).formula()
        assert equal(found, quotient(upper.formula(), lower.formula()))
        listed = total(t.formula() for t in above), total(t.formula() for t in below)
        assert equal(found, quotient(*listed))


@pytest.mark.parametrize(
    ("product", "expected"),
    [
        (add([a * sine(A) * cosine(B), a * cosine(A) * sine(B)]), "a*sin(alpha + beta)"),
        (add([a * sine(A), b * sine(A), c * cosine(A)]), "sin(alpha)*(a + b) + c*cos(alpha)"),
        (-sine(A - B) * a, "a*sin(beta - alpha)"),
        (add([a, -b]) * Product(-1), "b - a"),
        (add([a * sine(A), b * cosine(A)]) / cosine(A), "a*tan(alpha) + b"),
        (add([b, c]) / c, "(b + c)/c"),
        (add([a * b * sine(A), c * cosine(B)]) / (b * sine(A)), "c*cos(beta)/(b*sin(alpha)) + a"),
    ],
)
def test_short_forms(product, expected):
    found = product.formula()
    assert text(found) == expected


def test_the_order_in_which_a_sum_was_written_is_not_seen():
    terms = [a * sine(A), b * sine(A), c * cosine(B), a * c * cosine(B) * sine(C)]
    assert text(add(terms).formula()) == text(add(terms[::-1]).formula())


@pytest.mark.parametrize(
    ("name", "most"),
    [("karpenko_fig9_packet_clamp", 9), ("four_bar", 9), ("stephenson_six_bar", 18)],
)
def test_no_longer_than_what_sympy_simplifies_to(name, most):
    k = mechc.load(name).results["k"].formula
    assert count_operations(k) <= most, text(k)


def test_dividing_through_keeps_the_quotient():
    whole = add([a * b * sine(A), c * cosine(B)])
    for below in (b, sine(A), b * sine(A), c * cosine(B), a * c):
        assert equal((whole / below).formula(), quotient(whole.formula(), below.formula()))
