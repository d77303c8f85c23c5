"""Joints released: what parts then, what still holds, and what acts on the link goes with it."""

import math

import pytest

from mechc.algebra.product import ONE
from mechc.base.frozen import replace
from mechc.kinematics.joint_refs import JointRef, contact_at, held_end, members, unclear
from mechc.kinematics.release import released_linkage, work_of
from mechc.model.mechanism import Force
from small_poses import (
    HERE,
    RACK,
    SCREW,
    VALUES,
    at,
    driven_slider,
    force,
    form,
    graph,
    lever,
    number_of,
    on_pivots,
    slider_crank,
    slotted,
    torque,
    wheels,
)

A, B, R = (VALUES[n] for n in "abr")
PSI = VALUES["psi"]


def released(pose, joint, along, held):
    """Return the plan with a joint released, while the load ``held`` does no work."""
    load = next(k for k in pose.mechanism.loads if k.name == held)
    found = released_linkage(pose, joint, along, [[(ONE, load)]], frozenset())
    assert found is not None
    return found


def ratio(found, point, along):
    """Return a point's speed along a direction per unit of that at which the joint parts."""
    (speed,), (parting,) = found.plan.component(point, along), found.parting
    return number_of(speed) / number_of(parting)


def test_a_lever_whose_pivot_is_let_slide_turns_about_the_point_that_is_held():
    """P holds A across the arm; O moves across it, and B by as much."""
    found = released(lever(), JointRef("ground", "O"), at(90, alpha=1), "P")
    assert found.plan.mobility == 1
    assert ratio(found, "O", at(90, alpha=1)) == pytest.approx(1)
    assert ratio(found, "A", at(90, alpha=1)) == pytest.approx(0, abs=1e-12)
    assert ratio(found, "B", at(90, alpha=1)) == pytest.approx(1)
    assert ratio(found, "B", at(alpha=1)) == pytest.approx(B / A)


def test_a_slider_off_its_guide_moves_across_it():
    """With the crank held the rod turns about A: B moves by −tan ψ along per unit across."""
    found = released(slider_crank(), JointRef("ground", "B"), at(90), "M")
    assert ratio(found, "B", at(90)) == pytest.approx(1)
    assert ratio(found, "B", at()) == pytest.approx(-math.tan(PSI))
    assert ratio(found, "A", at()) == pytest.approx(0, abs=1e-12)


def test_a_rod_off_its_pin_parts_along_one_direction_only():
    """With the crank held B moves away from the rod's own end along the rod."""
    joint = JointRef("pin", "B", "AB")
    found = released(slider_crank(), joint, at(psi=1), "M")
    assert joint.loose == "B of AB"
    own = ratio(found, joint.loose, at(psi=1)) - ratio(found, "B", at(psi=1))
    across = ratio(found, joint.loose, at(90, psi=1)) - ratio(found, "B", at(90, psi=1))
    assert (own, across) == (pytest.approx(1), pytest.approx(0, abs=1e-12))


def test_what_acts_on_the_link_itself_goes_with_it_when_its_pin_is_released():
    """Q is on the rod and leaves with its end; F is on the pin and stays."""
    loads = (torque("M", "OA"), force("F", "B"), force("Q", "B", link="AB"))
    pose = slider_crank()
    lines = {"F": at(), "Q": at(90)}
    loaded = replace(pose, mechanism=replace(pose.mechanism, loads=loads), lines=lines)
    joint = JointRef("pin", "B", "AB")
    found = released(loaded, joint, at(psi=1), "M").plan.graph.pose.mechanism
    points = {load.name: load.point for load in found.loads if isinstance(load, Force)}
    assert points == {"F": "B", "Q": joint.loose}


@pytest.mark.parametrize("joint", [RACK, SCREW])
def test_a_rack_or_nut_off_its_wheel_moves_alone(joint):
    ref = JointRef("mesh", "K", joint.id)
    found = released(driven_slider(joint), ref, at(), "M")
    assert ratio(found, "K", at(90)) == pytest.approx(1)


def test_a_wheel_off_its_mesh_turns_alone_at_the_speed_of_its_rim():
    found = released(on_pivots(wheels()), JointRef("mesh", "O", wheels().id), at(), "T")
    (spin,), (parting,) = found.plan.spin("OA"), found.parting
    assert number_of(spin) * R == pytest.approx(number_of(parting))


def test_a_pin_out_of_its_slot_parts_across_it():
    found = released(slotted(), JointRef("contact", "A"), at(90, theta=1), "T")
    assert ratio(found, "A", at(90, theta=1)) == pytest.approx(1)


def test_nothing_moves_where_the_load_that_is_held_is_all():
    """A lever whose pivot may slide along its arm, with A and B both held, stays."""
    pose = lever()
    loads = [[(ONE, load)] for load in pose.mechanism.loads]
    assert released_linkage(pose, JointRef("ground", "O"), at(alpha=1), loads, frozenset()) is None


def test_loads_that_are_tied_work_together():
    """P and a tied load 2·P at B: their speed is V_A + 2·V_B along their lines."""
    pose = lever()
    first, second = pose.mechanism.loads
    found = graph(pose)
    speed = work_of([(ONE, first), (ONE.scaled(2), second)])(found)
    assert form(speed) == {0: pytest.approx(A - 2 * B)}


def test_a_rod_is_held_at_its_last_end_that_bears_no_load():
    mechanism = slider_crank().mechanism
    assert held_end(mechanism, mechanism.link("AB")) == "B"
    own = slider_crank().mechanism.loads[0], force("F", "B", link="AB")
    loaded = type(mechanism)(
        name="", title="", source="", span=HERE, links=mechanism.links, loads=own
    )
    assert held_end(loaded, mechanism.link("AB")) == "A"


def test_pivots_of_wheels_and_screws_are_unclear_but_not_of_racks():
    assert unclear(on_pivots(wheels()).mechanism) == {"O", "Q"}
    assert unclear(driven_slider(SCREW).mechanism) == {"O"}
    assert unclear(driven_slider(RACK).mechanism) == frozenset()


def test_what_a_joint_holds():
    assert members(slotted(), JointRef("contact", "A")) == ("A", "Q", "B")
    assert members(on_pivots(wheels()), JointRef("mesh", "O", wheels().id)) == (*"OQ", *"OA", *"QB")
    assert members(lever(), JointRef("pin", "A", "OAB")) == ("O", "A", "B")
    assert members(lever(), JointRef("ground", "O")) == ("O",)
    assert contact_at(slotted(), "A").body == "QB"
