"""The stroke as an HTML table, with what is said of it below."""

from html import escape

from ...study.stroke.stroke import Stroke
from .stroke import said, table, written


def to_html(stroke: Stroke) -> str:
    """Return the table that ``mechc stroke`` prints, and the lines below it."""
    shown = written(stroke, "en")
    head, *body = table(shown, {"slope", "velocity"})
    rows = [_row("th", head), *(_row("td", cells) for cells in body)]
    lines = "".join(f"<li>{escape(line)}</li>" for line in said(shown))
    return f"<table>{''.join(rows)}</table><ul>{lines}</ul>"


def _row(tag: str, cells: list[str]) -> str:
    return "<tr>{}</tr>".format("".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells))
