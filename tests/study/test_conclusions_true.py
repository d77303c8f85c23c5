"""What is said to follow from a result, tried out: slopes, trends, zeros, poles and their kinds."""

import math
from random import Random

import numpy as np
import pytest

import reference_geometry
from good_mechanisms import ALL, begun, tree_of
from mechc.formula.evaluate import evaluate
from mechc.formula.walk import symbols
from mechc.model.mechanism import Force
from reference_geometry import assemble_half
from reference_kinematics import Motion

STEP = 1e-6
POSES = 12

every_mechanism = pytest.mark.parametrize("name", ALL)


def results(name):
    """Return the results asked of a mechanism that are not its own definitions."""
    return [r for r in begun(name).results if r.target is not None]


def with_places(name):
    """Return the results that have a zero or a pole at a value of a parameter."""
    found = [r for r in results(name) if not r.where]
    return [r for r in found if any(v.at for v in (*r.zeros, *r.poles))]


def poses(name):
    """Yield poses within the ranges; what has no range stands at its value, or at one."""
    dice = Random(name)
    for _ in range(POSES):
        pose = {}
        for p in begun(name).mechanism.parameters:
            if p.range is not None:
                low, high = (evaluate(end, {}) for end in p.range)
                pose[p.name] = dice.uniform(low, high)
            elif p.value is None:
                pose[p.name] = dice.uniform(0.5, 2)
            elif not p.dependent:
                pose[p.name] = evaluate(p.value, {})
        yield pose


@every_mechanism
def test_derivatives_are_slopes(name):
    """Total ones, through loops that close, stand in test_closed."""
    for result in results(name):
        if result.derivatives and not result.where:
            for pose in list(poses(name))[:3]:
                for symbol, slope in result.derivatives.items():
                    assert_slope(result, pose, symbol, slope)


def assert_slope(result, pose, symbol, slope):
    h = STEP * (1 if abs(pose[symbol]) < 1e-3 else abs(pose[symbol]))
    up, down = (evaluate(result.formula, {**pose, symbol: pose[symbol] + s}) for s in (h, -h))
    size = abs(up) + abs(evaluate(slope, pose) * pose[symbol])
    expected = (up - down) / (2 * h)
    assert evaluate(slope, pose) == pytest.approx(expected, rel=1e-5, abs=1e-8 * size / h * STEP), (
        result.name
    )


@every_mechanism
def test_trends_hold_at_poses_within_the_ranges(name):
    for result in results(name):
        for symbol, trend in (result.trends or {}).items():
            signs = {np.sign(evaluate(result.derivatives[symbol], p)) for p in poses(name)}
            assert trend != "rises" or signs == {1}, result.name
            assert trend != "falls" or signs == {-1}, result.name
            assert trend != "constant" or signs == {0}, result.name


@every_mechanism
def test_zeros_and_poles_are_where_they_are_said_to_be(name):
    for result in with_places(name):
        for side, limits in ((1, result.zeros), (-1, result.poles)):
            for limit in (v for v in limits if v.at is not None):
                assert_order(name, result, limit, side)


def assert_order(name, result, limit, side):
    pose = next(poses(name))
    symbol, value = limit.at
    at = {**pose, symbol: evaluate(value, pose)}
    assert abs(evaluate(limit.factor, at)) < 1e-12
    near = abs(evaluate(result.formula, {**at, symbol: at[symbol] + STEP}))
    nearer = abs(evaluate(result.formula, {**at, symbol: at[symbol] + STEP / 2}))
    order = math.log2(near / nearer) * side
    assert order == pytest.approx(round(order), abs=1e-2), result.name
    assert round(order) >= 1, result.name


@every_mechanism
def test_dead_centres_are_no_loads_across_the_motion(name):
    if not all(p.value is not None for p in begun(name).mechanism.parameters):
        pytest.skip("parameters without values")
    for result in with_places(name):
        if hasattr(result.target, "below"):
            below, above = result.target.below, result.target.above
            for limits, still, moving in (
                (result.zeros, below, above),
                (result.poles, above, below),
            ):
                for limit in limits:
                    if limit.at is not None and limit.cause != "other":
                        assert_kind(name, limit, still, moving)


def assert_kind(name, limit, still, moving):
    loads = {load.name: load for load in begun(name).mechanism.loads}
    pose = next(poses(name))
    symbol, value = limit.at
    at = {**pose, symbol: evaluate(value, pose) + STEP}
    there, here = (tuple(speeds(name, p, loads[still], loads[moving])) for p in (at, pose))
    stands = there[0] / there[1] < 1e-3 * here[0] / here[1]
    assert stands == (limit.cause != "perpendicular load"), limit


def speeds(name, pose, *loads):
    """Return how fast the points (or links) of loads move, whatever their directions."""
    tree = tree_of(name)
    motion = Motion(assemble_half(tree, reference_geometry.defined(tree, pose)))
    assert motion.basis.shape[1] == 1
    for load in loads:
        if isinstance(load, Force):
            yield float(np.hypot(*(motion.velocity(load.point) @ motion.basis)[:, 0]))
        else:
            yield abs(float((motion.turning(load.link) @ motion.basis)[0]))


@every_mechanism
def test_proportions_swaps_and_what_does_not_matter(name):
    pose = next(poses(name))
    for result in results(name):
        if not symbols(result.formula) <= pose.keys():
            continue  # it rests on intermediates
        k = evaluate(result.formula, pose)
        for symbol, power in (result.proportional or {}).items():
            scaled = evaluate(result.formula, {**pose, symbol: 3 * pose[symbol]})
            assert scaled == pytest.approx(3**power * k, rel=1e-9), result.name
        for a, b in result.swaps:
            swapped = evaluate(result.formula, {**pose, a: pose[b], b: pose[a]})
            assert swapped == pytest.approx(k, rel=1e-9), result.name
        assert symbols(result.formula).isdisjoint(result.independent), result.name


def test_of_the_roots_of_a_sine_the_one_within_the_ranges_is_stated():
    """sin(phi + beta), with phi = 60 deg in 5 deg .. 175 deg, is zero at 180 deg - beta."""
    (k, _) = results("crank_slider")
    (zero,) = k.zeros
    assert zero.at is not None
    name, value = zero.at
    assert name == "phi"
    assert evaluate(value, {"beta": math.radians(15)}) == pytest.approx(math.radians(165))
