"""Loops of two unknowns closed by hand-built edges: each kind of dyad against coordinates."""

import math
from types import SimpleNamespace

import pytest

from mechc.algebra.angle import principal
from mechc.algebra.product import ONE, Product
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import ZERO, Call, Symbol, number, product
from mechc.model.values import completed
from mechc.pose.loops.by_groups import in_closed_form
from mechc.pose.loops.dyad_closures import dyad
from mechc.pose.loops.dyad_sides import DyadSides, along, common_turn, heron
from mechc.pose.loops.dyads import DyadLoop, _end_from
from mechc.pose.loops.rated import given_rates, loop_rates, moved_by, rate
from mechc.pose.loops.redundant import closure_of
from mechc.pose.pose import Arm, Limit, PoseDefinition, gathered, reverse, turned_by
from mechc.pose.rates import NameRates
from mechc.pose.samples import is_behind
from mechc.pose.vector_graph import Edge, chained, known_span, loop_name, mentioned
from small_poses import HERE, VALUES, arm, at, number_of, size

A, B, R, L = (VALUES[n] for n in "abrl")
PHI = VALUES["phi"]


def edge(tail, head, *arms):
    return Edge(tail, head, tuple(arms), HERE)


def closures(cycle, *unknown, kept=(), fixed=("O", "Q")):
    """Return the group of a loop and each of its closures as numbers of all names."""
    names = frozenset(unknown)
    sides = DyadSides(lambda name: name, frozenset(kept), frozenset(fixed), VALUES)
    group = dyad(DyadLoop.of(cycle, names), sides)
    found = []
    for closure in group.closures if group else ():
        known = completed(VALUES, closure.definitions)
        turned = {n: a.evaluate(known) for n, a in closure.directions.items()}
        found.append({**known, **turned})
    return group, found


def gap(cycle, values):
    arms = [a for e in cycle for a in e.arms]
    turns = [(a.length.evaluate(values), a.angle.evaluate(values)) for a in arms]
    return abs(sum(s * complex(math.cos(t), math.sin(t)) for s, t in turns))


FOUR_BAR = (
    edge("O", "A", *arm("r", at(phi=1))),
    edge("A", "B", *arm("b", at(theta2=1))),
    edge("B", "Q", *arm("l", at(180, psi2=1))),
    edge("Q", "O", *arm("a", at(180))),
)
SLIDER_CRANK = (
    edge("O", "A", *arm("r", at(phi=1))),
    edge("A", "B", *arm("l", at(psi2=1))),
    edge("B", "O", *arm("s", at(180))),
)
CYLINDER = (
    edge("O", "A", *arm("r", at(phi=1))),
    edge("A", "Q", *arm("s", at(psi2=1))),
    edge("Q", "O", *arm("a", at(180))),
)


@pytest.mark.parametrize(
    ("cycle", "unknown", "kind"),
    [
        (FOUR_BAR, ("theta2", "psi2"), "triangle"),
        (SLIDER_CRANK, ("psi2", "s"), "guide"),
        (CYLINDER, ("psi2", "s"), "slot"),
    ],
)
@pytest.mark.parametrize("named", [False, True])
def test_both_closures_of_a_dyad_close_the_loop(cycle, unknown, kind, named):
    group, found = closures(cycle, *unknown, kept=unknown if named else ())
    assert len(found) == 2
    assert group.limit.group == kind
    for values in found:
        assert gap(cycle, values) < 1e-12
    assert abs(found[0][unknown[0]] - found[1][unknown[0]]) > 1e-3


def test_a_slider_is_ahead_of_its_crank_or_behind():
    """The guide is walked from B back to O: the first closure has the rod along that."""
    _, (behind, ahead) = closures(SLIDER_CRANK, "psi2", "s")
    root = math.sqrt(L**2 - (R * math.sin(PHI)) ** 2)
    assert ahead["s"] == pytest.approx(R * math.cos(PHI) + root)
    assert behind["s"] == pytest.approx(R * math.cos(PHI) - root)


def test_two_lengths_follow_from_the_law_of_sines():
    cycle = (
        edge("O", "A", *arm("r", at(phi=1))),
        edge("A", "B", *arm("s", at(90))),
        edge("B", "O", *arm("t", at(180))),
    )
    _, (values,) = closures(cycle, "s", "t")
    assert (values["s"], values["t"]) == pytest.approx((-R * math.sin(PHI), R * math.cos(PHI)))


def test_a_triangle_has_its_area_by_heron():
    three, four, five = map(Product, (3, 4, 5))
    assert evaluate(heron(five, three, four), {}) == pytest.approx(4 * 6)


def test_a_vector_has_its_cosine_along_a_direction():
    found = along((*arm("a", at(phi=1)), *arm("b", at(90))), at(0))
    assert number_of(found) == pytest.approx(A * math.cos(PHI))


def test_arms_turn_by_what_they_have_in_common():
    vector = (*arm("a", at(phi=1, psi=1)), *arm("b", at(90, phi=1)))
    assert common_turn(vector) == at(phi=1)
    assert principal(at(350)) == at(-10)
    assert principal(at(-190)) == at(170)


@pytest.mark.parametrize(
    ("limit", "inside", "outside"),
    [
        (lambda: Limit("", "triangle", arm("d", at()), pq()), 1.5, 3.5),
        (lambda: Limit("", "triangle", arm("d", at()), pq()), 1.5, 0.5),
        (lambda: Limit("", "guide", (), (Product(2), Product.symbol("d"))), -1.9, -2.1),
        (lambda: Limit("", "slot", arm("d", at()), (ONE,)), 1.1, 0.9),
    ],
)
def test_closures_meet_where_a_margin_vanishes(limit, inside, outside):
    """Sides 1 and 2 reach from 1 to 3; a rod of 2 its guide; a slot passes 1 by."""
    signs = [min(m.evaluate({"d": d}) for m in limit().margins) > 0 for d in (inside, outside)]
    assert signs == [True, False]


