"""The way in: quiet when it is interrupted, even while the compiler is being imported."""

from collections.abc import Sequence
from importlib import import_module
from typing import cast

INTERRUPTED = 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status."""
    try:
        return _run(arguments)
    except KeyboardInterrupt:
        return INTERRUPTED


def _run(arguments: Sequence[str] | None) -> int:
    """Run one command; what it needs is imported here, where Ctrl-C is expected."""
    return cast(int, import_module(".run", __package__).run(arguments))
