"""What commands that read a description have in common."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click
from click.shell_completion import CompletionItem

from ..diagnostics import MechcError
from ..files import find, library, read, read_stdin
from ..source import Source
from ..syntax.settings import Settings, parse

F = TypeVar("F", bound=Callable[..., Any])


def source_of(name: str, stdin_name: str) -> Source:
    """Return the text of a file, of a mechanism of the library, or of standard input."""
    return read_stdin(stdin_name) if name == "-" else read(find(name))


def path_of(name: str) -> Path | None:
    """Return the path that is read for a name; None for standard input."""
    return None if name == "-" else find(name)


def _complete(ctx: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    names = [CompletionItem(name) for name in library() if name.startswith(begun)]
    return [*names, CompletionItem(begun, type="file")]


def _settings(ctx: click.Context, parameter: click.Parameter, given: tuple[str, ...]) -> Settings:
    for text in given:
        if "=" not in text:
            raise click.BadParameter(f"{text!r} is not NAME=VALUE, as in -D alpha=30deg")
    try:
        return dict(map(parse, given))
    except MechcError as error:
        raise click.BadParameter(str(error)) from None


description_argument = click.argument("file", metavar="FILE|NAME|-", shell_complete=_complete)
stdin_option = click.option(
    "--stdin-filename",
    "stdin_name",
    metavar="NAME",
    default="<stdin>",
    help="The name of standard input in messages; its suffix tells the notation.",
)
settings_option = click.option(
    "-D",
    "--define",
    "settings",
    multiple=True,
    callback=_settings,
    metavar="NAME=VALUE",
    help="Set a parameter: -D alpha=30deg. May be given several times.",
)
