"""Targets by name and by file suffix, loaded when they are used.

A target of mechc itself is one line of :data:`BUILT_IN`. Other packages offer theirs
through the entry-point group ``mechc.targets``; those are looked for only when a name
or a suffix is none of our own, so that finding a target costs nothing otherwise.
"""

from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from typing import NamedTuple, cast

from .target import Target

GROUP = "mechc.targets"


class Place(NamedTuple):
    """The module whose ``TARGET`` it is, and the suffixes that choose it."""

    module: str
    suffixes: tuple[str, ...]


BUILT_IN = {
    "latex": Place("mechc.emit.to_latex", (".tex",)),
    "python": Place("mechc.emit.to_python", (".py",)),
    "c": Place("mechc.emit.to_c", (".c", ".h")),
    "json": Place("mechc.emit.to_json", (".json",)),
}


def names() -> tuple[str, ...]:
    """Return the name of every target, ours first.

    >>> names()[:4]
    ('latex', 'python', 'c', 'json')
    """
    return tuple(BUILT_IN) + tuple(e.name for e in _foreign())


def load(name: str) -> Target:
    """Return a target by its name; LookupError where there is none."""
    if name in BUILT_IN:
        return cast(Target, import_module(BUILT_IN[name].module).TARGET)
    for entry in _foreign():
        if entry.name == name:
            return cast(Target, entry.load())
    raise LookupError(name)


def by_suffix(suffix: str) -> str | None:
    """Return the name of the target that a file suffix chooses, or None.

    >>> by_suffix(".h")
    'c'
    """
    for name, place in BUILT_IN.items():
        if suffix in place.suffixes:
            return name
    return next((e.name for e in _foreign() if suffix in load(e.name).suffixes), None)


def _foreign() -> tuple[EntryPoint, ...]:
    return tuple(e for e in entry_points(group=GROUP) if e.name not in BUILT_IN)
