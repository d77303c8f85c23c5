"""What the model stage makes of right descriptions."""

from fractions import Fraction

import pytest

from mechc.cli.dump import dump
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError, Report
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import PI, ZERO, Constant, Number, Symbol
from mechc.model.from_syntax import resolve
from mechc.model.mechanism import (
    Absolute,
    AlongLine,
    Force,
    LoadForm,
    LoadRatio,
    Mechanism,
    Offset,
    Pivot,
    Slider,
    Speed,
    SpeedRatio,
    Torque,
)
from mechc.model.values import dependent
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.settings import attached, parse, with_settings
from mechc.units import ANGLE, FORCE, LENGTH, PRESSURE

CLAMP = """\
mechanism clamp "A clamp"
param a     = 100 mm
param b     = 2*a as "arm"
param alpha = 12 deg in 2 deg .. 40 deg
pivot  O
slider K along 90 deg
link   OBA "lever"
link   BK
OB = a @ alpha - 90 deg
OA = b @ alpha - 90 deg
force P at A along -x
force F at K along y
find  k = P / F
"""


def model(*more: str, base: str = CLAMP, name: str = "clamp.mech") -> Mechanism:
    source = Source(name, base + "".join(f"{line}\n" for line in more))
    report = Report(source)
    tree = read(source, report)
    report.stop_on_errors()
    mechanism = resolve(tree, report)
    assert not report.diagnostics, [d.message for d in report.diagnostics]
    return mechanism


def codes(*more: str, base: str = CLAMP) -> list[str]:
    source = Source("clamp.mech", base + "".join(f"{line}\n" for line in more))
    report = Report(source)
    with pytest.raises(MechcError):
        resolve(read(source, report), report)
    return [d.code for d in report.sorted()]


def test_parameters_are_in_si_and_keep_the_users_unit() -> None:
    a, b, alpha = model().parameters
    assert (a.value, a.unit, a.dimension, a.dependent) == (
        Number(Fraction(1, 10)),
        "mm",
        LENGTH,
        False,
    )
    assert (b.label, b.unit, b.dependent) == ("arm", "mm", True)
    assert b.value is not None
    assert text(b.value) == "2*a"
    assert alpha.value is not None
    assert alpha.range is not None
    assert [text(f) for f in (alpha.value, *alpha.range)] == ["pi/15", "pi/90", "2*pi/9"]


def test_degrees_are_exact() -> None:
    (offset,) = model("let z = 40 deg").lets
    assert offset.value == model("let z = 2*pi/9*1").lets[0].value
    assert offset.dimension == ANGLE


def test_definitions_need_no_order() -> None:
    mechanism = model("let q = 2*r", "let r = k*c", "param c = 3*d", "param d = 5")
    assert [let.name for let in mechanism.lets] == ["q", "r"]
    assert [p.name for p in mechanism.parameters][-2:] == ["c", "d"]


@pytest.mark.parametrize("points", ["OBA", "OA", "AO", "BAO", "AB"])
def test_links_go_by_any_two_of_their_points(points: str) -> None:
    torque = model(f"torque M on {points}").loads[-1]
    assert isinstance(torque, Torque)
    assert torque.link == "OBA"


def test_a_rod_named_exactly_comes_before_a_body_through_its_points() -> None:
    more = "link BKC\nforce R at C along x\ntorque M on KB\n"
    loads = Compilation(Source("clamp.mech", CLAMP + more)).mechanism.loads
    assert isinstance(loads[-1], Torque)
    assert loads[-1].link == "BK"


@pytest.mark.parametrize(
    ("written", "tail", "head", "quarter"),
    [
        ("OA", "O", "A", 0),
        ("-OA", "O", "A", 2),
        ("perp OA", "O", "A", 1),
        ("-perp OA", "O", "A", 3),
    ],
)
def test_directions_of_vectors(written: str, tail: str, head: str, quarter: int) -> None:
    along = model(f"force R at A along {written}").loads[-1].along  # type: ignore[union-attr]
    assert isinstance(along, AlongLine)
    assert (along.tail, along.head, along.quarter) == (tail, head, quarter)


@pytest.mark.parametrize(
    ("written", "degrees"),
    [("x", 0), ("y", 90), ("-x", 180), ("-y", -90), ("30 deg", 30), ("0", 0)],
)
def test_directions_as_angles(written: str, degrees: float) -> None:
    along = model(f"force R at A along {written}").loads[-1].along  # type: ignore[union-attr]
    assert isinstance(along, Absolute)
    assert evaluate(along.angle, {}) == pytest.approx(degrees * 3.141592653589793 / 180)


