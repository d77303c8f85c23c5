"""Triangles by the laws of sines and cosines: the same values as the forms that code has."""

import math

import pytest

from good_mechanisms import CLOSED, compiled
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, negative, product, total
from mechc.model.result import Definition
from mechc.power.numbers import default_values
from mechc.report.book_forms import angle_ranges, book_form, positive_names

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


def two_equal_arms():
    """Return the components of a + a @ phi, along first."""
    angle = Symbol("phi")
    along, across = (product([(A, 1), (Call(f, (angle,)), 1)]) for f in ("cos", "sin"))
    return total([A, along]), across


@pytest.mark.parametrize(
    ("range_", "lengths", "expected"),
    [
        ((-40, 40), {"a"}, ("2*a*cos(phi/2)", "phi/2")),
        ((-40, 180), {"a"}, ("a*sqrt(2 + 2*cos(phi))", "atan2(a*sin(phi), a + a*cos(phi))")),
        ((-40, 40), set(), ("sqrt(2*a^2 + 2*a^2*cos(phi))", "atan2(a*sin(phi), a + a*cos(phi))")),
        (None, {"a"}, ("a*sqrt(2 + 2*cos(phi))", "atan2(a*sin(phi), a + a*cos(phi))")),
    ],
)
def test_two_equal_arms_halve_their_angle_where_it_is_known_to_be_no_straight_one(
    range_, lengths, expected
):
    x, y = two_equal_arms()
    ranges = {"phi": range_} if range_ else {}
    calls = (Call("hypot", (x, y)), Call("atan2", (y, x)))
    assert tuple(text(book_form(call, lengths, ranges)) for call in calls) == expected


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
    ranges = angle_ranges(compilation.mechanism)
    values = default_values(compilation.solution.balance.plan)
    for definition in where:
        form = book_form(definition.formula, positive, ranges)
        assert Definition(definition.name, form) == definition or math.isclose(
            evaluate(form, values), evaluate(definition.formula, values), rel_tol=1e-9
        )
