"""Ranges of parameters: their ends, and the value between them."""

from contextlib import suppress

import pytest

from mechc.diagnostics import MechcError
from mechc.driver import Compilation
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
    ("param", "what"),
    [
        ("m in -1 kg .. 2 kg", "mass"),
        ("c in -1 N/mm .. 2 N/mm", "stiffness"),
        ("m in 0 kg .. 2 kg", ""),
        ("c in 0 N/mm .. 2 N/mm", ""),
        ("s in -1 mm .. 2 mm", ""),
    ],
)
def test_no_mass_and_no_stiffness_is_negative_within_a_range(param, what):
    found = said(param)
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
