"""Tables, rows and sizes: what they are spelled out to has the same value."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechc.formula.choices import SAME_ROW, spelled_out
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Call, Formula, Symbol, number

X = Symbol("x")
ROWS = {-2: 5, 0: 7, 3: 11, 4: 13}
TABLE = (X, *(number(Fraction(part)) for row in ROWS.items() for part in row))

CALLS = {
    "interpolate": Call("interpolate", TABLE),
    "row": Call("row", TABLE),
    "met": Call("met", (X, *map(number, ROWS))),
    "next": Call("next", (X, *map(number, ROWS))),
}


def in_full(formula: Formula) -> Formula:
    """Return a call with all of its parts in terms of choices and conditions."""
    if not isinstance(formula, Call):
        return formula
    spelled = spelled_out(formula.function, formula.arguments)
    if spelled is not None:
        return in_full(spelled)
    return Call(formula.function, tuple(map(in_full, formula.arguments)))


@pytest.mark.parametrize("name", CALLS)
@given(st.one_of(st.sampled_from([*map(float, ROWS), 1.5, 3.5, -1.0]), st.floats(-4, 6)))
def test_what_is_spelled_out_has_the_same_value(name: str, x: float) -> None:
    direct, spelled = (evaluate(f, {"x": x}) for f in (CALLS[name], in_full(CALLS[name])))
    assert direct == pytest.approx(spelled, nan_ok=True, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(
    ("x", "value", "met"),
    [
        (-2, 5, -2),
        (0, 7, 0),
        (4, 13, 4),
        (3 * (1 + float(SAME_ROW) / 2), 11, 3 * (1 + float(SAME_ROW) / 2)),
        (3 * (1 + 2 * float(SAME_ROW)), math.nan, 3),
        (1e-300, math.nan, 0),
        (3.5, math.nan, 3),
        (3.6, math.nan, 4),
        (9, math.nan, 4),
        (-9, math.nan, -2),
        (math.nan, math.nan, math.nan),
    ],
)
def test_a_row_is_met_or_has_no_value(x: float, value: float, met: float) -> None:
    at = {"x": x}
    assert evaluate(CALLS["row"], at) == pytest.approx(value, nan_ok=True, rel=0)
    assert evaluate(CALLS["met"], at) == pytest.approx(met, nan_ok=True, rel=0)
