"""Sheets put together from others: values by hand, files that are read, and those that are not."""

import math
from pathlib import Path

import pytest

import mechc
from mechc.cli import main
from mechc.diagnostics import MechcError
from mechc.diagnostics.render import render
from mechc.report.note import note

PIN = """
sheet pin "Pin in shear"
param F = 2 kN in 0 kN .. 10 kN  # force
param d = 8 mm
param A = pi*d^2/4
list sizes = 5 mm, 8 mm
let tau = F/A in MPa  # shear stress
let s = next d in sizes
require tau < 80 MPa
expect tau = 39.8 MPa
"""

USER = """
sheet joint
param Q = 3 kN
use "parts/pin.mech" as one (F = Q)
use "parts/pin.mech" as two (F = Q)
let total = one_tau + two_tau in MPa
"""


def written(folder: Path, files: dict[str, str]) -> Path:
    """Write files and return the path of the first."""
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text)
    return folder / next(iter(files))


def refused(path: Path) -> list[str]:
    """Return the messages about a description in full."""
    with pytest.raises(MechcError) as caught:
        mechc.load(path)
    return [render(d, caught.value.source) for d in caught.value.diagnostics]


def joint(folder: Path, pin: str = PIN, user: str = USER) -> Path:
    return written(folder, {"joint.mech": user, "parts/pin.mech": pin})


AREA = math.pi * 16e-6
"""That of a pin of 8 mm, in square metres."""


def test_each_use_has_its_own_names(tmp_path: Path) -> None:
    found = mechc.load(joint(tmp_path)).evaluate(Q=2000.0, two_d=0.006)
    assert found["one_tau"] == pytest.approx(2000 / AREA)
    assert found["two_tau"] == pytest.approx(2000 / (AREA * 9 / 16))
    assert found["total"] == pytest.approx(found["one_tau"] + found["two_tau"])
    assert found["two_s"] == 0.008


def test_what_is_given_keeps_to_the_range(tmp_path: Path) -> None:
    wide = PIN.replace("80 MPa", "800 MPa")
    solved = mechc.load(joint(tmp_path, wide))
    assert solved.evaluate(Q=9900.0)["one_tau"] == pytest.approx(9900 / AREA)
    assert math.isnan(solved.evaluate(Q=10100.0)["total"])
    message = refused(joint(tmp_path, PIN.replace("10 kN", "2.5 kN")))[0]
    assert "joint.mech:4:34: error[E560]: one_F = 3 kN, expected at most 2.5 kN" in message
    assert "pin.mech:3:27: its range is given here" in message


def test_a_value_of_one_is_given_to_another(tmp_path: Path) -> None:
    user = USER.replace("(F = Q)\nlet", "(F = Q, d = one_s - 2 mm)\nlet")
    found = mechc.load(joint(tmp_path, PIN.replace("80", "800"), user)).evaluate(Q=1000.0)
    assert found["two_tau"] == pytest.approx(1000 / (AREA * 9 / 16))


def test_what_is_wrong_in_a_used_sheet_has_both_places(tmp_path: Path) -> None:
    (message, *_) = refused(joint(tmp_path, PIN.replace("F/A", "F/B")))
    assert "pin.mech:7:13: error[" in message
    assert "joint.mech:4:5: it is used here" in message


def test_what_fails_with_what_is_given_has_both_places_too(tmp_path: Path) -> None:
    """It is found when the whole is put together, not when the used sheet is read."""
    path = written(tmp_path, {"joint.mech": USER, "parts/pin.mech": PIN.replace("< 80", "< 8")})
    with pytest.raises(MechcError) as raised:
        _ = mechc.load(path).evaluate()
    first, second = raised.value.diagnostics
    assert (first.code, second.code) == ("E550", "E550")
    text = USER.index('"parts'), USER.rindex('"parts')
    assert [d.related[-1].span.start for d in (first, second)] == list(text)


def test_a_sheet_of_sheets_of_sheets(tmp_path: Path) -> None:
    outer = 'sheet all\nuse "joint.mech" as j (Q = 1 kN)\nlet x = 2*j_one_tau\n'
    path = written(tmp_path, {"all.mech": outer, "joint.mech": USER, "parts/pin.mech": PIN})
    assert mechc.load(path).evaluate()["x"] == pytest.approx(2000 / AREA)


@pytest.mark.parametrize("back", ["joint.mech", "parts/pin.mech", "./joint.mech"])
def test_circles(tmp_path: Path, back: str) -> None:
    (tmp_path / "parts").symlink_to(tmp_path)
    path = written(
        tmp_path, {"joint.mech": USER, "parts/pin.mech": f'sheet p\nuse "{back}" as b\n'}
    )
    message = refused(path)[0]
    assert "E555" in message
    assert "pin.mech:2:5" in message
    assert "joint.mech:4:5: it is used here" in message


@pytest.mark.parametrize("name", ["/a.mech", "../a.mech", "parts/../../a.mech", "C:a.mech"])
def test_paths_that_lead_elsewhere(tmp_path: Path, name: str) -> None:
    (tmp_path / "a.mech").write_text(PIN)
    (tmp_path / "in").mkdir()
    path = joint(tmp_path / "in", user=f'sheet s\nuse "{name}" as a\nlet x = 1\n')
    assert "E908" in refused(path)[0]


