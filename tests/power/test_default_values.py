"""Results with the values that the description gives: what loads are tied to counts, too."""

import math

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Symbol, number
from mechc.model import values
from mechc.model.mechanism import Require
from mechc.model.result import Result
from mechc.power.numbers import form_of, value_of
from mechc.source import Source, Span
from mechc.units import NUMBER


def test_a_load_may_rest_on_formulas_of_the_user_s_one_behind_the_other():
    lever = """
        mechanism lever
        param a = 60 mm
        param S = 2 kN
        pivot O
        link OAB
        OA = a @ 20 deg
        OB = 90 mm @ 200 deg
        force P at A along -y
        force F at B along -y
        list sizes = 1 kN, 3 kN, 7 kN
        let T = next 2*S in sizes
        let P = T
        find F
        friction pins 0.1 diameter 10 mm
    """
    found = {
        r.name: r.default for r in compile_source(Source("lever.mech", lever)).solution.results
    }
    assert found["F"] == pytest.approx(7000 * 60 / 90)
    assert found["F_f"] > found["F"]


THROUGH_THE_PIVOT = """
param t = 105 deg in 8 deg .. 188 deg
pivot O
slider A along 180 deg
link AB
link OBC
AB = 64.5 mm @ 315 deg
OB = 98.4 mm @ 105 deg
OC = 74 mm @ t
force P at A along 180 deg
force F at C along 105 deg
friction pins 0.232 diameter 17.1 mm
friction slider A 0.168
find k = P/F
"""
"""F passes through O: the rod AB is loaded by the friction at O alone, with either sign."""


def test_what_rests_on_a_sign_that_rounding_makes_is_not_zero():
    """The case printed has the sign of the load on AB, 1e-17; all links together have none."""
    results = mechc.loads(THROUGH_THE_PIVOT).results
    beside = mechc.loads(THROUGH_THE_PIVOT.replace("105 deg in", "105.0001 deg in")).results
    assert results["k"].default == 0
    assert results["k_f"].default == pytest.approx(0.0389900075, rel=1e-8)
    assert results["k_f"].default == pytest.approx(beside["k_f"].default, rel=1e-3)


X = Symbol("x")
POSITIVE = Require(X, ">", number(0), Span(0, 1))
OWN = Result("k", None, NUMBER, X, guards=(POSITIVE,))


def test_a_value_is_found_once_with_the_form_that_has_it(monkeypatch):
    found = []
    monkeypatch.setattr(values, "evaluate", lambda f, at: found.append(f) or evaluate(f, at))
    assert form_of(OWN, {"x": 3.0}) == (OWN, 3.0)
    assert found.count(X) == 2  # in the condition, and as the formula


@pytest.mark.parametrize(("at", "value"), [({"x": 3.0}, 3.0), ({"x": -1.0}, math.nan), ({}, None)])
def test_a_result_has_a_value_where_its_condition_holds(at, value):
    assert value_of(OWN, at) == pytest.approx(value, nan_ok=True)


AT_REST = """
param a = 60 mm
param alpha = {alpha} deg
pivot A
link AB
AB = 2*a @ -alpha
pivot C
link CD
CD = a @ 0 deg
contact B on CD normal 90 deg
CB = 2*a @ 30 deg
force P at B along -90 deg
force F at D along 90 deg
find k = P/F
"""


@pytest.mark.parametrize(("alpha", "k"), [(60, 1 / math.sqrt(3)), (90, None)])
def test_a_ratio_is_undetermined_where_all_loads_rest_that_move_beside(alpha, k):
    """Under the upright crank the lever stands still: what cos alpha leaves when it is cancelled
    holds beside that pose alone, and any P is balanced by the crank."""
    (found,) = compile_source(Source("rest.mech", AT_REST.format(alpha=alpha))).solution.results
    assert found.default == (k and pytest.approx(k))
    assert found.undetermined == (k is None)
