"""Friction inside k: the seeds' references, limits, laws."""

import math
from functools import cache

import pytest

import mechc
from gripping_brake import gripping_brake
from mechc.compilation import Compilation
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.walk import symbols
from mechc.model.values import completed, holds
from mechc.source import Source
from paths import LIBRARY
from seed_friction import described, entries

CASES = sorted(entries("friction.json"))


@cache
def loaded(case):
    return mechc.loads(described(case), case)


@pytest.mark.parametrize("case", CASES)
def test_seeds(case):
    expected = entries("friction.json")[case]
    found = loaded(case).evaluate()
    names = ("k_ideal", "k_real", "k_first_order", "k_holding", "eta")
    for name, key in zip(("k", "k_f", "k_f1", "k_hold", "eta_k"), names, strict=True):
        assert found[name] == pytest.approx(expected[key], rel=1e-10), name


@pytest.mark.parametrize("case", CASES)
def test_vanishing_friction_gives_the_ideal_ratio(case):
    found = loaded(case).evaluate(shrunk=1e-9)
    for name in ("k_f", "k_f1", "k_hold"):
        assert found[name] == pytest.approx(found["k"], rel=1e-7)


@pytest.mark.parametrize("case", CASES)
def test_the_first_order_errs_by_second_order(case):
    """A quarter of the friction leaves a sixteenth of the error."""
    errors = []
    for shrunk in (0.2, 0.05):
        found = loaded(case).evaluate(shrunk=shrunk)
        errors.append(found["k_f"] - found["k_f1"])
    assert errors[0] / errors[1] == pytest.approx(16, rel=0.05)


@pytest.mark.parametrize("case", CASES)
def test_both_motions_straddle_the_ideal_ratio(case):
    found = loaded(case).evaluate()
    assert found["k_hold"] < found["k"] < found["k_f"]
    assert 0 < found["eta_k"] < 1


def printed(name, result):
    """Return a formula of the library's as it is printed."""
    return text(mechc.load(name).results[result].formula)


def test_an_efficiency_shows_on_what_it_does_not_depend():
    """The lever behind a screw does not matter, and a cable has e to the power of its wrap."""
    assert printed("d45_11_screw_lever_with_friction", "eta_k") == (
        "p*(1 - mu*p/(pi*d))/(p + pi*mu*d)"
    )
    assert printed("cable_over_drum", "eta_k") == "exp(-pi*mu/2)"
    assert printed("d45_10_two_screws_with_friction", "eta_k") == "p/(pi*k_f)"


def test_an_efficiency_has_no_range_over_what_it_is_printed_without():
    lever = mechc.load("d45_11_screw_lever_with_friction").results["eta_k"]
    assert not lever.efficiency_ranges
    (cable,) = mechc.load("cable_over_drum").results["eta_k"].efficiency_ranges
    assert cable.parameter == "mu"


FOLLOWER = """mechanism follower
param r = 60 mm
param psi = 25 deg in 5 deg .. 40 deg
param mu = 0.12
param nu = 0.05
pivot O
link OC
slider A along y
OC = 50 mm @ 80 deg
OA = r @ 90 deg
contact A on OC normal 90 deg + psi
torque M on OC
force F at A along -y
find k = M/F
friction slider A mu
friction contact A nu
"""


def test_a_cam_presses_its_follower_on_the_guide():
    """M = r·R·sin(ψ + φ), F = R·(cos(ψ + φ) − μ·sin(ψ + φ)), with φ = atan ν on the face."""
    found = mechc.loads(FOLLOWER).evaluate()
    turn = math.radians(25) + math.atan(0.05)
    assert found["k"] == pytest.approx(0.06 * math.tan(math.radians(25)))
    across = math.sin(turn)
    assert found["k_f"] == pytest.approx(0.06 * across / (math.cos(turn) - 0.12 * across))


LEVER = """mechanism lever
param a = 150 mm
param b = 60 mm
param r = 8 mm
param f = 0.15
pivot O
link AOB
OA = a @ 180 deg
OB = b @ {side} deg
force Q at A along -90 deg
force P at B along {way} deg
friction pins f diameter 2*r
find k = Q/P
"""


