"""Friction on levers, rods, guides and wheels built by hand: slips, signs and closed forms."""

import math
from fractions import Fraction

import pytest

import mechc
from mechc.algebra.angle import Angle
from mechc.algebra.product import ONE, ZERO, Product
from mechc.algebra.sums import add
from mechc.algebra.trigonometry import cosine, sine
from mechc.base.frozen import replace
from mechc.formula.evaluate import evaluate
from mechc.formula.numeric.rounding import Rounding
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, negative, number, product, total
from mechc.friction.chain_bodies import BodyForce, EquationsCoupled, Task, cut_free
from mechc.friction.closed_form import readable
from mechc.friction.coupled import coupled, true_sizes
from mechc.friction.efficiency import Drives, _has_roots
from mechc.friction.friction_pairs import (
    Component,
    FrictionPair,
    LoadedPair,
    friction_pairs,
    radii,
    reduced,
)
from mechc.friction.iterated import exact, first_order
from mechc.friction.lever_quadratic import LeverPivot, on_lever
from mechc.friction.linear import LinearSolver
from mechc.friction.naming import Endings, Meanings, OwnNames, renamed
from mechc.friction.normal_forces import (
    Idle,
    _vanishes,
    loaded_pairs,
    scaled,
    without_slips_at_rest,
    without_unloaded,
)
from mechc.friction.sequential import SequentialSolver
from mechc.friction.signs.at_any_pose import AtAnyPose
from mechc.friction.signs.at_one_pose import SignsAtOnePose
from mechc.friction.signs.conditions import conditions
from mechc.friction.signs.names import bare, is_root
from mechc.kinematics.joint_refs import JointRef
from mechc.model.mechanism import LoadRatio, Mirror, Rope
from mechc.model.parts.friction import (
    Friction,
    GuideFriction,
    PinFriction,
    RopeFriction,
    ThreadFriction,
    WheelFriction,
)
from mechc.model.result import Definition, FrictionResult, Result, SignCase
from mechc.model.values import completed
from mechc.power.balance import equations_of
from mechc.power.loads import terms
from mechc.power.magnitudes import root
from mechc.power.reactions import Reactions
from mechc.units import NUMBER
from small_poses import (
    ALONG,
    HERE,
    RACK,
    SCREW,
    VALUES,
    arm,
    at,
    driven_slider,
    form,
    graph,
    lever,
    number_of,
    on_pivots,
    plan,
    slider_crank,
    unknown,
    wheels,
)
from small_poses import pose as small_pose

A, B, L, R, C = (VALUES[n] for n in "ablrc")
ALPHA, PHI, PSI = (VALUES[n] for n in ("alpha", "phi", "psi"))
RHO = 0.01


def any_pose():
    return AtAnyPose(set(), Meanings(), ())


def one_pose(own=(), **values):
    return SignsAtOnePose(
        set(), Meanings(), (), {**VALUES, "rho": RHO, **values}, {}, OwnNames(own)
    )


def value(size, signs):
    """Return a product in numbers, what was named put in."""
    known = completed({**VALUES, "rho": RHO}, signs.definitions)
    return evaluate(size.formula(), known)


# --------------------------------------------------------------------------- the lever

ARMS = {"A": arm("a", at(0)), "B": arm("b", at(90))}
UP = BodyForce("P", "A", at(90))
LOAD = BodyForce("F", "B", at(0))


def test_a_moment_is_arm_times_force_counter_clockwise():
    assert UP.moment(ARMS) == Product.symbol("a")
    assert LOAD.moment(ARMS) == -Product.symbol("b")
    assert BodyForce("M", "", None, ZERO, ONE).moment(ARMS) == ONE


def test_a_lever_without_friction_balances_moments():
    found = on_lever(UP, [LOAD], ARMS, None, any_pose())
    assert found.size == Product.symbol("b") / Product.symbol("a")


