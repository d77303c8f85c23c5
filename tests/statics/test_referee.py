import math
from fractions import Fraction
from random import Random

import pytest

from by_hand import HERE, angle_of, build, force, geometries, in_numbers, result, torque
from mechc.base.frozen import replace
from mechc.cli.exit_status import status
from mechc.compilation import Compilation
from mechc.diagnostics import Diagnostic, Report
from mechc.diagnostics.statics import (
    BUGS,
    methods_disagree,
    no_equilibrium,
    pose_does_not_close,
)
from mechc.formula import tree as formula
from mechc.model import mechanism as model
from mechc.model.mechanism import LoadForm, LoadRatio, Speed, SpeedRatio
from mechc.model.result import Result
from mechc.report.text.verdict import to_text
from mechc.source import Source
from mechc.statics.answers import load_ratio
from mechc.statics.assembly import Plane, direction
from mechc.statics.balanced import Balanced
from mechc.statics.equations import equilibrium
from mechc.statics.poses import candidates, feasible_pose
from mechc.statics.referee import RefereeDisagrees, cross_check
from mechc.statics.sparse_elimination import factor
from mechc.statics.speeds import speed_ratio
from mechc.statics.unfold import Unfolding
from mechc.units import ANGLE, LENGTH, NUMBER


def report():
    return Report(Source("by_hand.mech", "x"))


def ratio(pose, above="P", below="F"):
    answer = load_ratio(Balanced(pose, {}), above, below)
    assert not answer.trouble, answer.trouble
    return answer.value


def lever(**more):
    points = {"O": (0, 0), "A": (2, 0), "B": (-3, 0)}
    loads = [force("P", "A"), force("F", "B")]
    return build(points, ["AOB"], "O", {}, loads, {"P": -90, "F": -90}, **more)


# -------------------------------------------------------------------- hand cases


def test_a_lever_balances_by_its_arms():
    assert ratio(lever()) == pytest.approx(1.5, rel=1e-14)


def test_a_torque_balances_a_force_by_its_arm():
    points = {"O": (0, 0), "A": (0.3, 0.4)}
    pose = build(points, ["OA"], "O", {}, [torque("M", "OA"), force("F", "A")], {"F": 0})
    assert ratio(pose, "M", "F") == pytest.approx(0.4, rel=1e-14)


@pytest.mark.parametrize("phi", [0.3, 1.1, 2.0])
def test_a_slider_crank(phi):
    r, rod = 0.1, 0.35
    beta = math.asin(r * math.sin(phi) / rod)
    points = {"O": (0, 0), "A": (r * math.cos(phi), r * math.sin(phi))}
    points["B"] = (points["A"][0] + rod * math.cos(beta), 0)
    loads = [torque("M", "OA"), force("F", "B")]
    pose = build(points, ["OA", "AB"], "O", {"B": 0}, loads, {"F": 180})
    expected = -r * math.sin(phi + beta) / math.cos(beta)
    assert ratio(pose, "M", "F") == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("phi", [0.4, 1.2, 2.5])
def test_the_speed_of_a_slider_crank(phi):
    r, rod = 0.1, 0.35
    beta = math.asin(r * math.sin(phi) / rod)
    points = {"O": (0, 0), "A": (r * math.cos(phi), r * math.sin(phi))}
    points["B"] = (points["A"][0] + rod * math.cos(beta), 0)
    pose = Unfolding(build(points, ["OA", "AB"], "O", {"B": 0}, [], {}), {})
    crank, piston = Speed("link", "OA"), Speed("point", "B")
    expected = -r * math.sin(phi + beta) / math.cos(beta)
    assert speed_ratio(pose, SpeedRatio(piston, crank)).value == pytest.approx(expected, rel=1e-13)
    assert speed_ratio(pose, SpeedRatio(crank, piston)).value == pytest.approx(1 / expected)
    pin = speed_ratio(pose, SpeedRatio(Speed("point", "A"), crank))
    assert pin.value == pytest.approx(r, rel=1e-13)


