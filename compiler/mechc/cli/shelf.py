"""``mechc list``: the mechanisms of the library."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import click

from ..algebra.formula import text
from ..diagnostics import MechcError
from ..driver import Compilation
from ..files import library, read
from .session import Command

WIDTHS = {"title": 46, "source": 34}
"""Longest shown of a column on a terminal; ``--json`` has all of it."""


class Row(NamedTuple):
    """One mechanism; ``k`` is its first result."""

    name: str
    title: str
    source: str
    k: str


@click.command("list", cls=Command)
@click.option("--json", "as_json", is_flag=True, help="One JSON object per line, uncut.")
def command(as_json: bool) -> None:
    """List the mechanisms of the library: name, title, source and k.

    \b
    mechc list
    mechc list --json | jq -r .name
    """
    rows = [_row(name, path) for name, path in library().items()]
    for line in map(_json, rows) if as_json else table(rows):
        click.echo(line)


def _row(name: str, path: Path) -> Row:
    compilation = Compilation(read(path))
    try:
        mechanism, (first, *_) = compilation.mechanism, compilation.balance.results
    except MechcError as error:
        return Row(name, "", "", f"({error.diagnostics[0].code})")
    return Row(name, mechanism.title, mechanism.source, f"{first.name} = {text(first.formula)}")


def _json(row: Row) -> str:
    return json.dumps(row._asdict(), ensure_ascii=False)


def table(rows: list[Row]) -> Iterator[str]:
    r"""Yield a heading and the rows in columns.

    >>> print(*table([Row("jack", "Scissor jack", "a book", "k = tan(alpha)")]), sep="\n")
    NAME  TITLE         SOURCE  RESULT
    jack  Scissor jack  a book  k = tan(alpha)
    """
    lines = [Row("NAME", "TITLE", "SOURCE", "RESULT"), *map(_short, rows)]
    widths = [max(len(row[i]) for row in lines) for i in range(3)]
    for row in lines:
        columns = [cell.ljust(width) for cell, width in zip(row, widths, strict=False)]
        yield "  ".join([*columns, row.k]).rstrip()


def _short(row: Row) -> Row:
    cut = {name: _cut(getattr(row, name), width) for name, width in WIDTHS.items()}
    return row._replace(**cut)


def _cut(cell: str, width: int) -> str:
    return cell if len(cell) <= width else cell[: width - 1] + "…"
