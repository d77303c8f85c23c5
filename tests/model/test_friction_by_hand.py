"""The names that friction depends on, kind by kind."""

import pytest

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
