"""A drawn slide: its place is for loops to close, and its guide is one."""

import math

import pytest

import mechc
from mechc.figure.figure import Pivot
from mechc.model.mechanism import Slider

CRANK = """
param phi = 50 deg in 10 deg .. 80 deg
pivot O at (0 mm, 0 mm)
link OA
link AB
slide BK along x
OA = 30 mm @ phi
AB = 90 mm
B at (106 mm, 0 mm)
drive phi
torque M on OA
force F at K along -x
let F = 1 kN
"""
PHI = math.radians(50)
BETA = math.asin(math.sin(PHI) / 3)


def test_the_guide_of_a_slide_carries_all_that_presses_it():
    """N = F tan β; with a guide more, equilibrium would leave open which of them is pressed."""
    found = mechc.loads(f"{CRANK}find k = M/F\nfind N_K\n")
    assert found.results["N_K"].default == pytest.approx(1000 * math.tan(BETA), rel=1e-9)
    assert {trial.result.partition("/")[0] for trial in found._compilation.verdict.trials} == {
        "k",
        "N_K",
    }


def test_a_slide_has_friction_in_one_guide():
    """M = S·r·sin(φ + β), S (cos β − μ sin β) = F where M drives."""
    found = mechc.loads(f"{CRANK}friction slider K 0.1\nmotion releasing\nfind k = M/F\n")
    force = 1 / (math.cos(BETA) - 0.1 * math.sin(BETA))
    expected = -0.03 * math.sin(PHI + BETA) * force
    assert found.results["k_f"].default == pytest.approx(expected, rel=1e-9)


def test_the_place_of_its_guide_is_no_pivot():
    figure = mechc.loads(f"{CRANK}find k = M/F\n").figure()
    assert [part.point for part in figure.parts if isinstance(part, Pivot)] == ["O"]


def test_the_guide_that_a_drawing_adds_is_for_loops_alone():
    """The model marks the guide that it adds to a slide, and the pose has none such."""
    found = mechc.loads(f"{CRANK}find k = M/F\n")._compilation
    (guide,) = found.mechanism.each(Slider)
    assert (guide.point, guide.is_of_slide) == ("B", True)
    assert not found.pose.mechanism.each(Slider)
    assert not found.pose.guides