def test_a_floating_point_has_a_magnitude_of_speed_only():
    points = {"A": (0, 3), "B": (4, 0), "C": (2, 1.5)}
    pose = Unfolding(build(points, ["ACB"], "", {"A": 90, "B": 0}, [], {}), {})
    middle, end = Speed("point", "C"), Speed("point", "B")
    # The midpoint of a ladder of length 5 runs on a circle of radius 5/2 about the corner.
    assert speed_ratio(pose, SpeedRatio(middle, end)).value == pytest.approx(2.5 / 3)
    assert speed_ratio(pose, SpeedRatio(end, middle)).value == pytest.approx(3 / 2.5)


def test_times_multiplies_a_load():
    points = {"O": (0, 0), "A": (2, 0), "B": (-3, 0)}
    loads = [force("P", "A", times=2), force("F", "B", times=Fraction(1, 2))]
    pose = build(points, ["AOB"], "O", {}, loads, {"P": -90, "F": -90})
    assert ratio(pose) == pytest.approx(1.5 / 4)


@pytest.mark.parametrize("times", [Fraction(1, 10**30), 10**30])
def test_a_load_may_be_multiplied_by_anything(times):
    points = {"O": (0, 0), "A": (2, 0), "B": (-3, 0)}
    loads = [force("P", "A", times=times), force("F", "B")]
    pose = build(points, ["AOB"], "O", {}, loads, {"P": -90, "F": -90})
    assert ratio(pose) * times == pytest.approx(1.5)
    assert ratio(pose, "F", "P") / times == pytest.approx(1 / 1.5)


def test_a_tied_load_follows_the_load_it_is_tied_to():
    points = {"O": (0, 0), "A": (2, 0), "B": (-3, 1)}
    tie = formula.product([(formula.number(Fraction(1, 5)), 1), (formula.Symbol("F"), 1)])
    loads = [force("P", "A"), force("F", "B"), force("T", "B", tie=tie)]
    pose = build(points, ["AOB"], "O", {}, loads, {"P": -90, "F": -90, "T": 180})
    assert ratio(pose) == pytest.approx((3 + 0.2) / 2)
    assert ratio(pose, "P", "T") == pytest.approx((3 + 0.2) / 2 * 5)
    assert ratio(pose, "T", "F") == pytest.approx(0.2)


def toggle(**more):
    """The right half of a toggle press: lever OBA, rod BK, ram K on the line x = 0."""
    a, b, alpha, beta = 0.1, 0.25, math.radians(12), math.radians(7)
    arm = alpha - math.pi / 2
    points = {"O": (0, 0), "B": (a * math.cos(arm), a * math.sin(arm))}
    points["A"] = (b * math.cos(arm), b * math.sin(arm))
    rod = -math.pi / 2 - beta
    length = points["B"][0] / -math.cos(rod)
    points["K"] = (0, points["B"][1] + length * math.sin(rod))
    loads = [force("P", "A"), force("F", "K")]
    k = a * math.sin(alpha + beta) / (2 * b * math.cos(alpha) * math.cos(beta))
    guides = more.pop("guides", {"K": 90})
    more = {"mirror": "K", "axis": 90, **more}
    return build(points, ["OBA", "BK"], "O", guides, loads, {"P": 180, "F": 90}, **more), k


LEVER_WITH_A_LOAD_BY_ANOTHER = """
pivot O at (0 mm, 0 mm)
link OAB
A at (300 mm, 40 mm)
B at (300 mm, 200 mm)
force P at B along -x
force F at A along -y
force G at A along -x
let G = 0.5*F
find P
find R_O
"""


def test_reactions_are_asked_for_under_each_load_alone_also_where_one_has_the_size_of_another():
    verdict = Compilation(Source("m.mech", LEVER_WITH_A_LOAD_BY_ANOTHER)).verdict
    asked = {trial.result for trial in verdict.trials}
    assert verdict.agrees
    assert {"P/F", "P/G", "R_O_x/F", "R_O_x/G", "R_O_y/F"} <= asked


def test_both_halves_of_a_mirror_share_a_load():
    pose, k = toggle()
    assert ratio(pose) == pytest.approx(k, rel=1e-13)


def test_side_forces_of_mirrored_halves_cancel_without_a_guide():
    pose, k = toggle(guides={})
    assert ratio(pose) == pytest.approx(k, rel=1e-13)


def test_three_copies_share_a_load_in_three_parts():
    single, k = toggle(mirror=None, axis=None)
    assert ratio(single) == pytest.approx(2 * k)
    copied, _ = toggle(mirror=None, axis=None, copies=(3, "K"))
    assert ratio(copied) == pytest.approx(2 * k / 3)


