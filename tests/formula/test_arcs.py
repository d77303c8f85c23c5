"""Branches by their arc length: solved at the end of the way, or behind a fold that was found."""

import math

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
from mechc.formula.numeric.arcs import Arcs
from mechc.formula.numeric.newton import Way


@pytest.mark.parametrize("name", CURVES)
def test_an_end_is_a_fold_that_was_found(name):
    along, expected = CURVES[name]
    status, found = Arcs(of_one(along)).follow([begun(along)])
    assert status == expected
    if status == 0:
        assert along(found[0]) == pytest.approx(1.0, abs=1e-10)


def test_no_fold_is_found_in_too_few_points(monkeypatch):
    monkeypatch.setattr("mechc.formula.numeric.arcs.MOST_POINTS", 3)
    assert Arcs(of_one(wave(0.7))).follow([0.0]) == (2, ())


def test_a_branch_that_others_cross_goes_on_though_the_determinant_changes_its_sign():
    status, found = Arcs(crossing).follow([0.0, 0.0])
    assert status == 0
    assert found == pytest.approx((1.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("lines", NEARLY_CROSSING)
def test_no_arc_leads_across_to_a_branch_that_comes_near(lines):
    status, found = Arcs(nearly_crossing(*lines)).follow([upper(*lines, 0.0)])
    assert (status, *found) == (0, pytest.approx(upper(*lines, 1.0), abs=1e-12))


@pytest.mark.parametrize("bend", BENDS)
def test_no_arc_ends_behind_the_way(bend):
    status, found = Arcs(bent(*bend)).follow([0.0])
    assert (status, *found) == (0, pytest.approx(bent_end(*bend), abs=1e-12))


def test_a_fold_that_is_made_by_what_is_rounded_off_is_none():
    size = math.hypot(0.03, 1.0)
    status, found = Arcs(own_friction).follow([0.03 / size, 1.0 / size])
    assert status == 0
    assert found == pytest.approx((0.0, 1.0), abs=1e-12)


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
