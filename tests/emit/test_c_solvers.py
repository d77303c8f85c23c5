"""What emitted solvers do before pivoting: eliminate by zeros, begin with known slopes."""

import random

import numpy as np
import pytest

from mechc.emit.c.elimination import reduced
from mechc.emit.c.solvers import opening
from mechc.formula.tree import ZERO, Symbol, System, negative, number, power, product, total
from mechc.routine.sharing import solver
from systems import triad


def sparse(size, chance):
    """Return entries, some of them zero, and a matrix with zeros at the same places."""
    holes = [[chance.random() < 0.45 for _ in range(size)] for _ in range(size)]
    entries = [[ZERO if hole else Symbol("m") for hole in row] for row in holes]
    return entries, np.array([[0.0 if h else chance.uniform(-1, 1) for h in row] for row in holes])


@pytest.mark.parametrize("seed", range(60))
def test_what_is_eliminated_by_zeros_comes_back(seed):
    chance = random.Random(seed)
    size = 2 + seed % 5
    entries, matrix = sparse(size, chance)
    while abs(np.linalg.det(matrix)) < 1e-3:
        entries, matrix = sparse(size, chance)
    residual = [chance.uniform(-1, 1) for _ in range(size)]
    left = reduced(entries)
    space = {"slope": [*map(float, matrix.flat)], "residual": residual}
    inner = np.array([[eval(e, space) for e in row] for row in left.matrix])
    space["right"] = np.linalg.solve(inner, [eval(e, space) for e in left.right])
    change = [eval(e, space) for e in left.change]
    assert change == pytest.approx(np.linalg.solve(matrix, residual), rel=1e-9, abs=1e-12)
    assert np.sign(np.linalg.det(inner)) * left.turn == np.sign(np.linalg.det(matrix))


def test_of_four_unknowns_of_a_triad_two_are_left_to_pivoting():
    assert len(reduced(solver(triad().system()).jacobian).right) == 2


X, P = Symbol("x"), Symbol("p")


@pytest.mark.parametrize(
    ("equation", "known"),
    [
        (total([power(X, number(2)), negative(P)]), True),
        (total([product([(power(X, number(2)), 1), (P, 1)]), number(-1)]), False),
    ],
)
def test_only_slopes_without_outer_symbols_are_known_beforehand(equation, known):
    system = System(("x",), (equation,), (("p", 1.0),), (1.0,))
    assert (opening(solver(system), {"x": "x", "p": "p"}) is not None) == known
