"""The command line: what goes where, exit status, files whole or not at all."""

import io
import json
import os
import re
import shutil
import stat
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from mechc import __version__
from mechc.cli import main
from mechc.cli.by_click import mechc
from mechc.cli.commands import COMMANDS
from mechc.cli.commands.list import NOTED, noted
from mechc.data_folders import data
from mechc.files import library
from paths import EXAMPLES

WRONG = "mechanism m\nparam l = 1 m\npivot O\nlink OA\nOA = l @ alhpa\nfind k = P/F\n"


class Run(NamedTuple):
    status: int
    out: str
    err: str


Mechc = Callable[..., Run]


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Mechc:
    """Return a function that runs mechc in a folder with one good and one wrong description."""
    shutil.copy(EXAMPLES / "clamp.mech", tmp_path)
    shutil.copy(EXAMPLES / "clamp.yaml", tmp_path)
    (tmp_path / "wrong.mech").write_text(WRONG)
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("NO_COLOR", raising=False)

    def call(*arguments: str, stdin: bytes = b"") -> Run:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(stdin)))
        status = main(arguments)
        return Run(status, *capsys.readouterr())

    return call


# ------------------------------------------------------------------------- compile


@pytest.mark.parametrize(
    ("target", "mark"),
    [("latex", r"\documentclass"), ("python", "def k("), ("c", "packet_clamp_k("), ("json", "{")],
)
def test_compile_prints_one_file(run: Mechc, target: str, mark: str) -> None:
    status, out, err = run("compile", "clamp.yaml", "--emit", target)
    assert (status, err) == (0, "")
    assert mark in out


def test_both_notations_give_the_same(run: Mechc) -> None:
    one, other = (run("compile", f, "--emit", "python").out for f in ("clamp.mech", "clamp.yaml"))
    assert one == other


def test_compile_by_suffix_and_to_a_folder(run: Mechc, tmp_path: Path) -> None:
    assert run("compile", "clamp.mech", "-o", "k.c", "-o", "k.py", "-o", "k.tex") == (0, "", "")
    assert {"k.c", "k.h", "k.py", "k.tex"} <= {p.name for p in tmp_path.iterdir()}
    assert '#include "k.h"' in (tmp_path / "k.c").read_text()
    assert run("compile", "clamp.mech", "--emit", "c", "-o", "build/") == (0, "", "")
    assert {p.name for p in (tmp_path / "build").iterdir()} == {"packet_clamp.c", "packet_clamp.h"}


def test_emit_overrides_the_suffix(run: Mechc, tmp_path: Path) -> None:
    assert run("compile", "clamp.mech", "--emit", "python", "-o", "k.txt").status == 0
    assert "def k(" in (tmp_path / "k.txt").read_text()


@pytest.mark.parametrize(
    "line", ["compile clamp.mech --emit latex -o", "compile clamp.mech -o", "report clamp.mech -o"]
)
def test_no_text_is_written_to_what_is_to_be_a_page(run: Mechc, tmp_path: Path, line: str) -> None:
    status, _, err = run(*line.split(), "k.PDF")
    assert status == 2
    assert "'k.PDF' would hold no .PDF: write LaTeX to 'k.tex'" in err
    assert not (tmp_path / "k.PDF").exists()


def test_fragment_and_language(run: Mechc) -> None:
    out = run("compile", "clamp.mech", "--emit", "latex", "--fragment", "--lang", "uk").out
    assert r"\documentclass" not in out
    assert "ї" in out or "і" in out


def test_standard_input(run: Mechc, tmp_path: Path) -> None:
    text = (tmp_path / "clamp.mech").read_bytes()
    assert "def k(" in run("compile", "-", "--emit", "python", stdin=text).out
    status, _, err = run(
        "compile", "-", "--emit", "c", "--stdin-filename", "in.mech", stdin=b"pivot"
    )
    assert status == 1
    assert err.startswith("in.mech:1:")


