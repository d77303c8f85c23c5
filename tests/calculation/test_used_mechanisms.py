"""Mechanisms that a sheet uses: what comes of them there is what comes of them alone."""

import inspect
import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from jsonschema_rs import Draft202012Validator

import mechc
from mechc.cli import main
from mechc.cli.check_lines import report
from mechc.diagnostics import MechcError
from mechc.diagnostics.render import render
from mechc.emit.json.to_json import schema_text
from mechc.formula.evaluate import evaluate
from mechc.report.note import NoteLine, note
from run_targets import COMPILER, assert_close, built, by_c_singly, by_interpreter
from small_mechanisms import geared_lever, slider_crank

CLAMP = """
mechanism clamp
param b = 250 mm
param l = 150 mm
param f = 0.1
param alpha = 12 deg in 2 deg .. 40 deg
param F = 2  # no load of this name
pivot O
slider K along y
link OBA
link BK
OB = 100 mm @ alpha - 90 deg
OA = b @ alpha - 90 deg
BK = l @ -97 deg
mirror across y sharing K
force P at A along -x
force Q at K along y
friction pins f diameter 20 mm
find k = P/Q
find R_O
let share = k*F
"""

CRANK = "mechanism crank\n" + slider_crank(
    "require phi_AB < 0 deg",
    "find k = M/F",
    l="120 mm",
    phi="40 deg",
    drive="from 10 deg to 170 deg",
)

SHEET = """
sheet strength
param W = 3 kN
use "clamp.mech" as C (Q = W/2, f = 0.05)
let p = C_P_f/(1 cm^2) in MPa
let R = 2*C_R_O
require C_k_f < 2
require C_R_O_f < 1 MN  # iterated
"""


WHOLE = """
sheet whole
param W = 3 kN
use "clamp.mech" as C (Q = W/2, f = 0.05)
"""


class Clamped(NamedTuple):
    sheet: mechc.SolvedMechanism
    whole: mechc.SolvedMechanism
    alone: mechc.SolvedMechanism


def written(folder: Path, sheet: str = SHEET, **parts: str) -> Path:
    for name, text in {"clamp": CLAMP, "crank": CRANK, **parts}.items():
        (folder / f"{name}.mech").write_text(text)
    (folder / "sheet.mech").write_text(sheet)
    return folder / "sheet.mech"


def refused(path: Path) -> list[str]:
    with pytest.raises(MechcError) as caught:
        mechc.load(path)
    return [render(d, caught.value.source) for d in caught.value.diagnostics]


@pytest.fixture(scope="module")
def clamped(tmp_path_factory: pytest.TempPathFactory) -> Clamped:
    path = written(tmp_path_factory.mktemp("clamped"))
    whole = path.with_name("whole.mech")
    whole.write_text(WHOLE)
    return Clamped(mechc.load(path), mechc.load(whole), mechc.load(path.with_name("clamp.mech")))


def test_results_are_those_of_the_mechanism_alone(clamped: Clamped) -> None:
    """Also where a joint is pressed the other way, or nothing is left of k."""
    alpha = np.array([-1.2, -0.1222, 0.05, 0.4, 1.4, 1.58, 2.0])
    sheet = clamped.whole.evaluate(C_alpha=alpha, W=3000.0)
    alone = clamped.alone.evaluate(alpha=alpha, f=0.05, Q=1500.0)
    assert {f"C_{name}" for name in alone} <= sheet.keys()
    for name, values in alone.items():
        np.testing.assert_allclose(sheet[f"C_{name}"], values, rtol=1e-15, err_msg=name)
    assert np.isfinite(alone["k_f"]).sum() > 4


def test_code_has_what_the_calculation_needs(clamped: Clamped) -> None:
    """Its own lines, what these rest on, its conditions; a status asks for k, too."""
    names = {f.name for f in clamped.sheet._compilation.routine.functions}
    used = {"C_k", "C_k_f", "C_P_f", "C_R_O", "C_R_O_f"}
    assert names == {"p", "R", "C_Q", "C_f"} | used
    assert "C_R_O_direction" in {f.name for f in clamped.whole._compilation.routine.functions}
    assert "def C_P_hold" not in clamped.sheet.emit("python")


