"""Values of results by hand: which form stands in a pose, and what is nothing but rounding."""

import math

import pytest

from mechc.base.frozen import fields, replace
from mechc.compilation import Compilation
from mechc.formula.numeric.rounding import PrintedNumber
from mechc.formula.tree import Symbol, number, total
from mechc.model.mechanism import Let, Mechanism, Parameter, Require
from mechc.model.result import ClosedLoop, Definition, Result, UsedSolution
from mechc.model.values import (
    PrintedForm,
    following,
    of_sound_form,
    user_defined,
    usual_units,
    valid_form,
    valued_form,
)
from mechc.source import Source, Span
from mechc.units import LENGTH, NUMBER

X = Symbol("x")
POSITIVE = Require(X, ">", number(0), Span(0, 1))
ELSEWHERE = Result("k", None, NUMBER, number(2))
HERE = Result("k", None, NUMBER, X, guards=(POSITIVE,), elsewhere=ELSEWHERE)
ALONE = replace(HERE, elsewhere=None)


@pytest.mark.parametrize(
    ("result", "x", "found"),
    [
        (HERE, 1.0, HERE),
        (HERE, -1.0, ELSEWHERE),
        (HERE, math.nan, ELSEWHERE),
        (ALONE, 1.0, ALONE),
        (ALONE, -1.0, None),
        (replace(ALONE, guards=()), math.nan, replace(ALONE, guards=())),
    ],
)
def test_the_form_that_stands_is_that_whose_conditions_hold(result, x, found):
    assert valid_form(result, {"x": x}) == found


@pytest.mark.parametrize(("x", "found"), [(1.0, (HERE, 1.0)), (-1.0, (ELSEWHERE, 2.0))])
def test_the_form_that_stands_comes_with_its_value(x, found):
    assert valued_form(HERE, {"x": x}) == found


def test_what_a_formula_needs_and_is_not_given_leaves_it_without_a_value():
    assert valued_form(replace(ALONE, guards=()), {}) == (replace(ALONE, guards=()), None)


@pytest.mark.parametrize(
    ("value", "size", "found"),
    [
        (0.5, 0.5, 0.5),
        (1e-17, 0.0, 2.0),  # what is rounded may be a sign, which the other form has not
        (0.0, 0.0, 0.0),
        (math.inf, math.inf, math.inf),
        (None, None, None),
    ],
)
def test_what_is_zero_but_for_rounding_is_looked_at_in_the_form_for_elsewhere(value, size, found):
    def look(result: Result) -> PrintedForm:
        is_here = result is HERE
        return PrintedForm(
            result, value if is_here else 2.0, PrintedNumber(size if is_here else 2.0)
        )

    assert of_sound_form(HERE, look).number == found


def test_solutions_are_added_kind_by_kind():
    def solution(name: str) -> UsedSolution:
        loop, definition = ClosedLoop(name, frozenset(), X), Definition(name, X)
        parameter = Parameter(name, LENGTH, Span(0, 1))
        return UsedSolution(
            (replace(HERE, name=name),), (definition,), (loop,), (POSITIVE,), (parameter,)
        )

    one, other = solution("a"), solution("b")
    both = one + other
    assert both == UsedSolution(
        *((*getattr(one, f.name), *getattr(other, f.name)) for f in fields(UsedSolution))
    )
    assert [k.name for k in both.results] == [d.name for d in both.definitions] == ["a", "b"]


def test_without_another_form_zero_stays_zero():
    assert of_sound_form(ALONE, lambda r: PrintedForm(r, 1e-17, PrintedNumber(0.0))).number == 0


@pytest.mark.parametrize(
    ("given", "units"),
    [
        ("param F = 2 lbf\nparam a = 3 in", ("in", "lbf", "lbf*in")),
        ("param M = 2 ft*lbf", ("m", "lbf", "ft*lbf")),
        ("param F = 2 kN\nparam a = 3 mm", ("mm", "kN", "N*m")),
        ("param M = 5 N*mm", ("m", "N", "N*mm")),
    ],
)
def test_moments_have_the_unit_that_goes_with_forces_and_lengths(given, units):
    asked = "pivot O\nlink OA\nOA = 1 m @ 0 deg\nforce P at A along y\ntorque T on OA\nfind P"
    assert usual_units(Compilation(Source("m.mech", f"{given}\n{asked}")).mechanism) == units


def test_definitions_follow_with_the_parameters_that_they_rest_on_in_either_order():
    a = Parameter("a", LENGTH, Span(0, 0))
    b = Parameter("b", LENGTH, Span(0, 0), total([Symbol("a"), number(1)]), dependent=True)
    c = Let("c", total([Symbol("b"), Symbol("d")]), LENGTH, Span(0, 0))
    mechanism = Mechanism("m", "", "", Span(0, 0), parameters=(a, b), lets=(c,))
    assert following(mechanism).complete({"a": 2.0}) == {"a": 2.0, "b": 3.0}
    chain = following(mechanism, (*user_defined(mechanism).items(), ("d", Symbol("b"))))
    assert [name for name, _ in chain.definitions] == ["b", "d", "c"]
    assert chain.complete({"a": 2.0}) == {"a": 2.0, "b": 3.0, "c": 6.0, "d": 3.0}
    assert chain.complete({"d": 1.0}) == {"d": 1.0}
