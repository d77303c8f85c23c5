"""C in single precision: close to what double gives, without one operation of double."""

import ctypes
import shutil
import subprocess

import numpy as np
import pytest

import mechc
from mechc.emit.c.real import in_single_precision
from mechc.emit.c.to_c import TARGET as C
from mechc.emit.target import Compiled, Options
from mechc.routine.evaluate import evaluate
from paths import LIBRARY
from routine_samples import solved
from run_targets import POSES, companions, poses, sensitivity
from sources import in_thirds

EPSILON = 2.0**-23
COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]
STRICT = "-std=c99 -Wall -Wextra -Wconversion -Wdouble-promotion -pedantic -Werror -fPIC -shared"
NAMES = ("karpenko_fig9_with_friction", "claw_closed", "triad_press")
ALL = sorted(path.stem for path in LIBRARY.glob("*.*") if path.suffix in (".mech", ".yaml"))


def sources(found: Compiled) -> tuple[str, str]:
    source, header = C.emit(found, Options("code", c_real="float", gradient=True))
    return source.text, header.text


def built(found, folder, compiler="gcc"):
    """Return the library in single precision and the names of its batch forms in order."""
    source, header = sources(found)
    (folder / "code.c").write_text(source, encoding="utf-8")
    (folder / "code.h").write_text(header, encoding="utf-8")
    command = [compiler, *STRICT.split(), "-O1", "code.c", "-o", "code.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    heads = [line.split("(")[0].split()[1] for line in header.splitlines() if line[:5] == "void "]
    others = tuple(f"{found.routine.name}_{n}" for n in (*companions(found), "pose_n", "points_n"))
    one_by_one = [n for n in heads if "_gradient" not in n and not n.endswith("_of")]
    names = [n for n in one_by_one if not n.startswith(others)]
    return ctypes.CDLL(str(folder / "code.so")), names


def batch(call, columns):
    array = np.ctypeslib.ndpointer(dtype=np.float32)
    call.restype, call.argtypes = None, [ctypes.c_size_t] + [array] * (len(columns) + 1)
    values = np.empty(POSES, dtype=np.float32)
    call(POSES, *(np.asarray(c, dtype=np.float32) for c in columns), values)
    return values


def agree(name, folder, compiler):
    found = solved(name)
    code, names = built(found, folder, compiler)
    for function, linked in zip(found.routine.functions, names, strict=True):
        columns = poses(function)
        wanted = np.broadcast_to(evaluate(function, columns), POSES)
        values = batch(code[linked], list(columns.values()))
        bound = 40 * EPSILON * (np.abs(wanted) + sensitivity(function))
        stated = np.isfinite(wanted) & (bound < 1e-2 * np.abs(wanted))
        assert np.all(np.abs(values - wanted)[stated] <= bound[stated]), function.name
        assert np.all(np.isnan(values[np.isnan(wanted)])), function.name


@pytest.mark.skipif("gcc" not in COMPILERS, reason="no gcc")
@pytest.mark.parametrize("name", in_thirds(NAMES))
def test_float_is_close_to_double(name, tmp_path):
    agree(name, tmp_path, "gcc")


@pytest.mark.slow
@pytest.mark.parametrize(("part", "compiler"), [*enumerate(COMPILERS)])
def test_much_of_the_library_is_close_to_double(part, compiler, tmp_path):
    for name in ALL[part :: 2 * len(COMPILERS)]:
        (tmp_path / name).mkdir()
        agree(name, tmp_path / name, compiler)


def test_a_number_beyond_float_is_an_error():
    sheet = mechc.loads('sheet s "S"\nparam c = 2\nlet d = c*10^45\n')
    with pytest.raises(mechc.MechcError, match=r"E705.*beyond single precision"):
        sheet.emit("c", c_real="float")
    with pytest.raises(LookupError, match="no type is called 'half'"):
        sheet.emit("c", c_real="half")


def test_words_of_comments_and_names_stay():
    code = "double k(double sin_a) { return 1e-3*sin(sin_a); } /* double 1.0 */"
    single = "float k(float sin_a) { return 1e-3f*sinf(sin_a); } /* double 1.0 */"
    assert in_single_precision(code) == single
