"""A number that is rounding alone is printed as 0; one that is small is not."""

import math
import re
from fractions import Fraction
from random import Random

import pytest

from mechc.cli.check_lines import report
from mechc.compilation import compile_source, emit
from mechc.diagnostics import MechcError
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.formula.numeric.rounding import EPS, Rounding
from mechc.formula.tree import Call, Symbol, degrees, negative, number, power, product, total
from mechc.report.text.csv_of_stroke import to_csv
from mechc.report.text.stroke import to_table
from mechc.source import Source
from small_mechanisms import toggle

LEVER = """\
mechanism lever
param l = 1 m
param alpha = {angle}
pivot O
link OA
OA = l @ alpha
torque M on OA
weight W mass 3 kg at A
find M
let F2 = M/l
"""
X, Y = Symbol("x"), Symbol("y")


def default(angle: str) -> float:
    return compile_source(Source("m.mech", LEVER.format(angle=angle))).results[0].default


@pytest.mark.parametrize("angle", ["90 deg", "-90 deg", "270 deg", "450 deg", "7290 deg"])
def test_the_weight_above_the_pivot_needs_no_torque(angle):
    assert str(default(angle)) == "0.0"
    printed = "\n".join(report(compile_source(Source("m.mech", LEVER.format(angle=angle))), False))
    assert "= 0 N*m at the default pose" in printed
    assert "= 0 N at the default pose" in printed
    assert "e-1" not in printed


def test_what_is_small_but_known_stays():
    assert default("89.9999999 deg") == pytest.approx(29.41995 * math.radians(1e-7), rel=1e-6)


@pytest.mark.parametrize("turns", range(-40, 40, 7))
def test_zeros_of_sines_and_differences_are_seen(turns):
    half = Call("sin", (degrees(180 * turns),))
    assert Rounding({}).of(half).is_zero
    squares = [power(Call(f, (X,)), number(2)) for f in ("sin", "cos")]
    one = total([*squares, number(-1)])
    assert Rounding({"x": 0.1 + turns}).of(one).is_zero


def test_zero_over_zero_is_no_number():
    zero = Call("cos", (degrees(90),))
    assert math.isnan(
        Rounding({}).of(product([(zero, 1), (Call("sin", (degrees(180),)), -1)])).value
    )


@pytest.mark.parametrize("seed", range(200))
def test_the_bound_holds_the_error(seed):
    """(x + y) - x and its like, against exact sums: the error is below its bound."""
    dice = Random(seed)
    x, y = dice.uniform(-1, 1) * 10 ** dice.uniform(-6, 6), dice.uniform(-1, 1)
    found = Rounding({"x": x, "y": y}).of(
        total(
            [product([(X, 1), (Y, 1)]), X, negative(product([(X, 1), (total([Y, number(1)]), 1)]))]
        )
    )
    assert abs(found.value) <= found.error
    assert found.error <= 64 * EPS * abs(x)
    product_ = Rounding({"x": x, "y": y}).of(product([(X, 2), (Y, 1)]))
    exact = Fraction(x) ** 2 * Fraction(y)
    assert abs(Fraction(product_.value) - exact) <= Fraction(product_.error)


CRANK = "mechanism crank\n" + toggle(
    "drive alpha from 0 deg to 180 deg",
    "let F = 3 N",
    "find P",
    "find R_O",
    "find V_K/V_B",
    l="1 m",
    alpha="80 deg in 0 deg .. 180 deg",
)


def test_functions_with_poles_are_infinite_there_and_not_zero():
    for function in ("tan", "sec"):
        assert Rounding({}).of(Call(function, (degrees(90),))).is_infinite
    for function in ("cot", "csc"):
        assert Rounding({}).of(Call(function, (degrees(180),))).is_infinite
    pole = Call("tan", (degrees(90),))
    assert Rounding({}).of(Call("hypot", (pole, number(1)))).is_infinite
    assert Rounding({}).of(total([pole, number(1)])).is_infinite
    assert Rounding({}).of(total([pole, Call("sec", (degrees(270),))])).is_undetermined
    assert Rounding({}).of(product([(pole, 1), (Call("cos", (degrees(90),)), 1)])).is_undetermined
    assert Rounding({}).of(power(pole, number(-1))).is_zero


