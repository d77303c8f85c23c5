"""What a formula is rewritten as for readers has its value, whatever order its terms are in."""

import pytest
from hypothesis import given

from formula_strategies import VALUES, formulas
from mechc.formula.differences import differences_as_in, with_positive_sines
from mechc.formula.evaluate import evaluate
from mechc.formula.layout import in_degrees, over_line
from mechc.formula.rewriting import plus_first
from mechc.formula.tree import Sum
from mechc.report.book_forms import book_form
from mechc.report.sentences.order import geometry_first

TURNS = {19: -90, 40: 90, -90: 90}


def quarter(angle):
    """Turn what holds one of some constants: the rest is as it is known."""
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    return next((TURNS[size] for term in terms if (size := in_degrees(term)) in TURNS), 0)


REWRITINGS = {
    "with_positive_sines": lambda formula: with_positive_sines(formula, lambda: VALUES, quarter),
    "plus_first": plus_first,
    "as in its negative": lambda formula: differences_as_in(
        formula, with_positive_sines(formula, lambda: VALUES, quarter)
    ),
    "geometry first": lambda formula: geometry_first(formula, {"alpha", "theta"}),
    "over a line": over_line,
    "as in books": lambda formula: book_form(formula, {"a", "b", "c"}),
}


@pytest.mark.parametrize("name", REWRITINGS)
@given(formula=formulas)
def test_the_value_stays(name, formula):
    before = evaluate(formula, VALUES)
    if abs(before) < 1e9:
        after = evaluate(REWRITINGS[name](formula), VALUES)
        assert after == pytest.approx(before, rel=1e-7, abs=1e-9)
