"""C: clean under strict compilers as C99 and as C++, and safe from what a user writes."""

import ctypes
import itertools
import math
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from mechc.diagnostics import MechcError
from mechc.emit.c.to_c import TARGET
from mechc.emit.target import Emitted, Options
from mechc.routine.evaluate import evaluate
from routine_samples import LIBRARY, SAMPLES, compiled, guarded_by, solved

WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Werror", "-fsyntax-only"]
COMPILERS = {
    "c99": ["gcc", "-std=c99", "-pedantic", *WARNINGS, "-x", "c"],
    "c11": ["gcc", "-std=c11", "-pedantic", "-Wfloat-conversion", *WARNINGS, "-x", "c"],
    "c++": ["g++", *WARNINGS, "-x", "c++"],
    "c++20": ["g++", "-std=c++20", "-pedantic", *WARNINGS, "-x", "c++"],
}
HEADERS = "#include <math.h>\n#include <stddef.h>\n"
"""What the sources include, as C compilers see; C++ takes longer for it than for all the rest."""


def write(files: tuple[Emitted, ...], folder: Path) -> None:
    for name, text in files:
        (folder / name).write_text(text, encoding="utf-8")


def precompiled(language: str, folder: Path) -> str:
    """Return a header that C++ reads once for all the sources that include it first."""
    (folder / "headers.h").write_text(HEADERS, encoding="utf-8")
    own = [word for word in COMPILERS[language][:-2] if word != "-fsyntax-only"]
    subprocess.run([*own, "-x", "c++-header", "headers.h"], cwd=folder, check=True)
    return "headers.h"


SEEN_BY = {"c99": (), "c11": LIBRARY, "c++": LIBRARY, "c++20": LIBRARY[::3]}
"""What a compiler sees of the library; C99 sees all of it, as strictly, where targets agree."""

slow = pytest.mark.slow