def test_name_of_the_library(run: Mechc) -> None:
    assert "def k(" in run("compile", "karpenko_fig9_packet_clamp", "--emit", "python").out
    status, _, err = run("compile", "karpenko_fig9_packet_clmp", "--emit", "python")
    assert status == 3
    assert "did you mean 'karpenko_fig9_packet_clamp'?" in err


def test_define_sets_a_parameter(run: Mechc) -> None:
    plain = run("compile", "clamp.mech", "--emit", "json")
    other = run("compile", "clamp.mech", "--emit", "json", "-D", "alpha=30deg", "-D", "a = 0.2 m")
    assert other.status == 0
    assert plain.out != other.out
    assert "did you mean 'alpha'?" in run("check", "clamp.mech", "-D", "alhpa=1deg").err
    assert run("check", "clamp.mech", "-D", "alpha=1 mm").status == 1
    assert run("check", "clamp.mech", "-D", "alpha=)").status == 2
    assert run("check", "clamp.mech", "-D", "alpha").status == 2


def test_rule_for_make(run: Mechc, tmp_path: Path) -> None:
    run("compile", "clamp.mech", "-o", "k.c", "--deps", "k.d")
    assert (tmp_path / "k.d").read_text() == "k.c k.h: clamp.mech\n"


@pytest.mark.parametrize(
    "arguments",
    [
        ["compile", "clamp.mech"],
        ["compile", "clamp.mech", "-o", "k.xls"],
        ["compile", "clamp.mech", "--emit", "fortran"],
        ["compile", "clamp.mech", "--emit", "c", "-o", "clamp.mech"],
        ["compile"],
        ["complie", "clamp.mech"],
        ["show", "stage", "clamp.mech"],
    ],
    ids=" ".join,
)
def test_usage_errors(run: Mechc, tmp_path: Path, arguments: list[str]) -> None:
    before = (tmp_path / "clamp.mech").read_text()
    status, out, err = run(*arguments)
    assert (status, out) == (2, "")
    assert "Error:" in err
    assert (tmp_path / "clamp.mech").read_text() == before


def test_unknown_format_lists_the_known(run: Mechc) -> None:
    assert "latex, python, c, json" in run("compile", "clamp.mech", "-o", "k.xls").err


# ------------------------------------------------------------- whole or not at all


def test_wrong_description_leaves_files_alone(run: Mechc, tmp_path: Path) -> None:
    (tmp_path / "k.c").write_text("kept")
    status, out, err = run("compile", "wrong.mech", "-o", "k.c", "-o", "k.py")
    assert (status, out) == (1, "")
    assert "alhpa" in err
    assert (tmp_path / "k.c").read_text() == "kept"
    assert not (tmp_path / "k.py").exists()


def test_all_files_or_none(run: Mechc, tmp_path: Path) -> None:
    status, _, err = run("compile", "clamp.mech", "-o", "k.py", "-o", "nowhere/k.c")
    assert status == 3
    assert "nowhere" in err
    assert not [
        p for p in tmp_path.iterdir() if "k" in p.suffixes or p.name.startswith((".k", "k"))
    ]


def test_permissions_and_links_survive(run: Mechc, tmp_path: Path) -> None:
    real = tmp_path / "real.py"
    real.write_text("old")
    real.chmod(0o640)
    (tmp_path / "k.py").symlink_to(real)
    run("compile", "clamp.mech", "-o", "k.py")
    assert (tmp_path / "k.py").is_symlink()
    assert "def k(" in real.read_text()
    assert stat.S_IMODE(real.stat().st_mode) == 0o640


# ------------------------------------------------------------------ exit and words


def test_exit_status_by_kind(run: Mechc, tmp_path: Path) -> None:
    (tmp_path / "big.mech").write_bytes(b"#" * (2 << 20))
    (tmp_path / "latin.mech").write_bytes("механізм".encode("cp1251"))
    assert run("check", "clamp.mech").status == 0
    assert run("check", "wrong.mech").status == 1
    assert run("check", "nothing.mech").status == 3
    assert run("check", "latin.mech").status == 3
    assert run("derive", str(tmp_path)).status == 3
    assert run("check", "big.mech").status == 4


