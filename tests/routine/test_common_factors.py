"""What products have in common is divided and multiplied once, and nothing else changes."""

import math
import random
from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechc.formula.evaluate import evaluate
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Formula, Symbol, number, power, product, total
from mechc.routine.sharing import share
from mechc.routine.steps import Step

A, B, C, X, Y = map(Symbol, "abcxy")


def over(above: Sequence[Formula], below: Sequence[Formula], by: Fraction | int = 1) -> Formula:
    parts = [(number(by), 1), *((f, 1) for f in above), *((f, -1) for f in below)]
    return product(parts)


def shared(*formulas: Formula) -> tuple[list[str], list[str]]:
    found = share([], formulas, "abcxy")
    steps = [f"{s.name} = {text(s.formula)}" for s in found.steps if isinstance(s, Step)]
    return steps, [text(f) for f in found.formulas]


def test_a_common_divisor_is_divided_by_once() -> None:
    steps, found = shared(over([A], [X, Y]), over([B], [Y, X]))
    assert steps == ["p1 = 1/(x*y)"]
    assert found == ["a*p1", "b*p1"]


def test_the_number_that_most_fractions_have_goes_into_the_reciprocal() -> None:
    half = Fraction(1, 2)
    steps, found = shared(over([A], [X], half), over([B], [X], -half), over([C], [X]))
    assert steps == ["p1 = 1/(2*x)"]
    assert found == ["a*p1", "-b*p1", "2*c*p1"]


@pytest.mark.parametrize("below", [[], [Symbol("x")], [Call("sqrt", (number(2),))]])
def test_what_has_no_divisor_in_common_stays(below: list[Formula]) -> None:
    formulas = [over([A], below), over([B], [Y])]
    assert shared(*formulas) == ([], [text(f) for f in formulas])


def test_divisors_that_are_constant_stay() -> None:
    root = Call("sqrt", (number(2),))
    steps, found = shared(over([A], [root]), over([B], [root]))
    assert (steps, found) == ([], ["a/sqrt(2)", "b/sqrt(2)"])


def test_the_most_frequent_pair_is_multiplied_once() -> None:
    steps, found = shared(over([A, B, X], []), over([A, B, Y], []), over([A, X], []))
    assert steps == ["a_b = a*b"]
    assert found == ["a_b*x", "a_b*y", "a*x"]


def test_the_square_of_a_product_is_that_of_what_it_comes_to() -> None:
    assert shared(power(over([A, B], []), number(2))) == (["a_b = a*b"], ["a_b*a_b"])


PIECES = [A, B, C, X, Y, Call("sin", (X,)), total([A, B]), Call("sqrt", (total([C, Y]),))]


@given(st.randoms(use_true_random=False))
def test_values_stay_and_operations_become_no_more(source: random.Random) -> None:
    def some() -> list[Formula]:
        return source.choices(PIECES, k=source.randint(0, 4))

    formulas = [over(some(), some(), source.choice([1, -1, 2, Fraction(1, 2)])) for _ in range(5)]
    found = share([], formulas, "abcxy")
    values = {name: source.uniform(0.5, 2.0) for name in "abcxy"}
    for step in found.steps:
        assert isinstance(step, Step)
        values[step.name] = evaluate(step.formula, values)
    for before, after in zip(formulas, found.formulas, strict=True):
        assert math.isclose(evaluate(before, values), evaluate(after, values), rel_tol=1e-13)
    steps = sum(count_operations(s.formula) for s in found.steps if isinstance(s, Step))
    assert steps + sum(map(count_operations, found.formulas)) <= sum(
        map(count_operations, formulas)
    )
