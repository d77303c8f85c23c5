"""What formulas measure, found by what they come to in other units of length, mass and time."""

from fractions import Fraction

import pytest

from mechc.formula.tree import Call, Symbol, number, power, product, total
from mechc.model.result import Definition
from mechc.report.dimensions import dimension_of, found_dimension
from mechc.units import ANGLE, FORCE, LENGTH, MASS, NUMBER, PRESSURE, TIME, Dimension

HALF, THIRD = number(Fraction(1, 2)), number(Fraction(1, 3))
F, W, M, F0 = map(Symbol, ("F", "w", "m", "f"))
VALUES = {"F": 40.0, "w": 0.3, "m": 2.0, "f": 0.1, "t": 3.0}
DIMENSIONS = {"F": FORCE, "w": LENGTH, "m": MASS, "f": NUMBER, "t": TIME}


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (product([(F, 1), (W, -2)]), PRESSURE),
        (product([(F, 1), (W, 1), (F0, 3)]), Dimension(2, 1, -2)),
        (power(product([(F, 1), (W, 1), (M, -1)]), HALF), Dimension(1, 0, -1)),
        (power(W, THIRD), Dimension(Fraction(1, 3))),
        (
            total([product([(F, 2)]), product([(F, 1), (M, 1), (W, 1), (Symbol("t"), -2)])]),
            Dimension(2, 2, -4),
        ),
        (product([(W, -1)]), Dimension(-1)),
        (F0, NUMBER),
        (total([W, F0]), None),  # a length and a number
        (total([F, M]), None),
        (Call("sin", (W,)), None),
        (total([W, product([(number(-1), 1), (W, 1)])]), None),  # 0 is of any dimension
        (power(W, number(Fraction(13, 10))), None),  # as what rounding leaves of a zero
    ],
)
def test_the_dimension_of_a_formula(formula, expected):
    assert dimension_of(formula, VALUES, DIMENSIONS) == expected


@pytest.mark.parametrize(
    ("definition", "expected"),
    [
        (Definition("len_AB", F), LENGTH),  # by its name
        (Definition("q", Call("asin", (F0,))), ANGLE),
        (Definition("q", product([(F, 1), (W, -2)])), PRESSURE),
        (Definition("q", Symbol("unknown")), None),
    ],
)
def test_the_dimension_of_a_definition(definition, expected):
    assert found_dimension(definition, (), VALUES, DIMENSIONS) == expected
