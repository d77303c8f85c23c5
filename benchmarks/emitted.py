"""Emitted C against C by hand.

``gcc -O2`` compiles both sides alike, into libraries of their own; the loop over the poses
is in C, so that no call from Python is timed with them.
"""

import ctypes
import subprocess
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray

from measure import medians, table
from mechc.compilation import Compilation, compile_source, emit
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.files import library, read
from mechc.routine.steps import Input

HERE = Path(__file__).parent
Array = NDArray[np.float64]

ALLOWED = 1.3
"""What emitted scalar C may take, as a multiple of C by hand."""

# ------------------------------------------------------------------- (e) scalar C


def scalar(rounds: int) -> None:
    """Time emitted scalar functions against functions by hand that give the same k."""
    rows = [_against_hand(name, rounds) for name in ("crank_rocker", "watt_closed")]
    heading = ("mechanism", "time / by hand", "allowed", "worst difference")
    table("Emitted scalar C; the same k by hand in coordinates = 1", heading, rows)


def _against_hand(name: str, rounds: int) -> tuple[object, ...]:
    compilation = compile_source(read(library()[name]))
    inputs = compilation.routine.functions[0].inputs
    with TemporaryDirectory() as folder:
        own = Path(folder) / f"{name}.c"
        own.write_text(code(compilation), encoding="utf-8")
        runs = {
            which: _sweep(function, source, inputs, compilation)
            for which, function, source in (
                ("own", f"{name}_k", own),
                ("hand", f"{name}_by_hand", HERE / "by_hand.c"),
            )
        }
        found, expected = runs["own"](), runs["hand"]()
        difference = float(np.max(np.abs(found / expected - 1)))
        assert difference < 1e-12, "the function by hand computes another k"
        times = medians(runs, rounds)
    return name, times["own"] / times["hand"], ALLOWED, difference


def code(compilation: Compilation) -> str:
    """Return the emitted C."""
    files = emit(compilation, registry.load("c"), Options("k", single=True))
    return next(file.text for file in files)


def _sweep(
    function: str, source: Path, inputs: Sequence[Input], compilation: Compilation
) -> Callable[[], Array]:
    """Return what fills an array with a function's values along the stroke."""
    given = ", ".join(repr(i.default) for i in inputs[:-1])
    types = ", ".join("double" for _ in inputs)
    loop = f"""#include <stddef.h>
        double {function}({types});
        void sweep(size_t n, const double *drive, double *k)
        {{ for (size_t i = 0; i < n; ++i) k[i] = {function}({given}, drive[i]); }}"""
    run = built([source], loop).sweep
    drive = stroke(compilation, 5000)
    k = np.empty_like(drive)
    return lambda: (run(ctypes.c_size_t(len(k)), pointer(drive), pointer(k)), k)[1]


def built(sources: Iterable[Path], more: str = "") -> ctypes.CDLL:
    """Return a library of C sources and a text."""
    with TemporaryDirectory() as folder:
        target, extra = Path(folder) / "own.so", Path(folder) / "more.c"
        extra.write_text(more, encoding="utf-8")
        options = ["-std=c99", "-O2", "-fPIC", "-shared", "-o", str(target)]
        subprocess.run(["gcc", *options, *map(str, sources), str(extra), "-lm"], check=True)
        return ctypes.CDLL(str(target))


def pointer(values: NDArray[np.generic]) -> ctypes.c_void_p:
    """Return where an array begins."""
    return ctypes.c_void_p(values.ctypes.data)


def stroke(compilation: Compilation, poses: int) -> Array:
    """Return values of the drive, its two ends apart."""
    drive = compilation.mechanism.drive
    (given,) = (i for i in compilation.routine.functions[0].inputs if i.name == drive.parameter)
    return np.linspace(given.low, given.high, poses + 2)[1:-1]
