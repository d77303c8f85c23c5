"""Python: floats and arrays alike, quiet, clean, and safe from what a user writes."""

import ast
import math
import shutil
import subprocess
import sys
import tracemalloc
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mechc.compilation import Compilation
from mechc.emit.names import TargetNames
from mechc.emit.python.printer import RESERVED
from mechc.emit.python.to_python import TARGET, function_names
from mechc.emit.target import Options
from mechc.formula.tree import Call
from mechc.formula.walk import walk
from mechc.routine.steps import Input
from mechc.source import Source
from routine_samples import LIBRARY, SAMPLES, compiled, solved
from run_targets import span
from sources import in_thirds

RUFF = shutil.which("ruff") or shutil.which("ruff", path=str(Path(sys.executable).parent))


@cache
def text(sample: str) -> str:
    (file,) = TARGET.emit(solved(sample), Options(sample))
    assert file.name == f"{sample}.py"
    return file.text


def module(sample: str) -> dict[str, Any]:
    space: dict[str, Any] = {"__name__": sample}
    exec(compile(text(sample), f"{sample}.py", "exec"), space)
    return space


def test_scalars_give_a_float_and_arrays_an_array() -> None:
    k = module("clamp")["k"]
    assert type(k(0.1, 0.25, 0.2, 0.1)) is float
    assert type(k(1, 2, 0, np.float64(0.1))) is float
    assert k([0.1, 0.2], 0.25, 0.2, 0.1).shape == (2,)
    assert type(module("badly_named")["seven"]()) is float


def test_a_broken_condition_and_a_pole_are_quiet() -> None:
    k = module("clamp")["k"]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isnan(k(0.1, 0.25, 1.2, 0.9))
        assert k(0.1, 0.0, 0.2, 0.1) == np.inf


def test_the_docstring_says_formula_units_ranges_and_conditions() -> None:
    function = next(n for n in ast.parse(text("clamp")).body if isinstance(n, ast.FunctionDef))
    assert ast.get_docstring(function) == (
        "Return the force ratio P/F.\n\n"
        "    k = a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))\n\n"
        "NaN unless\n    alpha + beta < pi/2\n\n"
        "Args:\n"
        "    a: m; 100 mm, in 50 mm .. 100 mm\n"
        "    b: m; 250 mm, in 125 mm .. 250 mm\n"
        "    alpha: rad; 12 deg, in 6 deg .. 12 deg\n"
        "    beta: rad; 7 deg, in 3.5 deg .. 7 deg\n\n"
        "Operations: 9"
    )


def test_a_module_knows_the_values_and_ranges_of_the_description() -> None:
    space: dict[str, Any] = {}
    exec(text("clamp"), space)
    assert space["DEFAULTS"].keys() == {"a", "b", "alpha", "beta"}
    assert space["k"](**space["DEFAULTS"]) == pytest.approx(0.0670682245, rel=1e-9)
    assert space["RANGES"]["a"] == (0.05, 0.1)


def test_many_poses_take_no_more_memory_than_their_results() -> None:
    space: dict[str, Any] = {}
    exec(text("clamp"), space)
    function, one, poses = space["k"], (0.1, 0.25, 0.2, 0.1), 200_000
    many = [np.full(poses, one[0]), *one[1:3], np.full((2, 1), one[3])]
    tracemalloc.start()
    found = function(*many)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert found.shape == (2, poses)
    assert np.ptp(found) == 0.0
    assert found[0, 0] == pytest.approx(function(*one), rel=1e-15)
    assert most < 1.5 * found.nbytes


def test_bad_names_keep_apart() -> None:
    tree = ast.parse(text("badly_named"))
    functions = {n.name: n for n in tree.body if isinstance(n, ast.FunctionDef)}
    public = [name for name in functions if not name.startswith("_")]
    assert public == ["k", "k_n", "int_2", "int_", "seven", "pose"]
    arguments = " ".join(a.arg for a in functions["k"].args.args)
    assert arguments == "lambda_ int_ I n i np_ beta_3 beta beta_2 double l_A_prime k"
    assert "lambda_: m; lambda in the formula" in (ast.get_docstring(functions["k"]) or "")


def test_what_a_user_writes_stays_inside_the_docstring() -> None:
    tree = ast.parse(text("badly_named"))
    assert ast.get_docstring(tree) == (
        'A "title" with */ and /* and """ and \\.\n\n'
        "Source: line one line two ??/ */ int x; \\.\n"
        "Written by mechc 0.0.0. SI units and radians; floats and arrays alike."
    )


@pytest.mark.parametrize("sample", SAMPLES)
def test_every_sample_runs_by_itself(sample: str, tmp_path: Path) -> None:
    (tmp_path / "m.py").write_text(text(sample), encoding="utf-8")
    command = [sys.executable, "-I", "-W", "error", str(tmp_path / "m.py")]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.stderr == ""
    names = [f.name for f in compiled(sample).routine.functions]
    assert len(done.stdout.splitlines()) == len(names)


