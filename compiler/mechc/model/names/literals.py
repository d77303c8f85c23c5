"""Names for lengths that a description gives by numbers: ``AB = 250 mm``, ``pivot O at (1 m, 0)``.

After this every later stage sees a symbol, ``len_AB`` or ``x_O``, so that formulas keep their
dimensions. The symbol carries its number: forms show the name, and whatever is decided (does
this vanish, are these relations independent?) is decided by the number. Each has a name of its
own: of two links that are as long as each other a formula names the one that is meant.
"""

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from ...base.frozen import fields, replace
from ...base.named import NamedTuple
from ...formula.evaluate import evaluate
from ...formula.names import another
from ...formula.tree import (
    ZERO,
    Call,
    Constant,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    negative,
    number,
)
from ...formula.walk import substitute, symbols
from ...source import Span
from ...syntax import ast
from ...units import LENGTH, NUMBER, UNITS, Dimension, si_unit
from ..mechanism import (
    Arrow,
    Force,
    ForcePair,
    Geometry,
    Link,
    Load,
    Mechanism,
    Offset,
    Parameter,
)
from .scope import NamedNumber

COORDINATES = ("x", "y")
"""The kinds of lengths of which a line gives two."""

LengthKey = tuple[str, str, Formula]
"""A number of metres: the kind of length, whose it is, and the number."""


Measures = Mapping[str, Dimension]
"""What names measure; an angle, as a factor, is a pure number."""


class LengthNaming(NamedTuple):
    """What stands for numbers of metres, and what names measure."""

    known: Mapping[LengthKey, Formula]
    measures: Measures


LengthNames = Mapping[tuple[str, str], Formula]
"""The lengths of vectors, by their ends."""


class NamedLength(NamedTuple):
    """A length of the description under the name that it gets where it is a number."""

    kind: str
    of: str
    formula: Formula
    span: Span

    @property
    def name(self) -> str:
        """Return the name, as it is printed too."""
        return f"{self.kind}_{self.of}"

    @property
    def key(self) -> LengthKey:
        """Return the key by which it is one: a wheel of two pairs is one wheel."""
        return self.kind, self.of, self.formula


def with_names(mechanism: Mechanism, file: ast.File, named: Collection[NamedNumber]) -> Mechanism:
    """Return the mechanism with a named quantity for each length that is a number.

    ``named`` are the numbers that have names already, with their places.
    """
    found = [*_lengths(mechanism), *_coordinates(mechanism), *_of_joints(mechanism)]
    measures = {p.name: p.dimension.joined(NUMBER) for p in mechanism.parameters}
    literals = list({item.key: item for q in found for item in _numbers(q, measures)}.values())
    if not literals and not named:
        return mechanism
    taken, written = _names(mechanism) | {n.symbol.name for n in named}, tuple(_written(file))
    remarked = [statement for statement in file.statements if statement.remark]
    known: dict[LengthKey, Formula] = {}
    parameters = [_parameter(*one, written) for one in named]
    for literal in literals:
        symbol = Constant(_free(literal.name, taken), literal.formula)
        known[literal.key] = symbol
        quantity = _parameter(symbol, LENGTH, literal.span, written)
        parameters.append(replace(quantity, label=_label(literal, remarked)))
    return _put(replace(mechanism, literals=tuple(parameters)), LengthNaming(known, measures))


# ----------------------------------------------------------------------- what is a number


def _lengths(mechanism: Mechanism) -> Iterator[NamedLength]:
    made = _reaches(mechanism.loads).keys()
    for entry in mechanism.geometry:
        if (
            isinstance(entry, Arrow)
            and entry.length is not None
            and (entry.tail, entry.head) not in made
        ):
            yield NamedLength("len", f"{entry.tail}{entry.head}", entry.length, entry.span)


def _coordinates(mechanism: Mechanism) -> Iterator[NamedLength]:
    for entry in mechanism.geometry:
        if isinstance(entry, Offset):
            vector = _vector(entry.tail, entry.head)
            yield NamedLength("x", vector, entry.x, entry.span)
            yield NamedLength("y", vector, entry.y, entry.span)


def _vector(tail: str, head: str) -> str:
    """Return a vector's name; that of a place is its point's."""
    return f"{tail}{head}".replace("_", "")


