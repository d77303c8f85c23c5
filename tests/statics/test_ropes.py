"""Ropes over pulleys: one tension in all falls, and it only pulls; poses built by hand."""

import math

import pytest

from mechc.model.mechanism import LoadRatio, Rope
from mechc.model.result import Result
from mechc.pose.places import Plane
from mechc.statics.balanced import Balanced
from mechc.statics.contacts import slack
from mechc.statics.transfers import transfers
from mechc.statics.unfold import Unfolding
from mechc.units import NUMBER
from small_poses import ALONG, HERE, VALUES, at, force, pose

ALPHA = VALUES["alpha"]
ALL = {**VALUES, "pi": math.pi}
ROPE = Rope(("A", "K", "B", "H"), (ALONG, ALONG, ALONG), HERE)
FALLS = {ROPE.id: (at(-90, alpha=1), at(90), at(-90))}


def movable(up):
    """A movable pulley K, its first fall slanted, and the hand H; K's load is up or down."""
    return pose(
        {},
        pivots=("A", "B"),
        guides={"K": at(90), "H": at(90)},
        joints=(ROPE,),
        loads=(force("P", "H"), force("F", "K")),
        lines={"P": at(-90), "F": at(90 if up else -90)},
        falls=FALLS,
    )


def test_a_tension_pulls_the_ends_of_each_fall_together():
    """K is drawn towards A and B, the fixed axle B down on both sides of its pulley."""
    (transfer,) = transfers(Unfolding(movable(up=False), ALL))
    sums = {}
    for action in transfer.actions:
        sums[action.point] = sums.get(action.point, Plane(0.0, 0.0)).plus(action.force)
    assert sums["K"] == pytest.approx((-math.sin(ALPHA), 1 + math.cos(ALPHA)))
    assert sums["B"] == pytest.approx((0, -2))
    assert sums["H"] == pytest.approx((0, 1))


@pytest.mark.parametrize("up", [True, False])
def test_a_rope_never_pushes(up):
    """Lifted, the pulley leaves the rope: the tension would be −F/(1 + cos α)."""
    asked = Result("k", LoadRatio("P", "F"), NUMBER, None)
    faults = list(slack([asked], Balanced(movable(up), ALL)))
    assert [fault.code for fault in faults] == ["E343"] * up
    assert not up or f"{1 / (1 + math.cos(ALPHA)):.4g} times F" in faults[0].message