@pytest.mark.parametrize(
    ("side", "way", "b", "tightening", "releasing"),
    [
        (0, -90, 0.06, "(b + r*f)/(a - r*f)", "(b - r*f)/(a + r*f)"),
        (0, -90, 0.3, "(b + r*f)/(a - r*f)", "(b - r*f)/(a + r*f)"),
        (180, 90, 0.06, "(b + r*f)/(a + r*f)", "(b - r*f)/(a - r*f)"),
        (180, 90, 0.3, "(b - r*f)/(a - r*f)", "(b + r*f)/(a + r*f)"),
    ],
)
def test_parallel_forces_on_a_lever_need_no_root(side, way, b, tightening, releasing):
    """f·r·(Q + P) at the pivot between the forces, f·r·|Q − P| where both are on one side."""
    given = LEVER.format(side=side, way=way)
    expects = f"expect k_f = {tightening}\nexpect k_hold = {releasing}\n"
    assert not mechc.loads(given.replace("b = 60 mm", f"b = {b} m") + expects).warnings
    found = mechc.loads(given).evaluate(b=b)
    at = {"a": 0.15, "b": b, "r": 0.008, "f": 0.15}
    for name, formula in (("k_f", tightening), ("k_hold", releasing)):
        assert found[name] == pytest.approx(eval(formula, {}, at), rel=1e-12)


def test_a_lever_at_rest_has_no_friction_on_its_pivot():
    """At its dead centre the rod is turned by 2ρ/L alone: S·(a·cos δ + ρ) = F·b."""
    a, b, rho, delta = 0.08, 0.12, 0.0005, math.asin(2 * 0.0005 / 0.05)
    found = mechc.load("karpenko_fig7_with_friction").evaluate(alpha=0.0)
    size = b / (a * math.cos(delta) + rho)
    expected = size * (math.sin(delta) + 0.1 / 3 * math.cos(delta))
    assert found["k_f"] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "smooth"),
    [
        ("d45_16_wedge_hook_with_friction", "rho  = 0 deg"),
        ("fedoriv_fig2a_with_friction", "f     = 0"),
    ],
)
def test_formulas_stay_whole_where_a_coefficient_is_zero(name, smooth):
    text = (LIBRARY / f"{name}.mech").read_text("utf-8")
    parameter = f"param {smooth.split('=')[0]}"
    lines = [n for n in text.splitlines() if " at " not in n or not n.startswith("expect")]
    lines = [n for n in lines if not n.startswith("translate")]
    smoothed = [f"param {smooth}" if n.startswith(parameter) else n for n in lines]
    assert smoothed != lines
    solved = mechc.loads("\n".join(smoothed))
    assert not solved.warnings
    found = solved.evaluate()
    assert found["k_f"] == found["k_hold"] == pytest.approx(found["k"], rel=1e-14)


ALONG_A_GUIDE = """mechanism nut
param a = 30 mm
param b = 120 mm
param th = 20 deg in 5 deg .. 60 deg
param mu = 0.15
pivot O
slider K along y
link OBA
link BK
OB = a @ th
OA = b @ th
BK = 25 mm @ 90 deg
force P at A along -y
force F at K along y
friction pins mu diameter 6 mm
friction slider K 0.1 guide 20 mm overhang 30 mm
find k = P / F
"""


def test_a_rod_along_its_guide_presses_by_the_friction_of_its_pins_alone():
    """N = S·sin δ, the friction of the guide c·N: F = S·(cos δ − c·sin δ)."""
    mechanism = mechc.loads(ALONG_A_GUIDE, "nut.mech")
    a, b, th, rho, c = 30, 120, math.radians(20), 0.15 * 3, 0.1 * (1 + 2 * 35 / 20)
    delta = math.asin(2 * rho / 25)
    rod = 1 / (math.cos(delta) - c * math.sin(delta))
    arm = a * math.cos(th - delta) + rho  # of the rod's line at O, its pin's circle added

    def gap(drive: float) -> float:
        pivot = math.hypot(rod * math.sin(delta), rod * math.cos(delta) - drive)
        return drive * b * math.cos(th) - rod * arm - rho * pivot

    low, high = 0.2, 0.4
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if gap(middle) > 0 else (middle, high)
    assert mechanism.evaluate()["k_f"] == pytest.approx(low, rel=1e-12)
    arm, guide = mechanism.results["k_f"].holds
    assert (text(arm.left), arm.operator) == ("b*cos(th) - rho", ">")
    assert (text(guide.left), guide.operator) == (
        "L_K*cos(delta_BK) - 3*f_K*l_K*sin(delta_BK)",
        ">",
    )