SHARED_FEED = """
param r = 10 mm in 5 mm .. 30 mm
pivot C
link CE
CE = 50 mm @ 0 deg
slider G along y
{feed}
torque P on CE
force F at G along -y
copies 3 sharing G
find k = P/F
"""


@pytest.mark.parametrize(
    ("feed", "k_f"),
    [
        ("rack G on C r\nfriction rack G 0.05", 10e-3 / 3 / 0.95),
        (
            "screw G pitch r on CE\nfriction screw G 0.1 thread 12 mm",
            12e-3 / 2 / 3 * math.tan(math.atan(10 / (math.pi * 12)) + math.atan(0.1)),
        ),
    ],
)
def test_each_of_the_copies_gives_all_of_its_own_friction_in_teeth_and_threads(feed, k_f):
    """A third of the load, and friction of that: the referee took a third of the friction."""
    compilation = Compilation(Source("feed.mech", SHARED_FEED.format(feed=feed)))
    assert compilation.verdict.agrees
    found = {r.name: r.default for r in compilation.results}
    assert found["k_f"] == pytest.approx(k_f)


def test_a_redundant_parallel_branch_is_accepted():
    points = {"O": (0, 0), "A": (0, 1), "C": (1, 0), "B": (1, 1), "E": (2, 0), "D": (2, 1)}
    loads = [torque("M", "OA"), force("F", "D")]
    pose = build(points, ["OA", "CB", "ED", "ABD"], "OCE", {}, loads, {"F": 180})
    assert ratio(pose, "M", "F") == pytest.approx(-1)


def double_pendulum():
    points = {"O": (0, 0), "A": (1, 0), "B": (2, 0.5)}
    loads = [force("P", "A"), force("F", "B")]
    return build(points, ["OA", "AB"], "O", {}, loads, {"P": 90, "F": 90})


def test_equilibrium_that_cannot_be_is_said_to_be_so():
    pose = double_pendulum()
    answer = load_ratio(Balanced(pose, {}), "P", "F")
    assert math.isnan(answer.value)
    assert "balance" in answer.trouble


def seed_ratio(geometry, axis=None):
    """Return k of a seed's geometry, whole or with its loads on both halves of a mirror."""
    points, value, k = in_numbers(geometry)
    across = None if axis is None else direction(math.radians(axis)).turned()
    shared = [p for p, at in points.items() if across and abs(across.dot(Plane(*at))) < 1e-12]
    more = {"mirror": shared, "axis": axis} if across else {}

    def times(load):
        half = across is not None and load["point"] not in shared
        return Fraction(load["mult"]) / (2 if half else 1)

    drive, outputs = geometry["drive"], geometry["loads"]
    loads = [force("P", drive["point"], times(drive))]
    loads += [
        force(f"F{i}", load["point"], times(load), formula.Symbol("F0") if i else None)
        for i, load in enumerate(outputs)
    ]
    lines = {"P": angle_of(drive["dir"], value)[0]}
    lines.update({f"F{i}": angle_of(x["dir"], value)[0] for i, x in enumerate(outputs)})
    guides = {p: angle_of(d, value)[0] for p, d in geometry["sliders"]}
    pose = build(points, geometry["bodies"], geometry["ground"], guides, loads, lines, **more)
    return ratio(pose, "P", "F0") * angle_of(outputs[0]["dir"], value)[1], k


@pytest.mark.parametrize("geometry", geometries(), ids=lambda g: g["id"])
def test_the_geometries_of_the_seeds(geometry):
    found, expected = seed_ratio(geometry)
    assert found == pytest.approx(expected, rel=1e-12)


MIRRORED = [g for g in geometries() if g.get("mirror")]


@pytest.mark.parametrize("geometry", MIRRORED, ids=lambda g: g["id"])
def test_the_symmetric_geometries_of_the_seeds_with_both_halves(geometry):
    found, expected = seed_ratio(geometry, 0 if geometry["mirror"].startswith("y") else 90)
    assert found == pytest.approx(expected, rel=1e-12)


# ------------------------------------------------------------------- the referee


