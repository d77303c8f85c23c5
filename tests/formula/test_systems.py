"""Unknowns of systems: the branch that is meant, to the last digits, or no number."""

import math
import random
from fractions import Fraction

import numpy as np
import pytest

from mechc.formula.derivative import derivative
from mechc.formula.evaluate import evaluate, solution, solver, status, status_along
from mechc.formula.numeric.continuation import _Continuation, continued
from mechc.formula.numeric.elimination import eliminate, quick
from mechc.formula.numeric.newton import Way
from mechc.formula.to_sympy import to_sympy
from mechc.formula.to_text import text
from mechc.formula.tree import (
    Call,
    Implicit,
    Number,
    Power,
    Product,
    Symbol,
    System,
    implicit,
    negative,
    number,
    power,
    product,
    total,
)
from mechc.formula.walk import Substitution, substitute, symbols
from mechc.model.values import completed
from mechc.work import MOST_WORK, Allowance, at_most
from systems import Triad, s, triad

ROOT = System(
    ("x",), (total([power(s("x"), number(2)), negative(s("p"))]),), (("p", 1.0),), (-1.0,)
)

LOOP = System(
    ("x",),
    (total([power(s("x"), number(2)), negative(Call("cos", (s("p"),)))]),),
    (("p", -0.1),),
    (-1.0,),
    turning=("p",),
)
"""x² = cos p, where p is known but for whole turns; on a whole one the branch ends."""


def by_small_steps(triad: Triad, phi: float, steps: int = 2000) -> list[float] | None:
    """Return the unknowns by Newton's method in steps so small that no branch is left.

    The Jacobian is by differences: nothing of the compiler is used. None where a
    determinant vanishes on the way.
    """
    found, first = np.array(triad.start), triad.values["phi"]
    sides = set[float]()
    for k in range(steps + 1):
        here = first + (phi - first) * k / steps
        for _ in range(4):
            matrix = np.array(
                [
                    (
                        np.array(triad.residuals(found + h, phi=here))
                        - triad.residuals(found - h, phi=here)
                    )
                    / 2e-6
                    for h in 1e-6 * np.eye(4)
                ]
            ).T
            move = np.linalg.solve(matrix, triad.residuals(found, phi=here))
            found = found - move
            if abs(move).max() > 0.05:
                return None
        sides.add(np.sign(np.linalg.det(matrix)))
        if len(sides) > 1:
            return None
    return list(found)


@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(1, 6))]
)
def test_a_triad_keeps_its_branch(seed: int) -> None:
    made = triad(seed)
    for turn in (-0.9, 0.05, 0.7):
        phi = made.values["phi"] + turn
        found = solution(made.system(), tuple((made.values | {"phi": phi}).values()))
        slow = by_small_steps(made, phi)
        if slow is None:
            assert all(map(math.isnan, found))
        else:
            assert found == pytest.approx(slow, abs=1e-9)
            assert max(map(abs, made.residuals(found, phi=phi))) < 1e-14


@pytest.mark.parametrize("seed", range(6))
def test_continuation_comes_to_the_solutions_of_whole_ways_in_any_order(seed: int) -> None:
    made, chance = triad(seed), random.Random(seed)
    turns = [chance.uniform(-4, 4) for _ in range(24)] + [0.0, 1 / 32, -1 / 32, 9.0, math.nan]
    places = [tuple((made.values | {"phi": made.values["phi"] + t}).values()) for t in turns]
    one, other = (continued(made.system()) for _ in range(2))
    one(places[0]), other(places[0])
    found = [one(place) for place in places]
    assert repr(found[::-1]) == repr([other(place) for place in places[::-1]])
    whole = [solution(made.system(), place) for place in places]
    for near, far, turn in zip(found, whole, turns, strict=True):
        assert near == pytest.approx(far, rel=0, abs=1e-11, nan_ok=True), turn
    assert sum(not math.isnan(values[0]) for values in found) > 3


@pytest.mark.parametrize(("turn", "is_near"), [(0.1, True), (-0.4, True), (9.0, False)])
def test_near_the_anchor_the_rungs_of_a_ladder_lead_on(turn: float, is_near: bool) -> None:
    """Beyond them each place has a way of its own, which takes many times as long."""
    made, whole_ways = triad(0), []
    ladder = _Continuation(made.system())
    directly = ladder._directly
    ladder._directly = lambda outer: whole_ways.append(outer) or directly(outer)
    places = [tuple((made.values | {"phi": made.values["phi"] + t}).values()) for t in (0.02, turn)]
    for place in places:
        ladder.at(place)
    assert whole_ways == (places[:1] if is_near else places)