def test_what_nothing_uses_is_plotted_where_it_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path)
    command = ["plot", str(path), "--x", "C_alpha", "--y", "C_eta_k", "-o", str(tmp_path / "x.svg")]
    assert main(command) == 1
    assert "nothing in the sheet uses it: `let x = C_eta_k` asks for it" in capsys.readouterr().err
    path.write_text(SHEET + "let x = C_eta_k\n")
    assert main(command) == 0


def test_loads_follow_from_ratios(clamped: Clamped, tmp_path: Path) -> None:
    found = clamped.whole.evaluate() | clamped.sheet.evaluate()
    assert found["C_P"] == pytest.approx(found["C_k"] * 1500)
    assert found["C_P_f1"] == pytest.approx(found["C_k_f1"] * 1500)
    assert found["p"] == pytest.approx(found["C_P_f"] * 1e4)
    assert clamped.sheet._compilation.mechanism.lets[-1].unit == "kN"
    other = 'sheet s\nuse "crank.mech" as c (M = 9 N*m)\n'
    found = mechc.load(written(tmp_path, other)).evaluate()
    assert found["c_F"] * found["c_k"] == pytest.approx(9)


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
def test_c_computes_what_the_interpreter_does(clamped: Clamped, tmp_path: Path) -> None:
    """Also what is iterated, on which a condition rests."""
    found = clamped.sheet._compilation
    made = built(found, tmp_path)
    assert_close(by_c_singly(found, made), by_interpreter(found), 64, found.routine)


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
def test_the_note_has_results_and_the_derivation_behind_it(clamped: Clamped, language: str) -> None:
    """At the values that the sheet gives: f is 0.05 here, and 0.1 in the mechanism."""
    text = clamped.sheet.emit("latex", language=language)
    note, derived = text.split("\\clearpage\n")
    assert r"k_{f,C}=" in note
    assert r"R_{O,x,f,C}=" not in note  # on which nothing rests
    assert r"\rho_C" not in text
    assert r"\begin{tikzpicture}" in derived
    assert "0{,}05" in derived or "0.05" in derived
    assert r"\boxed{k=\frac{P}{Q}=" in derived
    assert "tikz" not in clamped.sheet.emit("latex", fragment=True)


def test_quantities_of_a_part_are_written_as_there_with_an_index(tmp_path: Path) -> None:
    """A force has one symbol in the calculation and in the derivation behind it."""
    text = (
        'sheet s\nparam W = 3 kN\nparam C_1 = 2\nuse "clamp.mech" as C (Q = W/2)\n'
        "use pin_joint as the_pin (F = C_R_O_f, tau_a = 70 MPa, sigma_a = 150 MPa, d = 9 mm)\n"
        "use cylinder as cyl (P = C_P_f1, p = 0.6 MPa)\n"
        "let x = C_1*C_R_O_direction*the_pin_d_min*cyl_d\n"
    )
    page = mechc.load(written(tmp_path, text)).emit("latex")
    assert r"R_{O,f,C}" in page
    assert r"d_{\mathrm{min},\text{the pin}}" in page
    assert r"\varphi_{R_{O,C}}" in page
    assert r"P_{f1,C}" in page
    assert r"$\mathrm{bores}_{\mathrm{cyl}}$ (ISO 15552)" in page
    assert "$C_{1}$ &" in page.replace("C_1", "C_{1}")  # a name of the sheet's own
    assert "C_{R" not in page


