"""Nodes of the tree at another place, and with other names."""

from collections.abc import Callable
from typing import Any, TypeVar

from ..base.frozen import fields, replace
from ..source import Span
from . import ast

T = TypeVar("T")

UNITS = frozenset({"dimension", "unit"})
"""The fields whose names are those of dimensions and units, and of nothing that a file declares."""


def unchanged(name: str) -> str:
    """Return the same name."""
    return name


def moved(node: T, by: int, renamed: Callable[[str], str] = unchanged) -> T:
    """Return a node with every span so many characters farther on, and its names renamed.

    >>> moved(ast.Symbol("F", Span(3, 4)), 10, "pin_{}".format)
    Symbol(name='pin_F', span=Span(start=13, end=14))
    """
    changed: Any = node
    match changed:
        case Span():
            changed = changed.moved(by)
        case ast.Name(text, span):
            changed = ast.Name(renamed(text), span.moved(by))
        case ast.Symbol(name, span):
            changed = ast.Symbol(renamed(name), span.moved(by))
        case tuple() if type(changed) is tuple:
            changed = tuple(moved(part, by, renamed) for part in changed)
        case _ if own := fields(type(changed)):
            parts = {f.name: getattr(changed, f.name) for f in own}
            plain = {name: unchanged if name in UNITS else renamed for name in parts}
            changed = replace(
                changed, **{name: moved(part, by, plain[name]) for name, part in parts.items()}
            )
    return changed  # type: ignore[no-any-return]
