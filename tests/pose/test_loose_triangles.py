"""Triangles of three moving bodies: closed wherever they stand, in closed form."""

import math

import numpy as np
import pytest

import mechc
from mechc.diagnostics import MechcError
from mechc.formula.tree import Implicit
from mechc.formula.walk import walk
from paths import LIBRARY

TABLE = """
mechanism table
param l = 1.2 m
param s = 0.8 m
pivot A at (0 m, {height})
pivot Z at (0 m, 0 m)
slider B along x through Z
link AMD
link BMEC
AM = {first}*l
AD = l @ AM
BM = {second}*l
BE = 0.8*l @ BM
BC = l @ BM
telescope AE
AE = s
assembly AMB cw
assembly B forward
drive s from 0.7 m to 0.85 m
actuator P between A and E
force W at D along -y
find k = P/W
"""


def is_iterated(mechanism):
    definitions = mechanism._compilation.pose.definitions
    return any(isinstance(part, Implicit) for d in definitions for part in walk(d.formula))


def test_a_scissor_on_a_cylinder_is_solved_by_laws_of_cosines():
    found = mechc.load("scissor_table")
    assert not is_iterated(found)
    assert str(found.k) == "10*cos(gamma_M/2)/(3*sin(mu_E) + 5*sin(gamma_M + mu_E))"


@pytest.mark.parametrize("height", ["0 m", "0.1 m"])
@pytest.mark.parametrize(("first", "second"), [(0.5, 0.5), (0.5, 0.45), (0.55, 0.4)])
def test_all_lengths_are_kept_along_the_stroke(height, first, second):
    """Arms of one length halve their angle, others do not; a guide may pass the pivot by."""
    found = mechc.loads(TABLE.format(height=height, first=first, second=second))
    assert not is_iterated(found)
    s = np.linspace(0.72, 0.85, 7)
    points, status = found.points(s=s)
    assert not np.any(status)
    above = float(height.split()[0])
    np.testing.assert_allclose(np.hypot(points["x_E"], points["y_E"] - above), s, rtol=1e-12)
    np.testing.assert_allclose(points["y_B"], 0.0, atol=1e-12)
    arm = np.hypot(points["x_M"], points["y_M"] - above)
    np.testing.assert_allclose(arm, first * 1.2, rtol=1e-12)
    away = np.hypot(points["x_M"] - points["x_B"], points["y_M"] - points["y_B"])
    np.testing.assert_allclose(away, second * 1.2, rtol=1e-12)
    assert math.isfinite(found.evaluate()["k"])


def test_what_has_no_place_is_still_asked_for():
    """Directions that no vector mentions are none to begin from."""
    text = (LIBRARY / "crank_rocker.mech").read_text(encoding="utf-8")
    text = text.replace("pivot O1 at (0 mm, 0 mm)", "pivot O1").replace("@ psi", "")
    with pytest.raises(MechcError) as refused:
        mechc.loads(text)
    assert refused.value.diagnostics