@pytest.mark.parametrize("signs", [any_pose, one_pose])
@pytest.mark.parametrize("turn", [1, -1])
def test_a_lever_lifts_against_the_friction_circle_of_its_pivot(signs, turn):
    """a·P − b·F = ±ρ·|R|, R the sum of both forces: more than without friction, or less."""
    at_pose = signs()
    bearing = LeverPivot("O", Product.symbol("rho"), Product(turn))
    size = value(on_lever(UP, [LOAD], ARMS, bearing, at_pose).size, at_pose)
    assert A * size - B == pytest.approx(turn * RHO * math.hypot(size, 1))


@pytest.mark.parametrize("turn", [1, -1])
def test_a_force_the_other_way_on_a_lever_has_the_opposite_size(turn):
    """Its arm is negative, and friction at the pivot acts as before."""
    bearing = LeverPivot("O", Product.symbol("rho"), Product(turn))
    down = BodyForce("P", "A", at(270))
    up_size, down_size = (
        value(on_lever(force, [LOAD], ARMS, bearing, at_pose).size, at_pose)
        for force, at_pose in ((UP, one_pose()), (down, one_pose()))
    )
    assert down_size == pytest.approx(-up_size)


@pytest.mark.parametrize("turn", [1, -1])
def test_the_force_on_a_lever_is_a_root_of_the_quadratic_that_is_shown(turn):
    """(a·P − b·F)² = ρ²·(P² + F²) with P in it by its name."""
    signs = one_pose()
    bearing = LeverPivot("O", Product.symbol("rho"), Product(turn))
    found = on_lever(UP, [LOAD], ARMS, bearing, signs)
    size = value(found.size, signs)

    def sides(force):
        known = completed({**VALUES, "rho": RHO, "P": force}, signs.definitions)
        return [evaluate(side, known) for side in found.quadratic]

    assert sides(size) == pytest.approx([(A * size - B) ** 2, RHO**2 * (size**2 + 1)])
    assert sides(2.0) == pytest.approx([(2 * A - B) ** 2, RHO**2 * 5])


@pytest.mark.parametrize(("turn", "turns"), [(1, False), (-1, True)])
def test_no_force_within_the_friction_circle_lifts_the_load(turn, turns):
    """With ρ > a the moment that friction adds outgrows that of the drive; it may still hold."""
    signs = one_pose(rho=0.5)
    found = on_lever(UP, [LOAD], ARMS, LeverPivot("O", Product.symbol("rho"), Product(turn)), signs)
    known = completed({**VALUES, "rho": 0.5}, signs.definitions)
    assert (evaluate(found.turns.formula(), known) > 0) is turns


@pytest.mark.parametrize("turn", [1, -1])
def test_parallel_forces_on_a_lever_need_no_root(turn):
    """a·P − b·F = ±ρ·(P + F)."""
    arms, signs = {"A": arm("a", at(0)), "B": arm("b", at(180))}, one_pose()
    bearing = LeverPivot("O", Product.symbol("rho"), Product(turn))
    size = value(on_lever(UP, [UP._replace(name="F", point="B")], arms, bearing, signs).size, signs)
    assert A * size - B == pytest.approx(turn * RHO * (size + 1))


def test_a_couple_that_drives_a_lever_adds_the_friction_of_its_load():
    """M = b·F + ρ·F."""
    signs = one_pose()
    couple = BodyForce("M", "", None, ZERO, ONE)
    bearing = LeverPivot("O", Product.symbol("rho"), ONE)
    assert value(on_lever(couple, [LOAD], ARMS, bearing, signs).size, signs) == pytest.approx(
        B + RHO
    )


def test_a_force_has_its_cosine_along_and_its_sine_across():
    pull = BodyForce("F", "A", at(phi=1), Product.symbol("a"))
    assert pull.along(at(psi=1)) == Product.symbol("a") * cosine(at(phi=1, psi=-1))
    assert pull.across(at(psi=1)) == Product.symbol("a") * sine(at(phi=1, psi=-1))
    assert pull.scaled(Product(2)).size == Product.symbol("a").scaled(2)