def test_a_direction_is_undetermined_of_nothing_and_no_zero_at_half_a_turn():
    zero = Call("cos", (degrees(90),))
    assert Rounding({}).of(Call("atan2", (zero, zero))).is_undetermined
    back = Rounding({}).of(Call("atan2", (zero, number(-1))))
    assert not back.is_zero
    assert abs(back.value) == pytest.approx(math.pi)


def test_rows_of_a_stroke_are_zero_infinite_or_undetermined():
    stroke = compile_source(Source("m.mech", CRANK)).stroke(5)
    named = {c.name: i for i, c in enumerate(stroke.columns)}
    start, _, middle, _, end = stroke.rows
    for row in (start, end):
        assert [str(row.values[named[n]]) for n in ("P", "R_O_x", "V_K_over_V_B")] == ["0.0"] * 3
    assert [middle.values[named[n]] for n in ("P", "R_O_x", "R_O")] == [math.inf] * 3
    assert middle.undetermined == ("R_O_direction",)
    table, values = to_table(stroke), to_csv(stroke)
    assert not re.search(r"-0(?![.\d])|e[-+]\d\d", table)
    assert re.search(r"\n +90 +infinite.*undetermined", table)
    assert ",inf," in values
    assert ",R_O_direction undetermined\n" in values
    assert [(e.result, e.kind) for e in stroke.extrema] == [("V_K_over_V_B", "minimum")]


@pytest.mark.parametrize(("rod", "code"), [("60 deg", "E507"), ("90 deg - alpha", "E508")])
def test_a_load_that_is_infinite_at_the_default_pose_is_refused(rod, code):
    """Where the rod folds onto the crank nothing determines it: that is no infinite load."""
    text = CRANK.replace("80 deg", "90 deg").replace("l @ 90 deg - alpha", f"l @ {rod}")
    with pytest.raises(MechcError, match=code) as caught:
        compile_source(Source("m.mech", text))
    assert {d.code for d in caught.value.diagnostics} == {code}


OVER = """\
mechanism over
param a = 1 m
param alpha = 90 deg
param beta = 270 deg
pivot O
link AOB
OA = a @ alpha
OB = a @ beta
force P at B along y
weight W mass 3 kg at A
find P
"""


def test_zero_over_zero_is_called_undetermined():
    compilation = compile_source(Source("m.mech", OVER))
    assert compilation.results[0].default is None
    assert "    undetermined (0/0) at the default pose" in list(report(compilation, False))
    (tex,) = emit(compilation, registry.load("latex"), Options(stem="m", language="uk"))
    assert "$P$ не визначено ($0/0$)" in tex.text


LEVER_OF_TWO = """
mechanism lever
param a = 1 m
param b = 2 m
param alpha = {angle}
pivot O
link AOB
OA = a @ 180 deg
OB = b @ alpha
force P at A along -y
force F at B along -y
{asked}
"""


@pytest.mark.parametrize("asked", ["find k = P/F", "find P\nlet F = 2 kN"])
def test_no_diagram_has_a_load_of_rounding(asked):
    source = Source("m.mech", LEVER_OF_TWO.format(angle="90 deg", asked=asked))
    (diagram,) = compile_source(source).free_bodies
    assert diagram.loads["P"] == 0
    assert diagram.loads["F"] > 0


def test_no_diagram_has_a_torque_of_rounding():
    source = LEVER.format(angle="90 deg").replace("let F2 = M/l", "")
    (diagram,) = compile_source(Source("m.mech", source)).free_bodies
    assert diagram.loads["M"] == 0
    (link,) = diagram.bodies
    assert not any(acting.moment for acting in link.forces)


