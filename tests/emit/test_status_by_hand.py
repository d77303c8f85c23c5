"""Conditions of a sheet, in C and in Python, that rest on what a system gives."""

from mechc.emit.c import status as in_c
from mechc.emit.python import status as in_python
from mechc.formula.tree import Symbol, number
from mechc.routine.steps import Checks, Guard, Input, Solve, Solver, Step
from mechc.units import NUMBER

A, B, X, Y, Z = map(Symbol, "abxyz")
SOLVER = Solver(("x", "y"), ("a",), (), (1.0, 1.0), (None,), 1, (), (X, Y), ((A, A), (A, A)))
CHECKS = Checks(
    (Input("a", NUMBER), Input("b", NUMBER)),
    (Solve(("x", "y"), (A,), SOLVER), Step("z", Y)),
    (Guard(Z, "<", B), Guard(A, ">=", number(2))),
)
ARGUMENTS = {"a": "a", "b": "double_"}


def test_c_names_what_is_used_of_a_solution_alone_and_numbers_its_conditions():
    made = in_c.checks_context(CHECKS, "holds", "holds_n", ARGUMENTS, {SOLVER: "solve_1"})
    head, solution, *rest = made.body
    assert (head, solution) == (
        "double solution[2];",
        "const int status_1 = solve_1(a, solution);",
    )
    assert rest[:2] == ["const double y = solution[1];", "const double z = y;"]
    assert rest[2].startswith("(void)status_1;")
    assert made.conditions == ["z < double_", "a >= 2.0"]
    assert made.call == "holds(a[i], double_[i])"


def test_python_names_what_is_used_of_a_solution_alone():
    made = in_python.checks_context(CHECKS, "status", ARGUMENTS, {SOLVER: "solve_1"})
    lines = [(line.name, line.code) for line in made.body]
    assert lines == [("_, (_, y)", "solve_1(a)"), ("z", "y")]
    assert made.conditions == ["z < double_", "a >= 2.0"]
    assert made.arguments == ["a", "double_"]
    said = [(line.name, line.code) for line in made.inputs]
    assert said == [("a", "number"), ("double_", "number; b in the formula")]
