"""Measure mechc against its peers and itself: ``python benchmarks/run.py [--quick] [PART …]``.

Every figure is a ratio of times taken in turns in one run, a fitted exponent or a
count, so that it means the same on another machine.
"""

import argparse
import os
import random
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import sympy

import peers
from batches import batches
from emitted import scalar
from generators import (
    closed_four_bar_chain,
    coupler_chain,
    four_bar_chain,
    frictional_four_bar_chain,
    scissor,
    uneven_scissor,
)
from measure import exponent, medians, table, timed
from mechc.base.frozen import replace
from mechc.compilation import Compilation, compile_source, emit
from mechc.diagnostics import Report
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.files import library, mechanisms, read
from mechc.formula.to_sympy import to_sympy
from mechc.kinematics.from_pose import plan_velocities
from mechc.model.from_syntax import resolve
from mechc.model.mechanism import Mechanism
from mechc.pose.from_model import solve_pose
from mechc.power.balance import Balance
from mechc.power.from_plan import balance
from mechc.source import Source
from precision import precision


class Chain(NamedTuple):
    """Descriptions of any size, and the goal of their time exponent.

    What takes long has only a ``part`` of the stages that others have.
    """

    text: Callable[[int], str]
    goal: float = 1.1
    part: int = 1


CHAINS = {
    "scissor, equal stages": Chain(scissor),
    "scissor, different stages": Chain(uneven_scissor),
    "chain of four-bars": Chain(four_bar_chain),
    "chain of closed four-bars": Chain(closed_four_bar_chain),
    "… with friction in all pins": Chain(frictional_four_bar_chain, goal=1.2, part=2),
    "chain of couplers": Chain(coupler_chain),
}

START = {
    "compile to latex": 0.35,
    "compile to python": 0.35,
    "compile to c": 0.35,
    "compile to c, again": 0.06,
    "check": 0.3,
    "check, with friction": 0.5,
}
"""What each process may take at most, when ``import sympy`` is 1: the goal."""

FASTER = {"four_bar": 300, "stephenson_six_bar": 600}
"""How many times faster k is to come than by its peer: the goal."""

STROKES = {"jansen_leg": 0.5, "double_butterfly": 0.3, "triad_closed": 0.08}
"""What each stroke may take at most, when ``import sympy`` is 1: the goal."""

PATIENCE = 2.0
"""Seconds for one compilation beyond which a chain of more than one size is not made longer."""


