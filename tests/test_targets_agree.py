"""The interpreter, the emitted Python, the compiled C and sympy agree."""

import ctypes
import math
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from mechc.algebra.to_sympy import to_sympy
from mechc.emit.target import Compiled, Options
from mechc.emit.to_c import TARGET as C
from mechc.emit.to_python import TARGET as PYTHON
from mechc.routine.evaluate import evaluate
from mechc.routine.steps import Function
from routine_samples import SAMPLES, compiled

COMPILER = shutil.which("gcc") or shutil.which("cc")
ULP = 2.0**-52
POSES = 40

Outputs = dict[str, np.ndarray]


def poses(function: Function, seed: int = 0) -> dict[str, np.ndarray]:
    """Return random inputs in their ranges; loads are of either sign."""
    random = np.random.default_rng(seed)
    return {
        i.name: random.uniform(-100.0, 100.0, POSES)
        if i.low is None or i.high is None
        else random.uniform(i.low, i.high, POSES)
        for i in function.inputs
    }


def by_interpreter(found: Compiled) -> Outputs:
    return {f.name: np.broadcast_to(evaluate(f, poses(f)), POSES) for f in found.routine.functions}


def by_python(found: Compiled) -> Outputs:
    (module,) = PYTHON.emit(found, Options("module"))
    space: dict[str, Callable[..., np.ndarray]] = {"__name__": "module"}
    exec(compile(module.text, "module.py", "exec"), space)
    callables = [v for k, v in space.items() if getattr(v, "__module__", "") == "module"]
    return {
        f.name: np.broadcast_to(call(*poses(f).values()), POSES)
        for f, call in zip(found.routine.functions, callables, strict=True)
    }


def library(found: Compiled, folder: Path) -> SimpleNamespace:
    """Return the compiled library and the linker's names in order: singles and batches."""
    source, header = C.emit(found, Options("code"))
    for file in (source, header):
        (folder / file.name).write_text(file.text, encoding="utf-8")
    strict = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]
    made = folder / "code.so"
    command = [COMPILER, *strict, "-O2", "-fPIC", "-shared", "code.c", "-o", made, "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    heads = [line for line in header.text.splitlines() if line.startswith(("double ", "void "))]
    names = [line.split("(")[0].split()[1] for line in heads]
    return SimpleNamespace(code=ctypes.CDLL(str(made)), singles=names[::2], batches=names[1::2])


def by_c_singly(found: Compiled, folder: Path) -> Outputs:
    made, outputs = library(found, folder), {}
    for function, name in zip(found.routine.functions, made.singles, strict=True):
        call = made.code[name]
        call.restype = ctypes.c_double
        call.argtypes = [ctypes.c_double] * len(function.inputs)
        columns = list(poses(function).values())
        outputs[function.name] = np.array([call(*(c[i] for c in columns)) for i in range(POSES)])
    return outputs


def by_c_in_batch(found: Compiled, folder: Path) -> Outputs:
    made, outputs = library(found, folder), {}
    array = np.ctypeslib.ndpointer(dtype=np.float64)
    for function, name in zip(found.routine.functions, made.batches, strict=True):
        call = made.code[name]
        call.restype = None
        call.argtypes = [ctypes.c_size_t] + [array] * (len(function.inputs) + 1)
        outputs[function.name] = np.empty(POSES)
        call(POSES, *poses(function).values(), outputs[function.name])
    return outputs


def assert_close(found: Outputs, expected: Outputs, ulps: int) -> None:
    assert list(found) == list(expected)
    for name, values in expected.items():
        finite = values[np.isfinite(values)]
        scale = math.sqrt(np.mean(finite**2)) if finite.size else 0.0
        bound = ulps * ULP * np.maximum(np.abs(values), scale)
        assert np.array_equal(np.isnan(found[name]), np.isnan(values)), name
        error = np.abs(found[name] - values)
        assert np.all((error <= bound) | ~np.isfinite(values)), (name, np.nanmax(error / bound))


@pytest.mark.parametrize("sample", SAMPLES)
def test_python_is_the_interpreter(sample: str) -> None:
    found = compiled(sample)
    assert_close(by_python(found), by_interpreter(found), 0)


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
@pytest.mark.parametrize("sample", SAMPLES)
def test_c_agrees_for_one_pose_and_for_many(sample: str, tmp_path: Path) -> None:
    found = compiled(sample)
    expected = by_interpreter(found)
    assert_close(by_c_singly(found, tmp_path), expected, 32)
    assert_close(by_c_in_batch(found, tmp_path), expected, 32)


@pytest.mark.parametrize("sample", SAMPLES)
def test_sympy_agrees(sample: str) -> None:
    found = compiled(sample)
    for function in found.routine.functions:
        columns = poses(function)
        values = {name: column[0] for name, column in columns.items()}
        expected = evaluate(function, values)
        if not math.isnan(expected):
            assert by_sympy(function, values) == pytest.approx(expected, rel=1e-12, abs=1e-14)


def by_sympy(function: Function, values: dict[str, float]) -> float:
    import sympy

    scope = {sympy.Symbol(name): sympy.Float(value, 30) for name, value in values.items()}
    for step in (*function.where, function):
        value = to_sympy(step.formula).subs(scope).evalf(25)
        scope[sympy.Symbol(step.name)] = value
    return float(value)


def test_a_difference_would_be_seen() -> None:
    found = compiled("clamp")
    expected = by_interpreter(found)
    off = {name: values * (1 + 64 * ULP) for name, values in expected.items()}
    with pytest.raises(AssertionError):
        assert_close(off, expected, 32)
