"""The derivation as the terminal shows it."""

import re
from collections.abc import Callable
from fractions import Fraction

import pytest

from good_mechanisms import compiled
from mechc.compilation import compile_source
from mechc.files import find, read
from mechc.formula.to_text import text
from mechc.formula.tree import Constant, Symbol, number, product
from mechc.report.sentences.wording import as_ratio
from mechc.report.text.character_sets import ASCII, UNICODE
from mechc.report.text.derivation import render
from mechc.report.text.printer import print_formula
from mechc.report.text.speller import LINE_COLUMNS, speller
from mechc.source import Source
from report_samples import equations, formula, packet_clamp, six_bar
from small_mechanisms import lifter


@pytest.mark.parametrize("unicode", [True, False], ids=["unicode", "ascii"])
def test_clamp_golden(unicode: bool, golden: Callable[[str, str], None]) -> None:
    clamp = packet_clamp()
    shown = render(clamp.derivation, clamp.mechanism, unicode=unicode)
    golden(f"derivation/clamp_{'unicode' if unicode else 'ascii'}.txt", shown)
    assert shown.isascii() is not unicode


@pytest.mark.parametrize(
    ("source", "unicode", "ascii_"),
    [
        (
            "2*b/a*cos(alpha)*sin(theta)/cos(alpha+theta)",
            "2b/a · cos α · sin θ / cos(α + θ)",
            "2*b/a * cos(alpha) * sin(theta) / cos(alpha + theta)",
        ),
        ("a - b*sin(deg(40))**2", "a − b · sin² 40°", "a - b * sin(40 deg)^2"),
        ("-a*(b + c)", "−a · (b + c)", "-a * (b + c)"),
        ("(b + c)/a", "(b + c) / a", "(b + c) / a"),
        ("a/(b + c)", "a / (b + c)", "a / (b + c)"),
        ("a/(b*c)", "a/(bc)", "a/(b*c)"),
        ("1/(b*c)", "1/(bc)", "1/(b*c)"),
        ("1/(b*sin(c))", "1 / (b · sin c)", "1 / (b * sin(c))"),
        ("1/(-b)", "1/(−b)", "1/(-b)"),
        ("sqrt(a**2 + l_1)", "√(a² + l₁)", "sqrt(a^2 + l_1)"),
        ("a*(b**(-1)) - 3/2", "a/b − 3/2", "a/b - 3/2"),
        ("asin(a/b)", "arcsin(a/b)", "asin(a/b)"),
        ("f*r", "f · r", "f * r"),
        ("a*f*R**2", "af · R²", "a*f * R^2"),
        ("a*f*n", "afn", "a*f*n"),
    ],
)
def test_formula_on_one_line(source: str, unicode: str, ascii_: str) -> None:
    assert print_formula(formula(source), UNICODE) == unicode
    assert print_formula(formula(source), ASCII) == ascii_


def test_a_literal_d_is_no_differential() -> None:
    """A pin's diameter that is a number has the name d: ρ = f·d/2, not df/2."""
    found = product([(Constant("d", number(Fraction(3, 250))), 1), (Symbol("f"), 1)])
    assert print_formula(found, UNICODE) == "f · d"


def test_lines_keep_to_the_width_and_break_outside_functions() -> None:
    six = six_bar()
    lines = render(six.derivation, six.mechanism).splitlines()
    assert max(map(len, lines)) <= LINE_COLUMNS
    assert all(line.count("sin(") <= line.count(")") for line in lines)


def test_a_speed_in_terms_of_one_other_reads_as_a_ratio() -> None:
    (plain, mixed, squared) = equations(
        "V_B = V_A*cot(alpha)", "V_C = V_A*V_B/l", "V_C = V_A**2/l*V_B"
    )
    assert text(as_ratio(plain).left) == "V_B/V_A"
    assert as_ratio(mixed) == mixed
    assert as_ratio(squared) == squared


def test_what_the_rule_says_is_not_said_twice() -> None:
    clamp = packet_clamp()
    assert render(clamp.derivation, clamp.mechanism).count("V_A/V_B") == 1


def test_long_equations_beside_a_wide_left_side_keep_to_the_width() -> None:
    press = compile_source(read(find("triad_press")))
    lines = render(press.derivation, press.mechanism).splitlines()
    assert max(map(len, lines)) <= LINE_COLUMNS
    assert not any(line.startswith(" " * 40) for line in lines)


def derived(name: str) -> str:
    compilation = compile_source(read(find(name)))
    return render(compilation.derivation, compilation.mechanism)