@pytest.mark.parametrize(
    ("rest", "shown"),
    [
        ("let x = C_P_f/(1 cm)", {"C_k_f", "C_P_f"}),
        ("let x = 2*C_R_O", {"C_R_O"}),
        ("let x = 2*W\nrequire C_eta_k > 0.1", {"C_eta_k", "C_k", "C_k_f"}),
        ("let x = 2*W\nexpect C_k = 0.1 +- 1", {"C_k"}),
    ],
)
def test_a_note_shows_of_a_mechanism_what_something_rests_on(
    tmp_path: Path, rest: str, shown: set[str]
) -> None:
    """All forces rest on the load that is given; the note names those that nobody asks for."""
    text = f'sheet s\nparam W = 3 kN\nuse "clamp.mech" as C (Q = W/2)\n{rest}\n'
    found = mechc.load(written(tmp_path, text))._compilation
    read = note(found.mechanism, found.results)
    given = {known.name for known in found.mechanism.taken} | {"C_P", "C_P_f", "C_P_hold"}
    assert {line.name for line in read.lines} & given == shown
    assert given - shown <= set(read.unused)
    inner = {"C_a_BK_hold", "C_S_BK_hold"}  # on which only k_hold rests
    assert not inner & {line.name for line in read.lines}


def test_results_of_a_mechanism_have_their_numbers_put_in(tmp_path: Path) -> None:
    """What is given to the mechanism keeps its unit; names of results are translated."""
    text = "sheet s\nuse crank_slider as c (F = 2 kN)\nlet M = c_M in N*m\n"
    sheet = mechc.load(written(tmp_path, text))._compilation
    (ratio,) = (line for line in note(sheet.mechanism, sheet.results).lines if line.name == "c_k")
    assert ratio.formula
    assert ratio.numbers
    assert evaluate(ratio.numbers, {}) == pytest.approx(ratio.value.value, rel=1e-4)  # type: ignore[union-attr]
    text = 'sheet s\nuse "clamp.mech" as C (Q = 2 kN)\nlet x = C_P_hold\n'
    said = mechc.load(written(tmp_path, text)).emit("latex", language="uk", fragment=True)
    assert "P_{\\text{утр},C}=" in said


def test_check_and_json_have_the_mechanism_at_the_values_of_the_sheet(tmp_path: Path) -> None:
    """Its ratio and its second opinion, under the prefix."""
    path = written(tmp_path, 'sheet s\nuse "crank.mech" as C (F = 2 kN, l = 0.1 m)\n')
    sheet, alone = mechc.load(path), mechc.load(tmp_path / "crank.mech").evaluate(l=0.1)
    heading, ratio, verdict = list(report(sheet._compilation, verbose=False))[-3:]
    assert heading == "  C is crank at the values that it is given here"
    assert ratio == f"    k = {alone['k'] * 1e3:.9g} mm"
    assert verdict.startswith("    equilibrium of the free bodies agrees in ")
    document = json.loads(sheet.emit("json"))
    Draft202012Validator(json.loads(schema_text())).validate(document)
    (used,) = document["used_mechanisms"]
    assert (used["prefix"], used["name"], used["referee"]["agrees"]) == ("C", "crank", True)
    found, force = used["results"]
    assert (force["name"], force["value"]) == ("F", 2000)
    assert found["value"] == pytest.approx(alone["k"], rel=1e-14)
    assert r"\varphi" in found["formula"]["latex"]


