"""Gears, belts, racks and screws: formulas by hand, conventions of sign, and laws."""

import math
from typing import Any

import pytest

import mechc
from mechc.compilation import Compilation, compile_source
from mechc.formula.to_text import text
from mechc.report.kinds import StepRule
from mechc.routine.evaluate import evaluate
from mechc.source import Source

PAIR = """
param r = 20 mm
param R = 50 mm
pivot O
pivot Q
link OA
link QB
OA = 40 mm @ 0 deg
QB = 40 mm @ 0 deg
{pair}
torque M on OA
torque T on QB
find q = omega_QB/omega_OA
find k = M/T
"""

RIM = """
param r = 30 mm
param theta = {theta} deg
pivot O
slider A along theta
link OE
OE = r @ theta - 90 deg
rack A on O r
force P at E along theta
force F at A along theta + 180 deg
find k = P/F
find v = V_A/V_E
"""

SCREW = """
param p = 4 mm in 2 mm .. 6 mm
param R = 100 mm in 80 mm .. 120 mm
pivot S
slider A along 25 deg
link SH
SH = R @ 0 deg
screw A pitch {pitch} on SH
force P at H along y
force F at A along 25 deg
find k = P/F
find v = V_A/omega_SH
"""

JAW = """
param r = 24 mm
param b = 100 mm
param psi = 20 deg
slider A along x
pivot O
link OD
rack A on O r
OD = b @ psi
"""

BOTH_JAWS = """
pivot Q
link QE
rack A on Q -r
QE = b @ -psi
force P at A along x
force N at D along -y
force H = N at E along y
find n = N/P
"""


def compiled(text: str) -> Compilation:
    compilation = compile_source(Source("a.mech", text))
    assert compilation.verdict.agrees
    assert compilation.verdict.trials
    return compilation


def formulas(source: str) -> dict[str, str]:
    return {r.name: text(r.formula) for r in compiled(source).derivation.results}


def values(source: str) -> dict[str, float]:
    functions = compiled(source).routine.functions
    return {f.name: float(evaluate(f, {i.name: i.default for i in f.inputs})) for f in functions}


# ------------------------------------------------------------------------ pairs of wheels


@pytest.mark.parametrize(
    ("pair", "speeds"),
    [
        ("gear O r, Q R", "-r/R"),
        ("gear O r, Q R inner", "r/R"),
        ("belt O r, Q R", "r/R"),
        ("belt O r, Q R crossed", "-r/R"),
    ],
)
def test_which_way_the_second_wheel_turns(pair: str, speeds: str) -> None:
    found = formulas(PAIR.format(pair=pair))
    assert found["q"] == speeds
    # M omega + T omega' = 0
    assert found["k"] == (speeds[1:] if speeds[0] == "-" else f"-{speeds}")


@pytest.mark.parametrize("pair", ["gear Q R, O r", "belt Q R, O r crossed"])
def test_wheels_may_be_named_in_either_order(pair: str) -> None:
    assert formulas(PAIR.format(pair=pair))["q"] == "-r/R"


def test_teeth_stand_for_radii() -> None:
    module = "param m = 2 mm\nparam z1 = 18\nparam z2 = 45\n"
    plain = PAIR.format(pair="gear O m*z1/2, Q m*z2/2")
    named = PAIR.format(pair="gear O r1, Q r2") + "param r1 = m*z1/2\nlet r2 = m*z2/2\n"
    assert formulas(module + plain)["q"] == "-z1/z2"
    assert formulas(module + named)["q"] == "-z1/z2"


def train(stages: int, word: str) -> str:
    """Return a train of equal stages, each with a wheel of r and one of R on the next axle."""
    lines = ["param r = 20 mm", "param R = 50 mm"]
    for i in range(stages + 1):
        lines += [f"pivot O{i}", f"link O{i}A{i}", f"O{i}A{i} = 40 mm @ {7 * i} deg"]
    lines += [f"{word} O{i} r, O{i + 1} R" for i in range(stages)]
    lines += ["torque M on O0A0", f"torque T on O{stages}A{stages}", "find k = M/T"]
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("stages", [1, 2, 3, 8])
@pytest.mark.parametrize(("word", "sense"), [("gear", -1), ("belt", 1)])
def test_train(stages: int, word: str, sense: int) -> None:
    found = values(train(stages, word))["k"]
    assert found == pytest.approx(-((sense * 0.4) ** stages), rel=1e-13)


def test_train_is_a_power() -> None:
    assert formulas(train(8, "belt"))["k"] == "-r^8/R^8"


def test_a_train_of_two_hundred_gears_does_not_underflow() -> None:
    """r^200 alone, of 20 mm, is less than the least double."""
    made = mechc.loads(train(200, "gear"), "train.mech")
    assert made.evaluate()["k"] == pytest.approx(-(0.4**200), rel=1e-12)
    assert made.evaluate(r=0.0475)["k"] == pytest.approx(-(0.95**200), rel=1e-12)
    assert not [d for d in made.warnings if d.code == "W503"]
    assert formulas(train(200, "gear"))["k"] == "-(r/R)^200"


def test_a_long_train_in_code() -> None:
    code: dict[str, Any] = {}
    exec(mechc.loads(train(200, "belt"), "train.mech").emit("python"), code)
    assert code["k"](0.0475, 0.05) == pytest.approx(-(0.95**200), rel=1e-12)


def test_an_idler_only_reverses() -> None:
    idle = PAIR.format(pair="gear O r, S 3*r\ngear S 3*r, Q R")
    extra = "pivot S\nlink SC\nSC = 40 mm @ 0 deg\n"
    assert formulas(extra + idle)["q"] == "r/R"


