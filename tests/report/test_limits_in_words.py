"""Zeros and poles of a result are stated once, and never off the stroke without saying so."""

import re

import numpy as np
import pytest

import good_mechanisms
import mechc
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.data_folders import data
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.formula.tree import Call, Symbol
from mechc.report.sentences.extents import extent_remarks
from mechc.report.sentences.limits import limits, passed_by
from mechc.report.sentences.remarks import remarks
from mechc.report.text.derivation import render
from mechc.report.text.speller import speller
from mechc.routine.evaluate import evaluate
from mechc.source import Source


def said(name: str, language: str = "en") -> list[str]:
    """Return the analyses of the results of a mechanism."""
    return stated(good_mechanisms.compiled(name), language)


def stated(found: Compilation, language: str = "en") -> list[str]:
    """Return the analyses of results."""
    results = found.reported.results
    spell = speller(results, found.mechanism, True, language)
    return [line for result in results for line in remarks(result, spell.locale, spell)]


def test_conditions_of_one_kind_stand_together_and_those_off_the_stroke_are_stated_as_such():
    (line,) = (each for each in said("jansen_leg") if "infinite when" in each)
    assert "sin μ_D = 0, sin μ_B = 0 or sin μ_E = 0 (dead centre" in line
    assert line.endswith("; sampling finds none for 0° ≤ φ ≤ 360° and the values given.")
    (line,) = (each for each in said("jansen_leg", "uk") if "нескінченності" in each)
    assert "sin μ_B = 0 або sin μ_E = 0" in line


def test_places_are_listed_instead_of_a_long_condition():
    lines = said("jansen_leg")
    assert not any("vanishes when" in line for line in lines)
    assert any("k is 0 at φ = 2.386°, φ = 34.24°" in line for line in lines)


def test_a_long_condition_stands_beside_a_short_one_that_does_not_hold_at_the_places():
    """At all four places it is the sum, and |sin(φ_BD − φ_QD)| is at least 0.96."""
    (line,) = (each for each in said("double_butterfly") if "vanishes when" in each)
    assert "when sin(φ_QD − φ_BD) = 0 or AF · sin(φ_EG − φ) · sin(φ_AF − φ_CF) − AG" in line
    found = good_mechanisms.compiled("double_butterfly")
    spell = speller(found.reported.results, found.mechanism, True, "en")
    (k,) = found.reported.results
    (extent,) = k.extents
    without = replace(k, extents=(replace(extent, zeros=()),))
    (line,) = limits(replace(without, poles=()), "k", spell.locale, spell)
    assert line.startswith("k vanishes when sin(φ_QD − φ_BD) = 0 (dead centre")
    assert line.endswith("; sampling finds none for 0° ≤ φ ≤ 360° and the values given.")


@pytest.mark.parametrize(("language", "word"), [("en", "or"), ("ru", "или"), ("uk", "або")])
def test_a_condition_has_the_name_that_its_sum_has_on_the_page(language, word):
    text = mechc.load("double_butterfly").emit("latex", language=language)
    assert rf"$\sin(\varphi_{{QD}}-\varphi_{{BD}})=0$ {word} $Z_2=0$" in text


def test_what_is_neither_zero_nor_infinite_is_stated_once():
    lines = said("toggle_clamp")
    assert sum("sampling finds none for 2° ≤ θ ≤ 40°" in line for line in lines) == 2
    assert not any("neither 0 nor infinite" in line for line in lines)
    assert any("k is nowhere infinite;" in line for line in said("triad_closed"))


TRAMMEL = """
mechanism tram
param phi = 30 deg
slider A along x through O
slider B along y through O
pivot O at (0 mm, 0 mm)
link ABM
AB = 200 mm @ 180 deg - phi
AM = 350 mm @ 180 deg - phi
drive phi from 10 deg to 80 deg
force P at A along -x
force Q at B along -y
find k = P/Q
find V_M/V_A
"""


