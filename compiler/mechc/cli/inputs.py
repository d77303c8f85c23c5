"""What commands that read a description have in common."""

import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, TypeVar

from .. import events
from ..diagnostics import MechcError
from ..diagnostics import files as files_messages
from ..files import SUFFIXES, find, read, read_stdin
from ..source import Source
from ..syntax.settings import Settings, parse
from ..syntax.vocabulary import METHODS
from . import usage
from .collisions import Claim, claim, refuse_reading, streams
from .usage import Word, descriptions

F = TypeVar("F", bound=Callable[..., Any])

NAMELESS = "<stdin>"
"""What messages call standard input where no name was given."""


def source_of(name: str, stdin_name: str) -> Source:
    """Return the text of a file, of a mechanism of the library, or of standard input."""
    refuse_reading(claim_of(name))
    return read_stdin(stdin_name) if name == "-" else read(find(name))


def claim_of(name: str) -> Claim:
    """Return the file that is read for a name, be it on standard input."""
    if name == "-":
        return next(streams(sys.stdin), Claim(None, "standard input"))
    return claim(find(name))


def path_of(name: str, stdin_name: str) -> Path | None:
    """Return the path that is read for a name; for standard input that of its given name."""
    if name == "-":
        return Path(stdin_name) if stdin_name != NAMELESS else None
    return find(name)


def expanded(names: Iterable[str]) -> Iterator[str]:
    """Yield names, and for a folder all descriptions below it.

    Raises :class:`MechcError` (E906) where it has none.
    """
    for name in names:
        if not Path(name).is_dir():
            yield name
        elif not (found := sorted(map(str, _below(Path(name))))):
            raise MechcError([files_messages.no_descriptions(name)])
        else:
            events.report("listed", name)
            yield from found


def _below(folder: Path) -> Iterator[Path]:
    """Yield the descriptions below a folder, but for what is hidden: ``.git``, ``.venv``."""
    for path in folder.rglob("*"):
        hidden = any(part.startswith(".") for part in path.relative_to(folder).parts)
        if path.suffix in SUFFIXES and not hidden and path.is_file():
            yield path


def _settings(given: tuple[str, ...]) -> Settings:
    """Return the values of ``-D NAME=VALUE``; refuse one that cannot be read, and one set twice."""
    for text in given:
        if "=" not in text:
            raise usage.BadParameter(f"{text!r} is not NAME=VALUE, as in -D alpha=30deg")
    names = [text.partition("=")[0].strip() for text in given]
    if twice := next((name for name in names if names.count(name) > 1), ""):
        raise usage.BadParameter(f"{twice!r} is set twice")
    try:
        return dict(map(parse, given))
    except MechcError as error:
        said = (f"{d.code}: {d.message}; {d.hint}" for d in error.diagnostics)
        raise usage.BadParameter("\n".join(said)) from None


description_argument = usage.argument("file", metavar="FILE|NAME|-", complete=descriptions)
by_option = usage.option(
    "--by",
    "method",
    kind=Word(METHODS),
    default=METHODS[0],
    show_default=True,
    help="How loads are derived: by virtual power, or by the equilibrium of free bodies.",
)
stdin_option = usage.option(
    "--stdin-filename",
    "stdin_name",
    metavar="NAME",
    default=NAMELESS,
    help="The name of standard input in messages; its suffix decides the notation.",
)
settings_option = usage.option(
    "-D",
    "--define",
    "settings",
    multiple=True,
    check=_settings,
    metavar="NAME=VALUE",
    help="Set a parameter: -D alpha=30deg. May be given several times.",
)
