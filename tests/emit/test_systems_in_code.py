"""Systems in routine, Python and C: solved once, alike in all, singly and in batches."""

import ctypes
import math
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from grown import Grown
from mechc.compilation import compile_source
from mechc.emit.c.to_c import TARGET as C
from mechc.emit.latex.to_latex import TARGET as LATEX
from mechc.emit.python.to_python import TARGET as PYTHON
from mechc.emit.target import Compiled, Options
from mechc.formula.evaluate import solution
from mechc.report.text.derivation import render
from mechc.routine.evaluate import evaluate
from mechc.routine.evaluate import pose as interpreted
from mechc.routine.promises import broken_promises
from mechc.routine.steps import PoseProgram, Solve
from mechc.source import Source
from routine_samples import solved
from run_targets import assert_close, built, by_c_in_batch, by_c_singly, by_interpreter, by_python
from systems import TRIAD_UNKNOWNS, triad

STRICT = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]

BEHIND_A_CUT = """
mechanism cut
param phi = -123 deg
pivot O at (0 mm, 0 mm)
pivot P at (-93 mm, -42 mm)
pivot Q at (5 mm, -199 mm)
pivot G at (47 mm, 120 mm)
link OA
link AB
link PB
link BC
link CDE
link QD
slider E along -62 deg through G
OA = 50 mm @ phi
AB = 57 mm
PB = 105 mm
BC = 56 mm
CD = 51 mm
CE = 91 mm
angle DCE = 112 deg
QD = 87 mm
assembly ABP cw
assembly E back
drive phi from -150 deg to -121 deg
torque M on OA
force F at E along 143 deg
find k = M/F
"""
"""A triad on rods between A and P: the direction of AP passes 180 deg near the default."""


def pose_of(found: Compiled) -> PoseProgram:
    assert found.routine.pose is not None
    return found.routine.pose


def sweep(found: Compiled, spread: float = 1.5, number: int = 301) -> dict[str, Any]:
    """Return the default pose's values, phi going past both ends of the branch."""
    values = {i.name: i.default for i in pose_of(found).inputs}
    middle = triad().values["phi"]
    return values | {"phi": middle + np.linspace(-spread, spread, number)}


