"""What joints ask of velocities: the textbook relation of each, and the graph they are put in."""

import math

import pytest

from mechc.base.frozen import replace
from mechc.kinematics.contacts import mesh_of, relations, slipping, spinning
from mechc.kinematics.graph import Rule, SpeedKind
from small_poses import (
    RACK,
    SCREW,
    VALUES,
    arm,
    at,
    driven_slider,
    form,
    graph,
    lever,
    on_pivots,
    slider_crank,
    slotted,
    two_bars,
    unknown,
    wheels,
)

R, C, L, A = (VALUES[n] for n in "rcla")


def only(pose):
    """Return the relations of joints that hold no pin, and the place of each unknown."""
    found = graph(pose)
    (relation,) = relations(pose, found.velocities, found.spins)
    return relation, lambda name: unknown(found, name)


@pytest.mark.parametrize(
    ("kind", "same", "sign", "rule"),
    [
        ("gear", False, 1, Rule.MESH),
        ("gear", True, -1, Rule.MESH),
        ("belt", True, -1, Rule.MESH),
        ("belt", False, 1, Rule.MESH),
    ],
)
def test_rims_of_wheels_have_one_speed(kind, same, sign, rule):
    """External gears and crossed belts turn oppositely: ω₁r₁ + ω₂r₂ = 0."""
    relation, of = only(on_pivots(wheels(kind, same)))
    assert relation.rule is rule
    assert form(relation.form) == {of("OA"): R, of("QB"): sign * C}


def test_a_rack_moves_with_the_rim_of_its_gear():
    relation, of = only(driven_slider(RACK))
    assert relation.rule is Rule.MESH
    assert form(relation.form) == {of("K"): 1, of("OA"): -R}


def test_a_screw_moves_by_its_pitch_for_a_turn():
    relation, of = only(driven_slider(SCREW))
    assert relation.rule is Rule.MESH
    found = form(relation.form, pi=math.pi)
    assert found == {of("K"): 1, of("OA"): pytest.approx(-C / (2 * math.pi))}


def test_a_pin_and_its_slot_have_one_speed_across_the_slot():
    relation, of = only(slotted())
    turn = VALUES["phi"] - VALUES["theta"]
    assert relation.rule is Rule.SLOT
    assert form(relation.form) == {of("OA"): pytest.approx(A * math.cos(turn)), of("QB"): -L}


def test_what_wheels_and_slots_turn_has_a_spin_of_its_own():
    assert spinning(on_pivots(wheels())) == {"OA", "QB"}
    assert spinning(slotted()) == {"QB"}
    assert spinning(slider_crank()) == set()


@pytest.mark.parametrize("joint", [wheels(), wheels("belt", same=True)])
def test_wheels_that_lost_each_other_slip_by_what_their_relation_was(joint):
    pose = on_pivots(joint)
    relation, _ = only(pose)
    assert slipping(graph(pose), pose, joint) == relation.form


@pytest.mark.parametrize("joint", [RACK, SCREW])
def test_a_rack_or_nut_that_is_released_slips_by_what_its_relation_was(joint):
    pose = driven_slider(joint)
    relation, _ = only(pose)
    assert slipping(graph(pose), pose, joint) == relation.form


def test_wheels_on_an_arm_slip_by_their_turns_as_seen_from_it():
    pair = replace(wheels(), second_link="", arm="QB")
    pose = on_pivots(pair)
    relation, of = only(pose)
    assert form(relation.form) == {of("OA"): R, of("QB"): pytest.approx(-R - C)}
    assert slipping(graph(pose), pose, pair) == relation.form


def test_what_is_no_mesh_has_no_speed_at_which_it_slips():
    with pytest.raises(AssertionError):
        slipping(graph(lever()), lever(), lever().mechanism.joint("pivot O"))


def test_a_mesh_is_found_by_its_id():
    assert mesh_of(driven_slider(RACK), RACK.id) is RACK
    with pytest.raises(AssertionError):
        mesh_of(driven_slider(RACK), "pivot O")


# ---------------------------------------------------------------------------- the graph


def test_a_lever_has_one_unknown_and_no_relation():
    found = graph(lever())
    assert [(u.kind, u.of) for u in found.unknowns] == [(SpeedKind.SPIN, "OAB")]
    assert found.relations == ()
    assert found.velocities["O"] == ()


def test_a_slider_crank_has_the_equal_projections_of_its_rod():
    found = graph(slider_crank())
    assert [(u.kind, u.of) for u in found.unknowns] == [
        (SpeedKind.SPIN, "OA"),
        (SpeedKind.SLIDE, "B"),
    ]
    (relation,) = found.relations
    assert (relation.rule, relation.points) == (Rule.PROJECTION, ("A", "B"))
    turn = VALUES["phi"] - VALUES["psi"]
    assert form(relation.form) == {
        0: pytest.approx(-R * math.sin(turn)),
        1: pytest.approx(-math.cos(VALUES["psi"])),
    }


def test_a_rod_given_by_components_has_equal_products_of_its_ends_velocities_and_itself():
    """V_A·AB = V_B·AB, with AB = (l, c), V_A = ω·r across the crank and V_B along x."""
    pose = slider_crank()
    ends = (*arm("l", at()), *arm("c", at(90)))
    found = graph(replace(pose, frames={**pose.frames, "AB": {"A": (), "B": ends}}))
    (relation,) = found.relations
    sine, cosine = math.sin(VALUES["phi"]), math.cos(VALUES["phi"])
    assert form(relation.form) == {
        unknown(found, "OA"): pytest.approx(R * (C * cosine - L * sine)),
        unknown(found, "B"): pytest.approx(-L),
    }


def test_a_guided_point_of_a_pivoted_link_does_not_move_across_its_guide():
    pose = lever()
    assert graph(replace(pose, guides={"A": pose.lines["P"]})).relations == ()
    askew = graph(replace(pose, guides={"A": pose.lines["F"]}))
    (relation,) = askew.relations
    assert relation.rule is Rule.GUIDE
    assert form(relation.form) == {0: A}


def test_a_pin_of_two_rods_moves_by_its_projections_on_them():
    """Each rod moves with the projection that is named by it: V·e₁ = p and V·e₂ = q."""
    pose = two_bars()
    guides = {"K": pose.guides["K"], "O": pose.guides["K"]}
    free = graph(replace(pose, guides=guides, mechanism=replace(pose.mechanism, joints=())))
    assert [u.kind for u in free.unknowns] == [
        SpeedKind.SLIDE,
        SpeedKind.SLIDE,
        *[SpeedKind.COMPONENT] * 2,
    ]
    for relation in free.relations:
        own = {u: p for u, p in form(relation.form).items() if u > 1}
        assert sorted(map(abs, own.values())) == [1]