def test_what_is_zero_and_infinite_outside_a_range_is_not_said_to_be_neither_in_it():
    page = " ".join(stated(Compilation(Source("tram.mech", TRAMMEL))))
    assert page.count("outside the ranges given") == 2
    assert "the rest at the values given, the least k is 0.17633" in page
    assert "V_M/V_A is neither 0 nor infinite;" in page


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("en", "k is nowhere infinite;"),
        ("uk", "k ніде не прямує до нескінченності;"),
        ("ru", "k нигде не стремится к бесконечности;"),
    ],
)
def test_where_it_is_stated_that_there_is_no_zero_it_is_said_of_poles_alone(language, words):
    page = mechc.load("vice_grip").emit("latex", language=language)
    assert words in page.replace("$", "")


@pytest.mark.parametrize(
    ("language", "words"),
    [("en", "this does not occur for"), ("ru", "этого не бывает"), ("uk", "цього не буває")],
)
def test_what_is_proved_not_to_occur_is_not_left_to_sampling(language, words):
    """|β| is at most 11.5° where sin β = 0.2 sin φ: neither cos β nor sin(β + φ) vanishes."""
    lines = [line for line in said("claw_closed", language) if "β" in line and "; " in line]
    assert len(lines) == 2
    assert all(words in line for line in lines)


@pytest.mark.parametrize("place", [1.3e-14, 3.5e-8, -3.5e-8])
def test_a_place_that_is_rounding_beside_its_range_is_zero(place):
    """An extremum is found to the root of what its values are rounded by."""
    found = good_mechanisms.compiled("peaucellier_closed")
    (k,) = (r for r in found.reported.results if r.extents)
    least = k.extents[0].least._replace(x=place)
    extent = replace(k.extents[0], least=least)
    spell = speller([k], found.mechanism, True, "en")
    (line,) = extent_remarks(replace(k, extents=(extent,)), "k", spell.locale, spell)
    assert "at φ = 0°;" in line


@pytest.mark.parametrize("name", ["crank_rocker", "toggle_clamp", "watt_closed", "whitworth"])
def test_a_stroke_without_zeros_or_poles_has_none(name):
    found = good_mechanisms.compiled(name)
    functions = {f.name: f for f in found.routine.functions}
    for result in found.reported.results:
        for kind in ("zeros", "poles"):
            if extent := passed_by(result, kind):
                values = {i.name: i.default for i in functions[result.name].inputs}
                values[extent.parameter] = np.linspace(*extent.range, 4001)
                along = evaluate(functions[result.name], values)
                if kind == "zeros":
                    assert np.all(along[1:] * along[:-1] > 0)
                else:
                    most = max(abs(extent.least.value), abs(extent.greatest.value))
                    assert np.max(np.abs(along)) <= most * (1 + 1e-6)


def test_friction_angles_are_not_followed_below_zero():
    for name in ("d45_16_wedge_hook_with_friction", "screw_jack_with_friction"):
        assert not any("−90° < ρ" in line or "ρ < 98°" in line for line in said(name))
    assert any("0° < β ≤ ρ" in line for line in said("d45_16_wedge_hook_with_friction"))


def test_a_law_is_explained_once():
    found = good_mechanisms.compiled("jansen_leg")
    text = " ".join(render(found.reported, found.mechanism, unicode=True).split())
    assert text.count("the law of cosines gives its angles") == 1
    assert "Likewise triangle ZDA, its vertices in counter-clockwise order." in text
    assert text.count("Equal-projection theorem") == 1
    assert "Likewise on the line AD the velocities of A and D have equal projections." in text


def test_atan2_is_explained_where_it_is_used():
    words = "atan2(y, x) is the direction of the vector with the components x and y."
    for name, count in (("crank_rocker", 1), ("four_bar", 0)):
        found = good_mechanisms.compiled(name)
        text = " ".join(render(found.reported, found.mechanism, unicode=True).split())
        assert text.count(words) == count


def test_a_slope_is_in_the_unit_of_lengths():
    (file,) = TARGET.emit(good_mechanisms.compiled("jansen_leg"), Options("jansen"))
    assert re.search(r"26\.1493[^$]*mm", file.text)


def test_what_a_result_is_proportional_to_is_written_in_the_order_of_its_formula():
    assert "k is proportional to gj/(hl)." in said("bolt_cutter")


