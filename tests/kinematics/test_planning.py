"""From relations to speeds: order, Cramer's rule, memory, names of long sums, what locks."""

import math
from itertools import pairwise
from types import SimpleNamespace

import pytest

from mechc.algebra.angle import Angle
from mechc.algebra.factors import ConstantSymbol
from mechc.algebra.product import ONE, ZERO, Product
from mechc.algebra.sums import BoundSum, add
from mechc.base.frozen import replace
from mechc.diagnostics import MechcError, Report
from mechc.formula.tree import Number, Symbol
from mechc.kinematics.from_pose import _check_frame, plan_velocities
from mechc.kinematics.graph import Graph, Relation, Rule, SpeedKind, UnknownSpeed
from mechc.kinematics.locked import described, locked
from mechc.kinematics.planning import _speeds_of, plan_of
from mechc.kinematics.readable import readable_plan
from mechc.kinematics.solving import MOST_UNNAMED_TERMS, Binder, Memory, by_one_other, solve
from mechc.model.mechanism import Find, Friction, LoadRatio, PinFriction
from mechc.source import Source, Span
from small_poses import (
    HERE,
    RACK,
    SCREW,
    VALUES,
    at,
    driven_slider,
    graph,
    lever,
    number_of,
    on_pivots,
    plan,
    slider_crank,
    slotted,
    two_bars,
    wheels,
)

R, C, L, A = (VALUES[n] for n in "rcla")
ALPHA, PHI, PSI, THETA = (VALUES[n] for n in ("alpha", "phi", "psi", "theta"))


def number(speeds, **values):
    (speed,) = speeds
    return number_of(speed, **values)


def test_a_slider_moves_as_its_crank_turns():
    """V_B = −ωr·sin(φ − ψ)/cos ψ."""
    found = plan(slider_crank())
    ratio = number(found.component("B", at())) / number(found.spin("OA"))
    assert ratio == pytest.approx(-R * math.sin(PHI - PSI) / math.cos(PSI))


def test_a_toggle_lifts_by_the_tangent():
    """V_K = 2·V_B·tan α of the speed of the pin along the drive."""
    found = plan(two_bars())
    ratio = number(found.component("K", at(-90))) / number(found.component("B", at(180)))
    assert ratio == pytest.approx(2 * math.sin(ALPHA) * L / (L * math.cos(ALPHA)))


@pytest.mark.parametrize(
    ("joint", "ratio"),
    [(wheels(), -R / C), (wheels(same=True), R / C), (wheels("belt", True), R / C)],
)
def test_wheels_turn_in_the_inverse_ratio_of_their_radii(joint, ratio):
    found = plan(on_pivots(joint))
    assert number(found.spin("QB")) / number(found.spin("OA")) == pytest.approx(ratio)


@pytest.mark.parametrize(("joint", "ahead"), [(RACK, R), (SCREW, C / (2 * math.pi))])
def test_racks_and_nuts_move_ahead_as_wheels_turn(joint, ahead):
    found = plan(driven_slider(joint))
    speed = number(found.component("K", at(90)), pi=math.pi)
    assert speed / number(found.spin("OA"), pi=math.pi) == pytest.approx(ahead)


def test_a_slotted_crank_turns_with_the_pin_across_its_slot():
    found = plan(slotted())
    ratio = number(found.spin("QB")) / number(found.spin("OA"))
    assert ratio == pytest.approx(A * math.cos(PHI - THETA) / L)


def test_what_moves_the_first_load_drives():
    pose = slider_crank()
    loads = pose.mechanism.loads
    turned = replace(pose, mechanism=replace(pose.mechanism, loads=loads[::-1]))
    kinds = [plan(p).graph.unknowns[plan(p).drives[0]].kind for p in (pose, turned)]
    assert kinds == [SpeedKind.SPIN, SpeedKind.SLIDE]


def test_mobility_is_unknowns_less_independent_relations():
    assert [plan(p).mobility for p in (lever(), on_pivots(), on_pivots(wheels()))] == [1, 2, 1]


def test_a_second_pair_of_like_wheels_is_redundant():
    joints = wheels(), wheels("belt", same=False)
    report = Report(Source("", ""))
    found = plan_velocities(on_pivots(*joints), report)
    assert [r.joint for r in found.redundant] == [joints[1].id]
    assert [d.code for d in report.sorted()] == ["W401"]