def test_check_warns_of_a_mechanism_at_the_values_of_the_sheet(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    crank = "param phi = 40 deg\npivot O\nlink OA\nOA = 50 mm @ phi\ntorque M on OA\n"
    crank += "force F at A along y\ndrive phi from 10 deg to 80 deg\nfind k = M/F\n"
    (tmp_path / "crank.mech").write_text(crank, "utf-8")
    sheet = tmp_path / "sheet.mech"
    sheet.write_text('sheet s\nuse "crank.mech" as c (phi = 120 deg)\nlet x = c_k\n', "utf-8")
    assert main(["check", str(sheet)]) == 0
    err = capsys.readouterr().err
    assert "crank.mech:7:1: warning[W222]" in err
    assert "where phi is 120 deg" in err


def test_the_status_rests_on_what_is_iterated(clamped: Clamped) -> None:
    namespace: dict[str, Any] = {}
    exec(clamped.sheet.emit("python"), namespace)
    names = [i.name for i in clamped.sheet._compilation.routine.checks.inputs]
    values = clamped.sheet.defaults
    for load, number in ((3e3, 0), (3e9, 2)):
        assert namespace["status"](*(load if n == "W" else values[n] for n in names)) == number


def test_a_sheet_within_derives_its_mechanism_too(tmp_path: Path) -> None:
    inner = 'sheet within\nparam W = 1 kN\nuse "crank.mech" as A (F = W, l = 0.1 m)\n'
    outer = 'sheet outer\nuse "inner.mech" as I (W = 2 kN)\nlet x = I_A_M/(1 cm)\n'
    found = mechc.load(written(tmp_path, outer, inner=inner))._compilation.used_mechanisms
    assert [prefix for prefix, _ in found] == ["I_A"]
    assert found[0][1].found[0].default == pytest.approx(
        mechc.load(tmp_path / "crank.mech").evaluate(l=0.1)["k"]
    )


def test_what_a_mechanism_does_not_rest_on_is_no_mistake(tmp_path: Path) -> None:
    sheet = 'sheet s\nuse "crank.mech" as c (F = 2 kN)\nlet F = c_M/(1 cm)\n'
    idle = CRANK.replace("param r =", "param idle = 1 mm\nparam r =")
    assert mechc.load(written(tmp_path, sheet, crank=idle)).warnings == []


def test_a_loop_that_does_not_close_and_a_condition_on_it(tmp_path: Path) -> None:
    sheet = 'sheet s\nuse "crank.mech" as crank (F = 1 kN)\nlet M = crank_M in N*m\n'
    phi = np.array([0.3, 1.2, 3.0, 3.5])
    solved = mechc.load(written(tmp_path, sheet))
    alone = mechc.load(tmp_path / "crank.mech")
    for length in (0.12, 0.045):
        here = solved.evaluate(crank_phi=phi, crank_l=length)
        there = alone.evaluate(phi=phi, l=length)["k"]
        np.testing.assert_array_equal(here["crank_k"], there)
        np.testing.assert_allclose(here["M"], 1000 * there, rtol=1e-14)
        assert 0 < np.isnan(there).sum() < phi.size
    namespace: dict[str, object] = {}
    exec(solved.emit("python"), namespace)
    status = namespace["status"]
    assert [int(status(0.05, 0.12, p)) for p in (0.3, 3.5)] == [0, 1]  # type: ignore[operator]


def test_a_loop_concerns_its_own_mechanism_alone(tmp_path: Path) -> None:
    sheet = 'sheet s\nuse "crank.mech" as a (F = 1 kN)\nuse "crank.mech" as b (M = 9 N*m)\n'
    solved = mechc.load(
        written(tmp_path, sheet + "let x = a_M/b_M\nlet y = 2*a_k\nlet z = b_F*b_k\n")
    )
    found = solved.evaluate(a_l=0.02, a_phi=1.2)
    assert all(np.isnan(found[name]) for name in ("a_k", "a_M", "x", "y"))
    assert found["z"] == pytest.approx(9)


def test_what_has_no_value_is_refused(tmp_path: Path) -> None:
    sheet = 'sheet s\nuse "crank.mech" as crank (l = 20 mm)\n'
    (message,) = refused(written(tmp_path, sheet))
    assert "sheet.mech:2:5: error[E564]: crank_k has no value" in message
    sheet = 'sheet s\nuse "crank.mech" as crank (phi = 200 deg)\n'
    (message,) = refused(written(tmp_path, sheet))
    assert "crank.mech:15:1: error[E550]: the requirement fails: " in message


def test_of_a_mechanism_the_first_result_without_value_is_named(tmp_path: Path) -> None:
    two = CRANK.replace("find k = M/F", "find k = M/F\nfind i = F/M")
    (tmp_path / "crank.mech").write_text(two, encoding="utf-8")
    sheet = 'sheet s\nuse "crank.mech" as A (l = 20 mm)\nuse "crank.mech" as B (l = 30 mm)\n'
    (tmp_path / "s.mech").write_text(sheet, encoding="utf-8")
    first, second = refused(tmp_path / "s.mech")
    assert "s.mech:2:5: error[E564]: A_k has no value" in first
    assert "s.mech:3:5: error[E564]: B_k has no value" in second


def test_two_of_one_kind_and_a_sheet_between(tmp_path: Path) -> None:
    """The force of one mechanism is given to another, through a sheet that uses both."""
    inner = (
        'sheet within\nparam W = 1 kN\nuse "clamp.mech" as A (Q = W)\n'
        'use "clamp.mech" as B (Q = A_P_f, alpha = 20 deg)\nlet whole = B_k_f*A_k_f\n'
    )
    outer = 'sheet outer\nuse "inner.mech" as I (W = 2 kN)\nlet x = I_B_P_f\nlet y = I_whole\n'
    plain = CLAMP.replace("find R_O\n", "")
    found = mechc.load(written(tmp_path, outer, inner=inner, clamp=plain)).evaluate(I_A_b=0.3)
    clamp = mechc.load(tmp_path / "clamp.mech")
    first, second = clamp.evaluate(b=0.3)["k_f"], clamp.evaluate(alpha="20 deg")["k_f"]
    assert found["x"] == pytest.approx(2000 * first * second)
    assert found["y"] == pytest.approx(first * second)


def test_what_is_wrong_in_a_mechanism_has_both_places(tmp_path: Path) -> None:
    (message, *_) = refused(written(tmp_path, clamp=CLAMP.replace("OA = b", "OA = c")))
    assert "clamp.mech:13:6: error[" in message
    assert "sheet.mech:4:5: it is used here" in message


def test_what_is_expected_of_used_results(tmp_path: Path) -> None:
    """A formula is proved, a figure at values of the used mechanism compared; both may fail."""
    right = "sheet s\nuse crank_slider as c (F = 1 kN)\n"
    right += "expect c_k = c_r*sin(c_phi + c_beta)/cos(c_beta)\n"
    right += "expect c_k = 48.2236300993 mm at c_phi = 45 deg, c_beta = 20 deg\n"
    found = mechc.load(written(tmp_path, right))._compilation.findings
    assert [finding.outcome for finding in found] == ["proved", "agrees"]
    for sound, wrong in [("48.22", "48.32"), ("cos(c_beta)", "cos(c_phi)")]:
        (message,) = refused(written(tmp_path, right.replace(sound, wrong)))
        assert "E581" in message
        assert "c_k is" in message


TONGS = """
sheet jaw
use tongs_fig4_9_forces as L (N = 500 N)
"""


@pytest.mark.parametrize(
    ("lang", "rod", "joint", "across"),
    [
        ("en", "force in the rod KE", "force at A", "x component"),
        ("uk", "зусилля в стрижні KE", "реакція в шарнірі A", "проєкція на вісь x"),
        ("ru", "усилие в стержне KE", "реакция в шарнире A", "проекция на ось x"),
    ],
)
def test_results_say_what_they_are_and_of_which_mechanism(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], lang: str, rod: str, joint: str, across: str
) -> None:
    path = tmp_path / "jaw.mech"
    path.write_text(TONGS, encoding="utf-8")
    assert main(["check", str(path), "--lang", lang]) == 0
    rows = {line.split()[0]: line for line in capfd.readouterr().out.splitlines()}
    assert rows["L_N_KE"].endswith(f"{rod} (tongs_fig4_9_forces)")
    assert rows["L_R_A"].endswith(f"{joint} (tongs_fig4_9_forces)")
    assert rows["L_R_A_x"].endswith(f"{joint}, {across} (tongs_fig4_9_forces)")
    assert rows["L_N"].split() == ["L_N", "=", "500", {"en": "N"}.get(lang, "Н")]


