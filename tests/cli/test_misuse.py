"""Command lines that make no sense: the right status, a message, and nothing written."""

import io
import shutil
import sys

import pytest

from mechc.cli import main
from paths import EXAMPLES

CLAMP = (EXAMPLES / "clamp.mech").read_bytes()

USAGE, FILES = 2, 3


@pytest.fixture
def call(tmp_path, monkeypatch, capsys):
    """Return a function that runs mechc in a folder of good and bad files."""
    shutil.copy(EXAMPLES / "clamp.mech", tmp_path)
    shutil.copy(EXAMPLES / "clamp.yaml", tmp_path)
    (tmp_path / "loop.mech").symlink_to("loop.mech")
    (tmp_path / "folder").mkdir()
    (tmp_path / "latin.mech").write_bytes("mechanism м".encode("cp1251"))
    monkeypatch.chdir(tmp_path)

    def run(line):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(CLAMP)))
        before = sorted(tmp_path.rglob("*")), (tmp_path / "clamp.mech").read_bytes()
        status = main(line.split())
        assert before == (sorted(tmp_path.rglob("*")), (tmp_path / "clamp.mech").read_bytes())
        return status, *capsys.readouterr()

    return run


@pytest.mark.parametrize(
    ("line", "status", "said"),
    [
        ("fmt --to yaml clamp.mech clamp.yaml", USAGE, "--to prints one description, 2 are given"),
        ("fmt --to mech - clamp.yaml", USAGE, "--to prints one description"),
        ("fmt - -", USAGE, "standard input (-) is read once"),
        ("new loop.mech", FILES, "symbolic links"),
        ("compile clamp.mech --emit c -o loop.mech", FILES, "symbolic links"),
        ("compile clamp.mech -o folder", USAGE, ""),
        ("compile clamp.mech -o nowhere/x.c", FILES, "no such file or directory"),
        ("compile clamp.mech --emit", USAGE, "requires an argument"),
        ("compile clamp.mech --emit c -D", USAGE, "requires an argument"),
        ("compile clamp.mech --emit c -D alpha", USAGE, "not NAME=VALUE"),
        ("compile clamp.mech --emit c -D a=1mm -D a=2mm", USAGE, "'a' is set twice"),
        ("compile clamp.mech --emit c -D a=1mm+-0.1mm", USAGE, "a value alone is set"),
        ("compile clamp.mech --emit c -D =3", USAGE, ""),
        ("compile clamp.mech --emit python -o k.c", USAGE, "a file of c by its suffix"),
        ("compile clamp.mech --emit c -D F=3kN", USAGE, "by a line `let F = 3 kN`"),
        ("compile clamp.mech --emit c --lang ua", USAGE, "Ukrainian is 'uk'"),
        ("explain 201", USAGE, "did you mean 'E201' or 'W201'?"),
        ("check clamp", FILES, "did you mean 'clamp.mech'?"),
        ("compile clamp.mech --emit latex --gradient", USAGE, "--gradient is about c and python"),
        ("compile clamp.mech -o k.py --c-openmp", USAGE, "--c-openmp is about c, and python"),
        (
            "compile clamp.mech -o k.c -o k.py --brief",
            USAGE,
            "--brief is about latex, and c, python",
        ),
        ("report clamp.mech -o table.csv", USAGE, "would hold LaTeX: write it to 'table.tex'"),
        ("check loop.mech", FILES, "E901"),
        ("derive folder", FILES, "is a directory"),
        ("check folder", FILES, "no file in 'folder' ends in .mech"),
        ("check latin.mech", FILES, "not UTF-8"),
        ("check clamp.mech/x", FILES, "E901"),
        ("clamp.mech check", USAGE, "a command comes first: `mechc check clamp.mech`"),
        ("stroke", USAGE, "Missing argument"),
        ("show zzz clamp.mech", USAGE, ""),
    ],
)
def test_what_makes_no_sense_is_refused(call, line, status, said):
    found, out, err = call(line)
    assert (found, out) == (status, "")
    assert said in err
    assert err
    assert "Traceback" not in err


def test_one_description_is_turned_into_the_other_notation(call):
    status, out, _ = call("fmt --to yaml clamp.mech")
    assert status == 0
    assert out.count("mechanism:") == 1
