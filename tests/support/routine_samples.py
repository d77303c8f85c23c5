"""Mechanisms with results made by hand, for the routine and the code targets."""

from fractions import Fraction
from functools import cache
from typing import Literal

import good_mechanisms
from known import Known
from mechc.base.frozen import replace
from mechc.data_folders import data
from mechc.emit.target import Compiled
from mechc.formula.tree import (
    PI,
    Call,
    Formula,
    Power,
    Symbol,
    degrees,
    implicit,
    negative,
    number,
    product,
    quotient,
    total,
)
from mechc.formula.walk import substitute
from mechc.model.mechanism import (
    Absolute,
    Force,
    Interval,
    Let,
    LoadForm,
    LoadRatio,
    Mechanism,
    Parameter,
    Require,
    Speed,
    SpeedRatio,
    Torque,
)
from mechc.model.result import Definition
from mechc.report.kinds import StepRule
from mechc.report.steps import Derivation, DerivationStep, Equation, PowerTerm
from mechc.routine.from_results import program
from mechc.routine.steps import Routine
from mechc.source import Span
from mechc.statics.verdict import NO_MORE, Trial, Untried, Verdict
from mechc.study.analysis import Acted, Analysis, DeadCentre, Vanishing
from mechc.units import ANGLE, FORCE, LENGTH, NUMBER, Dimension
from systems import triad

HERE = Span(0, 0)

LIBRARY = sorted(p.stem for p in data("library").iterdir() if p.suffix in (".mech", ".yaml"))

Operator = Literal["<", "<=", ">", ">=", "=", "!="]


def s(name: str) -> Symbol:
    return Symbol(name)


def f(function: str, *arguments: Formula) -> Call:
    return Call(function, arguments)


def sin(x: Formula) -> Call:
    return f("sin", x)


def cos(x: Formula) -> Call:
    return f("cos", x)


def parameter(name: str, dimension: Dimension, value: Formula, unit: str = "") -> Parameter:
    ends = Interval(product([(value, 1), (number(Fraction(1, 2)), 1)]), value)
    return Parameter(name, dimension, HERE, value=value, range=ends, unit=unit)


def angle(name: str, size: int) -> Parameter:
    return parameter(name, ANGLE, degrees(size), "deg")


def length(name: str, millimetres: int) -> Parameter:
    return parameter(name, LENGTH, number(Fraction(millimetres, 1000)), "mm")


def force(name: str, tie: Formula | None = None) -> Force:
    return Force(name, "A", Absolute(degrees(0), HERE), HERE, tie=tie)


A, B, ALPHA, BETA = s("a"), s("b"), s("alpha"), s("beta")
CLAMP_K = quotient(
    product([(A, 1), (sin(total([ALPHA, BETA])), 1)]),
    product([(number(2), 1), (B, 1), (cos(ALPHA), 1), (cos(BETA), 1)]),
)


def clamp() -> tuple[Mechanism, tuple[Analysis, ...]]:
    mechanism = Mechanism(
        "packet_clamp",
        "Packet clamp",
        "Karpenko et al. 2023, fig. 9",
        HERE,
        (length("a", 100), length("b", 250), angle("alpha", 12), angle("beta", 7)),
        loads=(force("P"), force("F")),
        requires=(Require(total([ALPHA, BETA]), "<", degrees(90), HERE),),
    )
    result = Analysis(
        "k",
        LoadRatio("P", "F"),
        NUMBER,
        CLAMP_K,
        zeros=(
            Vanishing(
                sin(total([ALPHA, BETA])),
                ("beta", negative(ALPHA)),
                DeadCentre(Acted("K"), Acted("A")),
            ),
        ),
        poles=(Vanishing(cos(ALPHA), ("alpha", degrees(90)), DeadCentre(Acted("A"), Acted("K"))),),
        proportional={"a": 1, "b": -1},
        swaps=(("alpha", "beta"),),
        trends={"alpha": "rises", "beta": "rises"},
        derivatives={"a": product([(CLAMP_K, 1), (A, -1)])},
        default=0.067068,
    )
    return mechanism, (result,)


