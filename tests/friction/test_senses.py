"""A slip that is zero at the values given has no sense, on paper and in code.

What is computed of it is a rounding of either sign, and friction with that sign would be a
number that no hand finds.
"""

import math
from collections.abc import Iterator

import numpy as np
import pytest

from friction_chains import chain, squared
from friction_statements import Ratios, refuted
from mechc import loads
from mechc.algebra.angle import Angle
from mechc.algebra.product import Product
from mechc.algebra.sums import add
from mechc.algebra.trigonometry import cosine, sine
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.friction.signs.senses import sense_of, size_of
from mechc.routine.evaluate import evaluate as by_interpreter
from mechc.source import Source
from mechc.study.analysis import as_printed
from mechc.study.locking import locking
from mechc.study.ratios import FrictionStudy
from small_mechanisms import geared_lever

RIGHT, DIAGONAL = 90, 45


def at(**terms: int) -> Angle:
    return Angle(tuple(terms.items()))


def squared_chains(seeds: range) -> Iterator[tuple[int, Compilation]]:
    for seed in seeds:
        written = squared(chain(seed), RIGHT if seed % 2 else DIAGONAL)
        compilation = Compilation(Source("square.mech", written))
        try:
            _ = compilation.results
        except MechcError as error:
            if {d.code for d in error.diagnostics} & {"E601", "E817"}:
                raise
            continue
        yield seed, compilation


def test_a_sense_is_that_of_the_value():
    a, b = Product.symbol("a"), Product.symbol("b")
    slip = add([a * sine(at(t=1)), -b * cosine(at(t=1))]) / sine(at(s=1))
    sense = sense_of(slip)
    for t in np.linspace(-3, 3, 41):
        for s in (-0.4, 2.0):
            values = {"a": 2e-6, "b": 3e-6, "t": t, "s": s}
            assert evaluate(sense, values) == math.copysign(1, slip.evaluate(values))


@pytest.mark.parametrize("turns", range(1, 40))
def test_a_zero_that_was_rounded_has_no_sense(turns):
    """Both terms are roundings, so that their sum is not small against them, but against a + b."""
    slip = add([Product.symbol("a") * sine(at(t=1)), Product.symbol("b") * sine(at(s=1))])
    values = {"a": 2e-6, "b": 3e-6, "t": math.pi * turns, "s": -math.pi * turns}
    assert slip.evaluate(values) != 0
    assert evaluate(sense_of(slip), values) == 0


def test_the_size_of_a_sum_is_that_of_its_terms():
    a, b = Product.symbol("a"), Product.symbol("b")
    slip = add([a.scaled(-2) * sine(at(t=1)), b * cosine(at(s=1)) / cosine(at(u=1))])
    size = size_of(slip)
    values = {"a": -1.5, "b": 3.0, "t": 0.4, "s": 1.1, "u": 0.6}
    assert evaluate(size, values) == pytest.approx((2 * 1.5 + 3) / math.cos(0.6))
    assert text(sense_of(Product.symbol("a") * sine(at(t=1)))) == "sense(a*sin(t), abs(a))"


SQUARE = chain(91000066)
"""The guide is square to BA at the values given, so that O does not slip."""


def test_a_guide_square_to_a_link_takes_no_friction_from_the_pivot():
    """Self-locking is told to 69.22 deg; by the sign of a rounding code moved from 68.34 deg."""
    mechanism = loads(SQUARE)
    angles = np.radians([68.0, 68.5, 69.0, 69.1])
    assert np.all(mechanism.evaluate(t2=angles)["k_f"] > 0)
    angles = np.radians([69.3, 69.8])
    assert np.all(mechanism.evaluate(t2=angles)["k_f"] < 0)


@pytest.mark.slow
def test_what_is_said_where_a_guide_is_square_to_a_link_is_true():
    assert list(refuted(loads(SQUARE)._compilation)) == []