def test_a_branch_ends_where_its_roots_meet() -> None:
    x = implicit(ROOT, 0)
    for p in (1e-6, 0.3, 1.0, 4.0, 20.0):
        assert evaluate(x, {"p": p}) == pytest.approx(-math.sqrt(p), rel=4e-16, abs=1e-18)
    for p in (-1e-6, -1.0, 1e4, math.inf, math.nan):
        assert math.isnan(evaluate(x, {"p": p}))


def test_the_status_says_why() -> None:
    def circle(x: list[float], p: list[float]) -> tuple[list[float], list[list[float]]]:
        return [x[0] * x[0] - p[0]], [[2 * x[0]]]

    way = Way(circle, 1, [1.0])
    assert way.follow([1.0], [1.0], [9.0]) == (0, (3.0,))
    assert way.follow([1.0], [1.0], [-1.0])[0] == 1
    assert Way(circle, 0, [1.0]).follow([0.0], [0.0], [1.0])[0] == 1
    assert way.follow([1.0], [1.0], [4000.0])[0] == 2
    assert way.follow([1.0], [1.0], [math.nan])[0] == 2


def test_a_status_of_many_values_is_that_of_each() -> None:
    root = Implicit(ROOT, 0, (product([(s("a"), 1), (s("b"), -1)]),))
    along = status_along(root)
    for a, b in ((2.0, 1.0), (-2.0, 1.0), (1e9, 1.0), (1.0, 0.0), (-1e-3, 1.0)):
        assert along({"a": a, "b": b, "c": 1.0}) == status(root, {"a": a, "b": b})
    assert {along({"a": a, "b": 1.0}) for a in (2.0, -2.0, 1e9)} == {0, 1, 2}


def test_small_whole_numbers_are_equal_to_those_that_are_made() -> None:
    for value in (-100, -1, 0, 1, 7, 100):
        assert number(value) == number(Fraction(value)) == Number(Fraction(value))
    half = product([(number(2), 1), (number(4), -1), (s("a"), 1)])
    assert half == Product((Number(Fraction(1, 2)), s("a")))
    assert product([(number(2), 1), (number(2), -1), (s("a"), 1)]) == s("a")
    assert product([(s("a"), 0)]) == number(1)
    assert product([(s("a"), 1), (number(0), 1)]) == number(0)


def test_elimination_states_the_determinants_sign() -> None:
    for rows, sign in (([[0.0, 1.0], [1.0, 0.0]], -1), ([[2.0, 1.0], [1.0, 3.0]], 1)):
        right = [5.0, 10.0]
        expected = np.linalg.solve(np.array(rows), right)
        assert eliminate([list(row) for row in rows], right) == sign
        assert right == pytest.approx(list(expected))
    assert eliminate([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]) == 0
    assert eliminate([[math.nan]], [1.0]) == 0


@pytest.mark.parametrize("size", [1, 2, 3, 5, 8, 9])
def test_elimination_written_out_has_the_bits_of_that_in_loops(size: int) -> None:
    chance = random.Random(size)
    for round_ in range(40):
        digits = 0 if round_ % 4 == 0 else 17  # whole numbers: equal pivots, nothing to take off
        numbers = [round(chance.uniform(-2, 2), digits) for _ in range(size * (size + 1))]
        rows = [numbers[i * size : (i + 1) * size] for i in range(size)]
        one, other = numbers[-size:], numbers[-size:]
        sign = eliminate([list(row) for row in rows], one)
        assert quick(size)([list(row) for row in rows], other) == sign
        assert not sign or repr(other) == repr(one)
    assert quick(size)([[math.nan] * size] * size, [1.0] * size) == 0


# ------------------------------------------------------------------------- as formulas


def test_only_outer_symbols_are_open() -> None:
    x = implicit(ROOT, 0)
    assert symbols(x) == {"p"}
    assert text(x) == "solution of (x^2 - p = 0) for x"
    assert text(product([(number(2), 1), (x, 1)])) == "2*(solution of (x^2 - p = 0) for x)"


PAIR = System(
    ("x", "y"),
    (
        total([s("x"), s("y"), negative(s("p"))]),
        total([s("x"), negative(s("y")), negative(s("q"))]),
    ),
    (("p", 1.0), ("q", 0.0)),
    (0.5, 0.5),
)


def test_unknowns_share_their_arguments_when_something_is_put_in() -> None:
    outer = (product([(s("r"), 2)]), total([s("r"), s("t")]))
    substitution = Substitution({"r": s("u")})
    x, y = (substitution.of(Implicit(PAIR, i, outer)) for i in (0, 1))
    assert isinstance(x, Implicit)
    assert isinstance(y, Implicit)
    assert x.arguments is y.arguments
    assert symbols(x, y) == symbols(x) | symbols(y) == {"u", "t"}


