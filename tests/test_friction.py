"""Friction inside k: the seeds' references, limits, laws."""

import pytest

import mechc
from seed_friction import described, entries

CASES = sorted(entries("friction.json"))


@pytest.mark.parametrize("case", CASES)
def test_seeds(case):
    expected = entries("friction.json")[case]
    found = mechc.loads(described(case), case).evaluate()
    names = ("k_ideal", "k_real", "k_first_order", "k_holding", "eta")
    for name, key in zip(("k", "k_f", "k_f1", "k_hold", "eta_k"), names, strict=True):
        assert found[name] == pytest.approx(expected[key], rel=1e-10), name


@pytest.mark.parametrize("case", CASES)
def test_vanishing_friction_gives_the_ideal_ratio(case):
    found = mechc.loads(described(case, shrunk=1e-9), case).evaluate()
    for name in ("k_f", "k_f1", "k_hold"):
        assert found[name] == pytest.approx(found["k"], rel=1e-7)


@pytest.mark.parametrize("case", CASES)
def test_the_first_order_errs_by_second_order(case):
    """A quarter of the friction leaves a sixteenth of the error."""
    errors = []
    for shrunk in (0.2, 0.05):
        found = mechc.loads(described(case, shrunk), case).evaluate()
        errors.append(found["k_f"] - found["k_f1"])
    assert errors[0] / errors[1] == pytest.approx(16, rel=0.05)


@pytest.mark.parametrize("case", CASES)
def test_both_motions_straddle_the_ideal_ratio(case):
    found = mechc.loads(described(case), case).evaluate()
    assert found["k_hold"] < found["k"] < found["k_f"]
    assert 0 < found["eta_k"] < 1
