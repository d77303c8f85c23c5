"""Curves by hand: where they are broken, zero, or turn, and that nothing leads across a break."""

import math
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

from mechc.base.frozen import replace
from mechc.formula.tree import number
from mechc.model.mechanism import Parameter
from mechc.plot.curves import limits, pieces, smooth
from mechc.plot.dead_centres import _Rest
from mechc.plot.narrowing import with_limits
from mechc.plot.query import _is_round, rows, usual
from mechc.plot.sampling import _touched, traced
from mechc.units import ANGLE, LENGTH
from small_poses import HERE, lever


def whole(function, low, high):
    with np.errstate(all="ignore"):
        trace = traced(function, low, high)
        return smooth(function, trace, *limits([trace]))


def test_zeros_and_poles_of_the_tangent():
    trace = whole(np.tan, -1.0, 7.0)
    assert trace.zeros == pytest.approx([0.0, math.pi, 2 * math.pi], abs=1e-15)
    assert trace.poles == pytest.approx([math.pi / 2, 1.5 * math.pi], rel=1e-15)
    assert (trace.jumps, trace.turns) == ((), ())


@pytest.mark.parametrize("pole", [1.0, 1.25, 1.0 + 1 / 7])
@pytest.mark.parametrize("power", [1, 2, 3])
def test_a_pole_of_any_order_on_a_place_or_beside_one(pole, power):
    trace = whole(lambda x: (x - pole) ** -power, 0.0, 2.0)
    assert trace.poles == pytest.approx([pole], abs=1e-7)
    assert (trace.zeros, trace.jumps, trace.turns) == ((), (), ())
    before, after = ((xs.min(), xs.max()) for xs, _ in pieces(trace))
    assert before[0] == 0.0
    assert after[1] == 2.0
    assert before[1] < pole < after[0]
    assert after[0] - before[1] < 1e-3


@pytest.mark.parametrize("shift", [0.0, 5.0])
def test_a_jump_is_neither_zero_nor_pole(shift):
    """With a change of sign, and without."""
    trace = whole(lambda x: np.where(x < 1 / 3, -1.0, 1.0) + shift, 0.0, 1.0)
    assert trace.jumps == pytest.approx([1 / 3], abs=1e-12)
    assert (trace.zeros, trace.poles) == ((), ())
    assert [set(ys) for _, ys in pieces(trace)] == [{shift - 1}, {shift + 1}]


def still_at_one(function):
    """Return a function at two points, at one of which it has a value of its own, 9."""
    values = with_limits(lambda x: np.where(x == 1.0, 9.0, function(x)), lambda x: x == 1.0, 2.0)
    return values(np.array([0.5, 1.0]))


def test_what_stands_still_for_an_instant_has_the_value_of_its_sides():
    assert still_at_one(lambda x: 3.0 + abs(x - 1.0)) == pytest.approx([3.5, 3.0], rel=1e-12)
    assert still_at_one(lambda x: np.where(x < 1.0, x, np.nan)) == pytest.approx([0.5, 1.0])


def test_what_stands_still_at_a_jump_has_no_value():
    assert np.isnan(still_at_one(lambda x: np.where(x < 1.0, 2.0, 4.0))).tolist() == [False, True]


def test_a_kink_at_a_place_is_an_extremum_although_narrowing_misses_it():
    low, high = np.radians([20.0, 160.0])
    place = np.linspace(low, high, 361)[180]
    for slope in (0.1, 0.3, 1.0, 3.0, 7.0, 10.0):
        (turn,) = whole(lambda x, m=slope: 0.913168 - m * abs(x - place), low, high).turns
        assert turn == pytest.approx((-1, place, 0.913168), rel=1e-12)


SIZES = np.array([32.0, 40.0, 50.0, 63.0, 80.0])


def taken(x):
    """Return the next size; conditions that meet at a size may leave out the size itself."""
    found = SIZES[np.minimum(np.searchsorted(SIZES, x), 4)]
    return np.where(np.abs(x - 50.0) < 1e-12, np.nan, found)


