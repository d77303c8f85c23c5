"""Every sheet of the library and the examples, in C and Python at the same random points."""

import ctypes
import shutil
from collections.abc import Callable, Sequence
from functools import cache
from itertools import cycle
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from mechc.compilation import Compilation, compile_source
from mechc.files import read
from run_targets import built
from sheet_digits import BALANCES, NEAR_ZERO, POINTS, SHEETS, by_python, most, within

COMPILERS = ("gcc", "clang")

INEXACT = ("sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "exp", "log", "power")

ONCE_UNSTABLE = {"centre_deviation", "claw_angles", "jaw_opening"}

EACH = pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=() if n in ONCE_UNSTABLE else pytest.mark.slow) for n in SHEETS],
)


@cache
def compiled(name: str) -> Compilation:
    return compile_source(read(SHEETS[name]))


@pytest.mark.slow
@pytest.mark.parametrize(("name", "compiler"), [*zip(SHEETS, cycle(COMPILERS), strict=False)])
def test_c_is_within_a_few_units_of_python(name: str, compiler: str, tmp_path: Path) -> None:
    if shutil.which(compiler) is None:
        pytest.skip(f"no {compiler}")
    found = compiled(name)
    in_c, drawn, (calls, _) = built(found, tmp_path, compiler), within(found), by_python(found)
    compared, forces = 0, np.ones(POINTS)
    for function, single, call in zip(found.routine.functions, in_c.singles, calls, strict=True):
        values = [drawn[i.name] for i in function.inputs]
        wanted = np.broadcast_to(call(*values), POINTS)
        got = singly(in_c.code[single], ctypes.c_double, values)
        bound = most(name, function.name, call, values, forces)
        assert np.array_equal(np.isnan(got), np.isnan(wanted)), function.name
        assert np.all((np.abs(got - wanted) <= bound) | ~np.isfinite(wanted)), function.name
        forces = np.fmax(forces, np.abs(wanted))
        compared += int(np.isfinite(wanted).sum())
    assert compared


@EACH
def test_a_last_digit_of_a_sine_costs_a_few(name: str) -> None:
    """Whatever the machine: its functions may be the same in C and in NumPy."""
    found = compiled(name)
    numpy = SimpleNamespace(**{**vars(np), **{f: shaken(getattr(np, f)) for f in INEXACT}})
    drawn, forces = within(found), np.ones(POINTS)
    calls = zip(by_python(found)[0], by_python(found, numpy)[0], strict=True)
    for function, (call, other) in zip(found.routine.functions, calls, strict=True):
        values = [drawn[i.name] for i in function.inputs]
        wanted, got = (np.broadcast_to(f(*values), POINTS) for f in (call, other))
        bound = most(name, function.name, call, values, forces)
        assert np.all((np.abs(got - wanted) <= bound) | ~np.isfinite(wanted)), function.name
        forces = np.fmax(forces, np.abs(wanted))


@pytest.mark.slow
@pytest.mark.parametrize("name", SHEETS)
def test_c_and_python_have_one_status_beyond_the_ranges(name: str, tmp_path: Path) -> None:
    found = compiled(name)
    in_c, drawn, (calls, status) = built(found, tmp_path), within(found, 0.05), by_python(found)
    for function, single, call in zip(found.routine.functions, in_c.singles, calls, strict=True):
        values = [drawn[i.name] for i in function.inputs]
        wanted = np.broadcast_to(call(*values), POINTS)
        got = singly(in_c.code[single], ctypes.c_double, values)
        assert np.array_equal(np.isnan(got), np.isnan(wanted)), function.name
    if status and found.routine.checks:
        values = [drawn[i.name] for i in found.routine.checks.inputs]
        got = singly(in_c.code[f"{found.mechanism.name}_status"], ctypes.c_int, values)
        assert np.array_equal(got, np.broadcast_to(status(*values), POINTS))


def test_the_exceptions_are_results() -> None:
    for name, results in (*NEAR_ZERO.items(), *BALANCES.items()):
        text = SHEETS[name].read_text("utf-8")
        assert [r for r in results if f"let {r} " not in text] == []


def shaken(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that is off by a unit in the last place, up or down, or not at all."""

    def off(*arguments: Any) -> Any:
        value = np.asarray(function(*arguments), dtype=float)
        first = np.broadcast_to(np.asarray(arguments[0], dtype=float), value.shape)
        digits = np.ascontiguousarray(first).view(np.uint64) * np.uint64(0x9E3779B97F4A7C15)
        way = (digits >> np.uint64(33)) % np.uint64(3)
        up, down = np.nextafter(value, np.inf), np.nextafter(value, -np.inf)
        return np.where(way == 0, value, np.where(way == 1, up, down))

    return off


def singly(call: Any, returned: Any, values: Sequence[np.ndarray]) -> np.ndarray:
    """Return the value of a function of C at each point."""
    call.restype, call.argtypes = returned, [ctypes.c_double] * len(values)
    return np.array([call(*(v[i] for v in values)) for i in range(POINTS)])
