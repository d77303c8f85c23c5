"""Listeners to what a run reads, writes and prints."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

Listener = Callable[[str, str, bytes], None]
"""Called with what happened, to which file, and the bytes that went through."""

_listeners: list[Listener] = []


@contextmanager
def listening(listener: Listener) -> Iterator[None]:
    """Report to a listener all that happens inside."""
    _listeners.append(listener)
    try:
        yield
    finally:
        _listeners.remove(listener)


def heard() -> bool:
    """Return whether anyone listens."""
    return bool(_listeners)


def report(what: str, place: str = "", content: bytes = b"") -> None:
    """Report to those who listen that something was read, written or printed."""
    for listener in _listeners:
        listener(what, place, content)