def test_a_staircase_has_jumps_alone_which_stand_upright():
    trace = whole(taken, 30.0, 80.0)
    assert trace.jumps == pytest.approx(SIZES[:-1], abs=1e-6)
    assert (trace.zeros, trace.poles, trace.turns) == ((), (), ())
    parts = list(pieces(trace))
    assert [set(ys) for _, ys in parts] == [{size} for size in SIZES]
    ends = [(before[-1], after[0]) for (before, _), (after, _) in pairwise(parts)]
    assert all(after - before < 1e-5 for before, after in ends)


def test_a_choice_is_neither_least_nor_greatest_where_it_jumps():
    trace = whole(lambda x: np.where(x < 1.0, x, 0.2), 0.0, 2.0)
    assert trace.jumps == pytest.approx([1.0])
    assert (trace.turns, trace.poles) == ((), ())


def test_rounding_next_to_a_jump_is_no_extremum():
    """Next to a branch point values are rounding: the point nearest to it is above the others."""
    jump, nearest = 1.0001, 1.0

    def falling(x):
        return np.where(x < jump, 2 - x + 0.01 * (abs(x - nearest) < 1e-9), -2 + x)

    trace = whole(falling, 0.0, 2.0)
    assert trace.jumps == pytest.approx([jump])
    assert trace.turns == ()


def test_a_stretch_of_zeros_is_no_place():
    trace = whole(lambda x: np.where(x < 1.0, 0.0, np.where(x < 1.3, 3.0, 0.0)), 0.0, 2.0)
    assert trace.jumps == pytest.approx([1.0, 1.3])
    assert (trace.zeros, trace.turns) == ((), ())


def test_a_level_stretch_turns_where_the_curve_goes_back():
    assert whole(lambda x: np.minimum(x, 0.5), 0.0, 1.0).turns == ()
    (top,) = whole(lambda x: np.minimum(np.minimum(x, 0.5), 1.2 - x), 0.0, 1.0).turns
    assert (top.sense, top.y) == (-1, pytest.approx(0.5))


def test_a_curve_runs_to_the_last_place_at_which_it_has_a_value():
    trace = whole(lambda x: np.sqrt(x - 0.3) + np.sqrt(0.7 - x), 0.0, 1.0)
    ((xs, _),) = pieces(trace)
    assert (xs[0], xs[-1]) == pytest.approx((0.3, 0.7), abs=1e-15)


@pytest.mark.parametrize("high", [math.pi / 2, 1.0])
def test_a_pole_at_an_end_leaves_the_rest_to_be_seen(high):
    """At the end of the range, and where the function ends to be."""
    trace = whole(lambda x: x / np.sqrt(np.cos(x * math.pi / 2 / high)), 0.0, math.pi / 2)
    assert trace.poles == pytest.approx([high], abs=1e-12)
    assert limits([trace])[1] < 30


def test_extrema_to_many_digits_smooth_or_with_a_corner():
    found = whole(lambda x: np.sin(x) + 3.0, 0.0, 6.0).turns
    assert [t.sense for t in found] == [-1, 1]
    assert [t.x for t in found] == pytest.approx([math.pi / 2, 1.5 * math.pi], abs=1e-9)
    assert [t.y for t in found] == pytest.approx([4.0, 2.0], abs=1e-15)
    (corner,) = whole(lambda x: np.abs(x - 0.2345) + x / 2, 0.0, 1.0).turns
    assert (corner.x, corner.y) == pytest.approx((0.2345, 0.11725), abs=1e-14)


def test_what_is_constant_but_for_rounding_does_not_turn():
    trace = whole(lambda x: np.sin(x) ** 2 + np.cos(x) ** 2, 0.0, 6.0)
    assert trace.turns == ()


def test_no_line_of_a_smooth_curve_is_off_by_much():
    trace = whole(lambda x: 1 / (1e-3 + x**2), -1.0, 1.0)
    middle = (trace.xs[1:] + trace.xs[:-1]) / 2
    straight = (trace.ys[1:] + trace.ys[:-1]) / 2
    up = np.abs(straight - 1 / (1e-3 + middle**2)) / 1000
    slope = np.diff(trace.ys) / 1000 / (np.diff(trace.xs) / 2)
    assert (up / np.hypot(1, slope)).max() < 5e-4
    assert len(trace.xs) < 1500