def test_a_loop_that_does_not_close_is_named_with_both_places(tmp_path: Path) -> None:
    (tmp_path / "crank.mech").write_text(CRANK, encoding="utf-8")
    (tmp_path / "s.mech").write_text('sheet s\nuse "crank.mech" as C (l = 30 mm)\n', "utf-8")
    with pytest.raises(MechcError) as found:
        mechc.load(tmp_path / "s.mech")
    assert found.value.source is not None
    said = render(found.value.diagnostics[0], found.value.source)
    assert "has no value at what is given to the mechanism: no closure of loop" in said
    assert "s.mech:2:5" in said
    assert "crank.mech:16:10: it is asked for here" in said


def test_a_bound_on_a_force_in_compression_is_doubted(tmp_path: Path) -> None:
    bounds = {
        "L_N_KE < 5 kN": True,
        "5 kN > L_N_KE": True,
        "abs(L_N_KE) < 5 kN": False,
        "L_R_A_x < 5 kN": False,
        "-5 kN < L_N_KE < 5 kN": False,
        "L_N_KE < 0 N": False,
    }
    for condition, is_doubted in bounds.items():
        sheet = mechc.loads(f"{TONGS}require {condition}\n")
        codes = [d.code for d in sheet.warnings]
        assert ("W265" in codes) == is_doubted, condition