@pytest.mark.parametrize(
    ("pair", "place", "codes"),
    [
        ("gear O r, Q R", "(42 mm, 56 mm)", []),
        ("gear O r, Q R", "(42 mm, 55 mm)", ["W302"]),
        ("gear O r, Q R inner", "(18 mm, -24 mm)", []),
        ("gear O R, Q r inner", "(18 mm, -24 mm)", []),
        ("gear O r, Q R inner", "(42 mm, 56 mm)", ["W302"]),
        ("belt O r, Q R", "(300 mm, 0)", []),
    ],
)
def test_gears_that_do_not_reach_one_another(pair: str, place: str, codes: list[str]) -> None:
    placed = PAIR.replace("pivot O\n", "pivot O at (0, 0)\n")
    placed = placed.replace("pivot Q\n", f"pivot Q at {place}\n")
    found = compiled(placed.format(pair=pair)).report.diagnostics
    # A negative k is remarked on as well, for wheels that turn alike.
    assert [d.code for d in found if d.code != "W502"] == codes


# ------------------------------------------------------------------------- racks, screws


@pytest.mark.parametrize("theta", [0, 35, 90, 200, 310])
def test_a_rack_moves_with_the_point_of_the_rim_on_the_right(theta: int) -> None:
    assert formulas(RIM.format(theta=theta)) == {"k": "1", "v": "1"}


def test_a_negative_radius_puts_the_rack_on_the_left() -> None:
    left = RIM.format(theta=35).replace("theta - 90 deg", "theta + 90 deg")
    left = left.replace("rack A on O r", "rack A on O -r")
    found = values(left.replace("P at E along theta", "P at E along theta + 180 deg"))
    # E now moves backwards as the wheel turns counter-clockwise, and the rack with it.
    assert found == pytest.approx({"k": -1.0, "v": -1.0}, rel=1e-13)


@pytest.mark.parametrize(("pitch", "sign"), [("p", ""), ("-p", "-")], ids=["right", "left"])
def test_screw(pitch: str, sign: str) -> None:
    found = formulas(SCREW.format(pitch=pitch))
    assert found["v"] == f"{sign}p/(2*pi)"
    assert found["k"] == f"{'' if sign else '-'}p/(2*pi*R)"


def test_pi_does_not_hide_what_a_result_rises_with() -> None:
    force = next(r for r in compiled(SCREW.format(pitch="-p")).derivation.results if r.name == "k")
    assert force.trends == {"p": "rises", "R": "falls"}
    assert {n: text(f) for n, f in (force.derivatives or {}).items()} == {
        "p": "1/(2*pi*R)",
        "R": "-p/(2*pi*R^2)",
    }


def test_a_rack_may_be_part_of_a_sliding_body() -> None:
    on_slider = JAW + "force P at A along x\nforce N at D along -y\nfind n = N/P\n"
    on_body = on_slider.replace("slider A along x", "slide AB along x").replace("P at A", "P at B")
    assert formulas(on_body) == formulas(on_slider) == {"n": "r/(b*cos(psi))"}


# --------------------------------------------------------------------- halves, branches


def test_a_mirrored_half_is_the_whole_written_out() -> None:
    half = JAW + "force P at A along x\nforce N at D along -y\nfind n = N/P\n"
    half += "mirror across x sharing A\n"
    assert formulas(half) == formulas(JAW + BOTH_JAWS) == {"n": "r/(2*b*cos(psi))"}


def test_mirrored_gears_written_out() -> None:
    # The rack turns O, O turns Q; below the line the same with all turning the other way.
    upper = JAW.replace("OD = b @ psi", "OD = 10 mm @ 0 deg").replace("b = 100 mm", "b = 60 mm")
    upper += "pivot S\nlink SG\nSG = b @ psi\ngear O 2*r, S r\n"
    loads = "force P at A along x\nforce N at G along y\n"
    lower = "pivot Q\nlink QE\nQE = 10 mm @ 0 deg\nrack A on Q -r\n"
    lower += "pivot T\nlink TH\nTH = b @ -psi\ngear Q 2*r, T r\nforce L = N at H along -y\n"
    find = "find n = N/P\n"
    mirrored = formulas(upper + loads + "mirror across x sharing A\n" + find)
    assert mirrored == formulas(upper + loads + lower + find) == {"n": "r/(4*b*cos(psi))"}


def test_copies_share_the_rack() -> None:
    branch = JAW + "copies 3 sharing A\nforce P at A along x\nforce N at D along -y\nfind n = N/P\n"
    assert formulas(branch) == {"n": "r/(3*b*cos(psi))"}


# ------------------------------------------------------------------------- derivations


@pytest.mark.parametrize(
    ("source", "rule"),
    [
        (PAIR.format(pair="gear O r, Q R"), StepRule.GEAR),
        (PAIR.format(pair="belt O r, Q R"), StepRule.BELT),
        (RIM.format(theta=10), StepRule.RACK),
        (SCREW.format(pitch="p"), StepRule.SCREW),
    ],
    ids=["gear", "belt", "rack", "screw"],
)
def test_the_derivation_names_the_rule(source: str, rule: StepRule) -> None:
    assert rule in {step.rule for step in compiled(source).derivation.steps}


def test_lengths_scale_away_and_radii_with_them() -> None:
    small = values(JAW + BOTH_JAWS)["n"]
    large = values((JAW + BOTH_JAWS).replace(" mm", "0 mm"))["n"]
    assert small == pytest.approx(large, rel=1e-14)
    assert small == pytest.approx(0.024 / (0.2 * math.cos(math.radians(20))), rel=1e-14)
