"""Compiled mechanisms built by hand from the frozen types, for the report's tests."""

import ast
from fractions import Fraction

from known import Known
from mechc.emit.target import Compiled
from mechc.formula.tree import (
    PI,
    Call,
    Formula,
    Symbol,
    degrees,
    negative,
    number,
    power,
    product,
    total,
)
from mechc.model.mechanism import (
    Absolute,
    AlongLine,
    Arrow,
    Copies,
    Force,
    Interval,
    Link,
    LoadForm,
    LoadRatio,
    Mechanism,
    Mirror,
    Offset,
    Parameter,
    Pivot,
    Require,
    Slider,
    Speed,
    SpeedRatio,
    Torque,
    Turn,
)
from mechc.model.result import Definition
from mechc.report.kinds import StepRule
from mechc.report.steps import Derivation, DerivationStep, Equation
from mechc.routine.steps import Routine
from mechc.source import Span
from mechc.statics.verdict import NO_MORE, Trial, Untried, Verdict
from mechc.study.analysis import Acted, Analysis, DeadCentre, Vanishing
from mechc.units import ANGLE, FORCE, LENGTH, NUMBER

HERE = Span(0, 0)


def formula(text: str) -> Formula:
    """Read a formula in Python's notation; ``deg(40)`` is a constant angle."""
    return _formula(ast.parse(text, mode="eval").body)


def _formula(node: ast.expr) -> Formula:
    match node:
        case ast.Constant(value=value):
            return number(Fraction(str(value)))
        case ast.Name(id="pi"):
            return PI
        case ast.Name(id=name):
            return Symbol(name)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return negative(_formula(operand))
        case ast.BinOp(left, operator, right):
            return _operation(_formula(left), operator, _formula(right))
        case ast.Call(func=ast.Name(id="deg"), args=[ast.Constant(value=value)]):
            return degrees(Fraction(str(value)))
        case ast.Call(func=ast.Name(id=function), args=arguments):
            return Call(function, tuple(map(_formula, arguments)))
        case _:
            raise AssertionError(ast.dump(node))


def _operation(left: Formula, operator: ast.operator, right: Formula) -> Formula:
    match operator:
        case ast.Add():
            return total([left, right])
        case ast.Sub():
            return total([left, negative(right)])
        case ast.Mult():
            return product([(left, 1), (right, 1)])
        case ast.Div():
            return product([(left, 1), (right, -1)])
        case _:
            return power(left, right)


def equations(*texts: str) -> tuple[Equation, ...]:
    """Read equations written with ``=``."""
    pairs = (text.split("=") for text in texts)
    return tuple(Equation(formula(a.strip()), formula(b.strip())) for a, b in pairs)


def along(text: str) -> Absolute:
    return Absolute(formula(text), HERE)


def length(name: str, millimetres: int, label: str = "") -> Parameter:
    value = number(Fraction(millimetres, 1000))
    return Parameter(name, LENGTH, HERE, value, None, "mm", label)


def angle(name: str, value: str, low: int, high: int, label: str = "") -> Parameter:
    span = Interval(degrees(low), degrees(high))
    return Parameter(name, ANGLE, HERE, degrees(Fraction(value)), span, "deg", label)


def compiled(mechanism: Mechanism, derivation: Derivation, verdict: Verdict) -> Compiled:
    routine = Routine(mechanism.name, mechanism.title, mechanism.source, ())
    return Known(mechanism, derivation, routine, verdict, "0.1")


def agreed(result: str, poses: int = 4) -> Verdict:
    trials = (Trial(result, {"a": float(i)}, 1.0, 1.0, 2e-16, 10.0) for i in range(poses))
    return Verdict(tuple(trials))


CLAMP_STEPS = (
    DerivationStep(
        StepRule.LEVER,
        ("O", "A", "B"),
        equations("V_A/V_B = b/a"),
        equations("V_A = V_B*b/a"),
    ),
    DerivationStep(
        StepRule.PROJECTION,
        ("B", "K"),
        equations("V_B*sin(alpha+beta) = V_K*cos(beta)"),
        equations("V_B = V_K*cos(beta)/sin(alpha+beta)"),
    ),
)

CLAMP_K = Analysis(
    "k",
    LoadRatio("P", "F"),
    NUMBER,
    formula("a*sin(alpha+beta)/(2*b*cos(alpha)*cos(beta))"),
    zeros=(
        Vanishing(
            formula("sin(alpha+beta)"),
            ("alpha", formula("-beta")),
            DeadCentre(Acted("K"), Acted("A")),
        ),
    ),
    poles=(Vanishing(formula("cos(alpha)"), ("alpha", formula("deg(90)")), "perpendicular load"),),
    proportional={"a": 1, "b": -1},
    swaps=(("alpha", "beta"),),
    trends={"a": "rises", "b": "falls", "alpha": "rises", "beta": "rises"},
    scopes={"a": "as given", "b": "as given", "alpha": "ranges", "beta": "ranges"},
    derivatives={
        "a": formula("sin(alpha+beta)/(2*b*cos(alpha)*cos(beta))"),
        "alpha": formula("a/(2*b*cos(alpha)**2)"),
    },
    default=0.0670,
)


