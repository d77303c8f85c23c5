"""Mechanisms joined at points are one: the same as it is written by hand."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import mechc
from mechc import files
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.diagnostics.render import render
from mechc.formula.evaluate import evaluate
from mechc.model.parts.friction import PinFriction
from mechc.report.languages.registry import locale
from mechc.report.latex.given import scheme
from mechc.report.latex.notation import notation
from paths import ROOT

TOGGLE = """
mechanism toggle "Toggle"
param l = 100 mm as "length of both links"
param alpha = 10 deg in -20 deg .. 40 deg
param f = 0.1
pivot C at (0 mm, 0 mm)
slider K along y through C
link CB "upper"
link BK
CB = l @ -90 deg + alpha
BK = l
assembly K back
drive alpha from 5 deg to 40 deg
force P at B along x
force F at K along -y
friction pins f diameter 12 mm
friction slider K 0.15
find k = P/F
let s = k*F
let h = 2*l
let t = s/h
require l < 1 m
expect k = 2*tan(alpha)
translate "upper" uk "верхня"
"""

CRANK = """
mechanism press
param r = 40 mm
param phi = 60 deg in 20 deg .. 120 deg
pivot O at (0 mm, 0 mm)
link OA
link AB "rod"
OA = r @ phi
AB = 120 mm
assembly ABC1 ccw
drive phi from 60 deg to 100 deg
torque M on OA
friction pin A 0.1 diameter 14 mm
"""

PRESS = """
mechanism press
param r = 30 mm
param b = 125 mm
param phi = 120 deg in 60 deg .. 165 deg
param T_l = 110 mm
param T_alpha: angle
pivot O at (160 mm, 100 mm)
pivot C1 at (0 mm, 210 mm)
slider K1 along y through C1
link OA
link AB
link C1B
link BK1
OA = r @ phi
AB = b
C1B = T_l @ -90 deg + T_alpha
BK1 = T_l
assembly K1 back
assembly ABC1 cw
drive phi from 60 deg to 165 deg
torque M on OA
force T_F at K1 along y
find k = M/T_F
find R_C1
"""

JOINED = f"""{CRANK}
use "toggle.mech" as T (l = 2*r + 20 mm) at (110 mm, 60 mm) joining T.B = B
find k = M/T_F
find R_T.C
"""

BY_HAND = f"""{CRANK}
let T_l = 2*r + 20 mm
param T_alpha: angle
param T_f = 0.1
pivot C1 at (110 mm, 60 mm)
slider K1 along y through C1
link C1B "upper (toggle)"
link BK1
C1B = T_l @ -90 deg + T_alpha
BK1 = T_l
assembly K1 back
force T_F at K1 along -y
friction pin C1 T_f diameter 12 mm
friction pin B T_f diameter 12 mm
friction pin K1 T_f diameter 12 mm
friction slider K1 0.15
let T_h = 2*T_l
require T_l < 1 m
require -20 deg <= T_alpha <= 40 deg
find k = M/T_F
find R_C1
"""


def written(folder: Path, text: str, **parts: str) -> Path:
    for name, part in {"toggle": TOGGLE, **parts}.items():
        (folder / f"{name}.mech").write_text(part, "utf-8")
    (folder / "whole.mech").write_text(text, "utf-8")
    return folder / "whole.mech"


def refused(path: Path) -> str:
    with pytest.raises(MechcError) as caught:
        mechc.load(path)
    return "\n".join(render(d, caught.value.source) for d in caught.value.diagnostics)


def assert_says(parts: set[str], text: str) -> None:
    assert {part for part in parts if part not in text} == set()


def forces(compilation: Compilation) -> Iterator[tuple[tuple[str, ...], list[float]]]:
    """Yield what acts on the bodies of every free-body diagram, and where."""
    for diagram in compilation.free_bodies:
        for body in diagram.bodies:
            for act in body.forces:
                place = diagram.result, diagram.motion, body.name, act.by, act.point
                yield place, [*(act.force or ()), act.moment]


def assert_same(joined: mechc.SolvedMechanism, hand: mechc.SolvedMechanism) -> None:
    """Assert that results along the stroke, and forces on bodies, are the same."""
    phi = np.linspace(1.1, 1.9, 7)
    results, expected = (m.evaluate(phi=phi, T_F=1000.0) for m in (joined, hand))
    assert results.keys() >= {"k", "R_C1_x"}
    for name in expected:
        np.testing.assert_allclose(results[name], expected[name], rtol=1e-12, err_msg=name)
    acting, wanted = (list(forces(m._compilation)) for m in (joined, hand))
    assert [place for place, _ in acting] == [place for place, _ in wanted]
    for (place, force), (_, other) in zip(acting, wanted, strict=True):
        assert force == pytest.approx(other, rel=1e-12, abs=1e-15), place


def ideal(text: str) -> str:
    """Return a description without its friction."""
    lines = (line for line in text.splitlines() if not line.startswith("friction"))
    return "\n".join(line for line in lines if "f = 0.1" not in line)


def k_of(path: Path) -> float:
    return float(mechc.SolvedMechanism(Compilation(files.read(path))).evaluate()["k"])


def points(path: Path) -> set[str]:
    return set(Compilation(files.read(path)).mechanism.spans)


def test_it_is_the_mechanism_written_by_hand() -> None:
    """Its formula, every result, and the force on every body."""
    path = ROOT / "examples" / "press" / "press.mech"
    joined, hand = mechc.load(path), mechc.loads(PRESS)
    assert joined.k == hand.k
    assert_same(joined, hand)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "$T$ is the mechanism toggle; its points $C$, $K$ and $B$ are $C_{1}$, $K_{1}$ and"),
        ("uk", "$T$ — механізм toggle; його точки $C$, $K$ та $B$ тут позначено $C_{1}$"),
        ("ru", "$T$ — механизм toggle; его точки $C$, $K$ и $B$ здесь обозначены $C_{1}$"),
    ],
)
def test_a_report_says_what_parts_are(language: str, said: str) -> None:
    mechanism = Compilation(files.read(ROOT / "examples" / "press" / "press.mech")).mechanism
    assert said in scheme(mechanism, locale(language), notation(language))[0]


@pytest.mark.slow
def test_friction_is_that_written_by_hand(tmp_path: Path) -> None:
    """Of one line for all pins, too: the joined pin has it, the pins of the crank have not."""
    joined, hand = mechc.load(written(tmp_path, JOINED)), mechc.loads(BY_HAND)
    assert np.isfinite(hand.evaluate()["k_f"])
    assert_same(joined, hand)


@pytest.mark.parametrize("point", ["T.K", "K1"])
def test_the_whole_gives_a_point_of_a_part_its_friction(tmp_path: Path, point: str) -> None:
    """By either name of the point: the line of the part about all its pins leaves it out."""
    thick = f"{JOINED}friction pin {point} 0.1 diameter 20 mm\n"
    joints = Compilation(files.read(written(tmp_path, thick))).mechanism.friction.joints
    pins = (pin for pin in joints if isinstance(pin, PinFriction))
    radii = {pin.point: evaluate(pin.radius, {"T_f": 0.1}) for pin in pins}
    assert (radii["K1"], radii["C1"]) == pytest.approx((1e-3, 6e-4))


def test_it_is_said_once_where_the_range_of_a_part_is_left(tmp_path: Path) -> None:
    """With the value that the loop gives, and that nothing was checked."""
    toggle = ideal(TOGGLE).replace("10 deg in -20 deg .. 40 deg", "85 deg in 85 deg .. 89 deg")
    toggle = toggle.replace("drive alpha from 5 deg to 40 deg", "")
    text = ideal(JOINED).replace("= B\n", "= B without alpha\n")
    compilation = Compilation(files.read(written(tmp_path, text, toggle=toggle)))
    assert compilation.verdict
    (warning,) = compilation.report.sorted()
    assert warning.code == "W601"
    assert "T_alpha = " in warning.message
    assert "expected at least 85 deg" in warning.message
    assert "no pose was found that meets the conditions of use" in warning.message


def test_what_rests_on_its_own_results_stays_behind(tmp_path: Path) -> None:
    mechanism = Compilation(files.read(written(tmp_path, JOINED))).mechanism
    assert {load.name for load in mechanism.loads} == {"M", "T_F"}
    assert [let.name for let in mechanism.lets] == ["T_h"]
    assert mechanism.translations["uk"]["upper (toggle)"] == "верхня (toggle)"


def test_coordinates_that_a_part_asks_for_stay_behind(tmp_path: Path) -> None:
    toggle = f"{TOGGLE}let up = y_B\nlet twice = 2*up\n"
    mechanism = Compilation(files.read(written(tmp_path, JOINED, toggle=toggle))).mechanism
    assert [let.name for let in mechanism.lets] == ["T_h"]


@pytest.mark.parametrize(
    ("alpha", "direction"),
    [
        ("1 deg in -10 deg .. 1 deg", "-90 deg + alpha"),
        ("270 deg in 269 deg .. 280 deg", "180 deg - alpha"),
        ("180 deg in 170 deg .. 2*90.5 deg", "90 deg + alpha"),
    ],
)
def test_the_range_of_what_a_loop_gives_is_a_condition(
    tmp_path: Path, alpha: str, direction: str
) -> None:
    """However the part counts its angle, what leaves the range is NaN; a whole turn leaves none."""
    toggle = ideal(TOGGLE).replace("-90 deg + alpha", direction).replace("drive alpha", "# ")
    path = written(tmp_path, ideal(JOINED).replace("= B\n", "= B without alpha\n"))
    phi = np.radians(np.linspace(60, 100, 41))
    bounded, free = (
        of_alpha(path, toggle, f"param alpha = {text}") for text in (alpha, f"{alpha} + 350 deg")
    )
    found, unbounded = (m.evaluate(phi=phi)["k"] for m in (bounded, free))
    link = np.degrees(free.points(phi=phi)[0]["phi_C1B"]) % 360
    within = (link >= 260) & (link <= 271)
    assert 3 < np.count_nonzero(within) < 38
    np.testing.assert_allclose(found, np.where(within, unbounded, np.nan), rtol=1e-12)


def of_alpha(path: Path, toggle: str, alpha: str) -> mechc.SolvedMechanism:
    """Return a whole whose part declares its angle so."""
    lines = (alpha if s.startswith("param alpha") else s for s in toggle.splitlines())
    path.with_name("toggle.mech").write_text("\n".join(lines), "utf-8")
    return mechc.load(path)


def test_a_frame_is_turned(tmp_path: Path) -> None:
    """A toggle that lies on its side, whose crank is turned back by as much, has the same k."""
    turned = JOINED.replace("at (110 mm, 60 mm)", "at (-60 mm, 110 mm) turned 90 deg")
    turned = turned.replace("r @ phi", "r @ phi + 90 deg")
    aslant = JOINED.replace("at (110 mm, 60 mm)", "at (x0, y0) turned 30 deg")
    aslant = aslant.replace("r @ phi", "r @ phi + 30 deg").replace(
        "use",
        "param x0 = 65.262794416288 mm\nparam y0 = 106.961524227066 mm\nuse",
    )
    texts = (ideal(text) for text in (JOINED, turned, aslant))
    first, *others = (k_of(written(tmp_path, text, toggle=ideal(TOGGLE))) for text in texts)
    assert others == pytest.approx([first, first], rel=1e-12)


def test_a_frame_lies_at_the_drawn_joint(tmp_path: Path) -> None:
    """The part is drawn in a frame of its own; its pin A falls on B of the whole."""
    bell = """
