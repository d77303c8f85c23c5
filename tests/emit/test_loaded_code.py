"""Machine code for arrays gives what the interpreter gives, and NumPy where none can be built."""

import shutil

import numpy as np
import pytest

import mechc
from mechc.emit import loaded_code
from mechc.emit.c import library
from mechc.routine.evaluate import evaluate
from routine_samples import solved
from run_targets import poses

needs_compiler = pytest.mark.skipif(library.compiler() is None, reason="no C compiler")


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("MECHC_CACHE", str(tmp_path))
    return tmp_path / "libraries"


def agrees(name):
    made = loaded_code.on_arrays(solved(name))
    for function in solved(name).routine.functions:
        values = poses(function)
        own, wanted = made[function.name](*values.values()), evaluate(function, values)
        np.testing.assert_allclose(own, wanted, rtol=1e-9)


@needs_compiler
@pytest.mark.parametrize("name", ["clamp", "badly_named", "watt_closed"])
def test_c_agrees_with_the_interpreter(name, folder):
    agrees(name)
    (first,) = folder.iterdir()
    agrees(name)
    assert [*folder.iterdir()] == [first]


@pytest.mark.parametrize("command", ["", "false"])
def test_without_a_compiler_numpy_takes_its_place(command, folder, monkeypatch):
    path = shutil.which(command)
    monkeypatch.setattr(library.shutil, "which", lambda name: path if name == command else None)
    monkeypatch.setenv("CC", command)
    agrees("badly_named")
    assert not [*folder.glob("*.so")]


@needs_compiler
@pytest.mark.parametrize("knows_the_machine", [True, False])
def test_code_is_for_the_machine_at_hand_where_the_compiler_knows_it(
    knows_the_machine, tmp_path, monkeypatch
):
    """A compiler that refuses the machine's own instructions is asked once more, without them."""
    asked, command = tmp_path / "asked", tmp_path / "cc"
    refuses = "" if knows_the_machine else 'case "$*" in *-march=native*) exit 1;; esac\n'
    text = f'#!/bin/sh\necho "$@" >> {asked}\n{refuses}exec {library.compiler()} "$@"\n'
    command.write_text(text)
    command.chmod(0o755)
    monkeypatch.setenv("CC", str(command))
    agrees("badly_named")
    natives = ["-march=native" in line for line in asked.read_text().splitlines()]
    assert natives == [True] + [False] * (not knows_the_machine)


@needs_compiler
def test_numbers_and_arrays_broadcast_beyond_a_block():
    clamp = mechc.load("karpenko_fig9_packet_clamp")
    alpha, beta = np.linspace(0.1, 0.5, library.BLOCK + 7), np.array([[0.1], [0.2]])
    found = clamp.compile().evaluate(alpha=alpha, beta=beta)["k"]
    assert found.shape == (2, len(alpha))
    np.testing.assert_allclose(found, clamp.evaluate(alpha=alpha, beta=beta)["k"], rtol=1e-13)
    assert clamp.compile().evaluate(alpha=[])["k"].shape == (0,)


@needs_compiler
def test_the_folder_holds_no_more_than_it_should(folder, monkeypatch):
    monkeypatch.setattr(library, "KEPT_LIBRARIES", 2)
    for number in range(4):
        assert library.functions(f"double twice_{number}(void) {{ return 2.0; }}", {}) == {}
    assert len([*folder.iterdir()]) == 2
