"""Where friction locks or jams a mechanism, against formulas by hand; ranges of efficiencies."""

import math
from collections.abc import Iterable
from importlib import import_module

import numpy as np
import pytest

import mechc
from friction_chains import COUPLED
from friction_statements import refuted
from gripping_brake import gripping_brake
from mechc.api import SolvedMechanism
from mechc.cli.main import main
from mechc.compilation import Compilation
from mechc.formula.to_text import text
from mechc.report.languages.en import LOCALE
from mechc.source import Source
from mechc.study.analysis import Analysis
from mechc.study.locking_intervals import (
    EfficiencyRange,
    Locking,
    LockingInterval,
    LockingIntervals,
)
from mechc.study.states import RatioAlong
from paths import LIBRARY
from small_mechanisms import slider_crank, wedges
from sources import in_thirds

SAMPLED = LOCALE.sampled

ROD_TOGGLE = """
param l = 100 mm
param alpha = 10 deg in {low} deg .. 45 deg
param d = 10 mm
pivot O
slider C along y
link OB
link BC
OB = l @ 90 deg - alpha
BC = l @ 90 deg + alpha
force P at B along -x
force F at C along -y
friction pins 0.1 diameter d
{more}
find k = P / F
"""

FEDORIV = """
param alpha = {alpha} deg in 1 deg .. 45 deg
param L = 80 mm
param d = 10 mm
param D = 30 mm
slider A along x
slider C along y
link AC
AC = L @ 90 deg - alpha
force Q at A along x
force W at C along -y
friction pins 0.1 diameter d
friction roller A 0.1 axle d wheel D
find k = Q / W
"""

WEDGE = wedges()

CRANK = """
param a = 30 mm
param alpha = 60 deg in 5 deg .. 175 deg
pivot O
link OA
OA = a @ alpha
force P at A along x
torque M on OA
friction pin O 0.3 diameter 60 mm
{more}
find k = P / M
find i = M / P
"""

SLIDER_CRANK = slider_crank(
    "friction pins 0.15 diameter 12 mm",
    "friction slider B 0.1",
    "find k = F / M",
    r="40 mm",
    l="120 mm",
    phi="40 deg",
    drive="from 1 deg to 179 deg",
    along="x",
)


def results(description: str) -> dict[str, Analysis]:
    return {r.name: r for r in Compilation(Source("test.mech", description)).results}


def locking(description: str, name: str) -> Locking:
    found = results(description)[name].locking
    assert found is not None
    return found


def stretches(description: str, name: str) -> list[LockingInterval]:
    (reach,) = locking(description, name).reaches
    return list(reach.stretches)


def efficiency(description: str, name: str) -> EfficiencyRange:
    (found,) = results(description)[name].efficiency_ranges
    return found


def degrees(*angles: float) -> list[float]:
    return [math.degrees(angle) for angle in angles]


# ------------------------------------------------------------------------- conditions


def test_a_rod_toggle_locks_up_to_the_turn_of_its_rods():
    (stretch,) = stretches(ROD_TOGGLE.format(low=0.1, more=""), "k_hold")
    assert stretch.state == "locked"
    assert stretch.low is not None
    assert stretch.low.is_dead_centre
    assert stretch.low.x == 0
    assert stretch.high is not None
    assert stretch.high.exact is not None
    assert text(stretch.high.exact) == "delta_OB"
    turn = math.asin(0.1 * 10 / 100)
    assert stretch.high.x == pytest.approx(turn, rel=1e-14)
    assert stretch.within == pytest.approx((math.radians(0.1), turn), rel=1e-12)


def test_the_condition_is_stated_where_it_is_out_of_range():
    (stretch,) = stretches(ROD_TOGGLE.format(low=1, more=""), "k_hold")
    assert stretch.high is not None
    assert stretch.high.exact is not None
    assert stretch.within is None


TAPPET = """mechanism tappet
param e = 20 mm
param phi = 50 deg in 0 deg .. 360 deg
pivot O
link OC
slide TK along y
OC = e @ phi
contact C on TK normal -90 deg
torque M on OC
force F at K along -y
friction contact C 0.1
find k = M/F
"""


def test_beyond_a_range_of_a_whole_turn_nothing_is_stated():
    """What is locked from 444° on is locked from 84° on, which is stated."""
    found = stretches(TAPPET, "k_hold")
    assert degrees(*(s.high.x for s in found)) == pytest.approx([90, 275.7106], rel=1e-6)


def test_the_motion_named_releasing_locks_alike():
    there, here = (
        ROD_TOGGLE.format(low=0.1, more=""),
        ROD_TOGGLE.format(low=0.1, more="motion releasing"),
    )
    assert stretches(there, "k_hold") == stretches(here, "k_f")
    assert efficiency(here, "eta_k").least == 0


def test_fedoriv_locks_up_to_both_angles_of_friction():
    """Fig. 1 of Fedoriv and Fedoriv: tan(α − β) ≤ tan φ₁ᵣ, β = asin(f·d/L)."""
    (stretch,) = stretches(FEDORIV.format(alpha=10), "k_hold")
    assert stretch.high is not None
    assert stretch.high.exact is not None
    assert text(stretch.high.exact) == "delta_AC + atan(f*d/D)"
    by_hand = math.asin(0.1 / 8) + math.atan(0.1 / 3)
    assert stretch.high.x == pytest.approx(by_hand, rel=1e-14)


@pytest.mark.parametrize(("along", "name"), [("x", "k_hold"), ("-x", "k_f")])
def test_a_wedge_locks_up_to_twice_the_angle_of_friction(along, name):
    """With P's arrow against the push k is negative, and P's motion along it the load's."""
    description = WEDGE.replace("W along x", f"W along {along}")
    (stretch,) = stretches(description, name)
    assert stretch.high is not None
    assert stretch.high.exact is not None
    assert text(stretch.high.exact) == "phi_A + atan(mu)"
    assert stretch.high.x == pytest.approx(2 * math.atan(0.1), rel=1e-14)
    assert locking(description, name).state == "locked"


