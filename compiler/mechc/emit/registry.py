"""Targets by name and by file suffix, loaded when they are used.

A target of mechc itself is one line of :data:`BUILT_IN`. Other packages offer theirs
through the entry-point group ``mechc.targets``; those are looked for only when a name
or a suffix is none of our own, so that finding a target costs nothing otherwise.
"""

from collections.abc import Iterable
from importlib import import_module
from typing import TYPE_CHECKING, cast

from ..base.named import NamedTuple
from ..diagnostics import emission as messages
from ..diagnostics.diagnostic import MechcError, Report
from .target import Target

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

GROUP = "mechc.targets"
"""The entry-point group in which packages register their targets."""


class TargetModule(NamedTuple):
    """The module whose ``TARGET`` it is, and the suffixes that choose it."""

    module: str
    suffixes: tuple[str, ...]


BUILT_IN = {
    "latex": TargetModule("mechc.emit.latex.to_latex", (".tex",)),
    "python": TargetModule("mechc.emit.python.to_python", (".py",)),
    "c": TargetModule("mechc.emit.c.to_c", (".c", ".h")),
    "json": TargetModule("mechc.emit.json.to_json", (".json",)),
}
"""Our own targets, which no other package can replace."""


def names() -> tuple[str, ...]:
    """Return the name of every target, ours first.

    >>> names()[:4]
    ('latex', 'python', 'c', 'json')
    """
    return (*BUILT_IN, *_foreign())


def load(name: str) -> Target:
    """Return a target by its name; LookupError where there is none.

    Raises :class:`MechcError` (E702) where another package's target does not load.
    """
    if name in BUILT_IN:
        return cast(Target, import_module(BUILT_IN[name].module).TARGET)
    if name not in (foreign := _foreign()):
        known = ", ".join(names())
        raise LookupError(f"no format is called {name!r}; there are {known}")
    target = _try(foreign[name])
    if isinstance(target, str):
        raise MechcError([messages.broken_target(name, foreign[name].value, target)])
    return target


def by_suffix(suffix: str, report: Report | None = None) -> str | None:
    """Return the name of the target that a file suffix chooses, or None.

    >>> by_suffix(".h")
    'c'
    """
    if ours := own_by_suffix(suffix):
        return ours
    return next((n for n, t in _loaded(report).items() if suffix in t.suffixes), None)


def own_by_suffix(suffix: str) -> str | None:
    """Return the name of the target of our own that a file suffix chooses, or None."""
    return next((name for name, place in BUILT_IN.items() if suffix in place.suffixes), None)


def targets(report: Report | None = None) -> dict[str, Target]:
    """Return every target by name, ours first, all loaded.

    One of another package that does not load is left out with a warning (W701).
    """
    return {name: load(name) for name in BUILT_IN} | _loaded(report)


def _loaded(report: Report | None) -> dict[str, Target]:
    """Return the targets of other packages that load."""
    found: dict[str, Target] = {}
    for name, entry in _foreign().items():
        target = _try(entry)
        if not isinstance(target, str):
            found[name] = target
        elif report is not None:
            report.add(messages.left_out_target(name, entry.value, target))
    return found


def entry_points(group: str) -> Iterable["EntryPoint"]:
    """Return the entries of all packages; looking them up costs a sixth of a compilation."""
    return cast(
        "Iterable[EntryPoint]", import_module("importlib.metadata").entry_points(group=group)
    )


def _foreign() -> dict[str, "EntryPoint"]:
    """Return the entries of other packages; of two under one name the first by its value."""
    found: dict[str, EntryPoint] = {}
    for entry in sorted(entry_points(group=GROUP), key=lambda e: (e.name, e.value)):
        if entry.name not in BUILT_IN:
            found.setdefault(entry.name, entry)
    return found


def _try(entry: "EntryPoint") -> Target | str:
    """Return the target, or what is wrong with it: a stranger's module may raise anything."""
    try:
        target = entry.load()
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    missing = [part for part in ("name", "suffixes", "emit") if not hasattr(target, part)]
    return f"an object without {', '.join(missing)}" if missing else cast(Target, target)
