"""A derivation in brief: the formulas of a row of a table, each name stated before it is used."""

import re

import pytest

from good_mechanisms import compiled
from mechc.cli.main import main
from mechc.compilation import Compilation, emit
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.report.text.derivation import render_brief
from mechc.source import Source
from report_samples import packet_clamp
from small_mechanisms import gripper

CLAMP = """\
Packet clamp of a profile-welding machine
Karpenko, Muzyka, Shishkin 2023, fig. 9

        V_A/V_B = b/a
        V_B/V_K = cos(beta) / sin(alpha + beta)

        P = F*a/(2*b) * sin(alpha + beta) / (cos(alpha) * cos(beta))
        k = P/F = a/(2*b) * sin(alpha + beta) / (cos(alpha) * cos(beta))
"""


def brief(name, numbers=False):
    made = compiled(name)
    return render_brief(made.derivation, made.mechanism, unicode=False, numbers=numbers)


def latex(name, language="en"):
    return emit(compiled(name), TARGET, Options(name, language=language, brief=True))[0].text


def test_a_clamp_is_a_row_of_the_table():
    made = packet_clamp()
    assert render_brief(made.derivation, made.mechanism, unicode=False, numbers=False) == CLAMP


def test_numbers_are_put_in_for_results_alone():
    found = brief("jansen_leg", numbers=True).partition("Numerical values")[2]
    assert "mu_B = 34.8804 deg\n" in found
    assert "k = 49 mm * 0.731552 * cos(89.2963 deg) - " in found


def test_a_half_turn_among_angles_is_no_number_of_radians():
    """Each value that a result rests on is a value alone, 348.38°, and no sum with 3.14159."""
    source = Source(
        "four_bar.mech",
        """
        mechanism four_bar
        param phi = 40 deg
        pivot Q at (0 mm, 0 mm)
        pivot W at (-200 mm, 150 mm)
        link WV
        link VB
        link QB
        WV = 50 mm @ phi
        QB = 150 mm
        VB = 160 mm
        assembly VBQ cw
        drive phi from 10 deg to 80 deg
        torque M on WV
        torque T on QB
        find k = M/T
        """,
    )
    made = Compilation(source)
    for shown in (
        render_brief(made.derivation, made.mechanism),
        emit(made, TARGET, Options("x", brief=True))[0].text,
    ):
        assert "3.14159" not in shown
        assert "348.3819" in shown


@pytest.mark.parametrize("name", ["jansen_leg", "karpenko_fig9_with_friction"])
def test_each_name_is_stated_before_it_is_used(name):
    stated, where = {p.name for p in compiled(name).mechanism.parameters}, brief(name)
    solved = re.findall(r"^ *(\w+) = (.*)$", where, re.MULTILINE)
    defined = {left for left, _ in solved}
    for left, right in solved:
        assert set(re.findall(r"\w+", right)) & defined <= stated, left
        stated.add(left)


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
def test_a_long_chain_has_a_short_report(language):
    text = latex("jansen_leg", language)
    assert text.count("=") < 90
    assert r"\begin{enumerate}" not in text
    assert "i_{DEF}=\\frac{\\omega_{DEF}}{\\omega_{OA}}" in text


def test_angles_of_a_drawing_stand_once(tmp_path, capsys):
    path = tmp_path / "m.mech"
    path.write_text(gripper(push="y"))
    for command in (["derive"], ["compile", "--emit", "latex"]):
        assert main([*command, str(path), "--brief", "--no-cache"]) == 0
        page = capsys.readouterr().out.replace(r"\varphi_{KA}&=", "φ_KA = ")
        page = page.replace(r"\varphi_{KA}=", "φ_KA = ")
        assert page.count("φ_KA = ") == 1