def test_table_1_by_hand() -> None:
    shown = derived("karpenko_fig1_parallel_levers")
    for line in (
        "V_B · sin α = V_A · cos α",
        "V_B/V_A = cot α",
        "V_D/V_B = OD/OB = b/a",
        "P · V_A − 2F · V_D = 0",
        "i_A = V_A/V_D = a/b · tan α",
    ):
        assert line in shown


def test_what_a_step_gives_is_reduced_to_the_drive() -> None:
    shown = derived("stephenson_six_bar")
    assert "V_A = O₁A · ω_O₁A = a · ω_O₁A" in shown
    assert "ω_ABC/ω_O₁A = " in shown


def test_a_link_that_does_not_turn_is_left_out_of_the_power() -> None:
    shown = derived("roberval_balance")
    assert "ω_ACG = 0" in shown
    assert "ω_ACG" not in shown.partition("Power equation")[2]


def test_a_long_speed_has_a_step_of_its_own() -> None:
    shown = derived("scissor_4")
    assert "V_A₄_F/V_B₀ = −4 · cot θ" in shown
    assert "P · V_B₀ + F · V_A₄_F / 2" in shown


def test_a_point_off_the_line_of_its_pivot_is_projected_on_its_load() -> None:
    shown = derived("shoe_brake")
    assert "V_S_N/V_H = −b/a" in shown
    assert "P · V_H + N · V_S_N + T · V_S_T = 0" in shown


def test_a_sum_of_lengths_does_not_vanish() -> None:
    assert "vanishes" not in derived("equalising_clamp")
    assert "vanishes when a − e = 0" in derived("differential_lever")


def test_the_angle_of_a_pole_begins_without_a_minus() -> None:
    assert "at α = 90° − θ" in " ".join(derived("karpenko_fig3_inclined_levers").split())


def test_two_components_of_a_velocity_have_two_names() -> None:
    shown = derived("scissor_4")
    assert "V_A₃_x = " in shown
    assert "V_A₃_y/V_B₀ = 3 · cot θ" in shown


def test_a_weight_is_its_mass_times_g_and_nothing_is_defined_twice() -> None:
    assert "W = mg\n        g = 9.80665 m/s²" in derived("wheelbarrow")
    clamp = derived("karpenko_fig9_packet_clamp")
    assert clamp.count("δ = 4/(πd²)") == 1


@pytest.mark.parametrize(
    ("language", "tangent", "unit"), [("uk", "tg α", "мм"), ("ru", "tg α", "мм")]
)
def test_a_derivation_is_in_the_language(language: str, tangent: str, unit: str) -> None:
    found = compile_source(read(find("karpenko_fig7_single_lever")))
    shown = render(found.derivation, found.mechanism, language=language)
    assert "tg α" in shown
    assert " мм" in shown
    words = re.sub(r"[A-Z]'?(?:_\w+)?|cos|sin|arc\w+|\d+", "", shown)
    assert len(re.findall(r"[а-яієїґ]", words)) > 20 * len(re.findall(r"[a-z]{3,}", words))


def test_lines_are_as_wide_as_asked() -> None:
    found = compile_source(read(find("crank_rocker")))
    for width in (40, 60, 110):
        shown = render(found.derivation, found.mechanism, width=width)
        prose = [line for line in shown.splitlines() if not set("=·√/(") & set(line)]
        assert width - 15 <= max(map(len, prose)) <= width


def test_a_direction_of_a_drawing_is_given_in_degrees() -> None:
    drawn = compile_source(
        Source(
            "lever.mech",
            "mechanism lever\npivot O at (0 mm, 0 mm)\nlink OAB\nA at (30 mm, 30 mm)\n"
            "B at (-20 mm, 0 mm)\nforce P at A along x\nforce F at B along y\nfind k = P/F\n",
        )
    )
    given = render(drawn.derivation, drawn.mechanism).split("\n\n")[1]
    assert "φ_OA = 45°" in given


def test_a_minus_of_angular_velocities_is_explained_where_steps_have_none() -> None:
    """Steps count them as they turn, a ratio that is asked for counts counter-clockwise."""
    found = compile_source(read(find("planetary_gear")))
    shown = render(found.derivation, found.mechanism, width=200)
    explained = "Angular velocities are positive counter-clockwise here"
    assert shown.count(explained) == 1
    assert explained in shown.partition("i_P = ")[2]


