"""Ropes and bands that slide around pulleys, by Euler's formula as textbooks write it."""

import math

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.formula.to_text import text
from mechc.source import Source
from small_mechanisms import mirrored_rope

CAPSTAN = """
param mu = 0.3 in 0.1 .. 0.5
pivot B
slider A along y
slider H along -90 deg
rope A, B along y, H along -90 deg
force P at H along -90 deg
force F at A along -y
friction rope B mu wrap {wrap} deg
find k = P/F
"""

TWO_DRUMS = """
pivot B
pivot C
slider A along y
slider H along -y
rope A, B along y, C along x, H along -y
force P at H along -y
force F at A along -y
friction rope B 0.2 wrap 90 deg
friction rope C 0.3 wrap 90 deg
find k = P/F
"""

BRAKE = """
param mu = 0.25 in 0.1 .. 0.4
pivot O at (0 mm, 0 mm)
pivot E at (-200 mm, -400 mm)
link OG
link EACB
OG = 100 mm @ 0 deg
EA = {near} mm @ {way} deg
EC = {far} mm @ 0 deg
EB = 700 mm @ 0 deg
rope A, O along 90 deg, C along -90 deg
torque M on OG
force P at B along -y
friction rope O mu wrap -180 deg drum 400 mm on OG
find M
"""

SHARED = mirrored_rope("friction rope B 0.25 wrap 160 deg")


def numbers(text, **values):
    return mechc.loads(text).evaluate(**values)


@pytest.mark.parametrize("wrap", [180, -180, 540])
@pytest.mark.parametrize("mu", [0.1, 0.4])
def test_tensions_are_to_each_other_as_in_eulers_formula(wrap, mu):
    found, ratio = numbers(CAPSTAN.format(wrap=wrap), mu=mu), math.exp(mu * math.radians(abs(wrap)))
    assert (found["k_f"], found["k_hold"]) == pytest.approx((ratio, 1 / ratio), rel=1e-12)


def test_ratios_of_pulleys_one_behind_the_other_multiply():
    found, ratio = numbers(TWO_DRUMS), math.exp((0.2 + 0.3) * math.pi / 2)
    assert (found["k_f"], found["k_hold"]) == pytest.approx((ratio, 1 / ratio), rel=1e-12)


def test_both_halves_of_a_mirror_have_the_pulley():
    found, ratio = numbers(SHARED), math.exp(0.25 * math.radians(160))
    ideal = 1 / (2 * math.cos(math.radians(20)))
    assert (found["k_f"], found["k_hold"]) == pytest.approx((ideal * ratio, ideal / ratio))


@pytest.mark.parametrize(("near", "far"), [(50, 450), (-50, 350)])
def test_a_differential_band_brake_has_both_ends_on_its_lever(near, far):
    """Moments about the fulcrum: P·l = T·far + t·near with T/t = e^(μπ), and M = (T − t)·r."""
    way = 0 if near > 0 else 180
    found = numbers(BRAKE.format(near=abs(near), far=far, way=way), P=100.0)
    ratio, load = math.exp(0.25 * math.pi), 100 * 700
    ccw, cw = load / (far * ratio + near), load / (near * ratio + far)
    assert found["M_f"] == pytest.approx(0.2 * ccw * (ratio - 1), rel=1e-12)
    assert found["M_hold"] == pytest.approx(-0.2 * cw * (ratio - 1), rel=1e-12)


def test_a_band_cannot_push():
    with pytest.raises(mechc.MechcError, match="would have to push"):
        mechc.loads(BRAKE.format(near=50, far=450, way=0).replace("along -y", "along y"))


def test_a_rope_may_be_wound_several_times():
    """Turns beyond one are no slip of radians for degrees there (W245)."""
    text = "param theta = 900 deg" + CAPSTAN.replace("{wrap} deg", "theta")
    assert not compile_source(Source("capstan.mech", text)).report.diagnostics


def test_words_of_ropes_are_names_elsewhere():
    named = CAPSTAN.replace("param mu = 0.3", "param drum = 0.1\nparam wrap = 0.2\nparam mu = 0.3")
    found = numbers(named.format(wrap=180).replace("find k", "let c = drum + wrap\nfind k"))
    assert found["c"] == pytest.approx(0.3)


def test_the_diameter_of_a_drum_has_a_name():
    """M = W d (e^(f π) − 1)/2: 600 mm is no 6/10 of a force."""
    drum = mechc.loads(
        "pivot O\npivot B\nlink OE\nslider A along -y\nOE = 300 mm @ 0 deg\n"
        "rope A, O along y, B along -y\ntorque M on OE\nweight W mass 40 kg at A\n"
        "friction rope O 0.3 wrap -180 deg drum 600 mm on OE\nfind M\n"
    )
    assert text(drum.results["M_f"].formula) == "W*d_O*(exp(pi*f_O) - 1)/2"
    assert drum.results["M_f"].default == pytest.approx(184.325683, rel=1e-8)


BLOCK = """
param mu = 0.25 in 0.1 .. 0.4
pivot D at (0 mm, 400 mm)
pivot G at (100 mm, 400 mm)
slider K along y
slider H along x
rope G, K along -y, D along y, H along x
friction rope K mu wrap 180 deg
friction rope D mu wrap -90 deg
force W at K along -y
force P at H along x
find k = P/W
"""


def formulas(description):
    return {r.name: text(r.formula) for r in compile_source(Source("r.mech", description)).results}


def test_coefficients_of_two_wraps_are_not_multiplied_out_to_first_order():
    first, second = "(exp(pi*mu) - 1)/(2*(1 + exp(pi*mu)))", "(exp(pi*mu/2) - 1)/(1 + exp(pi*mu/2))"
    assert formulas(BLOCK)["k_f1"] == f"1/2 + {first} + {second}"


def test_a_power_of_an_exponential_is_one():
    straight = BLOCK.replace("-90", "180").replace("along x", "along -y")
    assert formulas(straight)["k_f"] == "exp(2*pi*mu)/(1 + exp(pi*mu))"
