"""What a command writes: text for people, in their console's letters, and data, always UTF-8.

A console that lacks a letter gets a likeness of it (``->`` for an arrow), never a crash.
LaTeX, code, descriptions and tables of numbers are the same bytes whatever the console is.
"""

import codecs
import errno
import os
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, TextIO, TypeVar
from unicodedata import normalize

from .. import events

if TYPE_CHECKING:
    import shutil

    import click
else:
    from ..base.later import Later

    click, shutil = Later("click"), Later("shutil")

T = TypeVar("T")

LIKENESS = {
    "→": "->", "←": "<-", "⇒": "=>", "↔": "<->", "−": "-", "–": "-", "—": "-", "·": "*", "×": "*",
    "÷": "/", "≤": "<=", "≥": ">=", "≠": "!=", "≈": "~", "≡": "==", "±": "+-", "°": " deg",
    "′": "'", "″": '"', "‘": "'", "’": "'", "“": '"', "”": '"', "«": '"', "»": '"', "√": "sqrt",
    "∞": "inf", "π": "pi", "∑": "sum", "Σ": "sum", "∂": "d", "⟂": "perp ", "⊥": "perp ",
    "∥": "||", "∠": "angle ", "∈": "in", "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta",
    "ε": "epsilon", "ζ": "zeta", "η": "eta", "θ": "theta", "ι": "iota", "κ": "kappa",
    "λ": "lambda", "μ": "mu", "ν": "nu", "ξ": "xi", "ο": "omicron", "ρ": "rho", "σ": "sigma",
    "τ": "tau", "υ": "upsilon", "φ": "phi", "χ": "chi", "ψ": "psi", "ω": "omega", "Γ": "Gamma",
    "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Ξ": "Xi", "Π": "Pi", "Φ": "Phi", "Ψ": "Psi",
    "Ω": "Omega",
}  # fmt: skip
"""What stands for a letter that a console lacks."""


USUAL_WIDTH, NARROW, WIDE = 80, 40, 120
"""Columns of text that goes to no terminal, and of the narrowest and widest lines on one."""


def plainer(character: str) -> str:
    """Return an ASCII likeness of a character, ``?`` where it has none.

    >>> [plainer(c) for c in "→é²Ж"]
    ['->', 'e', '2', '?']
    """
    if character in LIKENESS:
        return LIKENESS[character]
    return normalize("NFKD", character).encode("ascii", "ignore").decode() or "?"


def _plainer_text(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    part = error.object[error.start : error.end]
    return "".join(map(plainer, part)), error.end


def prepare() -> None:
    """Let both streams write what their encoding lacks by its likeness."""
    codecs.register_error("mechc.plainer", _plainer_text)
    for stream in (sys.stdout, sys.stderr):
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="mechc.plainer")


def flush() -> None:
    """Write out what waits, while an error can still be shown."""
    if sys.stdout is not None:
        sys.stdout.flush()


def speaks_unicode() -> bool:
    """Return whether standard output takes every letter."""
    return (getattr(_out(), "encoding", None) or "utf-8").lower().startswith("utf")


def columns() -> int:
    """Return how wide lines of text are: as the terminal is, but none that is hard to read."""
    if not (sys.stdout is not None and sys.stdout.isatty()):
        return USUAL_WIDTH
    return min(max(shutil.get_terminal_size().columns, NARROW), WIDE)


def line_width() -> int:
    """Return where lines are broken on a terminal; elsewhere each statement has one line."""
    return columns() if sys.stdout is not None and sys.stdout.isatty() else sys.maxsize


def on_terminal() -> bool:
    """Return whether messages go to a terminal that knows colours: a dumb one does not."""
    return sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


def watched(items: Sequence[T], label: str) -> Iterator[T]:
    """Yield items, a bar on the terminal saying how many have been dealt with."""
    if not on_terminal():
        yield from items
        return
    step = max(1, len(items) // 100)
    with click.progressbar(items, label=label, file=sys.stderr, update_min_steps=step) as bar:
        yield from bar


def say(text: object, end: str = "\n") -> None:
    """Write text for people on standard output."""
    _say("out", _out(), f"{text}{end}")


def give(text: str) -> None:
    """Write data on standard output: UTF-8, line ends as they are."""
    _give("out", _out(), text)


def warn(text: str, color: bool = False) -> None:
    """Write a message for people on standard error."""
    if sys.stderr is not None:
        _say("err", sys.stderr, f"{text}\n", color)


def give_message(text: str) -> None:
    """Write a message for programs on standard error: UTF-8."""
    if sys.stderr is not None:
        _give("err", sys.stderr, f"{text}\n")


def _say(what: str, stream: TextIO, text: str, color: bool = False) -> None:
    _report(what, stream, text)
    if color:
        click.echo(text, file=stream, nl=False, color=True)
    else:
        stream.write(text)
        stream.flush()


def _report(what: str, stream: TextIO, text: str) -> None:
    """Report to those who listen which bytes a text becomes."""
    if events.heard():
        lines = text.replace("\n", os.linesep)
        events.report(what, "", lines.encode(stream.encoding, stream.errors or "strict"))


def _give(what: str, stream: TextIO, text: str) -> None:
    content = text.encode("utf-8", "surrogateescape")
    events.report(what, "", content)
    buffer = getattr(stream, "buffer", None)
    if buffer is None:
        stream.write(text)
        return
    stream.flush()
    buffer.write(content)
    buffer.flush()


def _out() -> TextIO:
    """Return standard output; OSError where the shell closed it: nothing is lost in silence."""
    if sys.stdout is None:
        raise OSError(errno.EBADF, os.strerror(errno.EBADF), "standard output")
    return sys.stdout
