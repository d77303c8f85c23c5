"""The folders of files that are not Python: the grammar, the library, and packages' own."""

import atexit
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import shutil
    import tempfile
    from importlib.resources.abc import Traversable
else:
    from .base.later import Later

    shutil, tempfile = Later("shutil"), Later("tempfile")

PACKAGE = Path(__file__).parent


@cache
def data(folder: str) -> Path:
    """Return the folder of data files, ``grammar`` or ``library``, or a package's own.

    In an installed package it lies inside the package; in a checkout, known by the
    ``pyproject.toml`` next to it, at the top. Out of a zip file it is unpacked.

    >>> (data("grammar") / "mechc.lark").is_file()
    True
    """
    packaged = PACKAGE / folder
    checkout = PACKAGE.parent.parent
    if packaged.is_dir():
        return packaged
    if (checkout / "pyproject.toml").is_file():
        return checkout / folder
    return _unpacked(folder)


def _unpacked(folder: str) -> Path:
    """Return a copy of a folder out of the zip file that the package was imported from.

    It goes when Python ends.
    """
    packed: Traversable = import_module("importlib.resources").files(__package__)
    target = Path(tempfile.mkdtemp(prefix="mechc-"))
    atexit.register(shutil.rmtree, target, ignore_errors=True)
    _copy(packed.joinpath(*folder.split("/")), target / folder)
    return target / folder


def _copy(packed: "Traversable", target: Path) -> None:
    if packed.is_file():
        target.write_bytes(packed.read_bytes())
        return
    target.mkdir(parents=True)
    for part in packed.iterdir():
        _copy(part, target / part.name)