NEAR_A_DEAD_CENTRE = """
slider K along x
pivot O at (80 mm, 60 mm)
link KB
link OBT
K at (0 mm, 0 mm)
B at (45 mm, 35 mm)
T at (150 mm, 20 mm)
force P at K along x
force F at T along y
friction pins 0.12 diameter {d} mm
find k = P/F
"""


@pytest.mark.parametrize("d", [1, 4, 8, 11, 12, 14])
def test_where_its_conditions_hold_a_root_balances(d):
    """The rod passes the circle about O where its arm is shorter than the radius: a jam."""
    mechanism = mechc.loads(NEAR_A_DEAD_CENTRE.format(d=d))
    result = mechanism.results["k_f"]
    known = completed({}, result.where)
    assert all(symbols(c.left) <= known.keys() for c in result.holds)
    assert math.isfinite(mechanism.evaluate()["k_f"]) == (d < 11)
    assert all(holds(c, known) for c in result.holds) == (d < 11)


IDLE = """
param l = 100 mm
param alpha = 10 deg in 1 deg .. 45 deg
pivot O
slider C along y
link OB
link BC
link BD
BD = 20 mm @ 0 deg
OB = l @ 90 deg - alpha
BC = l @ 90 deg + alpha
force P at B along -x
force F at C along -y
friction pins 0.1 diameter 10 mm
friction pin B 0 diameter 10 mm
find k = P / F
"""


def test_a_link_that_turns_idly_on_a_pin_without_friction_changes_nothing():
    """Each rod slips at one end, so that its line turns by asin(ρ/l)."""
    mechanism = mechc.loads(IDLE)
    turn = math.asin(0.005)
    for alpha in map(math.radians, (1, 10, 45)):
        found = mechanism.evaluate(alpha=alpha)
        assert found["k_f"] == pytest.approx(2 * math.tan(alpha + turn), rel=1e-12)
        assert found["k_hold"] == pytest.approx(2 * math.tan(alpha - turn), rel=1e-12)


# ------------------------------------------------------------------------------- halves

GRIPPER = """
param a = 40 mm
param b = 100 mm
param L = 60 mm
param alpha = 35 deg
pivot O
slider A along x
link AB
link BOD
AB = L @ alpha
BO = a @ 0 deg
OD = b @ 0 deg
force P at A along x
force F at D along y
friction pins 0.1 diameter 10 mm
find k = P / F
"""

OTHER_HALF = """
pivot U
link AV
link VUW
AV = L @ -alpha
VU = a @ 0 deg
UW = b @ 0 deg
force F2 = F at W along -y
"""

GUIDES = [
    "friction slider A 0.1",
    pytest.param("friction slider A 0.1 guide 40 mm overhang 60 mm", marks=pytest.mark.slow),
    pytest.param("friction roller A 0.1 axle 10 mm wheel 30 mm", marks=pytest.mark.slow),
]


@pytest.mark.parametrize(
    "guide", ["", pytest.param(GUIDES[0], marks=pytest.mark.slow), *GUIDES[1:]]
)
def test_side_forces_of_mirrored_halves_cancel(guide):
    """Figure 1 of Karpenko et al., as one half and as a whole: 7.770, not 8.295."""
    mirrored = mechc.loads(f"{GRIPPER}mirror across 0 deg sharing A\n{guide}")
    whole = mechc.loads(f"{GRIPPER}{OTHER_HALF}{guide}")
    expected = entries("friction.json")["F-G000-1"]
    for mechanism in (mirrored, whole):
        found = mechanism.evaluate()
        assert found["k_f"] == pytest.approx(expected["k_real"], rel=1e-12)
        assert found["k_hold"] == pytest.approx(expected["k_holding"], rel=1e-12)
    assert [w.code for w in mirrored.warnings] == (["W272"] if guide else [])
    assert not whole.warnings


