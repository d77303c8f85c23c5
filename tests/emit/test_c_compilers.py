"""C of the whole library under gcc and clang, at every level, without a warning; huge angles."""

import ctypes
import shutil
import subprocess
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from mechc.compilation import Compilation, emit
from mechc.emit.c.to_c import TARGET
from mechc.emit.target import Emitted, Options
from mechc.routine.evaluate import evaluate
from mechc.routine.steps import Function
from mechc.source import Source
from mechc.units import ANGLE
from routine_samples import LIBRARY, SAMPLES, solved
from run_targets import built, poses
from small_mechanisms import follower

STRICT = ["-Wall", "-Wextra", "-Wconversion", "-Wpedantic", "-Werror", "-c"]
COMPILERS = {
    "gcc": ["gcc", "-std=c99", "-x", "c"],
    "clang": ["clang", "-std=c99", "-x", "c"],
    "g++": ["g++", "-std=c++17", "-x", "c++"],
    "clang++": ["clang++", "-std=c++17", "-x", "c++"],
}
LEVELS = {"gcc": "-O3 -march=native", "clang": "-Os", "g++": "-O0", "clang++": "-O3 -march=native"}
"""Each compiler at a level of its own: all pairs take ten minutes and found no more."""

ITERATED = ("double_butterfly", "scissor_table", "triad_closed")


def compile_all(names: list[str], compiler: str, level: str, folder: Path) -> None:
    files = [file for name in names for file in TARGET.emit(solved(name), Options(name))]
    compile_files(files, compiler, level, folder)


def compile_files(files: Sequence[Emitted], compiler: str, level: str, folder: Path) -> None:
    command = COMPILERS[compiler]
    if shutil.which(command[0]) is None:
        pytest.skip(f"no {command[0]}")
    for name, text in files:
        (folder / name).write_text(text, encoding="utf-8")
    sources = [name for name, _ in files if name.endswith(".c")]
    run = [*command, *STRICT, *level.split(), *sources]
    done = subprocess.run(run, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[:2000]


@pytest.mark.parametrize(("compiler", "level"), [("gcc", "-O2"), ("clang", "-Os")])
def test_systems_compile_without_a_warning(compiler, level, tmp_path):
    compile_all([*ITERATED, "clamp"], compiler, level, tmp_path)


def test_forces_that_nothing_makes_compile_without_a_warning(tmp_path):
    """They are 0 whatever the load, which their statuses take, and whatever slopes are taken by."""
    text = follower("friction pin C 0.1 diameter 10 mm", "find R_C on QC")
    files = emit(Compilation(Source("press.mech", text)), TARGET, Options("press", gradient=True))
    compile_files(files, "gcc", "-O1", tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize(("part", "compiler"), [*enumerate(COMPILERS)])
def test_the_library_compiles_without_a_warning(part, compiler, tmp_path):
    """Each compiler sees another part of the library."""
    compile_all([*SAMPLES, *LIBRARY[part :: len(COMPILERS)]], compiler, LEVELS[compiler], tmp_path)


TWO_BRANCHES = """
param t1 = -93.2 deg in -133.2 deg .. -53.2 deg
slider A along t1
pivot C
link AB
param t2 = -176.2 deg in -216.2 deg .. -136.2 deg
AB = 147.4 mm @ t2
link CB
param t3 = -21.7 deg in -61.7 deg .. 18.3 deg
CB = 89.4 mm @ t3
pivot E
link AD
param t4 = -147.0 deg in -187.0 deg .. -107.0 deg
AD = 151.0 mm @ t4
link EDG
param t5 = 140.9 deg in 100.9 deg .. 180.9 deg
ED = 113.2 mm @ t5
param t6 = 175.1 deg in 135.1 deg .. 215.1 deg
EG = 156.7 mm @ t6
force P at A along t1 times 2
param t7 = 57.9 deg in 17.9 deg .. 97.9 deg
force F at G along t7
find k = P / F
param q = 1
friction pins 0.086*q diameter 6 mm coulomb
friction slider A 0.08*q guide 50 mm overhang 5 mm linear
"""


@cache
def of_two_branches():
    compilation = Compilation(Source("branches.mech", TWO_BRANCHES))
    return TARGET.emit(compilation, Options("branches"))


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_a_loop_that_needs_fewer_arguments_compiles_without_a_warning(compiler, tmp_path):
    """Only where friction turns a force round is k_f one of t2 and t3."""
    compile_files(of_two_branches(), compiler, "-O1", tmp_path)


HUGE = [1e6, 1.05e6, -2e6, 1e15, 1e22, -1e22, 1e300, np.inf, -np.inf, np.nan]


def stretched(function: Function) -> dict[str, np.ndarray]:
    """Return poses in which some angles are huge, infinite or no number."""
    found, dice = poses(function), np.random.default_rng(7)
    for item in function.inputs:
        if item.dimension == ANGLE:
            column = found[item.name]
            chosen = dice.random(len(column)) < 0.5
            found[item.name] = np.where(chosen, dice.choice(HUGE, len(column)), column)
    return found


def assert_huge_angles_are_right(name: str, folder: Path) -> None:
    found = solved(name)
    made = built(found, folder)
    expected, batches = {}, {}
    array = np.ctypeslib.ndpointer(dtype=np.float64)
    for function, batch in zip(found.routine.functions, made.batches, strict=True):
        values = stretched(function)
        call, result = made.code[batch], np.empty(len(next(iter(values.values()), HUGE)))
        call.restype = None
        call.argtypes = [ctypes.c_size_t, *[array] * (len(values) + 1)]
        call(len(result), *values.values(), result)
        batches[function.name] = result
        expected[function.name] = np.broadcast_to(evaluate(function, values), len(result))
    for key, result in batches.items():
        np.testing.assert_allclose(result, expected[key], rtol=1e-9, atol=1e-12, err_msg=key)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no C compiler")
@pytest.mark.parametrize("name", ["clamp", "crank_rocker", "karpenko_fig9_packet_clamp"])
def test_huge_angles_are_right_in_loops(name, tmp_path):
    assert_huge_angles_are_right(name, tmp_path)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("gcc") is None, reason="no C compiler")
@pytest.mark.parametrize("part", range(3))
def test_huge_angles_are_right_in_loops_of_the_library(part, tmp_path):
    for name in LIBRARY[part::6]:
        (tmp_path / name).mkdir()
        assert_huge_angles_are_right(name, tmp_path / name)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_a_loop_over_roots_becomes_vector_code(tmp_path):
    (source,) = TARGET.emit(solved("crank_rocker"), Options("k", single=True))
    (tmp_path / "k.c").write_text(source.text, encoding="utf-8")
    command = ["gcc", "-std=c99", "-O3", "-fopt-info-vec", "-c", "k.c"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    loops = {line.split(":")[1] for line in done.stderr.splitlines() if "loop vectorized" in line}
    heads = [source.text.splitlines()[int(n) - 1] for n in loops]
    assert [head.split()[0] for head in heads] == ["for", "for"]  # those of k and of i
