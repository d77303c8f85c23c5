"""Print a digest of everything that mechc writes of each description named: run as a script.

The first argument names the commands, with commas between; each other one is a file, or
``grown:SEED`` for a random closed mechanism. A line is a file, a command and the digest of
what it wrote to standard output and standard error. The last line says whether NumPy, whose
sines differ between its versions, had a part in it.
"""

import hashlib
import io
import sys
from collections.abc import Iterator
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory

from grown import Grown
from mechc.cli import main
from mechc.emit.registry import BUILT_IN

COMMANDS = {
    "check": ["check", "--verbose"],
    "stroke": ["stroke", "--velocities"],
    "derive": ["derive"],
    **{f"show {stage}": ["show", stage] for stage in ("pose", "statics", "figure", "bodies")},
    **{target: ["compile", "--emit", target] for target in BUILT_IN},
}


def digests(commands: list[str], names: list[str]) -> Iterator[str]:
    for name in names:
        path = grown(name) if name.startswith("grown:") else Path(name)
        for title in commands:
            found = hashlib.sha256(printed([*COMMANDS[title], str(path)])).hexdigest()
            yield f"{path.name} {title} {found}"


def grown(name: str) -> Path:
    path = Path(f"{name.replace(':', '_')}.mech")
    path.write_text(Grown(int(name.partition(":")[2])).text(), encoding="utf-8")
    return path


def printed(command: list[str]) -> bytes:
    streams = io.StringIO(), io.StringIO()
    with redirect_stdout(streams[0]), redirect_stderr(streams[1]):
        main(command)
    out, err = (stream.getvalue() for stream in streams)
    return f"{out}\0{err}".encode()


if __name__ == "__main__":
    with TemporaryDirectory() as scratch, chdir(scratch):
        print("\n".join(digests(sys.argv[1].split(","), sys.argv[2:])))
    print("NumPy" if "numpy" in sys.modules else "no NumPy")
