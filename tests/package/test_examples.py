"""The examples run, compile without a warning, and are laid out as fmt lays them out."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import mechc
from mechc.cli import main
from paths import ROOT

EXAMPLES = ROOT / "examples"
DESCRIPTIONS = sorted(p for p in EXAMPLES.iterdir() if p.suffix in {".mech", ".yaml"})


@pytest.mark.parametrize("path", DESCRIPTIONS, ids=lambda p: p.name)
def test_description(path: Path) -> None:
    assert mechc.load(path).warnings == []
    assert main(["fmt", "--check", str(path)]) == 0


def test_both_notations_of_the_clamp_say_the_same() -> None:
    mech, yaml = (mechc.load(EXAMPLES / f"clamp.{s}") for s in ("mech", "yaml"))
    assert mech.k == yaml.k
    assert mech.defaults == yaml.defaults


def test_crank_puller_is_the_textbook_slider_crank() -> None:
    import sympy

    crank = mechc.load(EXAMPLES / "crank_puller.mech")
    r, rod, phi = sympy.symbols("r l phi")
    beta = sympy.asin(r / rod * sympy.sin(phi))
    at = {r: 0.06, rod: 0.24, phi: 1.2217304763960306}
    expected = (r * sympy.sin(phi + beta) / sympy.cos(beta)).subs(at)
    assert crank.evaluate()["k"] == pytest.approx(float(expected), rel=1e-12)


def test_use_from_python() -> None:
    done = subprocess.run(
        [sys.executable, str(EXAMPLES / "use_from_python.py")],
        env={**os.environ, "PYTHONPATH": str(ROOT / "compiler")},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "k = a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))" in done.stdout
    assert "k at the default pose = 0.067068" in done.stdout
    assert "E" in done.stdout.splitlines()[-1]
