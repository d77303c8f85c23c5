"""What is printed means what was computed: formulas at random, printed and read back."""

import math
import re

from hypothesis import example, given

from formula_strategies import VALUES, formulas
from latex_reader import read
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Formula, Symbol, degrees, number, power, quotient
from mechc.report.latex.notation import notation
from mechc.report.latex.printer import latex
from mechc.report.text.character_sets import ASCII
from mechc.report.text.printer import print_formula
from report_samples import formula


def same(one: Formula, other: Formula) -> None:
    first, second = evaluate(one, VALUES), evaluate(other, VALUES)
    if math.isfinite(first) and abs(first) < 1e12:
        assert math.isclose(first, second, rel_tol=1e-6, abs_tol=1e-9)


@given(formulas)
def test_latex_reads_back_as_the_same_value(given_formula: Formula) -> None:
    same(given_formula, read(latex(given_formula, notation("en"))))


@example(power(degrees(3), number(-1)))
@example(quotient(Symbol("a"), degrees(3)))
@given(formulas)
def test_text_reads_back_as_the_same_value(given_formula: Formula) -> None:
    shown = re.sub(r"([0-9.]+(?:/[0-9]+)?) deg", r"deg(\1)", print_formula(given_formula, ASCII))
    same(given_formula, formula(shown.replace("^", "**")))