# --------------------------------------------------------------------- pairs and slips


def with_friction(pose, *joints):
    mechanism = replace(pose.mechanism, friction=Friction(tuple(joints)))
    return replace(pose, mechanism=mechanism)


def pin(point, carrier="", radius="r"):
    return PinFriction(point, carrier, Symbol(radius), HERE)


def slip_of(pose):
    (pair,) = friction_pairs(pose)
    return pair, form(pair.slip(graph(pose)), pi=math.pi)


def test_a_pin_slips_with_the_relative_rotation_of_its_links():
    pose = with_friction(slider_crank(), pin("A", "OA"))
    pair, slip = slip_of(pose)
    omega, slide = unknown(graph(pose), "OA"), unknown(graph(pose), "B")
    assert (pair.name, pair.joint) == ("A", JointRef("pin", "A", "AB"))
    own = {omega: -R * math.cos(PHI - PSI) / L - 1, slide: -math.sin(PSI) / L}
    assert slip == pytest.approx(own)


def test_a_pivot_slips_with_the_rotation_of_its_link():
    pose = with_friction(slider_crank(), pin("O"))
    assert slip_of(pose)[1] == {unknown(graph(pose), "OA"): 1}


@pytest.mark.parametrize(("axle", "place"), [("O", 1), ("K", 2)])
def test_a_rope_slips_by_half_of_what_runs_on_and_half_of_what_runs_off(axle, place):
    """From A along x to O, down to K, and along x to B: what A pulls back, B lets run."""
    rope = Rope(("A", "O", "K", "B"), (ALONG, ALONG, ALONG), HERE)
    falls = {rope.id: (at(), at(-90), at())}
    roped = small_pose({}, pivots="OK", guides={"A": at(), "B": at()}, joints=(rope,), falls=falls)
    given = RopeFriction(rope.id, axle, place, Symbol("mu"), Symbol("theta"), None, "", HERE)
    pair, slip = slip_of(with_friction(roped, given))
    first, last = unknown(graph(roped), "A"), unknown(graph(roped), "B")
    assert pair.name == f"{axle}_rope"
    assert slip == pytest.approx({first: -0.5, last: -0.5})


def test_a_guide_slips_with_the_speed_of_its_slider():
    pose = with_friction(slider_crank(), GuideFriction("B", number(Fraction(1, 5)), HERE))
    pair, slip = slip_of(pose)
    assert (pair.name, pair.joint) == ("B_guide", JointRef("ground", "B"))
    assert slip == {unknown(graph(pose), "B"): 1}


def test_rims_slip_with_their_wheel_and_racks_with_their_slider():
    pose = with_friction(
        on_pivots(wheels()), WheelFriction(wheels().id, "gear", "O", Symbol("b"), HERE)
    )
    assert slip_of(pose)[1] == {unknown(graph(pose), "OA"): R}
    pose = with_friction(
        driven_slider(RACK), WheelFriction(RACK.id, "rack", "K", Symbol("b"), HERE)
    )
    assert slip_of(pose)[1] == {unknown(graph(pose), "K"): 1}


def test_a_thread_slips_with_its_pitch_and_its_turn():
    """v·p/(πd) + ω·d/2."""
    thread = ThreadFriction(SCREW.id, "K", Symbol("b"), Symbol("l"), HERE)
    pose = with_friction(driven_slider(SCREW), thread)
    slip = slip_of(pose)[1]
    own = {unknown(graph(pose), "K"): C / (math.pi * L), unknown(graph(pose), "OA"): L / 2}
    assert slip == pytest.approx(own)


