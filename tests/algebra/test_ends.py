"""Every rewriting of products ends: constants on either side of a line, and multiples of angles."""

from fractions import Fraction
from itertools import product as pairs
from math import isclose, prod
from random import Random

import pytest

import mechc
from mechc.algebra.angle import Angle
from mechc.algebra.cancelling import canonical
from mechc.algebra.constants import is_constant
from mechc.algebra.factors import Trig
from mechc.algebra.product import Product
from mechc.algebra.trigonometry import cosine, sine
from mechc.formula.to_text import text

STEPS = [Fraction(1), Fraction(5), Fraction(15, 2), Fraction(15), Fraction(45, 2)]
ALL = sorted({step * i for step in STEPS for i in range(1, 90) if 0 < step * i < 90})
COARSE = sorted({step * i for step in STEPS[1:] for i in range(1, 90) if 0 < step * i < 90})
A = Angle.of("a")


def of(degrees):
    return sine(Angle.constant(degrees))


def count(product):
    return sum(abs(e) for f, e in product.factors.items() if is_constant(f))


def test_all_pairs_of_constants_on_either_side_of_a_line():
    for above, below in pairs(ALL, repeat=2):
        given = of(above) / of(below)
        found = canonical(given)
        assert isclose(found.evaluate({}), given.evaluate({}), rel_tol=1e-13)
        assert count(found) <= count(given)
        assert canonical(found) == found


def test_constants_with_powers_and_many_at_once():
    dice = Random(1)
    for _ in range(1000):
        given = prod(
            (of(dice.choice(COARSE)) ** dice.choice((-2, -1, 1, 2)) for _ in range(6)),
            start=Product(1),
        )
        found = canonical(given)
        assert isclose(found.evaluate({}), given.evaluate({}), rel_tol=1e-12)
        assert count(found) <= count(given)


def turned(dice):
    angle = A * Fraction(dice.choice((1, 1, 2, 3, 4, 6, 8)), dice.choice((1, 1, 2)))
    angle = angle + Angle.constant(dice.choice(COARSE) * dice.choice((-1, 0, 1)))
    return dice.choice((sine, cosine))(angle)


def test_multiples_of_an_angle_with_constants_on_either_side_of_a_line():
    dice = Random(2)
    for _ in range(800):
        above, below = (turned(dice) * turned(dice) * of(dice.choice(COARSE)) for _ in range(2))
        found = canonical(above / below)
        values = {"a": 0.7364}
        assert isclose(found.evaluate(values), (above / below).evaluate(values), rel_tol=1e-11)
        assert canonical(found) == found


@pytest.mark.parametrize(
    ("above", "below", "short"),
    [
        (cosine(A * 3), cosine(A), "2*cos(2*a) - 1"),
        (sine(A * 3), sine(A), "1 + 2*cos(2*a)"),
        (sine(A * 2), cosine(A), "2*sin(a)"),
        (cosine(A * 3), cosine(A) ** 2, "(2*cos(2*a) - 1)/cos(a)"),
        (of(60), of(15), "sqrt(3)/(2*sin(pi/12))"),
        (of(60) ** 2, of(45) ** 2, "3/2"),
        (of(40), of(20), "2*cos(pi/9)"),
        (of(20) * of(40) * of(80), Product(1), "sqrt(3)/8"),
    ],
)
def test_what_divides_is_cancelled(above, below, short):
    assert text(canonical(above / below).formula()) == short


def test_a_sum_is_divided_by_a_sine_whose_constant_it_does_not_mention():
    """cos 3a is 4 cos a cos(a + 60°) cos(a − 60°), whichever of them is cancelled first."""
    parts = [cosine(A + Angle.constant(60)), cosine(A - Angle.constant(60))]
    whole = cosine(A * 3)
    one = canonical(canonical(whole / cosine(A)) / parts[0])
    other = canonical(canonical(whole / parts[0]) / cosine(A))
    assert one == other == parts[1].scaled(4)
    assert all(isinstance(f, Trig) for f in one.factors)


@pytest.mark.parametrize(("rod", "guide"), [(75, 45), (105, 30), (15, 60), (50, 20)])
def test_a_rod_between_guides_at_constant_angles(rod, guide):
    mechanism = mechc.loads(
        f"""
        slider A along x
        slider C along {guide} deg
        link AC
        AC = 100 mm @ {rod} deg
        force P at A along x
        force F at C along {180 + guide} deg
        find k = P/F
        """,
        "rod.mech",
    )
    given = cosine(Angle.constant(rod)) / cosine(Angle.constant(rod - guide))
    assert isclose(abs(mechanism.evaluate()["k"]), abs(given.evaluate({})), rel_tol=1e-12)