def test_a_folder_stands_for_the_descriptions_below_it(run: Mechc, tmp_path: Path) -> None:
    for path in ("a/one.mech", "a/b/two.yml", "a/.git/three.mech", "a/readme.txt"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text((EXAMPLES / "clamp.mech").read_text())
    (tmp_path / "a/b/two.yml").write_text((EXAMPLES / "clamp.yaml").read_text())
    status, out, err = run("check", "a")
    assert (status, err) == (0, "")
    assert [line for line in out.splitlines() if ".y" in line or ".m" in line] == [
        "a/b/two.yml: packet_clamp",
        "a/one.mech: packet_clamp",
    ]
    (tmp_path / "empty").mkdir()
    for command in ("check", "fmt"):
        status, _, err = run(command, "empty")
        assert status == 3
        assert "error[E906]: no file in 'empty' ends in .mech" in err


def test_a_verbose_check_states_what_is_given_and_what_is_missing(
    run: Mechc, tmp_path: Path
) -> None:
    text = (library()["crank_rocker"]).read_text()
    (tmp_path / "good.mech").write_text(text)
    good = [" ".join(line.split()) for line in run("check", "-v", "good.mech").out.splitlines()]
    assert "O2 pivot at (d, 0 mm), on O2B" in good
    assert "phi = 60 deg, the drive, from 0 deg to 360 deg" in good
    assert "psi found by a loop, coupler, from the loop" in good
    assert "len_AO2 from a, d, phi" in good
    (tmp_path / "open.mech").write_text(
        text.replace("pivot O1 at (0 mm, 0 mm)", "pivot O1").replace("@ psi", "")
    )
    status, out, err = run("check", "-v", "open.mech")
    assert status == 1
    assert "error[E" in err
    missing = [" ".join(line.split()) for line in out.splitlines()]
    assert "O1 pivot without a place, on O1A" in missing
    assert "theta without a value (deg), rocker, from the loop" in missing
    assert "AB = b a loop must give its direction" in missing
    assert run("check", "-v", "wrong.mech").out == ""


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        (("chek", "x.mech"), "did you mean 'check'?"),
        (("x.mech",), "a command comes first: `mechc check x.mech`"),
        (("zzz",), "`mechc --help` lists them"),
        (("show", "poses", "clamp.mech"), "did you mean 'pose'?"),
        (("compile", "clamp.mech", "--emit", "pyton"), "did you mean 'python'?"),
        (("show", "clamp.mech", "pose"), "before the description: `mechc show pose clamp.mech`"),
        (("plot", "clamp.mech", "-y", "k"), "Did you mean '--y'?"),
        (("stroke", "clamp.mech", "-o", "k.csv"), "`mechc stroke … > FILE`"),
        (("fmt", "clamp.mech", "-o", "k.mech"), "laid out in place"),
        (("new", "arm", "-o", "k.mech"), "`mechc new arm` writes arm.mech"),
    ],
)
def test_a_mistyped_word_earns_the_nearest_one(
    run: Mechc, line: tuple[str, ...], hint: str
) -> None:
    status, out, err = run(*line)
    assert (status, out) == (2, "")
    assert hint in err


