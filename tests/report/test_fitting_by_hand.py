"""Which formulas are shown with their numbers in a terminal."""

from types import SimpleNamespace

import pytest

from mechc.formula.tree import Symbol
from mechc.report.evaluated import Evaluated
from mechc.report.put_in import GivenQuantity
from mechc.report.text.derivation import LINES, _fits

K, NAMED, NUMBERS = Symbol("k"), Symbol("named"), Symbol("numbers")
WIDTH = 40


def spell(length: int, parts=True):
    """Return a speller that takes so many columns, and has names for parts of ``NAMED``."""
    shown = SimpleNamespace(shown=lambda formula: K if formula == NAMED else formula)
    return SimpleNamespace(
        parts=shown if parts else None, width=WIDTH, relation=lambda *_: "x" * length
    )


@pytest.mark.parametrize(
    ("numbers", "formula", "speller", "fits"),
    [
        (None, NAMED, spell(1), False),
        (None, None, spell(1), False),
        (NUMBERS, None, spell(10 * WIDTH), True),
        (NUMBERS, NAMED, spell(10 * WIDTH, parts=False), True),
        (NUMBERS, K, spell(10 * WIDTH), True),
        (NUMBERS, NAMED, spell(LINES * WIDTH), True),
        (NUMBERS, NAMED, spell(LINES * WIDTH + 1), False),
    ],
)
def test_a_formula_with_names_for_its_parts_has_its_numbers_where_they_are_short(
    numbers, formula, speller, fits
):
    item = Evaluated(K, numbers, GivenQuantity(1.0, ""), False, formula)
    assert _fits(item, speller) is fits