@pytest.mark.parametrize("guide", GUIDES)
@pytest.mark.parametrize(
    ("load", "counted"), [("P at A along x", "times 1/2"), ("F at D along y", "times 2")]
)
def test_a_half_with_a_guide_that_both_halves_share_is_refused(guide, load, counted):
    half = GRIPPER.replace(load, f"{load} {counted}")
    assert mechc.loads(half).evaluate()["k_f"] == pytest.approx(
        entries("friction.json")["F-G000-1"]["k_real"], rel=1e-12
    )
    with pytest.raises(mechc.MechcError) as caught:
        mechc.loads(f"{half}\n{guide}").evaluate()
    assert [d.code for d in caught.value.diagnostics] == ["E278"]


PLUNGERS = """
param alpha = 10 deg in 1 deg .. 45 deg
slider B along -y
slider C along x
link BC
BC = 80 mm @ -alpha
force Q at B along -y
force W at C along -x {counted}
friction pins 0.1 diameter 10 mm
friction slider C 0.1 guide 40 mm overhang 30 mm
{mirror}
find k = Q / W
"""


def test_a_half_with_a_guide_of_its_own_is_no_wrong_half():
    """Each plunger slides in its guide, whether both are described or one that counts twice."""
    half = mechc.loads(PLUNGERS.format(counted="times 2", mirror=""))
    whole = mechc.loads(PLUNGERS.format(counted="", mirror="mirror across 90 deg sharing B"))
    assert not half.warnings
    alpha, turn, c = math.radians(10), math.asin(0.1 / 8), 0.1 * 3 * 30 / 40
    by_hand = 2 / (1 / math.tan(alpha + turn) - c)
    for mechanism in (half, whole):
        assert mechanism.evaluate()["k_f"] == pytest.approx(by_hand, rel=1e-12)


def test_branches_of_a_claw_press_their_common_guide_to_no_side():
    description = f"{GRIPPER}copies 3 sharing A\n"
    smooth, rough = (mechc.loads(f"{description}{guide}") for guide in ("", GUIDES[0]))
    assert rough.evaluate()["k_f"] == smooth.evaluate()["k_f"]
    assert [w.code for w in rough.warnings] == ["W272"]


def test_loads_alone_press_a_slider_on_its_guide():
    """A block on rough ground, with one force slanting down on it."""
    block = """
    param mu = 0.2
    slider B along x
    force P at B along x
    force Q at B along -y
    force R at B along 200 deg
    friction slider B mu
    find P
    """
    found = mechc.loads(block).evaluate(Q=30.0, R=50.0)
    across = 30.0 + 50.0 * math.sin(math.radians(20.0))
    drawn = 50.0 * math.cos(math.radians(20.0))
    assert found["P_f"] == pytest.approx(drawn + 0.2 * across)
    assert found["P_hold"] == pytest.approx(drawn - 0.2 * across)


@pytest.mark.parametrize("line", ["motion tightening", "motion releasing"])
def test_a_drive_that_passes_nothing_on_has_no_efficiency(line):
    """A balanced shaft: its torque overcomes the friction of the pivot and nothing else."""
    shaft = f"""
    pivot O
    link OA
    OA = 40 mm @ 90 deg
    torque M on OA
    weight W mass 2 kg at A
    friction pins 0.1 diameter 10 mm
    {line}
    find M
    """
    solved = mechc.loads(shaft)
    found = solved.evaluate()
    assert found["M"] == 0.0
    assert "eta_M" not in found
    assert abs(found["M_f"]) == pytest.approx(0.1 * 0.005 * 2 * 9.80665)
    assert solved.emit("latex")


def test_without_a_coefficient_nothing_is_said_of_jamming():
    """The root of −1/2 is no number: W256, not that friction cannot be overcome (W513)."""
    text = """
param al = 20 deg
param a = 2
let mu = sqrt(1/a - 1)
pivot O
slider K along 90 deg
link OB
link BK
OB = 200 mm @ 90 deg + al
BK = 200 mm @ 90 deg - al
force P at B along x
force F at K along -y
friction pins mu diameter 20 mm
find k = P/F
"""
    assert {d.code for d in mechc.loads(text).warnings} == {"W256", "W601"}