def main() -> None:
    """Run the comparisons asked for, or every one, and print their tables."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--quick", action="store_true", help="fewer rounds, shorter chains")
    options.add_argument("--plot", metavar="FILE", help="draw the part contenders, by matplotlib")
    options.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    chosen = options.parse_args()
    if strangers := set(chosen.parts) - PARTS.keys():
        options.error(f"no such part: {', '.join(sorted(strangers))}")
    for name, run in PARTS.items():
        if name in chosen.parts or not chosen.parts:
            found = run(chosen.quick)
            if name == "contenders" and chosen.plot:
                from contenders import plotted

                plotted(found, chosen.plot)


# --------------------------------------------------------------- (a) the whole process


def cold_start(
    rounds: int,
    name: str = "karpenko_fig9_packet_clamp",
    with_friction: str = "karpenko_fig9_with_friction",
) -> None:
    """Time whole processes, from the shell's start to the file, against ``import sympy``.

    All run from bytecode, as what is installed does, wherever this is measured.
    """
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"PYTHONPYCACHEPREFIX": folder}
        environment["MECHC_CACHE"] = ""
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        commands = {"import sympy": [sys.executable, "-c", "import sympy"]}
        for target in ("latex", "python", "c"):
            commands[f"compile to {target}"] = [
                *(sys.executable, "-m", "mechc", "compile", name),
                *("--emit", target, "-o", str(Path(folder) / f"k.{target}")),
            ]
        commands["check"] = [sys.executable, "-m", "mechc", "check", name]
        commands["check, with friction"] = [*commands["check"][:-1], with_friction]
        runs = {n: _process(c, environment) for n, c in commands.items()}
        kept = environment | {"MECHC_CACHE": str(Path(folder) / "kept")}
        runs["compile to c, again"] = _process(commands["compile to c"], kept)
        runs["compile to c, again"]()
        times = medians(runs, rounds)
    unit = times["import sympy"]
    rows = [(n, t / unit, START.get(n, "")) for n, t in times.items()]
    table("Cold start, whole process; import sympy = 1", ("process", "ratio", "goal"), rows)


def _process(command: list[str], environment: dict[str, str]) -> Callable[[], object]:
    return lambda: subprocess.run(command, check=True, capture_output=True, env=environment)


# ------------------------------------------------------------------ (b) k alone, warm


def derivation(rounds: int) -> None:
    """Time k against Kane's method and ``simplify``.

    Alone, from the mechanism, whose names and units are resolved as the peer's are in its
    source, to the one result that the peer computes; and, for what a user sees, from the
    parsed text to all that it asks for.
    """
    pairs = (("four_bar", peers.four_bar), ("stephenson_six_bar", peers.stephenson))
    rows = [_against(name, peer, rounds) for name, peer in pairs]
    heading = ("mechanism", "alone", "goal", "from parsed text", "operations", "peer's")
    table("How many times faster k comes than by Kane + simplify", heading, rows)


def _against(name: str, peer: Callable[[], sympy.Expr], rounds: int) -> tuple[object, ...]:
    source = read(library()[name])
    compilation = Compilation(source)
    tree, whole = compilation.tree, compilation.mechanism
    mechanism = replace(whole, finds=whole.finds[:1], lets=())
    own, other = to_sympy(solve(mechanism, source).results[0].formula), peer()
    _agree(own, other)
    runs = {
        "model": lambda: solve(mechanism, source),
        "text": lambda: solve(resolve(tree, Report(source)), source),
        "peer": peer,
    }
    times = medians(runs, rounds)
    alone, with_text = (times["peer"] / times[start] for start in ("model", "text"))
    return name, alone, FASTER[name], with_text, sympy.count_ops(own), sympy.count_ops(other)


def solve(mechanism: Mechanism, source: Source) -> Balance:
    """Return the solved power equation of a mechanism."""
    report = Report(source)
    return balance(plan_velocities(solve_pose(mechanism, report), report), report)


def _agree(own: sympy.Expr, other: sympy.Expr) -> None:
    chance = random.Random(3)
    symbols = own.free_symbols | other.free_symbols
    values = {s: chance.uniform(0.5, 1.5) for s in sorted(symbols, key=str)}
    one, two = float(own.subs(values)), float(other.subs(values))
    assert abs(one - two) < 1e-9 * abs(one), "the peer computes another k"


# ------------------------------------------------------------------------ (c) growth


def growth(sizes: tuple[int, ...], rounds: int) -> None:
    """Fit how compile time and the size of emitted C grow with the number of stages."""
    rows = []
    for title, chain in CHAINS.items():
        stages = tuple(n // chain.part for n in sizes)
        rows.append((title, *_growing(chain.text, stages, rounds), chain.goal))
    heading = ("chain", "stages", "size exponent", "time exponent", "goal")
    table("Growth to the most stages within patience", heading, rows)


def _growing(
    chain: Callable[[int], str], sizes: tuple[int, ...], rounds: int
) -> tuple[int, float, float]:
    times: list[float] = []
    for n in sizes:
        times.append(_best(Source("chain.mech", chain(n)), rounds))
        if times[-1] > PATIENCE and len(times) > 1:
            break
    reached = sizes[: len(times)]
    code = [_bytes_of_c(Source("chain.mech", chain(n))) for n in reached]
    return reached[-1], exponent(reached, code), exponent(reached, times)


def _best(source: Source, rounds: int) -> float:
    return min(timed(lambda: compile_source(source)) for _ in range(rounds))


def _bytes_of_c(source: Source) -> float:
    files = emit(compile_source(source), registry.load("c"), Options("chain"))
    return float(sum(len(file.text) for file in files if file.name.endswith(".c")))


# ------------------------------------------------------------------------ (d) lengths


def lengths() -> None:
    """Count the operations of the library's first results, where a printed form is known."""
    rows = []
    for name, path in mechanisms().items():
        compilation = compile_source(read(path))
        result, *_ = compilation.solution.results
        printed = [
            sympy.count_ops(to_sympy(e.value))
            for e in compilation.mechanism.expects
            if e.subject == result.name and not e.at
        ]
        if printed:
            rows.append((name, sympy.count_ops(to_sympy(result.formula)), printed[0]))
    table("Operations in k", ("mechanism", "own", "printed"), rows)


# ------------------------------------------------------------------- (h) strokes


def strokes(rounds: int) -> None:
    """Time strokes of what has been compiled, 37 rows each, against ``import sympy``."""
    unit = [sys.executable, "-c", "import sympy"]
    runs = {"import sympy": _process(unit, dict(os.environ))}
    for name in STROKES:
        runs[name] = partial(compile_source(read(library()[name])).stroke, 37)
    times = medians(runs, rounds)
    rows = [(name, times[name] / times["import sympy"], goal) for name, goal in STROKES.items()]
    table("A stroke of 37 rows; import sympy = 1", ("mechanism", "ratio", "goal"), rows)


# ------------------------------------------------- (e) to (g), in files of their own


def iterated(rounds: int) -> None:
    """Time emitted solvers; SciPy is asked for only here."""
    from iterated import implicit

    implicit(rounds)


def many_poses(poses: int, rounds: int) -> Mapping[str, Mapping[str, float]]:
    """Time many poses by what is emitted and by peers that are installed."""
    from contenders import contenders

    return contenders(poses, rounds)


PARTS: dict[str, Callable[[bool], Any]] = {
    "operations": lambda quick: lengths(),
    "start": lambda quick: cold_start(rounds=3 if quick else 15),
    "derivation": lambda quick: derivation(rounds=2 if quick else 9),
    "growth": lambda quick: growth(
        (4, 8, 16) if quick else (4, 8, 16, 32, 64), rounds=1 if quick else 3
    ),
    "strokes": lambda quick: strokes(rounds=2 if quick else 9),
    "scalar": lambda quick: scalar(rounds=15 if quick else 75),
    "batch": lambda quick: batches(rounds=15 if quick else 75),
    "contenders": lambda quick: many_poses(
        poses=10**6 if quick else 10**7, rounds=2 if quick else 5
    ),
    "implicit": lambda quick: iterated(rounds=5 if quick else 25),
    "precision": lambda quick: precision(poses=7 if quick else 51),
}
"""What can be measured, quickly or with care."""


if __name__ == "__main__":
    main()
