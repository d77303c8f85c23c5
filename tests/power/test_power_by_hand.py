"""Speeds, power equations and forces at joints of linkages built by hand."""

import math
from fractions import Fraction

import pytest

from mechc.algebra.product import ONE, Product
from mechc.algebra.sums import add
from mechc.algebra.trigonometry import cosine, sine
from mechc.base.frozen import replace
from mechc.formula.to_text import text
from mechc.formula.tree import ZERO, Call, Symbol, number, power, product, total
from mechc.kinematics.joint_refs import JointRef
from mechc.model.mechanism import Axial, Contact, Mirror, Normal, Pivot, Reaction, Speed
from mechc.pose.pose import Arm
from mechc.power.balance import equations_of
from mechc.power.joint_forces import called, find_force, holding, joint_of, line_of, size_of
from mechc.power.loads import given_size, occurrences, shares, terms
from mechc.power.magnitudes import even, length, magnitude, root
from mechc.power.numbers import is_zero_everywhere
from mechc.power.reactions import ForceTerm, Reactions, directions
from mechc.power.remarks import looseness
from mechc.power.speed_results import speed
from small_poses import (
    ALONG,
    HERE,
    LENGTHS,
    VALUES,
    arm,
    at,
    driven_slider,
    force,
    lever,
    number_of,
    on_pivots,
    plan,
    slider_crank,
    slotted,
    torque,
    two_bars,
    wheels,
)
from small_poses import pose as small_pose

A, B, L, R = (VALUES[n] for n in "ablr")
ALPHA, PHI, PSI, THETA = (VALUES[n] for n in ("alpha", "phi", "psi", "theta"))
a, b, l, r = (Product.symbol(n) for n in "ablr")  # noqa: E741


# ------------------------------------------------------------------------------ speeds


def test_a_point_of_a_lever_moves_counter_clockwise_at_arm_times_rate():
    found = speed(plan(lever()), Speed("point", "B"))
    assert found == ((b,), True)


def test_a_slider_moves_along_its_guide():
    pose = slider_crank()
    found, crank = plan(pose), speed(plan(pose), Speed("link", "OA"))
    (ahead,) = speed(found, Speed("point", "B")).speeds
    ratio = number_of(ahead) / number_of(crank.speeds[0])
    assert ratio == pytest.approx(-R * math.sin(PHI - PSI) / math.cos(PSI))


def test_a_point_without_guide_or_pivot_has_a_magnitude_only():
    pose = slider_crank()
    frames = {**pose.frames, "AB": {**pose.frames["AB"], "C": arm("c", at(90, psi=1))}}
    links = tuple(replace(k, points=tuple(frames[k.name])) for k in pose.mechanism.links)
    found = speed(
        plan(replace(pose, frames=frames, mechanism=replace(pose.mechanism, links=links))),
        Speed("point", "C"),
    )
    assert not found.signed


def test_the_length_of_two_arms_is_by_the_cosine_rule():
    assert length(arm("a", at(phi=1))) == a
    vector = (*arm("a", at(phi=1)), *arm("b", at(psi=1)))
    found = number_of(length(vector))
    assert found == pytest.approx(math.sqrt(A * A + B * B + 2 * A * B * math.cos(PHI - PSI)))


def test_even_powers_leave_a_root():
    assert root(Product(4) * a * a) == Product(2) * a
    assert text(root(Product(9) * a * a * b).formula()) == "3*a*sqrt(b)"


def test_the_magnitude_of_a_length_is_itself_and_of_a_sine_between_bars():
    mechanism = lever().mechanism
    assert magnitude(-a, mechanism) == a
    assert text(magnitude(-(a * sine(at(phi=1))), mechanism).formula()) == "a*abs(sin(phi))"
    squared = magnitude(sine(at(phi=1)), mechanism) ** 2
    assert even(squared) == sine(at(phi=1)) ** 2


# ------------------------------------------------------------------- the power equations


def test_the_power_of_a_load_is_its_speed_along_its_line():
    first, second = terms(plan(lever()))
    assert (first.power, second.power) == ((a,), (-b,))
    assert (first.tie, first.line) == (None, at(90, alpha=1))


def test_a_load_counts_as_often_as_it_acts():
    pose = lever()
    loads = replace(pose.mechanism.loads[0], times=Fraction(3)), pose.mechanism.loads[1]
    mechanism = replace(pose.mechanism, loads=loads, mirror=Mirror(ALONG, ("B",), HERE))
    first, second = terms(plan(replace(pose, mechanism=mechanism)))
    assert (first.power, second.power) == ((Product(6) * a,), (-b,))
    assert [occurrences(mechanism, load) for load in loads] == [2, 1]


