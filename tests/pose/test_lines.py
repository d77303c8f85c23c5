"""Directions between points that no vector joins: those of the vectors from one to the other."""

import pytest

import mechc
from mechc.driver import Compilation
from mechc.source import Source

COLLINEAR = """
param alpha = 20 deg
pivot O
link OABC
OA = {a} @ alpha
OB = {b} @ alpha
OC = 50 mm @ alpha + 90 deg
force P at C along {line}
torque M on OABC
find k = P/M
"""


@pytest.mark.parametrize(("a", "b", "ahead"), [(100, 300, True), (300, 100, False)])
@pytest.mark.parametrize(
    ("line", "turned"), [("AB", 0), ("BA", 180), ("perp AB", 90), ("-AB", 180)]
)
def test_a_difference_on_one_line_points_from_one_end_to_the_other(a, b, ahead, line, turned):
    text = COLLINEAR.format(a=f"{a} mm", b=f"{b} mm", line=line)
    angle = Compilation(Source("bar.mech", text)).pose.lines["P"]
    assert dict(angle.terms) == {"alpha": 1}
    assert angle.degrees % 360 == (turned + (0 if ahead else 180)) % 360


def test_a_force_along_a_difference_acts_the_way_that_it_is_drawn():
    """C is on the left of AB, so that P along AB turns the bar clockwise: P·OC = M."""
    text = COLLINEAR.format(a="a", b="b", line="AB") + "param a = {} mm\nparam b = 200 mm\n"
    assert mechc.loads(text.format(100)).evaluate()["k"] == pytest.approx(1 / 0.05)
    assert mechc.loads(text.format(300)).evaluate()["k"] == pytest.approx(-1 / 0.05)
