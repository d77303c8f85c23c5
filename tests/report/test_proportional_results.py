"""A ratio that is an earlier one times lengths and numbers: what is said of it is said once."""

import pytest

import mechc
from good_mechanisms import compiled
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, number, product
from mechc.model.values import completed, defaults
from mechc.report.proportional_results import multiple
from mechc.report.sections import outline
from mechc.report.sentences.remarks import remarks
from mechc.report.text.speller import speller
from small_mechanisms import drawn_four_bar

A, C, SINE = Symbol("a"), Symbol("c"), Call("sin", (Symbol("phi"),))
K = product([(A, 1), (SINE, 1)])


def test_a_factor_of_lengths_and_numbers_is_found_with_its_sign():
    found = multiple(product([(SINE, 1), (C, -1), (number(-2), 1)]), {"k": K}, {"a", "c"})
    assert (found.name, text(found.factor), found.is_negative) == ("k", "-2/(a*c)", True)


@pytest.mark.parametrize(
    "other", [product([(SINE, 2), (C, 1)]), Call("cos", (Symbol("phi"),)), number(0)]
)
def test_what_differs_by_more_is_no_multiple(other):
    assert multiple(other, {"k": K}, {"a", "c"}) is None


def test_a_length_that_may_be_negative_makes_none():
    assert multiple(product([(SINE, 1), (C, 1)]), {"k": K}, {"a"}) is None


def said(name, language="en"):
    return remarks_of(compiled(name), language)


def remarks_of(compilation, language="en"):
    derivation, mechanism = compilation.reported, compilation.mechanism
    spell = speller(derivation.results, mechanism, True, language)
    shown = (r for s in outline(derivation, mechanism).results for r in s.results)
    return {r.name: remarks(r, spell.locale, spell) for r in shown}


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        (
            "en",
            "i_B = ak/(2b): i_B vanishes or becomes infinite where k does; with α it rises or "
            "falls as k does.",
        ),
        (
            "uk",
            "i_B = ak/(2b): i_B дорівнює нулю чи прямує до нескінченності там само, де й k; зі "
            "збільшенням α зростає чи спадає так само, як k.",
        ),
        (
            "ru",
            "i_B = ak/(2b): i_B обращается в нуль или стремится к бесконечности там же, где и k; "
            "с увеличением α возрастает или убывает так же, как k.",
        ),
    ],
)
def test_what_is_said_of_the_earlier_one_holds_likewise(language, sentence):
    assert said("karpenko_fig1_parallel_levers", language)["i_B"][0] == sentence


def test_extremes_lie_at_the_same_places():
    (sentence,) = (each for each in said("crank_rocker")["i"] if "k/c" in each)
    assert sentence.endswith("; it is least and greatest where k is.")


def test_what_moves_in_the_factor_is_stated_in_full():
    """Of k₂ = c·k₁/b the trends are those by b and c."""
    assert not any("k₁" in each for each in said("equalising_clamp")["k2"])


@pytest.mark.parametrize("name", ["crank_rocker", "four_bar", "steering_trapezium"])
def test_the_equation_holds_in_numbers(name):
    compilation = compiled(name)
    derivation, mechanism = compilation.reported, compilation.mechanism
    shown = {r.name: r for s in outline(derivation, mechanism).results for r in s.results}
    other = shown["i"].multiple_of
    known = completed(defaults(mechanism), shown["i"].where)
    known |= {literal.name: evaluate(literal.value, {}) for literal in mechanism.literals}
    values = [evaluate(shown[n].formula, known) for n in ("i", other.name)]
    assert values[0] == pytest.approx(evaluate(other.factor, known) * values[1], rel=1e-12)


def test_an_earlier_ratio_without_a_name_is_the_ratio():
    """−M₁_over_M₂ stood in the sentence."""
    source = drawn_four_bar(
        "drive OA from 40 deg to 80 deg", "torque M_2 on CB", "find M/M_2, omega_CB/omega_OA"
    )
    shown = remarks_of(mechc.loads(source)._compilation, "en")["omega_CB_over_omega_OA"]
    assert any("= −M/M₂: " in each for each in shown)
    assert not any("over" in each for each in shown)
