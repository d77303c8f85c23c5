"""Circular slots and spread loads, against statics by hand on coordinates."""

import math
from fractions import Fraction

import pytest

import mechc
from mechc.compilation import Compilation
from mechc.formula.tree import Number
from mechc.model.mechanism import ArcSlot, Force
from mechc.source import Source

ROCKER = """
param r = 30 mm
param R = 60 mm
param phi = 70 deg
param mu = 0.15
pivot O at (0 mm, 0 mm)
pivot D at (100 mm, 0 mm)
link OA
link DCE
{slot}
OA = r @ phi
DC = 80 mm
DE = 120 mm
angle CDE = 30 deg
assembly DCA ccw
drive phi from 40 deg to 100 deg
torque M on OA
force F at E along perp ED
find k = M / F
{more}
"""
SLOT = "slot A in DCE about C radius R"
ROD = "link CA\nCA = R"

DRAWN_STRETCH = """
pivot O at (0 mm, 0 mm)
link OAB
link AC
slider C along 0 deg
A at (20 mm, 30 mm)
B at (50 mm, 70 mm)
C at (100 mm, 0 mm)
load q intensity 3 N/mm on AB along -y
force P at C along 180 deg
find P
"""

BEAM = """
param l = 400 mm
param b = 300 mm
param phi = 30 deg
param q = 2 N/mm
param q1 = 1 N/mm
param q2 = 3 N/mm
pivot O
link OAB
OA = l @ phi
OB = b @ phi + 20 deg
{loads}
torque T on OAB
find T
find R_O
"""
SPREAD = "load Q intensity q1 to q2 on OA along -y\nload S intensity q on BO along perp OB"
AT_ENDS = """
let Q0 = l*(2*q1 + q2)/6
let QA = l*(q1 + 2*q2)/6
let S0 = q*b/2
let SB = q*b/2
force Q0 at O on OAB along -y
force QA at A on OAB along -y
force S0 at O on OAB along perp OB
force SB at B on OAB along perp OB
"""
"""What two parallel forces at the ends of each stretch put on a rigid body in its stead."""


def rocker(slot=SLOT, more=""):
    return mechc.loads(ROCKER.format(slot=slot, more=more))


def places(phi, r=0.03, big=0.06, d=0.08):
    """Return A, C, D and E: C where the circles about D and A meet on the left of DA."""
    ax, ay, dx, dy = r * math.cos(phi), r * math.sin(phi), 0.1, 0.0
    apart = math.hypot(ax - dx, ay - dy)
    along = (d * d + apart * apart - big * big) / (2 * apart)
    high = math.sqrt(d * d - along * along)
    ux, uy = (ax - dx) / apart, (ay - dy) / apart
    centre = dx + along * ux + high * uy, dy + along * uy - high * ux
    turn = math.atan2(centre[1] - dy, centre[0] - dx) + math.radians(30)
    end = dx + 0.12 * math.cos(turn), dy + 0.12 * math.sin(turn)
    return (ax, ay), centre, (dx, dy), end


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def on_the_wall(phi):
    """Return the direction from the centre to the pin, seen from the rocker."""
    a, c, d, _ = places(phi)
    from_centre, from_pivot = minus(a, c), minus(c, d)
    return math.atan2(*from_centre[::-1]) - math.atan2(*from_pivot[::-1])


def torque_by_hand(phi, mu):
    """Return M for F = 1: the wall gives the pin N along its normal and mu·|N| against its slip."""
    a, c, d, e = places(phi)
    normal = tuple(part / 0.06 for part in minus(a, c))
    slip = math.copysign(1.0, on_the_wall(phi + 1e-6) - on_the_wall(phi - 1e-6))
    back = normal[1] * slip, -normal[0] * slip
    towards = tuple(part / 0.12 for part in minus(d, e))
    load = cross(minus(e, d), (-towards[1], towards[0]))
    for sign in (1.0, -1.0):
        wall = tuple(sign * n + mu * t for n, t in zip(normal, back, strict=True))
        size = load / cross(minus(a, d), wall)
        if size > 0:
            return -size * cross(a, wall)
    return math.nan


@pytest.mark.parametrize("degrees", [45, 60, 70, 85, 97])
def test_a_circular_slot_pushes_along_the_line_to_its_centre(degrees):
    value = rocker().evaluate(phi=math.radians(degrees))["k"]
    assert value == pytest.approx(torque_by_hand(math.radians(degrees), 0.0), rel=1e-9)


@pytest.mark.parametrize("degrees", [60, 70, 85, 97])
def test_friction_acts_along_the_wall(degrees):
    found = rocker(more="friction contact A mu").evaluate(phi=math.radians(degrees))
    assert found["k_f"] == pytest.approx(torque_by_hand(math.radians(degrees), 0.15), rel=1e-6)


def test_a_slot_is_the_rod_that_takes_its_place():
    of_slot, of_rod = rocker(more="find N_CA"), rocker(ROD, "find N_CA")
    for name in ("k", "N_CA"):
        assert of_slot[name] == of_rod[name]


def test_only_what_turns_on_a_pin_has_friction_there():
    slot = rocker(more="friction pins 0.1 diameter 10 mm")
    alone = rocker(more="friction pin O 0.1 diameter 10 mm\nfriction pin D 0.1 diameter 10 mm")
    assert slot.evaluate()["k_f"] == pytest.approx(alone.evaluate()["k_f"], rel=1e-12)