mechanism bell
pivot Q at (10 mm, 0 mm)
link AQD
A at (10 mm, 30 mm)
D at (50 mm, 0 mm)
force G at D along -y
force P at A along x
find k = P/G
"""
    whole = """
mechanism m
pivot O at (0 mm, 0 mm)
slider S along x
link OB
link BS
S at (60 mm, 0 mm)
B at (20 mm, 25 mm)
force P at S along -x
use "bell.mech" as L joining L.A = B without G
weight W mass 2 kg at L.D
find P
"""
    lever = whole.replace("pivot O at (0 mm, 0 mm)", "pivot O at (20 mm, -5 mm)")
    lever = lever.replace("link OB\n", "").replace("pivot O at (20 mm, -5 mm)\n", "")
    found = mechc.load(written(tmp_path, lever, bell=bell))
    hand = lever.replace('use "bell.mech" as L joining L.A = B without G', "").replace("L.D", "D1")
    hand += "pivot Q1 at (20 mm, -5 mm)\nlink BQ1D1\nD1 at (60 mm, -5 mm)\n"
    assert found.evaluate()["P"] == pytest.approx(mechc.loads(hand).evaluate()["P"], rel=1e-12)


def test_parts_are_joined_to_each_other(tmp_path: Path) -> None:
    """Two cranks on one slider: the moments are as their arms are."""
    text = """
