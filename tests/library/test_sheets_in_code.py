"""Every sheet of the library and the examples, in C and Python at the same random points."""

import ctypes
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mechc.driver import Compilation, compile_source
from mechc.emit.python.to_python import TARGET as PYTHON
from mechc.emit.target import Options
from mechc.files import library, mechanisms, read
from paths import EXAMPLES
from run_targets import COMPILER, ULP, built, companions

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(COMPILER is None, reason="no C compiler"),
]

POINTS = 200

FEW = 8
"""Units in the last place, of the value and of what the inputs' own rounding moves it by."""

SHEETS = {name: library()[name] for name in sorted(library().keys() - mechanisms().keys())}
SHEETS |= {"examples/gripper": EXAMPLES / "gripper" / "gripper.mech"}
SHEETS |= {"examples/pin": EXAMPLES / "pin.mech"}

Call = Callable[..., np.ndarray]


def by_python(found: Compilation) -> tuple[list[Call], Call | None]:
    """Return the functions of the emitted module in order, and that of the status, if any."""
    (module,) = PYTHON.emit(found, Options("module"))
    space: dict[str, Call] = {"__name__": "module"}
    exec(compile(module.text, "module.py", "exec"), space)
    made = [n for n, v in space.items() if getattr(v, "__module__", "") == "module"]
    beside = ("_", "pose", "points", *companions(found))
    return [space[n] for n in made if not n.startswith(beside)], space.get("status")


def inputs(found: Compilation) -> dict[str, np.ndarray]:
    """Return the values of all parameters, then random ones around their ranges, some outside."""
    random = np.random.default_rng(7)
    drawn = {}
    for item in (i for f in found.routine.functions for i in f.inputs):
        middle = 1.0 if item.default is None else item.default
        low = 0.6 * middle if item.low is None else item.low
        high = 1.5 * middle if item.high is None else item.high
        margin = 0.05 * (high - low) or 0.1
        ends = sorted((low - margin, high + margin))
        values = random.uniform(*ends, POINTS)
        values[0] = middle
        drawn.setdefault(item.name, values)
    return drawn


def moved_by_rounding(call: Call, values: Sequence[np.ndarray]) -> np.ndarray:
    """Return by how much a result moves where each input moves by its own size, to first order."""
    step, middle = 1e-7, call(*values)
    moves = np.zeros(POINTS)
    for i, value in enumerate(values):
        moved = call(*values[:i], value * (1 + step), *values[i + 1 :])
        moves = moves + np.nan_to_num(np.abs(moved - middle) / step)
    return moves


@pytest.mark.parametrize("name", SHEETS)
def test_c_is_within_a_few_units_of_python(name: str, tmp_path: Path) -> None:
    found = compile_source(read(SHEETS[name]))
    in_c, drawn, (calls, status) = built(found, tmp_path), inputs(found), by_python(found)
    compared = 0
    for function, single, call in zip(found.routine.functions, in_c.singles, calls, strict=True):
        values = [drawn[i.name] for i in function.inputs]
        wanted = np.broadcast_to(call(*values), POINTS)
        got = singly(in_c.code[single], ctypes.c_double, values)
        assert np.array_equal(np.isnan(got), np.isnan(wanted)), function.name
        bound = FEW * ULP * (np.abs(wanted) + moved_by_rounding(call, values))
        assert np.all((np.abs(got - wanted) <= bound) | ~np.isfinite(wanted)), function.name
        compared += int(np.isfinite(wanted).sum())
    assert compared
    if status and found.routine.checks:
        values = [drawn[i.name] for i in found.routine.checks.inputs]
        got = singly(in_c.code[f"{found.mechanism.name}_status"], ctypes.c_int, values)
        assert np.array_equal(got, np.broadcast_to(status(*values), POINTS))


def singly(call: Any, returned: Any, values: Sequence[np.ndarray]) -> np.ndarray:
    """Return what a function of C gives at each point."""
    call.restype, call.argtypes = returned, [ctypes.c_double] * len(values)
    return np.array([call(*(v[i] for v in values)) for i in range(POINTS)])
