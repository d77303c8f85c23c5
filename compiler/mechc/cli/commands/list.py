"""``mechc list``: the mechanisms of the library."""

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache, partial
from pathlib import Path
from textwrap import wrap
from typing import Any
from zlib import crc32

from ...base.named import NamedTuple
from ...data_folders import data
from ...diagnostics import MechcError
from ...files import library, read
from ...syntax.vocabulary import LANGUAGES
from .. import opening, usage
from ..terminal import give, line_width, say
from ..usage import Word

NOTED = "titles.json"
"""The file in the library that ``python -m mechc.cli.make_gallery`` makes anew: reading all the
descriptions for their titles takes longer than any one of them to be compiled."""

SOURCE = 34
"""Longest source shown; ``--json`` has all of it."""

TITLE = 20
"""The narrowest column that titles are broken to."""


class ListedMechanism(NamedTuple):
    """A mechanism or a sheet; ``k`` is its first result."""

    name: str
    title: str
    source: str
    k: str


@usage.command("list", repeatable=True)
@usage.option("-l", "--long", is_flag=True, help="With source and k, wider than a terminal.")
@usage.option("--json", "as_json", is_flag=True, help="All of it, one object per line, uncut.")
@usage.option(
    "--lang", "language", kind=Word(LANGUAGES), default="en", show_default=True,
    help="The language of titles and sources.",
)  # fmt: skip
def command(long: bool, as_json: bool, language: str) -> None:
    """List the mechanisms and sheets of the library by name and title.

    \b
    mechc list
    mechc list --lang uk
    mechc list --long | grep tan
    mechc list --json | jq -r .name
    """
    found = _row if long or as_json else _titled
    rows = [_listed(partial(found, language=language), *each) for each in library().items()]
    if as_json:
        give("".join(f"{_json(row)}\n" for row in rows))
        return
    for line in table(rows, 4) if long else titles(rows, line_width()):
        say(line)


def _listed(
    found: Callable[[str, Path], ListedMechanism], name: str, path: Path
) -> ListedMechanism:
    """Return a row; of a description that is wrong, the code that says why."""
    try:
        return found(name, path)
    except MechcError as error:
        return ListedMechanism(name, "", "", f"({error.diagnostics[0].code})")


def _titled(name: str, path: Path, language: str) -> ListedMechanism:
    """Return a row with the title alone, the one that was noted if the text is still the same."""
    source = read(path)
    made_from, *noted = _noted().get(name, (0,))
    is_same = made_from == checksum(source.text) and len(noted) == len(LANGUAGES)
    in_each = noted if is_same else opening.titles(source)
    return ListedMechanism(name, in_each[LANGUAGES.index(language)], "", "")


@cache
def _noted() -> dict[str, Sequence[Any]]:
    """Return the titles of the library by name, each line beginning with its text's checksum."""
    file = data("library") / NOTED
    return json.loads(file.read_text("utf-8")) if file.is_file() else {}


def checksum(text: str) -> int:
    """Return the checksum of a text whose title is noted."""
    return crc32(text.encode())


def noted() -> str:
    """Return the titles of the library as the text of their file, a line for each."""
    sources = {name: read(path) for name, path in library().items()}
    lines = {n: [checksum(s.text), *opening.titles(s)] for n, s in sources.items()}
    shown = (
        f"{json.dumps(n)}: {json.dumps(line, ensure_ascii=False)}" for n, line in lines.items()
    )
    return "{\n" + ",\n".join(shown) + "\n}\n"


def _row(name: str, path: Path, language: str) -> ListedMechanism:
    return ListedMechanism(name, *opening.title_source_and_result(read(path), language))


def _json(row: ListedMechanism) -> str:
    return json.dumps(row._asdict(), ensure_ascii=False)


def table(rows: Iterable[ListedMechanism], columns: int) -> Iterator[str]:
    r"""Yield a heading and the rows in their first columns.

    >>> jack = ListedMechanism("jack", "Scissor jack", "a book", "k = tan(alpha)")
    >>> print(*table([jack], 4), sep="\n")
    NAME  TITLE         SOURCE  RESULT
    jack  Scissor jack  a book  k = tan(alpha)
    """
    short = (row._replace(source=_cut(row.source)) for row in rows)
    lines = [ListedMechanism("NAME", "TITLE", "SOURCE", "RESULT"), *short]
    widths = [max(len(row[i]) for row in lines) for i in range(columns)]
    for row in lines:
        cells = zip(row, widths, strict=False)
        yield "  ".join(cell.ljust(width) for cell, width in cells).rstrip()


def titles(rows: Sequence[ListedMechanism], width: int) -> Iterator[str]:
    r"""Yield a heading, names and titles, these in several lines where one is too wide.

    >>> print(*titles([ListedMechanism("jack", "Scissor jack of two tiers", "", "")], 26), sep="\n")
    NAME  TITLE
    jack  Scissor jack of two
          tiers
    """
    named = max((len(row.name) for row in rows), default=0)
    room = max(width - named - 2, TITLE)
    yield from table((line for row in rows for line in _lines(row, room)), 2)


def _lines(row: ListedMechanism, room: int) -> Iterator[ListedMechanism]:
    first, *more = wrap(row.title, room) or [row.k]
    yield row._replace(title=first)
    yield from (ListedMechanism("", line, "", "") for line in more)


def _cut(source: str) -> str:
    return source if len(source) <= SOURCE else source[: SOURCE - 1] + "…"
