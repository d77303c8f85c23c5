"""The way in: quiet when it is interrupted, even while the compiler is being imported."""

from __future__ import annotations

import sys
from importlib import import_module

from .answers import find, give, question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

INTERRUPTED = 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status; without arguments that of the command line."""
    try:
        return _run(arguments)
    except KeyboardInterrupt:
        return INTERRUPTED


def _run(arguments: Sequence[str] | None) -> int:
    """Answer as before, or run the command; what it needs is imported where Ctrl-C is expected."""
    asked = question(sys.argv[1:]) if arguments is None else b""
    known = find(asked) if asked else None
    try:
        status = give(known) if known else None
    except OSError as error:
        status = import_module(".run", __package__).broken(error)
    if status is None:
        status = import_module(".run", __package__).run(arguments, asked)
    assert isinstance(status, int)
    return status
