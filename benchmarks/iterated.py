"""Loops that only iteration closes: emitted C against SciPy's ``fsolve``."""

import ctypes
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from scipy.optimize import fsolve

from emitted import Array, built, code, pointer, stroke
from measure import medians, table
from mechc.compilation import compile_source
from mechc.files import library, read
from mechc.formula.derivative import jacobian
from mechc.formula.numeric.newton import TINY
from mechc.formula.to_text import text
from mechc.formula.tree import Formula
from mechc.routine.sharing import share
from mechc.routine.steps import PoseProgram, Solve, Solver

WANTED = 100
"""How many times as fast as ``fsolve`` an emitted solver should be."""


def implicit(rounds: int, name: str = "triad_closed") -> None:
    """Time an emitted solver against ``fsolve`` on its equations, to the same tolerance.

    ``fsolve`` starts each pose from the one before; the emitted solver starts each from
    the default pose, as it must to stay on the branch that is meant.
    """
    compilation = compile_source(read(library()[name]))
    pose = compilation.routine.pose
    (solver,) = (s.solver for s in pose.steps if isinstance(s, Solve))
    poses = 100
    drive = stroke(compilation, poses)
    with TemporaryDirectory() as folder:
        own = Path(folder) / "own.c"
        own.write_text(code(compilation), encoding="utf-8")
        runs: dict[str, Callable[[], Array]] = {
            "own": _poses(built([own]), f"{name}_pose_n", pose, drive),
            "fsolve with the Jacobian": _followed(solver, drive, slopes=True),
            "fsolve without": _followed(solver, drive, slopes=False),
        }
    found = {which: run() for which, run in runs.items()}
    for which, values in found.items():
        assert np.max(np.abs(values - found["own"])) < 1e-9, f"{which} solves something else"
    times = medians(runs, rounds)
    rows = [(w, times[w] / times["own"], WANTED) for w in runs if w != "own"]
    table(f"Time per pose of {name}; emitted C = 1", ("peer", "ratio", "wanted"), rows)


def _poses(
    library_: ctypes.CDLL, name: str, pose: PoseProgram, drive: Array
) -> Callable[[], Array]:
    found = np.empty((len(pose.outputs), len(drive)))
    status = np.empty(len(drive), dtype=np.intc)
    moving = len(pose.inputs) - 1
    given = [np.full_like(drive, i.default) for i in pose.inputs[:moving]]
    arguments = [*map(pointer, [*given, drive, *found, status])]

    def run() -> Array:
        getattr(library_, name)(ctypes.c_size_t(len(drive)), *arguments)
        assert not status.any()
        return found.T

    return run


def _followed(solver: Solver, drive: Array, slopes: bool) -> Callable[[], Array]:
    """Return a run of ``fsolve`` from the default pose to both ends of the stroke."""
    equations, rows = python_of(solver)
    fixed, middle = solver.anchor[:-1], solver.anchor[-1]
    ahead = [i for i, phi in enumerate(drive) if phi >= middle]
    behind = [i for i, phi in enumerate(drive) if phi < middle][::-1]

    def run() -> Array:
        found = np.empty((len(drive), len(solver.unknowns)))
        for way in (ahead, behind):
            x: Sequence[float] | Array = solver.start
            for i in way:
                arguments = (*fixed, float(drive[i]))
                x = fsolve(equations, x, arguments, rows if slopes else None, xtol=TINY)
                found[i] = x
        return found

    return run


def python_of(solver: Solver) -> tuple[Callable[..., object], Callable[..., object]]:
    """Return a system's equations and its Jacobian as functions on plain floats.

    Parts that occur twice are computed once, and no array is made: the quickest form for
    so few numbers.
    """
    slopes = jacobian(solver.equations, solver.unknowns)
    width = len(solver.unknowns)
    flat = [entry for row in slopes for entry in row]
    return _function(solver, solver.equations, 0), _function(solver, flat, width)


def _function(solver: Solver, formulas: Sequence[Formula], width: int) -> Callable[..., object]:
    steps, results = share([], formulas, [*solver.unknowns, *solver.outer])
    written = [*map(text, results)]
    rows = [f"[{', '.join(written[i : i + width])}]" for i in range(0, len(written), width or 1)]
    source = "\n    ".join(
        [
            f"def function(x, {', '.join(solver.outer)}):",
            f"{', '.join(solver.unknowns)} = x",
            *(f"{step.name} = {text(step.formula)}" for step in steps),
            f"return [{', '.join(rows if width else written)}]",
        ]
    )
    space: dict[str, Callable[..., object]] = {}
    exec(f"from math import cos, pi, sin\n{source}", space)
    return space["function"]