@pytest.mark.parametrize(
    ("written", "hint"),
    [
        ('"%2e%2e/a.mech"', "a path is that from this file"),
        ('"~/a.mech"', "a path is that from this file"),
        (r'"..\a.mech"', "a path is that from this file"),
        ('"sheets/cylinder"', "`mechc list` prints the names of the library"),
        ('"parts/Pin.mech"', "did you mean 'parts/pin.mech'?"),
        ("joint", 'a file is in quotes: "joint.mech"'),
    ],
)
def test_what_is_not_there(tmp_path: Path, written: str, hint: str) -> None:
    """Nothing but the folder is looked into, however a path is spelled."""
    (tmp_path / "a.mech").write_text(PIN)
    (tmp_path / "in").mkdir()
    (message,) = refused(joint(tmp_path / "in", user=f"sheet s\nuse {written} as a\nlet x = 1\n"))
    assert "E907" in message
    assert f"hint: {hint}" in message


def test_links_and_what_is_no_file(tmp_path: Path) -> None:
    (tmp_path / "a.mech").write_text(PIN)
    inside = tmp_path / "in"
    inside.mkdir()
    (inside / "a.mech").symlink_to(tmp_path / "a.mech")
    (inside / "parts").mkdir()
    (inside / "parts" / "b.mech").mkdir()
    path = written(inside, {"s.mech": 'sheet s\nuse "a.mech" as a\nuse "parts/b.mech" as b\n'})
    assert "E908" in refused(path)[0]


def test_too_much_is_refused(tmp_path: Path) -> None:
    """Each sheet uses the next one twice: twenty of them would be a million."""
    twice = 'sheet s\nuse "{0}.mech" as a\nuse "{0}.mech" as b\n'
    files = {f"s{n}.mech": twice.format(f"s{n + 1}") for n in range(20)}
    assert "E562" in refused(written(tmp_path, files))[0]


def test_make_knows_what_is_used(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path = joint(tmp_path, PIN.replace("80", "800"))
    out = str(tmp_path / "out.py")
    assert main(["compile", str(path), "-o", out, "--deps", "-"]) == 0
    rule = capfd.readouterr().out
    assert rule.split()[1:] == [str(path), *[str(tmp_path / "parts/pin.mech")] * 2]
    assert main(["compile", str(path), "-o", str(tmp_path / "parts/pin.mech"), "--emit", "c"]) == 2


LEVER = """
mechanism lever
param Q = 3 kN
use "parts/pin.mech" as pin (F = Q/2)
let arm = 10*pin_s
pivot O
link OAB
OA = arm @ 0 deg
OB = 240 mm + pin_d @ 0 deg
force P at A along y
force F at B along -y
find k = P/F
let F = Q
let tau = pin_tau in MPa
"""


def test_a_mechanism_uses_a_sheet(tmp_path: Path) -> None:
    """Its formulas give lengths, loads and stresses; its range is a condition of use."""
    lever = mechc.load(joint(tmp_path, user=LEVER))
    found = lever.evaluate()
    assert found["k"] == pytest.approx((240 + 8) / 80)
    assert found["tau"] == pytest.approx(1500 / AREA)
    assert lever.evaluate(pin_d=0.004)["k"] == pytest.approx(244 / 50)
    assert math.isnan(lever.evaluate(Q=21e3)["tau"])
    assert "OA" in lever.emit("latex")
    wide = LEVER.replace("Q = 3 kN", "Q = 22 kN")
    message = refused(joint(tmp_path, user=wide))[0]
    assert "joint.mech:4:34: error[E560]: pin_F = 11000 N, expected at most 10000 N" in message


STEEL = """
sheet steel
param n = 1.5
param t = 8 mm
list sizes = 5 mm, 8 mm
let E = 210 GPa
let G = E/2.6
let tau_a = 205 MPa/n
let W = next t in sizes
"""


@pytest.mark.parametrize(
    ("text", "aside"),
    [
        ("\nlet a = Q/S_tau_a", {"S_t", "S_E", "S_G", "S_W", "S_sizes"}),
        ("\nlet a = 2*Q\nrequire S_G > 1 MPa", {"S_n", "S_t", "S_tau_a", "S_W", "S_sizes"}),
        ("(t = h)\nlet a = Q*S_n", {"S_E", "S_G", "S_tau_a"}),
        ("", set()),
    ],
)
def test_a_note_leaves_out_what_a_calculation_does_not_use(
    tmp_path: Path, text: str, aside: set[str]
) -> None:
    """What rests on the sheet's own stays, and what that rests on; the note names the others."""
    user = f'sheet joint\nparam Q = 3 kN\nparam h = 5 mm\nuse "steel.mech" as S {text}\n'
    sheet = mechc.load(written(tmp_path, {"joint.mech": user, "steel.mech": STEEL}))._compilation
    found = note(sheet.mechanism, sheet.results)
    brought = {"S_n", "S_t", "S_E", "S_G", "S_tau_a", "S_W", "S_sizes"}
    shown = {q.name for part in (found.given, found.lines, found.tables) for q in part}
    assert (set(found.unused), shown & brought) == (aside, brought - aside)
