"""No command writes over what it reads, nor one output over another; rules that make can read."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from mechc.cli import main
from mechc.cli.collisions import claim
from mechc.cli.output_paths import makefile_rule
from mechc.cli.usage import UsageError
from paths import EXAMPLES

needs_make = pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed here")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with a description, and a link of either kind to it."""
    shutil.copy(EXAMPLES / "clamp.mech", tmp_path / "d.mech")
    (tmp_path / "soft.mech").symlink_to("d.mech")
    (tmp_path / "hard.mech").hardlink_to(tmp_path / "d.mech")
    (tmp_path / "here").symlink_to(".")
    monkeypatch.chdir(tmp_path)
    return tmp_path


COLLISIONS = [
    "d.mech -o d.c --deps d.mech",
    "d.mech -o d.c --deps ./d.mech",
    "d.mech -o d.c --deps here/d.mech",
    "d.mech -o d.c --deps soft.mech",
    "d.mech -o d.c --deps hard.mech",
    "soft.mech --emit c -o d.mech",
    "d.mech --emit c -o hard.mech",
    "d.mech -o d.c --deps d.c",
    "d.mech -o d.c --deps d.h",
    "d.mech -o d.c -o ./d.c",
    "d.mech -o d.c -o here/d.h",
    "d.mech -o d.py -o here/here/d.py",
    "d.mech -o d.x -o d.y --emit latex --deps d.x",
    "d.mech --emit json -o new/ -o new/packet_clamp.json",
]


@pytest.mark.parametrize("line", COLLISIONS)
def test_a_collision_is_refused_before_anything_is_written(folder, capsys, line):
    before = {path.name for path in folder.iterdir()}
    text = (folder / "d.mech").read_text()
    assert main(["compile", *line.split()]) == 2
    assert "would overwrite" in capsys.readouterr().err
    assert {path.name for path in folder.iterdir()} == before
    assert (folder / "d.mech").read_text() == text


def test_outputs_of_their_own_are_written(folder):
    command = ["compile", "d.mech", "-o", "d.c", "-o", "d.py", "-o", "d.tex", "--deps", "d.d"]
    assert main(command) == 0
    assert (folder / "d.d").read_text() == "d.c d.h d.py d.tex: d.mech\n"
    assert main(command) == 0


def test_a_device_takes_any_number_of_outputs(folder):
    command = "compile d.mech --emit json -o /dev/null -o /dev/null"
    assert main(command.split()) == 0


@pytest.mark.parametrize("command", ["fmt --to yaml", "check", "derive", "compile --emit c"])
def test_the_shell_may_not_append_to_what_is_read(folder, command, run_shell):
    text = (folder / "d.mech").read_text()
    done = run_shell(f"$MECHC {command} d.mech >> d.mech")
    assert done.returncode == 2
    assert "is the description 'd.mech' itself" in done.stderr
    assert (folder / "d.mech").read_text() == text


def test_standard_input_is_not_written_over(folder, run_shell):
    text = (folder / "d.mech").read_text()
    done = run_shell("$MECHC compile - --emit json -o here/d.mech < d.mech")
    assert (done.returncode, (folder / "d.mech").read_text()) == (2, text)


def test_case_counts_where_the_disk_says_so(folder, monkeypatch):
    assert claim(folder / "K.c").key != claim(folder / "k.c").key
    monkeypatch.setattr("mechc.cli.collisions._ignores_case", lambda _: True)
    assert claim(folder / "K.c").key == claim(folder / "k.c").key


def test_new_leaves_a_file_as_it_is(folder, capsys):
    text = (folder / "d.mech").read_text()
    assert main(["new", "d"]) == 3
    assert (folder / "d.mech").read_text() == text


# -------------------------------------------------------------------- rules for make


def test_a_rule_of_standard_input(folder, run_shell):
    assert run_shell("$MECHC compile - -o d.c --deps d.d < d.mech").returncode == 0
    assert (folder / "d.d").read_text() == "d.c d.h:\n"
    done = run_shell("$MECHC compile - --stdin-filename x.mech -o d.c --deps - < d.mech")
    assert done.stdout == "d.c d.h: x.mech\n"


def test_a_rule_needs_files(folder, capsys):
    assert main(["compile", "d.mech", "--emit", "c", "--deps", "d.d"]) == 2
    assert "-o" in capsys.readouterr().err
    assert main(["compile", "d.mech", *["--emit", "c", "-o", "d.c", "-o", "-", "--deps", "-"]]) == 2
    assert not list(folder.glob("d.[cd]"))


NAMES = [
    "a b",
    "a:b",
    "a#b",
    "a$b",
    "a%b",
    "a\\b",
    "a\\ b",
    "a\\\\:b",
    "a&b",
    "a (b).c",
    "-b",
    "C:\\x y",
]


@needs_make
@pytest.mark.parametrize("name", NAMES)
def test_make_reads_the_rule(tmp_path, name):
    (tmp_path / name).write_text("")
    rules = makefile_rule([Path("out")], [Path(name)]) + "\techo read\n"
    rules += makefile_rule([Path(f"{name}.c")], [Path("absent")]) + "\techo made\n"
    rules += f"absent:\nlast{makefile_rule([Path('x')], [Path(f'{name}.c')])[1:]}"
    (tmp_path / "Makefile").write_text(rules)
    done = subprocess.run(
        ["make", "-rs", "out", "last"], cwd=tmp_path, capture_output=True, text=True
    )
    assert (done.stdout.split(), done.stderr) == (["read", "made"], "")


@pytest.mark.parametrize("name", ["a=b", "a;b", "a|b", "a*b", "a\tb", "a\nb", "~b", "b\\", "a(b)"])
def test_what_no_rule_can_name_is_refused(name):
    with pytest.raises(UsageError, match="no rule for make can name"):
        makefile_rule([Path(name)], [Path("d.mech")])
    with pytest.raises(UsageError, match="no rule for make can name"):
        makefile_rule([Path("d.c")], [Path(name)])


def test_a_name_that_is_not_utf_8(folder, run_shell):
    done = run_shell("cp d.mech $'\\xff.mech'; $MECHC compile $'\\xff.mech' -o d.c --deps d.d")
    assert (done.returncode, done.stderr) == (0, "")
    assert (folder / "d.d").read_bytes() == b"d.c d.h: \xff.mech\n"
    assert os.fsdecode(b"\xff.mech") in {path.name for path in folder.iterdir()}
