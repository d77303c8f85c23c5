"""Files out, whole or not at all. Imported ahead of the compiler: it needs nothing."""

from __future__ import annotations

import errno
import os
import stat

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import BinaryIO

    Failure = tuple[str, OSError]
    """The file that could not be written, and why."""


def write_whole(files: Mapping[str, bytes]) -> Failure | None:
    """Write all files or none: each into a temporary file beside its place, then moved.

    Return what failed; files of an earlier run are then as they were. A device or a pipe
    (``/dev/stdout``) is written directly.
    """
    pending: list[tuple[str, str]] = []
    path = ""
    try:
        for path, content in files.items():
            _prepare(path, content, pending)
        for path, made in pending:
            os.replace(made, path)
    except OSError as error:
        return path, error
    finally:
        for _, made in pending:
            if os.path.exists(made):
                os.unlink(made)
    return None


def _prepare(path: str, content: bytes, pending: list[tuple[str, str]]) -> None:
    """Write a file's content beside its place; both are ``pending`` then."""
    target = resolved(path)
    if os.path.exists(target) and not os.path.isfile(target):
        with open(target, "wb") as device:
            device.write(content)
        return
    with temporary(target) as file:
        pending.append((target, file.name))
        file.write(content)
    os.chmod(file.name, _mode(target))


def resolved(path: str) -> str:
    """Return a path with its links followed; ``OSError`` where these form a cycle."""
    found = os.path.realpath(path)
    try:
        os.stat(found)
    except OSError as error:
        if error.errno == errno.ELOOP:
            raise
    return found


def temporary(target: str) -> BinaryIO:
    """Return a new file beside another, open for writing, that its owner alone can read."""
    folder, name = os.path.split(target)
    attempt = 0
    while True:
        beside = os.path.join(folder, f".{name}.{os.getpid()}-{attempt}")
        try:
            return open(beside, "xb", opener=lambda path, flags: os.open(path, flags, 0o600))
        except FileExistsError:
            attempt += 1


def _mode(target: str) -> int:
    """Return the permissions of the file replaced, or those a new file gets."""
    if os.path.exists(target):
        return stat.S_IMODE(os.stat(target).st_mode)
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
