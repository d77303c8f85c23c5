"""The library's front."""

from pathlib import Path

import numpy as np
import pytest
import sympy

import mechc

CLAMP = Path(__file__).parents[1] / "examples" / "clamp.mech"
WRONG = "mechanism m\nparam l = 1 m\npivot O\nlink OA\nOA = l @ alhpa\nfind k = P/F\n"


@pytest.fixture(scope="module")
def clamp() -> mechc.SolvedMechanism:
    return mechc.load(CLAMP)


def test_k_is_a_sympy_expression(clamp: mechc.SolvedMechanism) -> None:
    a, b, alpha, beta = sympy.symbols("a b alpha beta")
    assert clamp.k == a * sympy.sin(alpha + beta) / (2 * b * sympy.cos(alpha) * sympy.cos(beta))
    assert clamp.k == clamp["k"]
    assert clamp.k.diff(a) * a == clamp.k


def test_evaluate_agrees_with_sympy(clamp: mechc.SolvedMechanism) -> None:
    alpha = np.linspace(0.1, 0.6, 7)
    found = clamp.evaluate(alpha=alpha, beta=0.3, a=0.12)["k"]
    given = {"a": 0.12, "b": 0.25, "beta": 0.3}
    at = {sympy.Symbol(name): value for name, value in given.items()}
    expected = [float(clamp.k.subs(at).subs(sympy.Symbol("alpha"), x)) for x in alpha]
    np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_evaluate_takes_the_rest_from_the_description(clamp: mechc.SolvedMechanism) -> None:
    assert clamp.evaluate()["k"] == clamp.evaluate(**clamp.defaults)["k"]
    assert isinstance(clamp.evaluate()["k"], float)


def test_unknown_names_are_refused_with_a_near_miss(clamp: mechc.SolvedMechanism) -> None:
    with pytest.raises(TypeError, match="did you mean 'alpha'"):
        clamp.evaluate(alhpa=0.1)
    with pytest.raises(KeyError, match="there are k"):
        clamp["eta"]
    with pytest.raises(LookupError):
        clamp.emit("fortran")


def test_emit_gives_what_the_command_line_gives(clamp: mechc.SolvedMechanism) -> None:
    assert "def k(" in clamp.emit("python")
    assert [f.name for f in clamp.emit_files("c")] == ["packet_clamp.c", "packet_clamp.h"]
    assert "\\documentclass" not in clamp.emit("latex", fragment=True)


def test_notebooks_get_latex(clamp: mechc.SolvedMechanism) -> None:
    assert clamp._repr_latex_().startswith(r"$\displaystyle \begin{aligned} k &= \frac{a ")
    assert repr(clamp) == "<packet_clamp: k>"


def test_derivation_is_data(clamp: mechc.SolvedMechanism) -> None:
    assert clamp.derivation.steps
    assert clamp.results["k"].name == "k"
    assert clamp.warnings == []


def test_error_carries_all_diagnostics() -> None:
    with pytest.raises(mechc.MechcError) as caught:
        mechc.loads(WRONG, "wrong.mech")
    error = caught.value
    assert len(error.diagnostics) >= 2
    assert error.source
    assert error.source.name == "wrong.mech"
    assert all(f"{d.code}: " in str(error) for d in error.diagnostics)


def test_unknown_file() -> None:
    with pytest.raises(mechc.MechcError, match="E901"):
        mechc.load("nowhere.mech")


def test_text_in_either_notation() -> None:
    assert mechc.loads(CLAMP.read_text()).k == mechc.load(CLAMP.with_suffix(".yaml")).k
