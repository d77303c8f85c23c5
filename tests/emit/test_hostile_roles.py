"""Hostile names in every role: what is emitted compiles, runs, and has the values of evaluate."""

import json
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from itertools import cycle
from pathlib import Path

import pytest

import mechc
from hostile_names import HOSTILE
from mechc.emit.c import library

STRICT = ["-Wall", "-Wextra", "-Werror", "-pedantic", "-O1", "-I."]
COMPILERS = {
    "gcc": ["gcc", "-std=c99", "-xc"],
    "clang": ["clang", "-std=c99", "-xc"],
    "g++": ["g++", "-std=c++17", "-xc++"],
}
TOGGLE = """\
mechanism toggle0 "toggle"
{params}
param l0 = {length}
param alpha0 = 10 deg in 2 deg .. 40 deg
pivot O
slider K along 90 deg
link OB
link BK
OB = l0 @ 90 deg + alpha0
BK = l0 @ 90 deg - alpha0
force P0 at B along 0 deg
{loads}
force F0 at K along -90 deg
{finds}
{lets}
"""

Names = Sequence[str]


def toggle(params: Names = (), loads: Names = (), finds: Names = (), lets: Names = ()) -> str:
    """Return a toggle whose lengths, loads, results or formulas have the names."""
    asked = [f"find {name} = P0/F0" for name in finds] or [
        "find P0" if loads else "find k0 = P0/F0"
    ]
    return TOGGLE.format(
        params="\n".join(f"param {name} = {10 + i} mm" for i, name in enumerate(params)),
        length=" + ".join(params) or "100 mm",
        loads="\n".join(f"force {name} at K along -90 deg" for name in loads),
        finds="\n".join(asked),
        lets="\n".join(f"let {name} = {i + 2}*l0*sin(alpha0)" for i, name in enumerate(lets)),
    )


def sheet(names: Names) -> str:
    """Return a sheet whose parameters, tables, lists and choices share the names."""
    params, tables, lists, lets = (names[i::4] for i in range(4))
    lines = ["sheet sheet0", "param w0 = 3 mm in 1 mm .. 9 mm"]
    for i, name in enumerate(params):
        lines.append(f"param {name} = {i + 1} mm")
    for i, name in enumerate(tables):
        lines += [f"table {name} = 0 mm: {i}, 10 mm: {i + 3}", f"let t_{i}q = {name} at w0"]
    for i, name in enumerate(lists):
        lines += [f"list {name} = {i + 1} mm, {i + 20} mm", f"let l_{i}q = next w0 in {name}"]
    for i, name in enumerate(lets):
        other = params[i % len(params)]
        lines.append(f"let {name} = {i + 1}*w0 when w0 < {i + 2} mm else {other}*2")
    return "\n".join(lines) + "\n"


def crank(names: Names) -> str:
    """Return a driven crank with friction: a loop, a pose, equations with hostile names."""
    title, r, length, phi, f, d, torque, force, k, more, place = names[:11]
    return f"""mechanism {title} "Crank"
param {r} = 50 mm in 30 mm .. 60 mm
param {length} = 200 mm
param {phi} = 60 deg
param {f} = 0.1
param {d} = 12 mm
pivot O at (0 mm, 0 mm)
slider B along x through O
link OA
link AB
OA = {r} @ {phi}
AB = {length}
assembly B forward
drive {phi} from 10 deg to 170 deg
torque {torque} on OA
force {force} at B along -x
friction pins {f} diameter {d}
find {k} = {torque}/{force}
let {more} = 2*{r}*{k}
let {place} = x_B in mm
"""


ROLES: dict[str, tuple[int, Callable[[Names], str]]] = {
    "parameters": (80, lambda names: toggle(params=names)),
    "lets": (30, lambda names: toggle(lets=names)),
    "results": (30, lambda names: toggle(finds=names)),
    "loads": (60, lambda names: toggle(loads=names)),
    "sheet": (120, sheet),
}
"""How many names at a time have a role, and the description in which they have it."""


@pytest.fixture(autouse=True)
def built_in_no_time(monkeypatch):
    """Build libraries without optimisation: a name is taken or refused, however quick code is."""
    monkeypatch.setattr(library, "FLAGS", ("-O0", "-fPIC", "-shared"))


def stands(text: str, folder: Path, compilers: Names) -> None:
    """Compile and run what is emitted; compare the values of C with those of evaluate."""
    mechanism = mechc.loads(text)
    source, header = mechanism.emit_files("c")
    (folder / header.name).write_text(header.text, encoding="utf-8")
    for compiler in compilers:
        if shutil.which(compiler):
            command = [*COMPILERS[compiler], *STRICT, "-c", "-", "-o", "/dev/null"]
            done = subprocess.run(
                command, input=source.text, cwd=folder, capture_output=True, text=True
            )
            assert done.returncode == 0, done.stderr[:2000]
    (folder / "emitted.py").write_text(mechanism.emit("python"), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "emitted.py"], cwd=folder, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr[-2000:]
    json.loads(mechanism.emit("json"))
    expected, found = mechanism.evaluate(), mechanism.compile().evaluate()
    assert found == pytest.approx(expected, rel=1e-12, nan_ok=True)


def chunks(names: Names, size: int) -> list[Names]:
    return [names[i : i + size] for i in range(0, len(names), size)]


def is_no_vector(name: str) -> bool:
    """Return whether a name is none of points: AA would be a direction where a length stands."""
    return not name[:2].isupper()


@pytest.mark.parametrize("role", ROLES)
def test_some_names_stand_in_every_role(role: str, tmp_path: Path) -> None:
    _, description = ROLES[role]
    stands(description(HOSTILE[7::29]), tmp_path, ["gcc"])


def test_some_names_stand_in_a_loop(tmp_path: Path) -> None:
    stands(crank(list(filter(is_no_vector, HOSTILE))[5::23]), tmp_path, ["gcc"])


@pytest.mark.slow
@pytest.mark.parametrize("role", ROLES)
def test_all_names_stand_in_every_role(role: str, tmp_path: Path) -> None:
    (size, description), compilers = ROLES[role], cycle(COMPILERS)
    for names in chunks(HOSTILE, size):
        if len(names) > 3:
            stands(description(names), tmp_path, [next(compilers)])


@pytest.mark.slow
def test_half_of_the_names_stand_in_a_loop(tmp_path: Path) -> None:
    compilers = cycle(["gcc", "clang"])
    for names in chunks(list(filter(is_no_vector, HOSTILE))[::2], 11):
        if len(names) == 11:
            stands(crank(names), tmp_path, [next(compilers)])


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no pdflatex")
@pytest.mark.parametrize("role", ROLES)
def test_all_names_stand_in_a_document(role: str, tmp_path: Path) -> None:
    size, description = ROLES[role]
    for names in chunks(HOSTILE, size):
        if len(names) > 3:
            text = mechc.loads(description(names)).emit("latex")
            (tmp_path / "a.tex").write_text(text, encoding="utf-8")
            command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-draftmode"]
            done = subprocess.run([*command, "a.tex"], cwd=tmp_path, capture_output=True)
            assert done.returncode == 0, done.stdout[-2000:]
