"""Columns of rounded values have the bits of what is found pose by pose, or leave it to that."""

import math
import random
from fractions import Fraction

import pytest

from mechc.formula.numeric.rounded_columns import RoundedColumn, RoundedColumns
from mechc.formula.numeric.rounding import EPS, Rounding
from mechc.formula.tree import Call, Formula, Number, Power, Product, Sum, Symbol, System, implicit

X, Y = Symbol("x"), Symbol("y")
EXACT = [(0.0, 1.0), (-0.0, -1.0), (math.pi / 2, 0.0), (1e300, 1e300), (-2.0, 2.0), (0.0, 0.0)]


def number(value: Fraction | int) -> Number:
    return Number(Fraction(value))


def power(base: Formula, exponent: Fraction | int) -> Formula:
    return Power(base, number(exponent))


CIRCLE = System(
    ("r",), (Sum((power(Symbol("r"), 2), Product((number(-1), X)))),), (("x", 4.0),), (2.0,)
)

FORMULAS: dict[str, Formula] = {
    "sum": Sum((X, Y, number(Fraction(1, 10)))),
    "difference": Sum((X, Product((number(-1), Y)), Product((number(-1), Sum((X, Y)))))),
    "product": Product((number(Fraction(1, 3)), X, Y, power(Sum((X, Y)), -2))),
    "square of what may be zero": power(Call("cos", (X,)), 2),
    "inverse": power(Call("cos", (X,)), -1),
    "of an inverse": Product((Y, power(power(X, -1), -1))),
    "root": power(X, Fraction(1, 2)),
    "overflow": power(X, 400),
    "power of two quantities": Power(X, Y),
    "tangent and cotangent": Sum((Call("tan", (X,)), Call("cot", (Y,)), Call("sec", (X,)))),
    "arcs": Sum((Call("asin", (X,)), Call("acos", (Y,)), Call("atan", (X,)))),
    "direction": Call("atan2", (Call("sin", (X,)), Y)),
    "distance": Call("hypot", (X, Y)),
    "sign": Call("sign", (Call("cos", (X,)),)),
    "choice": Call("choose", (Call("less", (X, Y)), power(X, -1), Y)),
    "next size": Call("next", (X, number(1), Y)),
    "loop": Product((implicit(CIRCLE, 0), Y)),
}


def columns(places: list[tuple[float, float]]) -> RoundedColumns:
    given = {
        name: RoundedColumn([p[i] for p in places], [EPS * abs(p[i]) for p in places])
        for i, name in enumerate("xy")
    }
    return RoundedColumns(given, len(places))


@pytest.mark.parametrize("name", FORMULAS)
def test_a_column_has_the_bits_of_each_pose(name: str) -> None:
    chance = random.Random(name)
    places = EXACT + [(chance.uniform(-3, 3), chance.uniform(-3, 3)) for _ in range(60)]
    column = columns(places).of(FORMULAS[name])
    for row, (x, y) in enumerate(places):
        alone = Rounding({"x": x, "y": y}).of(FORMULAS[name])
        found = column.at(row)
        assert found in (None, alone), (x, y)
        if not math.isfinite(alone.value):
            assert found is None


@pytest.mark.parametrize("name", FORMULAS)
def test_a_column_knows_most_poses(name: str) -> None:
    places = [(0.1 + 0.01 * i, 0.9 - 0.01 * i) for i in range(30)]
    column = columns(places).of(FORMULAS[name])
    assert sum(column.at(row) is not None for row in range(30)) >= 29


def test_definitions_are_those_of_a_single_pose() -> None:
    definitions = [("s", Sum((X, Y))), ("t", Product((Symbol("s"), X))), ("u", Symbol("nowhere"))]
    inner = columns([(1.0, 2.0)]).with_definitions(definitions)
    alone = Rounding({"x": 1.0, "y": 2.0})
    alone.define(definitions)
    assert inner.names == {"x", "y", "s", "t"}
    assert inner.of(Symbol("t")).at(0) == alone.values["t"]
