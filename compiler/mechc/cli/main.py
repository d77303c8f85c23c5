"""From a command line to an exit status, whatever happens on the way."""

import gc
import os
import sys
from collections.abc import Sequence

import click

from .. import __version__
from ..files import reason
from .commands import mechc
from .session import ENVIRONMENT, INTERNAL

INTERRUPTED = 130

PATIENT = 50_000
"""Objects between two searches for garbage: a command ends before much can gather, and
searching every 700 objects takes a twelfth of its time."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status."""
    gc.set_threshold(PATIENT)
    try:
        status = mechc.main(arguments, prog_name="mechc", standalone_mode=False)
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (click.Abort, KeyboardInterrupt):
        return INTERRUPTED
    except BrokenPipeError:
        return _hush()
    except OSError as error:
        return _refused(error)
    except SystemExit as error:
        return _hush() if error.code else 0
    except Exception as error:
        return _apologise(error)
    return status if isinstance(status, int) else 0


def _hush() -> int:
    """Let Python's own flush at exit find a standard output that can be written."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def _refused(error: OSError) -> int:
    """Say what the operating system refused: a name too long, a full disk behind a pipe."""
    place = f": {str(error.filename)[:80]!r}" if error.filename else ""
    click.echo(f"mechc: error: {reason(error)}{place}", err=True)
    return ENVIRONMENT


def _apologise(error: Exception) -> int:
    if os.environ.get("MECHC_TRACEBACK"):
        sys.excepthook(type(error), error, error.__traceback__)
    version = f"mechc {__version__}, Python {sys.version.split()[0]}, {sys.platform}"
    click.echo(
        f"mechc: internal error: {type(error).__name__}: {error}\n"
        "This is a fault of mechc, not of the description. Nothing was written. Please report it\n"
        f"with the description, the command and this line: {version}.\n"
        "MECHC_TRACEBACK=1 in the environment shows where it happened.",
        err=True,
    )
    return INTERNAL
