"""``mechc list``: the mechanisms of the library."""

import json
from collections.abc import Iterator
from pathlib import Path

from ..diagnostics import MechcError
from ..driver import Compilation
from ..files import library, read
from ..formula.to_text import text
from ..model.statements import only
from ..named import NamedTuple
from ..syntax.ast import Heading
from . import usage
from .terminal import give, say

TERMINAL = 80
"""Columns of a terminal, which names and titles share."""

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
    """Return a row with the title alone, for which nothing has to be solved."""
    try:
        heading = only(Compilation(read(path)).tree, Heading)
    except MechcError as error:
        return _failed(name, error)
    return Row(name, heading.title if heading else "", "", "")


def _row(name: str, path: Path) -> Row:
    compilation = Compilation(read(path))
    try:
        mechanism, (first, *_) = compilation.mechanism, compilation.found
    except MechcError as error:
        return _failed(name, error)
    return Row(name, mechanism.title, mechanism.source, f"{first.name} = {text(first.formula)}")


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
