"""What a report has defined already, so that nothing is defined twice."""

import pytest

from mechc.formula.tree import Symbol, negative, product, total
from mechc.model.result import Definition
from mechc.report.kinds import SentenceKind
from mechc.report.sections import ShownNames
from mechc.report.steps import Equation, Explanation, Paragraph

A, B, S = map(Symbol, "abs")
LED, BEHIND = total([A, negative(B)]), total([negative(B), A])


@pytest.mark.parametrize(
    ("formula", "is_new"),
    [(LED, False), (BEHIND, False), (total([A, B]), True), (product([(A, 1), (B, 1)]), True)],
)
def test_a_name_that_an_account_has_found_is_defined_again_only_as_something_else(formula, is_new):
    """The account leads by a; the definition, −b + a, was printed below it once more."""
    shown = ShownNames()
    account = Paragraph(SentenceKind.SOLVED_TOGETHER, (Equation(S, LED),))
    shown.equations(Explanation(("k",), (account,)))
    found = shown.new_definitions([S], [Definition("s", formula)])
    assert [d.name for d in found] == ["s"] * is_new
