"""The wheel works by itself: installed without network, run from an empty folder."""

import site
import subprocess
import sys
import sysconfig
import tarfile
import venv
import zipfile
from importlib.util import find_spec
from pathlib import Path

import pytest

from mechc import __version__
from paths import ROOT

needs_hatchling = pytest.mark.skipif(
    find_spec("hatchling") is None, reason="hatchling is not installed here"
)


def build(kind: str, folder: Path) -> Path:
    """Build with the back end itself, which needs no network."""
    code = f"import hatchling.build as b; print(b.build_{kind}({str(folder)!r}))"
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return folder / run.stdout.splitlines()[-1]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build("wheel", tmp_path_factory.mktemp("dist"))


@pytest.fixture(scope="module")
def python(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the interpreter of an environment with the wheel, and only the wheel, installed.

    Its dependencies are those of the environment that runs the tests.
    """
    folder = tmp_path_factory.mktemp("venv")
    venv.create(folder, with_pip=False, symlinks=True)
    scheme = {"base": str(folder), "platbase": str(folder)}
    target = Path(sysconfig.get_path("purelib", "venv", scheme))
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps"]
    subprocess.run([*command, "--target", str(target), str(wheel)], check=True)
    (target / "dependencies.pth").write_text("\n".join(site.getsitepackages()))
    return folder / "bin" / "python"


def run(python: Path, folder: Path, *arguments: str) -> str:
    command = [str(python), "-m", "mechc", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout


@needs_hatchling
def test_wheel_carries_its_data(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert "mechc/py.typed" in names
    assert "mechc/grammar/mechc.lark" in names
    assert {
        f"mechc/{p.relative_to(ROOT).as_posix()}" for p in (ROOT / "library").rglob("*.mech")
    } <= {*names}
    assert {n for n in names if n.endswith(".jinja")}
    assert not [n for n in names if n.startswith(("tests", "benchmarks", "examples"))]


@needs_hatchling
def test_source_package_can_be_tested(tmp_path: Path) -> None:
    sources = build("sdist", tmp_path)
    assert __version__ in sources.name
    with tarfile.open(sources) as archive:
        names = {n.split("/", 1)[1] for n in archive.getnames() if "/" in n}
    assert {
        "pyproject.toml",
        "README.md",
        "grammar/mechc.lark",
        "tests/package/test_wheel.py",
    } <= names


@needs_hatchling
def test_wheel_runs_from_an_empty_folder(python: Path, tmp_path: Path) -> None:
    assert run(python, tmp_path, "--version") == f"mechc {__version__}\n"
    assert "karpenko_fig9_packet_clamp" in run(python, tmp_path, "list")
    name = "karpenko_fig9_packet_clamp"
    assert r"\documentclass" in run(python, tmp_path, "compile", name, "--emit", "latex")
    run(python, tmp_path, "compile", name, "-o", "clamp.c")
    assert {p.name for p in tmp_path.iterdir()} == {"clamp.c", "clamp.h"}


@needs_hatchling
def test_wheel_is_what_runs(python: Path, tmp_path: Path) -> None:
    code = "import mechc; print(mechc.__file__)"
    where = subprocess.run(
        [str(python), "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True
    ).stdout
    assert "site-packages" in where
    assert str(ROOT) not in where
