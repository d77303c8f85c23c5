"""No other units are put in beside a number that stands for some of its own."""

import pytest

from mechc.compilation import compile_source
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.formula.tree import Call, Symbol, number, product, quotient, total
from mechc.report.dimensions import is_homogeneous
from mechc.report.languages import registry
from mechc.report.text.derivation import render
from mechc.source import Source
from mechc.units import FORCE, LENGTH, NUMBER

A, B, P, ALPHA = (Symbol(name) for name in ("a", "b", "P", "alpha"))
VALUES = {"a": 0.3, "b": 0.2, "P": 500.0, "alpha": 0.4}
DIMENSIONS = {"a": LENGTH, "b": LENGTH, "P": FORCE, "alpha": NUMBER}

LEVER = """
    param w = 38 mm
    pivot O at (0 mm, 0 mm)
    link OAB
    A at (w*w/(8 mm), 20 mm)
    B at (w, 70 mm)
    force P at A along y
    force F at B along -x
    find k = P/F
"""


def noted(text):
    compilation = compile_source(Source("lever.mech", text))
    return render(compilation.derivation, compilation.mechanism)


@pytest.mark.parametrize(
    ("formula", "same"),
    [
        (quotient(product([(A, 1), (P, 1)]), B), True),
        (Call("hypot", (A, B)), True),
        (Call("atan2", (A, B)), True),
        (product([(number(3), 1), (Call("cos", (ALPHA,)), 1)]), True),
        (total([A, number(-8)]), False),
        (Call("atan2", (total([A, number(1)]), B)), False),
        (product([(number(625), 1), (P, 1)]), True),
    ],
)
def test_a_formula_that_means_the_same_in_all_units(formula, same):
    assert is_homogeneous(formula, VALUES, DIMENSIONS) == same


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
def test_a_report_says_what_such_numbers_are_in(language):
    compilation = compile_source(Source("lever.mech", LEVER))
    (document,) = TARGET.emit(compilation, Options("lever", language=language))
    note = render(compilation.derivation, compilation.mechanism, language=language)
    said = registry.locale(language).plain_numbers
    assert said in document.text
    assert said in " ".join(note.split())


def test_numbers_with_names_of_their_own_have_their_units():
    note = noted(LEVER.replace("w*w/(8 mm)", "30 mm"))
    assert registry.locale("en").plain_numbers not in " ".join(note.split())
    assert "k = −70 / (36.0555 · cos 33.6901°) = −2.33333" in note


def test_numbers_are_not_put_in_beside_numbers_of_other_units():
    note = noted(LEVER)
    lines = [line for line in note.splitlines() if "38 mm" in line]
    assert [line.split()[:5] for line in lines] == [["w", "=", "38", "mm", "horizontal"]]


def test_a_number_with_a_unit_in_a_product_is_not_put_in_among_millimetres():
    """k = −8 mm·70 mm/(38 mm)² is a pure number; 0.008·70/38² would be a thousandth of it."""
    note = noted(LEVER)
    (line,) = [line.strip() for line in note.splitlines() if line.strip().startswith("k = −")]
    assert line == "k = −0.387812"