def test_what_loops_say_of_distances_and_directions_is_no_condition():
    """The slot's pin is at (0, -h), e from the pivot: how far and to which quarter follows."""
    text = """
mechanism gripper
param e = 24 mm
param h = 30 mm
param f = 0.12
pivot O at (e, 0 mm)
slider K along y
K at (0 mm, -h)
J at (e, 85 mm)
link OSJ
slot K in OS
friction pin O f diameter 8 mm
friction contact K 0.15
force P at K along -y
force F at J along x
find k = P/F
"""
    assert not mechc.loads(text).results["k_f"].holds


STAY = """
param s = 47 mm in 37 mm .. 57 mm
pivot O at (0 mm, 0 mm)
pivot P at (4 mm, 63 mm)
telescope PA
link OAE
slot S in OA
link ES
PA = s
OA = 70 mm
OE = 70 mm
angle AOE = 51 deg
ES = 55 mm
assembly OPA ccw
assembly S back
actuator M between P and A
force F at S along 24 deg
drive s
friction pins 0.154 diameter 6 mm coulomb
friction pin E 0.15 diameter 8 mm on ES
friction contact S 0.055
find k = M/F
"""
"""The stay ES stands in a slot of the link that it is pinned to: nothing slides there."""


@pytest.mark.parametrize("name", ["k_f", "k_hold"])
def test_a_joint_in_which_nothing_slides_adds_nothing(name):
    """Its slip had the name of the turn that is zero as well, which has another dimension."""
    result = mechc.loads(STAY).results[name]
    names = {d.name for d in result.where} | symbols(result.formula)
    assert not any("_E" in n or n.endswith("_S") for n in names if n.startswith(("Omega", "v_")))
    assert "n_S_face" not in symbols(result.formula)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("karpenko_fig1_with_friction", ["b - rho > 0"]),
        (
            "karpenko_fig2_with_friction",
            ["b*cos(alpha) - rho_O > 0", "a*sin(2*alpha + delta_AB) + rho_A - rho_O > 0"],
        ),
    ],
)
def test_a_load_that_holds_a_lever_acts_outside_its_friction_circle(name, expected):
    """Else friction at the pivot alone holds the lever, and no rod need press it."""
    holds = mechc.load(name).results["k_hold"].holds
    assert [f"{text(c.left)} {c.operator} {text(c.right)}" for c in holds] == expected


SELF_LOCKING = """
param t1 = 237.83 deg in 197.83 deg .. 277.83 deg
param t2 = 59.82 deg in -0.18 deg .. 119.82 deg
param t3 = 355.25 deg in 265.25 deg .. 445.25 deg
pivot O
slider A along 42.30 deg
link AB
link OBC
AB = 74.7 mm @ t1
OB = 51.9 mm @ t2
OC = 113.5 mm @ t3
force P at A along 42.30 deg
force F at C along 209.13 deg
friction pins 0.191 diameter 14.4 mm
friction slider A 0.075
find k = P/F
"""


def test_signs_with_which_nothing_balances_are_no_case():
    """It held "while S_AB_hold < 0", where a rod that is pressed would pull."""
    result = mechc.loads(SELF_LOCKING).results["k_hold"]
    shown = [f"{text(c.left)} {c.operator} 0" for c in result.holds]
    assert "S_AB_hold*s_AB < 0" in shown
    assert not any(c.startswith("S_AB_hold <") for c in shown)


GRIPPING = gripping_brake("0.5 in 0.1 .. 0.6", "find M\nlet P = 300 N")


def test_a_formula_that_jams_by_default_states_where_it_holds():
    (condition,) = mechc.loads(GRIPPING).results["M_f"].holds
    assert condition.operator == ">"
    values = {"P": 300.0, "len_CA": 0.06, "len_CB": 0.02, "s_O_rope": 1.0}
    signs = [evaluate(condition.left, {**values, "mu": mu}) > 0 for mu in (0.1, 0.34, 0.36, 0.6)]
    assert signs == [True, True, False, False]


