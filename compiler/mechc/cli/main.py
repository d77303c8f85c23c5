"""The way in: quiet when it is interrupted, even while the compiler is being imported."""

from __future__ import annotations

import atexit
import gc
import os
import sys
from importlib import import_module

from .find_answers import find, give, question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import NoReturn

INTERRUPTED = 130

PATIENT = 300_000
"""Objects between two searches for garbage in a process that is one command. A plain compilation
makes fewer and would spend a seventh of its time on searches every 700 objects; a longer one
is searched as its garbage may gather, some tens of megabytes at most."""


def console() -> NoReturn:
    """Be the whole process: the command line as the shell starts it, until the process ends."""
    gc.set_threshold(PATIENT)
    _leave(main())


def _leave(status: int) -> NoReturn:
    """End the process with a status, at once where nothing waits for the interpreter's end.

    Taking apart every module and object before the memory goes back to the system anyway is
    a sixth of a compilation.
    """
    if not _awaited() and _flushed():
        os._exit(status)
    sys.exit(status)


def _awaited() -> bool:
    """Return whether somebody does something at the end: a handler, a thread, a profiler."""
    threads = sys.modules.get("threading")
    monitoring = getattr(sys, "monitoring", None)
    return bool(
        getattr(atexit, "_ncallbacks", lambda: 1)()
        or (threads and threads.active_count() > 1)
        or sys.getprofile()
        or sys.gettrace()
        or (monitoring and any(map(monitoring.get_tool, range(6))))
        or sys.flags.inspect
        or os.environ.get("PYTHONINSPECT")
    )


def _flushed() -> bool:
    """Return whether both streams could be flushed; of one that fails the interpreter reports."""
    try:
        for stream in (sys.stdout, sys.stderr):
            if stream is not None:
                stream.flush()
    except (OSError, ValueError):
        return False
    return True


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
