"""What every result with friction promises; and that a broken promise is named."""

import math

import pytest

from good_mechanisms import ALL, begun
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.formula.tree import ZERO, Symbol, number, product
from mechc.friction.promises import broken_promises
from mechc.model.mechanism import Require
from mechc.model.result import Definition
from mechc.source import Source, Span


@pytest.mark.parametrize("name", ALL)
def test_promises_are_kept(name):
    assert broken_promises(begun(name).solution) == []


LEVER = """\
param a = 300 mm
param b = 200 mm
pivot O
link OAB
OA = a @ 0 deg
OB = b @ 90 deg
force P at A along y
force F at B along x
friction pin O 0.2 diameter 20 mm
find k = P/F
"""


def broken(**fields):
    """Return the promises that the lever's k_f breaks with some of its fields changed."""
    solution = Compilation(Source("lever.mech", LEVER)).solution
    assert broken_promises(solution) == []
    solved = []
    for each in solution.solved:
        if each.result.name == "k_f":
            each = replace(each, result=replace(each.result, **fields))
        solved.append(each)
    return broken_promises(replace(solution, solved=tuple(solved)))


def found(name="k_f"):
    results = Compilation(Source("lever.mech", LEVER)).solution.results
    return next(r for r in results if r.name == name)


def test_a_lever_lifts_against_the_radius_times_the_force_on_its_pivot():
    k = found().default
    assert 0.3 * k - 0.2 == pytest.approx(0.002 * math.hypot(k, 1))


def test_less_than_without_friction_is_seen():
    assert broken(default=0.6) == ["k_f is 0.6, 0.666667 without friction"]


def test_a_printed_case_of_another_number_is_seen():
    doubled = product([(number(2), 1), (found().case.formula, 1)])
    (sentence,) = broken(case=replace(found().case, formula=doubled))
    assert sentence.startswith("k_f is 0.67")
    assert "printed as 1.34" in sentence


def test_a_printed_case_of_other_signs_is_seen():
    holds = (Require(Symbol("a"), "<", ZERO, Span(0, 1)),)
    assert broken(case=replace(found().case, holds=holds)) == [
        "k_f is printed for other signs than those of the default pose"
    ]


def test_names_that_mean_nothing_are_seen():
    where = (Definition("beta", Symbol("gamma")),)
    guards = (Require(Symbol("delta"), ">", ZERO, Span(0, 1)),)
    sentences = broken(where=where, formula=Symbol("beta"), guards=guards, inside=frozenset("s"))
    assert sentences[:3] == [
        "beta of k_f uses gamma too early",
        "a condition of k_f uses delta",
        "s is inside a system of k_f that is not there",
    ]


def test_a_name_for_two_things_is_seen():
    where = (*found().where, Definition("x", Symbol("a")), Definition("x", Symbol("b")))
    assert broken(where=where) == ["x means two things", "x of k_f is defined twice"]