def test_nothing_has_friction_with_a_coefficient_of_zero_or_on_a_shared_guide():
    assert friction_pairs(with_friction(slider_crank(), GuideFriction("B", number(0), HERE))) == ()
    shared = slider_crank(mirror=Mirror(ALONG, ("B",), HERE), axis=at())
    pose = with_friction(shared, GuideFriction("B", number(Fraction(1, 5)), HERE), pin("O"))
    (pair,) = friction_pairs(pose)
    assert (pair.name, pair.number) == ("O", 2)


def test_radii_have_one_name_where_they_are_alike():
    (pivot,) = friction_pairs(with_friction(lever(), pin("O")))
    other = pivot._replace(name="A", factor=Product.symbol("c"))
    assert radii([pivot, pivot._replace(name="A")]) == {"O": "rho", "A": "rho"}
    assert radii([pivot, other]) == {"O": "rho_O", "A": "rho_A"}
    assert reduced("C_guide") == "mu_C"


# -------------------------------------------------------------- bodies one after another


def chained(pose, driving, sense, **given):
    """Return the driving load that follows body after body, by the signs of the pose."""
    found, signs = plan(pose), one_pose()
    equations = equations_of(terms(found))
    joint = loaded_pairs(found, equations, driving, friction_pairs(pose), given)
    owners = {load.name: equations.owner(load.name) for load in pose.mechanism.loads}
    task = Task(pose, driving, given, owners, joint, Reactions(pose, (driving,)))
    solver = SequentialSolver(cut_free(task, False), signs, sense)
    (found,) = solver.solve()
    return value(found, signs)


@pytest.mark.parametrize("sense", [1, -1])
def test_a_guide_under_a_rod_is_overcome_with_its_friction(sense):
    """F = S·(cos ψ ∓ μ·|sin ψ|) and M = S·r·sin(φ − ψ)."""
    pose = with_friction(slider_crank(), GuideFriction("B", number(Fraction(1, 5)), HERE))
    rod = 1 / (math.cos(PSI) - sense * 0.2 * abs(math.sin(PSI)))
    expected = rod * R * math.sin(PHI - PSI)
    assert chained(pose, "M", sense, F=ONE) == pytest.approx(expected)


@pytest.mark.parametrize("sense", [1, -1])
def test_a_rod_pulls_along_a_tangent_of_the_friction_circles_at_its_ends(sense):
    """The line passes A and B at ±ρ: of the four tangents the one that takes the most, or least.

    With ψ' its direction, sin(ψ' − ψ) = (d_B − d_A)/l and M = S·(r·sin(φ − ψ') + d_A).
    """
    pose = with_friction(slider_crank(), pin("A", "OA", "rho"), pin("B", "", "rho"))

    def moment(at_a, at_b):
        line = PSI + math.asin((at_b - at_a) / L)
        return (R * math.sin(PHI - line) + at_a) / math.cos(line)

    tangents = [moment(d, e) for d in (RHO, -RHO) for e in (RHO, -RHO)]
    expected = max(tangents) if sense > 0 else min(tangents)
    assert chained(pose, "M", sense, F=ONE) == pytest.approx(expected)


# ----------------------------------------------------------------------- normal forces


def loaded(pose, driving, **given):
    found = plan(pose)
    equations = equations_of(terms(found))
    return loaded_pairs(found, equations, driving, friction_pairs(pose), given)


def test_the_normal_force_of_a_guide_is_the_load_times_the_tangent():
    """Driven by M, the slip per unit speed of the crank is that of the slider."""
    pose = with_friction(slider_crank(), GuideFriction("B", number(Fraction(1, 5)), HERE))
    (pair,) = loaded(pose, "M", F=ONE)
    (across,) = pair.components
    assert number_of(across.ideal) == pytest.approx(math.tan(PSI))
    assert number_of(pair.slip) == pytest.approx(-R * math.sin(PHI - PSI) / math.cos(PSI))
    assert number_of(across.by["B_guide"]) == pytest.approx(math.tan(PSI))


