"""Forces at joints, contacts and speeds out of equilibrium, on linkages built by hand."""

import math

import pytest

from mechc.base.frozen import replace
from mechc.model.mechanism import (
    Axial,
    Contact,
    ForcePair,
    LoadRatio,
    Mirror,
    Normal,
    Reaction,
    Speed,
    SpeedRatio,
)
from mechc.model.result import Result
from mechc.pose.pose import PointContact
from mechc.statics.actions import Actions
from mechc.statics.assembly import AssembledBodies, Cylinder, Plane, PointForce, Transfer
from mechc.statics.balanced import Balanced
from mechc.statics.contacts import pulling
from mechc.statics.counted import uncounted
from mechc.statics.diagrams.load_cases import sizes_of
from mechc.statics.equations import UnknownForce, equilibrium
from mechc.statics.joint_forces import joint_force
from mechc.statics.speeds import speed_ratio
from mechc.statics.transfers import both, transfers
from mechc.statics.unfold import Unfolding
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
    lever,
    on_pivots,
    slider_crank,
    slotted,
    two_bars,
    wheels,
)

A, B, L, R, C = (VALUES[n] for n in "ablrc")
ALPHA, PHI, PSI, THETA = (VALUES[n] for n in ("alpha", "phi", "psi", "theta"))
ALL = {**VALUES, "pi": math.pi}


def at_joint(pose, target, load="F"):
    known = {k.name for k in pose.mechanism.loads[1:]}
    answer = joint_force(Balanced(pose, ALL), target, load, known)
    assert not answer.trouble
    return answer.value


def test_the_pivot_of_a_lever_bears_both_loads():
    """R = −F·e(α) − P·n(α) with P = F·b/a."""
    x = -math.cos(ALPHA) + B / A * math.sin(ALPHA)
    y = -math.sin(ALPHA) - B / A * math.cos(ALPHA)
    assert at_joint(lever(), Reaction("O", "", "x")) == pytest.approx(x)
    assert at_joint(lever(), Reaction("O", "", "y")) == pytest.approx(y)
    assert at_joint(lever(), Reaction("O", "", "size")) == pytest.approx(math.hypot(1, B / A))


def test_a_rod_is_in_tension_where_the_slider_is_pulled_away():
    for tail, head in ("AB", "BA"):
        found = at_joint(slider_crank(), Axial("AB", tail, head))
        assert found == pytest.approx(1 / math.cos(PSI))


def test_a_guide_pushes_across_with_the_tangent():
    assert at_joint(slider_crank(), Normal("B")) == pytest.approx(math.tan(PSI))
    assert at_joint(slider_crank(), Reaction("B", "", "y")) == pytest.approx(math.tan(PSI))


def test_a_pin_pushes_a_link_as_the_link_pushes_back():
    """On AB at A acts what the crank passes on: F from B along the rod, the other way."""
    pull = 1 / math.cos(PSI)
    found = at_joint(slider_crank(), Reaction("A", "AB", "x"))
    assert found == pytest.approx(-pull * math.cos(PSI))
    crank = at_joint(slider_crank(), Reaction("A", "OA", "x"))
    assert crank == pytest.approx(pull * math.cos(PSI))


def test_a_slot_pushes_across_with_the_couple_over_its_length():
    assert at_joint(slotted(), Normal("A"), "T") == pytest.approx(1 / L)


@pytest.mark.parametrize(
    ("pose", "above", "below", "ratio"),
    [
        (on_pivots(wheels()), "QB", "OA", -R / C),
        (on_pivots(wheels(same=True)), "QB", "OA", R / C),
        (slotted(), "QB", "OA", A * math.cos(PHI - THETA) / L),
    ],
)
def test_links_turn_as_couples_on_them_balance(pose, above, below, ratio):
    target = SpeedRatio(Speed("link", above), Speed("link", below))
    assert speed_ratio(Balanced(pose, ALL), target).value == pytest.approx(ratio)


@pytest.mark.parametrize(
    ("pose", "point", "ratio"),
    [
        (slider_crank(), "B", -R * math.sin(PHI - PSI) / math.cos(PSI)),
        (driven_slider(RACK), "K", R),
        (driven_slider(SCREW), "K", C / (2 * math.pi)),
    ],
)
def test_sliders_move_as_forces_on_them_balance_couples(pose, point, ratio):
    target = SpeedRatio(Speed("point", point), Speed("link", "OA"))
    assert speed_ratio(Balanced(pose, ALL), target).value == pytest.approx(ratio)