def test_the_referee_agrees_with_a_right_formula():
    pose, k = toggle()
    verdict = cross_check(pose, (result("k", LoadRatio("P", "F"), k),), report())
    assert verdict.agrees
    assert len(verdict.trials) == 1
    assert verdict.worst < 1e-13
    assert "agree: worst relative error" in to_text(verdict)


@pytest.mark.parametrize("wrong", [1 + 1e-9, -1, 2, 0])
def test_the_referee_stops_a_wrong_formula(wrong):
    pose, k = toggle()
    with pytest.raises(RefereeDisagrees) as caught:
        cross_check(pose, (result("k", LoadRatio("P", "F"), k * wrong),), report())
    assert [d.code for d in caught.value.diagnostics] == ["E601"]
    assert "disagrees" in to_text(caught.value.verdict)


def test_the_referee_checks_every_coefficient_of_a_linear_form():
    points = {"O": (0, 0), "A": (2, 0), "B": (-3, 0), "C": (1, 1)}
    loads = [force("P", "A"), force("F", "B"), force("Q", "C")]
    pose = build(points, ["AOBC"], "O", {}, loads, {"P": -90, "F": -90, "Q": 0})
    right = {"F": formula.number(Fraction(3, 2)), "Q": formula.number(Fraction(-1, 2))}
    whole = Result("P", LoadForm("P"), NUMBER, formula.ZERO, coefficients=right)
    verdict = cross_check(pose, (whole,), report())
    assert {t.result for t in verdict.trials} == {"P/F", "P/Q"}
    wrong = Result(
        "P", LoadForm("P"), NUMBER, formula.ZERO, coefficients={**right, "Q": formula.ONE}
    )
    with pytest.raises(RefereeDisagrees, match="P/Q"):
        cross_check(pose, (wrong,), report())


def test_the_referee_balances_as_many_loads_as_there_are_degrees_of_freedom():
    # An equalising beam: P pulls at its middle, F and Q at its ends.
    points = {"A": (-1, 0), "M": (0, 0), "B": (2, 0)}
    loads = [force("P", "M"), force("F", "A"), force("Q", "B")]
    pose = build(points, ["AMB"], "", {"M": 90}, loads, {"P": 90, "F": -90, "Q": -90})
    assert ratio(pose) == pytest.approx(1.5)


def test_rounded_zeros_are_no_equation():
    # Nothing guides E, but Q pulls along the rod: cos 90° of it must not demand Q = 0.
    points = {"A": (0, 0), "B": (-2, 0), "C": (3, 0), "D": (-2, -5), "E": (3, -5)}
    loads = [force("P", "A"), force("F", "D"), force("Q", "E")]
    lines = {"P": -90, "F": 90, "Q": 90}
    pose = build(points, ["BAC", "BD", "CE"], "", {"A": -90, "D": -90}, loads, lines)
    assert ratio(pose) == pytest.approx(5 / 3)


def test_a_load_that_does_no_work_is_left_alone():
    points = {"O": (0, 0), "A": (2, 0), "B": (-3, 0)}
    loads = [force("P", "A"), force("F", "B"), force("Q", "B")]
    pose = build(points, ["AOB"], "O", {}, loads, {"P": -90, "F": -90, "Q": 0})
    assert ratio(pose) == pytest.approx(1.5)


def test_a_result_that_equilibrium_does_not_know_is_a_bug():
    pose = double_pendulum()
    with pytest.raises(RefereeDisagrees) as caught:
        cross_check(pose, (result("k", LoadRatio("P", "F"), 1),), report())
    assert [d.code for d in caught.value.diagnostics] == ["E602"]


def test_a_result_without_a_finite_value_earns_a_warning():
    nowhere = Result("k", LoadRatio("P", "F"), NUMBER, formula.Call("log", (formula.ZERO,)))
    asked = report()
    verdict = cross_check(lever(), (nowhere,), asked)
    assert not verdict.trials
    assert [d.code for d in asked.diagnostics] == ["W601"]
    assert "Nothing was tried." in to_text(verdict)


