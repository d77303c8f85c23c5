"""E309: where in the stroke a loop can be closed that does not close at the default pose."""

import math

import mpmath
import pytest

import mechc
import small_mechanisms
from mechc.diagnostics.open_loops import AssemblyRange, cannot_assemble
from mechc.formula.evaluate import evaluate
from mechc.source import Span
from mechc.units import ANGLE

SLIDER = """
param a = 100 mm
param l = 60 mm
param e = 20 mm
param phi = 90 deg
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, e)
slider B along {along} through Q
link OA
link AB
OA = a @ phi
AB = l
assembly B forward
drive phi from -180 deg to 180 deg
torque M on OA
force F at B along -x
find k = M/F
"""

LADDER = """
param a = 100 mm
param b = 90 mm
param e = 50 mm
param s = 350 mm
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, e)
slider A along x through O
link AB
link QB
OA = s @ x
AB = a
QB = b
assembly ABQ cw
drive s from 10 mm to 400 mm
force P at A along x
torque M on QB
find k = P/M
"""


def four_bar(a=80, b=40, c=90, d=110, phi=150, low=0, high=360, place="(d, 0 mm)", crank="phi"):
    sides = {name: f"{side} mm" for name, side in zip("abcd", (a, b, c, d), strict=True)}
    drive = f"from {low} deg to {high} deg"
    pose = {"phi": f"{phi} deg", "drive": drive, "pivots": ("O1", "O2")}
    text = small_mechanisms.four_bar("find k = M/T", **sides, **pose)
    return text.replace("(d, 0 mm)", place).replace("a @ phi", f"a @ {crank}")


def limits(a, b, c, d):
    """Return the crank's angle with the coupler and rocker folded, and stretched."""
    return [math.acos((a * a + d * d - s * s) / (2 * a * d)) for s in (b - c, b + c)]


@pytest.fixture
def refused(monkeypatch):
    """Return the stretches that E309 names for a description, their ends, and the message."""

    def run(text):
        seen = []

        def spy(at, loop, drive, stretches, *more, words=cannot_assemble):
            seen.extend(stretches)
            return words(at, loop, drive, stretches, *more)

        monkeypatch.setattr("mechc.diagnostics.open_loops.cannot_assemble", spy)
        with pytest.raises(mechc.MechcError) as caught:
            mechc.loads(text, "test.mech")
        (stated,) = [d for d in caught.value.diagnostics if d.code == "E309"]
        ends = [end for stretch in dict.fromkeys(seen) for end in (stretch.low, stretch.high)]
        return ends, stated

    return run


def test_a_four_bar(refused):
    ends, stated = refused(four_bar())
    near, far = limits(80, 40, 90, 110)
    expected = [near, far, 2 * math.pi - far, 2 * math.pi - near]
    assert ends == pytest.approx(expected, abs=1e-14)
    assert "phi ends at acos((" in stated.hint


@pytest.mark.parametrize(
    ("crank", "back"),
    [
        ("90 deg - phi", lambda x: math.pi / 2 - x),
        ("phi + 10 deg", lambda x: x - math.radians(10)),
        ("2*phi", lambda x: x / 2),
    ],
)
def test_a_four_bar_whose_crank_is_measured_otherwise(refused, crank, back):
    ends, _ = refused(four_bar(phi=-60 if "-" in crank else 75, low=-80, high=85, crank=crank))
    near, far = limits(80, 40, 90, 110)
    for end in ends:
        if end not in (math.radians(-80), math.radians(85)):
            assert min(abs(end - back(s * x)) for x in (near, far) for s in (1, -1)) < 1e-12


def test_a_four_bar_on_a_frame_that_lies_aslant(refused):
    ends, _ = refused(four_bar(place="(d*cos(0.3 rad), d*sin(0.3 rad))", high=180))
    expected = [x + 0.3 for x in limits(80, 40, 90, 110)]
    assert ends == pytest.approx(expected, abs=1e-12)


def test_a_four_bar_that_closes_nowhere(refused):
    ends, stated = refused(four_bar(c=10, d=310))
    assert not ends
    assert "nor anywhere along phi" in stated.message


@pytest.mark.parametrize("along", ["x", "-x", "180 deg"])
def test_a_rod_that_does_not_reach_its_guide(refused, along):
    """a·sin φ = e ± l."""
    ends, _ = refused(SLIDER.format(along=along))
    low, high = math.asin((20 - 60) / 100), math.asin((20 + 60) / 100)
    expected = [-math.pi, -math.pi - low, low, high, math.pi - high, math.pi]
    assert ends == pytest.approx(expected, abs=1e-14)


def test_a_guide_that_lies_aslant(refused):
    """The height above a guide at angle t is a·sin(φ − t) − e·cos t."""
    ends, _ = refused(SLIDER.format(along="10 deg").replace("phi = 90", "phi = 100"))
    turn, height = math.radians(10), 20 * math.cos(math.radians(10))
    low, high = (turn + math.asin((height + s * 60) / 100) for s in (-1, 1))
    expected = [-math.pi, 2 * turn - math.pi - low, low, high, math.pi + 2 * turn - high, math.pi]
    assert ends == pytest.approx(expected, abs=1e-12)


