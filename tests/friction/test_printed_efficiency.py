"""Efficiencies as they are printed: the textbook's quotient where it is no longer than k_f is."""

import pytest

from mechc.compilation import Compilation, compile_source
from mechc.formula.to_text import text
from mechc.formula.tree import Symbol
from mechc.formula.walk import symbols
from mechc.source import Source

WEDGE = """
mechanism wedge
param beta = 10 deg in 5 deg .. 30 deg
param rho = 2 deg in 0 deg .. 8 deg
slide KW along x
slide AB along y
contact A on KW normal 90 deg - beta
force P at K along x
force N at B along -y
friction contact A tan(rho)
"""

LEVER = """
mechanism lever
param a = 60 mm
param b = 150 mm
pivot O
link AOB
OA = a @ 0 deg
OB = b @ 180 deg
force P at B along -y
force F at A along -y
friction pins 0.15 diameter 16 mm
find k = P/F
"""

TOGGLE = """
mechanism toggle
param a = 100 mm
param b = 250 mm
param alpha = 30 deg in 10 deg .. 60 deg
pivot O
slider K along y
link OBA
link BK
OB = a @ 0 deg
OA = b @ 0 deg
BK = 120 mm @ 90 deg + alpha
force P at A along y
force F at K along -y
friction pins 0.1 diameter 20 mm
find k = P/F
"""


def efficiency(description: str) -> tuple[str, set[str]]:
    """Return the printed efficiency and the names that it rests on."""
    results = compile_source(Source("printed.mech", description)).derivation.results
    found = next(r for r in results if r.name.startswith("eta"))
    return text(found.formula), {d.name for d in found.where}


@pytest.mark.parametrize("asked", ["find k = P/N", "motion releasing\nfind n = N/P"])
def test_it_has_the_angle_of_friction_and_not_the_ratio(asked):
    printed, names = efficiency(WEDGE + asked)
    assert printed == "tan(beta)/tan(beta + rho)"
    assert not names & {"k_f", "n_f"}


@pytest.mark.parametrize(("description", "printed"), [(LEVER, "a/(b*k_f)"), (TOGGLE, "a/(b*k_f)")])
def test_a_longer_one_keeps_the_ratio(description, printed):
    assert efficiency(description)[0] == printed


@pytest.mark.parametrize(("motion", "operator"), [("tightening", ">="), ("releasing", "<=")])
def test_at_a_zero_of_the_ratio_an_efficiency_holds_as_it_is_printed(motion, operator):
    """F acts through O: k is 0, all that P does is friction's, and 0 is not more than 0."""
    described = f"""
param phi = 0 deg
pivot O
link OAB
OA = 100 mm @ phi
OB = 300 mm @ 90 deg
force P at B along 180 deg
force F at A along 0 deg
friction pins 0.1 diameter 10 mm
motion {motion}
find k = P/F
"""
    results = {r.name: r for r in Compilation(Source("lever.mech", described)).results}
    eta = results["eta_k"]
    assert (eta.default, results["k"].default) == (0, 0)
    assert [h.operator for h in eta.holds if h.left == Symbol("k")] == [operator]
    assert symbols(eta.formula) == {"k_f", "phi"}
