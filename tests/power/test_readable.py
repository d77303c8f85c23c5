"""Formulas no longer than a person's: counted in operations, against the same by hand."""

import pytest

import mechc
from good_mechanisms import ALL
from mechc.algebra.equality import equal
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text

LONGEST = {
    "hoeken": 11,
    "jansen_leg": 42,
    "peaucellier_closed": 24,
    "double_butterfly": 48,
    "stephenson_closed": 19,
    "watt_closed": 16,
    "triad_closed": 28,
    "ternary_chain": 41,
}


@pytest.mark.parametrize("name", LONGEST)
def test_no_formula_grows(name: str) -> None:
    result = mechc.load(str(ALL[name])).results["k"]
    assert count_operations(result.formula) <= LONGEST[name]


def test_a_straight_line_mechanism_reads_as_by_hand() -> None:
    """Hoeken: V_P of the crank's end and of the coupler's turning, not three cosines."""
    hoeken = mechc.load("hoeken").results["k"]
    assert text(hoeken.formula) == "a*(sin(phi) + 2*sin(phi - mu_B - phi_AB)*sin(phi_AB)/sin(mu_B))"


@pytest.mark.parametrize("name", ["hoeken", "peaucellier_closed", "ternary_chain"])
def test_a_shorter_form_is_the_same(name: str) -> None:
    solved = mechc.load(str(ALL[name]))
    (item,) = solved._compilation.balance.solved
    assert item.value is not None
    assert text(item.value.formula()) != text(item.result.formula)
    assert equal(item.value.formula(), item.result.formula)
