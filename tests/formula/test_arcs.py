"""Branches by their arc length: solved at the end of the way, or behind a fold that was found."""

import math

import numpy as np
import pytest

from mechc.formula import arcs
from mechc.formula.arcs import Arcs
from mechc.formula.newton import Way
from mechc.routine import arcs as for_arrays
from mechc.routine.newton import follow
from mechc.routine.steps import NO_ARCS, Solver


def curve(x, at, along):
    """Return ``t = along(x)`` as one equation: where its slope is zero the curve turns back."""
    step = 1e-6
    slope = (along(x + step) - along(x - step)) / (2 * step)
    return along(x) - at, slope


def of_many(sides):
    """Return the sides of one pose for many."""

    def arrays(_, unknowns, share):
        residuals, matrix = sides(unknowns, share)
        rows = [[np.broadcast_to(m, share.shape) for m in row] for row in matrix]
        return np.array(residuals), np.array(rows)

    return arrays


def of_one(along):
    """Return the sides of ``along(x) = t``."""

    def sides(unknowns, share):
        residual, slope = curve(unknowns[0], share, along)
        return [residual], [[slope, -1.0]]

    return sides


def wave(height):
    """Rise to a hill of a height, fall into a valley, and rise to all heights; from 0 on."""
    return lambda x: height * (6.75 * x * (1 - x) ** 2)


def layer(width):
    """Turn from one straight line to another that is fifty times as steep, within a width."""
    return lambda x: x - 0.98 * (np.sqrt((x - 0.5) ** 2 + width**2) + (x - 0.5)) / 2


def begun(along):
    """Return where a curve begins, near 0."""
    x = 0.0
    for _ in range(5):
        residual, slope = curve(x, 0.0, along)
        x -= float(residual / slope)
    return x


CURVES = {
    "hill below the end": (wave(0.7), 1),
    "hill just below the end": (wave(1 - 1e-6), 1),
    "hill above the end": (wave(1.3), 0),
    "sharp hill": (lambda x: 0.4 - np.sqrt((x - 0.4) ** 2 + 1e-12), 1),
    "corner, where no tangent goes on": (lambda x: 0.4 - abs(x - 0.4), 2),
    "flat": (layer(1e-4), 0),
    "no more": (lambda x: np.where(x < 0.6, x, np.nan), 2),
    "gap": (lambda x: x + (x > 0.5), 2),
}


@pytest.mark.parametrize("name", CURVES)
def test_an_end_is_a_fold_that_was_found(name):
    along, expected = CURVES[name]
    start = begun(along)
    status, found = Arcs(of_one(along)).follow([start])
    assert status == expected
    if status == 0:
        assert along(found[0]) == pytest.approx(1.0, abs=1e-10)
    many, unknowns = for_arrays.follow(of_many(of_one(along)), np.full((1, 3), start))
    assert list(many) == [expected] * 3
    if status == 0:
        assert unknowns[0] == pytest.approx([found[0]] * 3, rel=1e-12)


def test_no_fold_is_found_in_too_few_points(monkeypatch):
    monkeypatch.setattr(arcs, "POINTS", 3)
    along, start = wave(0.7), 0.0
    assert Arcs(of_one(along)).follow([start]) == (2, ())
    many, _ = for_arrays.follow(of_many(of_one(along)), np.full((1, 1), start))
    assert list(many) == [2]


def crossing(unknowns, share):
    """The sides of y·(t - 1/2 - y²) = 0, x = t: three branches cross at t = 1/2, y = 0."""
    x, y = unknowns
    rest = share - 0.5
    return [x - share, y * (rest - y * y)], [[1.0, 0.0, -1.0], [0.0, rest - 3 * y * y, y]]


def test_a_branch_that_others_cross_goes_on_though_the_determinant_changes_its_sign():
    status, found = Arcs(crossing).follow([0.0, 0.0])
    assert status == 0
    assert found == pytest.approx((1.0, 0.0), abs=1e-12)
    many, unknowns = for_arrays.follow(of_many(crossing), np.zeros((2, 3)))
    assert list(many) == [0.0] * 3
    assert unknowns == pytest.approx(np.array([[1.0] * 3, [0.0] * 3]), abs=1e-12)