def chained() -> tuple[Mechanism, tuple[Analysis, ...]]:
    """Intermediates with shared parts, a load's linear form, lets that use both."""
    phi = s("phi")
    where = (
        Definition("theta", f("asin", product([(A, 1), (sin(phi), 1), (B, -1)]))),
        Definition("reach", total([product([(A, 1), (cos(phi), 1)]), f("cot", phi)])),
    )
    theta = s("theta")
    k = total(
        [
            product([(sin(total([phi, theta])), 1), (s("reach"), 2), (cos(theta), -1)]),
            product([(number(-3), 1), (f("tan", phi), 1), (cos(total([theta, phi])), 1)]),
        ]
    )
    gain = product([(f("sec", phi), 1), (A, 1), (B, -1)])
    mechanism = Mechanism(
        "chained",
        "",
        "",
        HERE,
        (
            length("a", 100),
            length("b", 250),
            angle("phi", 40),
            parameter("m", Dimension(mass=1), number(3), "kg"),
            Parameter("w", LENGTH, HERE, total([A, B]), dependent=True),
        ),
        loads=(force("P"), force("F"), Torque("M", "AB", HERE), force("Q", tie=s("m"))),
        lets=(Let("F", product([(s("m"), 1), (number(10), 1)]), FORCE, HERE),),
        requires=(Require(s("theta"), ">=", number(0), HERE), Require(s("m"), ">", A, HERE)),
    )
    form = total([product([(k, 1), (s("F"), 1)]), product([(gain, 1), (s("M"), 1), (A, -1)])])
    return mechanism, (
        Analysis("k", LoadRatio("P", "F"), NUMBER, k, where),
        Analysis("P", LoadForm("P"), FORCE, form, where, coefficients={"F": k, "M": gain}),
        Analysis("F", None, FORCE, mechanism.lets[0].value),
        Analysis("twice", None, FORCE, product([(number(2), 1), (s("P"), 1), (s("w"), 1)])),
    )


def badly_named() -> tuple[Mechanism, tuple[Analysis, ...]]:
    names = ["lambda", "int", "I", "n", "i", "np", "β", "beta", "beta_2", "double", "l_A'", "k"]
    mechanism = Mechanism(
        "class",
        'A "title" with */ and /* and """ and \\',
        "line one\nline two ??/ \u202e */ int x; \\",
        HERE,
        tuple(length(name, 10 * i + 20) for i, name in enumerate(names)),
    )
    terms = [product([(number(i + 1), 1), (s(name), 1)]) for i, name in enumerate(names)]
    ratio = product([(sin(s("lambda")), 2), (s("β"), 1), (s("beta"), -1)])
    where = (Definition("sin_lambda", s("int")), Definition("NAN", total(terms)))
    return mechanism, (
        Analysis(
            "k", None, NUMBER, product([(s("NAN"), 1), (ratio, 1), (s("sin_lambda"), 1)]), where
        ),
        Analysis("k_n", None, NUMBER, total([s("I"), s("np")])),
        Analysis("int", None, NUMBER, total([s("β"), product([(number(2), 1), (s("beta"), 1)])])),
        Analysis("int_", None, NUMBER, product([(s("int"), 1), (s("double"), 1)])),
        Analysis("seven", None, NUMBER, number(7)),
    )


def whole_language() -> tuple[Mechanism, tuple[Analysis, ...]]:
    """Every function, every kind of number and of exponent."""
    x, y = s("x"), s("y")
    parts: dict[str, Formula] = {
        "trigonometric": total(
            [f(name, total([x, y])) for name in ("sin", "cos", "tan", "cot", "sec", "csc")]
        ),
        "inverse": total([f("asin", x), f("acos", y), f("atan", x), f("atan2", x, y)]),
        "other": total(
            [f("sqrt", x), f("hypot", x, y, number(2)), f("abs", negative(x)), f("log", y)]
        ),
        "chosen": total(
            [f("min", x, y, number(1)), f("max", y, x, product([(y, 1), (x, 1)])), f("exp", x)]
        ),
        "powers": total([Power(x, number(n)) for n in (2, 3, 5, 13, -1, -4)]),
        "roots": total([Power(x, number(Fraction(n, 2))) for n in (1, 3, -1, -5)]),
        "other_powers": total([Power(x, number(Fraction(3, 10))), Power(x, y)]),
        "numbers": total(
            [product([(number(Fraction(n)), 1), (x, 1)]) for n in ("1/3", "0.3", "-1/8", "-7/6")]
            + [number(Fraction(2, 3)), number(Fraction("0.1")), number(-5), degrees(40), PI]
        ),
        "nested": product(
            [(total([x, negative(y)]), -2), (negative(x), 1), (total([x, number(1)]), -1), (y, 3)]
        ),
        "constant": f("sin", degrees(40)),
    }
    mechanism = Mechanism(
        "language",
        "Every function",
        "",
        HERE,
        (
            parameter("x", NUMBER, number(Fraction(3, 4))),
            parameter("y", NUMBER, number(Fraction(1, 2))),
        ),
    )
    return mechanism, tuple(Analysis(n, None, NUMBER, formula) for n, formula in parts.items())