def test_an_axis_comes_before_a_parameter_of_its_name() -> None:
    along = model("param x = 5 deg", "force R at A along x", "let q = x").loads[-1].along  # type: ignore[union-attr]
    assert isinstance(along, Absolute)
    assert along.angle == ZERO


def test_pivot_with_a_place() -> None:
    mechanism = model("pivot Q at (a, -30 mm)", "link QB")
    (place,) = (g for g in mechanism.geometry if isinstance(g, Offset))
    assert (place.tail, place.head, place.x) == ("", "Q", Symbol("a"))
    assert place.y == Constant("y_Q", Number(Fraction(-3, 100)))


def test_a_guide_through_a_place_gets_a_fixed_point() -> None:
    mechanism = model("slider L along x through (0, 5 mm)", "link BL")
    assert mechanism.each(Slider)[-1].through == "L_0"
    assert mechanism.each(Pivot)[-1].point == "L_0"
    assert isinstance(mechanism.each(Pivot)[-1], Pivot)
    place = mechanism.geometry[0]
    assert isinstance(place, Offset)
    assert (place.head, place.x) == ("L_0", ZERO)
    assert place.y == Constant("y_L0", Number(Fraction(5, 1000)))


def test_weights_hang_down_by_the_standard_gravity() -> None:
    load = model("weight W mass 2 kg at A times 1/2").loads[-1]
    assert isinstance(load, Force)
    assert (load.weight, load.times) == (True, Fraction(1, 2))
    assert load.tie == Number(Fraction("19.6133"))
    assert isinstance(load.along, Absolute)
    assert text(load.along.angle) == "-pi/2"


def test_a_parameter_g_is_the_gravity() -> None:
    load = model("param g = 1.62 m/s^2", "gravity along x", "weight W mass 2 kg at A").loads[-1]
    assert load.tie is not None
    assert text(load.tie) == "2*g"


def test_ties() -> None:
    load = model("param f = 0.2", "force T = f*F at A along x").loads[-1]
    assert load.tie is not None
    assert text(load.tie) == "f*F"
    load = model("param f = 0.2", "force T = (f + 1)*F - F/2 at A along x").loads[-1]
    assert load.tie is not None


def test_finds() -> None:
    mechanism = model("find F", "find V_A / V_K", "find omega_OA / V_K", "find F/P")
    assert {f.name: f.target for f in mechanism.finds} == {
        "k": LoadRatio("P", "F"),
        "F": LoadForm("F"),
        "V_A_over_V_K": SpeedRatio(Speed("point", "A"), Speed("point", "K")),
        "omega_OA_over_V_K": SpeedRatio(Speed("link", "OBA"), Speed("point", "K")),
        "F_over_P": LoadRatio("F", "P"),
    }


def test_a_let_with_a_loads_name_is_its_value() -> None:
    (let,) = model("let F = 2 kN").lets
    assert (let.name, let.value, let.dimension) == ("F", Number(Fraction(2000)), FORCE)


def test_a_let_that_feeds_the_geometry_is_a_parameter() -> None:
    mechanism = model(
        "let gamma = 2*alpha", "let c = a/2", "let d = c", "BK = d @ gamma", "let p = P/(pi*c^2)"
    )
    dependent = {p.name: p.dependent for p in mechanism.parameters[3:]}
    assert dependent == {"gamma": True, "c": True, "d": True}
    assert [(let.name, let.dimension) for let in mechanism.lets] == [("p", PRESSURE)]


def test_chains_of_conditions_are_split_and_lets_written_out() -> None:
    mechanism = model("let s = 2*alpha", "require 0 < s <= 90 deg")
    found = [(text(r.left), r.operator, text(r.right)) for r in mechanism.requires]
    assert found == [("0", "<", "2*alpha"), ("2*alpha", "<=", "pi/2")]


@pytest.mark.parametrize(
    ("value", "tolerance"),
    [("7.1407", "1/20000"), ("-0.5", "1/20"), ("1.20e2", "1/2"), ("7", "0"), ("b/a", "0")],
)
def test_tolerance_is_half_of_the_last_digit(value: str, tolerance: str) -> None:
    (expect,) = model(f"expect k = {value} at alpha = 10 deg").expects
    assert expect.tolerance == Fraction(tolerance)
    assert evaluate(expect.at["alpha"], {}) == pytest.approx(0.17453292519943295)


