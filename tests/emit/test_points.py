"""The function of a mechanism's points: alike in every target, and in the stroke."""

import csv
import ctypes
import io
import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import mechc
from mechc.api import SolvedMechanism
from mechc.cli.main import main
from mechc.compilation import Compilation, compile_source
from mechc.diagnostics import MechcError
from mechc.emit.c.to_c import TARGET as C
from mechc.emit.json.to_json import TARGET as JSON
from mechc.emit.python.to_python import TARGET as PYTHON
from mechc.emit.target import Options
from mechc.model.values import defaults
from mechc.report.text.csv_of_stroke import to_csv
from mechc.report.text.stroke import to_table
from mechc.source import Source
from paths import LIBRARY

ROCKER = (LIBRARY / "triple_rocker.mech").read_text(encoding="utf-8")
"""Its crank does not turn round: beyond dead centres there is no pose."""

FAST = ROCKER.replace("drive phi", "param n = 90 rpm\ndrive phi", 1)
FAST = "\n".join(f"{t} speed n" if t.startswith("drive") else t for t in FAST.splitlines())
PLACES = np.linspace(-3.0, 3.0, 41)


@pytest.fixture(scope="module", params=[ROCKER, FAST], ids=["slopes", "accelerations"])
def rocker(request: pytest.FixtureRequest) -> Compilation:
    return compile_source(Source("rocker.mech", request.param))


def by_api(compilation: Compilation) -> tuple[dict[str, np.ndarray], np.ndarray]:
    found, status = SolvedMechanism(compilation).points(phi=PLACES)
    return {n: np.broadcast_to(v, PLACES.shape) for n, v in found.items()}, status


def test_python_gives_what_the_interpreter_gives(rocker: Compilation) -> None:
    (file,) = PYTHON.emit(rocker, Options("module"))
    space: dict = {"__name__": "module"}
    exec(compile(file.text, "module.py", "exec"), space)
    points, values = rocker.routine.points, defaults(rocker.mechanism)
    assert points is not None
    given = {i.name: PLACES if i.name == "phi" else values[i.name] for i in points.program.inputs}
    found, status = space["points"](**given)
    expected, poses = by_api(rocker)
    assert 5 < np.sum(poses == 0) < 36
    np.testing.assert_array_equal(status, poses)
    for name, value in expected.items():
        np.testing.assert_array_equal(np.broadcast_to(found[name], PLACES.shape), value)
    one, single = space["points"](**{**given, "phi": 3.0})
    assert single == 1
    assert type(one["x_A"]) is float


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_c_gives_what_the_interpreter_gives(rocker: Compilation, tmp_path: Path) -> None:
    for file in C.emit(rocker, Options("code")):
        (tmp_path / file.name).write_text(file.text, encoding="utf-8")
    strict = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]
    command = ["gcc", *strict, "-O1", "-fPIC", "-shared", "code.c", "-o", "code.so", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    points, values = rocker.routine.points, defaults(rocker.mechanism)
    assert points is not None
    batch = getattr(ctypes.CDLL(str(tmp_path / "code.so")), f"{rocker.mechanism.name}_points_n")
    array = np.ctypeslib.ndpointer(dtype=np.float64)
    inputs = [
        np.ascontiguousarray(np.broadcast_to(PLACES if i.name == "phi" else values[i.name], 41))
        for i in points.program.inputs
    ]
    outputs = {name: np.empty(41) for name in points.program.outputs}
    status = np.empty(41, dtype=np.int32)
    batch.argtypes = [ctypes.c_size_t, *[array] * (len(inputs) + len(outputs)), ctypes.c_void_p]
    batch.restype = None
    batch(41, *inputs, *outputs.values(), status.ctypes.data)
    expected, poses = by_api(rocker)
    np.testing.assert_array_equal(status, poses)
    for name, value in expected.items():
        np.testing.assert_allclose(outputs[name], value, rtol=1e-12, atol=1e-13, err_msg=name)


def test_json_has_values_and_formulas(rocker: Compilation) -> None:
    document = json.loads(JSON.emit(rocker, Options("rocker"))[0].text)["points"]
    found, _ = SolvedMechanism(rocker).points()
    assert {q["name"]: q["value"] for q in document["quantities"]} == pytest.approx(found)
    assert {q["kind"] for q in document["quantities"]} >= {"place"}
    assert all(d["formula"]["text"] for d in document["definitions"])


def test_the_stroke_has_the_columns_asked_for(rocker: Compilation) -> None:
    stroke = rocker.stroke(7, ["all"])
    found, status = SolvedMechanism(rocker).points(phi=[row.drive for row in stroke.rows])
    assert rocker.routine.points is not None
    names = [column.name for column in stroke.columns]
    assert np.sum(status == 0) > 0
    for quantity in rocker.routine.points.quantities:
        column = [row.values[names.index(quantity.shown)] for row in stroke.rows]
        stands = [i for i, row in enumerate(stroke.rows) if not row.trouble]
        stated = np.broadcast_to(found[quantity.name], len(column))
        assert [column[i] for i in stands] == pytest.approx(
            [stated[i] for i in stands], rel=1e-12, abs=1e-13
        )
    assert "x_A [mm]" in to_table(stroke)
    header = next(csv.reader(io.StringIO(to_csv(stroke))))
    assert {"x_A [mm]", "y_A [mm]", "phi_AB [deg]"} <= set(header)


def test_a_path_of_nothing_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    """E597: nothing is printed."""
    compilation = compile_source(Source("rocker.mech", ROCKER))
    with pytest.raises(MechcError, match="E597: C has no path, expected O1, "):
        compilation.stroke(3, ["C"])
    code = main(["stroke", "crank_rocker", "--path", "b"])
    out, err = capsys.readouterr()
    assert code == 1
    assert not out
    assert "error[E597]" in err
    assert "did you mean 'B'?" in err
    assert main(["stroke", "crank_rocker", "--path", "B", "--points", "2"]) == 0
    assert "x_B [mm]" in capsys.readouterr().out


def test_points_want_a_drive_and_known_names() -> None:
    with pytest.raises(ValueError, match="expected a drive"):
        mechc.load("karpenko_fig9_packet_clamp").points()
    with pytest.raises(TypeError, match="no result depends on 'fi'"):
        mechc.load("crank_rocker").points(fi=1)