def test_a_pair_that_may_slip_alone_is_idle():
    pose = with_friction(on_pivots(), pin("Q"))
    alone = replace(pose.mechanism, loads=pose.mechanism.loads[:1])
    with pytest.raises(Idle):
        loaded(replace(pose, mechanism=alone), "M")


def test_pairs_that_only_friction_in_one_another_presses_are_left_out():
    """Of O, loaded, and E, pressed by friction in O, with A and B that press one another alone."""
    (whole,) = loaded(with_friction(slider_crank(), pin("O")), "M", F=ONE)

    def loaded_by(name, ideal, *by):
        component = Component(ideal, dict.fromkeys(by, ONE))
        return replace(whole, pair=whole.pair._replace(name=name), components=(component,))

    parts = [loaded_by("O", ONE, "O", "A"), loaded_by("E", ZERO, "O", "B")]
    parts += [loaded_by("A", ZERO, "B"), loaded_by("B", ZERO, "A", "B")]
    found = without_unloaded(parts)
    assert {p.pair.name: [*p.components[0].by] for p in found} == {"O": ["O"], "E": ["O"]}
    assert without_unloaded(parts[:2]) == parts[:2]


def test_a_slip_that_is_rounding_at_any_pose_is_zero():
    """r·sin φ − l·sin β vanishes by what β is; b − a + 0.1 does at the default pose alone."""
    ratio = product([(Symbol("r"), 1), (Symbol("l"), -1), (Call("sin", (Symbol("phi"),)), 1)])
    pose = lever(definitions=[("beta", Call("asin", (ratio,)))])
    crank, rod = Product.symbol("r"), Product.symbol("l")
    always = add([crank * sine(at(phi=1)), -(rod * sine(at(beta=1)))])
    once = add([Product.symbol("b"), -Product.symbol("a"), Product(Fraction(1, 10))])
    assert abs(number_of(once)) < 1e-12
    found = without_slips_at_rest([always, once, crank], plan(pose))
    assert [bool(slip) for slip in found] == [False, True, True]


def test_a_slip_that_vanishes_does_so_next_to_where_rounding_hides_it():
    """sin(β - φ)/g where β is φ up to a quarter turn; it is divided by g = 1e-12 once."""
    slip = sine(at(beta=1, phi=-1)) / Product.symbol("gap")

    def pose(phi, gap):
        rounding = Rounding({"phi": phi, "gap": gap})
        rounding.define([("beta", Call("asin", (Call("sin", (Symbol("phi"),)),)))])
        return rounding

    usual = [pose(0.1 * i, 0.5) for i in range(1, 8)]
    assert _vanishes(slip, [*usual, pose(0.4, 1e-12)])
    assert not _vanishes(slip, [pose(0.4, 1e-12)] * 8)
    assert not _vanishes(slip, [*usual, pose(3.0, 0.5)])


# ------------------------------------------------------------------------------- signs


def test_a_sign_is_that_of_the_odd_factors():
    a, b = Product.symbol("a"), Product.symbol("b")
    assert bare(Product(-3) * a * a * b**-1) == -b
    assert is_root(root(Product.symbol("a")))


def test_a_sum_that_must_be_negative_is_turned_unless_it_has_no_minus():
    """Not −a − ρ > 0 for a + ρ < 0."""
    a, rho = Symbol("a"), Symbol("rho")
    signs = one_pose()
    signs.conditions = {total([a, negative(rho)]): -1, total([a, rho]): -1}
    shown = [(text(left), operator) for left, operator in conditions(signs)]
    assert sorted(shown) == [("a + rho", "<"), ("rho - a", ">")]


def test_at_one_pose_a_sign_is_a_number_with_its_condition():
    signs = one_pose()
    assert signs.note_sign("s", -sine(at(psi=1))) == ONE
    assert list(signs.conditions.values()) == [-1]