def packet_clamp(title: str = "", source: str = "") -> Compiled:
    """The packet clamp of a profile-welding machine: a mirrored lever and rod."""
    mechanism = Mechanism(
        "packet_clamp",
        title or "Packet clamp of a profile-welding machine",
        source or "Karpenko, Muzyka, Shishkin 2023, fig. 9",
        HERE,
        parameters=(
            length("a", 100, "arm OB"),
            length("b", 250, "arm OA"),
            angle("alpha", "12", 2, 40),
            angle("beta", "7.5", 2, 40, "inclination of the rod BK"),
        ),
        joints=(Pivot("O", HERE), Slider("K", along("deg(90)"), HERE)),
        links=(Link("OBA", ("O", "B", "A"), HERE), Link("BK", ("B", "K"), HERE)),
        geometry=(
            Arrow("O", "B", formula("a"), along("alpha - deg(90)"), HERE),
            Arrow("O", "A", formula("b"), along("alpha - deg(90)"), HERE),
            Arrow("B", "K", None, along("-deg(90) - beta"), HERE),
        ),
        loads=(
            Force("P", "A", along("deg(180)"), HERE),
            Force("F", "K", along("deg(90)"), HERE),
        ),
        mirror=Mirror(along("deg(90)"), ("K",), HERE),
        requires=(
            Require(formula("0"), "<", formula("alpha + beta"), HERE),
            Require(formula("alpha + beta"), "<", formula("deg(90)"), HERE),
        ),
    )
    balance = equations("2*P*V_A*cos(alpha) - F*V_K = 0")
    derivation = Derivation(CLAMP_STEPS, (), balance, (CLAMP_K,), requires=mechanism.requires)
    return compiled(mechanism, derivation, agreed("k"))


LONG = "+".join(
    f"{i}*l_{i}*sin(alpha_{i}+beta)*cos(gamma-alpha_{i})/(l_{i}+r_{i})" for i in range(1, 13)
)
"""A sum of twelve terms, three lines wide."""


def six_bar() -> Compiled:
    """Not a real linkage: every kind of entry that a report can hold, some very long."""
    names = [f"l_{i}" for i in range(1, 13)] + [f"r_{i}" for i in range(1, 13)]
    mechanism = Mechanism(
        "six_bar",
        "",
        "",
        HERE,
        parameters=(
            *(length(n, 10 * i + 5) for i, n in enumerate(names)),
            Parameter("phi", ANGLE, HERE, degrees(30), None, "deg", "drive", "turned by hand"),
            Parameter("l_A", LENGTH, HERE, formula("2*l_1 + r_1"), dependent=True),
            Parameter("mu", NUMBER, HERE),
            Parameter("alpha1", ANGLE, HERE),
            Parameter("alpha_1", ANGLE, HERE),
        ),
        joints=(
            Pivot("O1", HERE),
            Pivot("O2", HERE),
            Slider("B'", AlongLine("O1", "A", 1, HERE), HERE),
        ),
        links=(
            Link("O1A", ("O1", "A"), HERE),
            Link("AB'", ("A", "B'"), HERE),
            Link("O2CD", ("O2", "C", "D"), HERE),
        ),
        geometry=(
            Offset("", "O1", formula("0"), formula("l_1"), HERE),
            Offset("O1", "O2", formula("l_2 + l_3"), formula("-l_4"), HERE),
            Turn("C", "O2", "D", formula("deg(40)"), HERE),
        ),
        loads=(
            Torque("M", "O1A", HERE, times=Fraction(1, 2)),
            Force("Q", "D", AlongLine("O2", "D", 3, HERE), HERE, formula("2*F")),
            Force("G", "C", along("deg(270)"), HERE, weight=True),
        ),
        copies=Copies(Fraction(3), ("O1",), HERE),
    )
    steps = (
        DerivationStep(
            StepRule.DYAD, ("A", "C", "O2"), equations("V_C = V_A*sin(phi)/cos(beta)"), ()
        ),
        DerivationStep(
            StepRule.TOGETHER, ("AB'", "O2CD"), equations(f"V_D = V_A*({LONG})/({LONG})"), ()
        ),
        DerivationStep(StepRule.ROTATION, ("O2CD",), equations("omega_O2CD = V_C/r_3"), ()),
    )
    results = (
        Analysis(
            "M",
            LoadForm("M"),
            FORCE,
            formula(f"F*({LONG})/({LONG}) + G*({LONG})"),
            where=(
                Definition("beta", formula("asin(l_A/l_2*sin(phi))")),
                Definition("gamma", formula("deg(180) - beta - phi")),
            ),
            coefficients={"F": formula(f"({LONG})/({LONG})"), "G": formula(LONG)},
            independent=("r_1", "mu"),
            default=float("nan"),
        ),
        Analysis(
            "V_D_over_V_A",
            SpeedRatio(Speed("point", "D"), Speed("point", "A")),
            NUMBER,
            formula("sin(beta)/sin(gamma)*" + "*".join(names)),
        ),
        Analysis("p", None, NUMBER, formula("4*M/(pi*l_1**2)*0.35*sqrt(mu**2+1)")),
    )
    derivation = Derivation(steps, (), equations("M*omega_O1A - Q*V_D = 0", "F*V_C = 0"), results)
    return compiled(mechanism, derivation, Verdict((), (Untried("k", 1, 4, NO_MORE),)))
