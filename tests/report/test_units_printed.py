"""Units that are printed can be typed: a ratio of a force and a couple is in 1/m."""

import re

import pytest

import mechc
from mechc.cli import main
from mechc.cli.check_lines import report
from mechc.compilation import compile_source
from mechc.files import find, read
from mechc.report.text.derivation import render
from mechc.source import Source
from mechc.units import UNITS, Dimension, si_unit

LEVER = """param a = 40 mm
pivot O
link OA
OA = a @ 0 deg
torque T on OA
force F at A along -90 deg
find k = F/T
"""


@pytest.mark.parametrize("value", ["25 1/m", "0.025 1/mm", "1/(40 mm)"])
def test_a_ratio_of_a_force_and_a_couple_is_expected(value):
    lines = list(
        report(compile_source(Source("u.mech", f"{LEVER}expect k = {value} at a = 40 mm\n")), False)
    )
    assert any("agrees (25 1/m)" in line or "proved" in line for line in lines)
    assert "    = 25 1/m at the default pose" in lines


def test_a_report_says_the_unit():
    assert r"=25\,\text{m}^{-1}" in mechc.loads(LEVER, "u.mech").emit("latex")
    assert r"=25\,\text{м}^{-1}" in mechc.loads(LEVER, "u.mech").emit("latex", language="uk")


WEIGHED = """param b = 24 in
param h = 12 in
param mu = 0.5
slider A along x
slider B along x
link ABCG
AB = b @ 0 deg
AC = (0 in, h)
AG = (b/2, b)
force P at C along x
force W at G along -y
friction slider A mu
friction slider B mu
find P
let W = 120 lbf
"""


def test_forces_are_in_the_unit_that_the_description_gives_them_in():
    page = mechc.loads(WEIGHED, "u.mech").emit("latex")
    assert "60\\,\\text{lbf}" in page
    assert r"\text{N}" not in page
    in_newtons = mechc.loads(WEIGHED.replace("let W = 120 lbf", "let W = 120 N"), "u.mech")
    assert r"60\,\text{N}" in in_newtons.emit("latex")


def test_a_curve_and_its_table_have_forces_in_that_unit_too():
    ranged = WEIGHED.replace("param h = 12 in", "param h = 12 in in 2 in .. 20 in")
    page = mechc.loads(f"{ranged}report P, plot P_f over h\n", "u.mech").emit("latex")
    assert r"\mathit{P}_{\mathit{f}},\ \mathrm{lbf}$" in page
    assert r"$20$ & $60$ \\" in page


def test_a_unit_of_two_words_keeps_its_hyphen():
    """Of a negative number the sign is a minus, and the hyphen of its unit is none."""
    compilation = compile_source(Source("u.mech", WEIGHED))
    derived = render(compilation.derivation, compilation.mechanism, language="ru")
    assert "P_уд = −120 фунт-сил · 0,5 = −60 фунт-сил" in derived
    assert "фунт−сила" not in derived


CYLINDER = """param d = 30 mm in 20 mm .. 40 mm
param phi = 30 deg in 10 deg .. 60 deg
param a = 50 mm
pivot O
pivot D
slider B along x
link OA
link AB
OA = a @ phi
AB = a @ -phi
OD = d @ 0 deg
actuator P between D and B
torque M on OA
find k = P/M
"""


def test_a_reciprocal_is_one_in_sentences_of_the_terminal_too(tmp_path, capsys):
    path = tmp_path / "u.mech"
    path.write_text(CYLINDER)
    assert main(["derive", str(path), "--no-cache"]) == 0
    derived = " ".join(capsys.readouterr().out.split())
    assert "the least k is 11.547 m⁻¹, at φ = 60°" in derived
    assert "1/m" not in derived


@pytest.mark.parametrize("unit", UNITS)
def test_the_unit_printed_for_what_a_unit_measures_can_be_typed(unit):
    shown = si_unit(UNITS[unit].dimension)
    assert shown in UNITS
    assert UNITS[shown].dimension == UNITS[unit].dimension
    assert UNITS[shown].factor == 1


def test_other_dimensions_are_quotients_of_base_units():
    assert si_unit(Dimension(-2, 1)) == "kg/m^2"
    assert si_unit(Dimension(-2)) == "1/m^2"


LITERAL = """
mechanism lever
param a = 1 m
param b = 2 m
pivot O
link AOB
OA = a @ 180 deg
OB = b @ 20 deg
torque P on AOB
torque T on AOB
weight W mass 3 kg at A
let T = 5 N*m
find P
"""


