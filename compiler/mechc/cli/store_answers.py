"""Answers kept for the next time: written whole, for their owner, and not without limit."""

import marshal
import os
from contextlib import suppress
from pathlib import Path

from ..whole_files import temporary
from .find_answers import SUFFIX, Event, checksum, folder, place

LARGEST_ANSWER = 4 << 20
"""Bytes of the largest answer that is kept."""

ROOM_FOR_ANSWERS = 64 << 20
"""Bytes that all answers may take up; beyond, the older half goes."""

KNOWN = {"read", "absent", "wrote", "out", "err", "repeatable"}
"""What may have happened for an answer to be kept. The last is what a command says of itself."""


def keep(asked: bytes, status: int, events: list[Event]) -> None:
    """Keep an answer that will be the same next time: the description was right, or wrong.

    What cannot be kept is no error: a full disk, a folder that is not ours.
    """
    happened = {what for what, _, _ in events}
    if status not in (0, 1) or not {"read", "repeatable"} <= happened <= KNOWN:
        return
    if not all(os.path.isfile(path) for what, path, _ in events if what == "wrote"):
        return
    content = marshal.dumps((asked, status, [e for e in events if e[0] != "repeatable"]))
    if len(content) <= LARGEST_ANSWER:
        with suppress(OSError):
            _put(Path(place(asked)), checksum(content) + content)
            _make_room(Path(folder()))


def _put(path: Path, content: bytes) -> None:
    """Write an answer, for its owner only; whoever reads meanwhile finds the old one, or none."""
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    with temporary(str(path)) as file:
        try:
            file.write(content)
            file.close()
            os.replace(file.name, path)
        finally:
            Path(file.name).unlink(missing_ok=True)


def _make_room(kept: Path) -> None:
    """Remove the older half of the answers where they are too many."""
    found = [(entry.stat(), entry) for entry in kept.glob(f"*{SUFFIX}")]
    if sum(status.st_size for status, _ in found) <= ROOM_FOR_ANSWERS:
        return
    found.sort(key=lambda one: one[0].st_mtime_ns)
    for _, entry in found[: (len(found) + 1) // 2]:
        entry.unlink(missing_ok=True)