def test_internal_error_asks_for_a_report(run: Mechc, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mechc.pipeline.read", lambda *_: 1 / 0)
    status, out, err = run("check", "clamp.mech")
    assert (status, out) == (70, "")
    assert f"mechc {__version__}" in err
    assert "Traceback" not in err
    monkeypatch.setenv("MECHC_TRACEBACK", "1")
    assert "Traceback" in run("check", "clamp.mech").err


def test_messages_as_json(run: Mechc) -> None:
    err = run("--format", "json", "check", "wrong.mech").err
    records = [json.loads(line) for line in err.splitlines()]
    assert {r["file"] for r in records} == {"wrong.mech"}
    assert run("check", "--format", "json", "wrong.mech").err == err


def test_concise_messages_are_lines(run: Mechc) -> None:
    lines = run("check", "--format", "concise", "wrong.mech").err.splitlines()
    assert lines
    assert all(line.startswith("wrong.mech:") for line in lines)


def test_colour_only_where_asked(run: Mechc, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "\x1b" not in run("check", "wrong.mech").err
    assert "\x1b" in run("check", "--color", "always", "wrong.mech").err
    assert "\x1b" in run("--color", "always", "check", "wrong.mech").err
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("TERM", "xterm")
    assert "\x1b" in run("check", "wrong.mech").err
    monkeypatch.setenv("TERM", "dumb")
    assert "\x1b" not in run("check", "wrong.mech").err
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b" not in run("check", "wrong.mech").err


def test_warnings_become_errors_on_demand(run: Mechc, tmp_path: Path) -> None:
    text = (tmp_path / "clamp.mech").read_text().replace("along 180 deg", "along 0 deg")
    (tmp_path / "turned.mech").write_text(text.split("\nexpect")[0] + "\n")
    status, _, err = run("compile", "turned.mech", "-o", "k.py")
    assert status == 0
    assert "warning[W" in err
    (tmp_path / "k.py").unlink()
    assert run("compile", "--werror", "turned.mech", "-o", "k.py").status == 1
    assert not (tmp_path / "k.py").exists()
    assert run("check", "--werror", "turned.mech").status == 1


def test_broken_pipe_is_quiet(tmp_path: Path) -> None:
    command = f"{sys.executable} -m mechc explain | head -n 1"
    env = {**os.environ, "PYTHONPATH": str(EXAMPLES.parent / "compiler")}
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, env=env)
    assert done.stderr == ""
    assert len(done.stdout.splitlines()) == 1


# ------------------------------------------------------------------ other commands


def test_check_says_what_it_found(run: Mechc) -> None:
    out = run("check", "clamp.mech").out
    assert "k = a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))" in out
    assert "proved" in out
    assert "equilibrium of the free bodies agrees" in out
    assert "condition" in run("check", "--verbose", "clamp.mech").out
    assert run("check", "--quiet", "clamp.mech").out == ""


def test_check_states_a_given_load_once_in_its_unit(run: Mechc) -> None:
    lines = run("check", "tongs_fig4_9_forces").out.splitlines()
    assert "  N = 500 N" in lines
    assert not any("where N" in line for line in lines)


def test_check_goes_through_all_files(run: Mechc) -> None:
    status, out, err = run("check", "wrong.mech", "clamp.mech")
    assert status == 1
    assert "wrong.mech" in err
    assert "packet_clamp" in out


def test_derive(run: Mechc) -> None:
    out = run("derive", "clamp.mech").out
    assert "V_B" in out
    assert "k" in out


@pytest.mark.parametrize(
    "stage",
    "syntax model pose kinematics power statics derivation routine".split(),  # noqa: SIM905
)
def test_show_every_stage(run: Mechc, stage: str) -> None:
    status, out, _ = run("show", stage, "clamp.mech")
    assert status == 0
    assert len(out) > 100
    assert "object at 0x" not in out
    assert max(map(len, out.splitlines())) < 400


@pytest.mark.parametrize("kind", ["four-bar", "slider-crank", "gripper", "cylinder", "sheet"])
def test_new_by_coordinates_compiles_as_it_is(run: Mechc, kind: str) -> None:
    for name in ("a.mech", "b.yaml"):
        run("new", name, f"--{kind}")
        status, out, err = run("check", name)
        assert (status, err) == (0, "")
        assert "len_O" in out or kind == "sheet"
        assert run("fmt", "--check", name).status == 0


def test_new_compiles_as_it_is(run: Mechc) -> None:
    for name in ("clamp2.mech", "clamp3.yaml"):
        assert run("new", name).out == f"{name}\n"
        status, out, err = run("check", name)
        assert (status, err) == (0, "")
        assert "proved" in out
        assert run("fmt", "--check", name).status == 0
    assert run("new", "press").out == "press.mech\n"
    assert run("new", "press").status == 3
    assert run("new", "my press").status == 2


def test_fmt_in_place_and_dry(run: Mechc, tmp_path: Path) -> None:
    file = tmp_path / "clamp.mech"
    tidy = file.read_text()
    assert run("fmt", "--check", "clamp.mech") == (0, "", "")
    file.write_text(tidy.replace("pivot O", "pivot   O"))
    untidy = file.read_text()
    assert run("fmt", "--check", "clamp.mech").status == 1
    assert "-pivot   O" in run("fmt", "--diff", "clamp.mech").out
    assert file.read_text() == untidy
    assert run("fmt", "clamp.mech") == (0, "", "")
    assert file.read_text() == tidy
    assert run("fmt", "-", stdin=untidy.encode()).out == tidy


def test_fmt_between_notations(run: Mechc, tmp_path: Path) -> None:
    yaml = run("fmt", "--to", "yaml", "clamp.mech").out
    assert "mechanism: packet_clamp" in yaml
    (tmp_path / "again.yaml").write_text(yaml)
    assert run("fmt", "--to", "mech", "again.yaml").out == (tmp_path / "clamp.mech").read_text()


def test_fmt_brings_entries_of_one_name_together(run: Mechc) -> None:
    pins = "".join(f"friction pin {point} f diameter d\n" for point in "AS")
    lines = f"friction screw S 0.1 thread d\n{pins}"
    yaml = run("fmt", "--to", "yaml", "-", stdin=lines.encode())
    assert yaml.status == 0
    assert yaml.out.index("S:") < yaml.out.index("A:")


def test_fmt_goes_through_all_files(run: Mechc, tmp_path: Path) -> None:
    (tmp_path / "wrong.mech").write_text("pivot ?\n")
    status, _, err = run("fmt", "--check", ".")
    assert status == 1
    assert "wrong.mech:1:7" in err


def test_fmt_of_a_folder_names_what_changes_and_leaves_out_what_is_hidden(
    run: Mechc, tmp_path: Path
) -> None:
    untidy = (tmp_path / "clamp.mech").read_text().replace("pivot O", "pivot   O")
    for folder in ("all/.git", "all/sub"):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "untidy.mech").write_text(untidy)
    assert run("fmt", "all") == (0, "", f"changed {Path('all/sub/untidy.mech')}\n")
    assert (tmp_path / "all/.git/untidy.mech").read_text() == untidy
    assert run("fmt", "all") == (0, "", "")


