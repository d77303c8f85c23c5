"""Mechanisms grown at random, through the whole compiler: k against a third method.

The referee judges each of them as well: a compile that disagrees with equilibrium raises.
"""

import pytest

import mechc
from gates import check
from mechanisms import sample


def compiler_against_velocities(seeds):
    errors, conditions = [], []
    for seed in seeds:
        expected = sample(seed)
        found = mechc.loads(expected.text, f"random_{seed}.mech").evaluate()["k"]
        errors.append(abs(float(found) / expected.k - 1))
        conditions.append(expected.condition)
        assert errors[-1] < 1e-6, f"seed {seed}: {found} instead of {expected.k}"
    check(errors, conditions)


def test_random_mechanisms():
    compiler_against_velocities(range(300))


@pytest.mark.slow
def test_thousands_of_random_mechanisms():
    compiler_against_velocities(range(1000, 6000))


@pytest.mark.slow
def test_large_random_mechanisms():
    errors, conditions = [], []
    for seed in range(100):
        expected = sample(seed, groups=8)
        solved = mechc.loads(expected.text, f"large_{seed}.mech")
        errors.append(abs(float(solved.evaluate()["k"]) / expected.k - 1))
        conditions.append(expected.condition)
    check(errors, conditions)
