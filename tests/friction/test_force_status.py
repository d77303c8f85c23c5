"""A force at a joint with friction says, as the load that drives does, whether anything moves."""

import ctypes
import math
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import mechc
from mechc.api import SolvedMechanism
from mechc.routine.evaluate import status
from paths import LIBRARY
from small_mechanisms import toggle

TOGGLE = "mechanism toggle\n" + toggle(
    "param f = 0.1", "friction pins f diameter 20 mm", "friction slider K f", alpha="20 deg"
)
ANGLES = (-3, 0.3, 4, 82, 87)
LOADS = (500.0, -500.0)
UNLOADED = (0.35, 0.0)
POSES = [*((math.radians(angle), load) for angle in ANGLES for load in LOADS), UNLOADED]


@pytest.fixture(scope="module")
def toggle() -> SolvedMechanism:
    return mechc.loads(f"{TOGGLE}find P, R_O, N_OB\n")


def values(alpha: float, load: float) -> dict[str, float]:
    return {"l": 0.2, "alpha": alpha, "f": 0.1, "F": load}


@pytest.mark.slow
def test_a_force_has_the_status_of_the_load_that_drives(toggle):
    listed = {f.name: f for f in toggle._compilation.routine.functions}
    stated = [int(status(listed["P_f"], listed["P"], values(*pose))) for pose in POSES]
    assert set(stated) == {0, 3, 4}
    assert stated[POSES.index(UNLOADED)] == 0
    for force in ("R_O", "R_O_direction", "N_OB"):
        with_friction = listed[f"{force}_f"]
        found = [int(status(with_friction, listed[force], values(*pose))) for pose in POSES]
        assert found == stated


def test_it_has_one_where_the_load_is_not_asked_for():
    """A ratio does not know which way the load points, a force without one has none beside it."""
    of_ratio = code(mechc.loads(f"{TOGGLE}find k = P/F, N_OB\n"))["N_OB_f_status"]
    assert [of_ratio(**values(*pose)) for pose in ((1.52, 500.0), (0.005, -500.0))] == [4, 3]
    alone = code(mechc.loads(f"{TOGGLE}let F = 500 N\nfind N_OB\n"))["N_OB_f_status"]
    assert [alone(0.2, alpha, 0.1) for alpha in (0.35, 1.52)] == [0, 4]


def test_nothing_is_held_where_there_is_no_load(toggle):
    """Rounding leaves a load of 1e-60 N, which has the one sign or the other."""
    releasing = code(mechc.loads(f"{TOGGLE}find P\nmotion releasing\n"))
    for space in (code(toggle), releasing):
        found = {n: space[n](*values(*UNLOADED).values()) for n in space if n.endswith("_status")}
        assert found
        assert not any(found.values()), found


@pytest.fixture(scope="module")
def clamp() -> dict[str, object]:
    """A toggle whose load has a closed form, that holds at its dead centre at 90 degrees, too."""
    text = (LIBRARY / "fedoriv_fig2a_with_friction.mech").read_text("utf-8")
    head, _ = text.split("find k")
    return code(mechc.loads(f"{head}find Q, R_E\n"))


@pytest.mark.parametrize(
    ("many", "seed"), [(30, 1), *(pytest.param(4000, s, marks=pytest.mark.slow) for s in (1, 4))]
)
def test_beside_a_dead_centre_nothing_is_stated_rather_than_what_is_false(clamp, many, seed):
    """For a unit of friction, joints are pressed with up to 1e14 there."""
    dice = np.random.default_rng(seed)
    beside = dice.choice([-1, 1], many) * 10.0 ** -dice.uniform(2, 16, many)
    ranges = ((0.05, 0.15), (0.01, 0.4), (0.002, 0.03))
    given = [math.pi / 2 + beside, *(dice.uniform(*ends, many) for ends in ranges)]
    given.append(dice.choice([-1.0, 1.0], many) * 10 ** dice.uniform(-1, 4, many))
    stated, of_load = (clamp[f"{n}_f_status"](*given) for n in ("R_E_x", "Q"))
    is_false = (stated != of_load) & (stated != 2) & (of_load != 2)
    assert not is_false.any(), np.transpose(given)[is_false]
    assert all(np.isfinite(clamp["R_E_x_f"](*given)) == (stated == 0))


def code(mechanism: SolvedMechanism) -> dict[str, object]:
    space: dict[str, object] = {"__name__": "module"}
    exec(compile(mechanism.emit("python"), "module.py", "exec"), space)
    return space


def in_c(toggle: SolvedMechanism, folder: Path, real: str) -> Callable[[float, float], int]:
    """Return the status of the force at O by compiled code, at an angle and a load."""
    for file in toggle.emit_files("c", c_real=real):
        (folder / file.name).write_text(file.text, encoding="utf-8")
    command = "gcc -std=c99 -Wall -Wextra -Werror -fPIC -shared toggle.c -o toggle.so -lm"
    subprocess.run(command.split(), cwd=folder, check=True)
    single = ctypes.CDLL(str(folder / "toggle.so")).toggle_R_O_f_status
    single.argtypes = [ctypes.c_double if real == "double" else ctypes.c_float] * 4
    return lambda alpha, load: single(*values(alpha, load).values())


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_python_and_c_say_the_same(toggle, tmp_path):
    single, of_python = in_c(toggle, tmp_path, "double"), code(toggle)["R_O_f_status"]
    for alpha, load in POSES:
        assert single(alpha, load) == of_python(*values(alpha, load).values())


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_single_precision_gives_up_earlier(toggle, tmp_path):
    """The load moves the toggle or jams it before its dead centre at 90 degrees; it never holds."""
    single = in_c(toggle, tmp_path, "float")
    beside = [(math.pi / 2 - 10.0**-n, load) for n in range(1, 10) for load in LOADS]
    found = [single(*pose) for pose in beside]
    assert set(found) == {0, 2, 4}
    assert found[:4] == [4, 0, 4, 0]


GEARED = """mechanism geared
param a = 50 mm
param r = 25 mm
param phi = 30 deg
drive phi from 25 deg to 120 deg
pivot O at (0 mm, 0 mm)
pivot Q at (2*r, 0 mm)
link OA
link QB
link BC
OA = a @ phi
QB = a @ -phi
BC = a
slider C along x through O
gear O r, Q r
assembly C forward
friction gear O 0.03
friction slider C 0.1
force F at C along y
torque M on OA
find k = M/F
"""
"""A load that presses its guide and does no work; at 90 degrees crank and rod are upright.

On the way to its solution the force that presses the gears turns round, and another branch of
solutions comes near there.
"""


def test_beside_upright_rods_no_single_pose_is_said_to_jam():
    """k_f is in proportion to the angle that is left to 90 degrees."""
    geared = mechc.loads(GEARED)
    functions = {f.name: f for f in geared._compilation.routine.functions}
    beside = [math.pi / 2 - 10 ** -(3 + i / 20) for i in range(81)]
    given = {"a": 0.05, "r": 0.025, "phi": np.array(beside)}
    interpreted = status(functions["k_f"], functions["k"], given)
    assert not np.any(interpreted)
    assert not np.any(code(geared)["k_f_status"](0.05, 0.025, np.array(beside)))
    numbers = [mechc.loads(GEARED).compile().evaluate(phi=phi)["k_f"] for phi in beside[::4]]
    assert numbers == pytest.approx(
        [1.03 * 0.1 * (math.pi / 2 - phi) for phi in beside[::4]], rel=0.02
    )
