"""Sines and cosines of the angles that a description gives, whatever form the algebra has."""

import pytest

import mechc
from mechc.algebra.angle import Angle
from mechc.algebra.trigonometry import cosine, sine
from mechc.formula.rewriting import as_cofunction, rewritten
from mechc.formula.to_text import text
from mechc.pose.given_angles import Constants, GivenLines

THETA, PHI = Angle.of("theta"), Angle.of("phi")


def at(angle: Angle, degrees: int) -> Angle:
    return angle + Angle.constant(degrees)


def written(product, *lines: Angle) -> str:
    """Return a product in the angles between lines, each of them written as an arrow."""
    quarter = GivenLines({Angle(), *lines}, {Angle(), *lines}).quarter
    return text(rewritten(product.formula(), lambda whole: as_cofunction(whole, quarter)))


@pytest.mark.parametrize(
    ("degrees", "expected"),
    [
        (60, "cos(theta + pi/3)"),
        (-67, "cos(theta - 67*pi/180)"),
        (-120, "cos(theta - 2*pi/3)"),
        (100, "cos(theta + 5*pi/9)"),
        (30, "cos(theta + pi/6)"),
        (-90, "sin(theta)"),
        (180, "-cos(theta)"),
    ],
)
def test_a_component_has_the_angle_of_its_vector(degrees, expected):
    line = at(THETA, degrees)
    assert written(cosine(line), line) == expected


def test_a_projection_has_the_angle_between_two_lines():
    """A ternary link's arm at phi − 100°, projected across a rod at theta."""
    arm = at(PHI, -100)
    assert written(sine(arm - THETA), arm, THETA) == "sin(phi - theta - 5*pi/9)"
    assert written(sine(arm - THETA), at(PHI, 80), THETA) == "-sin(phi - theta + 4*pi/9)"


def test_an_angle_between_other_lines_stays_as_it_is():
    assert written(cosine(at(THETA, 20)), at(THETA, 60)) == "cos(theta + pi/9)"


def test_a_constant_angle_is_a_given_one():
    assert written(sine(Angle.constant(50)), PHI, at(PHI, 50)) == "sin(5*pi/18)"
    assert written(cosine(Angle.constant(110)), at(PHI, 110), PHI) == "cos(11*pi/18)"
    assert written(sine(Angle.constant(50)), PHI, at(PHI, 40)) == "cos(2*pi/9)"
    assert written(sine(Angle.constant(50)), Angle.constant(50)) == "sin(5*pi/18)"
    assert written(cosine(Angle.constant(43)), Angle.constant(-47)) == "sin(47*pi/180)"


def turned(degrees: int, arms=(), others=(), corners=()) -> int:
    """Return how a constant angle is turned, in degrees."""
    links, guides, turns = ([Angle.constant(a) for a in each] for each in (arms, others, corners))
    return Constants(links, links, guides, turns).quarter(degrees)


@pytest.mark.parametrize(
    ("degrees", "lines", "expected"),
    [
        (43, {"arms": [-47], "others": [0]}, -90),
        (43, {"arms": [47], "others": [90]}, -90),
        (47, {"arms": [47], "others": [90]}, 0),
        (40, {"arms": [70], "others": [20]}, -90),
        (40, {"arms": [50], "others": [10, 100]}, 0),
        (80, {"arms": [170], "others": [0]}, -90),
        (70, {"arms": [110], "others": [0]}, -90),
        (30, {"arms": [0, 60], "corners": [60]}, -90),
        (33, {"arms": [47], "others": [0]}, 0),
    ],
)
def test_a_constant_angle_is_that_of_two_lines_as_they_are_written(degrees, lines, expected):
    """An acute direction as it stands, an obtuse one by the nearest axis, else between lines."""
    assert turned(degrees, **lines) == expected


LEANING_ROD = """
mechanism m
param a = 100 mm
param phi = 30 deg in 10 deg .. 60 deg
pivot O
slider B along {guide}
link OA
link AB
OA = a @ phi
AB = @ {rod}
torque M on OA
force F at B along {guide}
find k = M/F
"""


@pytest.mark.parametrize(
    ("guide", "rod", "divisor"),
    [
        ("x", "-47 deg", "cos(47*pi/180)"),
        ("y", "43 deg", "sin(43*pi/180)"),
        ("10 deg", "-30 deg", "cos(2*pi/9)"),
        ("x", "-160 deg", "cos(pi/9)"),
    ],
)
def test_a_rod_at_an_angle_that_is_a_number_has_that_angle(guide, rod, divisor):
    text_of_rod = LEANING_ROD.format(guide=guide, rod=rod)
    found = mechc.loads(text_of_rod, "m.mech").results["k"]
    assert text(found.formula).endswith(f"/{divisor}")


FOUR_BAR = """
mechanism m
param theta = 20 deg in 5 deg .. 40 deg
pivot O at (0 mm, 0 mm)
pivot Q at (-60 mm, -12 mm)
link OA
link AK
link QK
OA = 35 mm
QK = 20 mm @ theta + 60 deg
AK = 40 mm
assembly OAK ccw
drive theta
torque M on OA
force P at K along {along}
find k = M/P
"""


@pytest.mark.parametrize("along", ["-y", "perp QK", "perp AK"])
def test_loops_are_closed_by_the_angles_of_the_links(along):
    """A force across a link, or along an axis, gives no angle of its own."""
    found = mechc.loads(FOUR_BAR.format(along=along), "m.mech").results["k"]
    definitions = {name: text(formula) for name, formula in found.where}
    assert (
        definitions["len_OK"]
        == "hypot(x_Q + len_QK*cos(theta + pi/3), len_QK*sin(theta + pi/3) + y_Q)"
    )
    assert "pi/6" not in str(definitions)


def test_equations_that_are_solved_together_have_the_given_angles():
    page = mechc.load("double_butterfly").emit("latex")
    position = page.partition("Position")[2].partition("Numerical")[0]
    assert r"\cos(\varphi_{AF}-100^\circ)" in position
    assert r"\sin(\varphi_{AF}-\varphi_{EG}-100^\circ)" in position
    assert r"10^\circ)" not in position
    assert r"20^\circ)" not in position


def test_the_angle_of_a_link_is_read_where_another_part_is_measured_from_the_y_axis():
    """An arm at 20° in its link and a rod at 90° + theta make theta - phi + 70°: 20° is given."""
    arm, rod = at(PHI, 20), at(THETA, 90)
    lines = {Angle(), arm, rod}
    quarter = GivenLines(lines, {*lines}, written=[Angle.constant(20)]).quarter
    for projection in (sine(rod - arm), cosine(THETA - arm)):
        turned = rewritten(projection.formula(), lambda whole: as_cofunction(whole, quarter))
        assert text(turned) == "cos(phi - theta + pi/9)"
