"""The names that friction depends on, kind by kind."""

import pytest

from mechc.compilation import Compilation
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Symbol
from mechc.model.mechanism import (
    CollarFriction,
    FaceFriction,
    Friction,
    GuideFriction,
    PinFriction,
    PivotFriction,
    RopeFriction,
    ThreadFriction,
    WheelFriction,
)
from mechc.source import Source
from small_poses import HERE

F, D, P, Q = map(Symbol, "fdpq")


@pytest.mark.parametrize(
    ("joint", "names"),
    [
        (PinFriction("O", "", D, HERE), "d"),
        (GuideFriction("K", F, HERE), "f"),
        (FaceFriction("A", F, HERE), "f"),
        (WheelFriction("gear O, Q", "gear", "O", F, HERE), "f"),
        (ThreadFriction("screw K on OA", "K", F, D, HERE), "fd"),
        (CollarFriction("screw K on OA", "K", F, D, HERE), "fd"),
        (PivotFriction("O", "OA", F, D, P, HERE), "fdp"),
        (RopeFriction("rope A-O-B", "O", 1, F, Q, None, "", HERE), "fq"),
        (RopeFriction("rope A-O-B", "O", 1, F, Q, D, "OA", HERE), "fqd"),
    ],
)
def test_friction_depends_on_coefficients_lengths_and_thrusts(joint, names):
    assert Friction((joint,)).parameters == {*names}


def test_an_efficiency_is_all_that_friction_depends_on():
    assert Friction(efficiency=Symbol("eta")).parameters == {"eta"}
    assert Friction().parameters == set()


COLLAR = """
pivot O
slider K along y
link OA
OA = 50 mm @ 0 deg
screw K pitch 5 mm on OA
torque M on OA
force F at K along -y
friction collar K 0.1 {size}
find k = M/F
"""


@pytest.mark.parametrize(
    ("size", "radius"),
    [
        ("mean 30 mm", 0.015),
        ("outer 40 mm inner 20 mm", 0.015),
        ("outer 40 mm inner 20 mm pressure", (0.04**3 - 0.02**3) / (0.04**2 - 0.02**2) / 3),
    ],
)
def test_a_collar_has_friction_at_its_mean_radius(size, radius):
    source = Source("collar.mech", COLLAR.format(size=size))
    (collar,) = Compilation(source).mechanism.friction.joints
    assert evaluate(collar.radius, {}) == pytest.approx(radius)


def test_the_radius_of_a_new_collar_has_its_outer_diameter_first():
    source = Source("collar.mech", COLLAR.format(size="outer D inner d pressure"))
    given = f"param D = 40 mm\nparam d = 20 mm{source.text}"
    (collar,) = Compilation(Source("collar.mech", given)).mechanism.friction.joints
    assert text(collar.radius) == "(D^2 + D*d + d^2)/(3*(D + d))"
