"""Long parts that a derivation has more than once, and speeds that it finds in vain."""

from good_mechanisms import compiled
from mechc.base.frozen import replace
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, number, product, quotient, total
from mechc.report.derivation.from_solution import without_unused
from mechc.report.kinds import StepRule
from mechc.report.made_names import MadeNames
from mechc.report.steps import Derivation, DerivationStep, Equation, PowerTerm
from mechc.report.text.derivation import render
from mechc.report.text.repeated import RepeatedSums

A, B, C, D = map(Symbol, "abcd")
LONG = total(
    product([(side, 1), (Call("sin", (total([A, angle]),)), 1), (Call("cos", (angle,)), 1)])
    for side, angle in ((A, B), (C, D), (D, C))
)


def test_a_sum_is_named_where_it_stands_twice_and_never_as_a_whole():
    once, twice = [quotient(A, LONG)], [quotient(A, LONG), quotient(B, LONG)]
    assert not RepeatedSums(once, MadeNames(), lambda part: True).sums
    parts = RepeatedSums(twice, MadeNames(), lambda part: True)
    assert text(parts.shown(twice[0])) == "a/Z_1"
    assert parts.shown(LONG) == LONG
    assert [text(side) for side in parts.sides((LONG, number(0)))] == ["Z_1", "0"]


def test_sums_are_numbered_in_the_order_in_which_a_page_has_them():
    """The longer one was the first, wherever it stands."""
    longer = total([LONG, product([(B, 1), (C, 1), (D, 1)])])
    page = [quotient(A, LONG), quotient(LONG, longer), quotient(longer, LONG)]
    parts = RepeatedSums(page[1:] * 2, MadeNames(), lambda part: True, page)
    assert [text(parts.shown(one)) for one in page] == ["a/Z_1", "Z_1/Z_2", "Z_2/Z_1"]


def test_the_opposite_of_a_sum_has_its_name_with_a_minus():
    opposite = total(product([(number(-1), 1), (term, 1)]) for term in LONG.terms)
    parts = RepeatedSums([quotient(A, LONG), quotient(B, LONG)], MadeNames(), lambda part: True)
    assert text(parts.shown(quotient(C, opposite))) == "-c/Z_1"


def test_what_is_short_or_a_letter_of_a_point_is_not_taken():
    short = total([A, B])
    formulas = [quotient(C, short), quotient(D, short)]
    assert not RepeatedSums(formulas, MadeNames(), lambda part: True).sums
    assert count_operations(short) < count_operations(LONG)
    made = MadeNames()
    made.take_points(["Z"])
    parts = RepeatedSums([quotient(A, LONG), quotient(B, LONG)], made, lambda part: True)
    assert text(parts.shown(quotient(A, LONG))) == "a/Y_1"


def test_a_derivation_has_the_denominator_of_a_triad_once():
    compilation = compiled("triad_closed")
    shown = " ".join(render(compilation.reported, compilation.mechanism).split())
    assert shown.count("BC · sin(φ_AB − φ_RD) · sin(φ_QC − φ_BC)") == 1
    assert "where Z₁ = BC ·" in shown


TOGETHER = DerivationStep(
    StepRule.TOGETHER,
    ("AB", "CD"),
    (Equation(Symbol("omega_AB"), Symbol("omega_CD")),),
    tuple(
        Equation(Symbol(n), product([(A, 1), (Symbol("omega_O"), 1)]))
        for n in ("omega_AB", "omega_CD")
    ),
)
TERMS = (PowerTerm("M", "O", number(1), Symbol("omega_O")),)


def found(derivation: Derivation) -> list[str]:
    return [text(e.left) for step in without_unused(derivation).steps for e in step.results]


def test_speeds_that_nothing_has_are_left_out_of_what_is_solved_together():
    load = PowerTerm("T", "AB", number(1), Symbol("omega_AB"))
    derivation = Derivation((TOGETHER,), (*TERMS, load), (), ())
    assert found(derivation) == ["omega_AB"]


def test_speeds_that_a_later_step_has_are_kept():
    load = PowerTerm("T", "AB", number(1), Symbol("omega_AB"))
    lever = Equation(Symbol("V_D"), product([(B, 1), (Symbol("omega_CD"), 1)]))
    arm = DerivationStep(StepRule.ARM, ("C", "D"), (lever,), (lever,))
    derivation = Derivation((TOGETHER, arm), (*TERMS, load), (), ())
    assert found(derivation) == ["omega_AB", "omega_CD", "V_D"]


def test_of_speeds_that_nothing_has_all_are_kept():
    """A derivation that ends in them has no other end."""
    assert found(Derivation((TOGETHER,), TERMS, (), ())) == ["omega_AB", "omega_CD"]
    alone = replace(TOGETHER, rule=StepRule.ROTATION)
    assert found(Derivation((alone,), TERMS, (), ())) == ["omega_AB", "omega_CD"]
