"""Numbers put into a formula too long for a line: the sums named on the page have theirs."""

import math
import re
import sys
from fractions import Fraction

import mechc
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Call, Symbol, negative, number, product, total
from mechc.model.values import UsualUnits
from mechc.report.by_parts import by_parts
from mechc.report.evaluated import Evaluated, KnownQuantities
from mechc.report.put_in import GivenQuantity
from mechc.report.text.character_sets import UNICODE
from mechc.report.text.printer import print_formula

A, B, Z = map(Symbol, ("a", "b", "Z_1"))
SUM = total([A, B])
KNOWN = KnownQuantities(
    {"a": GivenQuantity(0.04, "mm"), "b": GivenQuantity(0.03, "mm")}, UsualUnits("mm")
)


VOLUME = product([(A, 1), (SUM, 2)])


def item(name: str) -> Evaluated:
    value = GivenQuantity(evaluate(VOLUME, {"a": 0.04, "b": 0.03}), "m^3")
    return Evaluated(Symbol(name), None, value, False, VOLUME, KNOWN)


def numbers_fit(found):
    return found.numbers is not None


def test_a_named_sum_has_its_value_once_and_before_what_rests_on_it():
    found = list(by_parts([item("R"), item("S")], {SUM: Z}, numbers_fit))
    assert [each.left.name for each in found] == ["Z_1", "R", "S"]
    assert found[0].value.text(6) == "70 mm"
    assert all(each.numbers is not None for each in found)


def test_the_value_of_a_named_sum_is_found_once_for_all_formulas_of_a_page(monkeypatch):
    asked = []
    module = sys.modules[by_parts.__module__]
    whole = module.found_unit
    monkeypatch.setattr(module, "found_unit", lambda *about: asked.append(about) or whole(*about))
    assert len(list(by_parts([item(name) for name in "RSTU"], {SUM: Z}, numbers_fit))) == 5
    assert len(asked) == 1


def test_a_product_without_named_sums_has_the_values_of_its_sums():
    """R = a (a + b)² = 40 mm · (70 mm)²."""
    (found,) = by_parts([item("R")], {}, numbers_fit)
    assert found.numbers is not None
    assert print_formula(found.numbers, UNICODE) == "40 mm · (70 mm)²"


def test_a_sum_has_the_values_of_its_terms_unless_rounding_would_be_seen():
    """a + b² / a, and a difference of which no digit is left."""
    whole = total([A, product([(B, 2), (A, -1)])])
    near = total([whole, product([(number(Fraction(-624999999, 10**10)), 1), (A, 1), (A, -1)])])
    values = {"a": 0.04, "b": 0.03}
    items = [
        Evaluated(Symbol("R"), None, GivenQuantity(evaluate(f, values), "mm"), False, f, KNOWN)
        for f in (whole, near)
    ]
    first, second = by_parts(items, {}, numbers_fit)
    assert first.numbers is not None
    assert print_formula(first.numbers, UNICODE) == "40 mm + 22.5 mm"
    assert second.numbers is None


def test_a_product_with_a_force_that_has_no_value_on_the_page_has_none():
    """S_AB (a + b), of which the report gives no S_AB."""
    formula = product([(Symbol("S_AB"), 1), (SUM, 1)])
    (found,) = by_parts([item("R")._replace(formula=formula)], {}, numbers_fit)
    assert found.numbers is None


def test_a_named_sum_that_has_no_value_is_passed_over():
    """Z_2 = Z_1 + S_AB has none where the report gives no S_AB, though Z_1 in it has one."""
    force = Symbol("S_AB")
    named = {total([SUM, force]): Symbol("Z_2"), SUM: Z}
    formula = product([(A, 1), (SUM, 1), (total([SUM, force]), 1)])
    whole = item("R")._replace(formula=formula)
    found = by_parts([whole], named, lambda each: each is not whole)
    assert [each.left.name for each in found] == ["Z_1", "R"]


def test_a_named_sum_that_another_mentions_too_has_its_value_once():
    """R = a Z_1 Z_2, and Z_2 = b + Z_1²/a."""
    outer = total([B, product([(SUM, 2), (A, -1)])])
    formula = product([(A, 1), (SUM, 1), (outer, 1)])
    named = {SUM: Z, outer: Symbol("Z_2")}
    found = list(by_parts([item("R")._replace(formula=formula)], named, numbers_fit))
    assert [each.left.name for each in found] == ["Z_1", "Z_2", "R"]


def test_what_does_not_fit_with_names_either_has_no_values_of_sums_before_it():
    alone = item("R")
    assert list(by_parts([alone], {SUM: Z}, lambda _: False)) == [alone]


def test_sums_named_on_a_page_have_their_numbers_there() -> None:
    page = mechc.load("examples/gripper/linkage.mech").emit("latex")
    numbers = page.split(r"\section*{Numerical values}")[1]
    values = dict(re.findall(r"(Z_\d)&=[^\n]*?([\d.]+\\,\\text\{mm\}\^2)(?=\\\\|&|\n)", numbers))
    assert len(values) == 2
    for value in values.values():  # S_KA = Z_2/(a² − ρ²)
        assert rf"=\frac{{{value}}}" in numbers


def test_a_sum_of_which_one_term_is_left_is_not_its_value_twice():
    """On the brief page of Hoeken's linkage φ_AQ is 0: φ_AB = 53.1301° = 53.1301°."""
    page = mechc.load("hoeken").emit("latex", brief=True)
    assert r"$\varphi_{AB}=53.1301^\circ$" in page
    assert r"53.1301^\circ=53.1301^\circ" not in page


def test_the_unit_of_a_sum_that_is_zero_by_its_values_is_that_of_its_terms():
    """a (b cos x + 0.75 a − b), x a quarter turn: rounding alone has no unit."""
    cosine = Call("cos", (Symbol("x"),))
    zero = total(
        [
            product([(B, 1), (cosine, 1)]),
            product([(number(Fraction(3, 4)), 1), (A, 1)]),
            negative(B),
        ]
    )
    quantities = {**KNOWN.quantities, "x": GivenQuantity(math.pi / 2, "deg")}
    known = KNOWN._replace(quantities=quantities)
    for factor, printed in ((A, "40 mm · 0 mm"), (product([(A, 2)]), "(40 mm)² · 0 mm")):
        formula = product([(factor, 1), (zero, 1)])
        left = item("R")._replace(formula=formula, value=GivenQuantity(0.0, "mm^2"), known=known)
        (found,) = by_parts([left], {}, numbers_fit)
        assert found.numbers is not None
        assert print_formula(found.numbers, UNICODE) == printed
