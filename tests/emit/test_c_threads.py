"""C's forms for many poses over all processors: the same values, built with OpenMP or without."""

import ctypes
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from mechc.emit.c.threads import LEAST, PART
from mechc.emit.c.to_c import TARGET
from mechc.emit.target import Options
from routine_samples import solved
from run_targets import span
from sources import in_thirds

GCC = shutil.which("gcc")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror", "-O2")

pytestmark = pytest.mark.skipif(GCC is None, reason="no gcc")


def built(sample: str, folder: Path, threads: bool, *flags: str) -> ctypes.CDLL:
    options = Options("code", gradient=True, c_openmp=threads, single=True)
    (source,) = TARGET.emit(solved(sample), options)
    (folder / "code.c").write_text(source.text, encoding="utf-8")
    made = folder / f"code{threads}{len(flags)}.so"
    command = [str(GCC), *STRICT, *flags, "-fPIC", "-shared", "code.c", "-o", str(made), "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    return ctypes.CDLL(str(made))


def values(library: ctypes.CDLL, sample: str, poses: int) -> list[np.ndarray]:
    """Return the values of the forms of all results, poses outside the range among them."""
    found = []
    for function in solved(sample).routine.functions:
        call = getattr(library, f"{solved(sample).routine.name}_{function.name}_n")
        random = np.random.default_rng(5)
        columns = [random.uniform(*span(i), poses) * 1.2 for i in function.inputs]
        result = np.full(poses + 1, 7.0)
        call(
            ctypes.c_size_t(poses), *(c.ctypes.data_as(ctypes.c_void_p) for c in (*columns, result))
        )
        assert result[-1] == 7.0
        found.append(result)
    return found


@pytest.mark.parametrize("sample", in_thirds(["clamp", "crank_rocker", "triad_closed"]))
def test_values_do_not_depend_on_threads(sample: str, tmp_path: Path) -> None:
    plain = built(sample, tmp_path, threads=False)
    serial = built(sample, tmp_path, threads=True)
    parallel = built(sample, tmp_path, True, "-fopenmp")
    for poses in (0, 1, PART + 1, LEAST, LEAST + 3 * PART + 5):
        expected = values(plain, sample, poses)
        for other in (serial, parallel):
            for one, two in zip(values(other, sample, poses), expected, strict=True):
                assert np.array_equal(one, two, equal_nan=True)


def test_all_forms_are_in_parts_and_none_without_the_option() -> None:
    (source,) = TARGET.emit(solved("crank_rocker"), Options("code", gradient=True, single=True))
    options = Options("code", gradient=True, c_openmp=True, single=True)
    (threads,) = TARGET.emit(solved("crank_rocker"), options)
    forms = [line for line in source.text.splitlines() if re.match(r"void \w+_n(_of)?\(", line)]
    assert "OPENMP" not in source.text.upper()
    assert threads.text.count("#pragma omp parallel for") == len(set(forms)) >= 4


def test_loops_of_the_parts_are_vector_code(tmp_path: Path) -> None:
    """Within a parallel region itself gcc forgets that arrays do not overlap."""
    options = Options("code", c_openmp=True, single=True)
    (source,) = TARGET.emit(solved("crank_rocker"), options)
    (tmp_path / "code.c").write_text(source.text, encoding="utf-8")
    flags = ["-std=c99", "-O3", "-fopenmp", "-mavx2", "-fopt-info-vec", "-c"]
    command = [str(GCC), *flags, "code.c", "-o", "code.o"]
    done = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
    assert "loop vectorized" in done.stderr


def test_names_of_the_user_stay_their_own(tmp_path: Path) -> None:
    built("badly_named", tmp_path, True, "-fopenmp")