@pytest.mark.parametrize(("slope", "bend"), [(0.365, 0.25), (0.065, 0.5), (0.4, 0.5), (0.715, 1)])
def test_no_arc_ends_behind_the_way(slope, bend):
    """The share grows ever faster along t = b x + c x²: square to a tangent it is past the end."""

    def bent(x, t):
        return [slope * x[0] + bend * x[0] * x[0] - t], [[slope + 2 * bend * x[0], -1.0]]

    end = (math.sqrt(slope * slope + 4 * bend) - slope) / (2 * bend)
    status, found = Arcs(bent).follow([0.0])
    assert (status, *found) == (0, pytest.approx(end, abs=1e-12))
    statuses, many = for_arrays.follow(of_many(bent), np.zeros((1, 2)))
    assert list(statuses) == [0.0] * 2
    assert many == pytest.approx(np.array([[end] * 2]), abs=1e-12)


def own_friction(unknowns, share):
    """The sides of a force x that its own friction alone makes, of the load q, on a circle.

    With all of the share x = |1.5 x|, so that x = 0 is the solution. What is rounded off makes a
    fold where q = 0, at t = 2/3.
    """
    x, q = unknowns
    force, left = 1.5 * share * x, 0.03 * (1.0 - share)
    size = np.sqrt(force * force + left * left * q * q + 1e-60)
    by_share = (0.03 * left * q * q - 1.5 * x * force) / size
    slopes = [1.0 - 1.5 * share * force / size, -left * left * q / size, by_share]
    return [x - size, x * x + q * q - 1.0], [slopes, [2 * x, 2 * q, 0.0]]


def test_a_fold_that_is_made_by_what_is_rounded_off_is_none():
    start = np.array([0.03, 1.0]) / np.hypot(0.03, 1.0)
    status, found = Arcs(own_friction).follow(list(start))
    assert status == 0
    assert found == pytest.approx((0.0, 1.0), abs=1e-12)
    statuses, unknowns = for_arrays.follow(of_many(own_friction), np.array([start] * 2).T)
    assert list(statuses) == [0.0] * 2
    assert unknowns == pytest.approx(np.array([[0.0] * 2, [1.0] * 2]), abs=1e-12)


def steep(unknowns, outer):
    """The sides of ``x - 2 e x³ = p`` with a fold at x² = 1/(6 e), and a kink of another slope."""
    (x,), (p, e) = unknowns, outer
    return [x - 2 * e * x**3 - p], [[1 - 6 * e * x * x]]


def steep_along(unknowns, outer, changes):
    """The same with the slope by the share of a way on which p and e change."""
    residuals, ((slope,),) = steep(unknowns, outer)
    return residuals, [[slope, -2 * unknowns[0] ** 3 * changes[1] - changes[0]]]


@pytest.mark.parametrize(("p", "expected"), [(0.3, 0), (0.54, 0), (0.55, 1), (3.0, 1)])
def test_a_way_by_arcs_says_that_it_ends_behind_a_fold(p, expected):
    """The fold is at p = 2/3 · sqrt(1/6 e) = 0.5443 for e = 1/4."""
    way = Way(steep, 1, [1.0], along=steep_along)
    status, found = way.follow([0.0, 0.25], [0.0], [p, 0.25])
    assert status == expected
    if status == 0:
        assert steep(found, [p, 0.25])[0][0] == pytest.approx(0.0, abs=1e-12)


def ending(unknowns, outer):
    """The sides of ``x = sqrt(1 - p)``: no number at p > 1, and no fold either."""
    (x,), (p,) = unknowns, outer
    root = math.sqrt(1 - p) if p <= 1 else math.nan
    return [x - root], [[1.0]]


def ending_along(unknowns, outer, changes):
    (p,), (change,) = outer, changes
    by_share = change / (2 * math.sqrt(1 - p)) if p < 1 else math.nan
    return ending(unknowns, outer)[0], [[1.0, by_share]]


def test_a_way_by_arcs_concludes_nothing_from_short_steps():
    """Steps become short before there is no number, and so they do before a fold."""
    status, _ = Way(ending, 1, [1.0]).follow([0.0], [1.0], [1.5])
    assert status == 1
    status, _ = Way(ending, 1, [1.0], along=ending_along).follow([0.0], [1.0], [1.5])
    assert status == 2


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
