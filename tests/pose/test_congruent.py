"""Triangles of the same three sides: what the first one gave is that of the second one, too."""

import math

import pytest

import mechc
from mechc.algebra.product import Product
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol
from mechc.pose.loops.dyad_sides import heron, is_same_angle

R, L, S = 0.15, 0.2, 0.09

KITE = """
mechanism kite
param l = 200 mm
param s = 90 mm
param r = 150 mm
param phi = 20 deg in -40 deg .. 40 deg
pivot O at (0 mm, 0 mm)
pivot Q at ({x} mm, 10 mm)
link QA
link OB
link OC
link AB
link AC
QA = r @ phi
OB = l
AB = s
OC = {oc}
AC = {ac}
assembly OAB ccw
assembly OAC {turn}
drive phi
torque M on QA
force F at C along y
find k = M/F
"""


def k_by_coordinates(x: float, oc: float, ac: float, side: int) -> float:
    """k = −dy_C/dphi, of C as the point where two circles meet, differenced."""

    def height(phi: float) -> float:
        a = complex(x + R * math.cos(phi), 0.01 + R * math.sin(phi))
        base, foot = abs(a), (oc**2 - ac**2 + abs(a) ** 2) / (2 * abs(a))
        return ((a / base) * complex(foot, side * math.sqrt(oc**2 - foot**2))).imag

    step, phi = 1e-5, math.radians(20)
    return -(height(phi + step) - height(phi - step)) / (2 * step)


@pytest.mark.parametrize(("oc", "ac"), [("l", "s"), ("s", "l")])
@pytest.mark.parametrize("x", [30, 55])
def test_a_second_triangle_of_the_same_sides_has_the_angles_of_the_first(oc, ac, x):
    """Mirrored in their base, or turned by half a turn about its middle."""
    solved = mechc.loads(KITE.format(x=x, oc=oc, ac=ac, turn="cw"), "m.mech")
    k = solved.results["k"]
    names = {name for name, _ in k.where}
    assert "mu_C" not in names
    sizes = {"l": L, "s": S}
    expected = k_by_coordinates(x / 1000, sizes[oc], sizes[ac], -1)
    assert float(solved.evaluate()["k"]) == pytest.approx(expected, rel=1e-6)


def test_a_mirrored_direction_is_that_of_the_base_twice_less_the_other_one():
    k = mechc.loads(KITE.format(x=30, oc="l", ac="s", turn="cw"), "m.mech").results["k"]
    where = {name: text(formula) for name, formula in k.where}
    assert where["phi_AC"] == "2*phi_OA - phi_AB"
    assert [name for name in where if name.startswith("mu_")] == ["mu_B"]


def test_what_is_mirrored_in_the_diagonal_of_a_rhombus_has_the_angle_of_its_side():
    """The base is the sum of two arms of one length: twice its direction is that of the crank."""
    solved = mechc.load("peaucellier_closed")
    assert text(solved.results["k"].formula) == "r*sin(2*phi_AB - mu_B - phi)/sin(mu_B)"
    (step,) = (s for s in solved.derivation.position if s.kind == "congruent")
    assert [(name, text(formula)) for name, formula in step.definitions] == [
        ("phi_AC", "phi - phi_AB")
    ]


@pytest.mark.parametrize("phi", [20, -40, 320, 380])
def test_a_rhombus_closes_turns_further_on_too(phi):
    """P of the inversor, at c/a from O for A at a, stays on a line; k is its velocity downwards."""
    solved = mechc.load("peaucellier_closed")
    turned = math.radians(phi)
    a = 0.06 * (1 + complex(math.cos(turned), math.sin(turned)))
    p = a * (0.2**2 - 0.09**2) / abs(a) ** 2
    slope = 0.06 * complex(-math.sin(turned), math.cos(turned))
    moved = (0.2**2 - 0.09**2) * (1 / a).conjugate() ** 2 * slope.conjugate()
    assert p.real == pytest.approx((0.2**2 - 0.09**2) / 0.12)
    assert float(solved.evaluate(phi=turned)["k"]) == pytest.approx(-moved.imag)


def test_a_triangle_of_other_sides_has_angles_of_its_own():
    other = KITE.format(x=30, oc="l", ac="s", turn="cw").replace("AC = s", "AC = 80 mm")
    names = {name for name, _ in mechc.loads(other, "m.mech").results["k"].where}
    assert "mu_C" in names


def test_sides_in_another_order_make_the_same_angle():
    d, p, q = (Product.symbol(n) for n in "dpq")
    one, other = (Call("atan2", (heron(*sides), Symbol("x"))) for sides in ((d, p, q), (q, d, p)))
    assert one != other
    assert is_same_angle(one, other)
    assert not is_same_angle(one, Call("atan2", (heron(d, p, q), Symbol("y"))))
    assert not is_same_angle(one, Call("acos", (Symbol("x"),)))