def test_loads_that_are_numbers_have_their_unit() -> None:
    compilation = compile_source(Source("m.mech", LITERAL))
    said = "\n".join(report(compilation, verbose=False))
    assert "where W = 29.41995 N\n" in said
    assert "  T = 5 N*m\n" in said
    derived = render(compilation.derivation, compilation.mechanism)
    assert "W = 29.41995 N\n" in derived
    assert "T = 5 N·m " in derived
    tex = mechc.loads(LITERAL).emit("latex", language="uk").replace("&", "")
    assert r"W=29{,}41995\,\text{Н}" in tex
    assert tex.count(r"W=29{,}41995") == tex.count(r"W=29{,}41995\,\text{Н}") == 2
    assert r"$5\,\text{Н}\cdot \text{м}$" in tex  # among the quantities given


def test_lets_that_are_numbers_have_their_unit() -> None:
    text = f"{LITERAL}let d = 25 mm\nlet s = 30 deg\nlet n = 2\n"
    compilation = compile_source(Source("m.mech", text))
    derived = render(compilation.derivation, compilation.mechanism)
    assert derived.count("\nFurther quantities\n") == 1
    assert {"d = 25 mm", "s = 30°", "n = 2"} <= {line.strip() for line in derived.splitlines()}
    tex = mechc.loads(text).emit("latex")
    for shown in (r"d=25\,\text{mm}", r"s=30^\circ", "n=2"):
        assert rf"\boxed{{{shown}}}" in tex


def test_a_let_is_given_in_the_unit_that_it_names() -> None:
    named = "let F = 2 kN\nlet p = F/a^2 in MPa\nlet w = atan(T/(F*a)) in rad\nfind T\n"
    found = mechc.loads(LEVER.replace("find k = F/T\n", named), "u.mech")
    assert "    = 1.25 MPa at the default pose" in report(found._compilation, False)
    shown = render(found._compilation.derivation, found._compilation.mechanism)
    assert "p = 2 kN / (40 mm)² = 1.25 MPa" in shown
    assert "= 0.785398 rad" in shown
    assert r"1{,}25\,\text{МПа}" in found.emit("latex", language="uk")


def test_a_stroke_has_a_let_in_the_unit_that_it_names() -> None:
    rocker = read(find("crank_rocker")).text
    named = "let s = k*5 N/(3 mm^3) in MPa\n"
    stroke = compile_source(Source("r.mech", f"{rocker}\n{named}")).stroke(3)
    assert ("s", "MPa") in [(column.name, column.unit) for column in stroke.columns]


def test_a_slope_of_a_ratio_by_a_length_is_in_its_reciprocal():
    """Bars that cross off their middles have a slope too long for a formula: its value is given."""
    described = read(find("scissor_table")).text
    crossed = "".join(
        line.replace("BM = l/2", "BM = 0.45*l")
        for line in described.splitlines(keepends=True)
        if not line.startswith("expect")
    )
    table = mechc.loads(crossed)
    (line,) = (line for line in table.emit("latex").splitlines() if r"\mathrm{d} k" in line)
    slope = re.search(r"=(-[\d.]+)\\,\\text\{m\}\^\{-1\}\$\.$", line)
    assert slope
    more, less = (table.evaluate(s=0.8 + step)["k"] for step in (1e-4, -1e-4))
    assert float(slope[1]) == pytest.approx((more - less) / 2e-4, rel=1e-5)


def test_an_angle_is_no_fraction_before_its_unit() -> None:
    """Not 663/8 deg, in check, the derivation and the page."""
    text = "pivot O at (0 mm, 0 mm)\nslider K along x\nlink OA\nlink AK\nA at (10 mm, 80 mm)\n"
    text += "K at (100 mm, 80 mm)\nforce P at A along x\nforce F at K along -x\nfind k = P/F\n"
    compilation = compile_source(Source("m.mech", f"{text}let q = k*sin(phi_OA)\n"))
    assert "where phi_OA = 82.875 deg\n" in "\n".join(report(compilation, verbose=False))
    assert render(compilation.derivation, compilation.mechanism).count("φ_OA = 82.875°") == 1
    tex = mechc.loads(f"{text}let q = k*sin(phi_OA)\n").emit("latex")
    (given,) = (
        line for line in tex.splitlines() if r"$\varphi_{OA}$ &" in line and "deg" not in line
    )
    assert r"82.875^\circ" in given


@pytest.mark.parametrize(("language", "unit"), [("en", "in"), ("uk", "дюйм"), ("ru", "дюйм")])
def test_inches_are_in_the_letters_of_the_language(language, unit):
    source = LEVER.replace("param a = 40 mm", "param a = 2 in in 1 in .. 3 in")
    compilation = compile_source(Source("u.mech", source))
    shown = render(compilation.reported, compilation.mechanism, language=language)
    given = next(line for line in shown.splitlines() if line.strip().startswith("a = "))
    assert given.count(unit) == 3
    assert given.count(" in") == (3 if language == "en" else 0)
