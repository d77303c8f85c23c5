"""Many poses by emitted C and NumPy, and by peers from the same formula, if they are installed."""

import ctypes
import subprocess
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np
import sympy

from emitted import Array, pointer, stroke
from measure import medians, table
from mechc.compilation import Compilation, compile_source, emit
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.files import library, read
from mechc.formula.to_sympy import to_sympy

NAMES = ("crank_rocker", "watt_closed")
PEERS = ("C", "NumPy", "lambdify", "ccode", "numba", "CasADi")
FLAGS = ("-O3", "-march=native", "-fPIC", "-shared")
EVERY = {"CasADi": 100}
"""Who is so slow that every hundredth pose must do; the time is taken a hundred times."""

WANTED = 4
"""How many times as fast as ``lambdify(cse=True)`` the emitted NumPy module should be."""

Run = Callable[[], Array]


class Task(NamedTuple):
    """k of a mechanism along its stroke: its formula, the symbols and values, the drive last."""

    compilation: Compilation
    formula: sympy.Expr
    symbols: list[sympy.Symbol]
    values: list[float | Array]


def contenders(poses: int, rounds: int) -> dict[str, Mapping[str, float]]:
    """Time all that is installed and print the table; return times per pose, emitted C = 1."""
    found = {name: _ratios(_task(name, poses), rounds) for name in NAMES}
    rows = [(n, *(f"{r[p]:.3g}" if p in r else "–" for p in PEERS)) for n, r in found.items()]
    table(f"Time per pose of {poses} poses; emitted batch of C = 1", ("mechanism", *PEERS), rows)
    against = [(n, r["lambdify"] / r["NumPy"], WANTED) for n, r in found.items()]
    heading = ("mechanism", "ratio", "wanted")
    table("How many times as fast as lambdify(cse) emitted NumPy is", heading, against)
    return found


def plotted(found: Mapping[str, Mapping[str, float]], file: str) -> None:
    """Draw the times per pose as bars; this asks for matplotlib."""
    pyplot = import_module("matplotlib.pyplot")
    figure, axes = pyplot.subplots(figsize=(7, 4), layout="constrained")
    width = 0.8 / len(found)
    for i, (name, ratios) in enumerate(found.items()):
        places = [j + i * width for j, p in enumerate(PEERS) if p in ratios]
        axes.bar(places, [ratios[p] for p in PEERS if p in ratios], width, label=name)
    axes.set_xticks([j + 0.4 - width / 2 for j in range(len(PEERS))], PEERS)
    axes.set_yscale("log")
    axes.set_ylabel("time per pose, emitted C = 1")
    axes.legend()
    figure.savefig(file)


def _ratios(task: Task, rounds: int) -> dict[str, float]:
    with TemporaryDirectory() as folder:
        runs = dict(_runs(task, Path(folder)))
        expected = runs["C"]().copy()
        for which, run in runs.items():
            off = np.max(np.abs(run() / expected[:: EVERY.get(which, 1)] - 1))
            assert off < 1e-6, f"{which} computes another k"
        times = medians(runs, rounds)
    return {which: EVERY.get(which, 1) * spent / times["C"] for which, spent in times.items()}


def _task(name: str, poses: int) -> Task:
    compilation = compile_source(read(library()[name]))
    function = compilation.routine.functions[0]
    formula = to_sympy(function.formula)
    for step in reversed(function.where):
        formula = formula.subs(sympy.Symbol(step.name), to_sympy(step.formula))
    known = {s.name: s for s in formula.free_symbols}
    symbols = [known[i.name] for i in function.inputs]
    values = [*(i.default for i in function.inputs[:-1]), stroke(compilation, poses)]
    return Task(compilation, formula, symbols, values)


def _runs(task: Task, folder: Path) -> Iterator[tuple[str, Run]]:
    """Yield what computes k for all poses, by name."""
    yield "C", _batch(task, folder)
    yield "NumPy", _module(task)
    by_numpy = sympy.lambdify(task.symbols, task.formula, "numpy", cse=True)
    yield "lambdify", lambda: by_numpy(*task.values)
    yield "ccode", _ccode(task, folder)
    if find_spec("numba"):
        yield "numba", _numba(task)
    if find_spec("casadi"):
        yield "CasADi", _casadi(task)


def _code(task: Task, target: str) -> str:
    (file,) = emit(task.compilation, registry.load(target), Options("k", single=True))
    return file.text


def _built(text: str, folder: Path, name: str) -> ctypes.CDLL:
    source, made = folder / f"{name}.c", folder / f"{name}.so"
    source.write_text(text, encoding="utf-8")
    subprocess.run(["gcc", *FLAGS, str(source), "-o", str(made), "-lm"], check=True)
    return ctypes.CDLL(str(made))


def _batch(task: Task, folder: Path) -> Run:
    """Return the emitted batch, whose parameters are arrays as well."""
    routine, drive = task.compilation.routine, task.values[-1]
    batch = getattr(_built(_code(task, "c"), folder, "own"), f"{routine.name}_k_n")
    given = [np.broadcast_to(v, np.shape(drive)).copy() for v in task.values]
    k = np.empty_like(drive)
    return lambda: (batch(ctypes.c_size_t(len(k)), *map(pointer, [*given, k])), k)[1]


def _module(task: Task) -> Run:
    space: dict[str, Any] = {"__name__": "emitted"}
    exec(compile(_code(task, "python"), "emitted.py", "exec"), space)
    return lambda: space["k"](*task.values)


def _ccode(task: Task, folder: Path) -> Run:
    """Return sympy's C, parts that occur twice once, in a loop over the drive."""
    parts, (result,) = sympy.cse(task.formula)
    *fixed, drive = task.symbols
    lines = [f"const double {name} = {sympy.ccode(part)};" for name, part in parts]
    text = f"""#include <math.h>
        #include <stddef.h>
        void k_n(size_t n, const double *given, const double *drive, double *k)
        {{
            {" ".join(f"const double {s} = given[{i}];" for i, s in enumerate(fixed))}
            for (size_t i = 0; i < n; ++i) {{
                const double {drive} = drive[i];
                {" ".join(lines)}
                k[i] = {sympy.ccode(result)};
            }}
        }}"""
    batch = _built(text, folder, "ccode").k_n
    given, angles = np.array(task.values[:-1]), task.values[-1]
    k = np.empty_like(angles)
    return lambda: (batch(ctypes.c_size_t(len(k)), *map(pointer, [given, angles, k])), k)[1]


def _numba(task: Task) -> Run:
    """Return a ufunc of numba of the same parts."""
    numba = import_module("numba")
    by_math = sympy.lambdify(task.symbols, task.formula, "math", cse=True)
    ufunc = numba.vectorize(["f8({})".format(", ".join(["f8"] * len(task.symbols)))])(by_math)
    return lambda: ufunc(*task.values)


def _casadi(task: Task) -> Run:
    """Return CasADi's virtual machine, to which all poses are handed at once."""
    casadi = import_module("casadi")
    symbols = [casadi.SX.sym(str(s)) for s in task.symbols]
    formula = sympy.lambdify(task.symbols, task.formula, [casadi, {"pi": np.pi}], cse=True)
    function = casadi.Function("k", symbols, [formula(*symbols)])
    given = [*task.values[:-1], casadi.DM(task.values[-1][:: EVERY["CasADi"]]).T]
    return lambda: np.asarray(function(*given)).ravel()
