"""Names of steps: what an entry of the table is called by the names of its parts."""

from fractions import Fraction

import pytest

from mechc.formula.tree import Number, Pi, Symbol
from mechc.routine.sharing import words
from mechc.routine.table import Apply, EntryTerms, Leaf, Ratio, Scaled

ENTRIES = (
    Leaf(Symbol("phi")),
    Leaf(Pi()),
    Leaf(Number(Fraction(2))),
    Leaf(Number(Fraction(1, 2))),
    Scaled(Fraction(-1), 0),
    Ratio((0, 2), ()),
)
LABELS = {0: "phi", 1: "", 2: "2", 3: "", 4: "minus_phi", 5: "phi_2"}


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        (ENTRIES[0], "phi"),
        (ENTRIES[2], "2"),
        (ENTRIES[3], ""),
        (Apply("sin", (0,)), "sin_phi"),
        (Apply("sin", (3,)), ""),
        (Scaled(Fraction(1), 0), "phi"),
        (Scaled(Fraction(-3), 0), "minus_3phi"),
        (Scaled(Fraction(1, 2), 0), ""),
        (Scaled(Fraction(1, 2), 1), "90deg"),
        (Scaled(Fraction(-1, 7), 1), ""),
        (Scaled(Fraction(2), 3), ""),
        (Ratio((0, 0), ()), "phi_squared"),
        (Ratio((0, 2), ()), "phi_2"),
        (Ratio((0,), (2,)), ""),
        (EntryTerms((0, 2)), "phi_plus_2"),
        (EntryTerms((2, 4)), "2_minus_phi"),
        (EntryTerms((0, 5)), ""),
    ],
)
def test_an_entry_is_called_by_its_parts_where_all_of_them_have_names(entry, said):
    assert words(entry, LABELS, ENTRIES) == said
