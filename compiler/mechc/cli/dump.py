"""What a stage made of a description, as indented text: one printer for the values of all stages.

A value that fits on a line stands on one, ``Link(name=OAC, points=(O, A, C))``; a longer one
has a line for each of its parts, and so have several records. Fields at their default, empty
ones and places in the source are left out. Quantities are in SI and radians, formulas in the
notation of the language; directions that algebra has taken in are in degrees.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Set
from enum import Enum
from fractions import Fraction
from typing import Any

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..base.frozen import REQUIRED, fields
from ..base.later import pattern
from ..base.named import NamedTuple
from ..base.string_enum import Word
from ..emit.describe import dimension_name
from ..figure.figure import Plane
from ..formula.to_text import text
from ..formula.tree import Formula
from ..report.text.character_sets import ASCII
from ..report.text.printer import print_formula
from ..source import Span
from ..syntax import ast
from ..syntax.text import direction
from ..units import Dimension, si_unit

DUMP_COLUMNS = 100
"""Columns that a value on one line keeps to; a formula is never broken."""

INDENT = "  "

ROUNDED_COMPONENT = 1e-12
"""A component of a vector that is smaller, relative to the other one, is rounding of 0."""

EQUATIONS = {
    ("name", "formula"),
    ("name", "value"),
    ("left", "right"),
    ("left", "operator", "right"),
}
"""The fields of records that are equations or conditions, and are written as such."""

_BARE = pattern(r"[^\s,:=()\[\]{}'\"]([^,:=()\[\]{}\"\n]*[^\s,:=()\[\]{}\"])?")


class DumpedValue(NamedTuple):
    """A value as text: all of it on one line, and its parts, each with its name or key.

    ``kind`` is the name of a record's type, empty for a tuple or a mapping. What is never
    taken apart has no parts.
    """

    line: str
    kind: str = ""
    parts: tuple[tuple[str, "DumpedValue"], ...] = ()


FormulaNames = dict[tuple[str, str], str]
"""Where the values that took more than a line were printed, by their kinds and lines."""


def dump(stage: str, value: object, earlier: Mapping[str, object] | None = None) -> str:
    """Return the value of a stage as text, ending in a line feed.

    ``earlier`` are the values of the stages before, by name. What takes more than a line and
    was printed before, there or here, is named instead of printed once more.

    >>> from mechc.model.mechanism import Pivot
    >>> pins = (Pivot("O1", Span(6, 8)), Pivot("O2", Span(16, 18)))
    >>> print(dump("pose", {"pins": pins, "free": ("a", "b")}, {"model": {"pivots": pins}}), end="")
    pins: as in model.pivots
    free: (a, b)
    """
    names: FormulaNames = {}
    for name, whole in (earlier or {}).items():
        for way, key in _long(printed(whole), name):
            names.setdefault(key, way)
    return "\n".join(_whole(printed(value), stage, names)) + "\n"


# ------------------------------------------------------------------------- lines


def _whole(value: DumpedValue, stage: str, names: FormulaNames) -> Iterator[str]:
    """Yield the lines of a stage's value; what is no record has no heading."""
    if value.kind or not value.parts:
        return _lines("", value, "", stage, names)
    return _inside(value, "", stage, names)


def _lines(
    lead: str, value: DumpedValue, indent: str, way: str, names: FormulaNames
) -> Iterator[str]:
    """Yield the lines of a value: one where it fits, else a heading and those of its parts.

    One that was printed before is referred to by its ``way``, the names from the stage down to it.
    """
    if _is_short(value, len(indent + lead)):
        yield indent + lead + value.line
    elif before := names.get((value.kind, value.line)):
        yield f"{indent}{lead}as in {before}"
    else:
        names[value.kind, value.line] = way
        yield (indent + lead + value.kind).rstrip()
        yield from _inside(value, indent + INDENT, way, names)


def _inside(value: DumpedValue, indent: str, way: str, names: FormulaNames) -> Iterator[str]:
    for name, inner in _ways(value, way):
        yield from _lines(_lead(*inner), inner[1], indent, name, names)


def _ways(value: DumpedValue, way: str) -> Iterator[tuple[str, tuple[str, DumpedValue]]]:
    """Yield the parts of a value with the way to each: by its name, or by its number."""
    for i, (name, part) in enumerate(value.parts):
        own = next((p.line for key, p in part.parts if part.kind and key == "name"), str(i))
        yield f"{way}.{name or own}", (name, part)


def _lead(name: str, part: DumpedValue) -> str:
    """Return the prefix of a part that has a line of its own."""
    if name:
        return f"{name}: "
    return "- " if part.parts and not part.kind else ""


def _is_short(value: DumpedValue, before: int) -> bool:
    """Return whether a value stands on one line; several records have a line each."""
    several = not value.kind and len(value.parts) > 1
    records = several and all(part.kind and not name for name, part in value.parts)
    return not value.parts or (before + len(value.line) <= DUMP_COLUMNS and not records)


