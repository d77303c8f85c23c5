"""Triangles by the laws of sines and cosines: the same values as the forms that code has."""

import math

import pytest

from good_mechanisms import CLOSED, compiled
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, negative, product, total
from mechc.model.result import Definition
from mechc.power.numbers import default_values
from mechc.report.book_forms import book_form, positive_names

A, B, C = (Symbol(name) for name in "abc")


def square(symbol):
    return product([(symbol, 2)])


def angle_at_c():
    """Return the angle between sides a and b of a triangle, as code finds it."""
    sides = [total([A, B, C]), total([A, B, negative(C)]), total([A, C, negative(B)])]
    four = product((side, 1) for side in (*sides, total([B, C, negative(A)])))
    return Call(
        "atan2", (Call("sqrt", (four,)), total([square(A), square(B), negative(square(C))]))
    )


def test_an_angle_of_a_triangle_is_by_the_law_of_cosines():
    assert text(book_form(angle_at_c(), {"a", "b"})) == "acos((a^2 + b^2 - c^2)/(2*a*b))"


def test_not_where_a_side_may_be_negative():
    assert book_form(angle_at_c(), {"a"}) == angle_at_c()


def test_not_where_the_sides_are_of_no_triangle():
    lost = Call("atan2", (Call("sqrt", (total([A, B]),)), C))
    assert book_form(lost, {"a", "b", "c"}) == lost


@pytest.mark.parametrize("name", CLOSED)
def test_a_report_has_the_values_of_the_code(name):
    compilation = compiled(name)
    where = {d.name: d for r in compilation.solution.results for d in r.where}.values()
    positive = positive_names(compilation.mechanism, where)
    values = default_values(compilation.solution.balance.plan)
    for definition in where:
        form = book_form(definition.formula, positive)
        assert Definition(definition.name, form) == definition or math.isclose(
            evaluate(form, values), evaluate(definition.formula, values), rel_tol=1e-9
        )
