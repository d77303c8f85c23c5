"""Mechanisms grown at random, through the whole compiler: k against a third method.

The referee judges each of them as well: a compile that disagrees with equilibrium raises.
"""

import pytest

import mechc
from gates import check
from mechanisms import sample
from mechc.compilation import Compilation
from mechc.source import Source


def found_at_default(text, name):
    """Return k at the default pose, after the referee has looked at it."""
    verdict = Compilation(Source(name, text)).verdict
    assert len(verdict.trials) == 4, verdict.remarks
    return verdict.trials[0].power


def compiler_against_velocities(seeds, groups=None):
    errors, conditions = [], []
    for seed in seeds:
        expected = sample(seed, groups)
        found = found_at_default(expected.text, f"random_{seed}.mech")
        errors.append(abs(found / expected.k - 1))
        conditions.append(expected.condition)
        assert errors[-1] < 1e-6, f"seed {seed}: {found} instead of {expected.k}"
    check(errors, conditions)


@pytest.mark.parametrize("part", range(2))
def test_random_mechanisms(part):
    compiler_against_velocities(range(part, 60, 2))


def test_random_mechanisms_through_the_front_of_the_library():
    for seed in range(1000, 1020):
        expected = sample(seed)
        found = mechc.loads(expected.text, f"random_{seed}.mech").evaluate()["k"]
        assert float(found) == pytest.approx(expected.k, rel=1e-9)


@pytest.mark.slow
def test_hundreds_of_random_mechanisms():
    compiler_against_velocities(range(60, 200))


@pytest.mark.slow
def test_large_random_mechanisms():
    compiler_against_velocities(range(20), groups=8)