def _long(value: DumpedValue, way: str) -> Iterator[tuple[str, tuple[str, str]]]:
    """Yield the way to every value that has parts, and by what it is known again."""
    if value.parts:
        yield way, (value.kind, value.line)
    for name, (_, part) in _ways(value, way):
        yield from _long(part, name)


# ------------------------------------------------------------------------ values


def printed(value: object) -> DumpedValue:
    """Return a value as text.

    >>> printed({"O": (Fraction(1, 2), "slider K", "a, b")}).line
    "{O: (1/2, slider K, 'a, b')}"
    """
    plain = leaf(value)
    if plain is not None:
        return DumpedValue(plain)
    kind = type(value).__name__ if _declared(value) else ""
    if (said := _equation(value)) is not None:
        return DumpedValue(said, kind)
    parts = tuple((name, printed(part)) for name, part in _parts(value))
    sign = "=" if kind else ": "
    shown = ", ".join(f"{name}{sign if name else ''}{part.line}" for name, part in parts)
    line = f"{{{shown}}}" if isinstance(value, Mapping) else f"{kind}({shown})"
    return DumpedValue(line, kind, parts)


def nested(value: object) -> Any:
    """Return a value for JSON: records as objects with their kind, formulas as text.

    >>> from mechc.model.mechanism import Interval
    >>> from mechc.formula.tree import Symbol, number
    >>> nested((Interval(number(0), Symbol("a")), 2, {"O": math.inf}))
    [{'kind': 'Interval', 'low': '0', 'high': 'a'}, 2, {'O': 'inf'}]
    """
    if value is None or (
        isinstance(value, bool | int | str) and not isinstance(value, Enum | Word)
    ):
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else str(value)
    if (plain := leaf(value)) is not None and not isinstance(value, Plane):
        return plain
    if not isinstance(value, Mapping) and not _declared(value):
        return [nested(part) for _, part in _parts(value)]
    kind = {"kind": type(value).__name__} if _declared(value) else {}
    return {**kind, **{name: nested(part) for name, part in _parts(value)}}


def leaf(value: object) -> str | None:
    """Return the text of a value that is never taken apart; None for any other."""
    match value:
        case Enum() | Word():
            return str(value.value)
        case str():
            return value if _BARE.fullmatch(value) and value.isprintable() else repr(value)
        case float():
            return f"{value:.9g}"
        case None | bool() | int() | Fraction():
            return str(value).lower()
        case Dimension():
            unit = si_unit(value)
            return dimension_name(value) + (f" in {unit}" if unit else "")
        case Plane(x, y):
            least = ROUNDED_COMPONENT * max(abs(x), abs(y))
            return f"({x if abs(x) > least else 0:.9g}, {y if abs(y) > least else 0:.9g})"
        case _:
            return _mathematics(value)


def _mathematics(value: object) -> str | None:
    """Return a formula, of whichever stage, in the notation of the language."""
    match value:
        case Angle():
            return print_formula(value.formula(), ASCII, angle=True)
        case Product():
            return text(value.formula())
        case ast.Name():
            return value.text
        case _ if isinstance(value, ast.Direction):
            return direction(value)
        case _ if isinstance(value, Formula):
            return text(value)
        case _:
            return None


def _equation(value: object) -> str | None:
    """Return the text of a record that is an equation or a condition; None for any other.

    Its defaults are not written.
    """
    own = {n: getattr(value, n) for n, default in _declared(value).items() if default is REQUIRED}
    kept = {name: part for name, part in own.items() if part != "" and not isinstance(part, Span)}
    if tuple(kept) not in EQUATIONS:
        return None
    sign = kept.pop("operator", "=")
    left, right = map(leaf, kept.values())
    return None if left is None or right is None else f"{left} {sign} {right}"


def _parts(value: Any) -> Iterable[tuple[str, Any]]:
    """Return the named parts of a value: fields that are not empty or default, entries, items."""
    if isinstance(value, Mapping):
        return [(printed(key).line, entry) for key, entry in value.items()]
    if isinstance(value, Set):
        return [("", item) for item in sorted(value, key=lambda item: printed(item).line)]
    if declared := _declared(value):
        own = ((name, getattr(value, name), default) for name, default in declared.items())
        return [(n, part) for n, part, default in own if not (_is_empty(part) or part == default)]
    return [("", item) for item in value]


def _declared(value: Any) -> Mapping[str, Any]:
    """Return the fields of a record with their defaults; what is no record has none."""
    defaults = dict.fromkeys(getattr(value, "_fields", ()), REQUIRED)
    defaults |= getattr(value, "_field_defaults", {})
    return defaults | {f.name: f.default for f in fields(value)}


def _is_empty(part: object) -> bool:
    """Return whether a field says nothing: None, nothing inside, places in the source."""
    if isinstance(part, Mapping):
        return all(isinstance(entry, Span) for entry in part.values())
    return part is None or isinstance(part, Span) or part in ("", (), frozenset())