def test_a_crank_locks_where_its_arm_is_inside_the_friction_circle():
    """M turns the crank against P where a·sin α exceeds ρ, on either side."""
    limit = math.degrees(math.asin(0.3 * 60 / 2 / 30))
    for name, state in (("i_hold", "locked"), ("k_f", "jammed")):
        first, last = stretches(CRANK.format(more=""), name)
        assert {first.state, last.state} == {state}
        assert first.within is not None
        assert last.within is not None
        assert degrees(*first.within) == pytest.approx([5, limit])
        assert degrees(*last.within) == pytest.approx([180 - limit, 175])
    for name in ("i_f", "k_hold"):
        assert not stretches(CRANK.format(more=""), name)


def test_without_a_range_the_condition_is_stated_all_the_same():
    description = ROD_TOGGLE.format(low=1, more="").replace(" in 1 deg .. 45 deg", "")
    (reach,) = locking(description, "k_hold").reaches
    assert reach.range is None
    (stretch,) = reach.stretches
    assert stretch.high is not None
    assert stretch.high.exact is not None
    assert stretch.within is None


def test_beyond_a_range_in_which_it_moves_it_is_looked_at_when_that_is_asked_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """No formula gives where it jams near 90°, so that nothing is said of it."""
    seen: list[float] = []
    look = RatioAlong._look
    monkeypatch.setattr(RatioAlong, "_look", lambda self, x: seen.append(x) or look(self, x))
    found = results((LIBRARY / "karpenko_fig9_with_friction.mech").read_text())
    reach = next(r for r in found["k_f"].locking.reaches if r.parameter == "alpha")
    assert reach.of_interest == ()
    assert math.radians(39) < max(seen) < math.radians(41)
    (stretch,) = reach.stretches
    assert (stretch.state, stretch.within) == ("jammed", None)
    assert max(seen) > math.radians(89)


