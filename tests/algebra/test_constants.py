"""Constants of angles: what vanishes vanishes, and what is short stays short."""

from fractions import Fraction
from math import cos, prod, radians, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechc.algebra.angle import Angle
from mechc.algebra.constants import _relations
from mechc.algebra.cyclotomic import short, unique
from mechc.algebra.product import ZERO, Product
from mechc.algebra.sums import add, canonical
from mechc.algebra.trigonometry import cosine, sine
from mechc.formula.to_text import text

law = settings(max_examples=60, deadline=None, derandomize=True, database=None)
A, B = Angle.of("alpha"), Angle.of("beta")

PARTS = [1, 2, 3, 4, 5, 6, 9, 15, 45, 90, 105, 900]


def at(angle: Angle, degrees: int | Fraction) -> Angle:
    return angle + Angle.constant(degrees)


def direct(terms: dict[int, tuple[int, int]], parts: int) -> complex:
    turns = {j: radians(90 * j / parts) for j in terms}
    return sum(complex(*v) * complex(cos(turns[j]), sin(turns[j])) for j, v in terms.items())


@st.composite
def directions(draw):
    parts = draw(st.sampled_from(PARTS))
    values = st.tuples(st.integers(-3, 3), st.integers(-3, 3)).filter(any)
    return parts, draw(st.dictionaries(st.integers(0, parts - 1), values, max_size=6))


@law
@given(directions())
def test_constants_keep_their_value_and_their_unique_form(drawn):
    parts, terms = drawn
    once = unique(dict(terms), parts)
    read = short(once, parts)
    assert direct(once, parts) == pytest.approx(direct(terms, parts), abs=1e-9)
    assert direct(read, parts) == pytest.approx(direct(terms, parts), abs=1e-9)
    assert unique(dict(read), parts) == once
    assert (abs(direct(terms, parts)) < 1e-9) == (once == {})


@law
@given(st.sampled_from(PARTS), st.data())
def test_one_direction_stays_one_direction(parts, data):
    direction = data.draw(st.integers(0, parts - 1))
    once = {direction: (2, -1)}
    assert short(unique(dict(once), parts), parts) == once


@pytest.mark.parametrize("n", [3, 4, 5, 6, 7, 8, 9, 10, 12, 15])
def test_a_star_of_n_directions_vanishes(n):
    assert add(cosine(at(A, Fraction(360 * i, n))) for i in range(n)) == ZERO
    assert add(sine(at(A * 2 - B, Fraction(360 * i, n))) for i in range(n)) == ZERO


@pytest.mark.parametrize(
    ("terms", "total"),
    [
        ([cosine(Angle.constant(36)), -cosine(Angle.constant(72))], Product(Fraction(1, 2))),
        ([Product(1), cosine(Angle.constant(120)).scaled(2)], ZERO),
        ([sine(Angle.constant(75)), -sine(Angle.constant(15))], cosine(Angle.constant(45))),
        ([cosine(A), sine(at(A, -30)), sine(at(A, -150))], ZERO),
        ([cosine(at(A, 20)), cosine(at(A, 140))], cosine(at(A, 80))),
        ([sine(at(A, 40)) * cosine(A), -cosine(at(A, 40)) * sine(A)], sine(Angle.constant(40))),
        (
            [sine(Angle.constant(80)), -sine(Angle.constant(40)) * cosine(Angle.constant(40)) ** 1],
            sine(Angle.constant(40)) * cosine(Angle.constant(40)),
        ),
    ],
)
def test_sums_of_constants_are_seen_through(terms, total):
    assert add([*terms, -total]) == ZERO
    assert add(terms) == add([total])


def test_factors_with_constants_are_found_again():
    product = cosine(at(A, 60)) * sine(at(B, 25)) * cosine(at(A - B, Fraction(123, 10)))
    a, c = Product.symbol("a"), Product.symbol("c")
    parts = [product * a * cosine(A), product * c * sine(at(A, 17))]
    whole = add(parts)
    assert all(f in whole.factors for f in product.factors)
    assert text(whole.formula()).count("cos") + text(whole.formula()).count("sin") == 5


@law
@given(st.integers(1, 90), st.integers(1, 90), st.integers(1, 60))
def test_constants_in_a_sum_never_make_two_forms_of_one_value(p, q, parts):
    one = sine(at(A, p)) * cosine(at(A, Fraction(q, parts)))
    two = [sine(at(A * 2, p + Fraction(q, parts))), sine(Angle.constant(p - Fraction(q, parts)))]
    assume(parts != 60)
    assert add([one, -add(x.scaled(Fraction(1, 2)) for x in two)]) == ZERO


def test_constants_that_double_into_one_another_are_split_once_only():
    """10°, 20°, 40°, 80° and sin 160° = sin 20° go round in a circle."""
    angles = {d: Angle.constant(d) for d in (10, 20, 40)}
    above = sine(angles[10]) * cosine(angles[10])
    below = cosine(angles[40]) * sine(angles[20])
    found = canonical(above / below)
    assert found.evaluate({}) == pytest.approx(0.5 / cos(radians(40)), rel=1e-14)


@pytest.mark.parametrize("degrees", [10, 15, 20, Fraction(61, 2), 40, 45, 60, Fraction(121, 4), 80])
def test_relations_between_sines_of_constants_hold_in_numbers(degrees):
    """A sine of 30.5° is none of 30°, which is a half and left out."""
    found = _relations(degrees)
    assert found
    for sines, value in found:
        assert prod(sin(radians(x)) ** e for x, e in sines.items()) == pytest.approx(float(value))
        assert not {30, 90} & sines.keys()