def module(found: Compiled) -> dict[str, Callable[..., Any]]:
    (file,) = PYTHON.emit(found, Options("module"))
    space: dict[str, Callable[..., Any]] = {"__name__": "module"}  # type: ignore[dict-item]
    exec(compile(file.text, "module.py", "exec"), space)
    return space


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> SimpleNamespace:
    if shutil.which("gcc") is None:
        pytest.skip("no gcc")
    folder = tmp_path_factory.mktemp("code")
    for sample in ("triple", "chained"):
        for file in C.emit(solved(sample), Options(sample)):
            (folder / file.name).write_text(file.text, encoding="utf-8")
    sources = ["triple.c", "chained.c"]
    command = ["gcc", *STRICT, "-O2", "-fPIC", "-shared", *sources, "-o", "code.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    return SimpleNamespace(code=ctypes.CDLL(str(folder / "code.so")))


def test_a_system_is_solved_once_in_each_function() -> None:
    routine = solved("triple").routine
    for function in (*routine.functions, pose_of(solved("triple"))):
        assert sum(isinstance(step, Solve) for step in function.steps) == 1
    for function in routine.functions:
        assert broken_promises(function) == []


def test_names_of_definitions_are_those_of_the_solution() -> None:
    (k, delta) = solved("triple").routine.functions
    (solve,) = (step for step in k.steps if isinstance(step, Solve))
    assert solve.names[:3] == TRIAD_UNKNOWNS[:3]
    assert solve.names[3] not in TRIAD_UNKNOWNS
    assert [step.name for step in delta.steps if not isinstance(step, Solve)] == ["epsilon_2"]


def test_the_interpreter_follows_every_pose_as_formulas_do() -> None:
    found, made = solved("triple"), triad()
    values = sweep(found)
    angles, status = interpreted(pose_of(found), values)
    singly = [
        solution(made.system(), tuple((made.values | {"phi": phi}).values()))
        for phi in values["phi"]
    ]
    for i, name in enumerate(TRIAD_UNKNOWNS[:3]):
        expected = np.array([one[i] for one in singly])
        np.testing.assert_allclose(angles[name], expected, rtol=1e-13, atol=1e-14)
        assert np.array_equal(np.isnan(expected), status != 0)


def test_a_sweep_has_no_jump() -> None:
    angles, status = interpreted(pose_of(solved("triple")), sweep(solved("triple"), number=4001))
    closed = np.flatnonzero(status == 0)
    assert 100 < len(closed) < 4001
    assert np.array_equal(closed, np.arange(closed[0], closed[-1] + 1))
    for name in TRIAD_UNKNOWNS[:3]:
        assert np.abs(np.diff(np.asarray(angles[name])[closed[40:-40]])).max() < 0.02


def test_python_says_what_the_interpreter_says() -> None:
    found = solved("triple")
    values, space = sweep(found), module(solved("triple"))
    angles, status = space["pose"](**values)
    expected, statuses = interpreted(pose_of(found), values)
    assert np.array_equal(status, statuses)
    for name, value in expected.items():
        np.testing.assert_array_equal(np.broadcast_to(angles[name], np.shape(value)), value)
    singly = [space["pose"](**(values | {"phi": phi})) for phi in values["phi"][::30]]
    np.testing.assert_array_equal([s for _, s in singly], status[::30])
    np.testing.assert_array_equal([one["beta"] for one, _ in singly], angles["beta"][::30])


def test_python_says_whether_dyads_close() -> None:
    pose = module(solved("chained"))["pose"]
    angles, status = pose(a=0.1, b=0.25, phi=0.5)
    assert (status, angles["theta"]) == (0, pytest.approx(math.asin(0.4 * math.sin(0.5))))
    angles, status = pose(a=0.3, b=0.25, phi=np.array([0.1, 1.5]))
    assert list(status) == [0, 1]
    assert math.isnan(angles["theta"][1])


def c_poses(library: SimpleNamespace, found: Compiled, values: dict[str, Any]) -> tuple[Any, Any]:
    """Return intermediates and status from C, the batch checked against single calls."""
    pose, name = pose_of(found), found.routine.name
    columns = np.broadcast_arrays(*(values[i.name] for i in pose.inputs))
    columns = [np.array(column, dtype=float) for column in columns]
    size = len(columns[0])
    outputs = [np.empty(size) for _ in pose.outputs]
    status = np.empty(size, dtype=np.intc)
    floats, ints = (np.ctypeslib.ndpointer(dtype=t) for t in (np.float64, np.intc))
    batch = library.code[f"{name}_pose_n"]
    batch.restype = None
    batch.argtypes = [ctypes.c_size_t, *[floats] * (len(columns) + len(outputs)), ints]
    batch(size, *columns, *outputs, status)
    single = library.code[f"{name}_pose"]
    single.argtypes = [ctypes.c_double] * len(columns) + [floats] * len(outputs)
    for i in range(0, size, 7):
        one = [np.empty(1) for _ in outputs]
        assert single(*(column[i] for column in columns), *one) == status[i]
        np.testing.assert_array_equal([o[0] for o in one], [o[i] for o in outputs])
    return dict(zip(pose.outputs, outputs, strict=True)), status


@pytest.mark.parametrize("sample", ["triple", "chained"])
def test_c_says_what_the_interpreter_says(library: SimpleNamespace, sample: str) -> None:
    found = solved(sample)
    values = {"a": 0.3, "b": 0.25, "phi": np.linspace(0.1, 1.5, 50)}
    values = sweep(found) if sample == "triple" else values
    angles, status = c_poses(library, found, values)
    expected, statuses = interpreted(pose_of(found), values)
    assert {0, 1} == set(status)
    assert np.array_equal(status, statuses)
    for name, value in expected.items():
        np.testing.assert_allclose(angles[name], value, rtol=1e-12, atol=1e-13)


def test_nonsense_has_a_status_too(library: SimpleNamespace) -> None:
    found = solved("triple")
    for nonsense in (math.nan, math.inf, 1e300):
        values = sweep(found) | {"phi": np.array([nonsense])}
        angles, status = c_poses(library, found, values)
        assert status[0] == 2
        assert math.isnan(angles["beta"][0])
        assert interpreted(pose_of(found), values)[1][0] == 2


def test_people_see_the_equations() -> None:
    found = solved("triple")
    line = "θ, β, γ, δ: the solution of the equations"
    assert line in render(found.derivation, found.mechanism)
    for language, word in (("en", "the solution"), ("uk", "розв’язок"), ("ru", "решение")):
        text = LATEX.emit(found, Options("triple", language=language))[0].text  # type: ignore[arg-type]
        assert rf"$\theta$, $\beta$, $\gamma$, $\delta$: {word}" in text
        assert r"+b\cos\beta+d\cos\theta-c\cos\gamma-x_2" in text


@pytest.mark.parametrize(("seed", "place"), [(70873, -1.1540780051241954), (70146, 1.2295)])
def test_no_step_passes_over_the_end_of_a_branch(seed: int, place: float) -> None:
    """Beyond it the links can be put together in another way, with a determinant of one sign."""
    found = compile_source(Source("grown.mech", Grown(seed).text()))
    (k,) = found.routine.functions
    values = {i.name: i.default for i in k.inputs if i.default is not None}
    assert math.isfinite(float(evaluate(k, values)))
    assert math.isnan(float(evaluate(k, {**values, "phi": place})))


def test_a_direction_that_passes_half_a_turn_leads_no_way_round(tmp_path: Path) -> None:
    found = compile_source(Source("cut.mech", BEHIND_A_CUT))
    (k,) = found.routine.functions
    (solve,) = (step for step in k.steps if isinstance(step, Solve))
    assert solve.solver.turning == ("phi_AB",)
    along = evaluate(k, {"phi": np.radians(np.linspace(-150, -121, 291))})
    assert np.abs(np.diff(along, 2)).max() < 5e-4
    expected = by_interpreter(found)
    assert_close(by_python(found), expected, 0, found.routine)
    if shutil.which("gcc"):
        made = built(found, tmp_path)
        assert_close(by_c_singly(found, made), expected, 64, found.routine)
        assert_close(by_c_in_batch(found, made), expected, 64, found.routine)
