"""Names for lengths that a description gives by numbers: ``AB = 250 mm``, ``pivot O at (1 m, 0)``.

After this every later stage sees a symbol, ``len_AB`` or ``x_O``, so that formulas keep their
dimensions. The symbol carries its number: forms show the name, and whatever is decided (does
this vanish, are these relations independent?) is decided by the number. Numbers of one kind and
size are one quantity under one name, so that a parallelogram stays one.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, assert_never

from ..formula.names import another
from ..formula.tree import ZERO, Constant, Formula, Sum, negative, number
from ..formula.walk import evaluate, substitute, symbols
from ..frozen import fields, replace
from ..source import Span
from ..syntax import ast
from ..units import LENGTH, UNITS, Dimension, si_unit
from .entries import vector_between
from .mechanism import (
    Arrow,
    Contact,
    Force,
    ForcePair,
    Geometry,
    Joint,
    Link,
    Load,
    Mechanism,
    Offset,
    Parameter,
    Pivot,
    Rack,
    Screw,
    Slider,
    Slot,
    WheelPair,
)
from .scope import Named

Known = Mapping[tuple[str, Formula], Formula]
"""What stands for a number of metres, by the kind of length and the number."""


Reaches = Mapping[tuple[str, str], Formula]
"""The lengths of vectors, by their ends."""


class Quantity(NamedTuple):
    """A length of the description under the name that it gets where it is a number.

    Of its ``kind`` are those that it is compared with: links with links, x with x.
    """

    kind: str
    of: str
    formula: Formula
    span: Span

    @property
    def name(self) -> str:
        """Return the name, as it is printed too."""
        return f"{self.kind}_{self.of}"


def with_names(mechanism: Mechanism, file: ast.File, named: Collection[Named]) -> Mechanism:
    """Return the mechanism with a named quantity for each length that is a number.

    ``named`` are the numbers that have names already, with their places.
    """
    found = [*_lengths(mechanism), *_coordinates(mechanism), *_of_joints(mechanism)]
    literals = list(_one_for_each_size(item for q in found for item in _numbers(q)))
    if not literals and not named:
        return mechanism
    taken, written = _names(mechanism) | {n.symbol.name for n in named}, tuple(_written(file))
    known: dict[tuple[str, Formula], Formula] = {}
    parameters = [_parameter(*one, written) for one in named]
    for literal in literals:
        symbol = Constant(_free(literal.name, taken), literal.formula)
        known[literal.kind, literal.formula] = symbol
        known[literal.kind, negative(literal.formula)] = negative(symbol)
        parameters.append(_parameter(symbol, LENGTH, literal.span, written))
    return _put(replace(mechanism, literals=tuple(parameters)), known)


# ----------------------------------------------------------------------- what is a number


def _lengths(mechanism: Mechanism) -> Iterator[Quantity]:
    made = _reaches(mechanism.loads).keys()
    for entry in mechanism.geometry:
        if (
            isinstance(entry, Arrow)
            and entry.length is not None
            and (entry.tail, entry.head) not in made
        ):
            yield Quantity("len", f"{entry.tail}{entry.head}", entry.length, entry.span)


def _coordinates(mechanism: Mechanism) -> Iterator[Quantity]:
    for entry in mechanism.geometry:
        if isinstance(entry, Offset):
            vector = f"{entry.tail}{entry.head}".replace("_", "")
            yield Quantity("x", vector, entry.x, entry.span)
            yield Quantity("y", vector, entry.y, entry.span)


def _of_joints(mechanism: Mechanism) -> Iterator[Quantity]:
    for joint in mechanism.joints:
        match joint:
            case WheelPair(first=first, second=second, span=span):
                yield Quantity("r", first, joint.first_radius, span)
                yield Quantity("r", second, joint.second_radius, span)
            case Rack(pivot=pivot, radius=radius, span=span):
                yield Quantity("r", pivot, radius, span)
            case Screw(point, pitch, span=span):
                yield Quantity("p", point, pitch, span)
            case Pivot() | Slider() | Slot() | Contact():
                pass
            case _:
                assert_never(joint)


def _numbers(quantity: Quantity) -> Iterator[Quantity]:
    """Yield a length that is a number, or those that are terms of it: ``d + 15 mm``."""
    formula = quantity.formula
    if _is_number(formula):
        yield quantity
    elif isinstance(formula, Sum):
        numbers = [term for term in formula.terms if _is_number(term)]
        yield from (quantity._replace(of=f"{quantity.of}_0", formula=n) for n in numbers)


def _is_number(formula: Formula) -> bool:
    return formula != ZERO and not symbols(formula)


def _one_for_each_size(literals: Iterable[Quantity]) -> Iterator[Quantity]:
    """Yield one literal for all of its kind and size, a positive one where there is one."""
    found: dict[tuple[str, Formula], Quantity] = {}
    for literal in literals:
        size = evaluate(literal.formula, {})
        key = literal.kind, literal.formula if size > 0 else negative(literal.formula)
        known = found.setdefault(key, literal)
        if size > 0 and known.formula != literal.formula:
            found[key] = literal
    yield from found.values()


# ------------------------------------------------------------------------- what it becomes


def _names(mechanism: Mechanism) -> set[str]:
    """Return the names that the description uses."""
    parts = (mechanism.parameters, mechanism.loads, mechanism.finds, mechanism.lets)
    return {part.name for group in parts for part in group}


def _free(name: str, taken: set[str]) -> str:
    """Return a name like this one that is not taken, and take it."""
    while name in taken:
        name = another(name)
    taken.add(name)
    return name


def _parameter(
    symbol: Constant, dimension: Dimension, place: Span, written: Sequence[ast.Number]
) -> Parameter:
    """Return a number as a quantity, with the unit that it was written in."""
    fitting = [n for n in written if UNITS[n.unit].dimension == dimension]
    inside = (n for n in fitting if place.start <= n.span.start and n.span.end <= place.end)
    units = {n.unit: number(n.value * UNITS[n.unit].factor) for n in inside}
    exact = (unit for unit, value in units.items() if symbol.value in (value, negative(value)))
    anywhere = next((n.unit for n in fitting), si_unit(dimension))
    unit = next(exact, next(iter(units), anywhere))
    return Parameter(symbol.name, dimension, place, symbol.value, unit=unit)


def _written(node: object) -> Iterator[ast.Number]:
    """Yield the numbers with a unit in a syntax tree."""
    if isinstance(node, ast.Number):
        if node.unit:
            yield node
        return
    parts = node if isinstance(node, tuple) else (getattr(node, f.name) for f in fields(node))
    for part in parts:
        yield from _written(part)


def _put(mechanism: Mechanism, known: Known) -> Mechanism:
    """Return the mechanism with numbers replaced by what stands for them."""
    loads = tuple(_load(load, known, mechanism.geometry) for load in mechanism.loads)
    reach = _reaches(loads)
    return replace(
        mechanism,
        loads=loads,
        geometry=tuple(_entry(entry, known, reach) for entry in mechanism.geometry),
        joints=tuple(_joint(joint, known) for joint in mechanism.joints),
        links=tuple(_link(link, known) for link in mechanism.links),
    )


def _link(link: Link, known: Known) -> Link:
    if link.arc is None:
        return link
    return replace(link, arc=replace(link.arc, radius=_named("len", link.arc.radius, known)))


def _joint(joint: Joint, known: Known) -> Joint:
    match joint:
        case WheelPair():
            first, second = (
                _named("r", r, known) for r in (joint.first_radius, joint.second_radius)
            )
            return replace(joint, first_radius=first, second_radius=second)
        case Rack():
            return replace(joint, radius=_named("r", joint.radius, known))
        case Screw():
            return replace(joint, pitch=_named("p", joint.pitch, known))
        case Pivot() | Slider() | Slot() | Contact():
            return joint
        case _:
            assert_never(joint)


def _reaches(loads: Iterable[Load]) -> Reaches:
    """Return how far along its stretch each spread load acts, by the vector to its point."""
    spread = [(k.point, k.spread) for k in loads if isinstance(k, Force) and k.spread]
    return {(found.tail, point): found.reach for point, found in spread}


def _load(load: Load, known: Known, geometry: Sequence[Geometry]) -> Load:
    """Return a load; one that is spread out over a length that is a number, by its name.

    So is a spring between points at a distance that is one.
    """
    if isinstance(load, ForcePair) and load.tie:
        entry = vector_between((load.first, load.second), geometry)
        length = entry.length if isinstance(entry, Arrow) else None
        if length is None or ("len", length) not in known:
            return load
        apart = {f"len_{load.first}{load.second}": known["len", length]}
        return replace(load, tie=substitute(load.tie, apart))
    if not isinstance(load, Force) or load.spread is None:
        return load
    spread = replace(load.spread, length=_named("len", load.spread.length, known))
    return replace(load, spread=spread, tie=spread.resultant)


def _entry(entry: Geometry, known: Known, reach: Reaches) -> Geometry:
    match entry:
        case Arrow(tail, head) if (tail, head) in reach:
            return replace(entry, length=reach[tail, head])
        case Arrow(length=length) if length is not None:
            return replace(entry, length=_named("len", length, known))
        case Offset(x=x, y=y):
            return replace(entry, x=_named("x", x, known), y=_named("y", y, known))
        case _:
            return entry


def _named(kind: str, length: Formula, known: Known) -> Formula:
    """Return a length with names for the numbers that it is, or that are terms of it."""
    if isinstance(length, Sum) and (kind, length) not in known:
        return Sum(tuple(known.get((kind, term), term) for term in length.terms))
    return known.get((kind, length), length)