def test_gears_and_a_belt_on_the_same_wheels_lock():
    with pytest.raises(MechcError) as caught:
        plan(on_pivots(wheels(), wheels("belt", same=True)))
    (found,) = caught.value.diagnostics
    assert found.code == "E401"
    assert "link OA" in found.message + (found.hint or "")


# ------------------------------------------------------------------ relations in numbers


def relation(place, **form):
    """Return a relation in u0, u1 …, their parts as whole numbers."""
    parts = {int(u[1:]): Product(p) for u, p in form.items()}
    return Relation(Rule.BODY, "AB", ("A", "B"), Angle(), parts, Span(place, place + 1))


def of_relations(count, *relations):
    unknowns = tuple(UnknownSpeed(SpeedKind.SPIN, f"L{i}") for i in range(count))
    spins = {u.of: i for i, u in enumerate(unknowns)}
    return Graph(lever(), unknowns, {}, spins, relations)


def test_speeds_follow_one_from_another():
    """2u₀ = u₁ and u₁ = 3u₂, u₀ given: u₁ = 2, u₂ = 2/3."""
    chain = relation(0, u0=2, u1=-1), relation(1, u1=1, u2=-3)
    found = plan_of(of_relations(3, *chain), Report(Source("", "")))
    speeds = [found.speeds[u][0] / found.speeds[0][0] for u in range(3)]
    assert speeds == [Product(1), Product(2), Product(2) / Product(3)]
    assert all(len(block.unknowns) == 1 for block in found.blocks)


def test_relations_that_hang_together_are_one_block():
    """u₁ + u₂ = 3u₀ and u₁ − u₂ = u₀: u₁ = 2, u₂ = 1."""
    pair = relation(0, u0=-3, u1=1, u2=1), relation(1, u0=-1, u1=1, u2=-1)
    found = plan_of(of_relations(3, *pair), Report(Source("", "")))
    (block,) = found.blocks
    assert len(block.relations) == len(block.unknowns) == 2
    ratios = [found.speeds[u][0] / found.speeds[0][0] for u in (1, 2)]
    assert ratios == [Product(2), ONE]


def test_a_block_is_solved_by_cramers_rule():
    """2x + y = 5, x − y = 1 with the right-hand sides as known speeds: x = 2, y = 1."""
    forms = [{0: Product(2), 1: ONE, 2: Product(-5)}, {0: ONE, 1: Product(-1), 2: Product(-1)}]
    assert solve(forms, (0, 1), {2: (ONE,)}, 1) == [(Product(2),), (ONE,)]


def test_a_single_relation_is_divided_through():
    a, b = Product.symbol("a"), Product.symbol("b")
    forms = [{0: a, 1: b}]
    assert solve(forms, (0,), {1: (ONE, ZERO)}, 2) == [(-b / a, ZERO)]


def test_what_a_group_holds_by_itself_locks():
    """u₁ and u₂ hold one another; u₀ only follows."""
    rows = relation(5, u1=1, u2=1), relation(3, u1=1, u2=-1), relation(0, u0=1, u1=1)
    found = locked(of_relations(3, *rows), rows)
    assert found.parts == ("link L1", "link L2", "link AB")
    assert found.span == Span(3, 4)


@pytest.mark.parametrize(
    ("rule", "words"),
    [
        (Rule.SLOT, "the slot of A in QB"),
        (Rule.CONTACT, "the contact of A with QB"),
        (Rule.HELD, "a load that is held still"),
        (Rule.BODY, "link QB"),
    ],
)
def test_a_relation_is_named_by_the_part_that_asks_it(rule, words):
    relation = Relation(rule, "QB", ("A", "C"), Angle(), {}, HERE)
    assert described(relation, lever().mechanism) == words


@pytest.mark.parametrize(
    ("pose", "words"),
    [
        (on_pivots(wheels()), "the pair of gears on O and Q"),
        (on_pivots(wheels("belt")), "the belt between O and Q"),
        (driven_slider(RACK), "the rack at K"),
        (driven_slider(SCREW), "the screw that moves K"),
    ],
)
def test_the_relation_of_what_meshes_is_named_by_its_joint(pose, words):
    (relation,) = graph(pose).relations
    assert described(relation, pose.mechanism) == words


