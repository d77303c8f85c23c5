"""Expressions as they were written: numbers with their units, π, what may not become a decimal."""

import math

import pytest

from mechc.diagnostics import Report
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Formula
from mechc.formula.walk import symbols
from mechc.model.parts import written
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.from_dsl import parse

VALUES = {"a": 3.0, "b": 2.0}


def read(value: str) -> Formula:
    source = Source("a.mech", f"let x = {value}")
    (let,) = parse(source, Report(source)).statements
    assert isinstance(let, ast.Let)
    assert isinstance(let.value, ast.Expr)
    return written.expression(let.value)


@pytest.mark.parametrize(
    ("value", "shown", "number"),
    [
        ("pi*a^2/4", "pi*a^2/4", math.pi * 9 / 4),
        ("a + 5 mm - b", "a + 5 mm - b", 1.005),
        ("90 deg - a", "90 deg - a", math.pi / 2 - 3),
        ("2*a/(0.5*b)", "2*a/(0.5*b)", 6.0),
        ("(8 mm)^2*a", "(8 mm)^2*a", 64e-6 * 3),
        ("a^0.5", "a^(1/2)", math.sqrt(3)),
        ("max(a, b, 0.2 kN)", "max(a, b, 0.2 kN)", 200.0),
    ],
)
def test_an_expression_is_what_people_wrote_and_its_value(value, shown, number):
    found = read(value)
    assert text(found) == shown
    assert evaluate(found, VALUES) == pytest.approx(number)
    assert symbols(found) <= VALUES.keys()


def test_a_whole_number_below_the_line_stays_there():
    assert text(read("a/5")) == "a/5"


def test_units_are_those_of_the_numbers():
    assert written.units(read("a + 5 mm"), read("2*(8 kN)^2/b")) == ["mm", "kN"]
