"""Reads back the LaTeX of formulas, as a reader of the page would: a second opinion.

A function without parentheses takes the letters and numbers behind it, up to a sign,
a dot, a thin space, a fraction or the next function.
"""

import re
from fractions import Fraction

from mechc.formula.tree import Call, Formula, Symbol, degrees, negative, number, power, product
from mechc.formula.tree import total as sum_of

TOKEN = re.compile(r"\\operatorname\{\w+\}|\\mathrm\{\w+\}|\\[A-Za-z]+|\\,|[0-9.]+|[A-Za-z]|.")
FUNCTIONS = {"\\arcsin": "asin", "\\ln": "log"} | {
    f"\\{name}": name for name in ("sin", "cos", "tan", "cot", "exp")
}


class Reader:
    """A recursive reader over the tokens of one formula."""

    def __init__(self, tex: str) -> None:
        self.tokens = [t for t in TOKEN.findall(tex) if t not in {" ", "\\left", "\\right"}]
        self.at = 0

    @property
    def next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, expected: str = "") -> str:
        token = self.next
        assert not expected or token == expected, f"{token!r} for {expected!r}"
        self.at += 1
        return token

    def sum(self) -> Formula:
        terms = []
        while self.next not in {"", ")", "}", "|"}:
            minus = self.next in "+-" and self.take() == "-"
            term = self.row()
            terms.append(negative(term) if minus else term)
        return sum_of(terms)

    def row(self) -> Formula:
        factors = []
        while self.next not in {"", ")", "}", "+", "-"}:
            if self.next in {"\\cdot", "\\,"}:
                self.take()
            else:
                factors.append(self.raised(self.atom()))
        return product((f, 1) for f in factors)

    def bare(self) -> Formula:
        """Read the argument of a function that has no parentheses."""
        factors = []
        while re.fullmatch(r"[0-9.]+|[A-Za-z]|\\(alpha|beta|theta|pi)", self.next):
            factors.append(self.raised(self.atom()))
        return product((f, 1) for f in factors)

    def raised(self, base: Formula) -> Formula:
        if self.next != "^":
            return base
        self.take("^")
        if self.next == "\\circ":
            self.take()
            return product([(base, 1), (degrees(1), 1)])
        return power(base, self.group())

    def group(self) -> Formula:
        self.take("{")
        inner = self.sum()
        self.take("}")
        return inner

    def atom(self) -> Formula:
        token = self.take()
        if token in FUNCTIONS:
            return self.call(FUNCTIONS[token])
        if token == "\\frac":
            return product([(self.group(), 1), (self.group(), -1)])
        if token == "\\sqrt":
            return power(self.group(), number(Fraction(1, 2)))
        if token == "(":
            inner = self.sum()
            self.take(")")
            return inner
        if token[0].isdigit():
            return number(Fraction(token))
        return Symbol(token.lstrip("\\"))

    def call(self, function: str) -> Formula:
        exponent: Formula = number(1)
        if self.next == "^":
            self.take("^")
            exponent = self.group()
        if self.next == "(":
            self.take("(")
            argument = self.sum()
            self.take(")")
        else:
            argument = self.bare()
        return power(Call(function, (argument,)), exponent)


def read(tex: str) -> Formula:
    """Return the formula that a page shows."""
    return Reader(tex).sum()
