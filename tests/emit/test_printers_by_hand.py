"""Formulas and calls as lines of code, written down by hand."""

from fractions import Fraction

import pytest

from mechc.emit.c.printer import LONGEST_LINE, CPrinter, broken, harmless, wrapped
from mechc.emit.printer import Level
from mechc.emit.python.printer import PythonPrinter
from mechc.formula.tree import ZERO, Number, Symbol, number, product, quotient, total

THIRD = Fraction(1, 3)
A, B = Symbol("a"), Symbol("b")
NAMES = {"a": "a", "b": "b"}
PRINTERS = [CPrinter(NAMES), PythonPrinter(NAMES)]


@pytest.mark.parametrize("printer", PRINTERS, ids=["c", "python"])
@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (number(3), "3.0"),
        (ZERO, "0.0"),
        (number(Fraction(1, 4)), "0.25"),
        (number(THIRD), "1.0/3.0"),
        (total([A, number(-2)]), "a - 2.0"),
        (product([(A, 1), (total([A, B]), 1)]), "a*(a + b)"),
        (quotient(A, product([(A, 1), (B, 1)])), "a/(a*b)"),
        (quotient(A, total([A, B])), "a/(a + b)"),
    ],
)
def test_a_formula_is_a_line(printer, formula, expected):
    assert printer.print(formula) == expected


@pytest.mark.parametrize("printer", PRINTERS, ids=["c", "python"])
@pytest.mark.parametrize(
    ("value", "expected"),
    [(-2, "(-2.0)"), (2, "2.0"), (0, "0.0"), (Fraction(-1, 4), "(-0.25)"), (THIRD, "(1.0/3.0)")],
)
def test_a_number_that_is_a_factor_has_brackets_where_it_has_a_sign(printer, value, expected):
    assert printer.print(Number(Fraction(value)), Level.PRODUCT) == expected
    assert printer.print(Number(Fraction(value))) == expected.strip("()")


@pytest.mark.parametrize("indent", ["    ", "        "])
def test_a_call_is_broken_where_it_is_longer_than_a_line(indent):
    """The indentation beyond the first counts; a line may be just as long as the longest."""
    head = "double f("
    room = LONGEST_LINE - (len(indent) - 4) - len(head) - len("x, )")
    fits, beyond = ["x", "y" * room], ["x", "y" * (room + 1)]
    assert wrapped(head, fits, indent) == f"{head}x, {'y' * room})"
    assert wrapped(head, beyond, indent) == f"{head}\n{indent}x,\n{indent}{'y' * (room + 1)})"


def test_a_condition_is_broken_at_its_signs():
    parts = ["a" * 40, "b" * (LONGEST_LINE - 14 - 40 - 4)]
    assert broken(" && ", parts) == " && ".join(parts)
    parts[0] += "a"
    assert broken(" && ", parts) == f"{parts[0]}\n        && {parts[1]}"


def test_a_comment_does_not_end_before_its_end():
    assert harmless("a */ b /* c ??/") == "a * / b / * c ? ?/"
    assert harmless("a\\") == "a\\ ."
