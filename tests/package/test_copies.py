"""Mechanisms and errors copied and sent to other processes; the package used from a zip file."""

import copy
import pickle
import shutil
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

import mechc
from mechc.pipeline import STAGES
from paths import ROOT
from sources import in_thirds

COPIES: dict[str, Callable[[Any], Any]] = {
    "pickle": lambda value: pickle.loads(pickle.dumps(value)),
    "deepcopy": copy.deepcopy,
    "copy": copy.copy,
}


@pytest.mark.parametrize("name", in_thirds(["crank_rocker", "fedoriv_fig1_with_friction"]))
@pytest.mark.parametrize("way", COPIES)
def test_a_copy_of_a_mechanism_is_as_good(name, way):
    mechanism = mechc.load(name)
    copied = COPIES[way](mechanism)
    assert copied.emit("c") == mechanism.emit("c")
    assert copied.emit("json") == mechanism.emit("json")
    assert copied.defaults == mechanism.defaults


@pytest.mark.parametrize("way", COPIES)
def test_a_copy_of_a_mechanism_that_has_been_used_is_as_good(way):
    """What it has made of itself on the way, functions among that, is made anew."""
    mechanism = mechc.load("crank_rocker")
    found = mechanism.evaluate(phi="30 deg")
    mechanism.points(), mechanism.stroke(3), mechanism.draw(), mechanism.plot()
    copied = COPIES[way](mechanism)
    assert copied.evaluate(phi="30 deg") == found
    assert copied.points() == mechanism.points()


@pytest.mark.parametrize("way", COPIES)
def test_a_copy_of_a_mechanism_with_machine_code_has_it_too(way):
    compiled = mechc.load("crank_rocker").compile()
    copied = COPIES[way](compiled)
    found = compiled.evaluate(phi=[0.5, 0.6])["k"]
    assert list(copied.evaluate(phi=[0.5, 0.6])["k"]) == list(found)
    assert copied._evaluation.has_machine_code


@pytest.mark.parametrize("way", COPIES)
def test_every_stage_can_be_copied(way):
    compilation = mechc.load("crank_rocker")._compilation
    for attribute in STAGES.values():
        value = getattr(compilation, attribute)
        assert COPIES[way](value) == value, attribute


@pytest.mark.parametrize("way", COPIES)
def test_an_error_keeps_what_it_carries(way):
    with pytest.raises(mechc.MechcError) as caught:
        mechc.loads("param\nlink\n")
    copied = COPIES[way](caught.value)
    assert copied.diagnostics == caught.value.diagnostics
    assert copied.source == caught.value.source
    assert str(copied) == str(caught.value)


@pytest.mark.slow
def test_from_a_zip_file(tmp_path):
    unpacked = tmp_path / "unpacked"
    unwanted = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "compiler" / "mechc", unpacked / "mechc", ignore=unwanted)
    for folder in ("grammar", "library"):
        shutil.copytree(ROOT / folder, unpacked / "mechc" / folder)
    archive = shutil.make_archive(str(tmp_path / "mechc"), "zip", unpacked)
    shutil.rmtree(unpacked)
    code = (
        "import mechc; m = mechc.load('crank_rocker'); print(mechc.__file__)\n"
        "print(len(m.emit('c')) > 100, len(m.emit('latex')) > 100, m)\n"
        "from mechc.files import library; print('whitworth' in library())\n"
    )
    env = {"PYTHONPATH": archive, "TMPDIR": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], capture_output=True, text=True, env=env, cwd=tmp_path
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "mechc.zip" in done.stdout
    assert "True True <crank_rocker" in done.stdout
    assert done.stdout.endswith("True\n")
    assert [path.name for path in tmp_path.iterdir()] == ["mechc.zip"]
