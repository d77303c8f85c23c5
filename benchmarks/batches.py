"""Emitted batches, and slopes, against AVX-512 by hand; arrays that fit the cache."""

import ctypes
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from emitted import HERE, Array, pointer
from measure import medians, table
from mechc.compilation import Compilation, compile_source, emit
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.files import library, read
from mechc.routine.steps import Input

NAMES = ("crank_slider", "karpenko_fig9_packet_clamp", "crank_rocker", "watt_closed")
POSES = 4096
COMPILERS = ("gcc", "clang")
ALLOWED = 1.15
"""What an emitted batch in cache may take, as a multiple of the one by hand."""

ALLOWED_SLOPES = 3.0
"""What k with all its slopes may take, as a multiple of k."""

FLAGS = ("-O3", "-march=native", "-fPIC", "-shared")


def batches(rounds: int) -> None:
    """Time emitted batches of k, and of k with its slopes, against k by hand."""
    macros = subprocess.run(
        ["gcc", "-march=native", "-dM", "-E", "-"], input="", capture_output=True, text=True
    )
    if "__AVX512DQ__" not in macros.stdout:
        print("\nNo AVX-512: what is written by hand for it cannot run here")
        return
    found = {name: _times(name, rounds) for name in NAMES}
    rows = [
        _row(f"{n}, {c}", t[c] / t["hand"], ALLOWED) for n, t in found.items() for c in COMPILERS
    ]
    heading = ("mechanism", "ratio", "goal", "reached")
    table(f"Emitted batch of {POSES} poses; AVX-512 by hand = 1", heading, rows)
    slopes = [_row(f"{n}, gcc", t["slopes"] / t["gcc"], ALLOWED_SLOPES) for n, t in found.items()]
    table("The same with all slopes; the emitted batch of k = 1", heading, slopes)


def _row(name: str, ratio: float, goal: float) -> tuple[object, ...]:
    return name, ratio, goal, "yes" if ratio <= goal else "no"


def _times(name: str, rounds: int) -> dict[str, float]:
    """Return what the batch by hand takes, those of both compilers, and the one with slopes."""
    compilation = compile_source(read(library()[name]))
    inputs = compilation.routine.functions[0].inputs
    given = [_values(item, seed) for seed, item in enumerate(inputs)]
    with TemporaryDirectory() as folder:
        own = Path(folder) / "own.c"
        own.write_text(_code(compilation), encoding="utf-8")
        hand = _run(_built("gcc", HERE / "by_hand_avx512.c"), f"{name}_by_hand", given, 1)
        runs = {c: _run(_built(c, own), f"{name}_k_n", given, 1) for c in COMPILERS}
        slopes = _run(_built("gcc", own), f"{name}_k_gradient_n", given, 1 + len(given))
        for run in (*runs.values(), slopes):
            assert np.max(np.abs(run() / hand() - 1)) < 1e-12, "by hand it is another k"
        return medians({**runs, "hand": hand, "slopes": slopes}, rounds)


def _values(item: Input, seed: int) -> Array:
    """Return values in the range, or near the default."""
    near = (0.99 * item.default, 1.01 * item.default)
    low, high = near if item.low is None else (item.low, item.high)
    return np.random.default_rng(seed).uniform(low, high, POSES)


def _code(compilation: Compilation) -> str:
    (file,) = emit(compilation, registry.load("c"), Options("k", single=True, gradient=True))
    return file.text


def _built(compiler: str, source: Path) -> ctypes.CDLL:
    with TemporaryDirectory() as folder:
        target = Path(folder) / "made.so"
        command = [compiler, *FLAGS, str(source), "-o", str(target), "-lm"]
        subprocess.run(command, check=True)
        return ctypes.CDLL(str(target))


def _run(made: ctypes.CDLL, name: str, given: Sequence[Array], outputs: int) -> Callable[[], Array]:
    """Return what runs a batch and returns its first array."""
    found = [np.empty(POSES) for _ in range(outputs)]
    arguments = [ctypes.c_size_t(POSES), *map(pointer, [*given, *found])]
    batch = getattr(made, name)
    return lambda: (batch(*arguments), found[0])[1]
