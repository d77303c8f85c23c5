"""Directions of links that formulas have as sums of angles: names for those that stand often."""

import pytest

from mechc.compilation import Compilation, compile_source
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, degrees, negative, number, product, total
from mechc.model.values import completed, defaults
from mechc.report.directions import NamedDirection, directions, in_results, named
from mechc.report.text.derivation import render
from mechc.source import Source
from small_mechanisms import drawn_six_bar

A, B, C = map(Symbol, "abc")
TWICE_A, TWICE_B = (product([(number(2), 1), (each, 1)]) for each in (A, B))


def watt() -> Compilation:
    return compile_source(Source("watt.mech", drawn_six_bar("find R_Q")))


def test_an_arm_of_a_ternary_link_has_its_direction() -> None:
    """As one writes it by hand, φ_QC, found once: the sum of three angles stood five times."""
    found = watt()
    said = render(found.reported, found.mechanism)
    assert "        φ_QC = φ_AB + μ_B + δ_BQC\n  2. Loop KCQ" in said
    assert "β_CK = arcsin((QC · cos φ_QC − x_K₀ + x_Q) / CK)" in said
    assert "V_K · cos β_CK = V_C · cos(β_CK + φ_QC)" in said
    assert "k vanishes when cos(β_CK + φ_QC) = 0" in said
    assert "φ_QC = 39.0939° + 58.5008° − 61.5673° = 36.0274°" in said
    assert said.count("δ_BQC") == 2


def test_an_account_by_equilibrium_has_it_too() -> None:
    found = watt()
    said = render(found.by_equilibrium, found.mechanism)
    assert "N_AB = QC · N_CK / QB · cos(β_CK + φ_QC) / sin μ_B" in said
    assert "φ_QC = φ_AB + μ_B + δ_BQC" in said


def test_results_keep_their_values() -> None:
    found = watt()
    chosen = directions(found.results, found.pose)
    known = dict(defaults(found.mechanism))
    known |= {literal.name: evaluate(literal.value, {}) for literal in found.mechanism.literals}
    known["F"] = 1000.0
    for result, before in zip(in_results(found.results, chosen), found.results, strict=True):
        value, old = (evaluate(r.formula, completed(known, r.where)) for r in (result, before))
        assert value == pytest.approx(old, rel=1e-12)


@pytest.mark.parametrize(
    ("turn", "angle", "shown"),
    [
        (0, total([A, B, negative(C)]), "sin(d - c)"),
        (0, total([C, negative(A), negative(B)]), "sin(c - d)"),
        (180, total([A, B, negative(C)]), "-sin(d - c)"),
        (180, total([C, negative(A), negative(B)]), "-sin(c - d)"),
        (0, total([A, negative(B)]), "sin(a - b)"),
        (0, total([negative(A), negative(B)]), "-sin(d)"),
        (180, total([negative(A), negative(B)]), "sin(d)"),
        (0, total([TWICE_A, TWICE_B]), "sin(2*d)"),
        (180, total([TWICE_A, TWICE_B]), "sin(2*d)"),
        (180, total([TWICE_A, TWICE_B, negative(C)]), "sin(2*d - c)"),
        (0, total([TWICE_A, B]), "sin(a + d)"),
        (180, total([negative(TWICE_A), negative(B)]), "sin(a + d)"),
        (0, total([TWICE_A, negative(B)]), "sin(2*a - b)"),
    ],
)
def test_the_sum_stands_by_its_name(turn: int, angle: Symbol, shown: str) -> None:
    direction = NamedDirection("d", (A, B), turn)
    formula = Call("sin", (angle,))
    turned = named(formula, [direction])
    assert text(turned) == shown
    values = {"a": 0.3, "b": 0.5, "c": 1.1}
    values["d"] = evaluate(direction.formula, values)
    assert evaluate(turned, values) == pytest.approx(evaluate(formula, values))


def test_a_cotangent_of_the_opposite_has_its_minus_before_it() -> None:
    formula = Call("cot", (total([negative(A), negative(B)]),))
    assert text(named(formula, [NamedDirection("d", (A, B))])) == "-cot(d)"


def test_a_constant_keeps_its_place() -> None:
    formula = Call("cos", (total([C, A, B, degrees(30)]),))
    assert text(named(formula, [NamedDirection("d", (A, B))])) == "cos(c + d + pi/6)"
