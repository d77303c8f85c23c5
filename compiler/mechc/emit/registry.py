"""All targets by name: the built-in ones, then those of other packages.

Nothing of a built-in target is imported before it emits.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points

from ..diagnostics.diagnostic import Report
from ..diagnostics.emission import broken_target, second_target
from .target import Compiled, Emitted, Options, Target

GROUP = "mechc.targets"
"""The entry-point group in which packages register their targets."""


@dataclass(frozen=True)
class BuiltIn:
    """A target of mechc's own, by the module that holds its ``TARGET``."""

    name: str
    suffixes: tuple[str, ...]
    module: str

    @cached_property
    def _target(self) -> Target:
        target: Target = import_module(self.module, __package__).TARGET
        return target

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return the files of the target itself."""
        return self._target.emit(compiled, options)


BUILT_IN = (
    BuiltIn("python", (".py",), ".to_python"),
    BuiltIn("c", (".c", ".h"), ".to_c"),
    BuiltIn("latex", (".tex",), ".to_latex"),
    BuiltIn("json", (".json",), ".to_json"),
)


def targets(report: Report | None = None) -> dict[str, Target]:
    """Return every target by name, built-in ones first.

    A target of another package that does not load, or whose name is in use, is left
    out with a warning in the report.

    >>> list(targets())[:4]
    ['python', 'c', 'latex', 'json']
    """
    found: dict[str, Target] = {target.name: target for target in BUILT_IN}
    for entry in _foreign():
        target = _load(entry, report)
        if target is not None and entry.name not in found:
            found[entry.name] = target
        elif target is not None and report is not None:
            report.add(second_target(entry.name, entry.value))
    return found


def by_suffix(suffix: str, report: Report | None = None) -> Target | None:
    """Return the target that a file's suffix (``.c``) chooses, or None.

    >>> by_suffix(".h").name
    'c'
    """
    for target in BUILT_IN:
        if suffix in target.suffixes:
            return target
    return next((t for t in targets(report).values() if suffix in t.suffixes), None)


def _foreign() -> Iterator[EntryPoint]:
    """Yield the entries of other packages, in a fixed order."""
    own = {(t.name, f"mechc.emit{t.module}:TARGET") for t in BUILT_IN}
    for entry in sorted(entry_points(group=GROUP), key=lambda e: (e.name, e.value)):
        if (entry.name, entry.value) not in own:
            yield entry


def _load(entry: EntryPoint, report: Report | None) -> Target | None:
    try:
        target = entry.load()
        missing = [f for f in ("name", "suffixes", "emit") if not hasattr(target, f)]
        reason = f"an object without {', '.join(missing)}" if missing else ""
    except Exception as error:  # whatever a stranger's module raises as it loads
        target, reason = None, f"{type(error).__name__}: {error}"
    if reason and report is not None:
        report.add(broken_target(entry.name, entry.value, reason))
    return None if reason else target
