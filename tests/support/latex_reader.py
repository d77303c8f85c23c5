"""Reads back the LaTeX of formulas, as a reader of the page would: a second opinion.

A function without parentheses takes the letters and numbers behind it, up to a sign,
a dot, a thin space, a fraction or the next function. A solidus divides by the one factor behind it.
"""

import re
from collections.abc import Collection
from fractions import Fraction

from mechc.formula.tree import PI, Call, Formula, Symbol, degrees, negative, number, power, product
from mechc.formula.tree import total as sum_of

TOKEN = (
    r"\\left\||\\right\||\\operatorname\{\w+\}|\\mathrm\{\w+\}|\\[A-Za-z]+|\\,|[0-9.]+|[A-Za-z]|."
)
FUNCTIONS = {
    "\\arcsin": "asin",
    "\\arccos": "acos",
    "\\arctan": "atan",
    "\\ln": "log",
    "\\operatorname{atan2}": "atan2",
    "\\operatorname{sgn}": "sign",
} | {f"\\{name}": name for name in ("sin", "cos", "tan", "cot", "sec", "csc", "min", "max")}


class Reader:
    """A recursive reader over the tokens of one formula; ``names`` are read as they stand."""

    def __init__(self, tex: str, names: Collection[str] = ()) -> None:
        known = "".join(
            re.escape(n) + (r"(?![A-Za-z])|" if re.search(r"\\[A-Za-z]+$", n) else "|")
            for n in sorted(names, key=len, reverse=True)
        )
        found = re.findall(known + TOKEN, tex.replace("\n", " "))
        self.tokens = [t for t in found if t not in {" ", "\\left", "\\right", "&", "\\quad"}]
        self.names = names
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
        while self.next not in {"", ")", "}", ",", "\\right|"}:
            minus = self.next in "+-" and self.take() == "-"
            term = self.row()
            terms.append(negative(term) if minus else term)
        return sum_of(terms)

    def row(self) -> Formula:
        factors = []
        while self.next not in {"", ")", "}", ",", "+", "-", "\\right|"}:
            if self.next in {"\\cdot", "\\,"}:
                self.take()
            elif self.next == "/":
                self.take()
                factors.append((self.raised(self.atom()), -1))
            else:
                factors.append((self.raised(self.atom()), 1))
        return product(factors)

    def bare(self) -> Formula:
        """Read the argument of a function that has no parentheses."""
        factors = []
        while self.next in self.names or re.fullmatch(
            r"[0-9.]+|[A-Za-z]|\\(alpha|beta|theta|pi)", self.next
        ):
            factors.append(self.raised(self.atom()))
            if self.next == "\\," and self.tokens[self.at + 1].startswith("\\mathrm"):
                self.take()  # a number before a word, as in sin 2 al
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
        if token in self.names:
            return Symbol(token)
        if token == "\\left|":
            inner = self.sum()
            self.take("\\right|")
            return Call("abs", (inner,))
        if token == "\\pi":
            return PI
        if token == "{":
            inner = self.sum()
            self.take("}")
            return inner
        if token == "\\mathrm{e}":
            self.take("^")
            return Call("exp", (self.group(),))
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
            arguments = [self.sum()]
            while self.next == ",":
                self.take(",")
                arguments.append(self.sum())
            self.take(")")
        else:
            arguments = [self.bare()]
        if function == "sign":  # on paper the sine of 180° is zero
            return power(Call("sense", (*arguments, number(1))), exponent)
        return power(Call(function, tuple(arguments)), exponent)


def read(tex: str, names: Collection[str] = ()) -> Formula:
    """Return the formula that a page shows, a symbol for each of the names spelled as there."""
    reader = Reader(tex, names)
    found = reader.sum()
    assert not reader.next, f"{reader.next!r} is left of {tex}"
    return found
