"""What a report says of ratios along the stroke, and over ranges, against dense sampling."""

import math
import re

import numpy as np
import pytest

from extents import along, curve, refuted
from grown import Grown, wide, without_drive
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.formula.tree import Symbol
from mechc.report.text.derivation import render
from mechc.source import Source
from mechc.study.analysis import Vanishing
from mechc.study.stroke.ratio_extent import vanishing
from mechc.study.stroke.stroke import StrokeInterval
from mechc.work import Allowance
from paths import LIBRARY


def of_library(name):
    return Compilation(Source(name, (LIBRARY / name).read_text(encoding="utf-8")))


def hold(seeds, changed=lambda description: description):
    stated = 0
    for seed in seeds:
        grown = Grown(seed)
        if "triad" in grown.kinds:
            continue
        compilation = Compilation(Source("grown.mech", changed(wide(grown))))
        try:
            stated += sum(len(r.extents) for r in compilation.reported.results)
        except MechcError:
            continue
        assert list(along(compilation)) == [], seed
    return stated


def test_the_least_force_of_the_claw_is_where_the_paper_has_it():
    k = of_library("claw_closed.mech").reported.results[0]
    (extent,) = k.extents
    assert extent.least[:2] == pytest.approx((1.380557799745, 1.372773669854), rel=1e-9)
    assert extent.zeros == extent.poles == ()


def test_a_ratio_that_turns_in_a_range_is_least_and_greatest_where_it_is_said_to_be():
    compilation = of_library("toggle_press.yaml")
    (k,) = compilation.reported.results
    assert [e.parameter for e in k.extents if not e.is_monotone] == ["phi"]
    assert list(along(compilation)) == []
    said = " ".join(render(compilation.reported, compilation.mechanism, unicode=False).split())
    assert "the least k is 4.1915 mm, at phi = 150 deg" in said


SQUARE_AT_THE_START = """
param a = 50 mm
param b = 90 mm
param phi = 120 deg in 90 deg .. 165 deg
drive phi from 90 deg to 165 deg
pivot O at (0 mm, 0 mm)
link OA
link AK
slider K along y through O
OA = a @ phi
AK = b
assembly K forward
load F intensity 2 N/mm on OA along -y
force M at K along y
find k = M/F
"""


def test_a_ratio_that_is_rounding_at_an_end_is_what_it_comes_to_there():
    """Neither load moves at 90 deg: the formula is 0/0 there, and k comes to b/(2 (a + b))."""
    compilation = Compilation(Source("square.mech", SQUARE_AT_THE_START))
    (k,) = compilation.reported.results
    (extent,) = k.extents
    assert extent.least[:2] == pytest.approx((math.pi / 2, 9 / 28), rel=1e-9)
    assert list(along(compilation)) == []


def test_a_ratio_of_speeds_is_followed_as_one_of_loads_is():
    compilation = of_library("triple_rocker.mech")
    k, i = compilation.reported.results
    (extent,) = i.extents
    assert extent.looked
    assert extent.zeros == extent.poles == ()
    assert (extent.least.x, extent.greatest.x) == (k.extents[0].least.x, k.extents[0].greatest.x)
    assert list(along(compilation)) == []
    rocker = of_library("crank_rocker.mech").reported.results
    zeros = [result.extents[0].zeros for result in rocker]
    assert zeros[0] == pytest.approx(zeros[1])


def test_what_is_said_along_random_strokes():
    assert hold(range(6)) > 1


@pytest.mark.slow
def test_what_is_said_along_many_random_strokes():
    assert hold(range(4, 22)) > 3


def test_a_loop_is_followed_along_a_range_as_along_a_stroke():
    path = LIBRARY / "crank_rocker.mech"
    text = re.sub(r" in \d+ deg \.\. \d+ deg", "", path.read_text(encoding="utf-8"))
    driven, ranged = (
        Compilation(Source("a.mech", t)).reported.results[0] for t in (text, without_drive(text))
    )
    (found,), (expected,) = ranged.extents, driven.extents
    assert found.least[:2] == pytest.approx(expected.least[:2])
    assert found.greatest[:2] == pytest.approx(expected.greatest[:2])
    for size in ("least", "greatest"):
        found, expected = (replace(e, **{size: None}) for e in (found, expected))
    assert found == expected


