"""Straight-line code that is compiled gives the bits of the formulas themselves."""

import math
import random
import struct
from fractions import Fraction

import pytest

from mechc.formula.evaluate import evaluate, straight_line
from mechc.formula.numeric.straight_line import OFTEN
from mechc.formula.tree import Call, Formula, Number, Power, Product, Sum, Symbol

X, Y = Symbol("x"), Symbol("y")


def power(base: Formula, exponent: Fraction | int) -> Formula:
    return Power(base, Number(Fraction(exponent)))


FORMULAS: dict[str, Formula] = {
    "sum": Sum((X, Y, Number(Fraction(1, 10)))),
    "nothing but zeros": Sum((Product((Number(Fraction(-1)), X)), Product((X, Y)))),
    "product": Product((Number(Fraction(1, 3)), X, Y, power(Sum((X, Y)), -2))),
    "many factors": Product((X,) * 40),
    "whole power": power(X, 3),
    "inverse": power(X, -1),
    "root": power(X, Fraction(1, 2)),
    "high power": power(X, 400),
    "functions": Call("atan2", (Call("sin", (X,)), Call("sqrt", (Y,)))),
    "cotangent": Call("cot", (X,)),
    "choice": Call("choose", (Call("less", (X, Y)), power(X, -1), Y)),
}


def bits(value: float) -> bytes:
    return b"no value" if math.isnan(value) else struct.pack("d", value)


@pytest.mark.parametrize("name", FORMULAS)
def test_compiled_code_has_the_bits_of_its_formula(name: str) -> None:
    chance = random.Random(name)
    code = straight_line([FORMULAS[name]], ["x", "y"])
    places = [(0.0, 1.0), (-0.0, -1.0), (1e300, 1e300), (-2.0, 2.0), (0.0, 0.0)]
    places += [(chance.uniform(-9, 9), chance.uniform(-9, 9)) for _ in range(2 * OFTEN)]
    for x, y in places[5:] + places:
        (found,) = code.at([x, y])
        assert bits(found) == bits(evaluate(FORMULAS[name], {"x": x, "y": y})), (x, y)


def test_what_has_no_value_leaves_the_others_theirs() -> None:
    code = straight_line([power(X, -1), power(Y, -1)], ["x", "y"])
    for _ in range(OFTEN):
        code.at([1.0, 2.0])
    inverse, other = code.at([0.0, 2.0])
    assert math.isnan(inverse)
    assert other == 0.5


def test_a_name_without_a_value_is_not_a_number_for_what_rests_on_it() -> None:
    chosen = Call("choose", (Call("less", (Y, Number(Fraction(1)))), Y, Symbol("z")))
    code = straight_line([Symbol("z"), chosen], ["x", "y"], [("z", power(X, -1))])
    for _ in range(OFTEN):
        code.at([1.0, 2.0])
    first, second = code.at([0.0, 0.5])
    assert math.isnan(first)
    assert second == 0.5