def test_the_default_pose_is_printed(tmp_path: Path) -> None:
    (tmp_path / "m.py").write_text(text("chained"), encoding="utf-8")
    done = subprocess.run([sys.executable, tmp_path / "m.py"], capture_output=True, text=True)
    k, load, other, _ = done.stdout.splitlines()
    assert k.startswith("k = -")
    assert load == "P: no default for M"
    assert other == "F = 30"


@pytest.mark.skipif(RUFF is None, reason="no ruff")
def test_everything_is_clean(tmp_path: Path) -> None:
    for sample in (*SAMPLES, *LIBRARY):
        (tmp_path / f"{sample}.py").write_text(text(sample), encoding="utf-8")
    # E741 is about names like l and I, which are the drawing's.
    command = [str(RUFF), "check", "--isolated", "--no-cache", "--ignore", "E741", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("sample", ["clamp", "chained", "badly_named"])
def test_golden(sample: str, golden: Callable[[str, str], None]) -> None:
    golden(f"code/{sample}.py", text(sample))


FEW = 300
"""Fewer poses than those (512) from which the emitted module takes sines from vector tangents."""

ANGLES = np.concatenate(
    [
        np.random.default_rng(1).uniform(-7.0, 7.0, 4000),
        np.random.default_rng(2).uniform(-1e15, 1e15, 1000),
        np.arange(-40, 41) * np.pi / 2,
        np.nextafter(np.arange(-40, 41) * np.pi / 2, 100.0),
        10.0 ** np.arange(-300.0, 300.0, 7.0),
        [0.0, -0.0, np.nan, np.inf, -np.inf],
    ]
)
"""Many angles, those next to multiples of a quarter turn and huge ones among them."""


@pytest.mark.parametrize("vectors", [True, False])
def test_many_sines_and_cosines_are_those_of_one_angle(vectors: bool) -> None:
    space = module("clamp")
    space["_VECTOR_TANGENTS"] = vectors
    with np.errstate(all="ignore"):
        pairs = zip(space["_cos_sin"](ANGLES), (np.cos(ANGLES), np.sin(ANGLES)), strict=True)
        for found, expected in pairs:
            assert np.array_equal(np.isnan(found), np.isnan(expected))
            known = ~np.isnan(expected)
            off = np.abs(found - expected)[known] / np.spacing(np.abs(expected[known]))
            assert np.max(off) <= (4.0 if vectors else 0.0)
            assert np.array_equal(np.signbit(found[known]), np.signbit(expected[known]))


@pytest.mark.parametrize("sample", in_thirds(LIBRARY))
def test_many_poses_have_the_values_of_one(sample: str) -> None:
    """Sines within 4 ulp move a result by some of them, times how sensitive it is.

    An arc sine next to a right angle turns one ulp into 1e-8, for one pose as well.
    """
    space, poses = module(sample), 2 * FEW
    for function in solved(sample).routine.functions:
        if any(isinstance(p, Call) and p.function == "asin" for p in walk(function.formula)):
            continue
        columns = {i.name: random_values(i, poses) for i in function.inputs}
        call = space[function_names(solved(sample).routine, TargetNames(RESERVED))[function.name]]
        many = np.broadcast_to(call(*columns.values()), poses)
        moved = np.zeros(poses)
        few = parts_of(call, columns, poses)
        for name, values in columns.items():
            moved += np.abs(parts_of(call, {**columns, name: values * (1 + 1e-7)}, poses) - few)
        near = np.isfinite(few) & np.isfinite(moved)
        assert np.array_equal(np.isnan(many)[near], np.isnan(few)[near])
        size = np.sqrt(np.mean(np.square(few[near]))) if np.any(near) else 0.0
        allowed = 16 * np.finfo(float).eps * (np.maximum(np.abs(few), size) + moved / 1e-7)
        assert np.all(np.abs(many - few)[near] <= allowed[near])


def random_values(item: Input, poses: int) -> np.ndarray:
    return np.random.default_rng(len(item.name)).uniform(*span(item), poses)


def parts_of(call: Callable[..., Any], columns: dict[str, np.ndarray], poses: int) -> np.ndarray:
    """Return values FEW poses at a time."""
    return np.concatenate(
        [
            np.broadcast_to(call(*(c[i : i + FEW] for c in columns.values())), FEW)
            for i in range(0, poses, FEW)
        ]
    )


BY_DIRECTIONS = """
param phi = 60 deg in 20 deg .. 120 deg
pivot O at (0 mm, 0 mm)
pivot C at (80 mm, 0 mm)
link OA
link AB
link CB
OA = 30 mm @ phi
AB = 90 mm
CB = 60 mm
assembly ABC cw
require 20 deg < phi_AB - phi_CB + 180 deg < 145 deg
torque M on OA
torque T on CB
find k = M/T
"""


def test_a_condition_on_directions_of_a_loop_is_checked_and_said_to_be():
    """The loop gives the angle between the two another name, by which code checks it."""
    (module,) = TARGET.emit(Compilation(Source("k.mech", BY_DIRECTIONS)), Options("module"))
    assert "Not checked here" not in module.text
    space = {"__name__": "module"}
    exec(compile(module.text, "module.py", "exec"), space)
    assert math.isfinite(space["k"](math.radians(60)))
    assert math.isnan(space["k"](math.radians(20)))