def test_what_is_said_along_random_ranges():
    assert hold(range(40, 44), without_drive) > 1


@pytest.mark.slow
def test_what_is_said_along_many_random_ranges():
    assert hold(range(44, 62), without_drive) > 3


IDLE = """
pivot O at (0 mm, 0 mm)
slider B along x through O
link OAC
link AB
param phi = 90 deg in 10 deg .. 170 deg
OA = 50 mm @ phi
OC = 80 mm @ phi + 40 deg
AB = 48 mm
assembly B forward
torque M on OAC
force F at C along x
find k = M/F
"""
"""The rod closes from 10 deg to 73.7 deg and from 106.3 deg on; k does not rest on it."""


def test_nothing_is_least_where_a_loop_does_not_close():
    compilation = Compilation(Source("idle.mech", IDLE.replace("90 deg in", "60 deg in")))
    (k,) = compilation.reported.results
    assert k.extents == ()
    closed = Compilation(Source("idle.mech", IDLE.replace("48 mm", "52 mm")))
    (extent,) = closed.reported.results[0].extents
    assert extent.range == pytest.approx(np.radians((10, 170)))


def test_the_sampler_refutes_what_is_false():
    compilation = of_library("crank_rocker.mech")
    k = compilation.reported.results[0]
    (extent,) = k.extents
    at = curve(compilation, "k", "phi")
    assert list(refuted(extent, at)) == []
    assert list(refuted(replace(extent, zeros=()), at))
    assert list(refuted(replace(extent, least=extent.greatest), at))
    assert list(refuted(replace(extent, zeros=(*extent.zeros, 1.234)), at))
    assert list(refuted(replace(extent, poles=extent.zeros), at))


def test_a_report_goes_without_what_would_take_too_much_work(monkeypatch):
    compilation = of_library("crank_rocker.mech")
    assert compilation.derivation.results
    monkeypatch.setattr("mechc.compilation.Allowance", lambda: Allowance(100))
    assert compilation.reported == compilation.derivation
    assert not compilation.report.diagnostics


def test_every_place_of_an_extreme_is_named():
    """Hoeken's straight line is alike on both sides of its middle."""
    (extent,) = of_library("hoeken.yaml").reported.results[0].extents
    places = [(e.x, *e.again) for e in (extent.least, extent.greatest)]
    assert np.degrees(places[0]) == pytest.approx((100, 260), abs=1e-3)
    assert sum(np.degrees(places[1])) == pytest.approx(360, abs=1e-3)
    assert len(places[1]) == 2


def test_a_ratio_that_turns_within_the_first_cell_of_a_range_is_greatest_there():
    """The end is larger than the next place that is looked at, and less than what lies between."""
    compilation = Compilation(
        Source(
            "contact.mech",
            """
            param t1 = -5.8 deg in -45.8 deg .. 34.2 deg
            pivot A
            link AB
            AB = 99.3 mm @ t1
            pivot C
            contact B on CD normal -135.6 deg
            link CD
            CD = 53.7 mm @ -52.3 deg
            CB = 81.4 mm @ -39.9 deg
            torque P on AB
            force F at D along -108 deg
            find k = P / F
            """,
        )
    )
    (extent,) = compilation.reported.results[0].extents
    assert np.degrees(extent.greatest.x) == pytest.approx(-45.6, abs=1e-5)
    assert list(along(compilation)) == []


def test_what_refining_leaves_of_a_double_zero_is_zero():
    """k = l_2/l_1·sin(t/2)·sin 2t: 4e-46 is no value of it."""
    chain = Compilation(
        Source(
            "chain.mech",
            "param t = -7.3 deg in -22.8 deg .. 17.2 deg\nparam l1 = 115 mm\nparam l2 = 105 mm\n"
            "slider A along t + 180 deg\nforce P at A along t + 180 deg\nlink AB\n"
            "AB = @ -t + 90 deg\npivot C\nlink BCD\nCB = l1 @ -t\nCD = l2 @ -1/2*t\n"
            "force F at D along 0 deg\nfind k = P/F\n",
        )
    )
    (k,) = chain.reported.results
    assert [extent.least.value for extent in k.extents] == [0]