def test_at_any_pose_a_sign_is_a_name_and_its_square_is_one():
    signs = any_pose()
    one = signs.note_sign("s", sine(at(psi=1)))
    assert signs.note_sign("t", -sine(at(psi=1)) * sine(at(psi=1)) ** 2) == -one
    assert signs.definitions == [Definition("s", Call("sign", (sine(at(psi=1)).formula(),)))]
    assert signs.unsquared(one * one * one) == one
    assert signs.unsquared(one * one) == ONE


@pytest.mark.parametrize("sense", [1, -1])
def test_a_line_is_turned_by_the_arc_of_a_sine_either_way(sense):
    signs = one_pose()
    turned = signs.turn_line("delta", at(phi=1), "asin", Product.symbol("rho").scaled(sense))
    known = completed({**VALUES, "rho": RHO}, signs.definitions)
    assert turned.evaluate(known) == pytest.approx(PHI + sense * math.asin(RHO))


def test_what_the_users_formulas_stand_for_bears_their_names():
    """β = asin(f·d/L) is the turn by asin(2ρ/L) with ρ = f·d/2, whatever it is called here."""
    f, d, length = map(Symbol, "fdL")
    own = [
        Definition("beta", Call("asin", (product([(f, 1), (d, 1), (length, -1)]),))),
        Definition("f_r", product([(d, 1), (f, 1), (Symbol("D"), -1)])),
        Definition("f_too", f),
    ]
    signs = one_pose(own, f=0.1, d=0.01, L=0.08, D=0.03)
    f, d, length = map(Product.symbol, "fdL")
    turn = signs.name_radius("rho", (f * d).scaled(Fraction(1, 2))).scaled(-2) / length
    assert signs.turn_line("delta", at(phi=1), "asin", turn) == at(phi=1) - Angle.of("beta")
    assert signs.name_coefficient("mu", d * f / Product.symbol("D")) == Product.symbol("f_r")
    assert signs.name_coefficient("mu", f) == f
    assert [text(definition.formula) for definition in signs.definitions] == [
        "f*d/2",
        "asin(2*rho/L)",
        "f*d/D",
    ]


def test_forces_are_not_written_out_for_the_users_names():
    """A force that has each of the two before it twice would be 2^60 times as long, whole."""
    f, mass = Symbol("f"), Symbol("m")
    own = OwnNames([Definition("beta", Call("asin", (f,))), Definition("rho", product([(f, 2)]))])
    own.note("S0", mass)
    for i in range(60):
        before = Symbol(f"S{i}")
        own.note(f"S{i + 1}", Call("hypot", (before, Call("atan", (before,)))))
    assert own.of(Call("hypot", (Symbol("S60"), f))) == ""
    own.note("mu", f)
    assert own.of(Call("asin", (Symbol("mu"),))) == "beta"


def test_names_get_endings_where_they_mean_something_else():
    meanings = Meanings()
    meanings.note([Definition("delta", Symbol("a"))])
    signs = AtAnyPose(set(), meanings, ("hold",))
    assert signs.define("delta", Symbol("b")) == "delta_hold"
    assert signs.define("delta", Symbol("b")) == "delta_hold"
    assert Endings().of("k", "tightening") == ("k_f",)


def test_names_of_code_are_others_on_a_page_where_they_mean_something_else_there():
    meanings = Meanings()
    meanings.note([Definition("b", Symbol("x")), Definition("S", Symbol("b"))])
    code = [
        Definition("a", Symbol("x")),
        Definition("b", Symbol("y")),
        Definition("S", Symbol("b")),
    ]
    names = renamed(code, meanings, ("hold",), {"S_hold"})
    assert {name: other.name for name, other in names.items()} == {"b": "b_hold", "S": "S_hold_"}


# ---------------------------------------------------------- ways to the driving load


def single(ideal, by=ZERO, slip=ONE, factor=Fraction(1, 5)):
    """Return one guide whose own friction changes how hard it is pressed."""
    pair = FrictionPair("G", JointRef("ground", "B"), Product(factor), lambda graph: {})
    return LoadedPair(pair, slip, (Component(ideal, {"G": by} if by else {}),), ())


