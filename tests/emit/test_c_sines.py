"""The sines and cosines of loops in C, against sines of many digits."""

import ctypes
import shutil
import subprocess

import mpmath
import numpy as np
import pytest

from mechc.emit.c.to_c import TARGET as C
from mechc.emit.target import Options
from routine_samples import solved
from sources import in_thirds

COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]
OPTIONS = ["-O1", "-O3 -march=native"]
FUNCTIONS = {"sin": mpmath.sin, "cos": mpmath.cos}
FORMS = [("karpenko_fig9_packet_clamp", ""), ("crank_rocker", "_of_pair")]
"""A mechanism that asks for the sine or the cosine of an angle, and one that asks for both."""
REALS = {"double": (np.float64, 2.0**20, 2.5, 0.0), "float": (np.float32, 2.0**13, 2.5, 1e-10)}
"""The type in NumPy, the angle from which on there is NaN, and how large an error may be.

That is in units of the last place; what float loses beside a zero is of no account where
its neighbouring angles are 1e-4 apart.
"""


def built(folder, mechanism, ending, real, compiler, options):
    """Return the functions of loops as functions that can be called."""
    (source,) = C.emit(solved(mechanism), Options("code", single=True, c_real=real))
    names = {name: f"mechc_{name}{ending}" for name in FUNCTIONS}
    more = (f"{real} {name}_({real} x) {{ return {call}(x); }}" for name, call in names.items())
    (folder / "code.c").write_text("\n".join([source.text, *more]), encoding="utf-8")
    command = [compiler, *options.split(), "-fPIC", "-shared", "code.c", "-o", "code.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    code, kind = ctypes.CDLL(str(folder / "code.so")), getattr(ctypes, f"c_{real}")
    found = {name: getattr(code, f"{name}_") for name in FUNCTIONS}
    for call in found.values():
        call.restype, call.argtypes = kind, [kind]
    return found


def angles(kind, limit):
    """Return angles of all sizes, and those next to where a sine or a cosine is zero."""
    dice = np.random.default_rng(5)
    spread = [dice.uniform(-span, span, 300) for span in (0.8, 4, 100, limit)]
    quarters = dice.integers(-int(limit / 1.58), int(limit / 1.58), 300)
    near = np.concatenate([quarters, np.arange(-8, 9)]) * (np.pi / 2)
    found = np.concatenate([*spread, near]).astype(kind)
    return [kind(x) for x in (*found, *np.nextafter(found, kind(9e9)))]


@pytest.mark.skipif(not COMPILERS, reason="no C compiler")
@pytest.mark.parametrize("options", in_thirds(OPTIONS))
@pytest.mark.parametrize("real", REALS)
@pytest.mark.parametrize(("mechanism", "ending"), FORMS)
def test_sines_are_within_some_units_of_the_last_place(mechanism, ending, real, options, tmp_path):
    kind, limit, most, little = REALS[real]
    for compiler in COMPILERS:
        calls = built(tmp_path, mechanism, ending, real, compiler, options)
        for name, call in calls.items():
            for x in angles(kind, 0.99 * limit):
                wanted = FUNCTIONS[name](mpmath.mpf(float(x)))
                allowed = most * float(np.spacing(kind(abs(wanted)))) + little
                assert abs(float(call(x)) - wanted) <= allowed, (compiler, name, float(x))
            for x in (1.05 * limit, -1e9, np.inf, np.nan):
                assert np.isnan(call(x)), (compiler, name, x)