def test_near_a_pole_the_rest_is_shown():
    trace = whole(np.tan, 0.0, 3.0)
    low, high = limits([trace])
    assert -10 < low < -1
    assert 1 < high < 10


def test_a_curve_that_ends_at_zero_has_one_there_and_one_that_fades_has_none():
    assert whole(np.sin, 1.0, math.pi).zeros == pytest.approx([math.pi])
    assert whole(np.cos, math.pi / 2, 3.0).zeros == pytest.approx([math.pi / 2])
    assert whole(lambda x: np.exp(-100 * x), 0.0, 1.0).zeros == ()
    assert whole(lambda x: np.exp(-100 * x), -1.0, 0.0).zeros == ()
    assert whole(lambda x: np.exp(100 * x), -1.0, 0.0).zeros == ()


@pytest.mark.parametrize(
    ("step", "unit", "is_round"),
    [
        (30.0, "deg", True),
        (36.0, "deg", False),
        (0.25, "mm", True),
        (0.3, "mm", False),
        (200.0, "mm", True),
        (0.0, "mm", False),
    ],
)
def test_a_step_of_a_table_is_one_that_a_person_takes(step, unit, is_round):
    assert _is_round(step, unit) is is_round


@pytest.mark.parametrize(
    ("low", "high", "unit", "step"),
    [(0, 180, "deg", 20), (2, 40, "deg", 2), (10, 80, "deg", 10), (0.1, 0.3, "m", 0.02)],
)
def test_rows_of_a_table_are_at_round_steps(low, high, unit, step):
    size = {"deg": math.pi / 180, "m": 1.0}[unit]
    ends = tuple(number(Fraction(end) * Fraction(size)) for end in (low, high))
    dimension = ANGLE if unit == "deg" else LENGTH
    varied = Parameter("x", dimension, HERE, None, ends, unit=unit)
    mechanism = replace(lever().mechanism, parameters=(varied,))
    assert (high - low) / (rows("x", mechanism) - 1) == pytest.approx(step)


@pytest.mark.parametrize(("names", "ys"), [("k k_f eta", ("k", "k_f")), ("k k_f1 eta", ("k",))])
def test_a_plot_has_the_first_result_with_friction_if_there_is_one(names, ys):
    """Of what rests on phi, whose range is given; M rests on nothing that has one."""
    varied = Parameter("phi", ANGLE, HERE, number(1), (number(0), number(2)), unit="deg")
    mechanism = replace(lever().mechanism, parameters=(varied,))
    fixed = SimpleNamespace(name="M", inputs=())
    inputs = (SimpleNamespace(name="phi"),)
    varying = [SimpleNamespace(name=name, inputs=inputs) for name in names.split()]
    found = usual(mechanism, SimpleNamespace(functions=(fixed, *varying)))
    assert (found.x, found.ys) == ("phi", ys)
    assert usual(mechanism, SimpleNamespace(functions=(fixed,))) is None


def test_a_pole_with_one_sign_on_both_sides_is_found_between_the_points_beside_its_peak():
    def steep(x):
        return (x - 0.4) ** -2 + 5.0

    with np.errstate(all="ignore"):
        grid = np.linspace(0.0, 1.0, 11) + 0.03
        assert list(_touched(steep, grid, steep(grid))) == pytest.approx([0.4], abs=1e-6)
        assert list(_touched(np.sin, grid * 3, np.sin(grid * 3))) == []


def test_a_dead_centre_is_looked_at_where_it_is_and_on_both_sides():
    rest = _Rest(SimpleNamespace(low=1.0, high=3.0), {}, None, {})
    (x, below, above), (before, behind) = rest._around(2.0)
    assert x == 2.0
    assert (x - below, x - before) == pytest.approx((above - x, behind - x))
    assert 0 < above - x < 1e-3 * (behind - x) < 1e-3
