"""Branches by their arc length on arrays: each of many ends as the interpreter has it."""

import math

import numpy as np
import pytest

from branches_by_arcs import (
    BENDS,
    CURVES,
    NEARLY_CROSSING,
    begun,
    bent,
    bent_end,
    crossing,
    nearly_crossing,
    of_one,
    own_friction,
    steep,
    steep_along,
    upper,
    wave,
)
from mechc.formula.numeric.newton import Way
from mechc.routine.arcs import follow as follow_arcs
from mechc.routine.newton import follow
from mechc.routine.steps import NO_ARCS, Solver


def of_many(sides):
    """Return the sides of one pose for many."""

    def arrays(_, unknowns, share):
        residuals, matrix = sides(unknowns, share)
        rows = [[np.broadcast_to(m, share.shape) for m in row] for row in matrix]
        return np.array(residuals), np.array(rows)

    return arrays


@pytest.mark.parametrize("name", CURVES)
def test_an_end_is_a_fold_that_was_found(name):
    along, expected = CURVES[name]
    many, (found,) = follow_arcs(of_many(of_one(along)), np.full((1, 3), begun(along)))
    assert list(many) == [expected] * 3
    if expected == 0:
        assert along(found) == pytest.approx([1.0] * 3, abs=1e-10)


def test_no_fold_is_found_in_too_few_points(monkeypatch):
    monkeypatch.setattr("mechc.formula.numeric.arcs.MOST_POINTS", 3)
    many, _ = follow_arcs(of_many(of_one(wave(0.7))), np.zeros((1, 1)))
    assert list(many) == [2]


def test_a_branch_that_others_cross_goes_on_though_the_determinant_changes_its_sign():
    many, unknowns = follow_arcs(of_many(crossing), np.zeros((2, 3)))
    assert list(many) == [0.0] * 3
    assert unknowns == pytest.approx(np.array([[1.0] * 3, [0.0] * 3]), abs=1e-12)


@pytest.mark.parametrize("lines", NEARLY_CROSSING)
def test_no_arc_leads_across_to_a_branch_that_comes_near(lines):
    start = np.full((1, 2), upper(*lines, 0.0))
    statuses, many = follow_arcs(of_many(nearly_crossing(*lines)), start)
    assert list(statuses) == [0.0] * 2
    assert many == pytest.approx(np.full((1, 2), upper(*lines, 1.0)), abs=1e-12)


@pytest.mark.parametrize("bend", BENDS)
def test_no_arc_ends_behind_the_way(bend):
    statuses, many = follow_arcs(of_many(bent(*bend)), np.zeros((1, 2)))
    assert list(statuses) == [0.0] * 2
    assert many == pytest.approx(np.array([[bent_end(*bend)] * 2]), abs=1e-12)


def test_a_fold_that_is_made_by_what_is_rounded_off_is_none():
    start = np.array([0.03, 1.0]) / np.hypot(0.03, 1.0)
    statuses, unknowns = follow_arcs(of_many(own_friction), np.array([start] * 2).T)
    assert list(statuses) == [0.0] * 2
    assert unknowns == pytest.approx(np.array([[0.0] * 2, [1.0] * 2]), abs=1e-12)


def test_many_ways_by_arcs_end_as_each_does():
    solver = Solver(("x",), ("p", "e"), (), (0.0,), (0.0, None), 1, (), (), (), NO_ARCS)

    def sides(unknowns, known, changes=None):
        found = steep(unknowns, known) if changes is None else steep_along(unknowns, known, changes)
        return np.array(found[0]), np.array(found[1])

    p = np.linspace(-0.8, 0.8, 33)
    status, (found,) = follow(sides, solver, [p, np.array(0.25)])
    way = Way(steep, 1, [1.0], along=steep_along)
    each = [way.follow([0.0, 0.25], [0.0], [x, 0.25]) for x in p]
    assert list(status) == [s for s, _ in each]
    assert {0.0, 1.0} == set(status)
    for x, (end, at) in zip(found, each, strict=True):
        assert x == pytest.approx(
            at[0] if end == 0 else math.nan, rel=1e-12, abs=1e-15, nan_ok=True
        )