def test_the_form_for_elsewhere_is_made_where_the_closed_form_has_no_value(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made: list[object] = []
    friction_results = import_module("mechc.friction.results")  # what waits has no name to restore
    make = friction_results._elsewhere
    monkeypatch.setattr(
        friction_results, "_elsewhere", lambda *given: made.append(given) or make(*given)
    )
    found = results((LIBRARY / "karpenko_fig9_with_friction.mech").read_text())
    assert not made
    assert all(reach.stretches for reach in found["k_f"].locking.reaches)
    assert made


@pytest.mark.parametrize("low", ["0.1", "1"])
def test_where_a_formula_gives_the_end_of_a_stretch_beyond_the_range_it_is_of_interest(low):
    (reach,) = locking(ROD_TOGGLE.format(low=low, more=""), "k_hold").reaches
    assert reach.of_interest == reach.stretches != ()


# ------------------------------------------------------------------------ closed poses


def test_a_slider_crank_jams_near_both_dead_centres():
    first, last = stretches(SLIDER_CRANK, "k_f")
    assert (first.low, last.high) == (None, None)
    assert first.high is not None
    assert last.low is not None
    mechanism = mechc.loads(SLIDER_CRANK)
    for end, way in ((first.high.x, 1), (last.low.x, -1)):
        beside, inside = (mechanism.evaluate(phi=end + way * x) for x in (1e-9, -1e-4))
        assert beside["k_f"] > 1e5 * abs(beside["k"])
        assert math.isnan(inside["k_f"])


def test_no_force_turns_a_crank_from_beyond_its_friction_circle():
    """Where the arm of the rod has another sign than without friction nothing balances."""
    mechanism = mechc.loads(SLIDER_CRANK)
    found = mechanism.evaluate(phi=[math.radians(x) for x in (0.5, 1, 177, 178.5, 179.5)])
    assert all(math.isnan(k) for k in found["k_f"])


@pytest.mark.parametrize("f", ["0", "0.1"])
def test_a_lever_without_friction_has_a_ratio(f):
    description = CRANK.format(more="").replace("pin O 0.3", f"pin O {f}")
    found = mechc.loads(description).evaluate()
    assert found["k_f"] >= found["k"] > 0


# --------------------------------------------------------------------------- efficiency


@pytest.mark.parametrize(
    ("alpha", "eta"), [(1, 0.276), (2, 0.432), (5, 0.656), (10, 0.792), (20, 0.884), (45, 0.945)]
)
def test_efficiencies_of_fedoriv(alpha, eta):
    found = mechc.loads(FEDORIV.format(alpha=alpha)).evaluate()
    assert found["eta_k"] == pytest.approx(eta, abs=5e-4)


def by_hand(alpha: float) -> float:
    return math.tan(alpha) / (math.tan(alpha + math.asin(0.1 / 8)) + 0.1 / 3)


def test_what_an_efficiency_runs_through():
    found = efficiency(FEDORIV.format(alpha=10), "eta_k")
    assert found.least == pytest.approx(by_hand(math.radians(1)))
    assert found.greatest == pytest.approx(by_hand(math.radians(45)))
    ((low, high),) = found.usual
    assert by_hand(low) == pytest.approx(0.9)
    assert high == math.radians(45)


def test_an_efficiency_is_zero_where_nothing_moves():
    assert efficiency(SLIDER_CRANK, "eta_k").least == 0


def test_the_efficiency_of_what_the_load_drives_is_below_one():
    """With the arrow of P turned round M drives, and P takes what arrives."""
    description = CRANK.format(more="").replace("along x", "along -x")
    found = mechc.loads(description).evaluate()
    assert found["k"] < 0
    assert 0 < found["eta_k"] < 1


# ------------------------------------------------------------------------------ wording


def stated(description: str, tmp_path, capsys, *command: str) -> str:
    path = tmp_path / "m.mech"
    path.write_text(description, encoding="utf-8")
    assert main([*command, str(path)]) == 0
    return " ".join(capsys.readouterr().out.split())


def test_check_states_the_condition(tmp_path, capsys):
    out = stated(ROD_TOGGLE.format(low=0.1, more=""), tmp_path, capsys, "check")
    assert (
        "Self-locking: F alone cannot move the mechanism for alpha <= delta_OB (0.573 deg)" in out
    )
    assert "in the range given for 0.1 deg <= alpha <= 0.573 deg" in out
    assert "eta_k runs from 0.149 to 0.98; it is between 0.9 and 0.95 for 5.19 deg" in out


CAM = """
param delta = 85 deg in 80 deg .. 89 deg
param rho = 2 deg
pivot O
slide KW along y
link OAB
contact A on KW normal 180 deg - delta
OA = 70 mm @ 90 deg
OB = 90 mm @ 90 deg
force P at K along y
force N at B along 0 deg
friction contact A tan(rho)
find n = N/P
"""


@pytest.mark.parametrize(
    ("language", "driving", "held"),
    [
        ("en", "No force P can move the mechanism", "Self-locking: P alone cannot move"),
        ("uk", "Жодна сила P не може зрушити механізм", "Самогальмування: сила P сама не може"),
        ("ru", "Никакая сила P не может сдвинуть механизм", "Самоторможение: сила P одна не"),
    ],
)
def test_no_self_locking_is_said_of_the_load_that_is_said_to_drive(
    language, driving, held, tmp_path, capsys
):
    """P drives in the motion that is asked for, and elsewhere that which N holds back."""
    command = ("check", "--lang", language)
    out = stated(CAM + "motion releasing", tmp_path, capsys, *command)
    assert driving in out
    assert held not in out
    out = stated(CAM, tmp_path, capsys, *command)
    assert held in out
    assert driving not in out


def test_check_states_what_is_locked_as_given(tmp_path, capsys):
    out = stated(WEDGE, tmp_path, capsys, "check")
    assert "Self-locking: F alone cannot move the mechanism at the values given." in out


@pytest.mark.parametrize(("condition", "states"), [("", ["jammed"]), ("require 2*mu*h < b", [])])
def test_nothing_jams_where_a_condition_of_use_fails(condition, states):
    """A floor does not pull: what a guide would do there is not said of a cabinet that tips."""
    text = (LIBRARY / "cabinet_on_casters.mech").read_text("utf-8")
    found = results(text.replace("require 2*mu*h < b", condition))["P_f"].locking
    assert found is not None
    (along,) = (reach for reach in found.reaches if reach.parameter == "mu")
    assert [part.state for part in along.of_interest] == states


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
def test_the_report_states_the_condition(language, tmp_path, capsys):
    out = tmp_path / "m.tex"
    description = FEDORIV.format(alpha=10)
    stated(description, tmp_path, capsys, "compile", "--lang", language, "-o", str(out))
    assert r"$\alpha\leq \delta_{AC}+" in out.read_text("utf-8")


@pytest.mark.parametrize(("command", "times"), [("check", 1), ("derive", 1)])
def test_what_is_sampled_is_called_so_and_what_is_solved_is_not(command, times, tmp_path, capsys):
    """The end of self-locking is a formula here; the efficiency is looked at place by place."""
    out = stated(ROD_TOGGLE.format(low=0.1, more=""), tmp_path, capsys, command)
    assert out.count(SAMPLED) == times
    assert 0 < out.index("runs from") < out.index(SAMPLED)
    (stretch,) = locking(ROD_TOGGLE.format(low=0.1, more=""), "k_hold").reaches[0].stretches
    assert not stretch.sampled


def test_stretches_of_coupled_friction_are_sampled():
    stuck = [
        s
        for name in ("k_f", "k_hold")
        for reach in locking(COUPLED, name).reaches
        for s in reach.stretches
    ]
    assert [s.sampled for s in stuck] == [True, True]


# ------------------------------------------------------------------------------- stroke


def test_the_stroke_takes_signs_from_each_pose():
    """Slips at B change their sign in the middle, where the printed case ends: k_f jumps."""
    mechanism = mechc.loads(SLIDER_CRANK)
    stroke = mechanism.stroke(points=9)
    names = [c.name for c in stroke.columns]
    found = mechanism.evaluate(phi=[row.drive for row in stroke.rows])
    for name in ("k_f", "k_f1", "k_hold", "eta_k"):
        column = [row.values[names.index(name)] for row in stroke.rows]
        middle = math.nan if name in stroke.rows[4].undetermined else found[name][4]
        expected = [*found[name][:4], middle, *found[name][5:]]
        assert column == pytest.approx(expected, rel=1e-12, nan_ok=True)
        assert math.isnan(column[4]) == (name != "k_f1")
    assert math.isnan(stroke.rows[0].values[names.index("k_f")])


def test_the_stroke_states_where_nothing_moves():
    stroke = mechc.loads(SLIDER_CRANK).stroke()
    first, last = stretches(SLIDER_CRANK, "k_f")
    assert [(s.result, s.state, s.low, s.high) for s in stroke.standstills] == [
        ("k_f", "jammed", *(first.within or ())),
        ("k_f", "jammed", *(last.within or ())),
    ]
    ((name, found),) = stroke.efficiency_ranges
    assert (name, found) == ("eta_k", efficiency(SLIDER_CRANK, "eta_k"))


def test_the_table_of_the_stroke_states_it_in_words(tmp_path, capsys):
    out = stated(ROD_TOGGLE.format(low=0.1, more="drive alpha"), tmp_path, capsys, "stroke")
    assert "k_hold: self-locking, the load alone moves nothing, from alpha = 0.1 deg" in out
    assert "eta_k runs from 0.149 to 0.98; it is between 0.9 and 0.95 from alpha" in out


@pytest.mark.parametrize(
    ("language", "driving", "row", "held"),
    [
        ("en", "k_f: no force F can move the mechanism, from", "k_f locked", "self-locking"),
        ("uk", "k_f: жодне значення F не може зрушити", "k_f: нерухомо", "самогальмування"),
        ("ru", "k_f: никакое значение F не может сдвинуть", "k_f: неподвижно", "самоторможение"),
    ],
)
def test_the_stroke_says_no_self_locking_of_the_load_that_is_said_to_drive(
    language, driving, row, held, tmp_path, capsys
):
    """As reports do: with ``motion releasing`` F drives."""
    command = ("stroke", "--lang", language)
    released = ROD_TOGGLE.format(low=0.1, more="drive alpha\nmotion releasing")
    out = stated(released, tmp_path, capsys, *command)
    assert driving in out
    assert row in out
    assert held not in out
    out = stated(ROD_TOGGLE.format(low=0.1, more="drive alpha"), tmp_path, capsys, *command)
    assert held in out
    assert driving not in out


# ------------------------------------------------------------------- constant efficiency


def warned(description: str) -> list[str]:
    return [f"{d.code} {d.message}" for d in mechc.loads(description).warnings]


def test_a_constant_efficiency_is_held_against_friction():
    """δ = asin(f·d/l) turns the rods: η = tan α/tan(α + δ)."""
    description = ROD_TOGGLE.format(low=1, more="efficiency 0.9").replace("d = 10", "d = 12")
    (message,) = warned(description)
    assert message.startswith("W511 the efficiency is given as 0.9, but friction makes it 0.59")
    low, high = (
        math.radians(float(part.split(" deg")[0]))
        for part in (message.split(" .. ")[1], message.split("for alpha = ")[2])
    )
    for place, eta in ((low, 0.85), (high, 0.95)):
        assert math.tan(place) / math.tan(place + math.asin(0.012)) == pytest.approx(eta, abs=1e-4)


def test_a_constant_efficiency_near_the_truth_passes():
    description = ROD_TOGGLE.format(low=1, more="efficiency 0.93").replace(
        "1 deg .. 45", "7 deg .. 20"
    )
    assert not warned(description)


@pytest.mark.parametrize(("low", "high", "seen"), [(1, 45, True), (7.3, 45, False)])
def test_a_constant_efficiency_is_doubted_near_a_dead_centre(low, high, seen):
    """d ln tan α/dα = 2/sin 2α is 8 at 7.239°."""
    description = ROD_TOGGLE.format(low=low, more="efficiency 0.9").replace(
        "friction pins 0.1", "#"
    )
    found = [w for w in warned(description) if w.startswith("W512")]
    assert bool(found) == seen
    if seen:
        assert f"alpha = 1 deg .. {math.degrees(math.asin(0.25)) / 2:.4g} deg" in found[0]


@pytest.mark.parametrize("name", ["d45_12_worm_sectors", "table_4_4_gear", "d45_10_two_screws"])
def test_an_efficiency_away_from_dead_centres_is_not_doubted(name):
    found = mechc.load(f"{name}_with_efficiency").warnings
    assert not [w for w in found if w.code in ("W511", "W512")]


@pytest.mark.parametrize(("along", "k_f"), [("-x", 1 / 0.8), ("x", 0.8)])
def test_an_efficiency_takes_from_the_load_that_drives(along, k_f):
    """With P's arrow turned round k is negative, and F drives."""
    description = ROD_TOGGLE.format(low=8, more="efficiency 0.8").replace("friction pins 0.1", "#")
    found = mechc.loads(description.replace("B along -x", f"B along {along}")).evaluate()
    assert found["k_f"] / found["k"] == pytest.approx(k_f)


def test_what_jams_as_given_has_no_value_and_a_warning():
    mechanism = mechc.loads(CRANK.format(more="").replace("alpha = 60", "alpha = 10"))
    assert [w.code for w in mechanism.warnings] == ["W513"]
    assert math.isnan(mechanism.evaluate()["k_f"])
    assert mechanism.evaluate()["i_hold"] <= 0 or math.isnan(mechanism.evaluate()["i_hold"])


# -------------------------------------------------------------- both sides of a dead centre

TOGGLE = """
param l = 100 mm
param r = {r} mm
param alpha = 10 deg
drive alpha from -20 deg to 45 deg
param d = 10 mm
pivot O
slider C along y through O
link OB
link BC
OB = l @ 90 deg - alpha
BC = r
assembly C forward
force P at B along -x
force F at C along -y
friction pins 0.1 diameter d
find k = P / F
"""

FACES = wedges("param gamma = 5 deg in 0 deg .. 20 deg", along="-gamma")


@pytest.mark.parametrize("r", [100, 140])
def test_a_toggle_locks_on_both_sides_of_its_dead_centre(r):
    """The lines of both rods turn by 2ρ over their lengths; they fall together at α = 2ρ/l."""
    description = TOGGLE.format(r=r)
    limit = 0.01
    ((before,), (after,)) = (stretches(description, name) for name in ("k_f", "k_hold"))
    assert before.within == pytest.approx((-limit, 0), rel=1e-4, abs=1e-12)
    assert after.within == pytest.approx((0, limit), rel=1e-4, abs=1e-12)
    assert before.high is not None
    assert after.low is not None
    assert before.high.is_dead_centre
    assert after.low.is_dead_centre


def test_faces_of_a_wedge_lock_between_both_slopes():
    """Locked while |β − γ| of the faces is below twice the angle of friction.

    Where β < γ the load pushes the wedge along P.
    """
    over, under = (
        stretch
        for name in ("k_hold", "k_f")
        for stretch in locking(FACES, name).reaches[0].stretches
        if stretch.state == "locked"
    )
    assert over.low is not None
    assert over.high is not None
    assert over.low.exact is not None
    assert over.high.exact is not None
    assert text(over.low.exact) == "gamma"
    assert text(over.high.exact) == "gamma + phi_A + atan(mu)"
    turn = math.degrees(2 * math.atan(0.1))
    assert degrees(over.low.x, over.high.x) == pytest.approx([5, 5 + turn])
    assert under.within is not None
    assert degrees(*under.within) == pytest.approx([2, 5])


def test_a_constant_efficiency_is_held_against_friction_that_is_iterated():
    """Beside a dead centre nothing arrives, on however short a stretch."""
    description = f"{with_friction_everywhere('crank_rocker')}efficiency 0.97\n"
    (message,) = (m for m in warned(description) if m.startswith("W511"))
    assert message.count("0 … 0.92 for phi") == 2


def test_an_efficiency_is_that_of_whichever_load_drives():
    """Beyond the dead centre F drives the toggle along P, and P takes what arrives."""
    mechanism = mechc.loads(ROD_TOGGLE.format(low=1, more=""))
    alpha, turn = math.radians(10), math.asin(0.01)
    there, here = (mechanism.evaluate(alpha=a)["eta_k"] for a in (-alpha, alpha))
    assert here == pytest.approx(math.tan(alpha) / math.tan(alpha + turn))
    assert there == pytest.approx(math.tan(alpha - turn) / math.tan(alpha))
    assert mechanism.evaluate(alpha=0.0)["eta_k"] == 0
    assert mechanism.evaluate(alpha=-turn / 2)["eta_k"] == 0


@pytest.mark.parametrize(("motion", "sense"), [("tightening", 1), ("releasing", -1)])
def test_a_constant_efficiency_takes_from_whichever_load_drives(motion, sense):
    more = f"efficiency 0.8\nmotion {motion}"
    description = ROD_TOGGLE.format(low=1, more=more).replace("friction pins 0.1", "#")
    mechanism = mechc.loads(description)
    for alpha in (0.2, -0.2):
        found = mechanism.evaluate(alpha=alpha)
        share = 0.8 ** (-sense * math.copysign(1, alpha))
        assert found["k_f"] == pytest.approx(share * found["k"])


def test_the_condition_of_an_efficiency_is_stated(tmp_path, capsys):
    out = stated(TOGGLE.format(r=140), tmp_path, capsys, "check")
    assert "holds while k > 0" in out
    assert "for -0.573 deg <= alpha < 0 deg. " in out
    assert "for 0 deg < alpha <= 0.573 deg. " in out
    assert "eta_k runs from 0 (nothing moves) to 0.983" in out


@pytest.mark.parametrize("command", ["derive", "stroke"])
def test_an_efficiency_next_to_a_limit_has_as_many_digits_as_keep_it_apart(
    command, tmp_path, capsys
):
    """At 23.4° it is 0.8997, below 0.9, and not within 0.9 to 0.95."""
    assert round(by_hand(math.radians(23.4)), 4) == 0.8997
    description = FEDORIV.format(alpha=30).replace("in 1 deg", "in 23.4 deg")
    drive = "drive alpha from 23.4 deg to 45 deg\n" if command == "stroke" else ""
    out = stated(description + drive, tmp_path, capsys, command)
    assert "runs from 0.8997 to 0.945; it is between 0.9 and 0.95" in out


@pytest.mark.parametrize("points", in_thirds([66, 651]))
def test_each_row_of_a_stroke_states_what_is_stuck(points, tmp_path, capsys):
    path = tmp_path / "m.mech"
    path.write_text(TOGGLE.format(r=100), encoding="utf-8")
    assert main(["stroke", "--csv", "-n", str(points), str(path)]) == 0
    head, *rows = (line.split(",") for line in capsys.readouterr().out.splitlines())
    drive, hold = (head.index(name) for name in ("alpha [deg]", "k_hold"))
    stuck = head.index("stuck") if "stuck" in head else len(head)
    for row in rows:
        alpha = math.radians(float(row[drive]))
        if abs(alpha) > 1e-6:
            assert ("k_hold locked" in ",".join(row[stuck:])) == (0 < alpha <= 0.01)
            assert ("k_f locked" in ",".join(row[stuck:])) == (-0.01 <= alpha < 0)
            assert (float(row[hold]) <= 0) == (alpha <= 0.01)


def test_the_stroke_has_no_extrema_of_an_efficiency_where_nothing_moves():
    stroke = mechc.loads(TOGGLE.format(r=140)).stroke()
    assert not [e for e in stroke.extrema if e.result == "eta_k" and not 0 < e.value <= 1]
    column = [c.name for c in stroke.columns].index("eta_k")
    assert all(row.values[column] < 1 for row in stroke.rows)


# ------------------------------------------------------------- ranges of other parameters

ECCENTRIC = """
param R = 30 mm
param e = 3 mm in 1 mm .. 10 mm
param phi = 10 deg in -80 deg .. 80 deg
param mu = 0.15 in 0.05 .. 0.3
pivot O
slide AV along y
link OH
OH = 120 mm @ phi + 180 deg
OA = (e*cos(phi), -R - e*sin(phi))
contact A on OH normal -90 deg
force P at H along y
force F at V along y
friction contact A mu
find k = P / F
"""

NUT = """
param p = 4 mm in 1 mm .. 10 mm
param d = 20 mm
param mu = 0.1 in 0 .. 0.2
pivot O
slider A along x
link OB
OB = @ 0 deg
screw A pitch p on OB
torque M on OB
force F at A along -x
friction screw A mu thread d
find k = M / F
"""


def reached(description: str, name: str) -> dict[str, LockingInterval]:
    found = {r.parameter: r.stretches for r in locking(description, name).reaches}
    return {parameter: stretch for parameter, (stretch,) in found.items()}


def test_an_eccentric_locks_while_it_is_small_against_the_friction_on_its_rim():
    """e·cos φ ≤ μ·(R + e·sin φ): the moments of F and of its friction about the pivot."""
    found = reached(ECCENTRIC, "k_hold")
    e, mu, phi = found["e"].high, found["mu"].low, math.radians(10)
    assert e is not None
    assert mu is not None
    assert e.exact is not None
    assert text(e.exact) == "R*sin(phi_A)/cos(phi + phi_A)"
    assert e.x == pytest.approx(0.15 * 0.03 / (math.cos(phi) - 0.15 * math.sin(phi)))
    assert mu.x == pytest.approx(3 * math.cos(phi) / (30 + 3 * math.sin(phi)))
    assert found["phi"].within == pytest.approx((math.radians(-80), math.radians(80)))


def test_a_nut_locks_below_the_pitch_that_friction_holds():
    """tan ψ = p/(πd) ≤ μ."""
    found = reached(NUT, "k_hold")
    pitch, mu = found["p"].high, found["mu"].low
    assert pitch is not None
    assert mu is not None
    assert [text(b.exact) for b in (pitch, mu) if b.exact] == ["pi*mu*d", "p/(pi*d)"]
    assert pitch.x == pytest.approx(math.pi * 0.02 * 0.1)
    assert mu.x == pytest.approx(0.004 / (math.pi * 0.02))


def test_what_an_efficiency_runs_through_over_a_coefficient():
    """η = tan ψ/tan(ψ + arctan μ) falls from 1."""
    (efficiency,) = (c for c in results(NUT)["eta_k"].efficiency_ranges if c.parameter == "mu")
    psi = math.atan(0.004 / (math.pi * 0.02))
    assert efficiency.greatest == pytest.approx(1)
    assert efficiency.least == pytest.approx(math.tan(psi) / math.tan(psi + math.atan(0.2)))


def test_lengths_are_stated_in_their_unit(tmp_path, capsys):
    out = stated(ECCENTRIC, tmp_path, capsys, "check")
    assert "(4.694 mm), in the range given for 1 <= e <= 4.694 mm." in out


def test_an_efficiency_of_one_runs_over_no_range(tmp_path, capsys):
    description = ROD_TOGGLE.format(low=1, more="").replace("pins 0.1", "pins 0")
    out = stated(description, tmp_path, capsys, "check")
    assert "eta_k = 1" in out
    assert "throughout" not in out


# --------------------------------------------------------------------------- the referee

BRAKE = """
param a = 40 mm
param h = 15 mm
param b = 100 mm
param mu = {mu}
param gamma = 10 deg
pivot O
slide WX along x
link OAB
OA = (a, -h)
OB = (a + b, 0 mm)
contact A on WX normal 90 deg - gamma
force P at B along -y
force F at W along x
friction contact A mu
find k = P / F
"""


@pytest.mark.parametrize("mu", [0.1, 0.3, 1, 4])
def test_a_face_steep_against_its_friction_is_judged(mu, tmp_path, capsys):
    """The force on the face is turned by the angle of friction: moments of it about O.

    Friction relieves the face by more than it is once μ exceeds tan γ.
    """
    found = mechc.loads(BRAKE.format(mu=mu)).evaluate()
    turn, steep = math.atan(mu), math.radians(10)
    by_hand = (40 / math.tan(steep + turn) + 15) / 140
    assert found["k_hold"] == pytest.approx(by_hand)
    assert math.isnan(found["k_f"]) == (turn > steep)
    out = stated(BRAKE.format(mu=mu), tmp_path, capsys, "check")
    assert f"agrees in {8 if turn > steep else 12} trials" in out


def test_a_wedge_is_judged_by_the_force_that_it_gives(tmp_path, capsys):
    description = WEDGE.replace("k = P / F", "n = F / P").replace(" in 2 deg .. 30 deg", "")
    out = stated(description, tmp_path, capsys, "check")
    assert "move the mechanism for 0 deg < beta <= phi_A + atan(mu) (11.42 deg)." in out
    assert "equilibrium of the free bodies agrees" in out


@pytest.mark.parametrize("mu", [0.3, 0.4])
def test_a_brake_that_grips_by_itself_is_said_to_jam(mu, tmp_path, capsys):
    """Without friction M is 0 everywhere; with it the band grips at CA = CB·exp(π·μ).

    At μ = 0, an end of the range, nothing resists at all.
    """
    brake = gripping_brake(f"{mu} in 0 .. 0.5", "find M\nlet P = 300 N")
    result = mechc.loads(brake).results["M_f"]
    (reach,) = result.locking.reaches
    (part,) = reach.stretches
    assert (part.state, part.within) == ("jammed", (pytest.approx(math.log(3) / math.pi), 0.5))
    assert result.locking.state == ("free" if mu < math.log(3) / math.pi else "jammed")
    out = stated(brake, tmp_path, capsys, "check")
    assert "Jammed: no force M can move the mechanism for 0.3497 <= mu <= 0.5." in out
    assert out.count("can move") == (1 if mu == 0.3 else 2)
    assert SAMPLED in out


BLOCK_BRAKE = """
param mu = 0.35 in 0.1 .. 1.2
param h = 60 mm
pivot O at (0 mm, 0 mm)
pivot C at (-50 mm, 200 mm {side} h)
link OG "drum"
link CAH "lever"
OG = 200 mm @ 0 deg
A at (0 mm, 200 mm)
H at (600 mm, 240 mm)
contact A on OG normal 90 deg
torque M on OG
force P at H along -y
friction contact A mu
find M
let P = 300 N
"""


@pytest.mark.parametrize(("side", "jammed"), [("+", "M_f"), ("-", "M_hold")])
def test_a_moment_that_is_zero_but_for_its_form_is_one(side, jammed):
    """M = (1 + x_C/(x_A − x_C))·…·P with x_A = 0: no power is meant to arrive.

    Moments about C are N·50 mm ∓ μ·N·h, so that the block grips at μ = 50/60.
    """
    found = mechc.loads(BLOCK_BRAKE.format(side=side)).results
    assert "eta_M" not in found
    for name in ("M_f", "M_hold"):
        parts = [part for reach in found[name].locking.reaches for part in reach.stretches]
        assert {part.state for part in parts if part.within} <= {"jammed"}
        within = [part.within for part in parts if part.within]
        assert within == ([(pytest.approx(50 / 60), 1.2)] if name == jammed else [])


# ----------------------------------------------------------------------------------- laws


WITH_FRICTION = [
    "claw", "d45_05_wedge_roller_lever", "d45_06_double_wedge", "d45_11_screw_lever",
    "d45_15_cam_lever", "d45_16_wedge_hook", "fedoriv_fig1", "fedoriv_fig2a", "fedoriv_fig2b",
    "karpenko_fig1", "karpenko_fig3", "karpenko_fig4", "karpenko_fig7", "karpenko_fig9",
    "lever_clamp", "screw_jack", "tongs_fig4_9", "wedge_drive",
]  # fmt: skip

OWN = {
    "rod toggle": ROD_TOGGLE.format(low=0.1, more=""), "wedge": WEDGE,
    "crank": CRANK.format(more=""),
    "slider crank": SLIDER_CRANK, "toggle": TOGGLE.format(r=140), "faces": FACES,
    "eccentric": ECCENTRIC, "nut": NUT,
    "yoke": """
param r = 40 mm in 10 mm .. 60 mm
param mu = 0.1 in 0 .. 0.5
param phi = 40 deg
drive phi from 1 deg to 179 deg
pivot O
slide BC along x
link OA
OA = r @ phi
slot A in BC
BC = @ 90 deg
torque M on OA
force F at B along x
friction contact A mu
friction slider B 0.1
friction pin O 0.1 diameter 12 mm
find k = M / F
find i = F / M
""",
}  # fmt: skip


def with_friction_everywhere(name: str) -> str:
    """Return a mechanism of the library with friction in all its pins."""
    source = (LIBRARY / f"{name}.mech").read_text(encoding="utf-8")
    lines = [line for line in source.splitlines() if not line.startswith("expect")]
    return "\n".join((*lines, "friction pins 0.1 diameter 6 mm", ""))


OWN |= {name: with_friction_everywhere(name) for name in ("crank_rocker", "watt_closed")}


def along(ends: tuple[float, float]) -> list[float]:
    low, high = ends
    return [low + (high - low) * (i + 0.37) / 61 for i in range(61)]


def is_within(place: float, parts: Iterable[tuple[float, float] | None]) -> bool:
    return any(part is not None and part[0] <= place <= part[1] for part in parts)


def assert_stuck(mechanism: SolvedMechanism, result: Analysis, reach: LockingIntervals) -> None:
    """Inside a stretch k with friction has not the sign of k, or no value; outside it has."""
    assert reach.range is not None
    places = along(reach.range)
    found = mechanism.evaluate(**{reach.parameter: places})
    ideal = result.name.removesuffix("_f").removesuffix("_hold")
    share = np.broadcast_to(found[result.name] / found[ideal], len(places))
    for place, value in zip(places, share, strict=True):
        stated = is_within(place, (s.within for s in reach.stretches))
        assert stated == (not value > 0), (result.name, reach.parameter, place)


SHOWN = 1e-5
"""Efficiencies are shown in three figures, and narrowed down to somewhat more."""


def assert_run(mechanism: SolvedMechanism, result: Analysis, efficiency: EfficiencyRange) -> None:
    """An efficiency stays within what is stated, and is usual just where that is stated."""
    places = along(efficiency.range)
    found = mechanism.evaluate(**{efficiency.parameter: places})[result.name]
    share = np.broadcast_to(np.fmax(found, 0), len(places))
    for place, eta in zip(places, share, strict=True):
        assert efficiency.least - SHOWN <= eta <= efficiency.greatest + SHOWN
        assert is_within(place, efficiency.usual) == (0.9 <= eta <= 0.95), (
            efficiency.parameter,
            place,
        )


@pytest.mark.parametrize("name", in_thirds([*WITH_FRICTION, *OWN]))
def test_what_is_stated_is_true_of_code(name):
    mechanism = mechc.loads(OWN[name]) if name in OWN else mechc.load(f"{name}_with_friction")
    for result in mechanism.results.values():
        for reach in result.locking.reaches if result.locking else ():
            if reach.range is not None:
                assert_stuck(mechanism, result, reach)
        for efficiency in result.efficiency_ranges:
            assert_run(mechanism, result, efficiency)


INCLINE = """
param gamma = 20 deg in 0 deg .. 60 deg
param mu = 0.3 in 0 .. 1
param m = 10 kg in 1 kg .. 20 kg
slide AB along gamma
force P at A along gamma
weight W mass m at B
friction slider A mu
find P
"""


def test_a_weight_on_an_incline_stays_where_friction_holds_it():
    found = reached(INCLINE.replace(" in 1 kg .. 20 kg", ""), "P_hold")
    gamma, mu = found["gamma"].high, found["mu"].low
    assert gamma is not None
    assert mu is not None
    assert [text(b.exact) for b in (gamma, mu) if b.exact] == ["atan(mu)", "tan(gamma)"]


def test_an_efficiency_has_no_range_over_what_it_does_not_depend_on():
    efficiency_ranges = results(INCLINE)["eta_P"].efficiency_ranges
    assert [c.parameter for c in efficiency_ranges] == ["gamma", "mu"]


def test_a_pose_at_which_a_joint_turns_back_is_no_fault(tmp_path, capsys):
    """Half a turn of its crank turns the coupler of Hoeken's linkage back: no slip there."""
    text_ = (LIBRARY / "hoeken.yaml").read_text("utf-8")
    path = tmp_path / "m.yaml"
    path.write_text(f"{text_}\nfriction: {{pins: {{f: 0.1, diameter: 1 mm}}}}\n", encoding="utf-8")
    assert main(["check", str(path)]) == 0
    assert "equilibrium of the free bodies agrees" in capsys.readouterr().out


def test_a_stretch_ends_at_the_place_of_which_nothing_is_known():
    tongs = mechc.load("karpenko_fig4_with_friction")
    reaches = {r.parameter: r for r in tongs.results["k_hold"].locking.reaches}
    before, beyond = reaches["theta"].stretches
    assert before.high.x == beyond.low.x == 0
    assert before.high.left_out
    assert beyond.low.left_out


@pytest.mark.parametrize("wide", in_thirds([10, 45]))
def test_where_iteration_fails_for_one_number_a_jam_is_not_cut_in_two(wide):
    """8.3e-8 rad beyond the pole at 90 degrees friction is found for the numbers on either side."""
    text = (LIBRARY / "fedoriv_fig2a_with_friction.mech").read_text(encoding="utf-8")
    given = f"alpha = 85 deg in {90 - wide} deg .. {90 + wide} deg"
    found = sampled(text.replace("alpha = 10 deg in 1 deg .. 45 deg", given))
    ((state, low, high),) = within(found["k_hold"], "alpha")
    assert (state, low) == ("jammed", 90)
    assert high == pytest.approx(90 + math.degrees(math.asin(1 / 80)), abs=1e-9)


def sampled(text_: str) -> dict[str, Analysis]:
    """Return the results of a description of which nothing is refuted by sampling of code."""
    compilation = Compilation(Source("m.mech", text_))
    assert list(refuted(compilation)) == []
    return {r.name: r for r in compilation.results}


def within(result: Analysis, parameter: str) -> list[tuple[str, float, float]]:
    """Return states and ends, those within the range, in degrees."""
    assert result.locking is not None
    (reach,) = (r for r in result.locking.reaches if r.parameter == parameter)
    known = [(s.state, s.within) for s in reach.stretches if s.within]
    return [(state, math.degrees(a), math.degrees(b)) for state, (a, b) in known]


SHORT_ROD = """
param phi = -151.828 deg in -303.808 deg .. 180 deg
pivot O at (0 mm, 0 mm)
slider B along x through O
link OA
link AB
OA = 31.7 mm @ phi
AB = 21.1 mm
assembly B back
drive phi
torque M on OA
force F at B on AB along x
weight W mass 2 kg at A on OA
friction pins 0.151 diameter 11.9 mm coulomb
friction slider B 0.255
find M
"""


@pytest.mark.slow
def test_where_iteration_finds_nothing_between_places_that_are_stuck_it_is_stuck():
    """A whole turn later the same is stated: 4 degrees beyond the end of the loop."""
    found = within(sampled(SHORT_ROD)["M_f"], "phi")
    before, after = (
        [(a, b) for s, a, b in found if s == "locked" and way * a > 0] for way in (-1, 1)
    )
    assert before[0] == pytest.approx([end - 360 for end in after[-1]], abs=1e-3)


FOLDED = """
param phi = 124.883 deg in 0 deg .. 169.224 deg
param r = 75.9 mm
param e = 0 mm
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, e)
slider B along x through Q
link OA
link AB
OA = r @ phi
AB = r
assembly B back
drive phi
torque M on OA
force F at B on AB along -x
friction pins 0.132 diameter 14.3 mm
find k = M/F
"""


def test_where_equal_links_lie_on_one_another_nothing_is_stated_of_rounding():
    """Up to 90 degrees B stands still in O, and k is 0 but for rounding."""
    ((state, low, high),) = within(results(FOLDED)["k_hold"], "phi")
    assert state == "jammed"
    assert low == pytest.approx(90, abs=1e-5)
    assert high > 91


def test_ends_that_are_two_are_shown_as_two(tmp_path, capsys):
    (path := tmp_path / "m.mech").write_text(FOLDED, encoding="utf-8")
    assert main(["check", str(path)]) == 0
    assert "90 deg < phi <= 90.0001 deg" in capsys.readouterr().out


WINGED = """
param alpha = -135.3 deg in -180 deg .. 180 deg
param beta = 3.4 deg
param l = 8 in
param m = 1.3 in
pivot O
slider K along beta
link OB
link BK
OB = l @ alpha
BK = m @ 3*alpha
force P at B on OB along -y
force F at K on BK along beta
friction pins 0.116 diameter 0.59 in
friction slider K 0.272
find k = P/F
"""


@pytest.mark.slow
def test_beside_a_place_at_which_a_slip_is_infinite_and_k_is_not_friction_is_looked_at():
    """At -90 degrees P is perpendicular to the path of B, and cos(alpha) cancels in k."""
    found = within(sampled(WINGED)["k_f"], "alpha")
    before, beyond = ((a, b) for s, a, b in found if s == "locked" and -92 < a < b < -88)
    assert before == pytest.approx((-91.53, -90), abs=0.01)
    assert beyond == pytest.approx((-90, -88.867), abs=0.01)


@pytest.mark.parametrize("unknown", [(0.1, 0.9), (0.3, 0.7), (0.5, 0.75)])
def test_nothing_is_stated_of_values_at_which_nothing_is_found(monkeypatch, unknown):
    """Between two values at which the crank jams the solver finds neither a balance nor a fold."""
    text_ = SLIDER_CRANK.replace("diameter 12 mm", "diameter 90 mm")
    low, high = stretches(text_, "k_f")[0].within
    first, last = (low + part * (high - low) for part in unknown)
    found = RatioAlong._real

    def real(moving: RatioAlong, x: float) -> float | None:
        return None if first < x < last else found(moving, x)

    monkeypatch.setattr(RatioAlong, "_real", real)
    for stretch in stretches(text_, "k_f"):
        assert stretch.sampled
        begins, ends = stretch.within
        assert not max(begins, first) + 1e-9 < min(ends, last) - 1e-9, (begins, ends)


MEETING = """
param phi = -150 deg in -190 deg .. -90 deg
pivot O at (0 mm, 0 mm)
pivot Q at (-80 mm, -60 mm)
link OA
link QBD
link AB
OA = 100 mm @ phi
AB = 130 mm
QB = 130 mm
QD = 100 mm @ -QB
assembly ABQ ccw
drive phi
force F at D along 180 deg
friction pins 0.1 diameter 10 mm
actuator N between A and Q
find k = N/F
"""


def test_nothing_is_said_of_a_stretch_of_rounding_where_pins_meet():
    """A passes Q: over 1e-8 of the range the force between them has no direction."""
    results = {r.name: r for r in Compilation(Source("m.mech", MEETING)).results}
    found = [s for reach in results["k_f"].locking.reaches for s in reach.stretches]
    assert [s.state for s in found] == ["locked"]
    assert found[0].high.x - found[0].low.x > 1e-3


def test_a_brake_that_begins_to_grip_at_the_values_given_is_jammed():
    """A shoe on a lever of 45 degrees: where mu is 1 the force of friction is infinite."""
    shoe = """
        param a = 50 mm
        param mu = 1
        pivot O
        pivot C
        link OG
        link CTH
        OG = 100 mm @ 90 deg
        OT = 100 mm @ 90 deg
        CT = (a, a)
        CH = 300 mm @ 0 deg
        contact T on OG normal 90 deg
        friction contact T mu
        torque P on OG
        force N at H along -y
        let N = 100 N
        find P
    """
    compilation = Compilation(Source("shoe.mech", shoe))
    states = {r.name: r.locking.state for r in compilation.results if r.locking}
    assert states == {"P_f": "free", "P_hold": "jammed"}


def test_a_bound_has_no_minuses_that_cancel() -> None:
    """By hand tan α = (μ₁ + μ₂)/(1 − μ₁μ₂), no −arctan((−μ₁ − μ₂)/(1 − μ₁μ₂))."""
    wedge = """
    param alpha = 12 deg in 4 deg .. 30 deg
    param mu_1 = 0.15
    param mu_2 = 0.1
    slider B along y
    slide WX along x
    contact B on WX normal 90 deg - alpha
    friction contact B mu_1
    friction slider W mu_2
    friction slider B mu_2
    force P at W along x
    force Q at B along -y
    find k = P/Q
    """
    (bound,) = (stretch.high for stretch in stretches(wedge, "k_hold"))
    assert bound is not None
    assert bound.exact is not None
    assert text(bound.exact) == "atan((mu_1 + mu_2)/(1 - mu_1*mu_2))"