def _of_joints(mechanism: Mechanism) -> Iterator[NamedLength]:
    for joint in mechanism.joints:
        yield from (NamedLength(*size, joint.span) for size in joint.sizes)


def _numbers(quantity: NamedLength, measures: Measures) -> Iterator[NamedLength]:
    """Yield a length that is a number, or those in it that are: ``2*(d + 15 mm)``."""
    if _is_number(quantity.formula):
        yield quantity
        return
    found = list[Formula]()

    def take(length: Formula) -> Formula:
        found.append(length)
        return length

    with_numbers(quantity.formula, take, measures)
    yield from (quantity._replace(of=f"{quantity.of}_0", formula=n) for n in found)


def with_numbers(length: Formula, put: Callable[[Formula], Formula], measures: Measures) -> Formula:
    """Return a length in which ``put`` stands for the numbers that are lengths themselves.

    It has them positive: of ``a - 20 mm`` the minus stands before what is put.
    Sums, ``hypot`` and the like are of lengths alone. Of a product the number is a length where
    all else is a pure number, and not where all else is a length by what its names measure.

    >>> a, names = Symbol("a"), {number(Fraction(1, 50)): Symbol("b")}
    >>> whole = Product((number(2), Sum((a, number(Fraction(1, 50))))))
    >>> found = with_numbers(whole, lambda n: names[n], {"a": LENGTH})
    >>> found == Product((number(2), Sum((a, Symbol("b")))))
    True
    """
    if _is_number(length):
        return negative(put(negative(length))) if _is_negative(length) else put(length)
    match length:
        case Sum(terms):
            return Sum(tuple(with_numbers(term, put, measures) for term in terms))
        case Call("hypot" | "min" | "max" | "abs" as function, arguments):
            return Call(function, tuple(with_numbers(each, put, measures) for each in arguments))
        case Product(factors):
            return Product(tuple(_factors_with_numbers(factors, put, measures)))
        case Call("sqrt", (Sum(terms),)):
            return Call("sqrt", (Sum(tuple(_square_with_number(term, put) for term in terms)),))
    return length


def _square_with_number(area: Formula, put: Callable[[Formula], Formula]) -> Formula:
    """Return a number that is the square of a length in its place; another area as it is.

    >>> _square_with_number(number(Fraction(1, 2500)), lambda n: Symbol("b"))
    Power(base=Symbol(name='b'), exponent=Number(value=Fraction(2, 1)))
    """
    match area:
        case Number(value) if value:
            size = abs(value)
            root = Fraction(math.isqrt(size.numerator), math.isqrt(size.denominator))
            square = Power(put(number(root)), number(2)) if root * root == size else area
            return negative(square) if value < 0 and square is not area else square
    return area


def _factors_with_numbers(
    factors: Sequence[Formula], put: Callable[[Formula], Formula], measures: Measures
) -> Iterator[Formula]:
    """Yield the factors of a length, what stands for a number in place of one that is a length."""
    others = _of_product(factors, measures)
    is_one = others == NUMBER and sum(map(_is_number, factors)) == 1
    for factor in factors:
        if _is_number(factor):
            yield with_numbers(factor, put, measures) if is_one else factor
        else:
            is_length = others == LENGTH == _measure(factor, measures)
            yield with_numbers(factor, put, measures) if is_length else factor


PURE = ("sin", "cos", "tan", "cot", "asin", "acos", "atan", "atan2", "exp", "log", "sign")
"""The functions whose value is a pure number, or an angle."""


def _measure(formula: Formula, measures: Measures) -> Dimension | None:
    """Return the dimension of a formula by those of its names; None where they do not say it."""
    match formula:
        case Symbol(name):
            return measures.get(name)
        case Sum(parts) | Call("hypot" | "min" | "max" | "abs", parts):
            found = {m for part in parts if (m := _measure(part, measures)) is not None}
            return found.pop() if len(found) == 1 else None
        case Product(factors):
            others = _of_product(factors, measures)
            return None if others == NUMBER and any(map(_is_number, factors)) else others
        case Power(base, Number(exponent)):
            of_base = _measure(base, measures)
            return None if of_base is None else of_base.scaled(exponent)
        case Call("sqrt", (base,)):
            return _measure(Power(base, Number(Fraction(1, 2))), measures)
        case Call(function) if function in PURE:
            return NUMBER
        case _:
            return None


