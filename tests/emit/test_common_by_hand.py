"""What long functions have in common, in C and in Python: computed once, taken by each."""

from types import SimpleNamespace

import mechc
from mechc.emit.c import functions
from mechc.emit.c import pose as in_c
from mechc.emit.c.reserved import RESERVED as C_WORDS
from mechc.emit.names import TargetNames
from mechc.emit.python import pose as in_python
from mechc.emit.python.printer import RESERVED as PYTHON_WORDS
from mechc.formula.tree import Symbol, product, total
from mechc.routine.steps import Common, Input, Step
from mechc.units import NUMBER
from small_mechanisms import gripper

A, B, U, V = map(Symbol, "abuv")
SUM = Step("u", total([A, B]))
SQUARE = Step("v", product([(U, 2)]))
INPUTS = Input("a", NUMBER), Input("b", NUMBER)
FIRST = Common(0, INPUTS, (SUM,), ("u",))
SECOND = Common(1, INPUTS, (SQUARE,), ("u", "v"), FIRST)
ARGUMENTS = {"a": "a", "b": "b_"}
CALLED = {0: "common", 1: "common_2"}


def test_c_takes_what_is_common_from_an_array_in_the_order_of_its_outputs():
    found = in_c.taking(SECOND, CALLED, ARGUMENTS, TargetNames(C_WORDS))
    assert found.body == ["double taken[2];", "common_2(a, b_, taken);"]
    assert found.names == {"u": "taken[0]", "v": "taken[1]"}
    assert in_c.taking(None, CALLED, ARGUMENTS, TargetNames(C_WORDS)) == ([], {})


def test_c_fills_the_array_with_what_another_one_gave_among_that():
    first = in_c.common_context(FIRST, CALLED, ARGUMENTS, {})
    assert first.head == "static void common(double a, double b_, double *values)"
    assert first.body == ["const double u = a + b_;", "values[0] = u;"]
    second = in_c.common_context(SECOND, CALLED, ARGUMENTS, {})
    assert second.body == [
        "double taken[1];",
        "common(a, b_, taken);",
        "const double v = taken[0]*taken[0];",
        "values[0] = taken[0];",
        "values[1] = v;",
    ]


def test_python_takes_what_is_common_by_its_name():
    space = TargetNames(PYTHON_WORDS, {*ARGUMENTS.values()})
    found = in_python.body_after_common(FIRST, (SQUARE,), (V,), ARGUMENTS, space, {})
    assert [(line.name, line.code) for line in found.body] == [
        ("values", "_values_0(a, b_)"),
        ("v", 'values["u"]*values["u"]'),
    ]
    alone = in_python.body_after_common(
        None, (SUM,), (U,), ARGUMENTS, TargetNames(PYTHON_WORDS), {}
    )
    assert [(line.name, line.code) for line in alone.body] == [("u", "a + b_")]


def test_numbers_of_a_description_have_their_units_in_comments():
    """Lengths and angles of a drawing, in the SI, in the docstring and in the header."""
    drawn = mechc.loads(gripper(), "drawn.mech")
    for target in ("python", "c"):
        text = drawn.emit(target)
        assert "where len_OA = 0.0180277564 m\n" in text
        assert "where phi_KA = -0.896055385 rad\n" in text


def test_the_body_of_a_function_takes_what_is_common_before_its_own_steps():
    function = SimpleNamespace(own=(SQUARE,), guards=(), output=V, status=None)
    scope = SimpleNamespace(commons=CALLED, solvers={})
    space = TargetNames(C_WORDS, {*ARGUMENTS.values()})
    found = functions._taken(function, FIRST, ARGUMENTS, scope, space)
    assert found.body == [
        "double taken[1];",
        "common(a, b_, taken);",
        "const double v = taken[0]*taken[0];",
    ]
    assert found.output == "v"
