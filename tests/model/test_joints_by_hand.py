"""What joints say of themselves: what they hold by themselves, which motions they tie."""

import math
from fractions import Fraction

import pytest

from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Number, Symbol
from mechc.model import mechanism as model
from mechc.model.parts.holding import OnLine
from small_poses import HERE, RACK, SCREW, VALUES, wheels

X = model.Absolute(Number(Fraction(0)), HERE)
SLOT = model.Slot("B", "OC", "O", "C", HERE, guided="BD")
CONTACT = model.Contact("B", "OC", "O", "C", X, HERE)
ROPE = model.Rope(("A", "P", "B", "P"), (X, X, X), HERE)


@pytest.mark.parametrize(
    ("joint", "held", "points", "bodies"),
    [
        (model.Pivot("O", HERE), ("O",), ("O",), ()),
        (model.Slider("K", X, HERE), ("K",), ("K",), ()),
        (SLOT, ("B",), ("B",), ("OC", "BD")),
        (CONTACT, ("B",), ("B",), ("OC",)),
        (wheels(), (), ("O", "Q"), ("OA", "QB")),
        (RACK, (), ("K", "O"), ("OA",)),
        (SCREW, (), ("K",), ("OA",)),
        (ROPE, (), ("A", "P", "B"), ()),
    ],
)
def test_a_joint_says_what_it_holds_and_names(joint, held, points, bodies):
    assert (joint.held, joint.points, joint.bodies) == (held, points, bodies)


def test_slots_and_contacts_are_on_a_line_of_their_link():
    assert [j for j in (SLOT, CONTACT, RACK, ROPE) if isinstance(j, OnLine)] == [SLOT, CONTACT]


def tied(joint):
    """Return the factor of each motion that a joint ties, by body and point."""
    return {(t.body, t.point): evaluate(t.factor, VALUES) for t in joint.tied}


@pytest.mark.parametrize(("same", "sign"), [(False, 1), (True, -1)])
def test_wheels_tie_their_turns_to_that_of_their_arm(same, sign):
    pair = model.WheelPair(
        "gear", "O", "OA", Symbol("r"), "Q", "QB", Symbol("c"), same, HERE, arm="OQ"
    )
    r, c = VALUES["r"], sign * VALUES["c"]
    assert tied(pair) == {("OA", ""): r, ("QB", ""): c, ("OQ", ""): pytest.approx(-r - c)}


def test_a_rack_ties_its_way_to_the_turn_by_the_radius_and_a_screw_by_the_lead():
    assert tied(RACK) == {("OA", ""): VALUES["r"], ("", "K"): -1}
    lead = VALUES["c"] / (2 * math.pi)
    assert tied(SCREW) == {("OA", ""): pytest.approx(lead), ("", "K"): -1}