def test_a_speed_from_two_others_is_over_one_denominator() -> None:
    derivation = compile_source(read(find("equalising_clamp"))).derivation
    (found,) = (e for s in derivation.steps for e in s.results if e.left == Symbol("omega_BAC"))
    assert text(found.right) == "(V_D - V_A)/(b*cos(phi))"


@pytest.mark.parametrize(("language", "unit"), [("en", "mm"), ("uk", "мм"), ("ru", "мм")])
def test_the_stroke_is_in_the_units_of_the_language(language: str, unit: str) -> None:
    found = compiled("oscillating_cylinder")
    text = render(found.reported, found.mechanism, unicode=True, language=language)
    assert re.search(rf" 450 {unit} \w+ 900 {unit}\.", text)


@pytest.mark.parametrize(
    ("equation", "width", "lines"),
    [
        ("  k = a + b ", 15, ["    k = a + b"]),
        ("k = a + b", 9, ["  k = a +", "      b"]),
        ("k = (a + b)*c", 8, ["  k =", "      (a + b)*c"]),
        ("one\ttwo", 80, ["  one     two"]),
        ("", 80, []),
    ],
)
def test_a_line_is_broken_where_it_does_not_fit(equation, width, lines):
    spell = speller((), compiled("four_bar").mechanism, unicode=False, width=width)
    assert spell.broken(equation, "  ") == lines


def test_angles_in_radians_are_printed_in_degrees() -> None:
    lever = """
    mechanism lever
    param phi = 0.5 rad
    pivot O
    slider K along 1.5 rad
    link OAB
    link BK
    OA = 100 mm @ phi
    OB = 150 mm @ phi + 0.3 rad
    BK = @ 0.2 rad
    force P at A along phi + 1.2 rad
    force F at K along -1.5 rad
    find k = P/F
    """
    found = compile_source(Source("lever.mech", lever))
    derived = render(found.derivation, found.mechanism)
    assert "sin(φ + 5.729578°)" in derived
    assert "sin 68.754935°" in derived
    assert " 1.2" not in derived.partition("Velocities")[2].partition("Numerical")[0]


DOUBLE_PLANET = """
mechanism planet
param r1 = 40 mm
param r2 = 30 mm
param r3 = 25 mm
param r4 = 45 mm
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, 0 mm)
link OA
link QX
link AB
OA = r1 + r2 @ 30 deg
QX = r4 @ 100 deg
AB = r3 @ 60 deg
gear O r1 on ground, A r2 on AB
gear A r3 on AB, Q r4 on QX
{load}
torque T on QX
find k = {ratio}
"""


def planet_said(load: str, ratio: str) -> str:
    found = compile_source(Source("planet.mech", DOUBLE_PLANET.format(load=load, ratio=ratio)))
    return render(found.derivation, found.mechanism)


def test_a_train_is_written_in_angular_velocities() -> None:
    """Willis has ω_arm, not V_A/(r₁ + r₂): by hand r₁·ω = r₂·(ω₂ − ω)."""
    said = planet_said("torque M on OA", "M/T")
    assert "r₁ · ω_OA = r₂ · (ω_AB − ω_OA)" in said
    assert "r₃ · (ω_AB − ω_OA) = r₄ · (ω_OA − ω_QX)" in said
    assert "V_A" not in said


def test_a_force_on_the_arm_is_known_by_the_speed_of_its_point_first() -> None:
    said = planet_said("force F at A along perp OA", "F/T")
    assert "ω_OA = V_A / (r₁ + r₂)" in said
    assert "r₁ · ω_OA = r₂ · (ω_AB − ω_OA)" in said
    assert "F/T = −ω_QX/V_A" in said


def test_a_result_that_jumps_at_the_default_pose_has_both_values_among_the_numbers() -> None:
    compilation = compile_source(Source("wedge.mech", lifter()))
    shown = render(compilation.derivation, compilation.mechanism)
    low, high = next(r.sides for r in compilation.results if r.name == "k_f")
    assert f"k_f: jumps from {low:.6g} to {high:.6g}" in shown


def test_a_term_of_which_rounding_alone_is_left_is_zero_among_the_numbers() -> None:
    """|sin φ| at half a turn was 1.2e-16, and the term 8.60915·10⁻¹⁶."""
    turned = lifter(at="phi", pushed="280 deg").replace("phi = 0 deg", "phi = 180 deg")
    compilation = compile_source(Source("wedge.mech", turned))
    shown = render(compilation.derivation, compilation.mechanism)
    assert "k_f₁ = 0 + 2.53236 + 0.192065 = 2.72443\n" in shown
