"""Collars that take the thrust of a screw or of a pivot, by the formulas of textbooks."""

import math

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.formula.to_text import text
from mechc.source import Source

JACK = """
param p = {pitch} mm
param d = 20 mm
pivot O
link OE
OE = 10 mm @ 0 deg
slider A along x
screw A pitch p on OE
torque T on OE
force N at A along -x
{friction}
find k = T/N
"""

LEVER = """
pivot O at (0 mm, 0 mm)
link OE
OE = 10 mm @ 0 deg
slider A along x
screw A pitch {pitch} mm on OE
pivot C at (120 mm, 60 mm)
link AB
link CBD
A at (40 mm, 0 mm)
B at (110 mm, 20 mm)
D at (160 mm, 90 mm)
torque T on OE
force N at D along x
friction screw A 0.12 thread 20 mm
friction collar A 0.15 outer 40 mm inner 22 mm pressure
friction pin A 0.15 diameter 10 mm
friction pin B 0.15 diameter 10 mm on AB
friction pin C 0.15 diameter 10 mm
find k = T/N
"""


DISC = """
param W = 2 kN
pivot O
link OE
OE = 80 mm @ 90 deg
torque T on OE
force N at E along y
friction collar O 0.3 {collar}
find {asked}
"""

MIRRORED = """
pivot O at (50 mm, 0 mm)
slider K along y
link OAJ
link KA
K at (0 mm, 40 mm)
A at (30 mm, 10 mm)
J at (60 mm, 90 mm)
mirror across y sharing K
force P at K along -y
force F at J along x
friction collar O 0.3 mean 20 mm thrust F/2
find k = P/F
"""


def numbers(pitch, *friction):
    return mechc.loads(JACK.format(pitch=pitch, friction="\n".join(friction))).evaluate()


@pytest.mark.parametrize("pitch", [6, -6])
@pytest.mark.parametrize(
    ("size", "radius"),
    [
        ("mean 30 mm", 15e-3),
        ("outer 40 mm inner 24 mm", 16e-3),
        ("outer 40 mm inner 24 mm wear", 16e-3),
        ("outer 40 mm inner 24 mm pressure", 2 / 3 * (20**3 - 12**3) / (20**2 - 12**2) * 1e-3),
    ],
)
def test_a_collar_carries_the_whole_load_at_its_mean_radius(pitch, size, radius):
    """T = F·(d/2·tan(ψ ± ρ) ± μ_c·r), whatever the thread itself loses."""
    found = numbers(pitch, "friction screw A 0.12 thread d", f"friction collar A 0.15 {size}")
    psi, rho = math.atan(abs(pitch) / (math.pi * 20)), math.atan(0.12)
    hand = math.copysign(1, pitch)
    lifts = 10e-3 * math.tan(psi + rho) + 0.15 * radius
    holds = 10e-3 * math.tan(psi - rho) - 0.15 * radius
    # A left-handed thread is driven the other way: along its arrow the torque lowers the load.
    expected = (lifts, holds) if hand > 0 else (-holds, -lifts)
    assert (found["k_f"], found["k_hold"]) == pytest.approx(expected, rel=1e-12)


def test_a_collar_alone_adds_its_couple():
    found = numbers(6, "friction collar A 0.1 mean 30 mm")
    ideal = 6e-3 / (2 * math.pi)
    assert found["k_f"] == pytest.approx(ideal + 0.1 * 15e-3, rel=1e-12)
    assert found["k_hold"] == pytest.approx(ideal - 0.1 * 15e-3, rel=1e-12)


def test_free_bodies_agree_where_a_collar_hangs_together_with_pins():
    """The program solves the coupled equations; loading compares them with the free bodies."""
    found = mechc.loads(LEVER.format(pitch=6)).evaluate()
    assert found["k_f"] > found["k"] > found["k_hold"]


def test_diameters_and_coefficients_that_are_numbers_have_names():
    sizes = "friction screw A 0.12 thread 20 mm", "friction collar A 0.15 outer 40 mm inner 24 mm"
    jack = mechc.loads(JACK.format(pitch=6, friction="\n".join(sizes)))
    named = {symbol.name for symbol in jack["k_f"].free_symbols}
    assert named == {"p", "f_A", "f_A_2", "d_A", "D_A", "D_i_A"}


@pytest.mark.parametrize(
    ("collar", "arm"),
    [
        ("mean 60 mm thrust W", 30e-3),
        ("outer 80 mm inner 40 mm thrust W faces 2", 2 * 30e-3),
        ("outer 80 mm inner 40 mm pressure thrust W", 2 / 3 * (40**3 - 20**3) / 1200 * 1e-3),
    ],
)
def test_a_thrust_on_a_pivot_resists_at_the_mean_radius(collar, arm):
    found = mechc.loads(DISC.format(collar=collar, asked="T")).evaluate()
    assert (found["T_f"], found["T_hold"]) == pytest.approx((600 * arm, -600 * arm), rel=1e-12)


def test_a_thrust_may_be_a_multiple_of_a_load():
    found = mechc.loads(DISC.format(collar="mean 60 mm thrust 4*N", asked="k = T/N")).evaluate()
    assert found["k_f"] == pytest.approx(0.3 * 4 * 30e-3, rel=1e-12)


def test_both_halves_of_a_mirror_have_the_collar():
    """Half of P's power is lost on the collar of each half: P_f − P = 2·μ·(F/2)·r·ω/V_K."""
    found = mechc.loads(MIRRORED + "find omega_OAJ/V_K").evaluate()
    slip = abs(found["omega_OAJ_over_V_K"])
    assert found["k_f"] - found["k"] == pytest.approx(2 * 0.3 / 2 * 10e-3 * slip, rel=1e-9)


def test_words_of_collars_are_names_elsewhere():
    names = "collar", "mean", "outer", "wear", "pressure", "thrust", "faces"
    given = "\n".join(f"param {name} = 0.02" for name in names)
    found = numbers(6, given, f"friction screw A ({'+'.join(names)}) thread d")
    assert found["k_f"] == pytest.approx(
        10e-3 * math.tan(math.atan(6 / (20 * math.pi)) + math.atan(0.14))
    )


@pytest.mark.parametrize(
    ("given", "pitch", "coefficient", "printed"),
    [
        ("param p = 4 mm\nparam f = 0.1", "p", "f", "d*(p + pi*f*d)/(2*(pi*d - f*p)) + f_c*d_c/2"),
        (
            "param psi = 4 deg\nparam rho = 6 deg",
            "pi*d*tan(psi)",
            "tan(rho)",
            "(d*tan(psi + rho) + f_c*d_c)/2",
        ),
    ],
)
def test_a_collar_stands_next_to_the_thread(given, pitch, coefficient, printed):
    """M = Q·(r₂·tg(ψ + ρ) + f·r), and not one line under all of it."""
    friction = f"friction screw A {coefficient} thread d\nfriction collar A f_c mean d_c"
    jack = JACK.format(pitch=4, friction=friction).replace("param p = 4 mm", given)
    jack = jack.replace("pitch p", f"pitch {pitch}")
    jack = f"param d_c = 40 mm\nparam f_c = 0.15\n{jack}"
    results = compile_source(Source("jack.mech", jack)).derivation.results
    assert next(text(r.formula) for r in results if r.name == "k_f") == printed