def test_a_doubted_force_is_shown_in_a_unit() -> None:
    for condition, unit in {"L_N_KE < 5 kN": " kN", "L_N_KE < L_N": " N"}.items():
        sheet = mechc.loads(f"{TONGS}require {condition}\n")
        (said,) = (d.message for d in sheet.warnings if d.code == "W265")
        assert said.split(",")[0].endswith(unit), said


def test_texts_of_a_used_mechanism_are_translated(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    lever = """mechanism lever
param a = 40 mm  # short arm
param d = 8 mm   # pin
pivot O at (0 mm, 0 mm)
link OAB
A at (40 mm, 0 mm)
B at (-100 mm, 0 mm)
force P at B along y
force F at A along y
find k = P/F
let m = k*d as "share"
translate "pin" uk "палець"
translate "share" uk "частка"
"""
    (tmp_path / "lever.mech").write_text(lever, encoding="utf-8")
    path = tmp_path / "s.mech"
    path.write_text('sheet s\nuse "lever.mech" as L (d = 9 mm)\n', encoding="utf-8")
    assert main(["check", "--lang", "uk", str(path)]) == 0
    said, warned = capfd.readouterr()
    assert "палець (lever)" in said
    assert "частка (lever)" in said
    assert "W224" not in warned


def test_what_is_taken_as_it_is_stands_behind_its_text(tmp_path: Path) -> None:
    path = tmp_path / "s.mech"
    path.write_text(
        "sheet s\nparam F = 2 kN in 0 kN .. 9 kN  # load\nuse pin_joint as pin (F = F)\n", "utf-8"
    )
    sheet = mechc.load(path)
    assert r"Force on the pin (pin\_joint): $F_{\mathrm{pin}}=F=2\,\text{kN}$\par" in (
        sheet.emit("latex").replace("\\noindent ", "")
    )
    shown = sheet._repr_markdown_()
    assert r"| $F$ | load | $2\,\text{kN}$ | $0\ \ldots\ {9\,\text{kN}}$ |" in shown
    assert r"Force on the pin (pin\_joint): $F_{\mathrm{pin}}=F=2\,\text{kN}$" in shown
    assert "\\par" not in shown


def test_what_a_result_rests_on_has_its_value(tmp_path: Path) -> None:
    """By hand: rho = f*d/2, b_OBA = OA = 250 mm; every name on the way has a value."""
    lines = noted(tmp_path, 'use "clamp.mech" as C (Q = 4 kN)\n')
    on_the_way = {line.name: line.value for line in lines if line.is_taken and not line.result}
    assert all(on_the_way.values())
    assert on_the_way["C_rho"] == (pytest.approx(0.1 * 0.01, rel=1e-12), "mm")


def noted(folder: Path, text: str) -> tuple[NoteLine, ...]:
    """Return the note of a sheet that uses the clamp."""
    (folder / "clamp.mech").write_text(CLAMP, "utf-8")
    (folder / "sheet.mech").write_text(f"sheet s\n{text}", "utf-8")
    compilation = mechc.load(folder / "sheet.mech")._compilation
    return note(compilation.mechanism, compilation.results).lines


EDGE = """mechanism edge
pivot O at (0 mm, 0 mm)
slider C along x
slider E along y
link AOD
link CD
link AE
A at (-52 mm, 14 mm)
D at (10 mm, 95 mm)
C at (340 mm, 80 mm)
E at (-60 mm, -60 mm)
force P at C along -x
force F at E along y
friction pins 0.15 diameter 10 mm
friction pin O 0.15 diameter 14 mm
friction slider E 0.12
friction slider C 0.1
find k = P/F
find R_O
find R_A on AOD
find R_D on AOD
find N_CD
find N_AE
find N_E
let l_1 = len_CD in mm
let h = y_C in mm
"""

STRENGTH = """sheet strength
use "edge.mech" as C (F = 4 kN)
param n = 1.6 in 1.2 .. 3
let R = C_R_O_f
""" + "".join(f"let x_{i} = {i}*R\nlet y_{i} = n*x_{i}\n" for i in range(1, 7))


def test_conditions_have_their_numbers_where_functions_are_computed_together(
    tmp_path: Path,
) -> None:
    """A coefficient of friction that is a number has a name, by which a condition compares."""
    (tmp_path / "edge.mech").write_text(EDGE, encoding="utf-8")
    (tmp_path / "strength.mech").write_text(STRENGTH, encoding="utf-8")
    solved = mechc.load(tmp_path / "strength.mech")
    scope: dict[str, Any] = {"__name__": "strength"}
    exec(solved.emit("python"), scope)
    values = solved.evaluate()
    for name in ("C_R_O_f", "x_1", "x_6", "y_6"):
        taken = inspect.signature(scope[name]).parameters
        found = scope[name](*(scope["DEFAULTS"][argument] for argument in taken))
        np.testing.assert_allclose(found, values[name], rtol=1e-12)


def test_a_drawn_drive_that_reaches_below_zero_is_given(tmp_path: Path) -> None:
    crank = """mechanism rocker
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link AB
link CB
A at (20 mm, 34.6 mm)
B at (80 mm, 60 mm)
drive OA from -40 deg to 80 deg
torque M on OA
torque T on CB
find k = M/T
"""
    (tmp_path / "rocker.mech").write_text(crank, encoding="utf-8")
    text = 'sheet s\nuse "rocker.mech" as C (T = 2 N*m, phi_OA = -20 deg)\nlet z = 2*C_M\n'
    (tmp_path / "s.mech").write_text(text, encoding="utf-8")
    alone = mechc.load(tmp_path / "rocker.mech").evaluate(phi_OA="-20 deg")
    found = mechc.load(tmp_path / "s.mech").evaluate()
    np.testing.assert_allclose(found["C_k"], alone["k"], rtol=1e-12)
    np.testing.assert_allclose(found["z"], 4 * alone["k"], rtol=1e-12)


def test_arguments_of_ones_own_stand_before_those_brought_in(tmp_path: Path) -> None:
    """Wherever the use stands: ``fmt`` moves it, as YAML has a place of its own for it."""
    use, own = 'use "crank.mech" as c (F = 1 kN)\n', "param t = 3 mm\n"
    for lines in (use + own, own + use):
        solved = mechc.load(written(tmp_path, f"sheet s\n{lines}let x = c_M/t\n"))
        function = next(f for f in solved._compilation.routine.functions if f.name == "x")
        assert [i.name for i in function.inputs] == ["t", "c_r", "c_l", "c_phi"]


def test_what_the_report_of_a_mechanism_leaves_out_is_not_said_to_be_derived(
    tmp_path: Path,
) -> None:
    for line, said in (("", 0), ("report k\n", 1)):
        (tmp_path / "edge.mech").write_text(EDGE + line, encoding="utf-8")
        text = 'sheet s\nuse "edge.mech" as C (F = 4 kN)\nlet x = C_k*C_R_O\n'
        (tmp_path / "s.mech").write_text(text, encoding="utf-8")
        page = mechc.load(tmp_path / "s.mech").emit("latex")
        below = page.partition("Results of the mechanism, derived below:")[2].partition(r"\par")[0]
        others = page.partition("Results of the mechanism:")[2].partition(r"\par")[0]
        assert "k_C=" in below
        assert ("R_{O,C}=" in others, "R_{O,C}=" in below) == (bool(said), not said)


SLOTTED = """
mechanism slotted
param phi = 90 deg
param a = 50 mm
pivot C at (0 mm, 100 mm)
pivot O at (0 mm, 0 mm)
link CA
link OE
slot A in OE
CA = a @ phi
OE = 300 mm
torque M on CA
force F at E along x
friction contact A 0.3
find k = M/F
"""


@pytest.mark.parametrize(
    ("given", "line", "is_said"),
    [
        ("", "let y = S_k_f", True),
        ("", "require S_eta_k < 2", True),
        ("", "let y = S_k", False),
        (" (phi = 89.9 deg)", "let y = S_k_f", False),
    ],
)
def test_a_joint_that_does_not_slide_at_the_pose_of_a_sheet_is_said(tmp_path, given, line, is_said):
    """The sheet had k_f without friction, beside the mechanism's own limit from both sides."""
    (tmp_path / "slotted.mech").write_text(SLOTTED, encoding="utf-8")
    path = tmp_path / "sheet.mech"
    path.write_text(f'sheet s\nuse "slotted.mech" as S{given}\n{line}\n', encoding="utf-8")
    said = [d.message for d in mechc.load(path).warnings if d.code == "W518"]
    assert len(said) == is_said
    assert all("without the friction of a joint that does not slide" in one for one in said)


def test_a_result_that_is_zero_in_a_mechanism_is_in_a_sheet(tmp_path):
    """k was stated as -3.1e-15 mm beside 0 mm of the mechanism itself."""
    (tmp_path / "train.mech").write_text(geared_lever(), encoding="utf-8")
    path = tmp_path / "sheet.mech"
    path.write_text('sheet s\nuse "train.mech" as T (alpha = 90 deg)\n', encoding="utf-8")
    results = {result.name: result.default for result in mechc.load(path)._compilation.results}
    assert results["T_k"] == results["T_k_f"] == 0


BALANCED = """
mechanism lever
param a = 100 mm
param b = 100 mm
pivot O
link OAB
OA = a @ 0 deg
OB = b @ 0 deg
force P at A along y
force F at B along -y
let F = 100 N
find P
find R_O
"""


def test_a_direction_without_value_says_why(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Arms of one length: nothing is left for the pivot, and zero points nowhere."""
    (tmp_path / "lever.mech").write_text(BALANCED)
    sheet = "sheet s\nparam a = {}\nuse 'lever.mech' as L (a = a)\nlet u = L_R_O_direction\n"
    paths = {a: tmp_path / f"{a[:3]}.mech" for a in ("100 mm", "101 mm")}
    for a, path in paths.items():
        path.write_text(sheet.format(a).replace("'", '"'))
        assert main(["derive", str(path)]) == 0
        said = "undetermined, as the force is zero"
        assert (said in capsys.readouterr().out) is (a == "100 mm")
    assert main(["check", "--lang", "uk", str(tmp_path / "lever.mech")]) == 0
    assert "не визначено, бо сила дорівнює нулю" in capsys.readouterr().out
