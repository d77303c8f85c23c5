"""A direction that is a sum of many angles keeps its own name, and its rate."""

import pytest

from good_mechanisms import compiled
from mechc.algebra.angle import Angle
from mechc.formula.to_text import text
from mechc.model.values import completed, defaults

STEP = 1e-6


def values_at(pose, phi):
    return completed({**defaults(pose.mechanism), "phi": phi}, pose.definitions)


def test_a_direction_of_many_angles_keeps_its_name():
    """Jansen's leg: ZC is turned from AB by three angles."""
    pose = compiled("jansen_leg").pose
    assert text(dict(pose.definitions)["phi_ZC"]) == "phi_AB - gamma_B - mu_B - mu_C + pi"
    (arm,) = pose.vector("ZBC", "Z", "C")
    assert arm.angle == Angle.of("phi_ZC")


def test_it_turns_with_the_angles_that_it_is_made_of():
    pose = compiled("jansen_leg").pose
    before, after = (values_at(pose, 1.0 + side * STEP)["phi_ZC"] for side in (-1, 1))
    slope = pose.rates["phi_ZC"].evaluate(values_at(pose, 1.0))
    assert slope == pytest.approx((after - before) / (2 * STEP), rel=1e-6)


def test_the_loop_that_gives_it_says_so():
    (triangle,) = (s for s in compiled("jansen_leg").pose.solved if "phi_AB" in s.names)
    assert triangle.names[-1] == "phi_ZC"