def test_unknowns_of_one_system_differ_by_their_arguments() -> None:
    x, there = Implicit(PAIR, 0, (s("r"), s("t"))), Implicit(PAIR, 0, (s("t"), s("r")))
    assert len({x, there, Implicit(PAIR, 1, x.arguments), Implicit(PAIR, 0, (s("r"), s("t")))}) == 3
    values = completed({"r": 3.0, "t": 1.0}, [("x", x), ("z", there)])
    assert (values["x"], values["z"]) == pytest.approx((2.0, 2.0))
    assert "x" not in completed({"r": 3.0}, [("x", x)])


def test_what_is_put_in_is_solved_for() -> None:
    square = product([(s("q"), 2)])
    x = substitute(implicit(ROOT, 0), {"p": square, "x": number(7)})
    assert isinstance(x, Implicit)
    assert text(x) == "solution of (x^2 - q^2 = 0) for x"
    assert evaluate(x, {"q": 3.0}) == pytest.approx(-3.0)


def test_sympy_solves_to_any_precision() -> None:
    sympy = pytest.importorskip("sympy")
    x = to_sympy(implicit(ROOT, 0))
    assert x.free_symbols == {sympy.Symbol("p")}
    exact = -sympy.sqrt(2).evalf(40)
    assert abs(x.subs({sympy.Symbol("p"): 2}).evalf(40) - exact) < sympy.Float("1e-38")


# ------------------------------------------------------------------------- derivatives

X, Y = Symbol("x"), Symbol("y")
TRIGONOMETRIC = ("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos")
FORMULAS = [
    *(Call(f, (product([(X, 1), (Y, 1)]),)) for f in TRIGONOMETRIC),
    *(Call(f, (total([X, power(Y, number(2))]),)) for f in ("atan", "sqrt", "abs", "exp", "log")),
    Call("abs", (total([X, negative(Y), number(-1)]),)),
    *(Call(f, (power(X, number(2)), product([(X, 1), (Y, 1)]))) for f in ("atan2", "min", "max")),
    Call("hypot", (X, power(X, number(3)), Y)),
    Call("max", (X, Y, product([(X, 3)]))),
    Power(X, product([(X, 1), (Y, 1)])),
    product([(X, -2), (total([X, Y]), 3), (Call("sin", (X,)), 1)]),
    power(X, number(-1)),
    Y,
]


@pytest.mark.parametrize("formula", FORMULAS, ids=text)
def test_a_derivative_is_the_limit_of_differences(formula: Symbol) -> None:
    at, step = {"x": 0.7, "y": 0.45}, 1e-5
    ends = [evaluate(formula, at | {"x": at["x"] + h}) for h in (step, -step)]
    slope = evaluate(derivative(formula, "x"), at)
    assert slope == pytest.approx((ends[0] - ends[1]) / (2 * step), rel=1e-8, abs=1e-9)


def test_a_solution_has_no_formula_for_its_slope() -> None:
    assert derivative(implicit(ROOT, 0), "x") == number(0)
    with pytest.raises(ValueError, match="no formula"):
        derivative(implicit(ROOT, 0), "p")


@pytest.mark.parametrize("p", [0.2, 0.2 + math.tau, 0.2 - math.tau, 0.2 + 2 * math.tau])
def test_what_is_known_but_for_turns_comes_the_shortest_way(p: float) -> None:
    expected = pytest.approx(-math.sqrt(math.cos(0.2)), rel=1e-14)
    assert solution(LOOP, (p,))[0] == expected
    assert status(implicit(LOOP, 0), {"p": p}) == 0
    following = continued(LOOP)
    assert [following(values)[0] for values in [(p,)] * 3] == [expected] * 3
    whole = System(LOOP.unknowns, LOOP.equations, LOOP.anchor, LOOP.start)
    assert (status(implicit(whole, 0), {"p": p}) == 0) == (p == 0.2)


def test_a_system_costs_its_work_whenever_it_is_asked():
    """What is kept counts, too: the allowance of a compilation does not rest on those before."""
    find = solver(System(("x",), ROOT.equations, (("p", 1.0),), (-1.0,)))
    costs = []
    for value in (4.0, 4.0, 5.0):
        with at_most(Allowance()) as allowance:
            assert find((value,)) == (pytest.approx(-math.sqrt(value)),)
        costs.append(MOST_WORK - allowance.left)
    assert costs[0] == costs[1] > 0
    assert 0 < costs[2] < 1000