LEANING = """
param a = 100 mm in 50 mm .. 150 mm
param b = 60 mm
param alpha = 20 deg in 10 deg .. 40 deg
param beta = 30 deg in 5 deg .. {most}
pivot O
link OAB
OA = a @ alpha
OB = b @ 0 deg
force P at A along -y
force F at B along beta
find k = P/F
"""


def leaning(most="60 deg"):
    """k = b·sin(beta)/(a·cos(alpha)), which rises with both angles."""
    (k,) = Compilation(Source("m.mech", LEANING.format(most=most))).reported.results
    return k


def test_a_ratio_that_rises_has_its_values_at_both_ends_of_each_range():
    first, second = leaning().extents
    assert [e.parameter for e in (first, second)] == ["alpha", "beta"]
    assert first.is_monotone
    assert second.is_monotone
    at = [0.6 * math.sin(math.radians(30)) / math.cos(math.radians(x)) for x in (10, 40)]
    assert (first.least.value, first.greatest.value) == pytest.approx(at, rel=1e-12)
    ends = (second.least.x, second.greatest.x)
    assert ends == pytest.approx((math.radians(5), math.radians(60)), rel=1e-12)


def test_a_ratio_that_turns_in_a_range_has_no_values_at_its_ends():
    """sin(beta) is greatest at 90 degrees."""
    turning, monotone = leaning("150 deg").extents
    assert (turning.parameter, turning.is_monotone) == ("beta", False)
    assert (monotone.parameter, monotone.is_monotone) == ("alpha", True)
    assert turning.greatest.x == pytest.approx(math.radians(90), abs=1e-6)


def test_values_at_ends_hold_to_samples():
    compilation = Compilation(Source("m.mech", LEANING.format(most="60 deg")))
    assert list(along(compilation)) == []


@pytest.mark.parametrize(
    ("load", "expected"), [("90 deg", [(0.0, 1.0)]), ("0 deg", [])], ids=["zero", "infinite"]
)
def test_rounding_at_an_end_is_zero_or_infinite(load, expected):
    """Of a lever at 90 degrees: 6e-17 and 2e16 were printed for cos 90 deg and its inverse."""
    lever = f"""
        param t = 30 deg in 0 deg .. 90 deg
        pivot O
        link OAB
        OA = 100 mm @ t
        OB = 100 mm @ {load}
        force P at A along {"y" if load == "0 deg" else "perp OA"}
        force F at {"B along -y" if load == "0 deg" else "A along -y"}
        find k = P/F
    """
    (k,) = Compilation(Source("lever.mech", lever)).reported.results
    assert [(e.least.value, e.greatest.value) for e in k.extents] == expected


def test_values_at_both_ends_stand_in_one_sentence():
    compilation = Compilation(Source("m.mech", LEANING.format(most="60 deg")))
    said = " ".join(render(compilation.reported, compilation.mechanism).split())
    assert (
        "With the rest at the values given, k is 0.30463 at α = 10° and 0.39162 at α = 40°; "
        "0.05565 at β = 5° and 0.55296 at β = 60°." in said
    )


def test_where_there_is_no_rest_nothing_is_said_of_its_values():
    lever = """
        param t = 30 deg in 0 deg .. 60 deg
        pivot O
        link OA
        OA = 100 mm @ t
        force P at A along perp OA
        force F at A along -y
        find k = P/F
    """
    compilation = Compilation(Source("lever.mech", lever))
    said = " ".join(render(compilation.reported, compilation.mechanism).split())
    assert "- k is 1 at t = 0° and 0.5 at t = 60°." in said


def test_a_telescope_without_a_drive_is_followed_along_its_range():
    """The boom is in line with the load's path at s = √(c² + r²): there k is zero."""
    text = (LIBRARY / "oscillating_cylinder.mech").read_text()
    still = re.sub(r"(?m)^drive .*\n", "", text)
    compilation = Compilation(Source("m.mech", still))
    (k,) = compilation.reported.results
    (extent,) = k.extents
    assert (extent.parameter, extent.unit, extent.looked) == ("s", "mm", True)
    assert extent.range == pytest.approx((0.4, 0.9))
    assert extent.zeros == pytest.approx((math.hypot(0.6, 0.4),), rel=1e-9)
    assert list(along(compilation)) == []
    said = " ".join(render(compilation.reported, compilation.mechanism).split())
    assert "For 400 ≤ s ≤ 900 mm, the rest at the values given, k is 0 at s = 721.1 mm" in said