def test_a_pair_of_forces_pushes_its_second_point_ahead_and_the_first_one_back():
    pose = two_bars()
    pair = ForcePair("S", "B", "K", HERE)
    mechanism = replace(pose.mechanism, loads=(pair,))
    changed = replace(pose, mechanism=mechanism, lines={"S": at(90)})
    pushes = {a.point: a.force for a in Unfolding(changed, ALL).assembly().loads["S"]}
    assert pushes["K"] == pytest.approx((0, 1), abs=1e-12)
    assert pushes["B"] == pytest.approx((0, -1), abs=1e-12)


def test_a_rod_in_tension_pulls_its_ends_together():
    actions = Actions(Unfolding(slider_crank(), ALL).assembly())
    actions.unknown(UnknownForce("AB", "", "tension"), 2.0)
    (at_a,), (at_b,) = actions.on_pins["A"].values(), actions.on_pins["B"].values()
    along = 2 * math.cos(PSI), 2 * math.sin(PSI)
    assert at_a.force == pytest.approx(along)
    assert at_b.force == pytest.approx(tuple(-part for part in along))


def test_a_guide_acts_across_itself():
    actions = Actions(Unfolding(slider_crank(), ALL).assembly())
    actions.unknown(UnknownForce("guide", "B", "normal"), 3.0)
    (found,) = actions.on_pins["B"].values()
    assert found.force == pytest.approx((0, 3))


@pytest.mark.parametrize(("turn", "codes"), [(90, []), (-90, ["E604"])])
def test_a_contact_may_push_and_not_pull(turn, codes):
    """The pin of OA rests on QB: turned round, its face would have to hold it down."""
    pose = on_pivots(Contact("A", "QB", "Q", "B", ALONG, HERE))
    touch = PointContact("contact", "A", "QB", "Q", arm("l", at(theta=1)), at(turn, theta=1), HERE)
    whole = replace(pose, contacts=(touch,))
    asked = Result("k", LoadRatio("M", "T"), NUMBER, None)
    assert [d.code for d in pulling([asked], Balanced(whole, ALL))] == codes


def test_loads_have_the_sizes_that_are_given_first():
    mechanism = lever().mechanism
    assert sizes_of(mechanism, {"P": 2.0}, {"F": 3.0}) == {"P": 2.0, "F": 3.0}


def test_a_pin_on_which_no_friction_acts_is_named():
    """The crank turns on O, crank and rod on A; B is guided, and the rod turns on it."""
    pins = list(uncounted(Unfolding(slider_crank(), ALL), ()))
    assert pins == ["O on OA", "A on OA", "A on AB", "B on AB"]
    assert list(uncounted(Unfolding(lever(), ALL), ())) == ["O on OAB"]


def test_the_parts_of_a_telescope_turn_one_another_oppositely():
    along = Plane(0.0, 1.0)
    cylinder = Cylinder("T", ("A", "B"), 0.5, along)
    system = equilibrium(AssembledBodies((), (), (), (), (), (), (cylinder,), {}, {}))
    column = system.unknowns.index(UnknownForce("T", "", "couple"))
    couples = sorted(row[column] for row in system.rows if column in row)
    assert couples == [-1.0, 1.0]
    side = system.unknowns.index(UnknownForce("T", "", "side"))
    arms = [row[side] for row in system.rows if abs(row.get(side, 0.0)) not in (0.0, 1.0)]
    assert arms == [-0.5]


@pytest.mark.parametrize(("same", "second"), [(False, C), (True, -C)])
def test_wheels_turn_each_other_and_the_arm_takes_what_is_left(same, second):
    """A unit force at the pitch point puts r on one wheel, ±c on the other, the rest on the arm."""
    pose = on_pivots(replace(wheels(same=same), arm="OQ"))
    (pair,) = transfers(Unfolding(pose, ALL))
    assert [c.moment for c in pair.actions] == pytest.approx([R, second])
    assert [c.moment for c in pair.bearings] == pytest.approx([-R - second])


def test_the_twin_of_a_rope_has_a_label_and_that_of_gears_has_none():
    pose = two_bars(mirror=Mirror(ALONG, ("K",), HERE), axis=at())
    halves = Unfolding(pose, ALL)
    for label, twin in (("", ""), ("B-O", "B-O'")):
        acting = (PointForce("B", Plane(1.0, 0.0)),)
        (own, other) = both(halves, Transfer("rope", "r", acting, label=label))
        assert (own.label, other.label) == (label, twin)
