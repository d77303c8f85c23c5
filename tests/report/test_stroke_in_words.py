"""What is said along a stroke, in every language."""

from typing import get_args

import pytest

import mechc
from good_mechanisms import loaded
from mechc.report.languages.registry import locale
from mechc.report.text.stroke import ENDS, KINDS, to_table
from mechc.study.analysis import NoCentre
from mechc.study.locking_intervals import DriveState
from mechc.study.pose_sweep import EXCLUDED, NO_POSE
from mechc.study.stroke.stretches import BEYOND, FLAT
from mechc.study.stroke.stroke import OnTheWay
from mechc.syntax.vocabulary import LANGUAGES

VERBS = ("still", "moves")


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_that_a_stroke_can_meet_has_words(language):
    words = locale(language).along_stroke
    kinds = {KINDS.get(kind, kind) for kind in get_args(NoCentre) + get_args(OnTheWay)} - {""}
    states = {f"{state} part" for state in get_args(DriveState)}
    assert {*NO_POSE, EXCLUDED, BEYOND, FLAT, *kinds, *states} <= words.keys()
    assert {"dead centre", *(f"{v}{d}" for v in VERBS for d in ("", " distance"))} <= words.keys()
    assert set(ENDS.values()) - {""} <= words.keys()


def test_a_stroke_in_ukrainian_has_its_units_and_decimal_commas():
    table = to_table(loaded("crank_rocker").stroke(3), language="uk")
    head, first, *_ = table.splitlines()
    assert head.split() == ["phi", "[град]", "k", "[мм]", "i", "mu_B", "[град]"]
    assert "-53,3333333" in first
    assert "k = 0 при phi = 24,1468 град: мертве положення" in table
    assert "." not in table.replace(". Нулі", "").replace("пропущені.", "")


def test_where_a_condition_begins_at_zero_it_is_zero():
    """It was found between the least numbers: below phi = 2.81617e-322 deg."""
    lever = """
param phi = 40 deg
pivot O
link OA
OA = 100 mm @ phi
torque M on OA
force F at A along x
require phi > 0 deg
drive phi from -60 deg to 60 deg
find k = M/F
"""
    table = to_table(mechc.loads(lever).stroke(3))
    assert "\nbelow phi = 0 deg: excluded by a condition of use\n" in table


def test_efficiencies_and_jams_in_russian():
    table = to_table(loaded("claw_with_friction").stroke(3), language="ru")
    assert "eta_k изменяется от 0,974 до 0,977; в пределах 0,9…0,95: нигде" in table
    assert "phi [рад]" in table


def test_english_is_said_as_ever():
    table = to_table(loaded("crank_rocker").stroke(3))
    assert "k = 0 at phi = 24.1468 deg: dead centre, B stands still while O1A moves" in table
    assert "Looked at 721 places: zeros, poles, jumps, extrema" in table


def test_a_ratio_of_speeds_that_is_k_has_no_column():
    """It would have the numbers of k beside k, without saying so."""
    found = loaded("crank_rocker").stroke()
    out = to_table(found, velocities=True)
    assert "V_B/omega_O1A [mm]" not in out
    assert "\nThroughout, V_B/omega_O1A = -k.\nV_B is the component" in out
    assert "omega" not in to_table(found)


def test_what_a_ratio_of_speeds_is_throughout_takes_more_than_both_ends():
    """Two curves may meet at the ends of a stroke alone."""
    out = to_table(loaded("crank_rocker").stroke(2), velocities=True)
    assert "Throughout" not in out
    assert "V_B/omega_O1A [mm]" in out


def test_a_place_in_radians_is_said_in_degrees_too():
    """The table has the unit that the description gives the drive in."""
    table = to_table(loaded("claw_closed").stroke(2))
    assert "phi [rad]" in table
    assert "k has a minimum 1.37277 at phi = 1.38056 rad (79.1001 deg)" in table
