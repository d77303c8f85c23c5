"""Where the files that are not Python lie."""

from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parent


@cache
def data(folder: str) -> Path:
    """Return the folder of data files, ``grammar`` or ``library``.

    In an installed package it lies inside the package; in a checkout, told by the
    ``pyproject.toml`` beside it, at the top.

    >>> (data("grammar") / "mechc.lark").is_file()
    True
    """
    packaged = PACKAGE / folder
    checkout = PACKAGE.parent.parent
    if not packaged.is_dir() and (checkout / "pyproject.toml").is_file():
        return checkout / folder
    return packaged
