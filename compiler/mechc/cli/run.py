"""From a command line to an exit status, whatever happens on the way."""

import os
import sys
from collections.abc import Sequence
from contextlib import suppress

from ..events import listening
from ..files import reason
from ..version import VERSION
from . import by_click, store_answers, terminal
from .commands import COMMANDS, found
from .exit_status import ENVIRONMENT, INTERNAL
from .find_answers import Event
from .plain import read
from .session import perform
from .usage import UsageError

COMPLETING = "_MECHC_COMPLETE"
"""Set in the environment where a shell asks for completions."""


def run(arguments: Sequence[str] | None = None, asked: bytes = b"") -> int:
    """Run one command and return its exit status; KeyboardInterrupt where it is interrupted.

    The answer to what is ``asked`` is kept for the next time.
    """
    terminal.prepare()
    try:
        return _answered(arguments, asked) if asked else _status(arguments)
    except OSError as error:
        return broken(error)
    except SystemExit as error:
        return _hush(0) if error.code else 0
    except Exception as error:
        return _apologise(error)


def _status(arguments: Sequence[str] | None) -> int:
    """Run the command of a line and return the exit status.

    Click, which takes long to import, reads completions, and lines that are not plain.
    """
    words = sys.argv[1:] if arguments is None else [*arguments]
    status = None if COMPLETING in os.environ else _plainly(words)
    if status is None:
        status = by_click.run(arguments)
    terminal.flush()
    return status


def _plainly(words: list[str]) -> int | None:
    """Run the command of a line that is plain; None where it is for click to read."""
    if not words or words[0] not in COMMANDS:
        return None
    command = found(words[0])
    values = read(command, words[1:])
    if values is None:
        return None
    try:
        return perform(command, values)
    except UsageError as error:
        return by_click.refuse(command, error)


def _answered(arguments: Sequence[str] | None, asked: bytes) -> int:
    events: list[Event] = []
    with listening(lambda *event: events.append(event)):
        status = _status(arguments)
    store_answers.keep(asked, status, events)
    return status


def broken(error: OSError) -> int:
    """Return the status where a stream or a file failed: 0 where nobody reads on."""
    return _hush(0 if isinstance(error, BrokenPipeError) else _refused(error))


def _hush(status: int) -> int:
    """Return the status; Python's own flush at exit finds a standard output that can be written."""
    with suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return status


def _refused(error: OSError) -> int:
    """Say what the operating system refused: a name too long, a full disk behind a pipe."""
    place = f": {str(error.filename)[:80]!r}" if error.filename else ""
    terminal.warn(f"mechc: error: {reason(error)}{place}")
    return ENVIRONMENT


def _apologise(error: Exception) -> int:
    if os.environ.get("MECHC_TRACEBACK"):
        sys.excepthook(type(error), error, error.__traceback__)
    version = f"mechc {VERSION}, Python {sys.version.split()[0]}, {sys.platform}"
    terminal.warn(
        f"mechc: internal error: {type(error).__name__}: {error}\n"
        "This is a fault of mechc, not of the description. Nothing was written. Please report it\n"
        f"with the description, the command and this line: {version}.\n"
        "MECHC_TRACEBACK=1 in the environment shows where it happened."
    )
    return INTERNAL
