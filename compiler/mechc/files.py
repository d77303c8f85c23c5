"""Files in and out: descriptions read with limits, outputs written whole or not at all."""

import os
import sys
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path, PurePosixPath

from . import events, whole_files
from .base.frozen import replace
from .data_folders import data
from .diagnostics import MechcError, near_miss, syntax_limits
from .diagnostics import files as messages
from .source import Source, Span

LARGEST_DESCRIPTION = 1 << 20
"""Bytes in the largest description that is read."""

SUFFIXES = (".mech", ".yaml", ".yml")

SHEETS = "sheets"
"""The folder of the library's calculation sheets, in that of its mechanisms."""


# ------------------------------------------------------------------------- reading


def find(name: str) -> Path:
    """Return the path of a description: a file of this name, or one of the library.

    Raises :class:`MechcError` (E901) with the nearest name where there is neither.

    >>> find("karpenko_fig9_packet_clamp").stem
    'karpenko_fig9_packet_clamp'
    """
    path = Path(name)
    if path.exists():
        return path
    events.report("absent", name)
    if found := _in_library(name):
        return found
    listed = library()
    beside = _neighbours(path)
    meant = next((f"did you mean {name + s!r}?" for s in SUFFIXES if name + s in beside), "")
    hint = meant or near_miss(name, [*listed, *beside]) or _holding(name, listed)
    raise MechcError([messages.file_not_found(name, hint)])


def used(name: str, folder: Path | None, span: Span) -> Path:
    """Return the path of what a description uses: of the library by name, or in its folder.

    Raises :class:`MechcError`: E907 where there is none, E908 where a path leads elsewhere.
    """
    if not name.endswith(SUFFIXES):
        if found := _in_library(name):
            return found
        hint = _beside(name, folder) or near_miss(name, library())
        raise MechcError([messages.used_not_found(span, name, hint)])
    parts = PurePosixPath(name).parts
    climbs = "\\" in name or ":" in name or name.startswith("/") or ".." in parts
    if climbs or folder is None:
        raise MechcError([messages.used_elsewhere(span, name, nowhere=not climbs)])
    try:
        path = resolved(folder / name)
        inside, there = path.is_relative_to(resolved(folder)), path.is_file()
    except OSError:
        inside, there = True, False
    if not inside:
        raise MechcError([messages.used_elsewhere(span, name, nowhere=False)])
    if not there:
        beside = [str(PurePosixPath(*parts[:-1], p.name)) for p in _descriptions(path.parent)]
        hint = near_miss(name, beside) or "a path is that from this file"
        raise MechcError([messages.used_not_found(span, name, hint)])
    return folder / name


def _beside(name: str, folder: Path | None) -> str:
    """Propose a file beside this one, where its name stands without quotes and suffix."""
    beside = _descriptions(folder) if folder else []
    return next((f'a file is in quotes: "{p.name}"' for p in beside if p.stem == name), "")


def _descriptions(folder: Path) -> list[Path]:
    with suppress(OSError):
        return sorted(p for p in folder.iterdir() if p.suffix in SUFFIXES)
    return []


def _in_library(name: str) -> Path | None:
    """Return the path of what the library has under a name, without looking at the rest."""
    folder = data("library")
    for place in (folder, folder / SHEETS):
        held = os.listdir(place)
        for file in (f"{name}{suffix}" for suffix in SUFFIXES):
            if file in held:
                return place / file
    return None


def library() -> dict[str, Path]:
    """Return the library, mechanisms and sheets: path by name, in alphabetical order."""
    folder = data("library")
    paths = (p for p in folder.rglob("*") if p.suffix in SUFFIXES)
    return {p.stem: p for p in sorted(paths, key=lambda p: p.stem)}


def mechanisms() -> dict[str, Path]:
    """Return the library without its sheets, which lie in a folder of their own."""
    return {name: path for name, path in library().items() if path.parent.name != SHEETS}


def _holding(name: str, listed: Iterable[str]) -> str:
    """Propose the mechanisms whose names hold this one."""
    longer = [known for known in listed if name in known]
    return f"the library has {', '.join(longer[:5])}" if name and longer else ""


def _neighbours(path: Path) -> list[str]:
    with suppress(OSError):
        return [str(path.with_name(p.name)) for p in path.parent.iterdir()]
    return []


def read(path: Path) -> Source:
    """Return the text of a file; :class:`MechcError` (E801, E902, E903) where it is none."""
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_DESCRIPTION + 1)
        events.report("read", str(path), content)
        return replace(decode(content, str(path)), folder=path.parent)
    except OSError as error:
        raise MechcError([messages.file_unreadable(str(path), reason(error))]) from None


def read_stdin(name: str) -> Source:
    """Return the text on standard input under a name; :class:`MechcError` where there is none."""
    if sys.stdin is None:
        raise MechcError([messages.file_unreadable(name, "standard input is closed")])
    events.report("read from a stream", name)
    try:
        return decode(sys.stdin.buffer.read(LARGEST_DESCRIPTION + 1), name)
    except OSError as error:
        raise MechcError([messages.file_unreadable(name, reason(error))]) from None


def decode(content: bytes, name: str) -> Source:
    """Return bytes as a source, a byte-order mark and Windows line ends put aside."""
    if len(content) > LARGEST_DESCRIPTION:
        oversize = syntax_limits.text_too_long(Span(0, 0), len(content), LARGEST_DESCRIPTION)
        raise MechcError([oversize], Source(name, ""))
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise MechcError([messages.file_not_text(name, error.start)]) from None
    return Source(name, text.replace("\r\n", "\n"))


def reason(error: OSError) -> str:
    """Return the operating system's words for an error, without the path."""
    return (error.strerror or str(error)).lower()


# ------------------------------------------------------------------------- writing


def make_folder(path: Path) -> None:
    """Make a folder, and those above it; :class:`MechcError` (E904) where it cannot be."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise MechcError([messages.file_unwritable(str(path), reason(error))]) from None


def write_all(files: Mapping[Path, str | bytes]) -> None:
    """Write all files or none, as :func:`~.whole_files.write_whole` does.

    Raises :class:`MechcError` (E904) where one cannot be written.
    """
    contents = {str(path): _encoded(content) for path, content in files.items()}
    if failure := whole_files.write_whole(contents):
        path, error = failure
        folder = os.path.dirname(path)
        lacking = folder if folder and not os.path.exists(folder) else ""
        raise MechcError([messages.file_unwritable(path, reason(error), lacking)])
    for path, content in contents.items():
        events.report("wrote", path, content)


def resolved(path: Path) -> Path:
    """Return a path with its links followed; ``OSError`` where these form a cycle."""
    return Path(whole_files.resolved(str(path)))


def _encoded(content: str | bytes) -> bytes:
    return content if isinstance(content, bytes) else content.encode("utf-8", "surrogateescape")
