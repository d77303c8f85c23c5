"""Names that a language, its headers or mechc's templates have: every target is right with them."""

import ast
import ctypes
import json
import runpy
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import mechc
from good_mechanisms import loaded
from mechc.diagnostics import MechcError
from sources import in_thirds

HOSTILE = """
    M_E M_PI MECHC_RESTRICT MECHC_PI MECHC_UNROLL MECHC_toggle_H mechc_sin mechc_circular
    mechc_eliminate I NAN INFINITY HUGE_VAL NULL signgam y0 y1 jn gamma lgamma errno EDOM ERANGE
    E2BIG INT8_C INT_MAX UINT64_MAX SIZE_MAX FP_NAN FE_INVALID SIGINT SIG_DFL PRId64 FLT_MAX assert
    isnan signbit double_t uint64_t size_t memcpy fabs stdin pow expf index time div class
    template this new delete typename nullptr restrict inline double int unix linux near far
    np numpy math float len range print lambda def None True self sum type found
    status n i start stop count quarter result shifted base reached matrix sign E1 P_A
    alignas static_assert thread_local typeof constexpr nullptr_t bool complex imaginary creal conj
    CMPLX offsetof ptrdiff_t max_align_t HUGE MAXFLOAT MATH_ERRNO read write close environ daylight
    timezone stat select random abort match case array where errstate infty frac left begin end
    documentclass par
"""
NAMES = HOSTILE.split()
TOGGLE = """\
mechanism {mechanism} "toggle"
{params}
param alpha = 10 deg in 2 deg .. 40 deg
pivot O
slider K along 90 deg
link OB
link BK
OB = l0 @ 90 deg + alpha
BK = l0 @ 90 deg - alpha
force {drive} at B along 0 deg
force {load} at K along -90 deg
find {result} = {drive}/{load}
{lets}
"""
STRICT = ["-Wall", "-Wextra", "-Wconversion", "-Wpedantic", "-Werror"]
COMMANDS = {
    "gcc": ["gcc", "-std=c99", "-xc"],
    "gnu": ["gcc", "-std=gnu17", "-xc"],
    "clang": ["clang", "-std=c99", "-xc"],
    "g++": ["g++", "-std=c++17", "-xc++"],
    "clang++": ["clang++", "-std=c++17", "-xc++"],
}
LEVELS = {"gcc": "-Os", "gnu": "-O3 -march=native", "clang": "-Os", "clang++": "-O3 -march=native"}
HEADERS = "errno limits float signal inttypes fenv stdio stdlib math string time"
BEFORE = "".join(f"#include <{name}.h>\n" for name in HEADERS.split())


def toggle(mechanism="toggle", drive="P", load="F", result="k", names=NAMES):
    """Return a toggle whose lengths, drive, load, result and lets have hostile names."""
    lengths = [n for n in names if n not in (drive, load, result)]
    params = "\n".join(f"param {n} = {10 + i} mm" for i, n in enumerate(lengths))
    lets = "\n".join(f"let q_{n} = 2*{n}*sin(alpha)" for n in lengths[::4])
    params += "\nparam l0 = " + " + ".join(lengths)
    return TOGGLE.format(**locals())


