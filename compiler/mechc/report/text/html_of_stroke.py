"""The stroke as an HTML table, with what is said of it below."""

from html import escape

from ...study.stroke.stroke import Stroke
from .stroke import said, table, written


def to_html(stroke: Stroke) -> str:
    """Return the table that ``mechc stroke`` prints, and the lines below it.

    The last column says what is wrong in a row; there is none where nothing is.
    """
    shown = written(stroke, "en")
    cells = table(shown, {"slope", "velocity"})
    if not any(row[-1] for row in cells):
        cells = [row[:-1] for row in cells]
    head, *body = cells
    rows = [_row("th", head), *(_row("td", row) for row in body)]
    lines = "".join(f"<li>{escape(line)}</li>" for line in said(shown))
    return f"<table>{''.join(rows)}</table><ul>{lines}</ul>"


def _row(tag: str, cells: list[str]) -> str:
    return "<tr>{}</tr>".format("".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells))
