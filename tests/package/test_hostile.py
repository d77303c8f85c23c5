"""Descriptions and places that mean harm: an error in two seconds, existing output untouched."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from mechc.cli import main
from mechc.emit import registry
from paths import COMPILER
from sources import in_thirds

SECONDS = 20
"""Far beyond what any of these takes, on a slow machine: what runs so long may never end."""

CRANK = """\
mechanism m "{title}"
param a = 100 mm
param b = 250 mm
param alpha = 12 deg
param beta = 7 deg
{params}
pivot O
slider K along {guide}
link OBA
link BK
OB = {length} @ {direction}
OA = b @ {direction}
BK = @ -90 deg - beta
force P at A along 180 deg
force F at K along 90 deg
find k = P / F
{lets}
"""


def crank(
    title: str = "",
    params: str = "",
    guide: str = "90 deg",
    length: str = "a",
    direction: str = "alpha - 90 deg",
    lets: str = "",
) -> str:
    return CRANK.format(**locals())


def doubled(first: str, step: str, number: int, word: str = "param") -> str:
    """Return a chain in which each quantity is made of the one before, written twice."""
    lines = [f"{word} {first}"]
    lines += [f"{word} q{i + 1} = {step.format(f'q{i}')}" for i in range(number)]
    return "\n".join(lines)


def star(rods: int) -> str:
    head = "param a = 1 m\nparam t = 60 deg\npivot O\nlink OA\nOA = a @ t\n"
    each = "slider S{0} along x\nlink AS{0}\nAS{0} = @ {1} deg\n"
    arms = "".join(each.format(i, -i / 2 - 10) for i in range(rods))
    return f"{head}{arms}force P at A along -t\nforce F at S7 along x\nfind k = P/F\n"


def pendulums(number: int) -> str:
    each = "pivot O{0}\nlink O{0}A{0}\nO{0}A{0} = a @ t\n"
    head = "param a = 1 m\nparam t = 10 deg\n" + "".join(each.format(i) for i in range(number))
    return f"{head}force P at A0 along x\nforce F at A1 along x\nfind k = P/F\n"


def links(number: int) -> str:
    body = "".join(f"link O{i}O{i + 1}\n" for i in range(number))
    return f"pivot O0\n{body}force P at O{number} along x\nforce F at O1 along x\nfind k = P/F\n"


CASES = {
    "code": (1, crank(lets='let q = __import__("os").system("true")')),
    "attribute": (1, crank(lets="let q = a.__class__")),
    "tower": (1, crank(lets="let q = 9^9^9^9")),
    "small_power": (4, crank(lets="let q = 2^-9999999")),
    "powers": (1, crank(lets="let q = (((a/b)^64)^64)^64")),
    "brackets": (4, crank(lets="let q = " + "(" * 20_000 + "a" + ")" * 20_000)),
    "line": (4, "#" + "x" * 10_000_000),
    "file": (4, "pivot O\n" * 1_250_000),
    "links": (1, links(5000)),
    "star": (1, star(300)),
    "pendulums": (4, pendulums(1000)),
    "sums": (1, crank(params=doubled("q0 = 1 mm", "{0} + {0}", 300), length="q300")),
    "angles": (1, crank(params=doubled("q0 = 1 deg", "{0} + {0}", 100), direction="q100")),
    "open_sums": (1, crank(params=doubled("q0: number", "{0} + {0}", 100), length="a*q100")),
    "open_angles": (1, crank(params=doubled("q0: angle", "{0} + {0}", 100), direction="q100")),
    "products": (1, crank(params=doubled("q0 = 1.1", "{0}*{0}", 100), length="a*q100")),
    "open_products": (0, crank(params=doubled("q0: number", "{0}*{0}", 100), length="a*q100")),
    "let_sums": (0, crank(lets=doubled("q0 = k", "{0} + {0}", 100, "let"))),
    "let_products": (0, crank(lets=doubled("q0 = k", "{0}*{0}", 100, "let"))),
    "multiple": (1, crank(direction="10^6*alpha")),
    "multiples": (0, crank(direction="1000*alpha", guide="999*beta/7")),
    "quotient": (0, crank(length="a*sin(1000001*alpha)/sin(alpha)")),
    "fraction": (0, crank(direction="alpha/7919", guide="beta/7907")),
    "tiny": (0, crank(direction="alpha + 1e-30 deg")),
    "digits": (0, crank(guide="12.3456789012345 deg")),
    "radians": (0, crank(direction="alpha + 1.23456789 rad")),
    "huge": (1, crank(direction="alpha + 1e30 deg")),
    "logarithm": (1, crank(length="a*log(0)")),
    "exponential": (1, crank(length="a*exp(exp(10))")),
    "exponents": (0, crank(length="a*cos(alpha)^64*(1 + sin(beta))^64")),
    "multiple_sines": (0, crank(length=f"a*({'+'.join(f'sin({i}*beta)' for i in range(1, 60))})")),
    "name": (1, crank().replace("mechanism m", "mechanism ../evil")),
    "lets_of_a_sheet": (
        4,
        "sheet m\nparam a0 = 1 mm\n" + "".join(f"let a{i + 1} = a{i}*1.001\n" for i in range(1500)),
    ),
    "speeds_of_a_sheet": (
        0,
        "sheet m\nparam a0 = 1 rpm\n"
        + "".join(f"let a{i + 1} = a{i} + 1 rpm\n" for i in range(300)),
    ),
    "tables_of_a_sheet": (
        0,
        "sheet m\nparam w = 3 mm in 1 mm .. 9 mm\n"
        + "".join(
            f"table t{i} = 0 mm: 1, 10 mm: {i + 2}\nlet c{i} = t{i} at w\n" for i in range(300)
        ),
    ),
    "empty": (1, ""),
    "carriage_returns": (1, crank().replace("\n", "\r")),
    "nul": (1, "mechanism m\n\0\0\n"),
}
"""Exit status and text of each."""

BYTES = {
    "binary": (3, bytes(range(256)) * 100),
    "latin": (3, b'mechanism m "\xe9"\n'),
    "utf_16": (3, crank().encode("utf-16")),
    "byte_order_mark": (0, b"\xef\xbb\xbf" + crank().encode()),
    "windows": (0, crank().replace("\n", "\r\n").encode()),
}


def compiled(tmp_path: Path, content: bytes, capsys: pytest.CaptureFixture[str]) -> int:
    """Compile to C over an existing file; return the status when all is as it must be."""
    (tmp_path / "m.mech").write_bytes(content)
    (tmp_path / "m.c").write_text("kept")
    begun = time.process_time()
    status = main(["compile", str(tmp_path / "m.mech"), "-o", str(tmp_path / "m.c")])
    assert time.process_time() - begun < SECONDS
    err = capsys.readouterr().err
    assert "Traceback" not in err
    assert "\0" not in err
    assert ((tmp_path / "m.c").read_text() == "kept") == (status != 0)
    assert {p.name for p in tmp_path.iterdir()} <= {"m.mech", "m.c", "m.h"}
    return status


@pytest.mark.parametrize("name", in_thirds(CASES))
def test_hostile_descriptions(name, tmp_path, capsys):
    status, text = CASES[name]
    assert compiled(tmp_path, text.encode(), capsys) == status


@pytest.mark.parametrize("name", BYTES)
def test_hostile_bytes(name, tmp_path, capsys):
    status, content = BYTES[name]
    assert compiled(tmp_path, content, capsys) == status


# ----------------------------------------------------------------------- file system


@pytest.fixture
def clamp(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "m.mech").write_text(crank())
    return tmp_path


def failing(capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    def run(*arguments: str) -> str:
        assert main(arguments) == 3
        return capsys.readouterr().err

    return run


def test_files_that_cannot_be_read(clamp, capsys):
    run = failing(capsys)
    assert "E902" in run("derive", ".")
    (clamp / "loop.mech").symlink_to(clamp / "loop.mech")
    assert "E901" in run("check", "loop.mech")
    (clamp / "latin.mech").write_bytes(b"\xe9")
    assert "E903" in run("check", "latin.mech")
    assert "E901" in run("check", "m.mech/x")
    assert "too long" in run("check", "x" * 5000)
    assert "E901" in run("check", "a\0b")


def test_places_that_cannot_be_written(clamp, capsys):
    run = failing(capsys)
    assert "E904" in (said := run("compile", "m.mech", "-o", "nowhere/k.c"))
    assert "make the folder 'nowhere' first" in said
    assert "E904" in run("compile", "m.mech", "--emit", "c", "-o", "m.mech/")
    assert "too long" in run("compile", "m.mech", "-o", f"{'x' * 300}.c")
    assert "E905" in run("new", "m.mech")
    assert {p.name for p in clamp.iterdir()} == {"m.mech"}
    assert (clamp / "m.mech").read_text() == crank()


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write")
def test_a_folder_that_is_read_only(clamp, capsys):
    (clamp / "closed").mkdir(mode=0o500)
    assert "E904" in failing(capsys)("compile", "m.mech", "-o", "closed/k.c")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
def test_a_full_disk(clamp, capsys):
    run = failing(capsys)
    assert "E904" in run("compile", "m.mech", "--emit", "c", "-o", "/dev/full")
    with Path("/dev/full").open("w") as full:
        done = child("compile", "m.mech", "--emit", "c", stdout=full)
        assert done.wait(20) == 3
    assert "Traceback" not in done.stderr.read()


def child(*arguments: str, **options: object) -> "subprocess.Popen[str]":
    command = [sys.executable, "-m", "mechc", *arguments]
    env = {**os.environ, "PYTHONPATH": str(COMPILER)}
    return subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=env, **options)


def test_an_interrupt_is_quiet(clamp):
    waiting = child("check", "-", stdin=subprocess.PIPE)
    for _ in range(20):  # on a busy machine the first may come before the interpreter heeds it
        time.sleep(1)
        waiting.send_signal(signal.SIGINT)
        with suppress(subprocess.TimeoutExpired):
            waiting.wait(1)
            break
    assert waiting.returncode == 130
    assert "Traceback" not in waiting.stderr.read()
    waiting.stdin.close()


def test_a_closed_pipe_is_quiet(clamp):
    reading, writing = os.pipe()
    os.close(reading)
    done = child("compile", "m.mech", "--emit", "latex", stdout=writing)
    os.close(writing)
    assert done.wait(20) == 0
    assert done.stderr.read() == ""


# -------------------------------------------------------------------- what is written

RESERVED = [
    "lambda",
    "int",
    "double",
    "def",
    "end",
    "NULL",
    "np",
    "numpy",
    "math",
    "size_t",
    "M_PI",
    "main",
    "nan",
    "inf",
    "k_n",
    "restrict",
    "printf",
    "sin1",
    "I",
    "async",
    "None",
    "class",
    "register",
    "begin",
]
EVIL = r"*/ int x; /* --> <script> \input{x} $x^2$ % # & _ { } ~ ''' \\ ??/ {0} %s {{ x }} \\end"


@pytest.mark.parametrize("target", registry.BUILT_IN)
def test_names_and_titles_cannot_escape(target, tmp_path, capsys):
    params = "\n".join(f"param {n} = 1 mm" for n in RESERVED)
    text = crank(title=EVIL, params=params, length="a + " + " + ".join(RESERVED))
    (tmp_path / "m.mech").write_text(text)
    assert main(["compile", str(tmp_path / "m.mech"), "--emit", target]) == 0
    out = capsys.readouterr().out
    match target:
        case "python":
            subprocess.run([sys.executable, "-"], input=out, text=True, check=True)
        case "c":
            command = ["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-xc", "-c", "-"]
            subprocess.run([*command, "-o", "/dev/null"], input=out, text=True, check=True)
        case "latex":
            assert r"\input{x}" not in out
            assert out.count(r"\end{document}") == 1


def test_escapes_of_terminals_do_not_reach_the_terminal(tmp_path, capsys):
    (tmp_path / "m.yaml").write_text('title: "\\e[31m \\b"\nlinks: ["\\e[31mA"]\n')
    (tmp_path / "n.mech").write_text('mechanism m "\x1b[31m\n\x1b[31m\n')
    for name in ("m.yaml", "n.mech"):
        assert main(["check", str(tmp_path / name)]) == 1
        streams = capsys.readouterr()
        assert "\x1b" not in streams.out + streams.err
