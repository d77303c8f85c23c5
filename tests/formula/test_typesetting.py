"""What the terminal and LaTeX set alike: parentheses, fractions, signs, powers, degrees."""

from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import given

from formula_strategies import formulas
from mechc.formula.tree import Call, Formula, Implicit, Number, Power, Product, Sum, Symbol, System
from mechc.formula.typesetting import FormulaRow, Typesetter
from mechc.report.latex.notation import notation
from mechc.report.latex.printer import latex
from mechc.report.text.character_sets import ASCII, UNICODE
from mechc.report.text.printer import print_formula
from report_samples import formula

BOTH = {
    "a - (b - c)*d": ("a − d · (b − c)", "a-d(b-c)"),
    "(-2)*(a + b)*c": ("−2c · (a + b)", "-2c(a+b)"),
    "a*(-2)*b + c": ("−2ab + c", "-2ab+c"),
    "c - 3*a/4": ("c − 3a/4", r"c-\frac{3a}{4}"),
    "a + (-3/4)": ("a − 3/4", r"a-\frac{3}{4}"),
    "a**(-3/4)": ("1/a^(3/4)", r"\frac{1}{a^{\frac{3}{4}}}"),
    "(-3)**a": ("(−3)^a", "(-3)^{a}"),
    "(3/4)**a": ("(3/4)^a", r"\left(\frac{3}{4}\right)^{a}"),
    "(a + b)**2": ("(a + b)²", "(a+b)^{2}"),
    "(a*b)**c": ("(ab)^c", "(ab)^{c}"),
    "(a**b)**c": ("(a^b)^c", "(a^{b})^{c}"),
    "a**(b + c)": ("a^(b + c)", "a^{b+c}"),
    "a**(-1/2)": ("1/√(a)", r"\frac{1}{\sqrt{a}}"),
    "sin(alpha)**2": ("sin² α", r"\sin^{2}\alpha"),
    "sin(alpha)**a": ("(sin α)^a", r"(\sin\alpha)^{a}"),
    "sin(alpha)**(-1)": ("1 / sin α", r"\frac{1}{\sin\alpha}"),
    "abs(a)**3": ("|a|³", r"\left|a\right|^{3}"),
    "hypot(a, -b)": ("√(a² + b²)", r"\sqrt{a^{2}+b^{2}}"),
    "cos(deg(40) - alpha)": ("cos(40° − α)", r"\cos(40^\circ-\alpha)"),
    "cos(-alpha)": ("cos(−α)", r"\cos(-\alpha)"),
    "cos(0)**2": ("cos² 0°", r"\cos^{2}0^\circ"),
    "cos(pi/8)": ("cos 22.5°", r"\cos22.5^\circ"),
    "cos(pi/7)": ("cos(180/7°)", r"\cos\left(\frac{180^\circ}{7}\right)"),
    "0.3535*cos(alpha)*a/b": ("0.3535 · a/b · cos α", r"0.3535\,\frac{a}{b}\cos\alpha"),
    "0.3535/cos(alpha)": ("0.3535 · 1 / cos α", r"0.3535\,\frac{1}{\cos\alpha}"),
    "sin(alpha - pi/2)/a": ("sin(α − 90°) / a", r"\frac{\sin(\alpha-90^\circ)}{a}"),
    "2*b/a*cot(alpha)": ("2b/a · cot α", r"\frac{2b}{a}\cot\alpha"),
    "0.35*a*b": ("0.35 · ab", r"0.35\,ab"),
    "-0.35*a": ("−0.35 · a", r"-0.35\,a"),
    "a**(-0.35*b)": ("a^(−0.35 · b)", r"a^{-0.35\,b}"),
    "atan2(a, b + c)": ("atan2(a, b + c)", r"\operatorname{atan2}(a,b+c)"),
}


@pytest.mark.parametrize(("source", "expected"), BOTH.items())
def test_a_formula_on_a_line_and_as_a_textbook_sets_it(
    source: str, expected: tuple[str, str]
) -> None:
    read = formula(source)
    assert (print_formula(read, UNICODE), latex(read, notation("en"))) == expected


def test_ascii_puts_functions_in_parentheses_and_powers_behind_them() -> None:
    read = formula("sin(alpha)**2*abs(a)/sqrt(b)")
    assert print_formula(read, ASCII) == "sin(alpha)^2 * abs(a) / sqrt(b)"


def test_a_solution_of_a_system_is_in_parentheses() -> None:
    x, a = Symbol("x"), Symbol("a")
    system = System(("x",), (Sum((x, a)),), (("a", 1.0),), (-1.0,))
    assert print_formula(Implicit(system, 0, (a,)), UNICODE) == "(x: x + a = 0)"
    assert latex(Implicit(system, 0, (a,)), notation("en")) == r"(x:\;x+a=0)"


