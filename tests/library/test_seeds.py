"""The printed formulas and numbers of the papers that mechc began with, and their misprints.

``seeds/values.json`` holds each formula as an arithmetic expression with reference
points computed to 30 digits; every one of them must come out of the mechanism.
"""

import ast
import json
import math
from functools import cache
from typing import Any

import pytest
import sympy

import mechc
from mechc.api import SolvedMechanism
from mechc.formula.to_text import text
from paths import LIBRARY, SEEDS

ENTRIES = {entry["id"]: entry for entry in json.loads((SEEDS / "values.json").read_text("utf-8"))}

RESULTS = {
    "S000-E2": ("karpenko_fig4_lifting_tongs", "F"),
    "S000-T1R1-k": ("karpenko_fig1_parallel_levers", "k"),
    "S000-T1R1-VB": ("karpenko_fig1_parallel_levers", "i_B"),
    "S000-T1R1-VA": ("karpenko_fig1_parallel_levers", "i_A"),
    "S000-T1R2-k": ("karpenko_fig2_scissor_tongs", "k"),
    "S000-T1R2-VB": ("karpenko_fig2_scissor_tongs", "i_B"),
    "S000-T1R2-VA": ("karpenko_fig2_scissor_tongs", "i_A"),
    "S000-T1R3-k": ("karpenko_fig3_inclined_levers", "k"),
    "S000-T1R3-VB": ("karpenko_fig3_inclined_levers", "i_B"),
    "S000-T1R3-VA": ("karpenko_fig3_inclined_levers", "i_A"),
    "S000-z": ("karpenko_fig3_inclined_levers", "z"),
    "S000-T1R4-k": ("karpenko_fig4_lifting_tongs", "k"),
    "S000-T1R4-VB": ("karpenko_fig4_lifting_tongs", "i_B"),
    "S000-T1R4-VA": ("karpenko_fig4_lifting_tongs", "i_A"),
    "S000-X5-k": ("karpenko_fig7_single_lever", "k"),
    "S000-X5-F": ("karpenko_fig7_single_lever", "F_clamp"),
    "S000-X6-k": ("karpenko_fig8_two_levers", "k"),
    "S000-X6-P": ("karpenko_fig8_two_levers", "P_min"),
    "S000-X7-k": ("karpenko_fig9_packet_clamp", "k"),
    "S000-X7-k-alt": ("karpenko_fig9_packet_clamp", "k"),
    "S000-X7-p": ("karpenko_fig9_packet_clamp", "p"),
    "S000-delta": ("karpenko_fig9_packet_clamp", "delta"),
}
"""Which result of which mechanism each printed formula is."""

FORCES = {
    "S004-ideal1": ("fedoriv_fig1_hinged_lever", "i", "Q"),
    "S004-ideal2": ("fedoriv_fig2a_knee", "i", "Q"),
    "S004-ideal3": ("fedoriv_fig2c_double_knee", "i", "Q"),
    "S002-49-P": ("tongs_fig4_9", "k", "N"),
}
"""Printed forces: the ratio of the mechanism times the given force."""

PRINTED = {
    "karpenko_fig1_parallel_levers": "2*b*cot(alpha)/a",
    "karpenko_fig2_scissor_tongs": "b*cot(alpha)/a",
    "karpenko_fig3_inclined_levers": "2*b*cos(alpha)*sin(theta)/(a*cos(alpha + theta))",
    "karpenko_fig4_lifting_tongs": "b*cos(alpha)/(a*cos(theta))",
    "karpenko_fig7_single_lever": "b*tan(alpha)/a",
    "karpenko_fig8_two_levers": "2*b*tan(alpha)/a",
    "karpenko_fig9_packet_clamp": "a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))",
    "fedoriv_fig1_hinged_lever": "tan(alpha)",
    "fedoriv_fig2a_knee": "2*tan(alpha)",
    "fedoriv_fig2c_double_knee": "tan(alpha)",
    "tongs_fig4_9": "2*h1*cos(gamma_1)/h2",
}
"""k as the page prints it."""