@pytest.mark.parametrize(
    ("language", "single"),
    [
        ("c99", False),
        *(
            pytest.param(n, single, marks=slow)
            for n, single in (("c++20", True), ("c11", True), ("c++", False))
        ),
    ],
)
def test_everything_compiles_without_a_warning(language: str, single: bool, tmp_path: Path) -> None:
    command = COMPILERS[language]
    if shutil.which(command[0]) is None:
        pytest.skip(f"no {command[0]}")
    names = (*SAMPLES, *SEEN_BY[language])
    for name in names:
        write(TARGET.emit(solved(name), Options(name, single=single)), tmp_path)
    sources = [f"{name}.c" for name in names]
    if language.startswith("c++"):
        command = [*command, "-include", precompiled(language, tmp_path)]
    done = subprocess.run([*command, *sources], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.skipif(shutil.which("g++") is None, reason="no C++ compiler")
def test_the_header_links_from_cpp(tmp_path: Path) -> None:
    write(TARGET.emit(compiled("clamp"), Options("clamp")), tmp_path)
    main = (
        '#include "clamp.h"\n#include "clamp.h"\n#include <cstdio>\n'
        'int main() { std::printf("%.6f", packet_clamp_k(0.1, 0.25, 0.2, 0.1)); }\n'
    )
    (tmp_path / "main.cpp").write_text(main, encoding="utf-8")
    for command in (["gcc", "-c", "clamp.c"], ["g++", "main.cpp", "clamp.o", "-o", "main", "-lm"]):
        subprocess.run(command, cwd=tmp_path, check=True)
    done = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True)
    assert done.stdout == "0.060609"


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no C compiler")
@pytest.mark.parametrize("level", ["-O0", "-O3"])
def test_loops_give_what_single_calls_give_at_the_edges(level: str, tmp_path: Path) -> None:
    operators = ("<", "<=", ">", ">=", "=", "!=")
    (file,) = TARGET.emit(guarded_by(operators), Options("edges", single=True))
    (tmp_path / file.name).write_text(file.text, encoding="utf-8")
    command = ["gcc", "-std=c99", level, "-fPIC", "-shared", "edges.c", "-o", "edges.so", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    code = ctypes.CDLL(str(tmp_path / "edges.so"))
    nan, inf = math.nan, math.inf
    edges = [0.0, -0.0, 1.0, -1.0, 5e-324, -5e-324, 1.0 + 2.0**-52, nan, inf, -inf, 1e9, 3.14e6]
    x, y = (np.array(column) for column in zip(*itertools.product(edges, edges), strict=True))
    array = np.ctypeslib.ndpointer(dtype=np.float64)
    for function in guarded_by(operators).routine.functions:
        single, batch = code[f"guarded_{function.name}"], code[f"guarded_{function.name}_n"]
        single.restype, single.argtypes = ctypes.c_double, [ctypes.c_double] * 2
        batch.restype, batch.argtypes = None, [ctypes.c_size_t, array, array, array]
        found = np.empty(len(x))
        batch(len(x), x, y, found)
        singly = np.array([single(*pair) for pair in zip(x, y, strict=True)])
        expected = evaluate(function, {"x": x, "y": y})
        np.testing.assert_allclose(singly, expected, rtol=4e-15, equal_nan=True)
        np.testing.assert_allclose(found, expected, rtol=4e-15, equal_nan=True)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_gcc_vectorises_the_loop_with_its_guard(tmp_path: Path) -> None:
    write(TARGET.emit(solved("clamp"), Options("clamp")), tmp_path)
    command = ["gcc", "-std=c99", "-O3", "-fopt-info-vec", "-c", "clamp.c"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "loop vectorized" in done.stderr


def test_a_pair_is_source_and_header_and_single_is_one_file() -> None:
    found = compiled("clamp")
    assert [e.name for e in TARGET.emit(found, Options("k"))] == ["k.c", "k.h"]
    (single,) = TARGET.emit(found, Options("k", single=True))
    assert single.name == "k.c"
    assert "#include <math.h>\n#include <stddef.h>\n" in single.text
    assert '#include "' not in single.text


def test_bad_names_keep_apart_and_in_order() -> None:
    header = TARGET.emit(compiled("badly_named"), Options("bad"))[1].text
    heads = " ".join(header.split())
    assert "double class_k( double lambda, double int_, double I_," in heads
    assert "double beta_3, double beta, double beta_2, double double_, double l_A_prime" in heads
    assert "double class_seven(void);" in heads
    assert "void class_k_n_2( size_t n_2," in heads
    assert "double class_k_n(double I_, double np);" in heads
    assert "void class_seven_n(size_t n, double *MECHC_RESTRICT seven);" in heads


def test_what_a_user_writes_stays_inside_its_comment() -> None:
    source = TARGET.emit(compiled("badly_named"), Options("bad"))[0].text
    comment = source[: source.index("*/")]
    assert "int x;" in comment
    assert "? ?/" in comment
    assert "\u202e" not in source
    assert "\\\n" not in source


@pytest.mark.parametrize("stem", ['a"b', "a\\b", "a\nb"])
def test_a_file_name_that_no_include_can_hold_is_an_error(stem: str) -> None:
    with pytest.raises(MechcError, match=r"E701: .* cannot stand in a C #include"):
        TARGET.emit(compiled("clamp"), Options(stem))


def test_there_is_no_global_no_allocation_and_no_pow_of_integers() -> None:
    for sample in SAMPLES:
        text = TARGET.emit(compiled(sample), Options(sample, single=True))[0].text
        for word in ("malloc", "errno", "M_PI", "static double mechc_state"):
            assert word not in text
    assert "pow(x, 2" not in text


@pytest.mark.parametrize("sample", ["clamp", "chained", "badly_named"])
def test_golden(sample: str, golden: Callable[[str, str], None]) -> None:
    for file in TARGET.emit(compiled(sample), Options(sample)):
        golden(f"code/{file.name}", file.text)
