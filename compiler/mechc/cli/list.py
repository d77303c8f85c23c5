"""``mechc list``: the mechanisms of the library."""

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from zlib import crc32

from ..data import data
from ..diagnostics import MechcError
from ..files import library, read
from ..named import NamedTuple
from ..source import Source
from . import compiled, usage
from .terminal import give, say

TERMINAL = 80
"""Columns of a terminal, which names and titles share."""

NOTED = "titles.json"
"""The file in the library that ``python -m mechc.cli.make_titles`` makes anew: reading all the
descriptions for their titles takes longer than any one of them to be compiled."""

SOURCE = 34
"""Longest source shown; ``--json`` has all of it."""


class Row(NamedTuple):
    """A mechanism or a sheet; ``k`` is its first result."""

    name: str
    title: str
    source: str
    k: str


@usage.command("list", repeatable=True)
@usage.option("-l", "--long", is_flag=True, help="With source and k, wider than a terminal.")
@usage.option("--json", "as_json", is_flag=True, help="All of it, one object per line, uncut.")
def command(long: bool, as_json: bool) -> None:
    """List the mechanisms and sheets of the library by name and title.

    \b
    mechc list
    mechc list --long | grep tan
    mechc list --json | jq -r .name
    """
    found = _row if long or as_json else _titled
    rows = [found(name, path) for name, path in library().items()]
    if as_json:
        give("".join(f"{_json(row)}\n" for row in rows))
        return
    for line in table(rows, 4 if long else 2):
        say(line)


def _titled(name: str, path: Path) -> Row:
    """Return a row with the title alone, the one that was noted if the text is still the same."""
    source = read(path)
    made_from, title = _noted().get(name, (0, ""))
    return Row(name, title, "", "") if made_from == checksum(source.text) else titled(name, source)


def titled(name: str, source: Source) -> Row:
    """Return a row with the title that stands in a text."""
    try:
        return Row(name, compiled.title(source), "", "")
    except MechcError as error:
        return _failed(name, error)


@cache
def _noted() -> dict[str, tuple[int, str]]:
    """Return the titles of the library by name, each with the checksum of its text."""
    file = data("library") / NOTED
    return json.loads(file.read_text("utf-8")) if file.is_file() else {}


def checksum(text: str) -> int:
    """Return the checksum of a text whose title is noted."""
    return crc32(text.encode())


def noted() -> str:
    """Return the titles of the library as the text of their file, a line for each."""
    sources = {name: read(path) for name, path in library().items()}
    lines = {n: [checksum(s.text), titled(n, s).title] for n, s in sources.items()}
    shown = (
        f"{json.dumps(n)}: {json.dumps(line, ensure_ascii=False)}" for n, line in lines.items()
    )
    return "{\n" + ",\n".join(shown) + "\n}\n"


def _row(name: str, path: Path) -> Row:
    try:
        return Row(name, *compiled.title_source_and_result(read(path)))
    except MechcError as error:
        return _failed(name, error)


def _failed(name: str, error: MechcError) -> Row:
    return Row(name, "", "", f"({error.diagnostics[0].code})")


def _json(row: Row) -> str:
    return json.dumps(row._asdict(), ensure_ascii=False)


def table(rows: list[Row], columns: int) -> Iterator[str]:
    r"""Yield a heading and the rows in their first columns.

    >>> print(*table([Row("jack", "Scissor jack", "a book", "k = tan(alpha)")], 4), sep="\n")
    NAME  TITLE         SOURCE  RESULT
    jack  Scissor jack  a book  k = tan(alpha)
    """
    named = max((len(row.name) for row in rows), default=0)
    short = (_short(row, TERMINAL - named - 2) for row in rows)
    lines = [Row("NAME", "TITLE", "SOURCE", "RESULT"), *short]
    widths = [max(len(row[i]) for row in lines) for i in range(columns)]
    for row in lines:
        cells = zip(row, widths, strict=False)
        yield "  ".join(cell.ljust(width) for cell, width in cells).rstrip()


def _short(row: Row, title: int) -> Row:
    return row._replace(title=_cut(row.title, title), source=_cut(row.source, SOURCE))


def _cut(cell: str, width: int) -> str:
    return cell if len(cell) <= width else cell[: width - 1] + "…"
