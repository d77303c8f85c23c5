"""What the Tab key gives in each shell, typed in a pseudo-terminal."""

import os
import re
import select
import shutil
import sys
import time

import pytest

from mechc.cli import main
from paths import COMPILER

pty = pytest.importorskip("pty")


START = {
    "bash": ["bash", "--noprofile", "--norc", "-i"],
    "zsh": ["zsh", "-f", "-i"],
    "fish": ["fish", "--no-config", "-i"],
}
READY = {
    "bash": "source {script}",
    "zsh": "bindkey -e; autoload -U compinit; compinit -D -u; source {script}",
    "fish": "source {script}",
}
HOME = "\x01"

TYPED = {
    "che": "check",
    "check dia": "check dials",
    "check dials/cl": "check dials/clamp_of_mine.mech",
    "check karpenko_fig9_p": "check karpenko_fig9_packet_clamp",
    "compile x.mech --emit py": "compile x.mech --emit python",
    "show pos": "show pose",
    "explain w40": "explain W401",
}


@pytest.fixture
def folder(tmp_path, monkeypatch, capsys):
    """A folder with the command, a description, and room for a script of completions."""
    (tmp_path / "dials").mkdir()
    (tmp_path / "dials" / "clamp_of_mine.mech").touch()
    command = tmp_path / "bin" / "mechc"
    command.parent.mkdir()
    command.write_text(
        f'#!/bin/sh\nPYTHONPATH="{COMPILER}" exec "{sys.executable}" -m mechc "$@"\n'
    )
    command.chmod(0o755)
    monkeypatch.setenv("PATH", f"{command.parent}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("TERM", "vt100")
    monkeypatch.chdir(tmp_path)
    for shell in START:
        main(["completions", shell])
        (tmp_path / shell).write_text(capsys.readouterr().out)
    return tmp_path


@pytest.mark.parametrize("shell", START)
def test_the_tab_key_completes(folder, shell):
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    process, terminal = pty.fork()
    if process == 0:
        os.execvp(START[shell][0], START[shell])
    try:
        put(terminal, f"{READY[shell].format(script=folder / shell)}; echo rea''dy\r")
        answer(terminal, "ready")
        for begun, whole in TYPED.items():
            put(terminal, f"mechc {begun}\t{HOME}echo 'go''t' \r")
            assert answer(terminal, r"got (mechc [^\r\n]*)").rstrip(" /") == f"mechc {whole}"
    finally:
        os.close(terminal)
        os.waitpid(process, 0)


def put(terminal: int, keys: str) -> None:
    os.write(terminal, keys.encode())


def answer(terminal: int, wanted: str, seconds: float = 30.0) -> str:
    """Return the output of the shell, without the commands of its line editor."""
    found, until = "", time.monotonic() + seconds
    while time.monotonic() < until:
        if select.select([terminal], [], [], 0.1)[0]:
            found += os.read(terminal, 4096).decode(errors="replace")
            plain = re.sub(r"\x1b(\[[0-9;?]*[A-Za-z]|[()][A-Z0-9]|.)", "", found)
            if match := re.search(wanted, plain):
                return match[match.re.groups]
    raise AssertionError(f"no {wanted} in {found!r}")
