"""What a step of a derivation is said to hold for; which slopes are given as values."""

import pytest

from mechc.algebra.angle import Angle
from mechc.formula.tree import ZERO, Call, Symbol, product
from mechc.kinematics.graph import Relation, Rule
from mechc.report.derivation.rules import involved
from mechc.report.languages.registry import locale
from mechc.report.latex.notation import notation
from mechc.report.latex.values_at_pose import LONGEST_DERIVATIVE, numbers
from mechc.study.analysis import Analysis, NumericSlope
from mechc.units import FORCE, NUMBER
from small_poses import HERE, graph, lever


def relation(rule, link, *points):
    return Relation(rule, link, points, Angle(), {}, HERE)


@pytest.mark.parametrize(
    ("found", "whom"),
    [
        (relation(Rule.SLOT, "QB", "A"), "QB"),
        (relation(Rule.PROJECTION, "AB", "A", "B"), "AB"),
        (relation(Rule.GUIDE, "", "K"), "K"),
    ],
)
def test_a_relation_holds_for_its_link_or_its_point(found, whom):
    assert involved(found, graph(lever())) == (whom,)


def test_the_value_of_a_slope_stands_for_a_long_derivative_alone():
    """Neither a derivative that is written down nor one that is zero needs its value as well."""
    long = product([(Call("sin", (Symbol(f"x_{i}"),)), 1) for i in range(LONGEST_DERIVATIVE)])
    derivatives = {"a": Symbol("b"), "b": ZERO, "c": long}
    slopes = {
        name: NumericSlope(size, NUMBER) for name, size in (("a", 2.5), ("b", 0.0), ("c", 7.5))
    }
    result = Analysis("p", None, FORCE, Symbol("a"), derivatives=derivatives, slopes=slopes)
    (shown,) = numbers([result], {Symbol("p")}, locale("en"), notation("en"))
    assert "7.5" in shown