# --------------------------------------------------- the walk, in a plain notation


class Tokens(Typesetter[str]):
    """Sets a formula so that every decision of the walk can be seen."""

    angles = frozenset({"alpha"})

    def __init__(self, built: bool, raised: bool) -> None:
        self.built, self.raised = built, raised

    def numeral(self, figures: str) -> str:
        return figures

    def ratio(self, value: Fraction) -> str:
        return str(value)

    def degrees(self, number: str) -> str:
        return f"{number}deg"

    def pi(self) -> str:
        return "pi"

    def name(self, name: str) -> str:
        return name

    def parentheses(self, inner: str) -> str:
        return f"({inner})"

    def minus(self, piece: str) -> str:
        return f"-{piece}"

    def joined(self, term: str) -> str:
        return term if term.startswith("-") else f"+{term}"

    def row(self, pieces: Sequence[str]) -> str:
        return "".join(pieces)

    def factors(self, formulas: FormulaRow, pieces: Sequence[str]) -> str:
        return "*".join(pieces)

    def joined_by(self, sign: str, pieces: Sequence[str]) -> str:
        return sign.join(pieces)

    def cases(self, rows: Sequence[tuple[str, str]], other: str | None) -> str:
        return "; ".join((*(f"{value} if {condition}" for value, condition in rows), other or ""))

    def over(self, above: str, below: str, several: bool) -> str:
        return f"[{above}|{below}]"

    def beside(self, first: str, second: str) -> str:
        return f"{first}.{second}"

    def scaled(self, lead: str, rest: str) -> str:
        return f"{lead}x{rest}"

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^{exponent}"

    def holds(self, call: str) -> bool:
        return False

    def root(self, inner: str) -> str:
        return f"root[{inner}]"

    def absolute(self, inner: str) -> str:
        return f"|{inner}|"

    def applied(self, function: str, exponent: str, argument: Formula, inner: str) -> str:
        return f"{function}{exponent}[{inner}]"

    def called(self, function: str, arguments: Sequence[str]) -> str:
        return f"{function}[{','.join(arguments)}]"

    def solution(self, unknown: str, zeros: Sequence[str]) -> str:
        return f"{unknown}:{','.join(zeros)}"


WALKED = {
    "(a + b)/c": ("[a+b|c]", "[(a+b)|c]"),
    "1/(a + b)": ("[1|a+b]", "[1|(a+b)]"),
    "a*(3/4)**b": ("a*(3/4)^b", "a*(3/4)^b"),
    "a**(3/4)": ("a^3/4", "a^(3/4)"),
    "a**(b + c)": ("a^b+c", "a^(b+c)"),
    "alpha - pi/4": ("alpha-45deg", "alpha-45deg"),
    "a - pi/4": ("a-[pi|4]", "a-[pi|4]"),
    "b/a*sin(alpha)": ("[b|a].sin[alpha]", "[b|a].sin[alpha]"),
    "7/5*a/b": ("1.4x[a|b]", "1.4x[a|b]"),
    "sqrt(pi/2 + alpha)": ("root[[pi|2]+alpha]", "root[[pi|2]+alpha]"),
    "abs(pi/2 + alpha)": ("|90deg+alpha|", "|90deg+alpha|"),
}
"""With lines of fractions and small exponents, and without."""


@pytest.mark.parametrize(("source", "expected"), WALKED.items())
def test_what_is_built_needs_fewer_parentheses(source: str, expected: tuple[str, str]) -> None:
    read = formula(source)
    assert tuple(Tokens(built, False).whole(read) for built in (True, False)) == expected


def test_powers_of_functions_are_raised_where_that_is_usual() -> None:
    squared = formula("cos(alpha)**2")
    assert Tokens(True, True).whole(squared) == "cos2[alpha]"
    assert Tokens(True, False).whole(squared) == "(cos[alpha])^2"
    half = Power(Call("cos", (Symbol("alpha"),)), Number(Fraction(3, 2)))
    assert Tokens(True, True).whole(half) == "(cos[alpha])^3/2"


def test_the_first_term_of_a_sum_has_no_plus() -> None:
    setter = Tokens(True, True)
    a, b = Symbol("a"), Product((Number(Fraction(-1)), Symbol("b")))
    assert [setter.term(t, first) for t in (a, b) for first in (True, False)] == [
        "a",
        "+a",
        "-b",
        "-b",
    ]


@given(formulas)
def test_parentheses_are_closed_and_signs_never_meet(given_formula: Formula) -> None:
    for built in (True, False):
        shown = Tokens(built, False).whole(given_formula)
        assert shown.count("(") == shown.count(")")
        assert not any(pair in shown for pair in ("--", "+-", "*-", "-+", "x-", ".-"))
