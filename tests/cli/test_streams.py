"""Consoles of every encoding, streams that are closed or full, and an interrupted start."""

import contextlib
import gc
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from mechc.cli import main
from mechc.cli.terminal import LIKENESS, plainer
from paths import EXAMPLES

pty = pytest.importorskip("pty")

CLAMP = str(EXAMPLES / "clamp.mech")
CONSOLES = ["cp1252", "cp1251", "cp866", "ascii"]


@pytest.mark.parametrize("console", CONSOLES)
def test_data_is_utf_8_on_every_console(run_shell, console, capfdbinary, tmp_path):
    line = f"$MECHC compile {CLAMP} --emit latex --lang uk > {tmp_path}/k.tex"
    assert run_shell(line, PYTHONIOENCODING=console).stderr == ""
    assert main(["compile", CLAMP, "--emit", "latex", "--lang", "uk"]) == 0
    assert (tmp_path / "k.tex").read_bytes() == capfdbinary.readouterr().out


@pytest.mark.parametrize("console", CONSOLES)
def test_text_for_people_degrades(run_shell, console, tmp_path):
    text = Path(CLAMP).read_text().replace("Packet clamp", "Пакет → Ħ é ±")
    (tmp_path / "a.mech").write_text(text, encoding="utf-8")
    for command in ("derive", "check"):
        done = run_shell(
            f"$MECHC {command} {tmp_path}/a.mech | iconv -f {console} -t utf-8",
            PYTHONIOENCODING=console,
        )
        assert done.stderr == ""
        assert "alpha" in done.stdout


def test_a_message_quotes_what_the_console_lacks(run_shell, tmp_path):
    (tmp_path / "a.mech").write_text('mechanism m "Пакет ±" oops\n', encoding="utf-8")
    done = run_shell(f"$MECHC check {tmp_path}/a.mech", PYTHONIOENCODING="ascii")
    assert done.returncode == 1
    assert '"????? +-" oops' in done.stderr
    as_json = run_shell(f"$MECHC --format json check {tmp_path}/a.mech", PYTHONIOENCODING="ascii")
    assert "Пакет" in as_json.stderr or '"E1' in as_json.stderr


def test_the_c_locale(run_shell):
    plain = run_shell(f"$MECHC derive {CLAMP}", LC_ALL="C", PYTHONUTF8="0")
    assert (plain.returncode, plain.stderr) == (0, "")


def test_every_likeness_is_ascii():
    assert all(plainer(character).isascii() for character in [*LIKENESS, "Ж", "é", "²", "\ud800"])


@pytest.mark.parametrize(
    ("line", "status", "said"),
    [
        ("$MECHC check - <&-", 3, "standard input is closed"),
        ("$MECHC check {clamp} >&-", 3, "standard output"),
        ("$MECHC derive {clamp} >&-", 3, "standard output"),
        ("$MECHC compile {clamp} --emit c >&-", 3, "standard output"),
        ("$MECHC check -q {clamp} >&-", 0, ""),
        ("$MECHC check {clamp} 2>&- >/dev/null", 0, ""),
        ("$MECHC check nothing 2>&- >/dev/null", 3, ""),
        ("$MECHC check {clamp} >/dev/full", 3, "no space left"),
        ("$MECHC compile {clamp} --emit c >/dev/full", 3, "no space left"),
        ("$MECHC compile {clamp} --emit c | head -n 1 >&-; exit ${{PIPESTATUS[0]}}", 0, ""),
    ],
)
def test_streams_that_are_closed_or_full(run_shell, line, status, said):
    if "/dev/full" in line and not Path("/dev/full").exists():
        pytest.skip("no /dev/full here")
    done = run_shell(line.format(clamp=CLAMP))
    assert done.returncode == status
    assert said in done.stderr
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_an_interrupted_start_is_quiet(tmp_path):
    """The interrupt comes while the command line is being imported."""
    code = (
        "import sys, signal, os\n"
        "from mechc.cli import main\n"
        "class Interrupting:\n"
        "    def find_spec(self, name, *rest):\n"
        "        if name == 'mechc.compilation': os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.meta_path.insert(0, Interrupting())\n"
        f"sys.exit(main(['check', {CLAMP!r}, '--no-cache']))\n"
    )
    env = {"PYTHONPATH": str(EXAMPLES.parent / "compiler")}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=env)
    assert (done.returncode, done.stderr) == (128 + signal.SIGINT, "")


def test_who_waits_for_the_end_of_the_process_is_waited_for(run_shell, tmp_path):
    """A command ends its process at once, but for handlers, threads and profilers."""
    code = "import atexit, threading, time\nfrom mechc.cli import console\nWAITING\nconsole()\n"
    handler = "atexit.register(print, 'at last')"
    waits = "lambda: (threading.main_thread().join(), print('at last'))"
    thread = f"threading.Thread(target={waits}).start()"
    for waiting in (handler, thread):
        (tmp_path / "a.py").write_text(code.replace("WAITING", waiting))
        done = run_shell(f"{sys.executable} {tmp_path}/a.py --version")
        assert done.returncode == 0
        assert done.stdout.splitlines()[-1] == "at last"
    profile = tmp_path / "profile"
    run_shell(f"{sys.executable} -m cProfile -o {profile} -m mechc --version")
    assert profile.stat().st_size > 0


def test_a_command_inside_another_program_leaves_its_garbage_collector_alone():
    before = gc.get_threshold()
    assert main(["explain", "E101"]) == 0
    assert gc.get_threshold() == before


LONG = (
    ["stroke", "crank_rocker", "-n", "300", "--csv"],
    ["plot", CLAMP, "--x", "alpha", "--family", "beta=5,10deg"],
)


@pytest.mark.parametrize("arguments", LONG, ids=("stroke", "plot"))
def test_long_work_is_watched_on_a_terminal_alone(arguments):
    command = [sys.executable, "-m", "mechc", *arguments, "--no-cache"]
    plain = subprocess.run(command, capture_output=True, check=True)
    terminal, end = pty.openpty()
    environment = {**os.environ, "TERM": "xterm"}
    watched = subprocess.run(
        command, stdout=subprocess.PIPE, stderr=end, check=True, env=environment
    )
    os.close(end)
    with open(terminal, "rb", buffering=0) as screen:
        shown = b"".join(_until_closed(screen)).decode()
    assert plain.stderr == b""
    assert "100%" in shown
    assert watched.stdout == plain.stdout


def _until_closed(screen):
    """Yield what a terminal shows; reading from a closed one is an error on Linux."""
    with contextlib.suppress(OSError):
        while part := screen.read(4096):
            yield part
