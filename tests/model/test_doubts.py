"""Remarks on loads that stand for friction: which are made, and which are not."""

import pytest

from mechc.driver import Compilation
from mechc.source import Source

LEVER = """
param mu = 0.2
param a = 100 mm
pivot O
link OA
OA = a @ 0 deg
force N at A along -y
torque M on OA
find k = M/N
friction pin O 0.1 diameter 10 mm
"""


@pytest.mark.parametrize(
    ("load", "is_friction"),
    [
        ("force T = mu*N at A along x", True),
        ("force T = mu*N at A along perp OA", False),  # along y, as N is
        ("force T = mu*N at A along y", False),
        ("force T = N/5 at A along x", False),  # a number is no coefficient
        ("force T = mu*N at O along x", False),
    ],
)
def test_a_share_of_a_force_across_it_looks_like_friction(load: str, is_friction: bool) -> None:
    compilation = Compilation(Source("lever.mech", f"{LEVER}{load}\n"))
    assert compilation.mechanism
    codes = [d.code for d in compilation.report.diagnostics]
    assert ("W206" in codes) == is_friction


def test_without_friction_elsewhere_nothing_is_remarked_upon() -> None:
    text = LEVER.replace("friction pin", "# friction pin") + "force T = mu*N at A along x\n"
    compilation = Compilation(Source("lever.mech", text))
    assert compilation.mechanism
    assert "W206" not in [d.code for d in compilation.report.diagnostics]
