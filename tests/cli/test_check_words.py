"""``mechc check`` in three languages, and its lines on a terminal."""

import re
from collections.abc import Callable
from itertools import takewhile
from pathlib import Path

import pytest

import good_mechanisms
from mechc.cli import main
from mechc.cli.check_lines import report
from mechc.report.languages import registry
from mechc.statics.verdict import UNJUDGED, WITHOUT_FORCES
from mechc.syntax.vocabulary import LANGUAGES
from paths import CORPUS, EXAMPLES

Run = Callable[..., str]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """Return a function that gives what mechc prints."""

    def call(*arguments: str) -> str:
        assert main(arguments) == 0
        return capsys.readouterr().out

    return call


def test_check_speaks_three_languages(run: Run) -> None:
    for language in registry.LANGUAGES:
        words = registry.locale(language).checked
        out = run("check", "--lang", language, str(EXAMPLES / "clamp.mech"), "crank_rocker")
        assert f": {words['proved'].split(': ')[1]}\n" in out
        value = "0.0670682245" if language == "en" else "0,0670682245"
        assert words["default"].format(value=value) in out
        assert words["equilibrium"].format(count=8, trials=words["trials"]) in out
        verbose = run("check", "-v", "--lang", language, "crank_rocker")
        for key in ("points", "parameters", "vectors", "follows", "found", "condition"):
            assert words[key] in verbose
    said = run("check", "--lang", "uk", "fedoriv_fig2a_with_friction").partition("\n")[2]
    names = {"expect", "alpha", "delta", "beta", "asin", "hold"}
    assert set(re.findall(r"[a-z]{4,}", said)) <= names


def test_check_has_the_texts_of_quantities_as_they_are_translated(run: Run) -> None:
    said = {"en": "pressure in the cylinder", "uk": "тиск у циліндрі", "ru": "давление в цилиндре"}
    for language, text in said.items():
        for options in ([], ["-v"]):
            out = run("check", "--lang", language, *options, "karpenko_fig9_packet_clamp")
            assert f"  p = delta*k*F  # {text}\n" in out


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "holds while cos(phi_Y + 10 deg) > 0"),
        ("uk", "справедливо, доки cos(phi_Y + 10 град) > 0"),
        ("ru", "справедливо, пока cos(phi_Y + 10 град) > 0"),
    ],
)
def test_conditions_have_constant_angles_in_degrees(
    language: str, said: str, run: Run, tmp_path: Path
) -> None:
    path = tmp_path / "wedge.mech"
    lines = (
        "slide WX along x",
        "slide YZ along y",
        "contact Y on WX normal 100 deg",
        "force P at W along -x",
        "force Q at Y along -y",
        "friction contact Y 0.12",
        "find k = P/Q",
    )
    path.write_text("\n".join(lines), encoding="utf-8")
    assert said in run("check", "--lang", language, str(path))


WITH_DECIMALS = """\
mechanism decimals "Numbers of every kind"
param a = 12.5 mm
param alpha = 10.5 deg
pivot O at (0.5 mm, 0 mm)
slider K along 33.5 deg
link OB
link BK
OB = 1.25*a @ 90 deg + alpha
BK = a @ 90.5 deg - alpha
force P at B along 14.5 deg
force F at K along -90 deg
find k = P/F
let q = max(0.75*P, 1.5*F)
let s = 1000.5*a^2/1 mm
require alpha < 80.5 deg
drive alpha from 0.5 deg to 60 deg
expect k = 0.281489 +- 0.01 at alpha = 10.5 deg
"""


@pytest.mark.parametrize("language", ["uk", "ru"])
@pytest.mark.parametrize("options", [[], ["-v"]])
def test_all_numbers_of_a_language_have_its_comma(
    options: list[str], language: str, tmp_path: Path, run: Run
) -> None:
    description = tmp_path / "decimals.mech"
    description.write_text(WITH_DECIMALS)
    lines = run("check", "--lang", language, *options, str(description)).splitlines()[1:]
    assert not [line for line in lines if re.search(r"\d\.\d| mm| deg", line)]
    assert "  q = max(0,75*P; 1,5*F)" in lines


def test_powers_of_ten_are_written_as_by_hand(tmp_path: Path, run: Run) -> None:
    description = tmp_path / "decimals.mech"
    description.write_text(WITH_DECIMALS.replace("1000.5*a^2/1 mm", "1e12*a in mm"))
    assert "= 1.25*10^13 mm at the default pose" in run("check", str(description))
    assert "s = 10¹² · 12.5 mm = 1.25·10¹³ mm" in run("derive", str(description))
    assert "1.25*10^13" in run("stroke", str(description))


def test_every_language_of_reports_can_be_asked_for() -> None:
    assert tuple(registry.LANGUAGES) == LANGUAGES


def test_every_language_has_the_words_of_check() -> None:
    tables = [registry.locale(language).checked for language in registry.LANGUAGES]
    assert all(words.keys() == tables[0].keys() for words in tables)
    assert tables[0].keys() >= {*UNJUDGED, *WITHOUT_FORCES}


def test_check_breaks_lines_at_the_width_of_a_terminal() -> None:
    compilation = good_mechanisms.compiled("jansen_leg")
    assert max(map(len, report(compilation, False, "uk"))) > 100
    for width in (80, 100):
        lines = [*report(compilation, False, "uk", width)][1:]
        assert max(map(len, lines)) <= width
        assert all(line.startswith("  ") for line in lines)


def test_it_says_which_load_drives_against_friction(capsys):
    """The load above the line drives, or as here that below it, as the motion is releasing."""
    assert main(["check", "fedoriv_fig2b_with_friction"]) == 0
    lines = capsys.readouterr().out.splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("  i_f = "))
    after = list(takewhile(lambda line: line.startswith("    "), lines[at + 1 :]))
    assert "    With friction, Q drives." in after


def test_constant_angles_are_in_degrees(capsys):
    """As a description may have them; equations that are solved together have no minus."""
    assert main(["check", "crimping_tool"]) == 0
    out = capsys.readouterr().out
    assert "*cos(theta - 10 deg))\n" in out
    assert "pi/" not in out
    assert main(["check", "triad_closed"]) == 0
    out = capsys.readouterr().out
    assert (
        "a*cos(phi) + len_AB*cos(phi_AB) + len_BC*cos(phi_BC) = len_QC*cos(phi_QC) + x_Q\n" in out
    )


def test_what_is_squared_or_between_bars_has_no_minus_before_it(run: Run) -> None:
    out = run("check", str(EXAMPLES / "press" / "press.mech"))
    assert "len_AC1 = hypot(r*cos(phi) + x_O, y_C1 - r*sin(phi) - y_O)" in out
    out = run("check", str(CORPUS / "good" / "opposite_sliders.mech"))
    assert "/abs(l*cos(delta - 50 deg)*cos(theta + 80 deg) + u*sin(delta + 80 deg)" in out


def test_formulas_are_those_of_pages(run: Run) -> None:
    """Sines of friction have the geometry first, and a constant direction needs no bars."""
    held = run("check", "karpenko_fig9_with_friction")
    assert "delta_BK - beta" not in held
    assert "c_P_hold = -tan(beta - delta_BK)/2" in held
    drawn = run("check", str(EXAMPLES / "strength" / "clamp.mech"))
    assert "abs(sin(" not in drawn
    assert "sin(phi_OA - phi_CA)" in drawn
    assert "sin(phi_CA - phi_OA)" not in drawn