mechanism pair
use crank_slider as S
use crank_slider as T (r = 30 mm) joining T.B = S.B, T.O = S.O
find k = S_M/T_M
find omega_T.OA/omega_S.OA
"""
    found = mechc.load(written(tmp_path, text))
    one, other = (mechc.load("crank_slider").evaluate(r=r)["k"] for r in (0.05, 0.03))
    assert abs(found.evaluate()["k"]) == pytest.approx(one / other, rel=1e-12)


def test_points_get_the_first_free_number(tmp_path: Path) -> None:
    text = JOINED.replace("assembly ABC1", "pivot O1 at (0 mm, 0 mm)\nassembly ABC1")
    text = text.replace("link OA", "pivot C1 at (9 mm, 9 mm)\nlink OA").replace("ABC1", "ABC2")
    assert {"C2", "K2"} <= points(written(tmp_path, text))
    second = text.replace("C2", "C7").replace("as T", "as T7").replace("T_", "T7_")
    assert {"C7", "K7"} <= points(written(tmp_path, second.replace("T.", "T7.")))


def test_a_pivot_of_the_library_is_joined_to_one_with_a_place(tmp_path: Path) -> None:
    """Whoever uses a part of the library does not write its file."""
    text = """
mechanism press
pivot O at (160 mm, 100 mm)
link OA
link AB
param phi = 60 deg
OA = 40 mm @ phi
AB = 120 mm
drive phi from 60 deg to 100 deg
use fedoriv_fig2a_knee as T at (0 mm, 210 mm) turned -90 deg joining T.B = B
torque M on OA
find k = M/T_W
"""
    assert_says({"E312", "or join it to", "`joining T.E = …`"}, refused(written(tmp_path, text)))


def test_errors_of_what_a_part_says(tmp_path: Path) -> None:
    """Both places stand in the message."""
    tied = TOGGLE.replace("force F", "force D = 0.1*P at K along x\nforce F")
    text = refused(written(tmp_path, JOINED, toggle=tied))
    assert_says({"E574", "without D", "force D = 0.1*P"}, text)
    heavy = TOGGLE.replace("force F", "gravity along x\nweight W mass 1 kg at K\nforce F")
    text = refused(written(tmp_path, JOINED, toggle=heavy))
    assert_says({"E910", "gravity along x", 'use "toggle.mech"'}, text)
    text = refused(written(tmp_path, JOINED.replace("turned", "").replace("60 mm)", "60)")))
    assert "60 what?" in text
    text = refused(written(tmp_path, JOINED.replace("at (110", "turned 90 at (110")))
    assert "whole.mech" in text
    whole = JOINED.replace("toggle.mech", "whole.mech")
    assert "E555" in refused(written(tmp_path, whole))


CRANK_BESIDE = """
mechanism crank
param r = 30 mm
param b = 150 mm
param phi = 100 deg
pivot A at (150 mm, 50 mm)
link AC
link CB
AC = r @ phi
CB = b
drive phi from 80 deg to 120 deg
torque M on AC
use "half.mech" as T (l = 110 mm) at (0 mm, 0 mm) joining T.B = B without P, alpha
assembly O1BC cw
find k = M/T_F
"""

HALF = """
mechanism half
param l = 100 mm
param alpha = 20 deg in 0 deg .. 40 deg
pivot O at (0 mm, 0 mm)
slider K along y
link OB
link BK
OB = l @ 90 deg + alpha
BK = l @ 90 deg - alpha
force P at B along x
force F at K along -y
find k = P/F
"""


def test_an_angle_that_rests_on_one_turned_back_is_not_a_turn_beyond_its_range(
    tmp_path: Path,
) -> None:
    """It was 361.09 deg where its range ends at 40 deg, and the code had no value there."""
    found = mechc.load(written(tmp_path, CRANK_BESIDE, half=HALF))
    assert np.isfinite(found.evaluate()["k"])
    assert [w.code for w in found.warnings if w.code in ("W221", "W601")] == []


def test_a_wrong_unit_and_a_pivot_without_place_of_a_part(tmp_path: Path) -> None:
    wrong = CRANK_BESIDE.replace("l = 110 mm", "l = 2 kN")
    text = refused(written(tmp_path, wrong, half=HALF))
    assert_says({"E559", "l = 2 kN", "param l = 100 mm"}, text)
    without = HALF.replace("pivot O at (0 mm, 0 mm)", "pivot O")
    text = refused(written(tmp_path, CRANK_BESIDE.replace("assembly O1BC cw\n", ""), half=without))
    assert_says({"E312", "`pivot O at (100 mm, 20 mm)`"}, text)


def test_remarks_of_a_part_keep_their_translations(tmp_path: Path) -> None:
    """A remark of a part ends with the part's name, as it does in a sheet, and so it is spoken."""
    toggle = TOGGLE.replace('as "length of both links"', "# length of both links")
    toggle += 'translate "length of both links" uk "довжина обох ланок"\n'
    path = written(tmp_path, JOINED, toggle=toggle)
    compilation = Compilation(files.read(path))
    spoken = compilation.mechanism.translations["uk"]
    assert spoken["length of both links (toggle)"] == "довжина обох ланок (toggle)"
    assert not [d for d in compilation.report.diagnostics if d.code == "W224"]
