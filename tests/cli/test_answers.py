"""The same asked again: the same bytes, found without the compiler, as long as nothing changed."""

import subprocess
import sys

import pytest

from mechc.cli import find_answers, main
from mechc.cli.exit_status import INTERNAL
from paths import COMPILER, EXAMPLES

CLAMP = (EXAMPLES / "clamp.mech").read_text(encoding="utf-8")
WARNED = CLAMP + "param idle = 3 mm\n"


@pytest.fixture
def ask(tmp_path, monkeypatch, capfdbinary):
    """Return a function that runs a command line as the shell would, in a folder of its own."""
    (tmp_path / "clamp.mech").write_text(CLAMP, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MECHC_CACHE", str(tmp_path / "kept"))

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["mechc", *arguments])
        return main(), *capfdbinary.readouterr()

    return run


@pytest.fixture
def no_compiler(monkeypatch):
    """Return a function after which the compiler fails whenever it is asked for."""

    def broken(*_):
        raise AssertionError("the compiler ran")

    return lambda: monkeypatch.setattr("mechc.cli.run._status", broken)


def kept(tmp_path):
    return sorted((tmp_path / "kept").glob("*"))


@pytest.mark.parametrize(
    "line",
    [
        "check clamp.mech",
        "--format json check clamp.mech",
        "check --werror clamp.mech",
        "check bad.mech",
        "--color always check bad.mech",
        "compile clamp.mech --emit c -D alpha=20deg",
        "compile karpenko_fig9_packet_clamp --emit latex",
    ],
)
def test_an_answer_is_repeated_byte_for_byte(ask, no_compiler, tmp_path, line):
    (tmp_path / "clamp.mech").write_text(WARNED, encoding="utf-8")
    (tmp_path / "bad.mech").write_text(CLAMP.replace("find", "fnid"), encoding="utf-8")
    first = ask(*line.split())
    assert first[1] + first[2]
    no_compiler()
    assert ask(*line.split()) == first
    assert ask(*line.split(), "--no-cache")[0] == INTERNAL


def test_files_are_written_again(ask, no_compiler, tmp_path):
    first = ask("compile", "clamp.mech", "-o", "k.c", "--deps", "k.d")
    texts = {name: (tmp_path / name).read_bytes() for name in ("k.c", "k.h", "k.d")}
    (tmp_path / "k.c").write_text("torn")
    (tmp_path / "k.h").unlink()
    no_compiler()
    assert ask("compile", "clamp.mech", "-o", "k.c", "--deps", "k.d") == first
    assert {name: (tmp_path / name).read_bytes() for name in texts} == texts


def test_what_changed_is_computed_anew(ask, tmp_path):
    before = ask("check", "clamp.mech")
    (tmp_path / "clamp.mech").write_text(WARNED, encoding="utf-8")
    after = ask("check", "clamp.mech")
    assert b"idle" in after[2]
    assert b"idle" not in before[2]


def test_a_file_goes_before_the_library(ask, tmp_path):
    name = "toggle_press"
    first = ask("compile", name, "--emit", "python")
    (tmp_path / name).write_text(CLAMP, encoding="utf-8")
    assert ask("compile", name, "--emit", "python") != first


def test_the_description_is_not_written_over(ask, tmp_path):
    assert ask("compile", "clamp.mech", "-o", "k.tex")[0] == 0
    (tmp_path / "k.tex").unlink()
    (tmp_path / "k.tex").hardlink_to(tmp_path / "clamp.mech")
    assert ask("compile", "clamp.mech", "-o", "k.tex")[0] == 2
    assert (tmp_path / "clamp.mech").read_text(encoding="utf-8") == CLAMP


@pytest.mark.parametrize("tear", [lambda whole: whole[:-9], lambda _: b"", lambda _: b"x" * 99])
def test_a_torn_answer_is_none(ask, tmp_path, tear):
    first = ask("check", "clamp.mech")
    (answer,) = kept(tmp_path)
    answer.write_bytes(tear(answer.read_bytes()))
    assert ask("check", "clamp.mech") == first


@pytest.mark.parametrize("line", ["check .", "check missing.mech", "check clamp.mech --help", "-V"])
def test_what_hangs_on_more_is_not_kept(ask, tmp_path, line):
    ask(*line.split())
    assert kept(tmp_path) == []


def test_answers_go_when_they_are_too_many(ask, tmp_path, monkeypatch):
    monkeypatch.setattr("mechc.cli.store_answers.ROOM_FOR_ANSWERS", 2000)
    for alpha in range(5, 10):
        ask("check", "clamp.mech", "-D", f"alpha={alpha}deg")
        assert sum(path.stat().st_size for path in kept(tmp_path)) <= 2 * 2000


def test_no_folder_no_answers(ask, tmp_path, monkeypatch):
    monkeypatch.setenv("MECHC_CACHE", "")
    assert ask("check", "clamp.mech")[0] == 0
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("MECHC_CACHE", str(tmp_path / "file" / "below"))
    assert ask("check", "clamp.mech")[::2] == (0, b"")


def test_the_folder_is_the_systems(monkeypatch):
    monkeypatch.delenv("MECHC_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "/caches")
    assert find_answers.folder() == "/caches/mechc"


def test_a_program_that_runs_commands_gets_none(ask, tmp_path):
    assert main(["check", "clamp.mech"]) == 0
    assert kept(tmp_path) == []


def test_runs_at_once_do_not_harm_one_another(ask, tmp_path):
    command = [sys.executable, "-m", "mechc", "check", "clamp.mech"]
    runs = [
        subprocess.Popen(command, stdout=subprocess.PIPE, env=_environment(tmp_path), cwd=tmp_path)
        for _ in range(2)
    ]
    said = {run.communicate()[0] for run in runs}
    assert len(said) == 1
    assert [path.suffix for path in kept(tmp_path)] == [find_answers.SUFFIX]


def _environment(tmp_path):
    return {"MECHC_CACHE": str(tmp_path / "kept"), "PYTHONPATH": str(COMPILER)}


def test_the_code_of_a_checkout_is_looked_through(ask, tmp_path, monkeypatch):
    package = tmp_path / "compiler" / "mechc"
    package.mkdir(parents=True)
    (package / "code.py").write_text("one = 1\n")
    monkeypatch.setattr(find_answers, "PACKAGE", str(package))
    before = find_answers.question(["check"])
    assert find_answers.question(["check"]) == before
    (package / "code.py").write_text("one = 12\n")
    assert find_answers.question(["check"]) != before


def test_what_is_installed_is_known_by_its_folder(ask, tmp_path, monkeypatch):
    package = tmp_path / "site-packages" / "mechc"
    package.mkdir(parents=True)
    monkeypatch.setattr(find_answers, "PACKAGE", str(package))
    before = find_answers.question(["check"])
    assert find_answers.question(["check"]) == before
    (tmp_path / "site-packages" / "mechc-0.2.dist-info").mkdir()
    assert find_answers.question(["check"]) != before
