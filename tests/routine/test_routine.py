"""The straight-line program: shared parts once, inputs and guards, linear growth."""

import math
from collections.abc import Iterable
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechc.base.frozen import replace
from mechc.emit.python.printer import PythonPrinter
from mechc.formula.evaluate import evaluate as value_of
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Formula, Power, Product, degrees, number, product, total
from mechc.formula.walk import walk
from mechc.model.mechanism import Mechanism, Require
from mechc.model.result import Definition, Result
from mechc.routine.evaluate import compute, evaluate
from mechc.routine.from_results import program
from mechc.routine.promises import broken_promises
from mechc.routine.sharing import share
from mechc.routine.steps import Function, Step
from mechc.units import NUMBER
from routine_samples import (
    LIBRARY,
    SAMPLES,
    chain_of,
    chained,
    clamp,
    cos,
    f,
    s,
    sin,
    solved,
    whole_language,
)


def functions(sample: tuple[Mechanism, tuple[Result, ...]]) -> dict[str, Function]:
    return {f.name: f for f in program(*sample).functions}


def written(steps: Iterable[Step]) -> list[str]:
    return [f"{step.name} = {text(step.formula)}" for step in steps]


def test_a_product_without_shared_parts_stays_as_written() -> None:
    k = functions(clamp())["k"]
    assert k.steps == ()
    assert text(k.output) == text(k.formula) == "a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))"
    assert k.operations == 9


def test_inputs_are_in_declared_order_with_default_and_range() -> None:
    k = functions(clamp())["k"]
    assert [i.name for i in k.inputs] == ["a", "b", "alpha", "beta"]
    assert (k.inputs[0].default, k.inputs[0].low, k.inputs[0].high) == (0.1, 0.05, 0.1)
    assert k.inputs[2].unit == "deg"


def test_loads_follow_parameters_and_lets_give_them_values() -> None:
    found = functions(chained())
    assert [i.name for i in found["k"].inputs] == ["a", "b", "phi"]
    assert [(i.name, i.unit) for i in found["P"].inputs[3:]] == [("m", "kg"), ("M", "N*m")]
    assert [i.name for i in found["F"].inputs] == ["m"]
    assert [w.name for w in found["twice"].where] == ["theta", "reach", "F", "P", "w"]


def test_shared_parts_become_steps_with_readable_names() -> None:
    k = functions(chained())["k"]
    assert written(k.steps) == [
        "sin_phi = sin(phi)",
        "p1 = a*sin_phi/b",
        "theta = asin(p1)",
        "cos_phi = cos(phi)",
        "reach = a*cos_phi + cos_phi/sin_phi",
        "t1 = sqrt((1 - p1)*(1 + p1))",
    ]
    assert text(k.output) == (
        "(sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi"
    )


def test_a_shared_sum_is_called_by_its_terms() -> None:
    angle = total([s("phi"), s("theta")])
    steps, _ = share([], [total([sin(angle), Call("cos", (angle,))])], [])
    assert written(steps) == ["phi_plus_theta = phi + theta"]


def test_an_input_above_and_below_is_cancelled_and_a_root_is_not() -> None:
    root = f("sqrt", s("x"))
    above, below = product([(s("a"), 1), (root, 1)]), product([(s("a"), -1), (root, -1)])
    _, (output,) = share([], [product([(above, 1), (below, 1)])], [])
    assert text(output) == "sqrt_x/sqrt_x"


def test_a_definition_names_what_equals_it() -> None:
    total_length = total([s("a"), s("b")])
    steps, (output,) = share([("whole", total_length)], [f("sqrt", total_length)], [])
    assert written(steps) == ["whole = a + b"]
    assert text(output) == "sqrt(whole)"


def test_new_names_avoid_those_in_use() -> None:
    twice = product([(sin(s("x")), 2)])
    steps, _ = share([], [twice], ["x", "sin_x"])
    assert [step.name for step in steps] == ["t1"]


def test_integer_powers_are_products() -> None:
    steps, (output,) = share([], [Power(s("x"), number(13))], ["x"])
    formulas = [*(step.formula for step in steps), output]
    assert not any(isinstance(part, Power) for formula in formulas for part in walk(formula))
    assert sum(map(count_operations, formulas)) <= 6


def test_one_tangent_stays_and_joins_a_sine_where_there_is_one() -> None:
    tangent = Call("tan", (s("x"),))
    assert text(share([], [tangent], []).formulas[0]) == "tan(x)"
    both = share([], [total([tangent, sin(s("x"))])], [])
    assert text(both.formulas[0]) == "sin_x/cos(x) + sin_x"


def test_two_results_may_use_one_name_for_different_things() -> None:
    mechanism, _ = clamp()
    first = Result("one", None, NUMBER, s("s1"), (Definition("s1", sin(s("alpha"))),))
    second = Result("two", None, NUMBER, s("s1"), (Definition("s1", cos(s("beta"))),))
    both = Result("both", None, NUMBER, total([s("one"), s("two")]))
    found = functions((mechanism, (first, second, both)))["both"]
    values = {"alpha": 0.3, "beta": 0.4}
    assert evaluate(found, values) == pytest.approx(math.sin(0.3) + math.cos(0.4))


