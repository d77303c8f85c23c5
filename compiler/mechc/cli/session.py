"""How messages are shown: form, colour, and whether warnings count as errors."""

import os
from collections.abc import Callable, Iterable
from typing import Any, Literal, TypeVar

import click

from .. import witness
from ..diagnostics import Diagnostic, MechcError, Severity, drawing, statics
from ..diagnostics.render import Form, render
from ..frozen import frozen, replace
from ..source import Source
from .answers import OFF
from .terminal import give_message, on_terminal, warn
from .words import Word

F = TypeVar("F", bound=Callable[..., Any])

WRONG, ENVIRONMENT, LIMIT, INTERNAL = 1, 3, 4, 70


@frozen
class Session:
    """What the options say of messages."""

    form: Form = "full"
    color: Literal["auto", "always", "never"] = "auto"
    werror: bool = False

    def show(self, diagnostics: Iterable[Diagnostic], source: Source | None) -> None:
        """Print diagnostics on standard error."""
        for diagnostic in diagnostics:
            text = render(diagnostic, source, self.form, self.colored)
            if self.form == "json":
                give_message(text)
            else:
                warn(text, self.colored)

    @property
    def colored(self) -> bool:
        """Return whether messages are coloured: on a terminal that can, unless NO_COLOR is set."""
        if self.color == "auto":
            return on_terminal() and not os.environ.get("NO_COLOR")
        return self.color == "always"

    def accept(self, diagnostics: list[Diagnostic], source: Source) -> None:
        """Show warnings; with ``--werror`` they end the command with status 1."""
        self.show(diagnostics, source)
        if diagnostics and self.werror:
            raise click.exceptions.Exit(WRONG)


def session() -> Session:
    """Return the session of the command that runs."""
    return click.get_current_context().find_object(Session) or Session()


def status(diagnostics: Iterable[Diagnostic]) -> int:
    """Return the exit status for a set of diagnostics: the worst class of their errors.

    >>> status([Diagnostic("E203", "x", None, "x"), Diagnostic("E801", "y", None, "y")])
    4
    """
    errors = {d.code for d in diagnostics if d.severity is Severity.ERROR}
    if not errors:
        return 0
    if errors & statics.BUGS:
        return INTERNAL
    classes = {code[1] for code in errors}
    if "9" in classes or errors & drawing.LACKING:
        return ENVIRONMENT
    if "8" in classes:
        return LIMIT
    return WRONG


class Command(click.Command):
    """A command that turns the library's exception into messages and an exit status."""

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command."""
        try:
            return super().invoke(ctx)
        except MechcError as error:
            session().show(error.diagnostics, error.source)
            ctx.exit(status(error.diagnostics))


class Repeatable(Command):
    """A command whose answer hangs on its arguments and on what it reads, and on nothing else."""

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; what it answers may be kept."""
        witness.report("repeatable")
        return super().invoke(ctx)


def _remember(ctx: click.Context, parameter: click.Parameter, value: Any) -> None:
    if value is not None and parameter.name:
        ctx.obj = replace(ctx.find_object(Session) or Session(), **{parameter.name: value})


def session_options(function: F) -> F:
    """Add ``--format``, ``--color`` and the like; they may stand before or after a command."""
    for option in (_afresh, _werror, _color, _form):
        function = option(function)
    return function


_form = click.option(
    "--format",
    "form",
    type=Word(["full", "concise", "json"]),
    expose_value=False,
    callback=_remember,
    help="How messages look: full, concise (one line), json (one object per line).",
)
_color = click.option(
    "--color",
    type=Word(["auto", "always", "never"]),
    expose_value=False,
    callback=_remember,
    help="Colour messages; auto: on a terminal, unless NO_COLOR is set.",
)
_werror = click.option(
    "--werror",
    is_flag=True,
    default=None,
    expose_value=False,
    callback=_remember,
    help="Treat warnings as errors.",
)
_afresh = click.option(
    OFF,
    is_flag=True,
    expose_value=False,
    help="Compute anew what was answered before.",
)
