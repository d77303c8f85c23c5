"""How messages are shown: form, colour, and whether warnings count as errors."""

import os
from collections.abc import Callable, Iterable, Mapping
from contextvars import ContextVar
from typing import Any, Literal, TypeVar

from .. import events
from ..base.frozen import frozen, replace
from ..diagnostics import Diagnostic, MechcError, render
from ..source import Source
from .exit_status import WRONG, status
from .find_answers import OFF
from .terminal import give_message, on_terminal, warn
from .usage import Command, Exit, Option, Word, adding

F = TypeVar("F", bound=Callable[..., Any])


@frozen
class Session:
    """What the options say of messages; ``afresh`` that no answer is given that was kept."""

    form: Literal["full", "concise", "json"] = "full"
    color: Literal["auto", "always", "never"] = "auto"
    werror: bool = False
    afresh: bool = False

    def show(self, diagnostics: Iterable[Diagnostic], source: Source | None) -> None:
        """Print diagnostics on standard error."""
        for diagnostic in diagnostics:
            text = render.render(diagnostic, source, self.form, self.colored)
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
            raise Exit(WRONG)


_running: ContextVar[Session] = ContextVar("session")


def session() -> Session:
    """Return the session of the command that runs."""
    return _running.get(Session())


def perform(command: Command, values: Mapping[str, Any], how: Session | None = None) -> int:
    """Run a command with the values of its arguments and options; return the exit status.

    Those of a session change ``how``. Errors in descriptions are shown here; a
    :class:`.usage.UsageError` is for the caller to show.
    """
    shown = {name: value for name, value in values.items() if name in NAMES}
    how = replace(how or Session(), **{n: value for n, value in shown.items() if value is not None})
    if command.repeatable:
        events.report("repeatable")
    token = _running.set(how)
    try:
        return command.run(**{n: v for n, v in values.items() if n not in NAMES}) or 0
    except MechcError as error:
        how.show(error.diagnostics, error.source)
        return status(error.diagnostics)
    except Exit as end:
        return end.status
    finally:
        _running.reset(token)


OPTIONS = (
    Option(
        "form",
        ("--format",),
        kind=Word(("full", "concise", "json")),
        of_session=True,
        help="How messages look: full, concise (one line), json (one object per line).",
    ),
    Option(
        "color",
        ("--color",),
        kind=Word(("auto", "always", "never")),
        of_session=True,
        help="Colour messages; auto: on a terminal, unless NO_COLOR is set.",
    ),
    Option(
        "werror",
        ("--werror",),
        is_flag=True,
        of_session=True,
        help="Treat warnings as errors.",
    ),
    Option(
        "afresh",
        (OFF,),
        is_flag=True,
        of_session=True,
        help="Compute anew what was answered before.",
    ),
)
"""The options of a session; they may stand before or after a command."""

NAMES = frozenset(option.name for option in OPTIONS)


def session_options(function: F) -> F:
    """Add the options of a session to a command."""
    for one in reversed(OPTIONS):
        function = adding(one)(function)
    return function
