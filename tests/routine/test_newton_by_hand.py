"""Newton's method for many poses at a time, on one equation."""

import numpy as np
import pytest

from mechc.base.frozen import replace
from mechc.formula.numeric import newton
from mechc.formula.to_text import text
from mechc.formula.tree import Symbol, System, negative, number, product, total
from mechc.routine.newton import eliminate, follow
from mechc.routine.sharing import solver
from mechc.routine.steps import Solver

SOLVER = Solver(("x",), ("p",), (), (-1.0,), (1.0,), -1, (), (), ())
"""The negative root of ``x² = p``, from p = 1 on."""


def root(unknowns, known):
    """Return ``x² - p`` and its slope."""
    (x,), (p,) = unknowns, known
    return np.array([x * x - p]), np.array([[2 * x]])


def test_the_branch_of_the_start_is_followed_to_the_last_digits():
    squares = np.geomspace(1e-2, 25, 97)
    status, (found,) = follow(root, SOLVER, [squares])
    assert not status.any()
    assert found == pytest.approx(-np.sqrt(squares), rel=1e-15, abs=0)


def test_an_angle_known_but_for_turns_is_brought_near_to_its_anchor():
    turning = replace(SOLVER, turning=("p",))
    for angle in (2.0, 0.5):  # ahead of the anchor, and behind it
        turned = np.array([angle, angle + 2 * np.pi, angle - 4 * np.pi])
        status, (found,) = follow(root, turning, [turned])
        assert not status.any()
        assert found == pytest.approx(np.full(3, -np.sqrt(angle)), rel=1e-14, abs=0)


def test_where_the_branch_ends_there_is_no_number():
    status, (found,) = follow(root, SOLVER, [np.array([-1.0, 4.0])])
    assert list(status) == [1.0, 0.0]
    assert np.isnan(found[0])


def test_too_few_corrections_give_no_number(monkeypatch):
    monkeypatch.setattr(newton, "CORRECTIONS", 1)
    status, _ = follow(root, SOLVER, [np.array([9.0])])
    assert list(status) == [2.0]


def test_elimination_gives_the_sign_of_the_determinant():
    matrix = np.array([[[0.0], [2.0]], [[3.0], [1.0]]])
    right = np.array([[4.0], [5.0]])
    assert list(eliminate(matrix, right)) == [-1.0]
    assert right[:, 0] == pytest.approx([1.0, 2.0])


def test_what_changes_on_the_way_need_not_stand_in_the_equations():
    """As with a friction of zero, of which no share is in them."""
    x, t = Symbol("x"), Symbol("t")
    zero = total([product([(x, 2)]), negative(product([(t, 1), (x, 1)])), number(-1)])
    system = System(("x",), (zero,), (("t", 0.0), ("left", 1.0)), (1.0,), by_arcs=True)
    made = solver(system)
    assert made.outer == ("t",)
    assert made.by_arcs.changes == ((0, "t_change"),)
    assert text(made.by_arcs.slopes[0]) == "-t_change*x"