def compiles(text: str, compiler: str, folder: Path) -> None:
    command, level = COMMANDS[compiler], LEVELS.get(compiler, "-O1").split()
    mechanism = mechc.loads(text)
    source, header = mechanism.emit_files("c")
    (folder / header.name).write_text(header.text, encoding="utf-8")
    whole = f'{BEFORE}#include "{header.name}"\n{source.text}'
    for code in (source.text, whole, mechanism.emit("c")):
        run = [*command, *STRICT, *level, "-I.", "-c", "-", "-o", "/dev/null"]
        done = subprocess.run(run, input=code, cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr[:2000]


EACH = [n if n == "gcc" else pytest.param(n, marks=pytest.mark.slow) for n in COMMANDS]


@pytest.mark.parametrize("compiler", EACH)
def test_c_compiles_with_any_name_after_any_header(compiler, tmp_path):
    command = COMMANDS[compiler]
    if shutil.which(command[0]) is None:
        pytest.skip(f"no {command[0]}")
    compiles(toggle(), compiler, tmp_path)


RESULTS = "M_E M_PI INFINITY NAN I y0 gamma errno n i start numpy np pose main k_n E r q_n"


@pytest.mark.parametrize("name", in_thirds(RESULTS.split()))
def test_c_and_python_stand_a_hostile_result_and_load(name, tmp_path):
    text = toggle(drive=name, result=f"{name}_x", load="mechc_sin", names=NAMES[:6])
    (tmp_path / "m.py").write_text(mechc.loads(text).emit("python"), encoding="utf-8")
    runpy.run_path(str(tmp_path / "m.py"), run_name="__main__")
    if shutil.which("gcc"):
        compiles(text, "gcc", tmp_path)


MECHANISMS = "math string numpy stdio errno stdint class lambda M strtok lgamma FP si re time"


@pytest.mark.parametrize("name", in_thirds(MECHANISMS.split()))
def test_files_hide_no_header_and_no_module(name, tmp_path):
    text = toggle(mechanism=name, drive="E", load="r", result="PI", names=NAMES[:6])
    mechanism = mechc.loads(text)
    for target in ("c", "python"):
        for file in mechanism.emit_files(target):
            (tmp_path / file.name).write_text(file.text, encoding="utf-8")
    for script in tmp_path.glob("*.py"):
        done = subprocess.run([sys.executable, script], capture_output=True, text=True)
        assert "PI = " in done.stdout, done.stderr
    if shutil.which("gcc"):
        for source in tmp_path.glob("*.c"):
            command = ["gcc", "-std=c99", *STRICT, "-I.", "-c", source.name, "-o", "/dev/null"]
            subprocess.run(command, cwd=tmp_path, check=True)


@pytest.mark.parametrize(
    ("target", "stem", "hidden"),
    [("c", "math", "<math.h>"), ("c", "String", "<String.h>"), ("python", "numpy", "numpy")],
)
def test_a_user_hears_of_a_file_that_would_hide_another(target, stem, hidden):
    with pytest.raises(MechcError, match=rf"E703: .* would hide .*{hidden}"):
        loaded("crank_rocker").emit_files(target, stem=stem)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_hostile_names_give_what_plain_ones_give(tmp_path):
    plain, hostile = loaded("crank_rocker"), mechc.loads(toggle())
    for mechanism in (plain, hostile):
        source = mechanism.emit_files("c")[0]
        header = mechanism.emit_files("c")[1]
        for file in (source, header):
            (tmp_path / file.name).write_text(file.text, encoding="utf-8")
    made = tmp_path / "toggle.so"
    command = ["gcc", "-std=c99", "-O2", "-fPIC", "-shared", "toggle.c", "-o", made, "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    call = ctypes.CDLL(str(made)).toggle_k
    call.restype, call.argtypes = ctypes.c_double, [ctypes.c_double]
    angles = np.array([0.1, 0.5, 1e6, 1e15, 1e22])
    expected = hostile.evaluate(alpha=angles)["k"]
    assert [call(a) for a in angles] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize(
    ("options", "works"),
    [
        (["-O2"], True),
        (["-Ofast"], False),
        (["-O2", "-ffast-math"], False),
        (["-O2", "-ffinite-math-only"], False),
        (["-O2", "-D__FINITE_MATH_ONLY__=1"], False),
        (["-O2", "-D_M_FP_FAST"], False),
        (["-O2", "-ffast-math", "-DMECHC_ALLOW_FAST_MATH"], True),
    ],
)
def test_arithmetic_without_nan_is_refused(compiler, options, works, tmp_path):
    if shutil.which(compiler) is None:
        pytest.skip(f"no {compiler}")
    text = loaded("crank_rocker").emit("c")
    command = [compiler, "-std=c99", "-w", *options, "-xc", "-c", "-", "-o", "/dev/null"]
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    assert (done.returncode == 0) == works
    assert works or "MECHC_ALLOW_FAST_MATH" in done.stderr


@pytest.mark.skipif(shutil.which("clang") is None, reason="no clang")
@pytest.mark.parametrize(("more", "works"), [([], True), (["-fno-honor-infinities"], False)])
def test_clang_states_nothing_of_nan_alone(more, works):
    """Should it do so one day, README has to say that it is refused."""
    text = loaded("crank_rocker").emit("c")
    command = ["clang", "-std=c99", "-fno-honor-nans", *more, "-xc", "-c", "-", "-o", "/dev/null"]
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    assert (done.returncode == 0) == works


def test_the_text_of_a_formula_is_in_code_and_in_the_document():
    text = TOGGLE.format(
        mechanism="m",
        params="param l0 = 1 m",
        drive="P",
        load="F",
        result="k",
        lets=r'let w = 2*k as "share \"\"\" \\ of */ ??/ %"',
    )
    mechanism = mechc.loads(text)
    label = r'share """ \ of */ ??/ %'
    assert json.loads(mechanism.emit("json"))["results"][-1]["label"] == label
    code = ast.parse(mechanism.emit("python"))
    (w,) = (f for f in code.body if isinstance(f, ast.FunctionDef) and f.name == "w")
    assert f'formula "{label}" of the description' in str(ast.get_docstring(w))
    assert 'formula "share """ \\ of * / ? ?/ %" of the description' in mechanism.emit("c")
