"""Names of a used mechanism that becomes a part: its points get a number, its quantities a prefix.

Point O of the first part is ``O1``, of the second ``O2``; a point that is joined has the name
that it has in the whole. ``T.O`` is point O of the part T, wherever a point may stand.
"""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from typing import Any, TypeVar

from ...base.frozen import fields, replace
from ...base.later import pattern
from ...base.named import NamedTuple
from ...source import Span
from ...syntax import ast, moved
from ...syntax.vocabulary import GROUND, of_used, points_of
from ..names.forms import form_of

T = TypeVar("T")

QUANTITIES = frozenset({"name", "prefix", "table", "sizes", "used", "without", "given"})
"""The fields whose names are those of quantities; any other one names points, or a unit."""

WITH_POINTS = (ast.Pivot, ast.Slider, ast.Link, ast.Slide, ast.Telescope)
"""The lines that make points."""

_POINT = pattern(r"([A-Z][0-9]*)('*)")
_NUMBERED = pattern(r"[0-9]+$")


class Renaming(NamedTuple):
    """How names change: those of points, those of quantities, and a direction that is asked for."""

    points: Callable[[ast.Name], ast.Name]
    symbol: Callable[[ast.Symbol], ast.Expr]
    quantities: Mapping[str, str]


def renamed(node: T, names: Renaming, field: str = "") -> T:
    """Return a node of the tree with other names."""
    changed: Any = node
    match changed:
        case ast.Name(text, span) if field in QUANTITIES:
            changed = ast.Name(names.quantities.get(text, text), span)
        case ast.Name() if field not in moved.UNITS:
            changed = names.points(changed)
        case ast.Symbol():
            changed = names.symbol(changed)
        case tuple() if type(changed) is tuple:
            changed = tuple(renamed(part, names, field) for part in changed)
        case _ if not isinstance(changed, ast.Name | Span) and (own := fields(type(changed))):
            parts = {f.name: renamed(getattr(changed, f.name), names, f.name) for f in own}
            changed = replace(changed, **parts)
            if isinstance(node, ast.Drive) and len(points_of(node.name.text)) == 2:
                changed = replace(changed, name=names.points(node.name))
    return changed  # type: ignore[no-any-return]


def points_named(node: object, field: str = "") -> Iterator[ast.Name]:
    """Yield the names made of points in a part of the tree, but for those in formulas."""
    match node:
        case ast.Name():
            if field not in QUANTITIES | moved.UNITS and node.text != GROUND:
                yield node
        case tuple():
            for part in node:
                yield from points_named(part, field)
        case _:
            for f in fields(type(node)):
                yield from points_named(getattr(node, f.name), f.name)


def symbols_in(node: object) -> Iterator[ast.Symbol]:
    """Yield the names in the formulas of a part of the tree."""
    match node:
        case ast.Symbol():
            yield node
        case tuple():
            for part in node:
                yield from symbols_in(part)
        case _:
            for f in fields(type(node)):
                yield from symbols_in(getattr(node, f.name))


def declared_points(statements: Iterable[ast.Statement]) -> dict[str, Span]:
    """Return the points of bodies and of the ground, each with its place in the text.

    Any other line may speak of points of parts by the names that they have in the whole.
    """
    found: dict[str, Span] = {}
    for statement in statements:
        for name in points_named(statement) if isinstance(statement, WITH_POINTS) else ():
            for point in points_of(name.text):
                found.setdefault(point, name.span)
    return found


def numbered(
    points: Iterable[str], joined: Mapping[str, str], prefix: str, known: Collection[str]
) -> dict[str, str]:
    """Return the name of each point of a part in the whole.

    The number is that at the end of the prefix, else 1; the next one where that is not free.

    >>> numbered(["O", "B", "K'"], {"B": "A"}, "T", {"O", "A", "O1"})
    {'O': 'O2', 'B': 'A', "K'": "K2'"}
    """
    found = _NUMBERED.search(prefix)
    at = int(found[0]) if found else 1
    while True:
        names = {p: joined.get(p) or _POINT.sub(rf"\g<1>{at}\2", p) for p in points}
        if all(p in joined or name not in known for p, name in names.items()):
            return names
        at += 1


def of_a_part(
    points: Mapping[str, str], quantities: Mapping[str, str], seen: Callable[[ast.Expr], ast.Expr]
) -> Renaming:
    """Return how the names of a used mechanism change where it becomes a part.

    ``seen`` gives a direction of the whole as the part has it.
    """

    def word(name: ast.Name) -> ast.Name:
        parts = points_of(name.text)
        text = "".join(points.get(p, p) for p in parts)
        return ast.Name(text, name.span) if parts else name

    def symbol(known: ast.Symbol) -> ast.Expr:
        name, span = known.name, known.span
        if name in quantities:
            return ast.Symbol(quantities[name], span)
        if form := form_of(name):
            text = "".join(points.get(p, p) for p in form.points)
            axis = f"_{form.axis}" if form.axis else ""
            changed = ast.Symbol(f"{form.prefix}_{text}{axis}", span)
            return seen(changed) if form.prefix == "phi" else changed
        return known

    return Renaming(word, symbol, quantities)


FindName = Callable[[str, str, Span], str | None]
"""Gives a point of a part its name in the whole; an unknown one is reported, and None."""


def spelled_out(lookup: FindName) -> Renaming:
    """Return how ``T.O`` becomes the name that the point has in the whole."""

    def text(name: str, span: Span) -> str:
        prefix, points = of_used(name)
        form, _, part = prefix.rpartition("_") if prefix else ("", "", "")
        before = f"{form}_" if form_of(f"{form}_AB") or form_of(f"{form}_A") else ""
        points, low, axis = points.partition("_")
        found = [lookup(part if before else prefix, p, span) for p in points_of(points)]
        return before + "".join(p for p in found if p) + low + axis

    def word(name: ast.Name) -> ast.Name:
        return ast.Name(text(name.text, name.span), name.span) if "." in name.text else name

    def symbol(known: ast.Symbol) -> ast.Expr:
        if "." not in known.name:
            return known
        return ast.Symbol(text(known.name, known.span), known.span)

    return Renaming(word, symbol, {})