def test_a_side_of_a_link_is_not_followed_along_its_range():
    """Its length is a size to be chosen: nothing moves along it."""
    text = (LIBRARY / "oscillating_cylinder.mech").read_text()
    rigid = re.sub(r"(?m)^drive .*\n", "", text)
    sized = rigid.replace("param r = 400 mm", "param r = 400 mm in 350 mm .. 450 mm")
    assert sized != rigid
    (k,) = Compilation(Source("m.mech", sized)).reported.results
    assert [e.parameter for e in k.extents] == ["s"]


class Curves:
    """Values of factors along a stroke, as functions of the drive."""

    def __init__(self, **curves):
        self._curves = curves

    def of(self, factor, result, x):
        return self._curves[factor.name](x)


def tied(places, *names, **curves):
    limits = [Vanishing(Symbol(name), None, "other") for name in names]
    part = StrokeInterval(0.0, 3.0, "", "")
    return {x: f.name for x, f in vanishing(places, limits, None, part, Curves(**curves))}


def test_a_place_belongs_to_the_only_factor_that_is_zero_there():
    curves = {"a": lambda x: 5 * (x - 1), "b": lambda x: 1e-4 * (x - 2)}
    assert tied((1.0, 2.0), "a", "b", **curves) == {1.0: "a", 2.0: "b"}


def test_a_place_at_which_two_factors_are_zero_belongs_to_none():
    curves = {"a": lambda x: x - 1, "b": lambda x: x * x - 1}
    assert tied((1.0,), "a", "b", **curves) == {}


def test_of_one_condition_nothing_is_tied():
    assert tied((1.0,), "a", a=lambda x: x - 1) == {}


FOLDED = """
param a = 50 mm
param b = 130 mm
param phi = 60 deg
drive phi from 55 deg to 65 deg
param r = 12 mm
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, 2*r)
link OA
link QD
link AB
link DB
OA = a @ phi
QD = a @ -phi
AB = b
DB = b
gear O r, Q r
assembly ABD cw
force F at B along y
torque M on OA
find k = M/F
"""


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "k is 0 at all places"),
        ("ru", "k равно нулю во всех проверенных положениях"),
        ("uk", "k дорівнює нулю в усіх"),
    ],
)
def test_of_what_is_zero_throughout_no_conditions_are_stated(language, said):
    """B moves along x, by symmetry; F is across it, whatever sin μ_B and cos φ are."""
    compilation = Compilation(Source("folded.mech", FOLDED))
    (found,) = compilation.reported.results
    assert found.zeros
    assert found.poles
    page = " ".join(render(compilation.reported, compilation.mechanism, language=language).split())
    assert said in page
    assert not re.search(r"vanish|infinite|обращается|бесконечн|прямує|нескінченн", page)


TURNING = """
param r = 50 mm
param l = 200 mm
param e = 10 mm
param phi = 60 deg
pivot O at (0 mm, 0 mm)
slider B along x through Q
link OA
link AB
pivot Q at (0 mm, e)
OA = r @ phi
AB = l
assembly B forward
drive phi from 1 deg to 100 deg
torque M on OA
force F at B along -x
let F = 100 N
find k = M/F
find N_B
find N_AB
"""


def test_where_a_force_changes_its_sense_is_stated_and_nothing_of_one_that_does_not():
    """The rod lies along the guide where r sin φ = e: there it presses the guide no longer."""
    reported = Compilation(Source("turning.mech", TURNING)).reported.results
    (along,) = next(r for r in reported if r.name == "N_B").extents
    assert along.zeros == pytest.approx([math.asin(10 / 50)])
    assert (along.least, along.greatest, along.looked) == (None, None, False)
    assert next(r for r in reported if r.name == "N_AB").extents == ()
