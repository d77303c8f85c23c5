"""Common divisors of polynomials by hand: each step on numbers that are easy to follow.

Polynomials are dictionaries from exponents to coefficients: ``x² - 1`` is ``{(2,): 1, (0,): -1}``.
"""

import pytest

from mechc.algebra import gcd
from mechc.algebra.gcd import TooLongError, common, degrees, divided, stripped, times
from mechc.algebra.modular import PRIME
from mechc.work import Allowance, at_most


def poly(*terms):
    """Return a polynomial of (coefficient, exponents…)."""
    return {tuple(exponents): value % PRIME for value, *exponents in terms}


X = poly((1, 1), (1, 0))  # x + 1
X2 = poly((1, 1), (-2, 0))  # x - 2
XY = poly((1, 1, 0), (1, 0, 1))  # x + y
YX = poly((1, 1, 0), (-1, 0, 1))  # x - y
X1 = poly((1, 1, 0), (1, 0, 0))  # x + 1, of two variables
Y1 = poly((1, 0, 1), (1, 0, 0))  # y + 1


def plus(f, g):
    return {e: (f.get(e, 0) + g.get(e, 0)) % PRIME for e in f.keys() | g.keys()}


def product(*factors):
    first, *others = factors
    for other in others:
        first = times(first, other)
    return first


# ------------------------------------------------------------------------- arithmetic


def test_a_product():
    assert times(X, X2) == poly((1, 2), (-1, 1), (-2, 0))
    assert times(XY, YX) == poly((1, 2, 0), (-1, 0, 2))  # x·y and -x·y are gone
    assert times(X, {}) == {}


def test_a_quotient():
    assert divided(poly((1, 2), (-1, 1), (-2, 0)), X2) == X
    assert divided(poly((6, 2, 1), (4, 1, 0)), poly((2, 1, 0))) == poly((3, 1, 1), (2, 0, 0))
    assert divided(poly((1, 2, 0), (-1, 0, 2)), YX) == XY
    assert divided(X, poly((2, 0))) == poly((pow(2, -1, PRIME), 1), (pow(2, -1, PRIME), 0))


def test_a_monomial_is_taken_out():
    assert stripped(poly((3, 2, 5), (4, 3, 5))) == poly((3, 0, 0), (4, 1, 0))
    assert stripped(poly((3, 1, 0), (4, 1, 2))) == poly((3, 0, 0), (4, 0, 2))
    assert stripped(XY) is XY


def test_the_degree_in_each_variable():
    assert degrees(poly((1, 2, 0), (1, 0, 3), (1, 1, 1))) == [2, 3]


# ---------------------------------------------------------------------------- divisors


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (X, X, X),
        (X, X2, poly((1, 0))),
        (product(X, X2), product(X, X), X),
        (product(X, X, X2), product(X, X), product(X, X)),
        (product(X, X), product(X, X, X, X2), product(X, X)),
        (times(X, poly((5, 0))), times(X, poly((7, 0))), X),  # the highest coefficient is 1
        (times(X, poly((1, 3))), times(X, poly((1, 1))), X),  # without monomials
        (poly((4, 3)), X, poly((1, 0))),
        (poly((4, 0)), poly((6, 0)), poly((1, 0))),
    ],
)
def test_of_one_variable(first, second, expected):
    assert common(first, second) == expected


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (XY, YX, poly((1, 0, 0))),
        (XY, Y1, poly((1, 0, 0))),
        (product(XY, YX), product(XY, Y1), XY),
        (product(XY, Y1), product(YX, Y1), Y1),  # it reaches in one variable only
        (product(XY, XY, YX), product(XY, XY, Y1), product(XY, XY)),
        (product(XY, Y1, YX), product(XY, Y1), product(XY, Y1)),
        (product(XY, Y1, Y1), product(YX, XY, Y1), product(XY, Y1)),
        (product(XY, YX, YX, Y1), product(XY, YX, Y1, Y1), product(XY, YX, Y1)),
    ],
)
def test_of_two_variables(first, second, expected):
    assert common(first, second) == expected
    assert common(second, first) == expected


def test_of_contents_that_remainders_would_lose():
    """Both are a polynomial in y times one in x: each part is found by itself."""
    y2 = poly((1, 0, 2), (3, 0, 0))
    x3 = poly((1, 3, 0), (2, 0, 0))
    first, second = product(y2, x3, XY), product(y2, x3, YX)
    assert common(first, second) == product(y2, x3)


def test_of_a_degree_that_falls_at_once():
    """The first remainder is (x + y)·y² already, and another one would be none."""
    second = times(XY, poly((1, 2, 0), (1, 0, 5)))
    first = plus(product(second, X1), times(XY, poly((1, 0, 2))))
    assert common(first, second) == common(second, first) == XY


def test_of_three_variables():
    a = poly((1, 1, 0, 0), (2, 0, 1, 0), (3, 0, 0, 1))  # x + 2y + 3z
    b = poly((1, 1, 1, 0), (1, 0, 0, 2))  # xy + z²
    c = poly((1, 0, 2, 0), (-1, 1, 0, 1))  # y² - xz
    d = poly((1, 1, 0, 0), (1, 0, 0, 0))  # x + 1
    assert common(product(a, b), product(a, c)) == a
    assert common(product(a, b, d), product(b, c, d)) == times(b, d)
    assert common(product(a, d), product(c, d)) == d
    assert common(product(a, b), product(c, d)) == poly((1, 0, 0, 0))


# ------------------------------------------------------------------------------ limits


def test_a_degree_that_is_too_high_is_refused():
    high = poly((1, gcd.HIGHEST + 1), (1, 0))
    for pair in ((high, X), (X, high)):
        with pytest.raises(TooLongError):
            common(*pair)


def test_the_highest_degree_is_taken():
    """x⁴⁰⁹⁶ - 1 and x - 1 have x - 1 in common."""
    one = poly((1, 1), (-1, 0))
    assert common(poly((1, gcd.HIGHEST), (-1, 0)), one) == one


def test_a_degree_counts_without_the_monomial():
    shifted = poly((1, gcd.HIGHEST + 1), (1, gcd.HIGHEST))
    assert common(shifted, X) == X


def test_a_remainder_that_grows_is_given_up(monkeypatch):
    """The first one of x + y + 1 by x - y has three terms, and none has more than the limit."""
    first, second = product(XY, XY, Y1), product(XY, YX, YX)
    monkeypatch.setattr(gcd, "MOST_REMAINDER_TERMS", 3)
    assert common(first, second) == XY
    monkeypatch.setattr(gcd, "MOST_REMAINDER_TERMS", 2)
    with pytest.raises(TooLongError):
        common(first, second)


def test_work_is_counted():
    """A product takes as many steps as pairs of terms, a quotient those that it goes over."""
    with at_most(Allowance(100)) as allowance:
        times(product(X, X), X2)
    assert 100 - allowance.left == 4 + 6
    with at_most(Allowance(100)) as allowance:
        divided(product(X, X2), X)
    assert 100 - allowance.left == 4 + (3 + 2) + (2 + 2)
