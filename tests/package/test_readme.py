"""Every block of the README is true: descriptions compile, commands print what is shown."""

import doctest
import re
import shlex
from pathlib import Path

import pytest

import mechc
from mechc.cli import main
from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.units import SIMPLE, SPELLINGS, UNITS
from paths import ROOT
from readme_commands import commands

README = ROOT / "README.md"
TEXT = README.read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


def test_the_description_is_the_example() -> None:
    (yaml,) = blocks("yaml")
    example = (ROOT / "examples" / "clamp.yaml").read_text(encoding="utf-8")
    assert yaml in example
    assert (
        str(mechc.loads(yaml, "README.yaml").k) == "a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))"
    )


def test_the_drawn_description_is_the_example() -> None:
    """The example has its texts in other languages behind it."""
    example = (ROOT / "examples" / "gripper.mech").read_text(encoding="utf-8")
    shown, others = example.split("\ntranslate ", 1)
    assert blocks("mech")[0] == shown
    assert all(line.startswith("translate ") for line in others.splitlines()[1:])


@pytest.mark.parametrize("text", blocks("mech"))
def test_descriptions_compile(text: str) -> None:
    """One that uses another is an example, which stands beside that."""
    files = (ROOT / "examples").rglob("*.mech")
    example = next(
        (f for f in files if f.read_text("utf-8").split("\ntranslate ")[0] == text), None
    )
    found = mechc.load(example) if example else mechc.loads(text, "README.mech")
    assert found.warnings == []


@pytest.mark.parametrize("block", blocks("console"))
def test_commands_print_what_is_shown(
    block: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    request: pytest.FixtureRequest,
) -> None:
    monkeypatch.chdir(ROOT / "examples")
    found = ""
    for line in re.findall(r"^\$ mechc (.*)", block, re.MULTILINE):
        main(shlex.split(line))
        found += f"$ mechc {line}\n{capsys.readouterr().out}"
    if request.config.getoption("--update"):
        README.write_text(README.read_text("utf-8").replace(block, found), encoding="utf-8")
    else:
        assert found == block


def test_python_session(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    runner = doctest.DocTestRunner(verbose=False, optionflags=flags)
    for number, block in enumerate(blocks("python")):
        if ">>>" in block:
            session = doctest.DocTestParser().get_doctest(block, {}, f"README {number}", None, 0)
            runner.run(session)
    assert runner.summarize(verbose=False).failed == 0
    assert runner.tries > 0


def test_two_commands_are_single_lines_that_set_themselves_up() -> None:
    found = commands(TEXT)
    assert len(found) == 2
    assert all(c.startswith("python3 -m venv .venv && .venv/bin/pip install") for c in found)


def test_mentioned_files_exist() -> None:
    for name in re.findall(r"`((?:examples|tests|library)/[\w./]+)`", TEXT):
        assert (ROOT / name).exists(), name


@pytest.mark.parametrize("row", re.findall(r"^\| `mechc (.*?)` \|", TEXT, re.MULTILINE))
def test_commands_of_the_table_work(
    row: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "clamp.mech").write_bytes((ROOT / "examples" / "clamp.mech").read_bytes())
    assert main(shlex.split(row.replace("STAGE", "power"))) == 0


def rows() -> list[tuple[str, str]]:
    """Return the first example in lines and in YAML of each row of the table of the language."""
    section = TEXT.split("| lines | YAML | meaning |")[1].split("\n\n")[0]
    return re.findall(r"^\| `([^`]+)`.*? \| `([^`]+)`.* \| ", section, re.MULTILINE)[1:]


@pytest.mark.parametrize(("line", "yaml"), rows(), ids=[line for line, _ in rows()])
def test_both_columns_of_the_language_say_the_same(line: str, yaml: str) -> None:
    trees = []
    for source in (Source("row.mech", f"{line}\n"), Source("row.yaml", f"{yaml}\n")):
        report = Report(source)
        trees.append(read(source, report))
        assert report.diagnostics == []
    assert trees[0].statements
    assert trees[0] == trees[1]


def test_the_list_of_units_is_whole() -> None:
    said = re.findall(
        r"^Units are (.*?), and the usual ones made of them, (.*?);", TEXT, re.M | re.S
    )
    words, compounds = (" ".join(re.findall("`([^`]+)`", part)).split() for part in said[0])
    assert {*words} == (SIMPLE.keys() | {"Hz", "J"}) - SPELLINGS.keys()
    assert {*compounds} <= UNITS.keys()
