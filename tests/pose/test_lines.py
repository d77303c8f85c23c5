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
    for a, sign in ((100, 1), (300, -1)):
        text = COLLINEAR.format(a=f"{a} mm", b="200 mm", line="AB")
        assert mechc.loads(text).evaluate()["k"] == pytest.approx(sign / 0.05)


@pytest.mark.parametrize("range_", ["", " in 80 mm .. 400 mm"])
def test_it_acts_so_wherever_the_ends_may_change_places(range_):
    text = COLLINEAR.format(a="a", b="b", line="AB")
    bar = mechc.loads(f"{text}param a = 100 mm{range_}\nparam b = 200 mm\n")
    assert list(bar.evaluate(a=[0.1, 0.19, 0.3])["k"]) == pytest.approx([20, 20, -20])


def test_its_direction_has_no_name_where_ranges_keep_the_ends_apart():
    text = COLLINEAR.format(a="a", b="b", line="AB")
    ranges = "param a = 100 mm in 80 mm .. 150 mm\nparam b = 200 mm in 160 mm .. 400 mm\n"
    assert str(mechc.loads(text + ranges).k) == "1/len_OC"