def test_a_ratio_of_two_true_zeros_is_not_called_infinite():
    text = LEVER_OF_TWO.format(angle="0 deg", asked="find k = P/F")
    text = text.replace("@ 180 deg", "@ beta").replace("pivot", "param beta = 0 deg\npivot")
    (result,) = compile_source(Source("m.mech", text.replace("along -y", "along x"))).results
    assert result.undetermined
    assert result.default is None


ROUND_ANGLES = """
param t1 = 150 deg
param t2 = 45 deg
param t3 = 270 deg
pivot O
slider A along 90 deg
link AB
link OBC
AB = 89.7 mm @ t1
OB = 65.3 mm @ t2
OC = 57.1 mm @ t3
force P at A along 90 deg
force F at C along 90 deg
friction pin O 0.131 diameter 9.5 mm
find k = P/F
"""


def test_an_arm_that_is_zero_but_for_rounding_is_zero_in_a_report():
    """b_AB = -57.1 mm cos 270 deg was printed as 1.04891e-14 mm."""
    compilation = compile_source(Source("line.mech", ROUND_ANGLES))
    (document,) = emit(compilation, registry.load("latex"), Options("line"))
    assert "b_{AB}&=-57.1\\,\\text{mm}\\cos270^\\circ=0\\," in document.text


AGAINST_NOTHING = """
pivot O at (0 m, 0 m)
pivot P5 at (-0.011017087543308417 m, 0.05452346968355958 m)
param s = 0.15005477958391056 m
param r = 0.09598994917815715 m
telescope P5A4
P5A4 = s
link OA4E6
OA4 = r
OE6 = 0.10044236495153604 m
angle A4OE6 = 0.4190898615296242 rad
slot S7 in OA4
link E6S7
E6S7 = 0.04156680726650065 m
assembly OP5A4 cw
assembly S7 back
actuator M between P5 and A4
actuator F between E6 and S7
find k = M / F
drive s from 0.12005477958391056 m to 0.18005477958391056 m
param q = 0.5
friction pins 0.166*q diameter 6 mm coulomb
friction pin E6 0.15*q diameter 8 mm on E6S7
friction contact S7 0.035*q
"""


def test_forces_of_a_load_that_works_against_nothing_are_zero_in_a_report():
    """Iteration leaves 1e-60 N of them."""
    compilation = compile_source(Source("idle.mech", AGAINST_NOTHING))
    (document,) = emit(compilation, registry.load("latex"), Options("idle"))
    assert "10^{-60}" not in document.text


def test_a_load_with_friction_that_is_rounding_as_that_without_it_is_zero():
    """Through O the force F bears no load of P, and so none of the friction in A and B."""
    pins = "".join(f"friction pin {point} 0.131 diameter 9.5 mm\n" for point in "AB")
    text = ROUND_ANGLES.replace("friction pin O 0.131 diameter 9.5 mm\n", pins)
    results = {r.name: r for r in compile_source(Source("line.mech", text)).results}
    for name in ("k_f", "k_hold"):
        assert results[name].default == 0
        assert not results[name].fails_here


NO_FORCE = """
mechanism lever
pivot O
link OA
OA = 100 mm @ 0 deg
torque M on OA
torque T on OA
find k = M/T
find R_O
"""


@pytest.mark.parametrize("page", ["latex", "check"])
def test_the_direction_of_no_force_is_not_listed(page):
    compilation = compile_source(Source("m.mech", NO_FORCE))
    if page == "check":
        shown = "\n".join(report(compilation, False))
        assert "  R_O = 0\n" in shown
    else:
        shown = emit(compilation, registry.load("latex"), Options(stem="m"))[0].text
        assert "R_O&=0" in shown
    assert "atan2" not in shown
    assert "direction" not in shown.replace("in the direction", "")
