"""The usual commands start without the heavy libraries."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from paths import ROOT

CLAMP = str(ROOT / "examples" / "clamp.mech")
YAML = str(ROOT / "examples" / "clamp.yaml")
HEAVY = {"sympy", "numpy", "scipy", "matplotlib", "mpmath", "lark", "jinja2"}
STAGES = {"mechc.compilation", "mechc.model", "mechc.kinematics", "yaml"}


def imports(*code: str) -> set[str]:
    """Return every module that a fresh interpreter imports, packages and modules of mechc."""
    run = subprocess.run(
        [sys.executable, "-v", *code],
        env={**os.environ, "PYTHONPATH": str(ROOT / "compiler")},
        capture_output=True,
        text=True,
        check=True,
    )
    return set(re.findall(r"^import '(\S+)' #", run.stderr, re.M))


def test_importing_the_package_is_free() -> None:
    found = imports("-c", "import mechc; mechc.__version__")
    assert not found & (HEAVY | STAGES | {"click"})


@pytest.mark.parametrize("arguments", [["--help"], ["--version"], ["compile", "-h"]])
def test_help_does_not_compute(arguments: list[str]) -> None:
    assert not imports("-m", "mechc", *arguments) & HEAVY


@pytest.mark.parametrize("arguments", [["--help"], ["--version"]])
def test_help_does_not_import_the_compiler(arguments: list[str]) -> None:
    assert not imports("-m", "mechc", *arguments) & STAGES


@pytest.mark.parametrize(
    "arguments",
    [
        ["fmt", "--diff", CLAMP],
        ["check", CLAMP],
        ["derive", CLAMP],
        ["compile", CLAMP, "--emit", "latex"],
        ["compile", CLAMP, "--emit", "c"],
        ["compile", CLAMP, "--emit", "python"],
        ["compile", CLAMP, "--emit", "json"],
    ],
    ids=" ".join,
)
def test_compiling_needs_no_heavy_library(arguments: list[str]) -> None:
    found = imports("-m", "mechc", *arguments)
    assert "mechc.syntax.notation" in found
    assert not found & HEAVY


@pytest.mark.parametrize("target", ["c", "python", "latex", "json"])
def test_the_other_notation_is_not_imported(target: str) -> None:
    found = imports("-m", "mechc", "compile", CLAMP, "--emit", target)
    assert not {name for name in found if "yaml" in name}
    assert "yaml" in imports("-m", "mechc", "compile", YAML, "--emit", target)


@pytest.mark.parametrize("target", ["c", "python", "latex", "json"])
def test_other_targets_are_not_imported(target: str) -> None:
    others = {f"mechc.emit.{name}.to_{name}" for name in ("c", "python", "latex", "json")}
    found = imports("-m", "mechc", "compile", CLAMP, "--emit", target)
    assert found & others == {f"mechc.emit.{target}.to_{target}"}


def test_lines_that_fit_are_not_broken() -> None:
    assert "textwrap" not in imports("-m", "mechc", *PAGES[0])


def test_no_other_package_is_asked_for_a_format_that_is_named(tmp_path: Path) -> None:
    command = ("-m", "mechc", "compile", CLAMP, "-o", str(tmp_path / "k.txt"))
    assert "importlib.metadata" not in imports(*command, "--emit", "latex")


@pytest.mark.parametrize("target", ["c", "python", "latex"])
def test_what_draws_nothing_makes_no_figure(target: str) -> None:
    found = imports("-m", "mechc", "compile", CLAMP, "--emit", target)
    assert not {name for name in found if name.startswith(("mechc.figure", "mechc.drawing"))}
    assert "mechc.figure" in imports("-m", "mechc", "compile", CLAMP, "--emit", "json")


def test_what_was_answered_before_needs_no_compiler(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MECHC_CACHE", str(tmp_path))
    command = ("-m", "mechc", "compile", CLAMP, "--emit", "c")
    assert "mechc.compilation" in imports(*command)
    again = {name for name in imports(*command) if name.startswith(("mechc", "click", "json"))}
    assert again == {
        *(
            "mechc",
            "mechc.version",
            "mechc.cache_folder",
            "mechc.base",
            "mechc.base.later",
            "mechc.whole_files",
        ),
        *("mechc.cli", "mechc.cli.main", "mechc.cli.find_answers"),
    }


def test_listing_titles_needs_no_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MECHC_CACHE", "")
    assert not imports("-m", "mechc", "list") & STAGES


LIBRARIES = {"mechc"}
CODE = ["compile", CLAMP, "--emit", "c"]
PAGES = [["check", CLAMP], ["compile", CLAMP, "--emit", "latex"]]


@pytest.mark.parametrize(
    ("arguments", "own", "all_"), [(CODE, 258, 342), (PAGES[0], 267, 352), (PAGES[1], 313, 398)]
)
def test_few_modules_are_imported(arguments: list[str], own: int, all_: int) -> None:
    """Ceilings with some room: a module takes a two-hundredth of what a compilation may take."""
    found = imports("-m", "mechc", *arguments)
    assert len([name for name in found if name.startswith("mechc")]) <= own
    assert len(found) <= all_


def test_what_is_found_is_printed_without_a_derivation() -> None:
    found = imports("-m", "mechc", *PAGES[0])
    assert not {name for name in found if name.startswith("mechc.report.derivation.")}
    assert not found & {"mechc.report.kinds", "mechc.report.steps"}


@pytest.mark.parametrize("arguments", PAGES)
def test_pages_need_no_program_and_no_stroke(arguments: list[str]) -> None:
    found = imports("-m", "mechc", *arguments)
    assert not {name for name in found if name.startswith(("mechc.routine", "mechc.study.stroke."))}


def test_compiling_to_code_imports_little() -> None:
    found = imports("-m", "mechc", *CODE)
    of_the_system = {"sitecustomize"}  # Debian's Python has one
    foreign = {name.split(".")[0] for name in found} - sys.stdlib_module_names - of_the_system
    assert {name for name in foreign if not name.startswith("_")} == LIBRARIES
    assert not found & {"dataclasses", "logging", "traceback", "argparse", "inspect", "threading"}
    late = ("mechc.report.languages.", "mechc.api")
    early = {"mechc.report.languages.locale", "mechc.report.languages.registry"}
    assert {name for name in found if name.startswith(late)} <= early


@pytest.mark.parametrize("description", [CLAMP, YAML])
@pytest.mark.parametrize("command", [["check"], ["compile", "--emit", "latex"]], ids=" ".join)
def test_no_words_of_messages_are_imported_where_nothing_is_wrong(
    command: list[str], description: str
) -> None:
    early = {f"mechc.diagnostics.{name}" for name in ("diagnostic", "render", "model")}
    found = imports("-m", "mechc", *command, description, "--no-cache")
    assert {name for name in found if name.startswith("mechc.diagnostics.")} <= early
    assert not {name for name in found if name.endswith(".slips")}
