"""Pins whose place on a line follows from a loop, by hand: slots, blocks, crossing lines."""

import math

import numpy as np
import pytest

import mechc

CRANK = """
param r = 50 mm
param h = 120 mm
param e = 70 mm
param phi = 50 deg
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, -h)
link OA
OA = r @ phi
drive phi from 10 deg to 80 deg
torque M on OA
"""
R, H, E = 0.05, 0.12, 0.07
PHI = np.radians(np.linspace(10, 80, 8))
REACH = np.hypot(R * np.cos(PHI), R * np.sin(PHI) + H)
"""From Q to A, by Pythagoras."""
TURN = np.arctan2(R * np.sin(PHI) + H, R * np.cos(PHI))
PARTING = R * H * np.cos(PHI) / REACH
"""By how much A departs from Q for a radian of the crank."""
TURNING = R * np.cos(TURN - PHI) / REACH
"""By how much QA turns for a radian of the crank: A's velocity across QA over QA."""


def k(text):
    return mechc.loads(CRANK + text, "place.mech").evaluate(phi=PHI)["k"]


def test_a_slotted_link_through_its_pivot():
    found = k("link QC\nslot A in QC\ntorque T on QC\nfind k = M/T")
    assert found == pytest.approx(-TURNING, rel=1e-12)


@pytest.mark.parametrize(
    ("line", "side"), [("", 1), ("assembly A forward", 1), ("assembly A back", -1)]
)
def test_a_pin_ahead_in_its_slot_or_behind(line, side):
    """D is on the line QC at e; with the pin behind Q it is on the other side of Q."""
    found = k(f"link QCD\nQD = e @ QC\nslot A in QC\nforce F at D along x\nfind k = M/F\n{line}")
    moved = -E * np.sin(TURN) * side * TURNING
    assert found == pytest.approx(-moved, rel=1e-12)


@pytest.mark.parametrize("side", ["A", "B"])
def test_two_rods_between_a_slot_and_the_pin_in_it(side):
    """The known side of their triangle is the pin's distance along the slot, by its cosine rule."""
    rods = "param b = 90 mm\nparam c = 150 mm\nlink QB\nlink AB\nQB = b\nAB = c\n"
    turns = f"assembly Q{'BA' if side == 'A' else 'AB'} ccw\n"
    found = k(f"link QC\nslot A in QC\n{rods}{turns}torque T on QB\nfind k = M/T")

    def opening(reach):
        return np.arccos((reach**2 + 0.09**2 - 0.15**2) / (2 * reach * 0.09))

    slope = (opening(REACH + 1e-6) - opening(REACH - 1e-6)) / 2e-6 * PARTING
    turning = TURNING - slope if side == "A" else TURNING + slope
    assert found == pytest.approx(-turning, rel=1e-7)


@pytest.mark.parametrize(("way", "side"), [("forward", 1), ("back", -1)])
def test_a_block_on_a_turning_link(way, side):
    """AE slides along QC; the pair between Q and E feels how far E departs from Q."""
    block = f"link QC\nlink AE\nslot A in QC\nslot E in QC\nAE = e\nassembly E {way}\n"
    found = k(block + "actuator F between Q and E\nfind k = M/F")
    departs = PARTING * np.sign(REACH + side * E)
    assert found == pytest.approx(-departs, rel=1e-12)


def test_a_spring_from_the_slots_end_to_the_pin():
    """M = −c(l0 − l)·dl/dφ, whether the slot is drawn towards the pin or away from it."""
    for way in ("forward", "back"):
        slot = f"link QC\nslot A in QC\nassembly A {way}\n"
        found = k(slot + "spring 2 N/mm between Q and A free 100 mm\nfind M\nlet k = M")
        assert found == pytest.approx(-2000 * (0.1 - REACH) * PARTING, rel=1e-12)


CROSSING = "slot T in OA\nslider T along x through G\npivot G at (-300 mm, h)\n"


def test_a_pin_where_a_slot_crosses_a_guide():
    """T is at h cot φ: a force along x needs M = F h/sin²φ."""
    found = k(CROSSING + "force F at T along x\nfind k = M/F")
    assert found == pytest.approx(H / np.sin(PHI) ** 2, rel=1e-12)


@pytest.mark.parametrize("from_", ["Q", "G"])
def test_a_pair_to_a_pin_that_only_lines_hold(from_):
    x, y = H / np.tan(PHI), np.full_like(PHI, H)
    start = {"Q": (0.0, -H), "G": (-0.3, H)}[from_]
    parts = -H / np.sin(PHI) ** 2 * (x - start[0]) / np.hypot(x - start[0], y - start[1])
    found = k(CROSSING + f"actuator F between {from_} and T\nfind k = M/F")
    assert found == pytest.approx(-parts, rel=1e-12)


def test_a_pair_to_a_pin_behind_the_start_of_its_guide():
    """The guide begins ahead of T, so that its place is negative; the pair still pushes apart."""
    ahead = CROSSING.replace("-300 mm", "900 mm")
    parts = H / np.sin(PHI) ** 2
    found = k(ahead + "actuator F between G and T\nfind k = M/F")
    assert found == pytest.approx(-parts, rel=1e-12)


def test_a_slot_beside_the_pivot_of_its_plate():
    """The slot DC passes Q by: two closures, and turn, length and angle are the plate's."""
    plate = "link QDC\nQD = e\nQC = 60 mm\nangle DQC = 1.2345678 rad\nslot A in DC\n"
    b, gamma = 0.06, 1.2345678
    across = E * b * math.sin(gamma) / math.sqrt(E**2 + b**2 - 2 * E * b * math.cos(gamma))
    for way, side in (("forward", 1), ("back", -1)):
        found = k(plate + f"assembly A {way}\ntorque T on QDC\nfind k = M/T")
        ahead = np.sqrt(REACH**2 - across**2)
        turning = TURNING - side * across / (ahead * REACH) * PARTING
        assert found == pytest.approx(-turning, rel=1e-11)


def test_a_yoke_whose_guide_has_a_place():
    """The rod WB hangs on the yoke, whose slot stands upright: W moves as A does along x."""
    yoke = (
        "slide WX along x\nslider W along x through O\nWX = @ 90 deg\nslot A in WX\n"
        "link WB\nWB = 150 mm\nslider B along y through O\nassembly B forward\n"
        "force F at B along y\nfind k = M/F"
    )
    solved = mechc.loads(CRANK + yoke, "yoke.mech")
    x = R * np.cos(PHI)
    height = np.sqrt(0.15**2 - x**2)
    assert "W241" not in {d.code for d in solved.warnings}
    assert solved.evaluate(phi=PHI)["k"] == pytest.approx(-R * np.sin(PHI) * x / height, rel=1e-12)
