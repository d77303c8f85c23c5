"""The library's front."""

import numpy as np
import pytest
import sympy

import mechc
from paths import EXAMPLES

CLAMP = EXAMPLES / "clamp.mech"
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
    with pytest.raises(LookupError, match="'fortran'; there are latex, python, c, json"):
        clamp.emit("fortran")
    with pytest.raises(TypeError, match="no option 'lang'; there are stem, fragment, language"):
        clamp.emit("latex", lang="uk")
    with pytest.raises(TypeError, match="'gamma' is no parameter; there are a, b"):
        clamp.figure(gamma=0.1)
    with pytest.raises(TypeError, match="'gamma'; they depend on a, alpha, b, beta"):
        clamp.evaluate(gamma=0.1)


def test_emit_gives_what_the_command_line_gives(clamp: mechc.SolvedMechanism) -> None:
    assert "def k(" in clamp.emit("python")
    assert [f.name for f in clamp.emit_files("c")] == ["packet_clamp.c", "packet_clamp.h"]
    assert "\\documentclass" not in clamp.emit("latex", fragment=True)


def test_repr_is_one_line(clamp: mechc.SolvedMechanism) -> None:
    assert repr(clamp) == "<packet_clamp: k>"
    assert repr(clamp.results["k"]).startswith("<k = a*sin(alpha + beta)/(2*b*")
    assert repr(clamp.derivation) == "<derivation of packet_clamp: 2 steps>"
    assert repr(mechc.load("crank_rocker").stroke(3)) == "<stroke over phi: k, i; 3 rows>"


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


WITH_GIVEN_LOADS = """
mechanism lever
param a = 1 m
param b = 2*a
param m = 3 kg
pivot O
link AOB
OA = a @ 180 deg
OB = b @ 0 deg
force P at B along -y
force F at A along -y
weight W mass m at A
let F = 400 N
find P
find R_O
let q = P/a
"""


def test_values_go_before_the_loads_of_the_description() -> None:
    lever = mechc.loads(WITH_GIVEN_LOADS)
    weight = 3 * 9.80665
    assert lever.evaluate()["P"] == pytest.approx((400 + weight) / 2)
    found = lever.evaluate(F=np.array([100.0, 500.0]), a=2)
    np.testing.assert_allclose(found["P"], [(100 + weight) / 2, (500 + weight) / 2])
    np.testing.assert_allclose(found["q"], found["P"] / 2)
    np.testing.assert_allclose(found["R_O_y"], 3 * found["P"])
    assert list(found["F"]) == [100.0, 500.0]
    assert list(found) == list(lever.evaluate())
    assert lever.evaluate(F=100, W=0)["P"] == 50
    assert lever.evaluate()["F"] == 400


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("b", r"'b' follows from the description: b = 2\*a; give a instead"),
        ("q", r"'q' follows from the description: q = P/a; give a instead"),
        ("P", r"'P' follows from the description: P = \(F \+ W\)/2; give F, W instead"),
        ("f", r"no result depends on 'f'"),
    ],
)
def test_what_follows_from_others_cannot_be_given(name: str, said: str) -> None:
    with pytest.raises(TypeError, match=said):
        mechc.loads(WITH_GIVEN_LOADS).evaluate(**{name: 1.0})


def test_degrees_are_hardly_given_as_radians(clamp: mechc.SolvedMechanism) -> None:
    with pytest.warns(UserWarning, match=r"alpha = 20 is taken in radians, 3\.18 turns"):
        clamp.evaluate(alpha=20)
    with pytest.raises(TypeError, match="alpha is None"):
        clamp.evaluate(alpha=None)
    with pytest.raises(ValueError, match=r"'clamp\.mech' is a path, which mechc\.load reads"):
        mechc.loads("clamp.mech")


def test_values_may_be_texts_with_units(clamp: mechc.SolvedMechanism) -> None:
    assert clamp.evaluate(alpha="10 deg", a="0.5 in") == clamp.evaluate(
        alpha=np.radians(10), a=0.0127
    )
    both = clamp.evaluate(alpha=["5 deg", "10 deg"])["k"]
    np.testing.assert_array_equal(both, clamp.evaluate(alpha=np.radians([5, 10]))["k"])
    assert clamp.figure(a="0.1 m").points == clamp.figure(a=0.1).points


@pytest.mark.parametrize("text", ["10", "10 mm", "beta", "1/0 deg", "", "5 deg\nparam c = 2"])
def test_texts_that_are_no_such_quantity_are_refused(
    clamp: mechc.SolvedMechanism, text: str
) -> None:
    with pytest.raises(mechc.MechcError):
        clamp.evaluate(alpha=text)
