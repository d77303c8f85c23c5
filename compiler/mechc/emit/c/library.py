"""C built into a library in a folder of the user's, and loaded: results for many poses at once."""

import atexit
import ctypes
import hashlib
import os
import platform
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from ...cache_folder import folder
from ...routine.arcs import Array
from ...routine.evaluate import OnArrays, Value, scalar_or_array

FLAGS = ("-O3", "-ffp-contract=fast", "-fPIC", "-shared")
BLOCK = 16384
"""Poses at once where an argument is one number, which fills an array of so many."""

KEPT_LIBRARIES = 64
"""Libraries that the folder holds; those that were used longest ago go."""


def compiler() -> str | None:
    """Return the C compiler's path; None where there is none."""
    asked = os.environ.get("CC", "")
    return next(filter(None, map(shutil.which, (asked, "cc", "gcc", "clang"))), None)


def functions(source: str, names: Mapping[str, str]) -> dict[str, OnArrays] | None:
    """Return the batch forms of a source by the names of their results.

    ``names`` are those of the batch forms. None where there is no compiler, or it fails.
    """
    try:
        library = _library(source)
    except (OSError, subprocess.SubprocessError):
        return None
    if library is None:
        return None
    return {result: _on_arrays(getattr(library, name)) for result, name in names.items()}


def _library(source: str) -> ctypes.CDLL | None:
    """Return a source as a library: the one in the folder, or a new one."""
    command = compiler()
    if command is None:
        return None
    parts = (source, command, *FLAGS, platform.machine(), platform.node())
    key = hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]
    target = _folder() / f"{key}.so"
    if target.exists():
        target.touch()
    else:
        _build(command, source, target)
        _tidy(target.parent)
    return ctypes.CDLL(str(target))


def _folder() -> Path:
    """Return the folder of libraries: the one for this run where nothing is to be kept."""
    kept = folder()
    libraries = Path(kept) / "libraries" if kept else _of_this_run()
    libraries.mkdir(mode=0o700, parents=True, exist_ok=True)
    return libraries


@cache
def _of_this_run() -> Path:
    made = tempfile.mkdtemp(prefix="mechc")
    atexit.register(shutil.rmtree, made, ignore_errors=True)
    return Path(made)


def _build(command: str, source: str, target: Path) -> None:
    """Write a library, complete or not at all, for the processor at hand where that can be said."""
    with tempfile.TemporaryDirectory(dir=target.parent) as place:
        code, made = Path(place) / "code.c", Path(place) / "code.so"
        code.write_text(source, encoding="utf-8")
        for native in (["-march=native"], []):
            run = [command, *FLAGS, *native, str(code), "-o", str(made), "-lm"]
            done = subprocess.run(run, capture_output=True, check=not native)
            if done.returncode == 0:
                break
        made.replace(target)


def _tidy(libraries: Path) -> None:
    by_age = sorted(libraries.glob("*.so"), key=lambda path: path.stat().st_mtime)
    for path in by_age[:-KEPT_LIBRARIES]:
        path.unlink(missing_ok=True)


def _on_arrays(batch: Any) -> OnArrays:
    batch.restype = None

    def values(*arguments: Value) -> Value:
        arrays = [np.asarray(each, dtype=np.float64) for each in arguments]
        shape = np.broadcast_shapes(*(each.shape for each in arrays))
        found = np.empty(shape)
        _fill(batch, arrays, found)
        return scalar_or_array(found)

    return values


def _fill(batch: Any, arrays: Sequence[Array], found: Array) -> None:
    """Put the values of a batch form into an array, in blocks where an argument is one number."""
    single = [each.ndim == 0 for each in arrays]
    block = min(found.size, BLOCK) if any(single) else found.size
    held = [
        np.full(block, each) if one else np.ascontiguousarray(np.broadcast_to(each, found.shape))
        for each, one in zip(arrays, single, strict=True)
    ]
    places = [(h.ctypes.data, 0 if one else 8) for h, one in zip(held, single, strict=True)]
    places.append((found.ctypes.data, 8))
    batch.argtypes = [ctypes.c_size_t, *(ctypes.c_void_p for _ in places)]
    for start in range(0, found.size, max(block, 1)):
        size = min(block, found.size - start)
        batch(size, *(place + width * start for place, width in places))