YOKE = """mechanism yoke
param phi = 50 deg in 0 deg .. 360 deg
param e = 20 mm
pivot O
link OC
slide TK along y
OC = e @ TIMES*phi
contact C on TK normal -90 deg
torque M on OC
force F at K along -y
find k = F/M
"""


@pytest.mark.parametrize(
    ("language", "places", "many"),
    [
        ("en", "that is, at φ = 90° or 270° (", "at φ = 30° and every 60° from there on ("),
        ("ru", "то есть при φ = 90° или 270° (", "то есть при φ = 30° и далее через каждые 60° ("),
        ("uk", "тобто при φ = 90° або 270° (", "тобто при φ = 30° і далі через кожні 60° ("),
    ],
)  # fmt: skip
def test_every_place_within_a_range_is_named(language, places, many):
    for times, expected in ((1, places), (3, many)):
        found = Compilation(Source("yoke.mech", YOKE.replace("TIMES", str(times))))
        spell = speller(found.reported.results, found.mechanism, True, language)
        (k,) = found.reported.results
        assert any(expected in line for line in remarks(k, spell.locale, spell))


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "except perhaps where {} as well (dead centre"),
        ("uk", "крім, можливо, випадків, коли водночас {} (мертве положення"),
        ("ru", "кроме, возможно, случаев, когда одновременно {} (мёртвое положение"),
    ],
)
def test_what_makes_a_condition_doubtful_is_written_as_in_the_formula(language, said):
    """The sine of ψ − φ was the one of φ − ψ there; outside the ranges nothing is doubtful."""
    text = (data("library") / "bench_shears.yaml").read_text()
    wide = re.sub(r", range: [^}]*", "", text)
    for description, is_said in ((wide, True), (text, False)):
        found = Compilation(Source("bench_shears.yaml", description))
        spell = speller(found.reported.results, found.mechanism, True, language)
        (k,) = found.reported.results
        lines = "\n".join(remarks(k, spell.locale, spell))
        assert (said.format("sin(ψ − φ) = 0") in lines) == is_said
        assert (said.partition(" {}")[0] in lines) == is_said
        assert "sin(φ − ψ)" not in lines


def test_a_condition_that_is_made_a_sine_is_the_one_of_the_formula():
    text = mechc.load("steering_trapezium").emit("latex")
    assert r"vanishes when $\sin(\psi-\delta+67^\circ)=0$" in text
    assert r"\delta-\psi" not in text


def test_each_place_stands_with_the_condition_that_holds_there():
    found = good_mechanisms.compiled("watt_closed")
    (k,) = (r for r in found.reported.results if r.extents)
    spell = speller(found.reported.results, found.mechanism, True, "en")
    first, second = Call("sin", (Symbol("phi"),)), Call("cos", (Symbol("psi"),))
    places = (1.0, 2.0, 3.0)
    vanishes = {1.0: first, 2.0: second, 3.0: first}
    extent = replace(k.extents[0], zeros=places, least=None, vanishes=vanishes)
    (line,) = extent_remarks(replace(k, extents=(extent,)), "k", spell.locale, spell)
    assert "k is 0 at φ = 57.3° and φ = 171.9° (sin φ = 0), φ = 114.6° (cos ψ = 0)" in line
    unknown = replace(extent, vanishes={1.0: first})
    (line,) = extent_remarks(replace(k, extents=(unknown,)), "k", spell.locale, spell)
    assert "k is 0 at φ = 57.3°, φ = 114.6° and φ = 171.9° (found" in line


def test_a_condition_has_its_sum_as_the_formula_has_it():
    """Neither in another order nor with the other sign, with a name of its own or without."""
    (zero,) = (line for line in said("triad_press") if "load is perpendicular" in line)
    assert "when b · sin(σ − β) · sin γ − c · sin(τ − γ) · sin β = 0" in zero
    found = good_mechanisms.compiled("class_four_block")
    text = render(found.derivation, found.mechanism)
    assert "k vanishes when Z₂ = 0" in text
    assert "k becomes infinite when Z₁ = 0" in text