def test_the_figure_has_a_groove_and_no_rod():
    figure = Compilation(Source("a.mech", ROCKER.format(slot=SLOT, more=""))).figure
    kinds = [type(part).__name__ for part in figure.parts]
    assert kinds.count("ArcSlot") == 1
    assert kinds.count("Link") == 2


def test_the_rod_knows_its_slot():
    compilation = Compilation(Source("a.mech", ROCKER.format(slot=SLOT, more="")))
    (rod,) = (link for link in compilation.mechanism.links if link.arc)
    assert (rod.name, rod.points) == ("CA", ("C", "A"))
    assert isinstance(rod.arc, ArcSlot)
    assert (rod.arc.link, rod.arc.centre) == ("DCE", "C")


def test_the_radius_of_a_slot_is_given_once():
    with pytest.raises(mechc.MechcError) as found:
        rocker(more="CA = 40 mm")
    assert [d.code for d in found.value.diagnostics] == ["E238"]


GROOVED_SLIDE = """
pivot O at (0 mm, 0 mm)
slide WX along x
link OA
slot A in WX about X radius 50 mm
W at (0 mm, 40 mm)
X at (80 mm, 60 mm)
A at (50 mm, 20 mm)
torque M on OA
force F at W along -x
find k = M/F
find N_XA
"""


def test_a_circular_slot_in_a_slide():
    # N along (-3, -4)/5 holds F along x; at A the moment of its reaction is that of M.
    found = mechc.loads(GROOVED_SLIDE).evaluate(F=1.0)
    assert found["N_XA"] == pytest.approx(-1 / 0.6, rel=1e-12)
    assert found["k"] == pytest.approx(0.05 * 4 / 3 - 0.02, rel=1e-12)


def test_a_spread_load_does_what_forces_at_its_ends_do():
    spread = mechc.loads(BEAM.format(loads=SPREAD)).evaluate()
    ends = mechc.loads(BEAM.format(loads=AT_ENDS)).evaluate()
    for name in ("T", "R_O_x", "R_O_y"):
        assert spread[name] == pytest.approx(ends[name], rel=1e-12)


def test_a_uniform_load_acts_in_the_middle():
    compilation = Compilation(Source("a.mech", BEAM.format(loads="load Q on OA along -y")))
    (load,) = (k for k in compilation.mechanism.loads if k.name == "Q")
    (link,) = compilation.mechanism.links
    assert (load.point, load.tie, link.points) == ("M", None, ("O", "A", "B", "M"))
    assert mechc.loads(BEAM.format(loads="load Q on OA along -y")).evaluate(Q=10)[
        "T"
    ] == pytest.approx(10 * 0.2 * math.cos(math.radians(30)))


def test_made_points_have_names_of_their_own():
    text = BEAM.replace("link OAB", "link OABM\nOM = 10 mm @ phi").format(loads=SPREAD)
    points = [k.point for k in Compilation(Source("a.mech", text)).mechanism.loads[:2]]
    assert points == ["M1", "M2"]


def test_a_load_over_a_drawn_stretch_has_its_exact_length():
    """0.05 − 0.02 is no 0.03 in floats: the stretch is as long as the drawing says."""
    drawn = Compilation(Source("", DRAWN_STRETCH)).mechanism
    (spread,) = (k.spread for k in drawn.loads if isinstance(k, Force) and k.spread)
    assert spread.length == Number(Fraction(1, 20))


DRAWN_AND_DRIVEN = """
pivot O at (0 mm, 0 mm)
link OAB
A at (300 mm, 100 mm)
B at (100 mm, 250 mm)
drive OA from 10 deg to 40 deg
load Q intensity 2 N/mm on AB along -y
torque M on OAB
find M
"""


def test_a_load_off_the_pivot_of_a_drawn_link_that_is_driven():
    """Its middle is at x = 200 mm, the stretch 250 mm long."""
    assert mechc.loads(DRAWN_AND_DRIVEN).evaluate()["M"] == pytest.approx(2000 * 0.25 * 0.2)


@pytest.mark.parametrize("stretch", ["AB", "BA"])
def test_a_stretch_between_points_on_one_ray_has_its_length(stretch):
    """From 100 mm to 400 mm: two triangles, with their centroids at 200 mm and 300 mm."""
    text = """
    param a = 20 deg
    pivot O
    link OAB
    OA = 100 mm @ a
    OB = 400 mm @ a
    load Q intensity 100 N/m to 300 N/m on {} along -y
    torque M on OAB
    find M
    """
    text = "\n".join(map(str.strip, text.splitlines())).format(stretch)
    first, last = (100, 300) if stretch == "AB" else (300, 100)
    ends = ((first, 0.2), (last, 0.3))  # arms of both triangles
    moment = sum(q * 0.3 / 2 * arm for q, arm in ends) * math.cos(math.radians(20))
    assert mechc.loads(text).evaluate()["M"] == pytest.approx(moment, rel=1e-12)


@pytest.mark.parametrize("word", ["radius", "load", "intensity"])
def test_new_words_are_still_names(word):
    text = f"param {word} = 30 mm\npivot O\nlink OA\nOA = {word} @ 20 deg\n"
    text += f"force P at A along y\ntorque M on OA\nlet x = 2*{word}\nfind k = M/P\n"
    assert mechc.loads(text).evaluate()["x"] == pytest.approx(0.06)