NAMES = {"g1": "gamma_1"}
"""Parameters that the library spells out."""


@cache
def mechanism(name: str) -> SolvedMechanism:
    return mechc.load(name)


# ------------------------------------------- the seeds' expressions, read without eval


FUNCTIONS = {"sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "sqrt": sympy.sqrt}
OPERATORS: dict[type[ast.operator], Any] = {
    ast.Add: lambda x, y: x + y,
    ast.Sub: lambda x, y: x - y,
    ast.Mult: lambda x, y: x * y,
    ast.Div: lambda x, y: x / y,
    ast.Pow: lambda x, y: x**y,
}


def expression(formula: str) -> sympy.Expr:
    """Return a seed's arithmetic as sympy, node by node."""
    return convert(ast.parse(formula, mode="eval").body)


def convert(node: ast.expr) -> sympy.Expr:
    match node:
        case ast.Constant(value):
            return sympy.Rational(repr(value))
        case ast.Name("pi"):
            return sympy.pi
        case ast.Name(name):
            return sympy.Symbol(NAMES.get(name, name))
        case ast.BinOp(left, operator, right):
            return OPERATORS[type(operator)](convert(left), convert(right))
        case ast.Call(ast.Name(function), [argument]):
            return FUNCTIONS[function](convert(argument))
    raise AssertionError(f"unexpected in a seed: {ast.dump(node)}")


def unfolded(name: str, result: str) -> sympy.Expr:
    """Return a result with the names it rests on put in."""
    found, inner = mechanism(name)[result], mechanism(name).where
    while named := found.free_symbols & {sympy.Symbol(n) for n in inner}:
        found = found.xreplace({s: inner[s.name] for s in named})
    return found


def vanishes(difference: sympy.Expr) -> bool:
    """Prove an identity: in half-angle tangents it is one of rational functions."""
    rational = sympy.expand_trig(difference).replace(
        lambda node: isinstance(node, sympy.sin | sympy.cos | sympy.tan | sympy.cot), in_half_angles
    )
    return bool(sympy.cancel(rational) == 0)


def in_half_angles(node: sympy.Expr) -> sympy.Expr:
    t = sympy.Symbol(f"t_{node.args[0]}")
    sine, cosine = 2 * t / (1 + t**2), (1 - t**2) / (1 + t**2)
    values = {sympy.sin: sine, sympy.cos: cosine, sympy.tan: sine / cosine}
    return values.get(node.func, cosine / sine)


def points(seed: str) -> list[tuple[dict[str, float], float]]:
    return [
        ({NAMES.get(n, n): v for n, v in p["inputs"].items()}, float(p["value_30"]))
        for p in ENTRIES[seed]["points"]
    ]


# --------------------------------------------------------------------------- tests


@pytest.mark.parametrize(("name", "printed"), PRINTED.items())
def test_k_comes_out_as_printed(name: str, printed: str) -> None:
    assert text(mechanism(name).results["k"].formula) == printed


@pytest.mark.parametrize("seed", RESULTS)
def test_formula_is_the_printed_one(seed: str) -> None:
    name, result = RESULTS[seed]
    assert vanishes(unfolded(name, result) - expression(ENTRIES[seed]["formula"]))


@pytest.mark.parametrize("seed", [s for s in RESULTS if "identity" not in ENTRIES[s]["status"]])
def test_formula_is_no_longer_than_the_printed_one(seed: str) -> None:
    name, result = RESULTS[seed]
    printed = sympy.count_ops(expression(ENTRIES[seed]["formula"]))
    assert sympy.count_ops(mechanism(name)[result]) <= printed


@pytest.mark.parametrize("seed", RESULTS)
def test_emitted_python_gives_the_reference_values(seed: str) -> None:
    name, result = RESULTS[seed]
    function = python_of(name)[result]
    wanted = function.__code__.co_varnames[: function.__code__.co_argcount]
    for inputs, value in points(seed):
        found = function(*(inputs[n] for n in wanted))
        assert float(found) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize("seed", FORCES)
def test_forces_come_out_of_the_ratios(seed: str) -> None:
    name, result, force = FORCES[seed]
    product = mechanism(name)[result] * sympy.Symbol(force)
    assert vanishes(product - expression(ENTRIES[seed]["formula"]))
    function = python_of(name)[result]
    wanted = function.__code__.co_varnames[: function.__code__.co_argcount]
    for inputs, value in points(seed):
        found = function(*(inputs[n] for n in wanted)) * inputs[force]
        assert float(found) == pytest.approx(value, rel=1e-12)


@cache
def python_of(name: str) -> dict[str, Any]:
    space: dict[str, Any] = {"__name__": name}
    exec(compile(mechanism(name).emit("python"), name, "exec"), space)
    return space


def test_corrected_force_divides_by_the_efficiency() -> None:
    clamp = mechanism("karpenko_fig8_two_levers")
    assert clamp["P_real"] == sympy.Symbol("P_min") / sympy.Symbol("eta")


@pytest.mark.parametrize("seed", ["S000-F5", "S000-F6", "S000-F10", "S000-F11", "S000-F12"])
def test_curves_of_the_figures(seed: str) -> None:
    for inputs, value in points(seed):
        assert curve(seed, inputs) == pytest.approx(value, rel=1e-12, abs=1e-15)


def curve(seed: str, inputs: dict[str, float]) -> float:
    """Figs 5 and 6 keep alpha + theta = 80 deg; figs 10 to 12 have a = b."""
    if seed in {"S000-F5", "S000-F6"}:
        other = "theta" if "alpha" in inputs else "alpha"
        angles = {**inputs, other: math.radians(80) - next(iter(inputs.values()))}
        return float(python_of("karpenko_fig3_inclined_levers")["z"](**angles))
    return float(python_of("karpenko_fig9_packet_clamp")["k"](a=1.0, b=1.0, **inputs))


# ----------------------------------------------------------------------- misprints

MISPRINTS = {
    "E000-1, acceleration directed down": (
        "karpenko_fig4_lifting_tongs",
        "expect F = m*(g - w)/(2*f)*lam",
    ),
    "E000-2, speed ratio with tan alpha": (
        "karpenko_fig2_scissor_tongs",
        "expect i_A = 2*a/b*tan(alpha)",
    ),
    "E000-3, clamping force without cot alpha": (
        "karpenko_fig7_single_lever",
        "expect F_clamp = a/b*p*pi*d^2/4",
    ),
}


@pytest.mark.parametrize(("name", "claim"), MISPRINTS.values(), ids=list(MISPRINTS))
def test_misprint_is_refuted(name: str, claim: str) -> None:
    description = (LIBRARY / f"{name}.mech").read_text("utf-8")
    with pytest.raises(mechc.MechcError) as refused:
        mechc.loads(f"{description}\n{claim}\n")
    (diagnostic,) = refused.value.diagnostics
    assert diagnostic.name == "expectation-refuted"
    assert diagnostic.span is not None
    start = diagnostic.span.start
    assert description.count("\n") < f"{description}\n{claim}\n"[:start].count("\n")


def test_scheme_4_is_independent_of_equal_angles() -> None:
    """E000-4: the paper says so of 45 deg only; k = b/a for every alpha = theta."""
    k = mechanism("karpenko_fig4_lifting_tongs")["k"]
    alpha, theta, a, b = sympy.symbols("alpha theta a b")
    assert k.subs(theta, alpha) == b / a


def test_packet_clamp_angles_are_always_interchangeable() -> None:
    """E000-5: the paper asks for alpha + beta < 90 deg."""
    swaps = mechanism("karpenko_fig9_packet_clamp").results["k"].swaps
    assert ("alpha", "beta") in swaps