def test_a_lever_balances_by_the_inverse_ratio_of_its_arms():
    equations = equations_of(terms(plan(lever())))
    assert equations.solve("P", ["P"], "F") == b / a
    assert equations.number == 1
    assert equations.idle_loads == ()


def tied():
    """The lever with a load G on A, half of F."""
    pose = lever()
    half = product([(number(Fraction(1, 2)), 1), (Symbol("F"), 1)])
    loads = (*pose.mechanism.loads, force("G", "A", tie=half))
    lines = {**pose.lines, "G": at(90, alpha=1)}
    return replace(pose, lines=lines, mechanism=replace(pose.mechanism, loads=loads))


def test_a_tied_load_adds_its_part_to_what_it_is_tied_to():
    equations = equations_of(terms(plan(tied())))
    assert equations.owner("G") == ("F", Product(Fraction(1, 2)))
    assert equations.columns["F"] == [add([-b, a.scaled(Fraction(1, 2))])]
    names = [(load.name, part) for part, load in shares(tied().mechanism, "F")]
    assert names == [("F", ONE), ("G", Product(Fraction(1, 2)))]
    assert given_size(tied().mechanism, "P") is None


def test_a_load_along_its_arm_is_idle():
    pose = replace(lever(), lines={"P": at(90, alpha=1), "F": at(90, alpha=1)})
    assert equations_of(terms(plan(pose))).idle_loads == ("F",)


def test_two_cranks_balance_each_for_itself():
    equations = equations_of(terms(plan(on_pivots())))
    assert equations.number == 2
    assert not equations.determines(["M", "F"])
    assert equations.determines(["M", "T"])


def test_a_motion_that_moves_no_load_is_idle_and_changes_no_power_of_others():
    pose = on_pivots()
    alone = replace(pose.mechanism, loads=(torque("M", "OA"),))
    found = plan(replace(pose, mechanism=alone))
    equations = equations_of(terms(found))
    (idle,) = equations.idle_motions
    power = [Product(5), Product(5)]
    power[idle] = Product(0)
    assert equations.per_power("M", power) == Product(5)
    power[idle] = ONE
    assert equations.per_power("M", power) is None


def test_without_a_load_there_is_no_equation_and_no_motion():
    equations = equations_of(())
    assert (equations.number, equations.idle_motions, equations.idle_loads) == (0, (), ())


# ------------------------------------------------------------------------ forces at joints


def forces(pose, *joint, driving):
    found = Reactions(pose, (driving,)).of(JointRef(*joint))
    assert found is not None
    return lambda direction: {n: number_of(p) for n, p in found.along(direction).items() if p}


def test_the_pivot_of_a_lever_bears_both_loads():
    """R = −F − P with P = F·b/a."""
    along = forces(lever(), "ground", "O", driving="P")
    assert along(at(alpha=1)) == {"F": pytest.approx(-1)}
    assert along(at(90, alpha=1)) == {"F": pytest.approx(-B / A)}


def test_a_rod_bears_the_load_of_its_slider_over_the_cosine():
    along = forces(slider_crank(), "pin", "B", "AB", driving="M")
    assert along(at(psi=1)) == {"F": pytest.approx(1 / math.cos(PSI))}
    assert along(at(90, psi=1)).get("F", 0) == pytest.approx(0, abs=1e-12)


def test_a_guide_bears_the_load_times_the_tangent():
    along = forces(slider_crank(), "ground", "B", driving="M")
    assert along(at(90)) == {"F": pytest.approx(math.tan(PSI))}


def test_a_slot_bears_the_couple_over_its_lever():
    """The pin is pushed across the slot by T over the slot's length."""
    along = forces(slotted(), "contact", "A", driving="M")
    assert along(at(90, theta=1)) == {"T": pytest.approx(1 / L)}


def test_teeth_bear_the_couple_over_the_radius():
    along = forces(on_pivots(wheels()), "mesh", "O", wheels().id, driving="M")
    assert along(at()) == {"T": pytest.approx(-1 / VALUES["c"])}


def test_a_force_term_has_its_cosine_in_another_direction():
    term = ForceTerm(at(phi=1), {"F": a})
    assert term.along(at(psi=1)) == {"F": a * cosine(at(phi=1, psi=-1))}


def test_what_halves_share_is_pushed_along_the_line_only():
    pose = two_bars(mirror=Mirror(ALONG, ("O", "K"), HERE), axis=at(90))
    assert directions(pose, JointRef("ground", "O")) == (at(90),)
    assert directions(pose, JointRef("ground", "K")) == ()
    assert directions(pose, JointRef("pin", "B", "BK")) == (at(90, alpha=-1), at(180, alpha=-1))


