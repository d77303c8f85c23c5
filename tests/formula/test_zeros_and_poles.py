"""Where formulas vanish, solved for a name: what is nothing has no place of its own."""

import pytest

from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, negative, number, product, total
from mechc.formula.zeros_and_poles import zeros

A, C = Symbol("a"), Symbol("c")
COT = Call("cot", (A,))


@pytest.mark.parametrize(
    ("terms", "found"),
    [
        ([product([(C, 1), (COT, 1)]), product([(Symbol("d"), 1), (COT, 1)])], ["pi/2"]),
        ([COT, negative(C)], ["atan(1/c)"]),
        (
            [product([(C, 1), (total([A, Symbol("b")]), 1)]), product([(C, 1), (negative(A), 1)])],
            [],
        ),
    ],
)
def test_sums_of_functions_of_one_angle(terms, found):
    """(c + d)·cot a is zero at 90°; a + b − a rests on no a."""
    assert [text(solution.value) for solution in zeros(total(terms), "a")] == found


def test_a_bound_is_of_powers_and_its_first_term_is_positive():
    """mu·(4·sin + mu·cos) = 3·cos was solved by atan((-mu*mu + 3)/(4*mu))."""
    mu, sine, cosine = Symbol("mu"), Call("sin", (A,)), Call("cos", (A,))
    inner = total([product([(number(4), 1), (sine, 1)]), product([(mu, 1), (cosine, 1)])])
    whole = total(
        [product([(number(-1), 1), (mu, 1), (inner, 1)]), product([(number(3), 1), (cosine, 1)])]
    )
    assert [text(solution.value) for solution in zeros(whole, "a")] == ["atan((3 - mu^2)/(4*mu))"]


@pytest.mark.parametrize(("times", "found"), [(2, ("b/2", 90)), (-4, ("b/4", 45)), (1, ("b", 180))])
def test_a_multiple_of_an_angle_vanishes_at_its_part_and_as_often(times, found):
    angle = total([product([(number(times), 1), (A, 1)]), negative(Symbol("b"))])
    if times < 0:
        angle = total([Symbol("b"), product([(number(times), 1), (A, 1)])])
    (solution,) = zeros(Call("sin", (angle,)), "a")
    assert (text(solution.value), solution.period) == found
