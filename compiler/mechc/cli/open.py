"""A compilation of what a command was given."""

import click

from ..diagnostics import near_miss
from ..driver import Compilation
from ..syntax.settings import Settings, driven, params
from .inputs import source_of


def begin(name: str, stdin_name: str, settings: Settings) -> Compilation:
    """Open a compilation, refusing settings of parameters that the description lacks."""
    source = source_of(name, stdin_name)
    if settings:
        statements = Compilation(source).tree.statements
        declared = [p.name.text for p in params(statements)]
        declared += driven(statements)
        for unknown in (name for name in settings if name not in declared):
            hint = near_miss(unknown, declared) or f"it has {', '.join(declared) or 'none'}"
            raise click.BadParameter(
                f"{source.name} has no parameter {unknown!r}; {hint}", param_hint="-D"
            )
    return Compilation(source, settings)
