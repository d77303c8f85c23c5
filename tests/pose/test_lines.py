"""Directions between points that no vector joins: those of the vectors from one to the other."""

import math

import pytest

import mechc
from mechc.compilation import Compilation
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


ACROSS = """
param alpha = 100 deg{range}
param gamma = 10 deg in 0 deg .. 20 deg
param a = 100 mm
pivot O
pivot B
link OA
OA = a @ alpha
OB = a @ gamma
torque M on OA
actuator P between B and A
find k = P/M
"""


@pytest.mark.parametrize(
    ("range_", "formula"),
    [
        (" in 60 deg .. 150 deg", "-1/(a*cos(alpha/2 - gamma/2))"),
        (" in -20 deg .. 150 deg", "1/(a*sin(alpha - phi_BA))"),
        ("", "1/(a*sin(alpha - phi_BA))"),
    ],
)
def test_across_two_equal_arms_a_cylinder_is_on_the_line_that_halves_their_angle(range_, formula):
    """Where the arms may change places it pushes the other way beyond, and has a name."""
    bar = mechc.loads(ACROSS.format(range=range_))
    assert str(bar.k) == formula
    for alpha in (1.2, 2.0, 2.6):
        expected = -1 / (0.1 * math.cos((alpha - math.radians(10)) / 2))
        assert bar.evaluate(alpha=alpha)["k"] == pytest.approx(expected)


def test_it_pushes_both_ends_apart_whichever_is_named_first():
    """From A to B the two arms halve the angle backwards."""
    other_way = ACROSS.replace("between B and A", "between A and B")
    bar = mechc.loads(other_way.format(range=" in 60 deg .. 150 deg"))
    assert str(bar.k) == "-1/(a*cos(alpha/2 - gamma/2))"


def test_beyond_the_range_that_it_rests_on_it_has_no_value():
    """Below 10 degrees A and B have changed places, and P would push the other way."""
    bar = mechc.loads(ACROSS.format(range=" in 60 deg .. 150 deg"))
    found = bar.evaluate(alpha=[math.radians(11), math.radians(9)])["k"]
    assert found[0] == pytest.approx(-1 / (0.1 * math.cos(math.radians(0.5))))
    assert math.isnan(found[1])


def test_where_the_value_lies_beyond_the_range_nothing_rests_on_the_range():
    beyond = ACROSS.replace("100 deg{range}", "5 deg in 60 deg .. 150 deg")
    whole = ACROSS.replace("100 deg{range}", "5 deg in 0 deg .. 150 deg")
    assert mechc.loads(beyond).evaluate() == mechc.loads(whole).evaluate()


def test_where_the_stroke_goes_beyond_the_range_nothing_rests_on_the_range():
    """No pose of the stroke was looked at below 10 degrees, as if a condition were broken."""
    bar = f"{ACROSS.format(range=' in 60 deg .. 150 deg')}drive alpha from -50 deg to 100 deg\n"
    rows = mechc.loads(bar).stroke(2).rows
    expected = [1 / (0.1 * math.cos(math.radians(a - 10) / 2)) for a in (-50, 100)]
    assert [row.values[0] for row in rows] == pytest.approx([expected[0], -expected[1]])


JACK = """
param alpha = 30 deg{range}
param a = 150 mm
pivot A
slider C along y through A
link AB
link BC
link AD
link DC
AB = a @ alpha
AD = a @ 180 deg - alpha
BC = a
DC = a
assembly C forward
actuator N between D and B
force F at C along -y
find k = N/F
"""


def test_the_screw_of_a_scissor_jack_lies_across():
    jack = mechc.loads(JACK.format(range=" in 10 deg .. 70 deg"))
    assert str(jack.k) == "-cot(alpha)"
    exact = mechc.loads(JACK.format(range=""))
    for alpha in (0.2, 0.8, 2.0):
        expected = -abs(math.cos(alpha)) / math.sin(alpha)
        assert exact.evaluate(alpha=alpha)["k"] == pytest.approx(expected)


def test_a_stroke_is_no_range_that_formulas_may_count_on():
    """A plot beyond it has the sense in which the cylinder pushes there."""
    bar = mechc.loads(ACROSS.format(range="") + "drive alpha from 60 deg to 150 deg\n")
    for alpha, sense in ((2.0, -1), (-1.0, 1)):
        expected = sense / (0.1 * math.cos((alpha - math.radians(10)) / 2))
        assert bar.evaluate(alpha=alpha)["k"] == pytest.approx(expected)
