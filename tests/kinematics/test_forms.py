"""Velocities as linear forms: rotations, projections, spins, rates at which points part."""

import math

import pytest

from mechc.algebra.product import ONE, Product
from mechc.base.frozen import replace
from mechc.kinematics import forms
from mechc.kinematics.graph import Flow
from mechc.model.mechanism import ForcePair
from mechc.pose.pose import PointContact
from small_poses import (
    HERE,
    VALUES,
    arm,
    at,
    form,
    graph,
    lever,
    slider_crank,
    two_bars,
    unknown,
)

A, B, L = (VALUES[n] for n in "abl")
ALPHA, PHI, PSI = (VALUES[n] for n in ("alpha", "phi", "psi"))


def test_a_spin_turns_a_vector_by_a_quarter_counter_clockwise():
    (flow,) = forms.turned(arm("a", at(30)), 7)
    assert flow == Flow(Product.symbol("a"), at(120), 7)


def test_a_velocity_projects_by_the_cosine_of_the_angle_between():
    velocity = (Flow(Product.symbol("a"), at(alpha=1), 0),)
    assert form(forms.projection(velocity, at(phi=1))) == {
        0: pytest.approx(A * math.cos(PHI - ALPHA))
    }


def test_a_velocity_has_no_part_across_itself():
    velocity = (Flow(ONE, at(alpha=1), 0),)
    assert forms.projection(velocity, at(90, alpha=1)) == {}


def test_forms_are_subtracted_term_by_term():
    a, b = Product.symbol("a"), Product.symbol("b")
    assert forms.subtract({0: a, 1: b}, {0: a, 2: a}) == {1: b, 2: -a}


def test_forms_are_combined_each_with_its_factor():
    a, b = Product.symbol("a"), Product.symbol("b")
    found = forms.combined([(a, {0: ONE, 1: b}), (-ONE, {0: a})])
    assert found == {1: a * b}


def test_a_scaled_form_has_every_part_scaled():
    a, b = Product.symbol("a"), Product.symbol("b")
    assert forms.scaled({0: a, 1: ONE}, b) == {0: a * b, 1: b}


def test_lever_speed_is_arm_times_rate():
    found = graph(lever())
    (omega,) = found.spins.values()
    along = forms.projection(found.velocities["A"], at(90, alpha=1))
    across = forms.projection(found.velocities["B"], at(180, alpha=1))
    assert (form(along), form(across)) == ({omega: A}, {omega: B})


def test_a_pivoted_link_has_a_spin_of_its_own():
    found = graph(lever())
    assert forms.spin(found, "OAB") == {found.spins["OAB"]: ONE}


def test_a_rod_turns_with_the_difference_of_its_ends_across_it_over_its_length():
    """ω·l = (V_B − V_A)·n: the slider's x-speed and the crank pin's, across the rod."""
    found = graph(slider_crank())
    omega, slide = unknown(found, "OA"), unknown(found, "B")
    expected = {omega: -VALUES["r"] * math.cos(PHI - PSI) / L, slide: -math.sin(PSI) / L}
    assert form(forms.spin(found, "AB")) == pytest.approx(expected)


def test_a_rod_of_several_arms_turns_by_its_reach_across_the_first():
    pose = slider_crank()
    arms = (*arm("l", at(psi=1)), *arm("c", at(90, psi=1)))
    frames = {**pose.frames, "AB": {"A": (), "B": arms}}
    velocities = {"A": (), "B": (Flow(ONE, at(90, psi=1), 0),)}
    bent = replace(pose, frames=frames)
    assert form(forms.rod_spin(bent, "AB", "A", "B", velocities)) == {0: pytest.approx(1 / L)}


def test_points_part_at_the_speed_of_the_second_less_that_of_the_first():
    found = graph(two_bars())
    pair = ForcePair("S", "B", "K", HERE)
    spin, slide = unknown(found, "OB"), unknown(found, "K")
    parted = form(forms.parting(found, pair, at(90)))
    assert parted == {slide: 1, spin: pytest.approx(L * math.sin(ALPHA))}


def test_twins_part_at_the_speed_of_one_away_from_the_line():
    found = graph(two_bars())
    pair = ForcePair("S", "B", "B'", HERE, joins_twins=True)
    assert form(forms.parting(found, pair, at(180))) == {
        unknown(found, "OB"): pytest.approx(L * math.cos(ALPHA))
    }


def test_a_pin_leaves_a_slot_with_its_own_speed_less_that_of_the_slot_under_it():
    found = graph(lever())
    touch = PointContact("slot", "B", "OAB", "O", arm("a", at(alpha=1)), at(90, alpha=1), HERE)
    left = forms.relative_speed(found, touch, at(90, alpha=1))
    assert form(left) == {0: pytest.approx(-A)}
    assert forms.relative_speed(found, touch._replace(reach=()), at(90, alpha=1)) == {}


def test_a_couple_works_against_its_links_spin_and_a_force_against_its_points_speed_along_it():
    found = graph(slider_crank())
    couple, push = found.pose.mechanism.loads
    assert forms.speed_of_load(found, couple) == {unknown(found, "OA"): ONE}
    assert forms.speed_of_load(found, push) == {unknown(found, "B"): ONE}


def test_a_pair_of_forces_works_against_the_speed_at_which_its_points_part():
    pair = ForcePair("S", "B", "K", HERE)
    pose = two_bars()
    found = graph(replace(pose, lines={**pose.lines, "S": at(90)}))
    assert forms.speed_of_load(found, pair) == forms.parting(found, pair, at(90))