def test_a_pose_that_breaks_a_condition_is_not_drawn():
    alpha = formula.Symbol("alpha")
    parameter = model.Parameter("alpha", ANGLE, HERE, formula.degrees(20))
    spread = model.Interval(formula.degrees(1), formula.degrees(89))
    parameter = model.Parameter("alpha", ANGLE, HERE, formula.degrees(20), spread)
    limit = model.Require(alpha, "<", formula.degrees(30), HERE)
    pose = lever(parameters=(parameter,), requires=(limit,))
    pose = replace(pose, free=("alpha",))
    drawn = [values["alpha"] for values in candidates(pose, 40)]
    assert drawn[0] == pytest.approx(math.radians(20))
    assert 3 <= len(drawn) < 40
    assert max(drawn) < math.radians(30)
    assert drawn == [values["alpha"] for values in candidates(pose, 40)]


def test_where_nothing_is_free_there_is_one_pose():
    pose = replace(lever(), free=())
    assert len(list(candidates(pose, 40))) == 1


def test_parameters_without_a_value_are_drawn_and_dependent_ones_follow():
    a = model.Parameter("a", LENGTH, HERE)
    twice = formula.product([(formula.number(2), 1), (formula.Symbol("a"), 1)])
    b = model.Parameter("b", LENGTH, HERE, twice, dependent=True)
    pose = lever(parameters=(a, b))
    pose = replace(pose, free=("a",))
    for values in candidates(pose, 5):
        assert 0.5 <= values["a"] <= 2
        assert values["b"] == 2 * values["a"]
    assert feasible_pose(pose, {"a": math.nan}, Random(1)) is None


# ------------------------------------------------------------------ the equations


def test_cutting_free_gives_two_equations_a_pin_and_three_a_body():
    pose, _ = toggle(mirror=None, axis=None)
    system = equilibrium(Unfolding(pose, {}).assembly())
    assert len(system.rows) == 4 * 2 + 3
    assert len(system.unknowns) == 1 + 3 * 2 + 2 + 1


def test_elimination_solves_what_dense_elimination_solves():
    numpy = pytest.importorskip("numpy")
    dice = Random(7)
    for size in (1, 3, 10, 40):
        dense = numpy.zeros((size, size))
        for i in range(size):
            for j in {i, *(dice.randrange(size) for _ in range(3))}:
                dense[i, j] = dice.uniform(-1, 1) * 10 ** dice.uniform(-3, 3)
        right = {i: dice.uniform(-1, 1) for i in range(size)}
        rows = [{j: v for j, v in enumerate(row) if v} for row in dense.tolist()]
        found = factor(rows, size).solve(right)
        expected = numpy.linalg.solve(dense, [right[i] for i in range(size)])
        condition = numpy.linalg.cond(dense)
        assert numpy.allclose(found, expected, rtol=1e-15 * condition, atol=0)


def test_the_adjoint_gives_the_influence_of_each_row():
    dice = Random(3)
    rows = [{j: dice.uniform(-1, 1) for j in range(6)} for _ in range(6)]
    factors = factor(rows, 6)
    before = factors.solve({0: 1.0, 3: 2.0})[4]
    shares = factors.adjoint(4)
    for i in range(6):
        right = {0: 1.0, 3: 2.0}
        right[i] = right.get(i, 0.0) + 1.0
        after = factors.solve(right)[4]
        assert after - before == pytest.approx(shares[i] * factors.scales[i])


def test_an_unknown_that_nothing_fixes_is_not_determined():
    factors = factor([{0: 1.0, 1: 1.0}, {2: 1.0}, {0: 2.0, 1: 2.0}], 3)
    assert not factors.determined(0)
    assert not factors.determined(1)
    assert factors.determined(2)
    assert factors.gap(factors.solve({0: 1.0, 2: 2.0}), {0: 1.0, 2: 2.0}) < 1e-15
    assert factors.gap(factors.solve({0: 1.0, 2: 3.0}), {0: 1.0, 2: 3.0}) > 0.1


@pytest.mark.parametrize("stages", [16, 64])
def test_the_cost_of_a_chain_is_linear(stages):
    """Count additions, not seconds: a scissor of n stages takes a fixed number per stage."""
    pose = scissor(stages)
    system = equilibrium(Unfolding(pose, {}).assembly())
    entries = sum(map(len, system.rows))
    assert len(factor(system.rows, len(system.unknowns)).steps) < 2 * entries


