"""The interpreter, emitted Python and compiled C, run on the same random poses."""

import ctypes
import shutil
import subprocess
from collections.abc import Callable, Iterator, Sequence
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from mechc.base.frozen import replace
from mechc.emit.c.to_c import TARGET as C
from mechc.emit.python.to_python import TARGET as PYTHON
from mechc.emit.target import Compiled, Options
from mechc.formula.tree import Formula, Power, Symbol, product
from mechc.formula.walk import children, rebuild
from mechc.routine.evaluate import evaluate
from mechc.routine.steps import Function, Input, Routine, Solve
from mechc.units import LENGTH, NUMBER

COMPILER = shutil.which("gcc") or shutil.which("cc")


ULP = 2.0**-52


POSES = 40


ROUNDED_ZERO = 1e-30
"""What is smaller is rounding of a zero, in SI: two roundings multiplied are 5e-32.

A load that does no work presses joints by 1e-16 of itself, and friction makes 1e-16 of that.
"""

NOISE, DRAWS = 1e-10, 6
"""The part of itself by which an operation is off, and how often that is drawn."""

OFF = "off "
"""How the factors begin by which operations are off."""


Outputs = dict[str, np.ndarray]


def poses(function: Function, seed: int = 0) -> dict[str, np.ndarray]:
    """Return random inputs in their ranges, near their defaults where they have none."""
    random = np.random.default_rng(seed)
    return {i.name: random.uniform(*span(i), POSES) for i in function.inputs}


def span(item: Input) -> Sequence[float]:
    if item.low is not None and item.high is not None:
        return item.low, item.high
    if item.default is not None:
        return sorted((0.9 * item.default, 1.1 * item.default))
    return (0.5, 2.0) if item.dimension == LENGTH else (-100.0, 100.0)


def by_interpreter(found: Compiled) -> Outputs:
    return {f.name: np.broadcast_to(evaluate(f, poses(f)), POSES) for f in found.routine.functions}


def by_python(found: Compiled) -> Outputs:
    (module,) = PYTHON.emit(found, Options("module"))
    space: dict[str, Callable[..., np.ndarray]] = {"__name__": "module"}
    exec(compile(module.text, "module.py", "exec"), space)
    made = (v for v in space.values() if getattr(v, "__module__", "") == "module")
    beside = companions(found)
    callables = [v for v in made if not v.__name__.startswith(("_", "pose", "points", *beside))]
    return {
        f.name: np.broadcast_to(call(*poses(f).values()), POSES)
        for f, call in zip(found.routine.functions, callables, strict=True)
    }


def companions(found: Compiled) -> tuple[str, ...]:
    """Return the names of functions that stand beside results with friction, or of a sheet."""
    listed = [f for r in found.routine.functions for f in (r.otherwise, r.status) if f]
    return (*(f.name for f in listed), *(["status"] if found.routine.checks else []))


def built(found: Compiled, folder: Path, compiler: str | None = COMPILER) -> SimpleNamespace:
    """Return the compiled library and the linker's names in order: singles and batches."""
    source, header = C.emit(found, Options("code"))
    for file in (source, header):
        (folder / file.name).write_text(file.text, encoding="utf-8")
    strict = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]
    made = folder / "code.so"
    command = [compiler, *strict, "-O1", "-fPIC", "-shared", "code.c", "-o", made, "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    positional = header.text.split("typedef struct")[0].splitlines()
    heads = [line for line in positional if line.startswith(("double ", "void "))]
    beside = (*companions(found), "pose_n", "points_n")
    others = tuple(f"{found.routine.name}_{name}" for name in beside)
    names = [line.split("(")[0].split()[1] for line in heads]
    names = [name for name in names if not name.startswith(others)]
    return SimpleNamespace(code=ctypes.CDLL(str(made)), singles=names[::2], batches=names[1::2])


def by_c_singly(found: Compiled, made: SimpleNamespace) -> Outputs:
    outputs = {}
    for function, name in zip(found.routine.functions, made.singles, strict=True):
        call = made.code[name]
        call.restype = ctypes.c_double
        call.argtypes = [ctypes.c_double] * len(function.inputs)
        columns = list(poses(function).values())
        outputs[function.name] = np.array([call(*(c[i] for c in columns)) for i in range(POSES)])
    return outputs


def by_c_in_batch(found: Compiled, made: SimpleNamespace) -> Outputs:
    outputs = {}
    array = np.ctypeslib.ndpointer(dtype=np.float64)
    for function, name in zip(found.routine.functions, made.batches, strict=True):
        call = made.code[name]
        call.restype = None
        call.argtypes = [ctypes.c_size_t] + [array] * (len(function.inputs) + 1)
        outputs[function.name] = np.empty(POSES)
        call(POSES, *poses(function).values(), outputs[function.name])
    return outputs


def sensitivity(function: Function) -> np.ndarray:
    """Return by how much the output moves where every operation is off by a part of itself.

    It is what rounding errors grow by, whatever the order of the operations: near a pole, or
    where a loop comes to its end, it is large, and infinite where a step has no value any more.
    """
    values, random = poses(function), np.random.default_rng(0)
    middle, disturbed = evaluate(function, values), _disturbed(function)
    names = [i.name for i in disturbed.inputs[len(function.inputs) :]]
    moved = []
    for _ in range(DRAWS):
        parts = 1 + random.uniform(-NOISE, NOISE, len(names))
        moved.append(evaluate(disturbed, {**values, **dict(zip(names, parts, strict=True))}))
    found = np.abs(np.array([np.broadcast_to(m - middle, POSES) for m in moved])) / NOISE
    return np.where(np.isnan(found), np.inf, found).max(axis=0)


def _disturbed(function: Function) -> Function:
    """Return a function in which each operation is multiplied by an input of its own."""
    number = count()
    steps = tuple(
        replace(s, arguments=tuple(_off(a, number) for a in s.arguments))
        if isinstance(s, Solve)
        else replace(s, formula=_off(s.formula, number))
        for s in function.steps
    )
    output = _off(function.output, number)
    parts = tuple(Input(f"{OFF}{i}", NUMBER) for i in range(next(number)))
    inputs = (*function.inputs, *parts)
    return replace(function, inputs=inputs, steps=steps, output=output, otherwise=None)


def _off(formula: Formula, number: Iterator[int]) -> Formula:
    exponents = {len(children(formula)) - 1} if isinstance(formula, Power) else set()
    parts = (p if i in exponents else _off(p, number) for i, p in enumerate(children(formula)))
    return product([(rebuild(formula, tuple(parts)), 1), (Symbol(f"{OFF}{next(number)}"), 1)])


def assert_close(found: Outputs, expected: Outputs, ulps: int, routine: Routine) -> None:
    assert list(found) == list(expected)
    for function in routine.functions:
        name, values = function.name, expected[function.name]
        assert np.array_equal(np.isnan(found[name]), np.isnan(values)), name
        with np.errstate(invalid="ignore"):
            error = np.abs(found[name] - values)
            is_off = np.isfinite(values) & (error > ulps * ULP * np.abs(values) + ROUNDED_ZERO)
            if is_off.any():
                is_off &= (
                    error > ulps * ULP * (np.abs(values) + sensitivity(function)) + ROUNDED_ZERO
                )
        assert not is_off.any(), (name, found[name][is_off], values[is_off])
