"""No command writes over what it reads, nor one output over another."""

import os
import stat
import sys
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import TextIO

from ..base.named import NamedTuple
from ..files import resolved
from . import usage

FileKey = tuple[object, ...]
"""The identity of a file, whatever path leads to it."""


class Claim(NamedTuple):
    """A file that is read or written, and what messages call it."""

    key: FileKey | None
    name: str


def refuse_collisions(written: Iterable[Path], read: Iterable[Claim], printed: bool) -> None:
    """End with a usage error where an output is what was read, or another output.

    ``printed`` states that something goes to standard output, too.
    """
    taken = {known.key: f"the description {known.name!r}" for known in read if known.key}
    claims = [claim(path) for path in written]
    for key, name in [*claims, *(streams(sys.stdout) if printed else ())]:
        if key in taken:
            raise usage.UsageError(f"the output {name!r} would overwrite {taken[key]}")
        if key:
            taken[key] = f"the output {name!r}"


def refuse_reading(read: Claim) -> None:
    """End with a usage error where the shell lets standard output write to what is read."""
    for stream in (sys.stdout, sys.stderr):
        for key, name in streams(stream):
            if key and key == read.key:
                raise usage.UsageError(f"{name} is the description {read.name!r} itself")


def claim(path: Path) -> Claim:
    """Return the identity of a path's file; none where it is a device or a pipe.

    A file that is there is known by its number on its disk, so that links and letters'
    case do not matter; one that is not, by its folder and its name.
    """
    with suppress(OSError):
        return Claim(_number(path.stat()), str(path))
    place = resolved(path)
    with suppress(OSError):
        folder = place.parent.stat()
        name = place.name.casefold() if _ignores_case(place.parent) else place.name
        return Claim((folder.st_dev, folder.st_ino, name), str(path))
    return Claim((str(place),), str(path))


def streams(stream: TextIO | None) -> Iterator[Claim]:
    """Yield the file of a standard stream, where the shell made it one."""
    if stream is not None:
        with suppress(OSError, ValueError):
            yield Claim(_number(os.fstat(stream.fileno())), stream.name.strip("<>"))


def _number(status: os.stat_result) -> FileKey | None:
    return (status.st_dev, status.st_ino) if stat.S_ISREG(status.st_mode) else None


def _ignores_case(folder: Path) -> bool:
    """Return whether a folder's disk takes ``A`` and ``a`` for one name."""
    twin = folder.with_name(folder.name.swapcase())
    return twin != folder and twin.exists() and twin.samefile(folder)