def test_forces_are_called_as_the_language_does():
    assert called(Reaction("O", "", "x")) == "R_O"
    assert called(Reaction("B", "AB", "size")) == "R_B on AB"
    assert called(Axial("AB", "A", "B")) == "N_AB"
    assert called(Normal("K")) == "N_K"


def test_the_force_along_a_rod_is_positive_in_tension():
    """F pulls the slider away: the rod is in tension by F/cos ψ, from either end."""
    pose = slider_crank()
    for tail, head in ("AB", "BA"):
        found = find_force(Axial("AB", tail, head), pose, Reactions(pose, ("M",)))
        assert number_of(found.coefficients["F"]) == pytest.approx(1 / math.cos(PSI))


def test_the_size_of_a_force_is_its_two_parts_by_pythagoras():
    pose = lever()
    found = find_force(Reaction("O", "", "size"), pose, Reactions(pose, ("P",)))
    assert text(found.formula) == "sqrt(a^2 + b^2)*abs(F)/a"
    across = find_force(Reaction("O", "", "direction"), pose, Reactions(pose, ("P",)))
    assert text(across.formula).startswith("atan2(")


def test_guides_slots_and_pins_are_found_by_what_is_asked():
    pose = slotted()
    assert holding("A", pose) == JointRef("contact", "A")
    assert holding("K", driven_slider(wheels())) == JointRef("ground", "K")
    assert joint_of(Normal("A"), pose) == JointRef("contact", "A")
    assert joint_of(Reaction("A", "OA", "x"), pose) == JointRef("pin", "A", "OA")
    assert line_of(Normal("A"), pose) == (Arm(ONE, at(90, theta=1)),)
    assert line_of(Normal("K"), driven_slider(wheels())) == (Arm(ONE, at(180)),)
    assert line_of(Reaction("O", "", "y"), pose) == (Arm(ONE, at(90)),)


def test_squares_of_a_sine_and_cosine_merge_in_a_size():
    x, y = a * cosine(at(phi=1)), a * sine(at(phi=1))
    assert size_of(x, y, lambda value: value) == a


def test_what_two_sides_have_in_common_stands_outside_and_no_minus_inside():
    assert text(size_of(-a * b, a * l, lambda value: value).formula()) == "a*hypot(b, l)"


def test_what_nothing_joins_is_named():
    assert looseness(on_pivots().mechanism) == "join link OA to link QB: nothing does"
    assert looseness(on_pivots(wheels()).mechanism) == ""
    assert looseness(slider_crank().mechanism) == ""
    bare = replace(two_bars().mechanism, joints=two_bars().mechanism.joints[:1])
    assert looseness(bare) == "hold link BK, which hangs on pin B alone"


def test_a_link_that_its_own_slot_holds_is_not_loose():
    mechanism = slotted().mechanism
    joints = tuple(j for j in mechanism.joints if not (isinstance(j, Pivot) and j.point == "Q"))
    assert looseness(replace(mechanism, joints=joints)) == ""
    others = tuple(j for j in joints if isinstance(j, Pivot))
    assert looseness(replace(mechanism, joints=others)) == "join link OA to link QB: nothing does"


@pytest.mark.parametrize(
    ("guides", "joined", "said"),
    [
        ("A", "", "keep link AB from turning on its guide by `slide AB along …`"),
        ("AB", "", ""),  # two guides keep its turn
        ("A", "B", ""),  # so does a pin
    ],
)
def test_a_link_may_turn_on_one_guide_and_a_contact(guides, joined, said):
    """The follower AB slides at A, and B touches the cam QC."""
    cam = {"Q": (), "C": arm("b", at(theta=1)), **({joined: ()} if joined else {})}
    frames = {"AB": {"A": (), "B": arm("a", at(90))}, "QC": cam}
    touches = Contact("B", "QC", "Q", "C", ALONG, HERE)
    held = small_pose(frames, pivots="Q", guides=dict.fromkeys(guides, at(90)), joints=[touches])
    assert looseness(held.mechanism) == said


# ------------------------------------------------------------------------------ nothing

SQUARES = [power(Call(name, (Symbol("alpha"),)), number(2)) for name in ("sin", "cos")]


@pytest.mark.parametrize(
    ("formula", "is_zero"),
    [
        (ZERO, True),
        (Symbol("P"), False),
        (total([*SQUARES, number(-1)]), True),
        (total([Symbol("a"), number(Fraction(-LENGTHS["a"]))]), False),
        (Symbol("unknown"), False),
    ],
)
def test_what_is_zero_with_other_parameters_too_is_zero_everywhere(formula, is_zero):
    assert is_zero_everywhere(formula, (), lever()) == is_zero