@pytest.mark.parametrize("sense", [1, -1])
def test_a_guide_that_its_own_friction_presses_gives_a_quotient(sense):
    """n = 2 − σ·μ·n/2 and P = 3 + σ·μ·n with μ = 1/5."""
    joint = single(Product(2), by=Product(Fraction(1, 2)))
    solver = LinearSolver("P", Product(3), [joint], one_pose(), sense)
    size = 2 / (1 + sense * 0.1)
    assert sum(map(number_of, solver.solve())) == pytest.approx(3 + sense * 0.2 * size)


@pytest.mark.parametrize("sense", [1, -1])
def test_what_is_printed_of_a_rope_holds_for_its_smaller_tension(sense):
    """S′ = 3S: the mean tension 2S presses, of which friction is the whole, P = 3 ± 2S."""
    guide = single(Product(2), by=Product(Fraction(1, 2)), factor=1)
    rope = replace(guide, pair=guide.pair._replace(tensions=Product(3)))
    solver = LinearSolver("P", Product(3), [rope], one_pose(), sense)
    load = sum(map(number_of, solver.solve()))
    mean = 2 / (1 + sense / 2)
    assert load == pytest.approx(3 + sense * mean)
    (step,) = solver.steps
    assert step.kind == "ropes"
    known = {"S_G": mean / 2, "v_G": 1.0, "P": load}
    for left, right in step.equations:
        assert evaluate(left, known) == pytest.approx(evaluate(right, known))


def test_more_pairs_than_a_person_reads_hang_together():
    with pytest.raises(EquationsCoupled):
        LinearSolver("P", ONE, [single(ONE)] * 4, one_pose(), 1)


@pytest.mark.parametrize("sense", [1, -1])
def test_to_first_order_friction_adds_its_power_under_ideal_forces(sense):
    joint = single(Product(-2), slip=Product(-3))
    found = first_order(number(5), [joint], sense, lever().mechanism)
    assert evaluate(found.formula, {}) == pytest.approx(5 + sense * 0.2 * 2 * 3)


@pytest.mark.parametrize("sense", [1, -1])
def test_the_coupled_equations_give_the_true_pressing_force(sense):
    """The same guide as above, by Newton's method: n = 2/(1 ± μ/2)."""
    joint = [single(Product(2), by=Product(Fraction(1, 2)))]
    sizes = true_sizes(coupled(joint, set()), sense)
    known = completed({}, sizes.definitions)
    assert known[sizes.names["G"]] == pytest.approx(2 / (1 + sense * 0.1))
    found = exact(number(3), joint, sizes, lambda value: value)
    whole = evaluate(found.formula, completed({}, found.where))
    assert whole == pytest.approx(3 + sense * 0.2 * 2 / (1 + sense * 0.1))


@pytest.mark.parametrize(("sense", "expected"), [("tightening", 0.8), ("releasing", 1.25)])
def test_what_arrives_is_the_smaller_over_the_larger_load(sense, expected):
    """k = 2: tightening the drive takes 2.5, and held at 2.5 the load drives it."""
    ideal = Result("k", LoadRatio("P", "F"), NUMBER, number(2))
    real = FrictionResult("k_f", None, NUMBER, number(Fraction(5, 2)))
    found = Drives(ideal, sense, plan(lever())).efficiency(real, HERE)
    assert evaluate(found.formula, completed({}, found.where)) == pytest.approx(expected)


@pytest.mark.parametrize(("sense", "expected"), [("tightening", 2.5), ("releasing", 1.6)])
def test_a_given_efficiency_divides_what_drives_and_multiplies_what_follows(sense, expected):
    ideal = Result("k", LoadRatio("P", "F"), NUMBER, number(2))
    found = Drives(ideal, sense, plan(lever())).with_constant("k_f", number(Fraction(4, 5)))
    assert evaluate(found.formula, completed({}, found.where)) == pytest.approx(expected)


