"""Slopes by reverse accumulation: those of sympy, of differences, and of every target."""

import ctypes
import re
import shutil
import subprocess

import numpy as np
import pytest
import sympy

import mechc
from mechc.emit.c.to_c import TARGET as C
from mechc.emit.python.to_python import TARGET as PYTHON
from mechc.emit.target import Options
from mechc.formula.to_sympy import to_sympy
from mechc.routine.evaluate import evaluate, pose
from mechc.routine.functions import operations
from mechc.routine.gradient import gradient, gradients
from routine_samples import SAMPLES, solved
from run_targets import poses
from sources import in_thirds

CLOSED = ("crank_rocker", "karpenko_fig9_with_friction")


@pytest.mark.parametrize(
    "name", ["karpenko_fig9_packet_clamp", "crank_slider", "lever_first_class"]
)
def test_slopes_are_those_of_sympy(name):
    function = solved(name).routine.functions[0]
    k, values = to_sympy(function.formula), {n: a[0] for n, a in poses(function).items()}
    found, _ = pose(gradient(function), values)
    symbols = {symbol.name: symbol for symbol in k.free_symbols}
    at = {symbols[n]: value for n, value in values.items()}
    for item in function.inputs:
        wanted = float(sympy.diff(k, symbols[item.name]).subs(at))
        assert found[f"dk_d{item.name}"] == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("name", in_thirds([*SAMPLES, *CLOSED]))
def test_slopes_are_those_of_differences(name):
    for function, program in gradients(solved(name).routine.functions):
        values = {n: array[:5] for n, array in poses(function).items()}
        found, _ = pose(program, values)
        own, *slopes = (np.broadcast_to(found[n], 5) for n in program.outputs)
        np.testing.assert_allclose(own, evaluate(function, values), rtol=1e-13, atol=1e-15)
        for item, slope in zip(function.inputs, slopes, strict=True):
            x = values[item.name]
            step = 1e-5 * np.maximum(np.abs(x), 1e-2)
            ends = [evaluate(function, {**values, item.name: x + s}) for s in (step, -step)]
            scale = np.nanmax(np.abs(own)) / np.max(np.abs(x))
            there = np.isfinite(ends[0]) & np.isfinite(ends[1]) & np.isfinite(own)
            wanted = (ends[0] - ends[1]) / (2 * step)
            np.testing.assert_allclose(
                slope[there], wanted[there], rtol=1e-5, atol=1e-6 * scale, err_msg=item.name
            )


def test_all_slopes_cost_a_few_results_however_many_inputs():
    for name in ("crank_rocker", "watt_closed", "claw_closed"):
        function = solved(name).routine.functions[0]
        assert operations(gradient(function).steps) < 3.5 * function.operations


def test_what_iterates_has_none_and_says_nothing_false():
    closed = solved("triad_closed")
    assert gradients(closed.routine.functions) == []
    (file,) = PYTHON.emit(closed, Options("triad", gradient=True))
    assert "gradient" not in file.text


def test_where_a_condition_fails_there_are_no_slopes():
    (function, *_) = solved("clamp").routine.functions
    found, _ = pose(gradient(function), {"a": 1, "b": 1, "alpha": 1.2, "beta": 1})
    assert all(np.isnan(value) for value in found.values())


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
@pytest.mark.parametrize("name", in_thirds(["karpenko_fig9_with_friction", "clamp", "badly_named"]))
def test_targets_agree(name, tmp_path):
    found = solved(name)
    (module,) = PYTHON.emit(found, Options("own", gradient=True))
    (source,) = C.emit(found, Options("own", gradient=True, single=True))
    (tmp_path / "own.c").write_text(source.text, encoding="utf-8")
    strict = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Wpedantic", "-Werror"]
    command = ["gcc", *strict, "-fPIC", "-shared", "own.c", "-o", "own.so", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    library, space = ctypes.CDLL(str(tmp_path / "own.so")), {"__name__": "own"}
    exec(module.text, space)
    own = [value for name, value in space.items() if "_gradient" in name]
    heads = re.findall(r"^void (\w*_gradient\w*)\(\s*size_t", source.text, re.M)
    alone = [name for name in dict.fromkeys(heads) if not name.endswith("_of")]
    batches = [getattr(library, name) for name in alone]
    pairs = gradients(found.routine.functions)
    for (function, program), mine, batch in zip(pairs, own, batches, strict=True):
        values, wanted = list(poses(function).values()), pose(program, poses(function))[0]
        arrays = [np.empty(40) for _ in program.outputs]
        batch(ctypes.c_size_t(40), *(ctypes.c_void_p(a.ctypes.data) for a in (*values, *arrays)))
        for array, by_python, value in zip(
            arrays, mine(*values).values(), wanted.values(), strict=True
        ):
            scale = np.nanmax(np.abs(value)) if np.any(np.isfinite(value)) else 0.0
            for other in (array, np.broadcast_to(by_python, 40)):
                np.testing.assert_allclose(other, value, rtol=1e-11, atol=1e-13 * scale)


def test_from_python():
    assert "def k_gradient(" in mechc.load("crank_slider").emit("python", gradient=True)
