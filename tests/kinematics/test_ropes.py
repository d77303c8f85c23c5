"""Ropes over pulleys: what their length asks of velocities, against formulas by hand."""

import pytest

from mechc.driver import compile_source
from mechc.formula.to_text import text
from mechc.source import Source

TWO_WEIGHTS = """
param alpha = 30 deg in 10 deg .. 80 deg
pivot B
slider A along 180 deg + alpha
slider C along -y
rope A, B along alpha, C along -y
force P at C along -y
force Q at A along -y
find k = P/Q
"""

MOVABLE = """
param alpha = 20 deg in 0 deg .. 60 deg
pivot A
pivot B
slider K along y
slider H along -y
rope A, K along -90 deg + alpha, B along y, H along -y
force P at H along -y
force F at K along -y
find k = P/F
"""

MIRRORED = """
param alpha = 20 deg in 10 deg .. 60 deg
pivot B
slider K along y
slider H along y
rope K, B along 90 deg - alpha, H along -90 deg
mirror across y sharing K
force P at H along -y
force F at K along -y
find k = P/F
"""

ON_A_BOOM = """
param a = 3 m
param b = 2 m
param alpha = 30 deg in 20 deg .. 60 deg
param beta = 20 deg
pivot O
pivot B
slider H along -y
link OC
OC = a @ alpha
rope C, B along 180 deg - beta, H along -y
force P at H along -y
force F at C along -y
find k = P/F
"""


@pytest.mark.parametrize(
    ("described", "formula"),
    [
        (TWO_WEIGHTS, "sin(alpha)"),
        (MOVABLE, "1/(1 + cos(alpha))"),
        (MIRRORED, "1/(2*cos(alpha))"),
        (ON_A_BOOM, "cos(alpha)/sin(alpha + beta)"),
    ],
)
def test_what_a_rope_transmits(described: str, formula: str) -> None:
    """The falls at the load share it; both halves of a mirror have a hand."""
    compilation = compile_source(Source("a.mech", described))
    (result,) = compilation.derivation.results
    assert text(result.formula) == formula
    assert compilation.verdict.agrees
    assert compilation.verdict.trials
