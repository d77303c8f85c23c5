"""Trusses and frames, in which nothing moves: forces against statics by hand on coordinates."""

import numpy as np
import pytest

import mechc
from mechc.compilation import compile_source
from mechc.source import Source

PLACES = {"A": (0.0, 0.0), "B": (3.0, 0.4), "C": (1.0, 2.0), "D": (4.2, 1.7)}
RODS = ("AB", "AC", "BC", "CD", "BD")


def truss(places: dict[str, tuple[float, float]] = PLACES) -> str:
    lines = ["pivot A", "slider B along 20 deg", *(f"link {rod}" for rod in RODS)]
    lines += [f"{p} at ({x} m, {y} m)" for p, (x, y) in places.items()]
    lines += ["force F at D along 250 deg", "force H at C along x"]
    lines += [f"find N_{rod}" for rod in RODS] + ["find R_A", "find N_B"]
    return "\n".join(lines) + "\n"


def joint_by_joint(f: float, h: float) -> dict[str, float]:
    """Return the forces by the method of joints: two equations for each, solved at once."""
    names = [*(f"N_{rod}" for rod in RODS), "R_A_x", "R_A_y", "N_B"]
    matrix, right = np.zeros((8, 8)), np.zeros(8)
    rows = {point: 2 * i for i, point in enumerate(PLACES)}
    for column, rod in enumerate(RODS):
        tail, head = (np.array(PLACES[p]) for p in rod)
        along = (head - tail) / np.linalg.norm(head - tail)
        for point, push in ((rod[0], along), (rod[1], -along)):
            matrix[rows[point] : rows[point] + 2, column] = push
    matrix[rows["A"], 5] = matrix[rows["A"] + 1, 6] = 1
    across = np.radians(20 + 90)
    matrix[rows["B"] : rows["B"] + 2, 7] = np.cos(across), np.sin(across)
    line = np.radians(250)
    right[rows["D"] : rows["D"] + 2] = -f * np.cos(line), -f * np.sin(line)
    right[rows["C"]] = -h
    return dict(zip(names, np.linalg.solve(matrix, right), strict=True))


@pytest.mark.parametrize(("f", "h"), [(1.0, 0.0), (0.0, 1.0), (700.0, -250.0)])
def test_a_truss_of_five_rods(f: float, h: float) -> None:
    found = mechc.loads(truss(), "truss.mech").evaluate(F=f, H=h)
    wanted = joint_by_joint(f, h)
    size = max(map(abs, wanted.values()))
    assert {n: found[n] for n in wanted} == pytest.approx(wanted, rel=1e-11, abs=1e-12 * size)


def test_the_referee_judges_a_truss() -> None:
    verdict = compile_source(Source("truss.mech", truss())).verdict
    assert verdict.agrees
    assert {trial.result for trial in verdict.trials} >= {"N_AB/F", "N_CD/F", "R_A_x/H"}


BEAM = """
param a = 2 m
param l = 5 m
pivot A
slider B along x
link ACB
AC = (a, 0)
AB = (l, 0)
force F at C along -y
torque M on ACB
find R_A, N_B
expect R_A_x = 0*F
expect R_A_y = F*(l - a)/l + M/l
expect N_B = F*a/l - M/l
"""


def test_a_beam_on_two_supports() -> None:
    findings = compile_source(Source("beam.mech", BEAM)).findings
    assert [finding.outcome for finding in findings] == ["proved"] * 3


def test_a_three_hinged_arch() -> None:
    """Span L, rise h, W at the crown: the thrust is W·L/(4h); H at the crown lifts one foot."""
    text = """
    param L = 8 m
    param h = 3 m
    pivot A
    pivot B
    link AC
    link BC
    AC = (L/2, h)
    BC = (-L/2, h)
    force W at C along -y
    find R_A
    expect R_A_x = W*L/(4*h)
    expect R_A_y = W/2
    """
    findings = compile_source(Source("arch.mech", text)).findings
    assert [finding.outcome for finding in findings] == ["proved"] * 2


@pytest.mark.parametrize("target", ["python", "c", "latex", "json"])
def test_every_target_has_a_frame(target: str) -> None:
    assert "N_AB" in mechc.loads(truss(), "truss.mech").emit(target).replace("_{AB}", "_AB")


def test_a_frame_that_is_held_twice_leaves_forces_open() -> None:
    twice = truss().replace("slider B along 20 deg", "pivot B").replace("find N_B\n", "")
    with pytest.raises(mechc.MechcError) as caught:
        mechc.loads(twice, "truss.mech")
    assert {d.code for d in caught.value.diagnostics if d.code[0] == "E"} == {"E509"}
