"""What may stand on a command line: proposed while it is typed, and where it is mistyped."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

import click
from click.shell_completion import CompletionItem

from ..diagnostics import near_miss
from ..files import library

if TYPE_CHECKING:
    Choice = click.Choice[str]
else:
    Choice = click.Choice  # not generic before click 8.2


class Word(Choice):
    """One of a few words; the nearest one is proposed for a word that is none of them."""

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return the word."""
        try:
            return super().convert(value, param, ctx)
        except click.BadParameter as error:
            hint = near_miss(value, map(str, self.choices))
            raise click.BadParameter(f"{error.message.rstrip('.')}{hint and f'; {hint}'}") from None


def beginning(begun: str, words: Iterable[str]) -> list[CompletionItem]:
    """Return the words that begin so, as completions."""
    return [CompletionItem(word) for word in words if word.startswith(begun)]


def descriptions(
    ctx: click.Context, parameter: click.Parameter, begun: str
) -> list[CompletionItem]:
    """Return the mechanisms of the library, and the shell's own files, as completions."""
    return [*beginning(begun, library()), *paths(ctx, parameter, begun)]


def paths(ctx: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    """Return the request for the shell's own completion of files."""
    return [CompletionItem(begun, type="file")]