NOTHING_OVER_NOTHING = """
param t1 = 90 deg
param t2 = -90 deg
pivot O
link AOB
OA = 60 mm @ t1
OB = 80 mm @ t2
force P at A along 90 deg
force F at B along -90 deg
find k = P/F
friction pins 0.15 diameter 8 mm
"""
"""Both forces go through the pivot: k is 0/0 at the values given."""


def test_with_friction_a_ratio_is_undetermined_where_it_is_without():
    """No load turns the lever there. An efficiency was a rounding of zero, 1.1e-15."""
    compilation = Compilation(Source("open.mech", NOTHING_OVER_NOTHING))
    for name in ("k", "k_f", "k_f1", "k_hold", "eta_k"):
        (found,) = (r for r in compilation.results if r.name == name)
        assert found.undetermined, name
        assert found.default is None, name


def test_an_efficiency_is_undetermined_where_no_load_is_asked_for_with_friction_either():
    """It was said to be 0, and put in as 1/(1 - 0.02*0) = 0: the share of what friction takes."""
    found = {
        r.name: r for r in Compilation(Source("gear.mech", geared_lever(alpha="90 deg"))).results
    }
    assert found["k_f"].default == 0
    assert found["eta_k"].undetermined
    assert not found["eta_k"].fails_here


def hold_at_the_values_given(compilation: Compilation) -> int:
    """Compare the numbers on paper with those of code, at the values given; return how many."""
    functions = {f.name: f for f in compilation.routine.functions}
    compared = 0
    for result in compilation.results:
        if result.name not in functions or result.default is None:
            continue
        code = functions[result.name]
        found = by_interpreter(code, {i.name: i.default for i in code.inputs})
        if math.isfinite(result.default) and abs(result.default) < 1e9:
            assert found == pytest.approx(result.default, rel=1e-7, abs=1e-9), result.name
            compared += 1
    return compared


def test_chains_with_right_angles():
    tried = list(squared_chains(range(95000000, 95000004)))
    assert len(tried) > 1
    assert sum(hold_at_the_values_given(c) for _, c in tried) > 6


@pytest.mark.parametrize(
    ("seed", "name", "near"),
    [
        (95000018, "t1", 5.4979),
        pytest.param(97000004, "t2", 2.3561, marks=pytest.mark.slow),
    ],
)
def test_where_two_links_lie_on_a_line_square_to_the_guide_the_drive_moves_them(seed, name, near):
    """There forces are small against the load, and no fold ends their branch: it was said to jam.

    From steps that became short that was concluded; by arcs the branch is followed to its end.
    A pin has no slip at the values given, whatever these angles: the page says nothing along them.
    """
    ((_, compilation),) = squared_chains(range(seed, seed + 1))
    study, named = FrictionStudy(compilation.solution), "k_f" if seed % 2 else "k_hold"
    held = next(r for r in compilation.solution.results if r.name == named)
    (reach,) = (r for r in locking(study, held, as_printed(held)).reaches if r.parameter == name)
    assert not [s for s in reach.stretches if s.state == "jammed"]
    ratios = Ratios(compilation, held)
    assert set(ratios.states({name: near + np.linspace(-5e-5, 5e-5, 7)})) == {0}


def test_where_all_lies_on_a_line_square_to_the_guide_no_motion_is_determined():
    """Both links may turn there as far as velocities go; rounded cosines of 270° said otherwise."""
    written = squared(chain(95000089), RIGHT)
    with pytest.raises(MechcError) as caught:
        _ = Compilation(Source("square.mech", written)).results
    assert "E508" in {d.code for d in caught.value.diagnostics}


@pytest.mark.slow
def test_many_chains_with_right_angles():
    tried = (range(95000001, 95000002), range(95000020, 95000030))
    for seed, compilation in (one for seeds in tried for one in squared_chains(seeds)):
        hold_at_the_values_given(compilation)
        assert list(refuted(compilation)) == [], seed