@pytest.mark.parametrize(("phi", "expected"), [(0.7, math.cos(0.7) / 0.8), (2, math.cos(2) * 0.8)])
def test_a_given_efficiency_changes_sides_with_the_ratio_and_is_printed_for_one(phi, expected):
    ideal = Result("k", LoadRatio("P", "F"), NUMBER, Call("cos", (Symbol("phi"),)), default=0.76)
    share = number(Fraction(4, 5))
    found = Drives(ideal, "tightening", plan(lever())).with_constant("k_f", share)
    assert evaluate(found.formula, completed({"phi": phi}, found.where)) == pytest.approx(expected)
    assert found.case is not None
    assert text(found.case.formula) == "5*cos(phi)/4"


@pytest.mark.parametrize("ideal", [number(2), number(0)])
def test_a_ratio_of_one_sign_or_none_is_printed_as_it_is(ideal):
    ratio = Result("k", LoadRatio("P", "F"), NUMBER, ideal)
    found = Drives(ratio, "tightening", plan(lever())).with_constant("k_f", number(Fraction(4, 5)))
    assert found.case is None


def test_what_adds_to_a_multiple_of_the_drive_slips_as_much_more():
    (found,) = scaled([single(ONE, slip=Product(3))], Product(2))
    assert found.slip == Product(6)


def test_a_sum_over_a_cosine_is_divided_term_by_term():
    """cos φ/(sin φ + c·cos φ) reads as 1/(tan φ + c)."""
    phi = at(phi=1)
    whole = cosine(phi) / add([sine(phi), Product.symbol("c") * cosine(phi)])
    assert text(readable(whole)) == "1/(tan(phi) + c)"


ROOT = Call("sqrt", (Symbol("a"),))


@pytest.mark.parametrize(
    ("formula", "where", "has_roots"),
    [
        (ROOT, (), True),
        (total([Symbol("a"), negative(ROOT)]), (), True),
        (Symbol("n"), (Definition("n", ROOT),), True),
        (Symbol("a"), (Definition("n", ROOT),), False),
        (Symbol("n"), (Definition("n", Symbol("a")),), False),
    ],
)
def test_a_ratio_is_a_root_where_one_is_in_it_or_in_what_it_rests_on(formula, where, has_roots):
    assert _has_roots(SignCase(formula, where, ())) is has_roots


TRAIN = """
mechanism train
param r1 = 20 mm
param r2 = 40 mm
param r3 = 15 mm
param r4 = 60 mm
param l = 80 mm
param c = 0.03
pivot O1
pivot O2
pivot O3
link O1A
link O2B
link O3D
O1A = l @ 0 deg
O2B = r2 @ 0 deg
O3D = 50 mm @ 0 deg
gear O1 r1, O2 r2
gear O2 r3, O3 r4
friction gear O1 c
friction gear O2 c
force P at A along y
torque T on O3D
find k = T/P
"""


def test_what_two_pairs_of_wheels_lose_is_a_square() -> None:
    """By hand η = (1 − c)², no c·(c − 2) + 1."""
    results = mechc.loads(TRAIN).results
    assert text(results["k_hold"].formula).count("(1 - c)^2") == 1
    assert text(results["k_f"].formula).count("(1 + c)^2") == 1


def test_a_loss_in_teeth_is_a_factor_to_first_order() -> None:
    """r·(1 + c)/l, no r/l + c·r/l."""
    rack = """
    mechanism rack
    param l = 400 mm
    param r = 30 mm
    param c = 0.05
    pivot O
    slider A along -y
    link OB
    OB = l @ 50 deg
    rack A on O r
    force P at B along perp OB
    force F at A along y
    friction rack A c
    find k = P/F
    """
    assert text(mechc.loads(rack).results["k_f1"].formula) == "r*(1 + c)/l"
