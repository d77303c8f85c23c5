"""Laws of sums of products: one form for one value, whatever way it is written."""

from fractions import Fraction
from math import isclose, prod
from random import Random

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechc.algebra.angle import Angle
from mechc.algebra.factors import Trig
from mechc.algebra.from_formula import to_product
from mechc.algebra.laurent import Ring, size
from mechc.algebra.modular import ModularPoint
from mechc.algebra.product import ONE, ZERO, Product, Sum
from mechc.algebra.sums import MOST_MULTIPLIED_TERMS, BoundSum, add, canonical
from mechc.algebra.trigonometry import cosine, sine
from mechc.formula.to_text import text
from mechc.formula.tree import Constant, Number
from product_strategies import VALUES, angles, products

law = settings(max_examples=40, deadline=None, derandomize=True, database=None)


some = st.lists(products(), min_size=1, max_size=4)
plain = st.lists(products([0, 0, 90]), min_size=1, max_size=4)


def close(found, expected, scale=1.0):
    return isclose(found, expected, rel_tol=1e-9, abs_tol=1e-9 * max(scale, 1))


def value(terms):
    return sum(t.evaluate(VALUES) for t in terms)


@law
@given(some)
def test_a_sum_keeps_its_value(terms):
    total = add(terms)
    assert close(total.evaluate(VALUES), value(terms), sum(abs(t.coefficient) for t in terms))
    point = ModularPoint(5)
    assert total.residue(point) == sum(t.residue(point) for t in terms) % point.prime


@law
@given(some, st.integers(0, 99))
def test_the_order_of_terms_does_not_matter(terms, seed):
    shuffled = list(terms)
    Random(seed).shuffle(shuffled)
    assert add(shuffled) == add(terms)


@law
@given(some, some)
def test_the_grouping_of_terms_does_not_matter(left, right):
    assume(sum(map(size, [*left, *right])) <= MOST_MULTIPLIED_TERMS)
    assert add([add(left), add(right)]) == add([*left, *right])


@law
@given(some)
def test_a_sum_added_to_nothing_stays_as_it_is(terms):
    total = add(terms)
    assert add([total]) == total
    assert canonical(total) == total


@law
@given(some)
def test_a_sum_less_itself_vanishes(terms):
    total = add(terms)
    assert add([total, -total]) == ZERO
    assert add([*terms, -total]) == ZERO
    assert bool(total) == bool(sum(t.residue(ModularPoint(5)) for t in terms) % ModularPoint.prime)


@law
@given(plain, products([0, 90]))
def test_a_common_factor_is_taken_out(terms, common):
    whole = add(t * common for t in terms)
    assert whole == canonical(add(terms) * common)


@law
@given(st.lists(products([0, 0, 90], trigs=3), min_size=1, max_size=1), plain)
def test_what_is_multiplied_out_is_factored_again(factors, terms):
    whole = prod(factors, start=ONE)
    assume(0 < size(whole) <= 32)
    ring = Ring([whole])
    parts = [
        part.scaled(ring.expand([whole]).scale)
        for key, v in ring.expand([whole]).terms.items()
        for part in single(ring, key, v)
    ]
    assert add(parts) == canonical(whole)


def single(ring, key, v):
    powers = Product(1, ring.monomial(key))
    return [powers * part for part in ring.single(key, v)]


