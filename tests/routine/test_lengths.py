"""Lengths of vectors as roots of their squares, and what needs no root at all."""

from collections.abc import Sequence

import pytest

from mechc.formula.to_text import text
from mechc.formula.tree import Call, Formula, Power, Symbol, negative, number, product, total
from mechc.routine.lengths import fresh, size, sizes, squaring, unsigned, with_roots

A, B, L, U, X, Y = map(Symbol, "abluxy")
TWO = number(2)


def length(*parts: Formula) -> Formula:
    return Call("hypot", parts)


def times(count: int, formula: Formula) -> Formula:
    return product([(number(count), 1), (formula, 1)])


def written(
    definitions: Sequence[tuple[str, Formula]], *formulas: Formula
) -> tuple[list[str], list[str]]:
    named, results = with_roots(definitions, formulas, {"l", "x", "y"})
    return [f"{name} = {text(f)}" for name, f in named], list(map(text, results))


def test_a_length_is_the_root_of_the_squares_of_its_components() -> None:
    assert written([("l", length(X, Y))], L) == (["l = sqrt(x^2 + y^2)"], ["l"])
    assert written([], length(negative(X), Y)) == ([], ["sqrt(x^2 + y^2)"])
    assert written([], times(3, length(X, Y))) == ([], ["3*sqrt(x^2 + y^2)"])


def test_a_square_that_is_asked_for_is_defined_before_its_root() -> None:
    known = ["l_squared = x^2 + y^2", "l = sqrt(l_squared)"]
    assert written([("l", length(X, Y))], Power(L, TWO)) == (known, ["l_squared"])
    later = [("l", length(X, Y)), ("u", total([Power(L, TWO), X]))]
    assert written(later, U) == ([*known, "u = l_squared + x"], ["u"])


def test_the_square_of_what_is_no_length_stays() -> None:
    assert written([("u", X)], Power(U, TWO)) == (["u = x"], ["u^2"])


@pytest.mark.parametrize(
    ("one", "other", "known"),
    [
        (total([U, L]), total([U, negative(L)]), "u^2 - l^2"),
        (total([L, U]), total([L, negative(U)]), "l^2 - u^2"),
        (total([L, U]), total([U, L]), "(l + u)*(u + l)"),
        (total([X, U]), total([X, negative(U)]), "(x + u)*(x - u)"),
        (total([L, U]), total([L, negative(X)]), "(l + u)*(l - x)"),
        (total([X, U, L]), total([X, U, negative(L)]), "(x + u)^2 - l^2"),
    ],
)
def test_a_difference_of_squares_needs_no_root(one: Formula, other: Formula, known: str) -> None:
    assert text(squaring({"l"})(product([(one, 1), (other, 1)]))) == known


def test_lengths_are_known_by_their_components_whatever_their_signs() -> None:
    found = sizes([("l", length(negative(X), Y)), ("u", X)])
    assert found == {frozenset({X, Y}): "l"}
    assert [unsigned(f) for f in (X, negative(X))] == [X, X]


def test_a_length_that_is_a_product_has_no_root() -> None:
    root = size(times(3, A), times(4, A))
    assert root is not None
    assert text(root) == "5*abs(a)"
    root = size(times(3, A), times(-4, A), {"a"})
    assert root is not None
    assert text(root) == "5*a"
    assert size(A, A) is None
    assert size(A, B) is None


def test_a_new_name_is_free() -> None:
    taken = {"q", "q_"}
    assert [fresh("q", taken), fresh("p", taken), fresh("p", taken)] == ["q__", "p", "p_"]