def test_tolerance_is_in_the_unit_written() -> None:
    (expect,) = model("let c = 2*a", "expect c = 0.2000 m").expects
    assert expect.tolerance == Fraction(1, 20000)
    (expect,) = model("let c = 2*a", "expect c = 200.0 mm").expects
    assert expect.tolerance == Fraction(1, 20000)


def test_an_expectation_may_repeat_the_ratio() -> None:
    (expect,) = model("expect P/F = 2*b/a").expects
    assert expect.subject == "k"


def test_mirror_and_copies() -> None:
    mechanism = model("mirror across y sharing K", "copies 3 sharing K")
    assert mechanism.mirror is not None
    assert mechanism.mirror.sharing == ("K",)
    assert mechanism.copies is not None
    assert mechanism.copies.number == 3


def test_a_description_without_a_name_goes_by_its_file() -> None:
    sheet = "param a = 3\nlet b = 2*a\n"
    assert model(base=sheet, name="dir/two words.mech").name == "two_words"


def test_reserved_words_of_other_languages_are_names() -> None:
    words = ("int", "lambda", "class", "double", "begin")
    sheet = "".join(f"param {w} = 2\n" for w in words) + f"let void = {'*'.join(words)}\n"
    assert [p.name for p in model(base=sheet).parameters] == list(words)


def test_points_and_quantities_are_two_worlds() -> None:
    mechanism = model("param O = 2 mm", "let K = 2*O")
    assert mechanism.lets[0].dimension == LENGTH


def test_many_errors_are_reported_in_one_run() -> None:
    found = codes("OK = aa @ 30", "force Q at Z along x", "find q = P / G", "let u = a + alpha")
    assert found == ["E201", "E222", "E202", "E282", "E220"]


def test_what_uses_a_wrong_definition_stays_quiet() -> None:
    assert codes("param c = a + alpha", "let u = 2*c", "let v = u + a", "BK = c @ u") == ["E220"]


def test_an_error_shows_both_places() -> None:
    source = Source("x.mech", CLAMP + "let u = alpha + a\n")
    report = Report(source)
    with pytest.raises(MechcError) as caught:
        resolve(read(source, report), report)
    (error,) = caught.value.diagnostics
    other, *declared = error.related
    assert error.span is not None
    assert source.text[error.span.start : error.span.end] == "a"
    assert source.text[other.span.start : other.span.end] == "alpha"
    assert other.message == "this is an angle (deg)"
    lines = [source.text[d.span.start - len("param ") : d.span.end] for d in declared]
    assert lines == ["param alpha", "param a"]


def test_a_point_inside_a_word_is_marked_itself() -> None:
    source = Source("x.mech", CLAMP + "OZ1 = a\n")
    report = Report(source)
    with pytest.raises(MechcError) as caught:
        resolve(read(source, report), report)
    span = caught.value.diagnostics[0].span
    assert span is not None
    assert source.text[span.start : span.end] == "Z1"


def test_both_notations_mean_the_same() -> None:
    yaml = """\
mechanism: clamp
title: A clamp
params:
  a: 100 mm
  b: {value: 2*a, label: arm}
  alpha: {value: 12 deg, range: 2 deg .. 40 deg}
pivots: [O]
sliders: {K: 90 deg}
links: {OBA: lever, BK: ""}
geometry:
  OB: a @ alpha - 90 deg
  OA: b @ alpha - 90 deg
forces:
  P: {at: A, along: -x}
  F: {at: K, along: y}
find: {k: P / F}
"""
    assert dump("model", model(base=yaml, name="clamp.yaml")) == dump("model", model())


def test_pi_is_exact() -> None:
    assert model("let c = pi").lets[0].value == PI


@pytest.mark.parametrize(("setting", "message"), [("alpha=30", "30 what?"), ("a=2deg", "'a': exp")])
def test_a_setting_measures_what_the_file_says(setting: str, message: str) -> None:
    """The command line must not turn 30 degrees into 30 radians."""
    given = dict([parse(setting)])
    source = attached(Source("clamp.mech", CLAMP), given)
    report = Report(source)
    tree = with_settings(read(source, report), given, source)
    with pytest.raises(MechcError, match=message) as caught:
        resolve(tree, report)
    assert len(caught.value.diagnostics) == 1


def test_what_follows_from_other_parameters_alone_is_dependent() -> None:
    """A number follows from nothing, and neither does a name without a value."""
    mechanism = resolve(
        read(Source("m.mech", CLAMP), Report(Source("", ""))), Report(Source("", ""))
    )
    assert {name: text(formula) for name, formula in dependent(mechanism).items()} == {"b": "2*a"}