def scissor(stages):
    points, bodies = {}, []
    for i in range(stages + 1):
        points[f"A{i}"], points[f"B{i}"] = (2.0 * i, 0.0), (2.0 * i, 1.5)
    for i in range(stages):
        points[f"C{i}"] = (2.0 * i + 1, 0.75)
        bodies.append([f"A{i}", f"C{i}", f"B{i + 1}"])
        bodies.append([f"B{i}", f"C{i}", f"A{i + 1}"])
    loads = [force("P", "B0"), force("F", f"A{stages}")]
    guides = {"B0": 90, f"A{stages}": 0}
    return build(points, bodies, ["A0"], guides, loads, {"P": -90, "F": 180})


def test_a_long_scissor_still_has_its_ratio():
    # x = n·w, w² + h² = const: dx/dh = −n·h/w.
    assert ratio(scissor(64)) == pytest.approx(64 * 1.5 / 2, rel=1e-9)


FAULTS = ((methods_disagree, (1.0, 2.0)), (no_equilibrium, ("why",)), (pose_does_not_close, (1.0,)))


def test_a_disagreement_is_a_fault_of_the_compiler_and_not_of_the_description():
    assert {status([Diagnostic(code, "x", None, "x")]) for code in BUGS} == {70}
    assert all("please report it" in words(HERE, "k", *rest).hint for words, rest in FAULTS)


def test_a_ratio_of_two_loads_that_a_spring_balances_is_judged_with_the_spring():
    """Two levers with a spring between them: at any force in it M and T stand in one ratio."""
    text = """
param a = 100 mm
param alpha = 30 deg
param beta = 50 deg
pivot O
pivot Q
link OA
link QB
OA = a @ alpha
QB = a @ beta
OQ = (150 mm, 0 mm)
torque M on OA
torque T on QB
spring 200 N/m between A and B free 20 mm
find k = M/T
"""
    trials = Compilation(Source("levers.mech", text)).verdict.trials
    assert len(trials) == 4
    assert all(trial.agrees for trial in trials)


def test_a_load_within_a_rigid_part_is_judged_to_be_nothing_by_both_methods():
    """Four rods are one body, pushed apart from within: k is zero but for rounding."""
    text = """
param phi = -0.94 rad
pivot O at (0 mm, 0 mm)
pivot G at (213 mm, -88 mm)
slider S along 2.3 rad through G
link OA
link AS
link SB
link AB
OA = 50 mm @ phi
AS = 107 mm
SB = 53 mm
AB = 159 mm
slot T in AB
link ST
ST = 50 mm
assembly S forward
assembly SBA ccw
assembly T back
torque M on OA
actuator F between A and T
find k = M/F
drive phi from -1.2 rad to -0.7 rad
"""
    compilation = Compilation(Source("within.mech", text))
    assert [t.power for t in compilation.verdict.trials] == [0.0] * 4
    assert compilation.verdict.worst < 1e-15
    assert [d.code for d in compilation.report.diagnostics] == ["W503"]


def test_a_pin_that_does_not_turn_has_no_friction_however_near_a_dead_centre():
    """B lies on O, so that OA and AB turn as one; at 36.87° A is on Q, and forces are infinite."""
    text = """
param phi = 36 deg in 36 deg .. 37 deg
pivot O at (0 mm, 0 mm)
pivot Q at (160 mm, 120 mm)
link OA
link QBD
link AB
OA = 200 mm @ phi
AB = 200 mm
QB = 200 mm
QD = 100 mm @ -QB
assembly ABQ cw
force F at D along 90 deg
friction pins 0.1 diameter 10 mm
actuator N between A and Q
find k = N/F
"""
    trials = Compilation(Source("rest.mech", text)).verdict.trials
    assert {t.result for t in trials} >= {"k_f", "k_hold"}
    assert all(t.agrees for t in trials)


def test_an_angle_of_zero_is_moved_where_others_are():
    """At 0 both forces go through O and any of them balance; elsewhere 3·P = -F."""
    text = """
param t = 0 deg
pivot O
link OAB
OA = 100 mm @ t
OB = 300 mm @ t
force P at B along 0 deg
force F at A along 0 deg
find k = P/F
"""
    trials = Compilation(Source("level.mech", text)).verdict.trials
    assert len({t.values["t"] for t in trials}) == len(trials) == 4
    assert all(t.agrees for t in trials)
