"""Ropes over pulleys: what their length asks of velocities, against formulas by hand."""

import pytest

from mechc.compilation import compile_source
from mechc.formula.to_text import text
from mechc.source import Source
from small_mechanisms import mirrored_rope, movable_pulley

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

MOVABLE = movable_pulley("find k = P/F")

MIRRORED = mirrored_rope()

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


TACKLE = movable_pulley("let F = 600 N", "find P", "find N_AK", "find N_BH")


@pytest.mark.parametrize("friction", ["", "friction slider K 0.1\nfriction slider H 0.1\n"])
def test_the_tension_of_a_rope(friction: str) -> None:
    """All falls have the tension of the hand, however hard guides are pressed beside it."""
    described = TACKLE + friction
    compilation = compile_source(Source("a.mech", described))
    found = {result.name: result for result in compilation.derivation.results}
    assert [text(found[name].formula) for name in ("N_AK", "N_BH")] == ["F/(1 + cos(alpha))"] * 2
    assert compilation.verdict.agrees
    if friction:
        values = {result.name: result.default for result in compilation.results}
        assert values["N_AK_f"] == pytest.approx(values["N_BH_f"], rel=1e-9)
        assert values["N_AK_f"] > 600 / (1 + 0.93969262)


def test_both_halves_of_a_mirror_have_a_rope_of_their_own() -> None:
    described = MIRRORED.replace("find k = P/F", "find P\nfind N_KB")
    compilation = compile_source(Source("a.mech", described))
    assert compilation.verdict.agrees
    hand, tension = (text(result.formula) for result in compilation.derivation.results)
    assert tension == hand
