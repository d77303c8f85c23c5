"""Diagnostics as text: in full, one line each, or JSON.

The full form quotes the line and puts a caret under the place::

    clamp.mech:7:12: error[E203]: `a` is a length where an angle is wanted
      7 | BK = @ alpha + a
        |                ^
      hint: …
"""

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Literal, assert_never
from unicodedata import combining, east_asian_width

from ..source import Source, Span
from .diagnostic import Diagnostic, Severity

if TYPE_CHECKING:
    import click
else:
    from ..base.later import Later

    click = Later("click")

MessageFormat = Literal["full", "concise", "json"]

LONGEST_EXCERPT = 72
"""Longest excerpt of a line, in characters; a longer line is cut around the caret."""

COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow"}

Paint = Callable[..., str]


def render(
    diagnostic: Diagnostic, source: Source | None, form: MessageFormat = "full", color: bool = False
) -> str:
    r"""Return the text of a diagnostic; ``source`` is None where no text was read.

    >>> from mechc.source import Source, Span
    >>> d = Diagnostic("W999", "example", Span(5, 7), "a link of no length", "give it one")
    >>> print(render(d, Source("x.mech", "link AB")))
    x.mech:1:6: warning[W999]: a link of no length
      1 | link AB
        |      ^^
      hint: give it one
    """
    match form:
        case "full":
            return _full(diagnostic, source, click.style if color else _plain)
        case "concise":
            return _headline(diagnostic, source, click.style if color else _plain)
        case "json":
            text = json.dumps(as_json(diagnostic, source), ensure_ascii=False)
            return text.encode("utf-8", "backslashreplace").decode()
        case _:
            assert_never(form)


def _plain(text: str, **_: object) -> str:
    return text


# ------------------------------------------------------------------------- as text


def _full(diagnostic: Diagnostic, source: Source | None, paint: Paint) -> str:
    """Return a message with the lines of the text that it is about, and its hint below."""
    colour = COLOURS[diagnostic.severity]
    lines = [_headline(diagnostic, source, paint)]
    if source and diagnostic.span:
        lines += _excerpt(source, diagnostic.span, paint, colour)
        for span, message in diagnostic.related:
            lines.append(f"  {_place(source, span)}: {_shown(message)}")
            lines += _excerpt(source, span, paint, "blue")
    if diagnostic.hint:
        first, *table = diagnostic.hint.split("\n")
        lines.append(f"  {paint('hint:', fg='cyan')} {_shown(first)}")
        lines += [f"        {_shown(row)}" for row in table]
    return "\n".join(lines)


def _headline(diagnostic: Diagnostic, source: Source | None, paint: Paint) -> str:
    kind = f"{diagnostic.severity}[{diagnostic.code}]"
    place = _place(source, diagnostic.span) + ": " if source else ""
    colour = COLOURS[diagnostic.severity]
    message = paint(_shown(diagnostic.message), bold=True)
    return f"{place}{paint(kind, fg=colour, bold=True)}: {message}"


def _place(source: Source, span: Span | None) -> str:
    if span is None:
        return _shown(source.name)
    part, (start, _) = source.part(span)
    line, column = part.position(start)
    return f"{_shown(part.name)}:{line}:{column}"


def _excerpt(source: Source, span: Span, paint: Paint, colour: str) -> list[str]:
    source, span = source.part(span)
    number, column = source.position(span.start)
    text, indent, width = cut(source.line(number), column - 1, column - 1 + span.end - span.start)
    gutter = f"{number:>3}"
    mark = paint("^" * width, fg=colour, bold=True)
    return [f"{gutter} | {text}", f"{' ' * len(gutter)} | {' ' * indent}{mark}"]


def cut(line: str, start: int, end: int) -> tuple[str, int, int]:
    r"""Return the visible part of a line, and the caret's indent and width in terminal cells.

    Tabs become four spaces, wide characters count as two cells, control characters are
    not passed on to the terminal, and a long line is cut around the caret.

    >>> cut("\tlink AB", 6, 8)
    ('    link AB', 9, 2)
    """
    low = max(0, min(start - LONGEST_EXCERPT // 2, len(line) - LONGEST_EXCERPT))
    high = low + LONGEST_EXCERPT
    before = ("…" if low else "") + _shown(line[low:start])
    marked = _shown(line[start : min(end, high)])
    after = _shown(line[max(start, min(end, high)) : high]) + ("…" if high < len(line) else "")
    return before + marked + after, _cells(before), max(_cells(marked), 1)


def _shown(text: str) -> str:
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in _untabbed(text))


def _untabbed(text: str) -> str:
    return text.replace("\t", "    ")


def _cells(text: str) -> int:
    return sum(0 if combining(c) else 1 + (east_asian_width(c) in "WF") for c in text)


# ------------------------------------------------------------------------- as JSON


def as_json(diagnostic: Diagnostic, source: Source | None) -> dict[str, object]:
    """Return the record that ``--format json`` prints; places are None where there are none."""
    return {
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": str(diagnostic.severity),
        "message": diagnostic.message,
        "help": diagnostic.hint,
        **_range(source, diagnostic.span),
        "related": [{"message": m, **_range(source, span)} for span, m in diagnostic.related],
    }


def _range(source: Source | None, span: Span | None) -> dict[str, object]:
    if source and span:
        source, span = source.part(span)
    start, end = (span.start, span.end) if span else (None, None)
    return {
        "file": source.name if source else None,
        "start": _position(source, start),
        "end": _position(source, end),
    }


def _position(source: Source | None, offset: int | None) -> dict[str, int] | None:
    return source.position(offset)._asdict() if source and offset is not None else None
