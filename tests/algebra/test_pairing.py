"""Sines of a sum in pairs: each pair is a product of a sine and a cosine, of the same value."""

import pytest

from mechc.algebra.angle import Angle
from mechc.algebra.pairing import paired
from mechc.algebra.product import Product, Sum
from mechc.algebra.trigonometry import cosine, sine
from product_strategies import VALUES

ALPHA, BETA = map(Angle.of, ("alpha", "beta"))
SUM, DIFFERENCE = ALPHA + BETA, ALPHA - BETA
A, C = map(Product.symbol, "ac")


@pytest.mark.parametrize(
    ("one", "other", "half"),
    [
        (sine(SUM), sine(DIFFERENCE), sine(ALPHA) * cosine(BETA)),
        (sine(SUM), -sine(DIFFERENCE), cosine(ALPHA) * sine(BETA)),
        (cosine(SUM), cosine(DIFFERENCE), cosine(ALPHA) * cosine(BETA)),
        (cosine(DIFFERENCE), -cosine(SUM), sine(ALPHA) * sine(BETA)),
        (A * sine(SUM), A * sine(DIFFERENCE), A * sine(ALPHA) * cosine(BETA)),
    ],
)
def test_two_waves_of_one_size_are_a_product(one, other, half):
    for terms in ((one, other, C), (other, one, C)):
        found = paired(Sum(terms))
        assert found == Product.of(Sum((half.scaled(2), C)))
        assert found.evaluate(VALUES) == pytest.approx(sum(t.evaluate(VALUES) for t in terms))


@pytest.mark.parametrize("other", [cosine(DIFFERENCE), A * sine(DIFFERENCE), A])
def test_other_terms_stay_apart(other):
    whole = Sum((sine(SUM), other, C))
    assert paired(whole) == Product.of(whole)