def chain_of(stages: int) -> tuple[Mechanism, tuple[Analysis, ...]]:
    """Each stage's intermediate depends twice on the one before: a tree would be 2^n long."""
    where = [Definition("v0", sin(ALPHA))]
    for i in range(1, stages):
        last = s(f"v{i - 1}")
        step = total(
            [product([(last, 1), (cos(ALPHA), 1)]), product([(cos(last), 1), (sin(BETA), 1)])]
        )
        where.append(Definition(f"v{i}", step))
    mechanism = Mechanism("chain", "", "", HERE, (angle("alpha", 30), angle("beta", 20)))
    ratio = SpeedRatio(Speed("point", "D"), Speed("link", "OA"))
    return mechanism, (Analysis("u", ratio, NUMBER, s(f"v{stages - 1}"), tuple(where)),)


def triple() -> tuple[Mechanism, tuple[Analysis, ...]]:
    """A ternary link on three rods: four unknowns of one system, two of them in k."""
    made = triad()
    system = made.system()
    parameters = [
        parameter(name, ANGLE if name in ("phi", "epsilon") else LENGTH, number(Fraction(value)))
        for name, value in made.values.items()
    ]
    turned = replace(
        parameters[0], range=Interval(*(number(Fraction(made.values["phi"]) + t) for t in (-1, 1)))
    )
    fixed = [replace(p, range=None) for p in parameters[1:]]
    mechanism = Mechanism("triple", "", "", HERE, (turned, *fixed), loads=(force("P"), force("F")))
    where = tuple(Definition(n, implicit(system, i)) for i, n in enumerate(system.unknowns))
    k = product([(sin(total([s("beta"), negative(s("gamma"))])), 1), (cos(s("theta")), -1)])
    back = (Definition("epsilon_2", product([(number(2), 1), (s("epsilon"), 1)])),)
    inner = substitute(
        implicit(system, 3), {"epsilon": product([(s("epsilon_2"), 1), (number(2), -1)])}
    )
    return mechanism, (
        Analysis("k", LoadRatio("P", "F"), NUMBER, k, where[:3]),
        Analysis("delta", None, ANGLE, total([inner, s("phi")]), back),
    )


SAMPLES = {
    "triple": triple,
    "clamp": clamp,
    "chained": chained,
    "badly_named": badly_named,
    "whole_language": whole_language,
    "chain": lambda: chain_of(64),
}


def compiled(sample: str) -> Compiled:
    """Return a sample as it comes to a target, with a derivation and a verdict."""
    mechanism, results = SAMPLES[sample]()
    relation = Equation(s("V_B"), product([(s("V_D"), 1), (A, 1), (B, -1)]))
    derivation = Derivation(
        (DerivationStep(StepRule.LEVER, ("O", "B", "D"), (relation,), (relation,)),),
        (PowerTerm("P", "A", number(1), s("V_A")),),
        (Equation(product([(s("P"), 1), (s("V_A"), 1)]), s("F")),),
        results,
    )
    trial = Trial("k", {"a": 0.1}, 0.5, float("inf"), 1e-16, 3.0)
    posed = {d.name: d.formula for r in results for d in r.where}
    routine = program(mechanism, results, posed)
    return Known(
        mechanism, derivation, routine, Verdict((trial,), (Untried("k", 1, 4, NO_MORE),)), "0.0.0"
    )


@cache
def solved(name: str) -> Compiled:
    """Return a sample, or a mechanism of the library, as it comes to a target."""
    if name in SAMPLES:
        return compiled(name)
    return good_mechanisms.compiled(name)


def guarded_by(operators: tuple[Operator, ...]) -> Compiled:
    """One function of x and y for each operator, which gives a value only where x OP y."""
    parameters = (parameter("x", NUMBER, number(1)), parameter("y", NUMBER, number(1)))
    formula = total([cos(s("x")), product([(number(2), 1), (sin(s("y")), 1)])])
    functions = []
    for i, operator in enumerate(operators):
        require = Require(s("x"), operator, s("y"), HERE)
        mechanism = Mechanism("guarded", "", "", HERE, parameters, requires=(require,))
        functions += program(mechanism, (Analysis(f"f{i}", None, NUMBER, formula),)).functions
    routine = Routine("guarded", "", "", tuple(functions))
    return Known(mechanism, Derivation((), (), (), ()), routine, Verdict(()), "0.0.0")
