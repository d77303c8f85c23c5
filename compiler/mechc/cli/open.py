"""A compilation of what a command was given."""

from ..diagnostics import near_miss
from ..driver import Compilation
from ..source import Source
from ..syntax.settings import Settings, driven, drives, params
from . import usage
from .inputs import source_of


def begin(name: str, stdin_name: str, settings: Settings, drive: str = "") -> Compilation:
    """Open a compilation, refusing settings of parameters that the description lacks.

    Of several drives the one of the name given moves.
    """
    source = source_of(name, stdin_name)
    if drive:
        _check_drive(drive, source)
    check_names(settings, source, "-D")
    return Compilation(source, settings, drive)


def check_names(settings: Settings, source: Source, option: str) -> None:
    """Refuse settings of parameters that a description lacks."""
    if not settings:
        return
    statements = Compilation(source).composed.statements
    declared = [p.name.text for p in params(statements)]
    declared += driven(statements)
    for unknown in (name for name in settings if name not in declared):
        hint = near_miss(unknown, declared) or f"it has {', '.join(declared) or 'none'}"
        raise usage.BadParameter(
            f"{source.name} has no parameter {unknown!r}; {hint}", where=option
        )


def _check_drive(drive: str, source: Source) -> None:
    declared = [d.name.text for d in drives(Compilation(source).tree.statements)]
    if drive not in declared:
        hint = near_miss(drive, declared) or f"it has {', '.join(declared) or 'none'}"
        raise usage.BadParameter(f"{source.name} has no drive {drive!r}; {hint}", where="--drive")