def test_a_guide_is_named_by_its_point():
    relation = Relation(Rule.GUIDE, "", ("K",), Angle(), {}, HERE)
    assert described(relation, lever().mechanism) == "the guide of K"


# ---------------------------------------------------------------------- memory and names


def test_a_speed_that_was_met_before_is_known_again_with_its_sign():
    a, b = Product.symbol("a"), Product.symbol("b")
    memory = Memory((0,), ())
    memory.note(0, (ONE,))
    memory.note(1, (a / b,))
    assert memory.recall({0: a, 2: b}, 2) == (-a / b,)
    assert memory.recall({0: -a, 2: b}, 2) == (a / b,)
    assert memory.recall({0: b, 2: a}, 2) is None


def test_an_angular_velocity_is_no_speed_whatever_the_numbers():
    """An arm of a metre: V = r·ω is ω by number, and r is not 1."""
    arm = Product.of(ConstantSymbol("r", Number(1)))
    memory = Memory((0,), {0})
    memory.note(0, (ONE,))
    assert memory.recall({0: -arm, 1: ONE}, 1) is None
    memory.note(1, (arm,))
    assert memory.recall({0: -arm, 2: ONE}, 2) == (arm,)


def long_sum(*letters):
    terms = [Product.symbol(f"{letters[0]}{i}") for i in range(MOST_UNNAMED_TERMS + 1)]
    return add([x * y for x, y in pairwise(terms)] + [Product.symbol(n) for n in letters])


def test_a_long_sum_has_one_name_however_often_it_comes():
    whole, binder = long_sum("x", "y"), Binder(frozenset({"s1"}))
    once, again = binder.bound(whole), binder.bound(Product(2) * whole)
    assert [b.name for b in binder.bindings] == ["s2"]
    assert once == Product.of(BoundSum("s2", whole))
    assert again == Product(2) * once
    assert binder.bindings[0].value == whole


def test_a_short_sum_stays():
    whole, binder = add(map(Product.symbol, "ab")), Binder(frozenset())
    assert binder.bound(whole) == whole
    assert binder.bindings == []


def test_a_standing_plan_has_the_same_speeds():
    for pose in (slider_crank(), two_bars(), slotted()):
        found = plan(pose)
        read = readable_plan(found)
        for unknown, speeds in found.speeds.items():
            assert number(read.speeds[unknown]) == pytest.approx(number(speeds))


def test_a_form_has_its_part_of_each_drive():
    found = plan(on_pivots())
    first, second = found.graph.spins["OA"], found.graph.spins["QB"]
    value = found.value({first: Product(2), second: Product(-3)})
    assert sorted(p.coefficient for p in value) == [-3, 2]


def test_what_one_other_speed_gives_is_put_by_that_one():
    a, b = Product.symbol("a"), Product.symbol("b")
    assert by_one_other({0: a, 1: -b}, 1, {0: (ONE,)}) == (a / b,)
    assert by_one_other({0: a, 1: -b, 2: a}, 1, {0: (ONE,), 2: (ONE,)}) is None


a, b, c, d = (Product.symbol(name) for name in "abcd")
RATIO = a / b


@pytest.mark.parametrize(
    ("recalled", "found"), [(ONE, ONE), (a * c * d, RATIO), (c / d, RATIO), (None, RATIO)]
)
def test_a_speed_that_another_gives_stays_by_it_where_that_is_as_short(recalled, found):
    """b·u = a·v and v = 1: u is a/b, but where it is known again by less."""
    memory = SimpleNamespace(recall=lambda form, unknown: recalled and (recalled,))
    speeds = _speeds_of([0], [{0: b, 1: -a}], {1: (ONE,)}, 1, memory)
    assert list(speeds) == [(0, (found,))]


@pytest.mark.parametrize(
    ("finds", "frictions", "codes"),
    [((), 0, []), ((), 2, ["E403"]), ((LoadRatio("P", "F"),), 1, ["E402"])],
)
def test_of_a_frame_nothing_is_asked_that_moves(finds, frictions, codes):
    asked = tuple(Find("k", target, HERE) for target in finds)
    pins = tuple(PinFriction("O", "", Symbol("a"), HERE) for _ in range(frictions))
    mechanism = replace(lever().mechanism, finds=asked, friction=Friction(pins))
    report = Report(Source("", ""))
    _check_frame(mechanism, report)
    assert [found.code for found in report.sorted()] == codes
