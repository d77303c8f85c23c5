"""Ranges of parameters: their ends, and the value between them."""

from contextlib import suppress

import pytest

import mechc
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.source import Source
from small_mechanisms import lever


def said(param: str) -> list[str]:
    """Return the messages about a lever beside which a parameter is declared."""
    text = lever(f"param {param}", f"let used = {param.partition(' ')[0]}")
    compilation = Compilation(Source("lever.mech", text))
    with suppress(MechcError):
        assert compilation.mechanism
    return [d.message for d in compilation.report.diagnostics]


@pytest.mark.parametrize(
    ("param", "used", "what"),
    [
        ("m in -1 kg .. 2 kg", "weight W mass m at A", "mass"),
        ("m in 0 kg .. 2 kg", "weight W mass m at A", ""),
        ("m in -1 kg .. 2 kg", "let used = m", ""),
        ("c in -1 N/mm .. 2 N/mm", "spring c between A and B free 20 mm", "rate of a spring"),
        ("c in 0 N/mm .. 2 N/mm", "spring c between A and B free 20 mm", ""),
        ("c in -1 N/mm .. 2 N/mm", "let used = c", ""),
    ],
)
def test_no_mass_and_no_rate_of_a_spring_is_negative_within_a_range(param, used, what):
    compilation = Compilation(Source("lever.mech", lever(f"param {param}", used)))
    with suppress(MechcError):
        assert compilation.mechanism
    found = [d.message for d in compilation.report.diagnostics if d.code == "E235"]
    assert len(found) == bool(what)
    assert all(what in message for message in found)


@pytest.mark.parametrize(
    ("param", "is_wrong"),
    [
        ("s = 2 mm in 1 mm .. 3 mm", False),
        ("s = 1 mm in 1 mm .. 3 mm", False),
        ("s = 3 mm in 1 mm .. 3 mm", False),
        ("s = 4 mm in 1 mm .. 3 mm", True),
        ("s = 0 mm in 1 mm .. 3 mm", True),
        ("s in 3 mm .. 1 mm", True),
        ("s in 1 mm .. 1 mm", True),
    ],
)
def test_a_range_goes_up_and_holds_the_value(param, is_wrong):
    assert len(said(param)) == is_wrong


def test_what_has_the_unit_of_a_stiffness_or_a_mass_may_be_negative_where_it_is_none():
    sheet = mechc.loads("""
sheet flow
param q = 5 N/mm in -10 N/mm .. 10 N/mm
param m = 1 kg in -3 kg .. 3 kg
param l = 20 mm
let F = q*l
let n = 2*m
""")
    assert sheet.evaluate(q=-1000.0)["F"] == pytest.approx(-20.0)
