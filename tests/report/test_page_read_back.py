"""Every formula of a report, read back with numbers, gives what code gives."""

from random import Random

import pytest

from force_mechanisms import given
from force_samples import pushing
from friction_mechanisms import closed
from good_mechanisms import ALL, compiled
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.emit.latex.to_latex import TARGET as LATEX
from mechc.emit.target import Options
from mechc.source import Source
from page import Page

QUICK = ("fedoriv_fig2a_with_friction", "d45_16_wedge_hook_with_friction", "tongs_fig4_9_forces")
"""Mechanisms in which names would have two meanings, did nothing tell them apart."""

SPREAD = """
mechanism boom
pivot O at (0 m, 0 m)
pivot C at (0 m, -1 m)
link OBD
telescope CB
B at (1.2 m, 0.3 m)
D at (1.7 m, 0.4 m)
param c_Q = 1.5 m
param Z1 = 2.5 m
force G at D along -y
load Q intensity 1200 N/m on OB along -y
actuator P between C and B
friction pins 0.12 diameter 50 mm
find P
find R_O
let U = c_Q*P + Z1*G
"""


def wrong(text: str) -> list[str]:
    return list(Page(Compilation(Source("page.mech", text))).wrong())


def test_a_long_load_with_friction_is_not_given_by_coefficients_without():
    assert wrong(SPREAD) == []


def test_an_efficiency_of_either_side_that_drives_is_not_said_to_be_that_of_one():
    """k is negative here, and k/k_f = 1.03 was said to be the efficiency, 0.97."""
    assert wrong(closed(99100574)) == []


PERPENDICULAR = """
param t1 = 0 deg in -50 deg .. 60 deg
param t2 = 210 deg in 130 deg .. 300 deg
param t3 = 285 deg in 200 deg .. 350 deg
pivot O
slider A along 15 deg
link AB
link OBC
AB = 74.3 mm @ t1
OB = 53.5 mm @ t2
OC = 75.5 mm @ t3
force P at A along 15 deg
force F at C along 285 deg
friction pins 0.156 diameter 13.5 mm
friction slider A 0.160
find k = P/F
"""


def test_the_sign_of_a_force_that_friction_alone_makes_is_put_into_no_formula():
    """F points at O: without friction AB bears nothing, and sgn 0 gave -0.0377, not -0.0432."""
    compilation = Compilation(Source("page.mech", PERPENDICULAR))
    assert list(Page(compilation).wrong()) == []
    (document,) = LATEX.emit(compilation, Options("page"))
    numbers = document.text.partition("Numerical values")[2]
    assert r"k_{\mathrm{hold}}&=-0.0432368" in numbers
    assert r"\operatorname{sgn}" not in numbers


def test_a_formula_that_does_not_hold_at_the_values_given_is_said_not_to():
    """Next to them it does."""
    compilation = Compilation(Source("page.mech", PERPENDICULAR))
    assert [r.name for r in compilation.results if r.fails_here] == ["k_hold"]
    beside = Compilation(Source("page.mech", PERPENDICULAR.replace("285 deg in", "284 deg in")))
    assert not any(r.fails_here for r in beside.results)


@pytest.mark.parametrize("name", QUICK)
def test_a_report_says_what_code_computes(name: str):
    assert list(Page(compiled(name)).wrong()) == []


def test_a_wrong_report_is_seen():
    page = Page(compiled("fedoriv_fig2a_with_friction"))
    page.tex = page.tex.replace(r"\boxed{k_f=2\tan(\alpha+", r"\boxed{k_f=2\tan(\alpha-")
    assert [text.split()[0] for text in page.wrong()] == ["k_f"]


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(ALL.keys() - set(QUICK))[::2])
def test_every_second_report_says_what_code_computes(name: str):
    assert list(Page(compiled(name)).wrong()) == []


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(92000, 92010))
def test_reports_of_random_mechanisms_say_what_code_computes(seed: int):
    sample = pushing(given(seed, 1 + seed % 2, ratio=bool(seed % 3)))
    if sample is None:
        return
    try:
        assert wrong(sample.with_friction(Random(seed), said=bool(seed % 2))) == []
    except MechcError:
        return


def test_an_efficiency_of_nothing_is_no_negative_ratio():
    sample = pushing(given(92026, 1))
    assert sample is not None
    assert wrong(sample.with_friction(Random(92026), said=False)) == []


ONE_ITERATED = """
pivot A
link AB
AB = 109.5 mm @ 174.8 deg
pivot C
link CD
CD = 50.7 mm @ -134.5 deg
gear C 19.5 mm, A 57.2 mm inner
pivot E
link EG
EG = 121.3 mm @ -10.4 deg
gear E 18.1 mm, C 40.5 mm inner
slider H along -34 deg
screw H pitch 3.4 mm on EG
torque P on AB times 2
force F at H along -68.1 deg
find k = P / F
friction gear C 0.055
friction gear E 0.079
friction screw H 0.119 thread 12 mm
"""


def test_forces_that_one_result_iterates_and_another_solves_for_have_two_names():
    """k_f is found by iteration and k_hold in steps: n of the screw stood for either."""
    compilation = Compilation(Source("screw.mech", ONE_ITERATED))
    assert any(r.name == "k_f" and r.inside for r in compilation.results)
    page = Page(compilation)
    assert r"n_{H,\mathrm{screw},\mathrm{hold}}" in page.tex
    assert list(page.wrong()) == []