def _of_product(factors: Sequence[Formula], measures: Measures) -> Dimension | None:
    """Return the dimension of the factors that are no numbers; None where one is unknown."""
    whole = NUMBER
    for factor in factors:
        if not _is_number(factor):
            own = _measure(factor, measures)
            if own is None:
                return None
            whole = whole.joined(own)
    return whole


def _is_number(formula: Formula) -> bool:
    return formula != ZERO and not symbols(formula)


def _is_negative(constant: Formula) -> bool:
    return evaluate(constant, {}) < 0


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


def _label(length: NamedLength, remarked: Iterable[ast.Statement]) -> str:
    """Return the comment behind the line that gives a length, '' of one that gives two."""
    if length.kind in COORDINATES:
        return ""
    lines = (s for s in remarked if s.span.start <= length.span.start < s.span.end)
    return next((line.remark for line in lines), "")


def _written(node: object) -> Iterator[ast.Number]:
    """Yield the numbers with a unit in a syntax tree."""
    if isinstance(node, ast.Number):
        if node.unit:
            yield node
        return
    parts = node if isinstance(node, tuple) else (getattr(node, f.name) for f in fields(node))
    for part in parts:
        yield from _written(part)


def _put(mechanism: Mechanism, names: LengthNaming) -> Mechanism:
    """Return the mechanism with numbers replaced by what stands for them."""
    lengths = {
        (e.tail, e.head): length
        for e in mechanism.geometry
        if isinstance(e, Arrow) and e.length is not None
        if (length := _named("len", f"{e.tail}{e.head}", e.length, names)) != e.length
    }
    loads = tuple(_load(load, lengths) for load in mechanism.loads)
    reach = {**lengths, **_reaches(loads)}
    return replace(
        mechanism,
        loads=loads,
        geometry=tuple(_entry(entry, names, reach) for entry in mechanism.geometry),
        joints=tuple(j.with_sizes([_named(*s, names) for s in j.sizes]) for j in mechanism.joints),
        links=tuple(_link(link, lengths) for link in mechanism.links),
    )


def _between(tail: str, head: str, lengths: LengthNames) -> Formula | None:
    """Return the named length that is given of a vector or of its opposite."""
    return lengths.get((tail, head), lengths.get((head, tail)))


def _link(link: Link, lengths: LengthNames) -> Link:
    if link.arc is None:
        return link
    centre, pin = link.points
    radius = _between(centre, pin, lengths) or link.arc.radius
    return replace(link, arc=replace(link.arc, radius=radius))


def _reaches(loads: Iterable[Load]) -> LengthNames:
    """Return how far along its stretch each spread load acts, by the vector to its point."""
    spread = [(k.point, k.spread) for k in loads if isinstance(k, Force) and k.spread]
    return {(found.tail, point): found.reach for point, found in spread}


def _load(load: Load, lengths: LengthNames) -> Load:
    """Return a load; one that is spread out over a length that is a number, by its name.

    So is a spring between points at a distance that is one.
    """
    if isinstance(load, ForcePair) and load.tie:
        length = _between(load.first, load.second, lengths)
        if length is None:
            return load
        apart = {f"len_{load.first}{load.second}": length}
        return replace(load, tie=substitute(load.tie, apart))
    if not isinstance(load, Force) or load.spread is None:
        return load
    length = _between(load.spread.tail, load.spread.head, lengths)
    spread = replace(load.spread, length=length or load.spread.length)
    return replace(load, spread=spread, tie=spread.resultant)


def _entry(entry: Geometry, names: LengthNaming, lengths: LengthNames) -> Geometry:
    match entry:
        case Arrow(tail, head) if (tail, head) in lengths:
            return replace(entry, length=lengths[tail, head])
        case Offset(tail, head, x, y):
            vector = _vector(tail, head)
            x, y = (_named(*each, names) for each in (("x", vector, x), ("y", vector, y)))
            return replace(entry, x=x, y=y)
        case _:
            return entry


def _named(kind: str, of: str, length: Formula, names: LengthNaming) -> Formula:
    """Return a length with names for the numbers that it is, or that are lengths in it."""
    if (kind, of, length) in names.known:
        return names.known[kind, of, length]

    def put(found: Formula) -> Formula:
        return names.known.get((kind, f"{of}_0", found), found)

    return length if _is_number(length) else with_numbers(length, put, names.measures)