def test_a_drive_that_is_a_length(refused):
    """s² + e² = (a + b)²; a stroke's other end is its own."""
    ends, _ = refused(LADDER)
    assert ends == pytest.approx([0.01, math.sqrt(0.19**2 - 0.05**2)], abs=1e-15)


def test_a_second_loop_whose_limit_the_first_one_carries(refused):
    """The rocker may turn to where rod and second rocker are stretched; then back to the crank."""
    a, b, c, d, e = 40.0, 120.0, 80.0, 100.0, 150.0
    text = four_bar(a, b, c, d, 200).replace(
        "torque T on O2B",
        f"""
param e = {e} mm
pivot O3 at (d + e, 0 mm)
link BC
link O3C
BC = 60 mm
O3C = 95 mm
assembly BCO3 ccw
torque T on O3C
""",
    )
    psi = math.acos((c * c + e * e - 155**2) / (2 * c * e))
    bx, by = d + c * math.cos(psi), c * math.sin(psi)
    side = math.hypot(bx, by)
    turn = math.acos((side**2 + a * a - b * b) / (2 * side * a))
    expected = [math.atan2(by, bx) + s * turn for s in (1, -1)]
    ends, stated = refused(text)
    assert "O3-C-B-O2" in stated.message
    inner = [x for x in ends if x not in (0, 2 * math.pi)]
    assert len(inner) == 2
    for x in inner:
        assert min(abs(math.remainder(x - y, 2 * math.pi)) for y in expected) < 1e-12


# ------------------------------------------------------------------------------ class III

TRIAD = """
param a   = 60 mm
param phi = 170 deg
pivot O at (0 mm, 0 mm)
pivot Q at (200 mm, 0 mm)
pivot R at (100 mm, 200 mm)
link OA
link AB
link BCD
link QC
link RD
OA        = a @ phi
AB        = 60 mm
BC        = 80 mm
BD        = 80 mm
angle CBD = 60 deg
QC        = 90 mm
RD        = {rod} mm
assembly CBA cw
drive phi from -180 deg to 180 deg
torque M on OA
force F at C along perp CQ
find k = M/F
"""


def singular_poses(place, start):
    """Return φ at which the loops close and their determinant is zero, to thirty digits."""

    def equations(t, b, g, h, phi):
        pin = 60 * mpmath.expj(phi) + 60 * mpmath.expj(t)
        first = pin + 80 * mpmath.expj(b) - 200 - 90 * mpmath.expj(g)
        turned = b + mpmath.pi / 3
        second = pin + 80 * mpmath.expj(turned) - mpmath.mpc(100, 200) - 70 * mpmath.expj(h)
        matrix = mpmath.matrix(
            [
                [f(60 * mpmath.expj(t + q)), f(80 * mpmath.expj(x + q)), *last]
                for x, which in ((b, 0), (turned, 1))
                for f in (mpmath.re, mpmath.im)
                for last in (
                    [
                        -f(90 * mpmath.expj(g + q)) * (which == 0),
                        -f(70 * mpmath.expj(h + q)) * which,
                    ],
                )
            ]
        )
        return [first.real, first.imag, second.real, second.imag, mpmath.det(matrix)]

    q = mpmath.pi / 2
    with mpmath.workdps(30):
        return mpmath.findroot(equations, [*start, place])[4]


def test_a_group_of_class_three(refused):
    """The ends are where crank, rods and ternary link are singular: three rods meet in a point."""
    ends, stated = refused(TRIAD.format(rod=70))
    assert len(ends) == 2
    close = mechc.loads(TRIAD.format(rod=70).replace("170 deg", "70 deg"), "test.mech")

    pose = close._compilation.pose
    for end in ends:
        inside = end + math.copysign(2e-3, 1 - end)
        values = {"a": 0.06, "phi": inside}
        for name, formula in pose.definitions:
            values[name] = evaluate(formula, values)
        start = [values[n] for n in ("phi_AB", "phi_BC", "phi_QC", "phi_RD")]
        assert float(singular_poses(end, start)) == pytest.approx(end, abs=1e-12)
    assert "it closes for phi from -5 to 99 deg" in stated.message


@pytest.mark.slow
def test_a_group_of_class_three_that_closes_nowhere(refused):
    ends, stated = refused(TRIAD.format(rod=20).replace("QC        = 90", "QC = 20"))
    assert not ends
    assert "nor anywhere along phi" in stated.message


def test_a_loop_that_closes_at_one_value_alone_is_said_to_be_held():
    stretch = AssemblyRange(math.radians(44.907), math.radians(44.907) + 1e-12, ANGLE)
    stated = cannot_assemble(Span(0, 1), "O-A-B", "phi", [stretch])
    assert stated.message.endswith("it closes for phi at 44.907 deg alone")
    assert stated.hint == "phi cannot move the loop: leave a length or an angle of it open"
