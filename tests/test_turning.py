"""Angles carried as cosine and sine: the same values, no arc tangent where none is needed."""

import pytest

from good_mechanisms import ALL, compiled
from mechc.formula.tree import Call
from mechc.formula.walk import evaluate, walk
from mechc.power.numbers import default_values, value_of
from mechc.routine.evaluate import evaluate as run

CLOSED = ("crank_rocker", "watt_closed", "stephenson_closed", "toggle_clamp", "whitworth")


def functions_of(function):
    formulas = [*(s.formula for s in function.steps), function.output]
    return {f.function for formula in formulas for f in walk(formula) if isinstance(f, Call)}


@pytest.mark.parametrize("name", CLOSED)
def test_nothing_is_turned_back_into_an_angle(name):
    for function in compiled(name).routine.functions:
        assert "atan2" not in functions_of(function)


@pytest.mark.parametrize("name", [n for n in ALL if compiled(n).pose.definitions])
def test_the_values_are_those_of_the_formula(name):
    compilation = compiled(name)
    values = default_values(compilation.plan)
    for result, function in zip(
        compilation.balance.results, compilation.routine.functions, strict=True
    ):
        if all(i.name in values for i in function.inputs):
            expected = value_of(result, values)
            assert run(function, values) == pytest.approx(expected, rel=1e-12)


def test_a_condition_keeps_the_angle_that_it_asks_for():
    import mechc

    text = ALL["crank_rocker"].read_text(encoding="utf-8")
    solved = mechc.loads(text + "require theta - psi > 40 deg\n", "conditioned.mech")
    (k, _) = solved._compilation.routine.functions
    assert k.guards
    assert run(k, {**default_values(solved._compilation.plan), "phi": 0.1}) != run(
        k, default_values(solved._compilation.plan)
    )
    assert evaluate(k.guards[0].right, {}) > 0
