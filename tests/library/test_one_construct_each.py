"""Mechanisms of one construct each, against formulas by hand and numbers by singular values."""

import math

import pytest

import reference_geometry
import reference_kinematics
from good_mechanisms import ALL, GOOD, compiled, tree_of
from mechc.routine.evaluate import evaluate
from mechc.syntax import ast

NAMES = [path.stem for path in GOOD]
LOADS = dict(zip("FGHMNPW", (1.3, 0.7, 2.1, 0.4, 1.1, 0.9, 3.0), strict=True))
"""Sizes of the loads that linear forms are evaluated with."""

REMARKED = {
    "closed_by_definition": {"W581"},
    "trammel_with_point": {"W581"},
    "second_parallel_bar": {"W401"},
}
"""Warnings that a mechanism is there for."""

every_mechanism = pytest.mark.parametrize("name", NAMES)


def test_names_differ_from_those_of_the_library():
    assert len(ALL) >= 75
    assert all(path.stem == name for name, path in ALL.items())
    assert {ALL[name] for name in NAMES} == set(GOOD)


@every_mechanism
def test_expectations_hold(name):
    expected = reference_geometry.every(tree_of(name), ast.Expect)
    findings = compiled(name).findings
    assert len(findings) == len(expected)
    assert {f.outcome for f in findings} <= {"proved", "agrees"}


@every_mechanism
def test_warnings(name):
    assert {d.code for d in compiled(name).report.diagnostics} == REMARKED.get(name, set())


@every_mechanism
def test_statics_agrees(name):
    assert compiled(name).verdict.agrees
    assert compiled(name).verdict.trials


def moved(name):
    """Return a pose near the default one; what depends on others follows."""
    values = {}
    for i, p in enumerate(compiled(name).mechanism.parameters):
        if not p.dependent and p.value is not None:
            default = reference_geometry.defaults(tree_of(name))[p.name]
            values[p.name] = default * (1 + 0.02 * math.sin(i + 1))
    return reference_geometry.defined(tree_of(name), values)


@every_mechanism
@pytest.mark.parametrize("pose", ["default", "nearby"])
def test_agrees_with_coordinates_and_singular_values(name, pose):
    tree = tree_of(name)
    values = reference_geometry.defaults(tree) if pose == "default" else moved(name)
    functions = compiled(name).routine.functions
    needed = {i.name for f in functions for i in f.inputs}
    values = {**{n: v for n, v in LOADS.items() if n not in values}, **values}
    if not needed <= values.keys():
        pytest.skip("parameters without values")
    expected = reference_kinematics.results(tree, values)
    for function in functions:
        found = float(evaluate(function, {i.name: values[i.name] for i in function.inputs}))
        wanted = expected.get(function.name)
        if wanted is None:
            wanted = expected[function.name.replace("_over_", "/")]
        assert found == pytest.approx(wanted, rel=1e-9, abs=1e-12)
