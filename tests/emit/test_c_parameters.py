"""C's struct of parameters: the values of the description by name, and the same results from it."""

import ctypes
import math
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from mechc.compilation import Compilation
from mechc.emit.c.to_c import TARGET
from mechc.emit.target import Compiled, Options
from mechc.routine.steps import programs
from mechc.source import Source
from paths import LIBRARY
from routine_samples import solved
from sources import in_thirds

NAMES = ("crank_rocker", "fedoriv_fig2a_with_friction", "triad_closed", "grip_force")
TYPES = {"double": ctypes.c_double, "int": ctypes.c_int}
pytestmark = pytest.mark.skipif(shutil.which("gcc") is None, reason="no C compiler")


def read(name: str) -> Compiled:
    """Return a mechanism of the library or of the samples, or a sheet."""
    sheet = LIBRARY / "sheets" / f"{name}.mech"
    return Compilation(Source(name, sheet.read_text("utf-8"))) if sheet.exists() else solved(name)


def header(found: Compiled) -> str:
    return TARGET.emit(found, Options("code", gradient=True))[1].text


def struct_of(found: Compiled) -> type[ctypes.Structure]:
    """Return the struct with the fields of the header."""
    body = header(found).split("typedef struct ")[1].split("}")[0]
    names = [line.split()[1].rstrip(";") for line in body.splitlines()[1:] if line]

    class Parameters(ctypes.Structure):
        _fields_ = [(name, ctypes.c_double) for name in names]

    return Parameters


def heads(found: Compiled) -> dict[str, tuple[str, list[str]]]:
    """Return type and arguments of every function that the header declares."""
    code = header(found).split('extern "C" {')[1]
    plain = "".join(part.split("*/")[-1] for part in code.split("/*"))
    declared = (line.strip() for line in plain.split(";") if line.rstrip().endswith(")"))
    split = (line.partition("(") for line in declared)
    return {
        start.split()[-1]: (start.split()[-2], [word.split()[-1] for word in rest[:-1].split(",")])
        for start, _, rest in split
    }


def built(found: Compiled, folder: Path) -> ctypes.CDLL:
    (source,) = TARGET.emit(found, Options("code", single=True, gradient=True))
    (folder / "code.c").write_text(source.text, encoding="utf-8")
    command = ["gcc", "-std=c99", "-O2", "-fPIC", "-shared", "code.c", "-o", "code.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "code.so"))


def called(
    code: ctypes.CDLL, name: str, kind: str, given: list[object], filled: int
) -> list[float]:
    """Return the value of a function and the values that it fills."""
    outputs = [ctypes.c_double(math.nan) for _ in range(filled)]
    call = code[name]
    call.restype = TYPES.get(kind)
    return [call(*given, *map(ctypes.byref, outputs)), *(output.value for output in outputs)]


@pytest.mark.parametrize("name", in_thirds(NAMES))
def test_the_struct_gives_the_same_bits_as_numbers_in_order(name: str, tmp_path: Path) -> None:
    found = read(name)
    code, functions, struct = built(found, tmp_path), heads(found), struct_of(found)
    fields, dice = [field for field, _ in struct._fields_], np.random.default_rng(3)
    defaults = struct.in_dll(code, f"{found.routine.name}_defaults")
    pairs = [(n.removesuffix("_of"), n) for n in functions if re.search("(?<!_n)_of$", n)]
    results = {f"{found.routine.name}_{f.name}" for f in found.routine.functions}
    assert results <= {positional for positional, _ in pairs}
    for stretch in (1.0, *dice.uniform(0.9, 1.1, 5)):
        values = {field: getattr(defaults, field) * stretch for field in fields}
        for positional, taking in pairs:
            kind, arguments = functions[positional]
            given = [ctypes.c_double(values[a]) for a in arguments if a in values]
            filled = len(functions[taking][1]) - 1
            expected = called(code, positional, kind, given, filled)
            of_struct = ctypes.byref(struct(**values))
            np.testing.assert_array_equal(called(code, taking, kind, [of_struct], filled), expected)


@pytest.mark.parametrize("name", in_thirds(NAMES))
def test_an_array_of_structs_gives_what_each_gives_alone(name: str, tmp_path: Path) -> None:
    found = read(name)
    code, functions, struct = built(found, tmp_path), heads(found), struct_of(found)
    defaults = struct.in_dll(code, f"{found.routine.name}_defaults")
    stretched = [
        [getattr(defaults, field) * part for field, _ in struct._fields_]
        for part in (1, 1.04, 0.97)
    ]
    several = (struct * len(stretched))(*(struct(*values) for values in stretched))
    taking = [n for n in functions if re.search("_n_of$", n)]
    assert len(taking) == len([n for n in functions if re.search("(?<!_n)_of$", n)])
    for many in taking:
        one = re.sub("_n_of$", "_of", many)
        kind, arguments = functions[one]
        kinds = [*("double" for _ in arguments[1:]), *([] if kind == "void" else [kind])]
        arrays = [(TYPES[each] * len(several))() for each in kinds]
        code[many].restype = None
        code[many](ctypes.c_size_t(len(several)), several, *arrays)
        for i, single in enumerate(several):
            given = [ctypes.byref(single)]
            returned, *rest = called(code, one, kind, given, len(arguments) - 1)
            expected = rest if kind == "void" else [*rest, returned]
            np.testing.assert_array_equal([array[i] for array in arrays], expected)


def test_defaults_are_those_of_the_description_and_nan_where_it_has_none(tmp_path: Path) -> None:
    text = """\
mechanism lever
param a = 100 mm
param b: length
pivot O
link AOB
OA = a @ 0 deg
OB = b @ 180 deg
force P at A along -90 deg
force F at B along -90 deg
find k = P/F
"""
    found = Compilation(Source("lever.mech", text))
    defaults = struct_of(found).in_dll(built(found, tmp_path), "lever_defaults")
    assert defaults.a == 0.1
    assert math.isnan(defaults.b)


def test_every_default_of_the_routine_is_in_the_struct() -> None:
    for name in NAMES:
        found = read(name)
        inputs = {i.name: i for part in programs(found.routine) for i in part.inputs}
        text = TARGET.emit(found, Options("code"))[0].text.split("_defaults = {")[1].split("}")[0]
        numbers = [float(line.split()[0].rstrip(",")) for line in text.splitlines()[1:] if line]
        assert numbers == [i.default for i in inputs.values()]


def test_what_a_pose_fills_has_its_unit() -> None:
    text = header(solved("crank_rocker"))
    assert "len_AO2_out: len_AO2, in m\n" in text
    assert "psi_out: psi, in rad\n" in text


def test_slopes_have_their_units() -> None:
    text = header(solved("crank_rocker"))
    assert " *   k_out: k, in m\n" in text
    assert " *   dk_da_out: the slope of k by a, a number\n" in text
    assert " *   dk_dphi_out: the slope of k by phi, in m\n" in text
    assert " *   di_da_out: the slope of i by a, in 1/m\n" in text