@pytest.fixture
def short_library(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The library with every eighth of its mechanisms: results are computed to be listed."""
    names = sorted(library())[::8]
    monkeypatch.setattr("mechc.cli.commands.list.library", lambda: {n: library()[n] for n in names})
    return names


def test_list(run: Mechc) -> None:
    heading, *rows = run("list").out.splitlines()
    assert heading.split() == ["NAME", "TITLE"]
    assert len(rows) > 20
    assert not [row for row in rows if "…" in row]


@pytest.mark.slow
def test_records_of_the_list_have_results(run: Mechc) -> None:
    records = [json.loads(line) for line in run("list", "--json").out.splitlines()]
    assert [r["name"] for r in records] == sorted(library())
    assert not [r for r in records if r["k"].startswith("(E")]


def test_list_with_results(run: Mechc, short_library: list[str]) -> None:
    heading, *rows = run("list", "--long").out.splitlines()
    assert heading.split() == ["NAME", "TITLE", "SOURCE", "RESULT"]
    assert [row.split()[0] for row in rows] == short_library


@pytest.mark.parametrize("language", ["uk", "ru"])
def test_titles_in_a_language(run: Mechc, language: str) -> None:
    _, *rows = run("list", "--lang", language).out.splitlines()
    assert [row.split()[0] for row in rows] == sorted(library())
    assert not [row for row in rows if not re.search("[а-яіїєґ]", row)]


@pytest.mark.parametrize("language", ["uk", "ru"])
def test_list_in_a_language(run: Mechc, short_library: list[str], language: str) -> None:
    _, *rows = run("list", "--lang", language).out.splitlines()
    records = map(json.loads, run("list", "--json", "--lang", language).out.splitlines())
    assert [(r["name"], r["title"]) for r in records] == [tuple(r.split(None, 1)) for r in rows]


def test_titles_noted_are_those_of_the_library() -> None:
    assert (data("library") / NOTED).read_text("utf-8") == noted()


def test_a_title_noted_of_another_text_is_read_again(
    run: Mechc, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = run("list").out
    monkeypatch.setattr(
        "mechc.cli.commands.list._noted", lambda: {"four_bar": (0, "something else")}
    )
    assert run("list").out == before


def test_explain(run: Mechc) -> None:
    assert run("explain", "e901").out.startswith("E901: file-not-found\n")
    assert run("explain", "file-not-found").out == run("explain", "E901").out
    assert "E901  file-not-found" in run("explain").out
    assert "\n\n    telescope ABC            # wrong" in run("explain", "E111").out
    assert "\n\n    link OB\n    telescope OB     # warned of" in run("explain", "W254").out
    status, _, err = run("explain", "E91")
    assert status == 2
    assert "did you mean" in err


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completions(run: Mechc, shell: str) -> None:
    assert "_MECHC_COMPLETE" in run("completions", shell).out


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_with_an_example(run: Mechc, name: str) -> None:
    out = run(name, "--help").out
    assert f"mechc {name}" in out.split("Usage:")[1].split("\n", 1)[1]
    command = mechc.get_command(None, name)  # type: ignore[arg-type]
    assert command
    assert command.name == name


def test_help_lists_every_command(run: Mechc) -> None:
    out = run("--help").out
    assert all(f"  {name} " in out for name in COMMANDS)


def test_of_the_library_can_be_written_in_both_notations(run: Mechc) -> None:
    for name in sorted(library())[::3]:
        for notation in ("mech", "yaml"):
            status, out, err = run("fmt", "--to", notation, name)
            assert (status, err) == (0, ""), name
            assert out


@pytest.mark.parametrize(
    ("command", "fails"),
    [("check", "FAILS"), ("derive", "FAILS"), ("derive --lang uk", "НЕ ВИКОНАНО")],
)
def test_a_condition_that_fails_stands_in_the_whole_calculation(
    run: Mechc, tmp_path: Path, command: str, fails: str
) -> None:
    path = tmp_path / "bolt.mech"
    path.write_text(FAILING_BOLT, encoding="utf-8")
    status, out, err = run(*command.split(), str(path))
    assert status == 1
    (line,) = (line for line in out.splitlines() if line.endswith(f", {fails}"))
    assert "254" in line
    assert sum("reserve" in line for line in out.splitlines()) == 1
    assert "E550" in err


def test_no_reserve_is_the_least_where_a_condition_fails(run: Mechc, tmp_path: Path) -> None:
    path = tmp_path / "bolt.mech"
    holding = FAILING_BOLT + "param a = 2 mm\nlet b = 3*a\nrequire b < 8 mm\nrequire b > 5 mm\n"
    path.write_text(holding, encoding="utf-8")
    _, out, _ = run("check", str(path))
    assert sum(", reserve" in line for line in out.splitlines()) > 1
    assert ", the least" not in out


def test_a_calculation_with_another_mistake_is_not_shown(run: Mechc, tmp_path: Path) -> None:
    path = tmp_path / "bolt.mech"
    path.write_text(f"{FAILING_BOLT}let z = 1/(F - 20 kN)\n", encoding="utf-8")
    status, out, err = run("check", str(path))
    assert (status, out) == (1, "")
    assert "E550" in err
    assert "E551" in err


FAILING_BOLT = """\
sheet bolt "Bolt in shear"
param F = 20 kN
param d = 10 mm
let tau = 4*F/(pi*d^2) in MPa  # shear stress
require tau < 100 MPa
let s = 100 MPa/tau  # reserve
"""