@law
@given(angles())
def test_sines_and_cosines_have_one_form(angle):
    for turns in range(-4, 5):
        turned = angle + Angle.constant(90 * turns)
        assert sine(turned) == (sine, cosine)[turns % 2](angle).scaled((-1) ** (turns % 4 // 2))
    assert sine(-angle) == -sine(angle)
    assert cosine(-angle) == cosine(angle)
    assert sine(angle) == cosine(angle - Angle.constant(90))


@law
@given(angles(), st.integers(1, 4))
def test_double_angles_are_split_only_to_cancel(angle, halvings):
    assume(angle.terms)
    doubled = sine(angle * 2**halvings)
    assert canonical(sine(angle) * cosine(angle)) == canonical(sine(angle * 2)).scaled(
        Fraction(1, 2)
    )
    ratio = canonical(doubled / sine(angle))
    assert all(e > 0 for e in ratio.factors.values())
    assert close(
        ratio.evaluate(VALUES) * sine(angle).evaluate(VALUES), doubled.evaluate(VALUES), 10
    )


@law
@given(products(), products(), st.integers(-3, 3))
def test_products_multiply_like_numbers(p, q, n):
    assume(p.coefficient and q.coefficient)
    point = ModularPoint(2)
    assume(p.residue(point) and q.residue(point))
    assert p * q == q * p
    assert (p * q) / q == p
    assert (p * q) ** n == p**n * q**n
    product = p.residue(point) * q.residue(point) % point.prime
    assert (p * q).residue(point) == product
    assert canonical(p / q).residue(point) * q.residue(point) % point.prime == p.residue(point)


def test_a_sum_that_names_hide_is_seen_to_vanish():
    a, b, c = map(Product.symbol, "abc")
    long = add([a * b, c * c])
    name = Product.of(BoundSum("s1", long))
    assert add([name, -(a * b), -(c**2)]) == ZERO
    assert add([name, a * b]) != ZERO


def test_a_sum_too_long_to_multiply_out_is_seen_to_vanish():
    terms = [Product.symbol(f"x{i}") for i in range(MOST_MULTIPLIED_TERMS)]
    long = Product.of(Sum(tuple(terms)))
    more = [t * Product.symbol("y") for t in terms]
    assert add([long * Product.symbol("y"), *(-t for t in more)]) == ZERO


def test_a_huge_exponent_is_carried_as_it_is():
    a, t = Product.symbol("a"), sine(Angle.of("t"))
    assert (a * t) ** 1000 / (a * t) ** 999 == a * t
    assert add([a**1000, a**1001]).factors[next(iter(a.factors))] == 1000


@pytest.mark.parametrize(
    "constant", [0, 30, 45, 60, 40, 80, Fraction("12.3456789"), Fraction(1, 7919)]
)
def test_addition_theorems_hold_for_every_constant(constant):
    a = Angle.of("alpha") + Angle.constant(constant)
    b = Angle.of("beta") * Fraction(1, 2) - Angle.constant(constant * 2)
    parts = [sine(a) * cosine(b), cosine(a) * sine(b)]
    assert add(parts) == sine(a + b)
    assert add([cosine(a - b), -cosine(a + b)]) == canonical(sine(a) * sine(b) * Product(2))
    assert add([sine(a) ** 2, cosine(a) ** 2]) == ONE


def test_a_coefficient_of_a_million_is_carried():
    a, b = Angle.of("alpha") * 10**6, Angle.of("beta")
    assert add([sine(a) * cosine(b), cosine(a) * sine(b)]) == sine(a + b)


def test_a_trig_of_a_form_is_never_a_constant_that_is_rational():
    for degrees in range(-720, 721, 30):
        for product in (sine(Angle.constant(degrees)), cosine(Angle.constant(degrees))):
            for factor in product.factors:
                assert isinstance(factor, Trig)
                assert factor.angle.degrees == 30
                assert factor.function == "cos"


def test_what_terms_of_a_sum_share_is_taken_out_whole():
    """A factor that most terms have was taken out once: mu*p*p*(3*D + 3*E)."""
    mu, p, d, e, x = map(Product.symbol, ("mu", "p", "D", "E", "x"))
    inner = mu * p * p
    whole = Sum((inner * d.scaled(3), inner * e.scaled(3), x))
    assert text(whole.formula()) == "3*mu*p^2*(D + E) + x"
    halves = Sum((x, (inner * d).scaled(Fraction(-3, 2)), (inner * e).scaled(Fraction(9, 4))))
    assert text(halves.formula()) == "3*mu*p^2*(3*E - 2*D)/4 + x"


def test_terms_that_cancel_by_what_named_numbers_are_are_left_out():
    """Sides b and d of a parallelogram are 70 mm each: (b - d)·sin β + e·cos β is e·cos β."""
    length = Number(Fraction(7, 100))
    a, b, d = (to_product(Constant(name, length)) for name in "abd")
    e = to_product(Constant("e", Number(Fraction(1, 2))))
    beta = Angle.of("beta")
    whole = add([b * sine(beta), -d * sine(beta), e * cosine(beta)])
    assert text(whole.formula()) == "e*cos(beta)"
    assert text(add([a * a, -b * d, e * sine(beta)]).formula()) == "e*sin(beta)"
    kept = add([b * sine(beta), -e * sine(beta), d * cosine(beta)])
    assert text(kept.formula()) == "sin(beta)*(b - e) + d*cos(beta)"
