"""A syntax tree as indented text; places in the source are left out."""

from collections.abc import Iterator, Mapping
from typing import Any

from ..frozen import Field, fields
from ..source import Span

WIDTH = 80


def pretty(value: object, indent: str = "") -> str:
    """Return a node as text, one field a line where it is long.

    >>> from mechc.syntax.ast import Name, Pivot
    >>> pretty(Pivot(point=Name("O", span=Span(6, 7)), span=Span(0, 7)))
    "Pivot(point=Name(text='O'))"
    """
    opening, parts, closing = _taken_apart(value)
    if not parts:
        return opening + closing
    deeper = indent + "  "
    shown = [name + pretty(part, deeper) for name, part in parts]
    line = opening + ", ".join(shown) + closing
    if len(indent) + len(line) <= WIDTH and "\n" not in line:
        return line
    body = "".join(f"\n{deeper}{part}," for part in shown)
    return f"{opening}{body}\n{indent}{closing}"


Parts = list[tuple[str, Any]]


def _taken_apart(value: Any) -> tuple[str, Parts, str]:
    """Return how a value opens, its parts with what stands before each, and how it closes."""
    if fields(value):
        parts = [(f"{f.name}=", getattr(value, f.name)) for f in _telling(value)]
        return f"{type(value).__name__}(", parts, ")"
    if isinstance(value, tuple) and hasattr(value, "_fields"):
        parts = [(f"{name}=", part) for name, part in zip(value._fields, value, strict=True)]
        return f"{type(value).__name__}(", parts, ")"
    if isinstance(value, Mapping):
        return "{", [(f"{key!r}: ", part) for key, part in value.items()], "}"
    if isinstance(value, list | tuple | set | frozenset):
        return "(", [("", part) for part in value], ")"
    return str(value) if hasattr(value, "value") else repr(value), [], ""


def _telling(value: Any) -> Iterator[Field]:
    """Yield the fields that are not at their default."""
    for item in fields(value):
        part = getattr(value, item.name)
        if not isinstance(part, Span) and part != item.default:
            yield item
