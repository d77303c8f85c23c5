"""The examples run, compile without a warning, and are laid out as fmt lays them out."""

import csv
import io
import math
import os
import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import mechc
from mechc.cli import main
from paths import ROOT
from seed_friction import entries

EXAMPLES = ROOT / "examples"
DESCRIPTIONS = sorted(p for p in EXAMPLES.rglob("*") if p.suffix in {".mech", ".yaml"})


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


def test_the_gripper_from_the_part_to_the_cylinder() -> None:
    """By hand: four faces hold by friction; R_O and N_KA balance the finger without friction."""
    gripper = mechc.load(EXAMPLES / "gripper" / "gripper.mech")
    found = gripper.evaluate(L_f=0.0)
    force = 2 * (9.81 + 2) * 1.5 * math.sin(math.pi / 3) / (2 * 0.15)
    assert 4 * 0.15 * found["N"] == pytest.approx(2 * (9.81 + 2) * 1.5)
    arm = 10 * 0.78086881 + 15 * 0.62469505  # of the rod about O, in mm
    rod = force * 60 / arm
    assert found["L_N_KA_f"] == pytest.approx(-rod)
    assert found["L_P_f"] == pytest.approx(2 * rod * 0.78086881)
    reaction = math.hypot(force + rod * 0.62469505, rod * 0.78086881)
    assert found["L_R_O_f"] == pytest.approx(reaction)
    assert found["pivot_pin_d_min"] == pytest.approx(math.sqrt(4 * reaction / (math.pi * 75e6)))
    assert (found["cyl_d"], found["s"]) == (0.04, 0.025)
    assert math.isnan(gripper.evaluate(tau_a=5e6)["pivot_pin_d_min"])


def printed(script: str) -> str:
    """Return the output of an example in Python."""
    return subprocess.run(
        [sys.executable, str(EXAMPLES / script)],
        env={**os.environ, "PYTHONPATH": str(ROOT / "compiler")},
        capture_output=True,
        text=True,
        check=True,
    ).stdout


def test_use_from_python() -> None:
    out = printed("use_from_python.py")
    assert "k = a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))" in out
    assert "k at the default pose = 0.067068" in out
    assert "E" in out.splitlines()[-1]


def test_figures_of_prism_jaws() -> None:
    """Every point that is known of the 31 printed curves is in the table."""
    table = {
        (row["figure"], *(float(row[angle]) for angle in ("alpha", "beta", "phi"))): row
        for row in csv.DictReader(io.StringIO(printed("hodunko-2019/figures.py")))
    }
    for seed, entry in entries("values.json").items():
        if not seed.startswith("S001-F"):
            continue
        _, figure, curve = seed.split("-")
        for point in entry["points"]:
            at = (round(math.degrees(point["inputs"][a])) for a in ("alpha", "beta", "phi"))
            found = float(table[figure[1:], *at][column(curve)])
            assert found == pytest.approx(point["value"], abs=1e-8), seed


def column(curve: str) -> str:
    """Return the column of a curve; the two faces on one side have one additional force."""
    sides = {"dP1": "dP_far", "dP2": "dP_near"}
    return sides.get(curve) or f"{curve[:-1]}_{curve[-1]}".replace("Pp_", "P_p")


def test_least_forces_of_prism_jaws() -> None:
    """The paper's forces are the least ones for a weight alone; else friction allows less."""
    script = runpy.run_path(str(EXAMPLES / "hodunko-2019" / "least_forces.py"))
    rows = {int(row[0]): [float(value) for value in row[1:]] for row in list(script["rows"]())[1:]}
    assert rows[10] == pytest.approx([94.3914, 81.5532], abs=1e-4)
    assert all(least < paper for paper, least in rows.values())
    given = {"alpha": 2.0, "beta": 0.0, "phi": 0.1, "G": 20.0, "I": 5.0, "f": 0.1}
    paper = mechc.load("prism_jaws").evaluate(**given)["P_c"]
    assert script["least"](**given) == pytest.approx(paper, rel=1e-12)


@pytest.mark.slow
def test_least_forces_are_those_of_a_linear_programme() -> None:
    """With normal forces and friction apart, as a solver of linear programmes takes them."""
    script = runpy.run_path(str(EXAMPLES / "hodunko-2019" / "least_forces.py"))
    dice = np.random.default_rng(3)
    for _ in range(200):
        alpha, beta, phi = np.radians(dice.uniform([80, 0, -10], [150, 180, 10]))
        G, I, f = dice.uniform([1, 0, 0.02], [50, 50, 0.6])  # noqa: E741
        found = script["least"](alpha, beta, phi, G, I, f)
        assert found == pytest.approx(by_linear_programme(alpha, beta, phi, G, I, f), rel=1e-12)


def by_linear_programme(
    alpha: float, beta: float, phi: float, weight: float, inertia: float, f: float
) -> float:
    below, above = alpha / 2 + phi, alpha / 2 - phi
    across = np.array([np.sin(below), np.sin(above), -np.sin(below), -np.sin(above)])
    upright = np.array([np.cos(below), -np.cos(above), np.cos(below), -np.cos(above)])
    balances = np.block([[across, -upright], [upright, across], [np.zeros(4), np.ones(4)]])
    loads = [-inertia * np.sin(beta), weight + inertia * np.cos(beta), 0.0]
    cones = np.block([[-f * np.eye(4), np.eye(4)], [-f * np.eye(4), -np.eye(4)]])
    cost, bounds = np.repeat([1.0, 0.0], 4), [(0, None)] * 4 + [(None, None)] * 4
    linprog = pytest.importorskip("scipy.optimize").linprog
    solved = linprog(cost, cones, np.zeros(8), balances, loads, bounds)
    assert solved.status == 0
    return float(solved.fun)