PARALLELOGRAM = """
param ga = 10 deg
param al = 190 deg
param mu = 0.1
param phi = 50 deg in 20 deg .. 160 deg
param a = 200 mm
param d = 20 mm
param f = 0.1
param be = 35 deg
param h = 130 mm
param l = 400 mm
pivot O at (0 mm, 0 mm)
pivot Q at (300 mm, 0 mm)
link OA
link QBD
link AB
link DE
slider E along ga through O
OA = a @ phi
QB = a
QD = h
angle BQD = be
AB = 300 mm
DE = l
assembly ABQ cw
assembly E forward
torque M on OA
force P at E along al
friction pins f diameter d
friction slider E mu
find k = M/P
"""


def test_forces_that_are_alike_are_counted_where_they_keep_their_names():
    """The rod AB and the crank OA pass on one force, and their pins turn as much as the drive."""
    result = mechc.loads(PARALLELOGRAM).results["k_f1"]
    assert text(result.formula).startswith("k + rho*(3*r_O + r_Q) + rho*r_D*Omega_D")
    assert not {"Omega_O", "r_A"} & {d.name for d in result.where}


CRANKS = """
param phi = 50 deg in 20 deg .. 160 deg
param a = 200 mm
param h = 130 mm
param be = 15 deg
pivot O at (0 mm, 0 mm)
pivot Q at (300 mm, 0 mm)
link OA
link QBD
link AB
OA = a @ phi
QB = a
QD = h
angle BQD = be
AB = 300 mm
assembly ABQ cw
torque M on OA
force P at D along x
friction pins 0.1 diameter 20 mm
find k = M/P
"""


def test_a_condition_that_another_one_implies_is_left_out():
    """Where h sin(be + phi) exceeds rho, the sine is positive."""
    holds = mechc.loads(CRANKS).results["k_hold"].holds
    shown = [f"{text(c.left)} {c.operator} {text(c.right)}" for c in holds]
    assert "h*sin(be + phi) - rho > 0" in shown
    assert "sin(be + phi) > 0" not in shown


@pytest.mark.parametrize("along", ["0 deg", "s"])
def test_no_sign_that_is_zero_at_a_dead_centre_alone_is_put_in_a_printed_formula(along):
    """At 0 no force turns the bar: beside it the pivot turns, and rubs; bar and forces may turn."""
    bar = f"""
param t = 0 deg
param s = 0 deg
pivot O
link OAB
OA = 100 mm @ t
OB = 300 mm @ t
force P at B along {along}
force F at A along {along}
friction pins 0.1 diameter 10 mm
find k = P/F
"""
    found = {r.name: r for r in Compilation(Source("level.mech", bar)).results}
    for name in ("k_f", "k_f1", "k_hold"):
        assert "f*d" in text(found[name].formula)
        assert all(h.operator != "=" for h in found[name].holds)


SUMS_IN_FORCES = """
param a = 60 mm
param b = 60 mm
param alpha = 60 deg
pivot A
link AB
AB = b @ -alpha
pivot C
link CD
CD = a @ 30 deg
contact B on CD normal 90 deg
CB = a + b @ alpha
pivot E
link EG
link DH
slot D in EG guiding DH
EG = 300 mm @ 45 deg
ED = 2*a @ 45 deg
DH = 100 mm @ EG
force P at B along perp AB
force F at H along alpha
find k = P/F
friction pins 0.12 diameter 6 mm
friction contact B 0.08
"""


def test_what_is_printed_of_iterated_forces_has_all_that_they_rest_on():
    """Long sums of the forces without friction, s1 and s2, were in what code has alone."""
    compilation = Compilation(Source("slot.mech", SUMS_IN_FORCES))
    given = {p.name for p in compilation.mechanism.parameters} | {"P", "F"}
    for result in compilation.results:
        known = given | {other.name for other in compilation.results}
        for definition in result.where:
            assert symbols(definition.formula) <= known, (result.name, definition.name)
            known.add(definition.name)
        assert symbols(result.formula) <= known
