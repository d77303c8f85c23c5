"""What was answered before, found again without the compiler.

A question is the command line with all that an answer hangs on but the files it reads: the
folder, the encodings, the code of mechc. An answer is what happened, in order: files read and
written, and what was printed. It holds as long as every file that was read has the same bytes.

Nothing is imported here but what Python has loaded anyway, or loads in no time.
"""

from __future__ import annotations

import marshal
import os
import stat
import sys
import zlib

from ..cache_folder import folder as folder
from ..whole_files import write_whole

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

Event = tuple[str, str, bytes]
"""What happened (``read``, ``absent``, ``wrote``, ``out``, ``err``), to which file; the bytes."""

KeptAnswer = tuple[int, list[Event]]
"""The exit status and the events."""

OFF = "--no-cache"
SUFFIX = ".answer"
INSTALLED = "-packages"
"""How the names of folders of installed packages end."""

PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def question(arguments: list[str]) -> bytes:
    """Return the question that a command line puts; empty where no answer is to be kept."""
    streams = (sys.stdout, sys.stderr)
    if not arguments or OFF in arguments or not folder():
        return b""
    if not all(hasattr(stream, "buffer") for stream in streams):
        return b""
    try:
        asked = (
            [(word, os.path.isdir(word)) for word in arguments],
            [(stream.encoding, stream.isatty()) for stream in streams],
            [os.get_terminal_size(s.fileno()).columns for s in streams if s.isatty()],
            [os.environ.get(name) for name in ("NO_COLOR", "TERM", "COLUMNS")],
            (sys.version, os.getcwd(), PACKAGE, *_state()),
        )
        return ascii(asked).encode()
    except (OSError, ValueError):
        return b""


def _state() -> Iterator[int]:
    """Yield numbers that change with the code of mechc, and with what is installed along with it.

    Who installs a package changes its folder; a checkout is looked through, file by file.
    """
    for place in sys.path:
        if place.endswith(INSTALLED) and os.path.isdir(place):
            yield os.stat(place).st_mtime_ns
    above = os.path.dirname(PACKAGE)
    if above.endswith(INSTALLED):
        yield os.stat(above).st_mtime_ns
        return
    checkout = os.path.dirname(above)
    tops = [PACKAGE, *(os.path.join(checkout, name) for name in ("grammar", "library"))]
    for top in tops:
        if top == PACKAGE or os.path.isdir(top):
            yield from _files(top)


def _files(top: str) -> tuple[int, int]:
    """Return the number of files below a folder, and a sum over their paths, sizes and times."""
    found, folders = [], [top]
    while folders:
        with os.scandir(folders.pop()) as entries:
            for entry in entries:
                if not entry.is_dir():
                    status = entry.stat()
                    found.append((entry.path, status.st_size, status.st_mtime_ns))
                elif entry.name != "__pycache__":
                    folders.append(entry.path)
    found.sort()
    # Version 2 of marshal writes equal values as the same bytes; later ones tell shared objects.
    return len(found), zlib.crc32(marshal.dumps(found, 2))


def place(asked: bytes) -> str:
    """Return the file of an answer. Two questions may share it: it holds its question, too."""
    name = f"{zlib.crc32(asked):08x}{zlib.adler32(asked):08x}{SUFFIX}"
    return os.path.join(folder(), name)


def find(asked: bytes) -> KeptAnswer | None:
    """Return the answer to a question, if it is known and holds."""
    try:
        with open(place(asked), "rb") as file:
            check, content = file.read(4), file.read()
        if check != checksum(content):
            return None
        known, code, events = marshal.loads(content)
        return (code, events) if known == asked and _holds(events) else None
    except (OSError, ValueError, EOFError, TypeError):
        return None


def checksum(content: bytes) -> bytes:
    """Return the four bytes that a whole answer has and one that was cut off has not."""
    return zlib.crc32(content).to_bytes(4, "big")


def _holds(events: list[Event]) -> bool:
    """Return whether all that was read is the same, and what is written harms nothing."""
    taken = {_number(os.fstat(stream.fileno())) for stream in (sys.stdout, sys.stderr)}
    for what, path, content in events:
        if what == "read":
            with open(path, "rb") as file:
                if file.read() != content or _number(os.fstat(file.fileno())) in taken:
                    return False
        elif what == "absent" and os.path.lexists(path):
            return False
    taken |= {_number(os.stat(path)) for what, path, _ in events if what == "read"}
    return all(_writable(path, taken) for what, path, _ in events if what == "wrote")


def _writable(path: str, taken: set[tuple[int, int]]) -> bool:
    """Whether a path is free, or a plain file that is none of those taken; it is one then."""
    if not os.path.lexists(path):
        return os.path.isdir(os.path.dirname(path) or ".")
    status = os.stat(path)
    free = stat.S_ISREG(status.st_mode) and _number(status) not in taken
    taken.add(_number(status))
    return free


def _number(status: os.stat_result) -> tuple[int, int]:
    return status.st_dev, status.st_ino


# ------------------------------------------------------------------- given once more


def give(answer: KeptAnswer) -> int | None:
    """Write and print what was written and printed before; return the exit status.

    None where a file cannot be written: nothing was, and nothing is printed then.
    """
    status, events = answer
    written = {path: content for what, path, content in events if what == "wrote"}
    if write_whole(written):
        return None
    streams = {"out": sys.stdout, "err": sys.stderr}
    for what, _, content in events:
        if what in streams:
            streams[what].buffer.write(content)
            streams[what].buffer.flush()
    return status