def pq():
    return ONE, Product(2)


def test_what_rests_on_a_root_ends_with_it():
    root = Call("sqrt", (Symbol("x"),))
    definitions = (
        PoseDefinition("p", root),
        PoseDefinition("q", Symbol("p")),
        PoseDefinition("z", number(1)),
    )
    found = in_closed_form("O-A", definitions, root)
    assert found.names == {"p", "q"}
    assert found.margin == Symbol("x")
    arc = in_closed_form("O-A", definitions, Call("asin", (Symbol("x"),)))
    assert [evaluate(arc.margin, {"x": x}) for x in (0.5, -1.5)] == [0.5, -0.5]


def test_a_loop_closes_at_the_rates_of_its_unknowns():
    """The slider-crank's rod turns by −r·cos φ/(l·cos ψ) of its crank's rate."""
    loop = gathered(a for e in SLIDER_CRANK for a in e.arms)
    found = loop_rates([loop], ["psi2", "s"], {"phi": ONE})
    values = {**VALUES, "psi2": -0.3}
    turning = -R * math.cos(PHI) / (L * math.cos(-0.3))
    assert found["psi2"].evaluate(values) == pytest.approx(turning)
    assert found["s"].evaluate(values) == pytest.approx(
        -R * math.sin(PHI) - L * math.sin(-0.3) * turning
    )


def test_a_turning_vector_moves_across_itself_and_a_growing_one_along():
    vector = arm("s", at(psi2=1))
    across, ahead = rate(vector, {"psi2": ONE}), rate(vector, {"s": ONE})
    assert across == (Arm(Product.symbol("s"), at(90, psi2=1)),)
    assert ahead == (Arm(ONE, at(psi2=1)),)


def test_names_move_with_the_drive_as_their_formulas_do():
    definitions = [
        PoseDefinition("u", Call("sin", (Symbol("phi"),))),
        PoseDefinition("w", Symbol("u")),
        PoseDefinition("v", Symbol("a")),
    ]
    assert moved_by("phi", definitions) == {"phi", "u", "w"}
    rates = given_rates(definitions, "phi")
    assert set(rates) == {"phi", "u", "w"}
    assert number_of(rates["w"]) == pytest.approx(math.cos(PHI))


def test_loops_are_named_by_their_points():
    assert loop_name(FOUR_BAR) == "O-A-B-Q"
    assert chained(["", "A", "A_0", "B"]) == "A-B"
    assert mentioned(FOUR_BAR[1].arms) == {"b", "theta2"}
    assert known_span(FOUR_BAR, frozenset({"theta2", "psi2"})) == ("Q", "A")
    assert known_span(FOUR_BAR, frozenset({"theta2", "a"})) is None


def test_vectors_are_gathered_turned_and_reversed():
    a, b = Product.symbol("a"), Product.symbol("b")
    whole = gathered([Arm(a, at(30)), Arm(b, at(210)), Arm(b, at(30)), Arm(b, at(phi=1))])
    assert whole == (Arm(a, at(30)), Arm(b, at(phi=1)))
    assert gathered([Arm(-a, at(30))]) == (Arm(a, at(210)),)
    assert turned_by(arm("a", at(psi=1)), {"psi": at(90)}) == arm("a", at(90))
    vector = (*arm("a", at(phi=1)), *arm("b", at(90)))
    assert size(reverse(vector)) == pytest.approx(-size(vector))


def test_a_negative_length_is_behind():
    assert is_behind(Product.symbol("s"), [{}, {"s": -1.0}])
    assert not is_behind(Product.symbol("s"), [{"s": 1.0}])


def test_what_rests_on_a_name_without_a_rate_has_none():
    rates = NameRates({"phi": number(1)}, unknown=["psi"])
    assert rates.of(Symbol("psi")) is None
    assert rates.of(product([(Symbol("phi"), 1), (Symbol("psi"), 1)])) is None
    assert rates.of(Symbol("r")) == ZERO
    assert rates.of(product([(Symbol("r"), 1), (Symbol("phi"), 1)])) == Symbol("r")


def test_what_turns_as_one_body_has_the_direction_that_closes_its_loop():
    """r along phi + 90° and, 30° ahead of it, one vector of unknown direction theta2."""
    known = arm("r", at(90, phi=1))
    moving = [*arm("l", at(30, theta2=1))]
    state = SimpleNamespace(angles={"theta2"}, named=set(), free_name=lambda stem: stem)
    found = closure_of("theta2", known, moving, state)
    values = completed(VALUES, found.definitions)
    turned = found.directions["theta2"].evaluate(values)
    assert math.remainder(turned + math.pi / 6 - (PHI + math.pi / 2) - math.pi, math.tau) == (
        pytest.approx(0, abs=1e-12)
    )


# ------------------------------------------------------------------- where edges end


@pytest.mark.parametrize(
    ("pin", "end"),
    [("A", "C"), ("B", "C"), ("C", "D"), ("D", "")],
)
def test_edges_that_turn_together_are_followed_to_where_they_end(pin, end):
    """AB and BC are arms of one body at theta, CD one of another."""
    edges = [
        edge("A", "B", *arm("a", at(theta=1))),
        edge("B", "C", *arm("a", at(30, theta=1))),
        edge("C", "D", *arm("b", at(psi=1))),
    ]
    assert _end_from(pin, edges) == end
