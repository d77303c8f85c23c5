"""A body on two supports: whether it slides or tips over first, as statics has it."""

import math

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.formula.to_text import text
from mechc.source import Source

CRATE = """
param b = 600 mm in 300 mm .. 900 mm
param h = 700 mm in 200 mm .. 1200 mm
param mu = 0.3 in 0.1 .. 0.6
slider A along x
slider B along x
link ABCG
AB = b @ 0 deg
AC = (0 mm, h)
AG = (b/2, b/2)
force P at C along x
force W at G along -y
friction slider A mu
friction slider B mu
find P
find N_A
"""


@pytest.mark.parametrize("h", [0.3, 0.9])
def test_it_slides_while_its_load_is_behind(h):
    found = mechc.loads(CRATE).evaluate(W=100.0, h=h)
    assert found["P_f"] == pytest.approx(30)
    assert found["N_A_f"] == pytest.approx(50 - 30 * h / 0.6)


def test_it_tips_over_above_half_its_width_over_the_coefficient():
    assert math.isnan(mechc.loads(CRATE).evaluate(W=100.0, h=1.01)["P_f"])


def test_the_formula_says_so():
    results = compile_source(Source("crate.mech", CRATE)).derivation.results
    (slides,) = (r for r in results if r.name == "P_f")
    assert [f"{text(c.left)} {c.operator} {text(c.right)}" for c in slides.holds] == [
        "W > 0",
        "b - 2*h*mu > 0",
    ]


def pressing(description: str) -> str:
    results = compile_source(Source("crate.mech", description)).derivation.results
    return next(text(r.formula) for r in results if r.name == "N_A_f")


def test_supports_are_solved_together():
    assert pressing(CRATE) == "W*(b - 2*h*mu)/(2*b)"


def test_no_closed_form_is_printed_where_it_tips_over():
    assert "n_A_guide" in pressing(CRATE.replace("h = 700 mm", "h = 1100 mm"))