def test_a_definition_by_itself_and_an_unknown_name_are_refused() -> None:
    mechanism, _ = clamp()
    circle = (Result("p", None, NUMBER, s("q")), Result("q", None, NUMBER, s("p")))
    with pytest.raises(LookupError, match="defined by itself"):
        program(mechanism, circle)
    with pytest.raises(LookupError, match="nothing explains zeta in result p"):
        program(mechanism, (Result("p", None, NUMBER, s("zeta")),))


def test_guards_give_nan_where_their_inputs_are_there() -> None:
    k = functions(clamp())["k"]
    values = {"a": 0.1, "b": 0.25, "alpha": np.array([0.2, 1.2]), "beta": 0.5}
    assert np.isnan(evaluate(k, values)).tolist() == [False, True]
    found = functions(chained())
    assert [text(g.left) for g in found["k"].guards] == ["theta"]
    assert [text(g.left) for g in found["P"].guards] == ["theta", "m"]


def test_a_guard_on_what_a_function_is_not_given_is_left_out() -> None:
    mechanism, results = clamp()
    other = Mechanism(
        "m", "", "", mechanism.span, mechanism.parameters,
        requires=(Require(s("alpha"), "<", s("beta"), mechanism.span),),
    )  # fmt: skip
    lone = Result("q", None, NUMBER, sin(s("alpha")))
    assert functions((other, (lone,)))["q"].guards == ()
    assert len(functions((other, results))["k"].guards) == 1


def test_scalars_give_floats_and_arrays_broadcast() -> None:
    k = functions(clamp())["k"]
    values = {"a": 0.1, "b": 0.25, "alpha": 0.2, "beta": 0.1}
    assert type(evaluate(k, values)) is float
    rows = evaluate(k, {**values, "alpha": np.ones((3, 1)) * 0.2, "beta": np.ones(2) * 0.1})
    assert np.shape(rows) == (3, 2)
    assert np.all(rows == evaluate(k, values))


@pytest.mark.parametrize("stages", [16, 64, 256])
def test_a_chain_has_linear_size(stages: int) -> None:
    (function,) = program(*chain_of(stages)).functions
    assert len(function.steps) == stages + 2
    assert function.operations <= 4 * stages


@pytest.mark.parametrize("name", [*SAMPLES, *LIBRARY])
def test_promises_are_kept(name: str) -> None:
    for function in solved(name).routine.functions:
        assert broken_promises(function) == []


def test_broken_promises_are_seen() -> None:
    k = functions(chained())["k"]
    shuffled = replace(k, steps=k.steps[::-1], output=total([k.output, sin(s("phi"))]))
    assert "p1 uses sin_phi too early" in broken_promises(shuffled)
    assert "sin(phi) is computed twice" in broken_promises(shuffled)
    assert broken_promises(replace(k, steps=())) != []


@pytest.mark.parametrize("name", [r.name for r in whole_language()[1]])
def test_the_interpreter_agrees_with_plain_evaluation(name: str) -> None:
    function = functions(whole_language())[name]
    values = {"x": 0.71, "y": 0.38}
    assert evaluate(function, values) == pytest.approx(
        value_of(function.formula, values), rel=1e-14
    )


_ATOMS = st.sampled_from([s("x"), s("y"), number(2), number(-3), degrees(30)])


def _larger(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    exponents = st.sampled_from([1, 2, 4, -1, -3])
    return st.one_of(
        st.lists(inner, min_size=1, max_size=4).map(total),
        st.lists(st.tuples(inner, exponents), min_size=1, max_size=4).map(product),
        st.tuples(st.sampled_from(["sin", "cos", "tan", "cot", "sec"]), inner).map(
            lambda pair: Call(pair[0], (pair[1],))
        ),
    )


@settings(max_examples=150, deadline=None)
@given(st.recursive(_ATOMS, _larger, max_leaves=25))
def test_sharing_changes_no_value(formula: Formula) -> None:
    values = {"x": 0.37, "y": 1.13}
    steps, (output,) = share([], [formula], ["x", "y"])
    scope = dict(values)
    for step in steps:
        scope[step.name] = value_of(step.formula, scope)
    expected, found = value_of(formula, values), value_of(output, scope)
    if not math.isnan(expected) and abs(expected) < 1e12:
        largest = max(abs(value_of(part, values)) for part in walk(formula))
        assume(largest < 1e9)  # of the sine of more than that no digit is right
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-9 * largest)


def test_the_pose_has_no_part_in_friction() -> None:
    pose = solved("claw_with_friction").routine.pose
    assert pose is not None
    assert pose.outputs == ("beta",)
    assert [item.name for item in pose.inputs] == ["l_A", "l", "phi"]


def test_a_product_within_a_product_is_computed_as_it_is_printed():
    """1/(300*(a*b)) was printed without the inner parentheses, and rounded otherwise."""
    inner = Power(Product((s("a"), s("b"))), number(-1))
    formula = Product((number(Fraction(1, 300)), inner))
    printed = PythonPrinter({"a": "a", "b": "b"}).print(formula)
    values = np.random.default_rng(0).uniform(0.1, 1, (100, 2))
    for a, b in values:
        assert compute(formula, {"a": a, "b": b}) == eval(printed, {"a": a, "b": b})
