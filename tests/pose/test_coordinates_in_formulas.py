"""Coordinates and directions in formulas, and sliding speeds that are made of speed ratios."""

import math

import numpy as np
import pytest

import mechc
from mechc.diagnostics import MechcError
from reference_drawn import Drawn

ROCKER = """
mechanism rocker
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link ABE
link CB
A at (30 mm, 50 mm)
B at (110 mm, 60 mm)
E at (80 mm, 120 mm)
drive OA from 30 deg to 80 deg
torque M on OA
torque T on CB
find k = M/T
"""


def test_a_formula_may_ask_for_coordinates_and_directions():
    text = f"{ROCKER}let u = x_E\nlet v = y_E - y_B\nlet turn = phi_AB\n"
    rocker, angle = mechc.loads(text), np.radians([35.0, 50.0, 75.0])
    found, at = rocker.evaluate(phi_OA=angle), rocker.points(phi_OA=angle)[0]
    assert found["u"] == pytest.approx(at["x_E"], rel=1e-12)
    assert found["v"] == pytest.approx(at["y_E"] - at["y_B"], rel=1e-12)
    assert found["turn"] == pytest.approx(at["phi_AB"], rel=1e-12)


def test_without_a_place_they_count_from_the_first_pivot():
    lever = """
param a = 40 mm
param alpha = 30 deg
pivot O
link OA
OA = a @ alpha
force P at A along x
force F at A along y
find k = P/F
let h = y_A
expect h = a*sin(alpha)
"""
    assert mechc.loads(lever).evaluate()["h"] == pytest.approx(0.02)


def test_a_name_of_ones_own_goes_before():
    text = ROCKER.replace("drive", "param x_E = 7 mm\ndrive", 1) + "let u = 2*x_E\n"
    assert mechc.loads(text).evaluate()["u"] == pytest.approx(0.014)
    with pytest.raises(MechcError, match="x_G"):
        mechc.loads(f"{ROCKER}let u = x_G\n")


def test_the_sliding_speed_at_a_pin():
    """(ω₁ − ω₂)·r at the pin B, for a crank at 10 rad/s and a pin of 20 mm."""
    text = f"""{ROCKER}find i1 = omega_AB/omega_OA
find i2 = omega_CB/omega_OA
param omega = 10 1/s
let v_B = abs(i1 - i2)*omega*20 mm/2
"""
    (motion,) = Drawn(ROCKER).motions
    crank, coupler, rocker = motion[-3:]
    expected = abs(coupler - rocker) / abs(crank) * 10 * 0.01
    assert mechc.loads(text).evaluate()["v_B"] == pytest.approx(expected, rel=1e-9)


def test_the_sliding_speed_in_a_slot():
    """Of the die along a lever about Q: the component of its velocity along the lever."""
    text = """
mechanism quick_return
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, -50 mm)
link OA
link QC
slot A in QC
A at (30 mm, 40 mm)
C at (40 mm, 70 mm)
drive OA from 20 deg to 90 deg
torque M on OA
torque T on QC
find k = M/T
find u = V_A_x/omega_OA
find v = V_A_y/omega_OA
let s = u*cos(phi_QC) + v*sin(phi_QC)
"""
    turned = math.atan2(90, 30)
    expected = -0.04 * math.cos(turned) + 0.03 * math.sin(turned)
    assert mechc.loads(text).evaluate()["s"] == pytest.approx(expected, rel=1e-9)
