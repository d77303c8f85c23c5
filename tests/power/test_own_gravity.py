"""The letter g is the usual acceleration only where no parameter of that name is."""

import pytest

import mechc
from mechc.cli.check_lines import report
from mechc.compilation import compile_source
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.report.text.derivation import render
from mechc.source import Source

LEVER = """\
mechanism lever
param l = 1 m
param m = 3 kg
param alpha = 20 deg
{more}
pivot O
link OA
OA = l @ alpha
torque M on OA
weight W mass m at A
find M
"""
OWN = LEVER.format(more="param g = 1.62 m/s^2")
USUAL = LEVER.format(more="")
KILOGRAMS_FORCE = """\
mechanism lever
param l = 1 m
param n = 3
param alpha = 20 deg
pivot O
link OA
OA = l @ alpha
torque M on OA
force F at A along -90 deg
let F = n*1 kgf
find M
"""


def printed(text: str) -> list[str]:
    compilation = compile_source(Source("m.mech", text))
    (document,) = TARGET.emit(compilation, Options("m"))
    stated = render(compilation.derivation, compilation.mechanism)
    return ["\n".join(report(compilation, False)), stated, document.text]


@pytest.mark.parametrize("place", range(3))
def test_ones_own_g_is_not_called_the_usual_one(place):
    assert "9.80665" not in printed(OWN)[place]
    assert "9.80665" in printed(USUAL)[place]


def test_what_is_printed_of_ones_own_g_is_what_computes():
    assert mechc.loads(OWN).evaluate()["M"] == pytest.approx(3 * 1.62 * 0.9396926208)


def test_a_kilogram_force_is_no_weight():
    assert all("*g" not in text and "g =" not in text for text in printed(KILOGRAMS_FORCE)[:2])
