"""The sets of reserved names are complete: the compilers and Python at hand are asked."""

import builtins
import json
import keyword
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator

import pytest

from mechc.emit.c.reserved import HEADERS, LINKED, RESERVED
from mechc.emit.names import TargetNames
from mechc.emit.python import printer

OURS = ("math", "stddef", "stdint", "string")
_OTHERS = """
    assert ctype errno fenv float inttypes iso646 limits locale setjmp signal stdarg stdbool stdio
    stdlib time unistd wchar
"""
OTHERS = _OTHERS.split()
OF_C = ("complex", "tgmath")
STANDARDS = {"c": ("c99", "gnu99", "gnu17"), "c++": ("c++11", "c++17", "gnu++20")}
COMPILERS = {"gcc": "c", "clang": "c", "g++": "c++", "clang++": "c++"}
FEATURES = ((), ("-D_GNU_SOURCE",), ("-D_XOPEN_SOURCE=700",))


def preprocessed(compiler: str, headers: tuple[str, ...], *options: str) -> Iterator[str]:
    """Yield what a compiler makes of headers, by every standard and every set of features."""
    if shutil.which(compiler) is None:
        pytest.skip(f"no {compiler}")
    language = COMPILERS[compiler]
    text = "".join(f"#include <{name}.h>\n" for name in headers)
    for standard in STANDARDS[language]:
        for features in FEATURES:
            command = [compiler, f"-std={standard}", "-x", language, "-E", *features, *options, "-"]
            done = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
            yield done.stdout


@pytest.mark.parametrize("compiler", COMPILERS)
def test_every_macro_of_the_headers_is_reserved(compiler):
    others = (*OTHERS, *(OF_C if COMPILERS[compiler] == "c" else ()))
    for defined in preprocessed(compiler, (*OURS, *others), "-dM"):
        objects = re.findall(r"^#define ([A-Za-z]\w*)(?= |$)", defined, re.MULTILINE)
        called = re.findall(r"^#define ([A-Za-z]\w*_\w*)\(", defined, re.MULTILINE)
        assert len(objects) > 100
        plain = {name for name in objects if f"#define {name} {name}" not in defined}
        assert {n for n in plain if n not in RESERVED} == set()
        assert {n for n in called if n not in LINKED} == set()


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_every_name_of_our_headers_with_an_underscore_is_reserved_at_file_scope(compiler):
    for text in preprocessed(compiler, OURS, "-P"):
        names = set(re.findall(r"(?<!\w)[A-Za-z]\w*_\w*", text))
        assert names
        assert {name for name in names if name not in LINKED} == set()


def test_what_begins_with_an_underscore_is_given_to_nothing():
    names = TargetNames(RESERVED)
    assert [names.claim(n) for n in ("_Foo", "__x", "_", "MECHC_PI", "mechc_sin")] == [
        "Foo", "x", "x_2", "x_MECHC_PI", "x_mechc_sin",
    ]  # fmt: skip


def test_common_letters_of_mechanics_keep_their_names():
    kept = "E E1 EA F P_A F_B M_O S_AB F_C gamma y0 j1 index alpha_1 R_O_x l_max toggle string time"
    assert [name for name in kept.split() if name in RESERVED] == []


def test_every_keyword_and_built_in_function_of_python_is_reserved():
    functions = {n for n in dir(builtins) if n.islower() and not n.startswith("_")}
    for name in (*keyword.kwlist, *keyword.softkwlist, *functions):
        assert name in printer.RESERVED or name == "_"


def test_every_module_that_numpy_loads_is_known():
    script = (
        "import json, sys, numpy\n"
        "loaded = {name.partition('.')[0] for name in sys.modules}\n"
        "print(json.dumps(sorted(loaded & sys.stdlib_module_names)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    loaded = {name for name in json.loads(done.stdout) if not name.startswith("_")}
    assert loaded - printer.MODULES == set()
    assert "numpy" in printer.MODULES


def test_the_headers_are_those_that_there_are():
    assert {*OURS, *OTHERS, *OF_C} <= HEADERS
