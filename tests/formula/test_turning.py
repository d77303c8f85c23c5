"""Angles carried as cosine and sine: the same values, no arc tangent where none is needed."""

import math

import pytest

from good_mechanisms import ALL, compiled
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import ONE, Call, Symbol, negative, number, power, product, total
from mechc.formula.walk import symbols, walk
from mechc.power.numbers import default_values, value_of
from mechc.routine.evaluate import evaluate as run
from mechc.routine.unit_vectors import in_unit_vectors
from sources import in_thirds

CLOSED = ("crank_rocker", "watt_closed", "stephenson_closed", "toggle_clamp", "whitworth")


def functions_of(function):
    formulas = [*(s.formula for s in function.steps), function.output]
    return {f.function for formula in formulas for f in walk(formula) if isinstance(f, Call)}


@pytest.mark.parametrize("name", CLOSED)
def test_nothing_is_turned_back_into_an_angle(name):
    for function in compiled(name).routine.functions:
        assert "atan2" not in functions_of(function)


@pytest.mark.parametrize("name", in_thirds(ALL))
def test_the_values_are_those_of_the_formula(name):
    compilation = compiled(name)
    values = default_values(compilation.plan)
    for result, function in zip(
        compilation.solution.results, compilation.routine.functions, strict=True
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


@pytest.mark.parametrize(("name", "groups"), [("crank_rocker", 1), ("watt_closed", 2)])
def test_a_triangle_costs_one_root(name, groups):
    k = compiled(name).routine.functions[0]
    assert sum(text(s.formula).count("sqrt") for s in k.steps) == groups
    assert "sqrt" not in text(k.output)


R, P, Q, X, Y = map(Symbol, "rpqxy")


def heron(d, p, q):
    return product(
        (total(f), 1)
        for f in ((p, q, d), (p, q, negative(d)), (d, p, negative(q)), (d, q, negative(p)))
    )


def kink(d):
    """Return the angle between the sides p and q of a triangle."""
    squares = total([power(P, number(2)), power(Q, number(2)), negative(power(d, number(2)))])
    return Call("atan2", (Call("sqrt", (heron(d, P, Q),)), squares))


def carried(definitions, result, values):
    """Return a result with angles carried as vectors."""
    written, (output,) = in_unit_vectors(definitions, [result], (), {*values})
    known = dict(values)
    for name, formula in written:
        known[name] = evaluate(formula, known)
    return evaluate(output, known)


def plainly(definitions, result, values):
    known = dict(values)
    for name, formula in definitions:
        known[name] = evaluate(formula, known)
    return evaluate(result, known)


OF_ONE_ANGLE = [Call(f, (Symbol("mu"),)) for f in ("sin", "cos", "tan", "cot", "sec", "csc")]


@pytest.mark.parametrize("wanted", OF_ONE_ANGLE, ids=text)
@pytest.mark.parametrize(
    ("p", "q", "r"), [(2, 3, 4), (-2, 3, 4), (2, -3, 1.5), (3, 3, 0.1), (2, 3, 5.5)]
)
def test_a_triangle_is_the_same_with_sides_of_any_sign_and_nan_without_one(wanted, p, q, r):
    values = {"p": p, "q": q, "r": r}
    expected = plainly([("mu", kink(R))], wanted, values)
    assert carried([("mu", kink(R))], wanted, values) == pytest.approx(expected, nan_ok=True)
    assert math.isnan(expected) == (r > 5)


@pytest.mark.parametrize("wanted", OF_ONE_ANGLE, ids=text)
@pytest.mark.parametrize("x", [-0.9, 0.3, 1.2])
def test_an_arc_sine_is_the_same_and_nan_beyond_one(wanted, x):
    definitions = [("mu", Call("asin", (X,)))]
    expected = plainly(definitions, wanted, {"x": x})
    assert carried(definitions, wanted, {"x": x}) == pytest.approx(expected, nan_ok=True)
    assert math.isnan(expected) == (x > 1)


def test_the_length_of_a_vector_is_not_rooted_where_its_square_is_enough():
    definitions = [("d", Call("hypot", (X, Y))), ("mu", kink(Symbol("d")))]
    written, (output,) = in_unit_vectors(definitions, [OF_ONE_ANGLE[0]], (), {*"pqxy"})
    assert [name for name, _ in written] == ["d_squared"]
    assert text(output).count("sqrt") == 1


@pytest.mark.parametrize("order", [1, -1])
def test_the_length_of_a_vector_is_used_once_it_is_defined(order):
    definitions = [("d", Call("hypot", (X, Y))), ("t", Call("atan2", (Y, X)))][::order]
    wanted = product([(Symbol("d"), 1), (Call("sin", (Symbol("t"),)), 1)])
    values = {"x": 0.3, "y": -0.7}
    assert carried(definitions, wanted, values) == pytest.approx(-0.7)


def test_vectors_of_many_uses_are_divided_by_their_size_once():
    angles = [Symbol(f"t{i}") for i in range(9)]
    wanted = total(Call("sin", (total([Symbol("mu"), t]),)) for t in angles)
    _, (output,) = in_unit_vectors([("mu", kink(R))], [wanted], (), {*"pqr"})
    assert {"cos_mu", "sin_mu"} <= symbols(output)
    assert "/" not in text(output)


def test_angles_on_angles_stay_short_and_far_from_underflow():
    definitions, last = [], ONE
    for i in range(40):
        name = f"psi{i}"
        definitions.append((name, total([last, Call("atan2", (Y, Symbol(f"x{i}")))])))
        last = Symbol(name)
    values = {"y": 1e-12} | {f"x{i}": 1e-10 * (i + 1) for i in range(40)}
    wanted = Call("sin", (last,))
    assert carried(definitions, wanted, values) == pytest.approx(
        plainly(definitions, wanted, values), rel=1e-13
    )
    written, _ = in_unit_vectors(definitions, [wanted], (), {*values})
    assert max(len(text(f)) for _, f in written) < 300


def test_a_sum_of_many_angles_is_turned_by_as_an_angle():
    definitions = [(f"mu{i}", Call("atan2", (Y, Symbol(f"x{i}")))) for i in range(12)]
    wanted = Call("cos", (total(Symbol(f"mu{i}") for i in range(12)),))
    _, (output,) = in_unit_vectors(definitions, [wanted], (), {"y"})
    assert output == wanted
