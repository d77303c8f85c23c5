"""The mechanisms that tests compile whole: the library, and a corpus with one construct each."""

from functools import cache

import mechc
from mechc.compilation import Compilation, complete
from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.notation import read
from paths import CORPUS, LIBRARY

GOOD = sorted((CORPUS / "good").glob("*.mech"))
OF_LIBRARY = sorted(p for p in LIBRARY.iterdir() if p.suffix in {".mech", ".yaml"})
ALL = {path.stem: path for path in (*OF_LIBRARY, *GOOD)}


@cache
def begun(name: str) -> Compilation:
    """Return a mechanism whose stages run as they are asked for, each once for all tests."""
    path = ALL[name]
    return Compilation(Source(path.name, path.read_text(encoding="utf-8")))


@cache
def loaded(name: str) -> "mechc.Mechanism":
    """Return a mechanism of the library as a user has it, solved once for all tests."""
    return mechc.load(name)


def compiled(name: str) -> Compilation:
    """Return a mechanism after every stage."""
    return complete(begun(name))


@cache
def tree_of(name: str) -> ast.File:
    return read(begun(name).source, Report(begun(name).source))


CLOSED = (
    "crank_rocker",
    "double_crank",
    "double_rocker",
    "triple_rocker",
    "whitworth",
    "oscillating_cylinder",
    "toggle_clamp",
    "vice_grip",
    "watt_closed",
    "stephenson_closed",
    "peaucellier_closed",
    "excavator_arm",
    "gripper_closed",
    "steering_trapezium",
    "triad_closed",
    "double_butterfly",
    "hoeken",
    "jansen_leg",
    "crank_shaper",
    "scissor_table",
    "landing_gear",
    "crimping_tool",
)


PARTS = (0.15, 0.4, 0.65, 0.9)
