"""What stands behind *where*: the names that a result mentions, each defined once."""

import math
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Literal

from ..base.frozen import frozen, replace
from ..base.named import NamedTuple
from ..formula.choices import is_looked_up
from ..formula.evaluate import equations
from ..formula.layout import decimal, has_minus, over_line, short_decimal
from ..formula.rewriting import in_reading_order
from ..formula.tree import (
    ZERO,
    Constant,
    Formula,
    Implicit,
    Number,
    Product,
    Sum,
    Symbol,
    negative,
    total,
)
from ..formula.walk import substitute, walk
from ..model.mechanism import GRAVITY, Force, Load, Mechanism, Parameter, Require
from ..model.result import Definition, Result
from ..model.values import is_constant, user_defined
from ..units import ANGLE, LENGTH, NUMBER, UNITS, si_unit
from . import book_forms
from .digits import VALUE_DIGITS


def looked_up(mechanism: Mechanism) -> Iterator[Parameter]:
    """Yield what choices, tables and lists give: people read these where they are given."""
    for parameter in mechanism.parameters:
        if parameter.dependent and any(map(is_looked_up, walk(parameter.value or ZERO))):
            yield parameter


def stated_above(mechanism: Mechanism) -> Iterator[Parameter]:
    """Yield the parameters that stand whole in what is given: nothing defines them again."""
    yield from filter(is_constant, mechanism.parameters)
    yield from looked_up(mechanism)


FREE_FALL = Symbol("g")
"""The letter of :data:`GRAVITY`; where a description has weights, no other quantity bears it."""


def takes_usual_g(load: Load) -> bool:
    """Return whether a load is a weight by the usual g, not by a parameter of that name."""
    match load:
        case Force(weight=True, tie=Product((Number(value), *_))):
            return value == GRAVITY.value
        case _:
            return False


def usual_weights(mechanism: Mechanism) -> frozenset[str]:
    """Return the names of the weights by the usual g."""
    return frozenset(load.name for load in mechanism.loads if takes_usual_g(load))


def by_letter(formula: Formula) -> Formula:
    """Return a weight by the usual g as ``m·g``.

    >>> from ..formula.tree import product
    >>> from ..formula.to_text import text
    >>> text(by_letter(product([(Symbol("m"), 1), (GRAVITY, 1)])))
    'm*g'
    """
    assert isinstance(formula, Product)
    return Product((*formula.factors[1:], FREE_FALL))


@frozen
class NameLetters:
    """What the names of a report stand for, as far as how they are written depends on it.

    ``usual`` are the weights by the usual g, ``units`` those of what is given by a number,
    ``positive`` the lengths that are never negative, ``choices`` those of a description as they
    are written, in their units, ``ranges`` the least and the greatest values of angles. ``alike``
    gives the first of lengths that have one number for the others.
    """

    usual: frozenset[str]
    units: Mapping[str, str]
    positive: frozenset[str]
    choices: Mapping[str, Formula]
    ranges: "book_forms.Ranges"
    alike: Mapping[str, Formula]


def letters(
    mechanism: Mechanism, results: Iterable[Result], others: Iterable[Definition] = ()
) -> NameLetters:
    """Return how definitions are to be written that stand with results, and ``others``."""
    found = list(results)
    units = constant_units(mechanism) | literal_units(found)
    where = (*others, *(d for r in found for d in r.where))
    positive = book_forms.positive_names(mechanism, where)
    choices, ranges = dict(_choices(mechanism)), book_forms.angle_ranges(mechanism)
    alike = dict(_alike(mechanism))
    return NameLetters(usual_weights(mechanism), units, positive, choices, ranges, alike)


def _alike(mechanism: Mechanism) -> Iterator[tuple[str, Formula]]:
    """Yield the lengths given by a number that an earlier one has, with the name of that."""
    first: dict[Formula, Formula] = {}
    for literal in mechanism.literals:
        if literal.value is not None and literal.dimension == LENGTH:
            own = Constant(literal.name, literal.value)
            if (known := first.setdefault(literal.value, own)) != own:
                yield literal.name, known


def _choices(mechanism: Mechanism) -> Iterator[tuple[str, Formula]]:
    for parameter in looked_up(mechanism):
        if parameter.written and not parameter.written.kind:
            yield parameter.name, parameter.written.formula


def as_written(where: Iterable[Definition], known: NameLetters) -> list[Definition]:
    """Return definitions as books write them.

    The usual weights as ``m·g``, constants in their units, triangles by the laws of sines and
    cosines.
    """
    return [_as_written(d, known) for d in where]


def _as_written(definition: Definition, known: NameLetters) -> Definition:
    """Return a definition as a book has it: a choice, a number in its unit, sides by angles."""
    name, formula = definition
    unit = UNITS.get(known.units.get(name, ""))
    if name in known.usual:
        return Definition(name, by_letter(formula))
    if name in known.choices:
        return Definition(name, known.choices[name])
    if unit is None or not isinstance(formula, Number):
        return Definition(name, over_line(_in_book_form(formula, known)))
    value = formula.value / unit.factor / Fraction(math.pi if unit.pi else 1)
    is_short = value.denominator < 10**VALUE_DIGITS
    shown = value if is_short else Fraction(f"{float(value):.{VALUE_DIGITS}g}")
    return Definition(name, _measure(shown))


def _in_book_form(formula: Formula, known: NameLetters) -> Formula:
    """Return a formula as books have it: where sides are equal by their numbers alone, by one name.

    What was put in for one of them, b + c - a = c, leaves no law of cosines otherwise.
    """
    book = book_forms.book_form(formula, known.positive, known.ranges)
    if book_forms.has_heron(book) and known.alike:
        one = substitute(formula, known.alike)
        other = book_forms.book_form(one, known.positive, known.ranges)
        return book if book_forms.has_heron(other) else other
    return book


def _measure(value: Fraction) -> Formula:
    """Return a number as it stands before its unit: 82.875 is no fraction there.

    >>> _measure(Fraction(663, 8)).name
    '82.875'
    """
    figures = None if value.denominator == 1 or short_decimal(value) else decimal(value)
    return Constant(figures, Number(value)) if figures else Number(value)


def given_loads(mechanism: Mechanism) -> Iterator[Parameter]:
    """Yield the loads that a formula of the user's own gives by a number, as quantities given."""
    loads = {load.name for load in mechanism.loads}
    for let in mechanism.lets:
        if let.name in loads and isinstance(let.value, Number):
            unit = let.unit or si_unit(let.dimension)
            yield Parameter(
                let.name, let.dimension, let.span, let.value, unit=unit, label=let.label
            )


def literal_unit(load: Load, given: Formula | None = None) -> str:
    """Return the unit of a load whose size, ``given`` or tied, is a number; else ''."""
    return si_unit(load.dimension) if isinstance(given or load.tie, Number) else ""


def constant_units(mechanism: Mechanism) -> dict[str, str]:
    """Return the loads and the named constants that are numbers, with their units."""
    given = user_defined(mechanism)
    units = {load.name: literal_unit(load, given.get(load.name)) for load in mechanism.loads}
    units |= {p.name: p.unit or "m" for p in mechanism.parameters if is_constant(p)}
    return {name: unit for name, unit in units.items() if unit}


def literal_units(results: Iterable[Result]) -> dict[str, str]:
    """Return the results that are numbers in some unit of the SI, with the unit; no angles."""
    numbers = (r for r in results if isinstance(r.formula, Number) and r.formula != ZERO)
    return {r.name: si_unit(r.dimension) for r in numbers if r.dimension not in (ANGLE, NUMBER)}


class SolvedSystem(NamedTuple):
    """A system of equations that defines names as its unknowns."""

    names: tuple[str, ...]
    """Its unknowns; one that a definition gives a name has that name."""

    zeros: tuple[Formula, ...]
    """The formulas that are zero in it, one for each equation."""


def without_minus(zero: Formula) -> tuple[Formula, Formula]:
    """Return the sides of the equation that something is zero, no term with a minus if possible.

    >>> from ..formula.to_text import text
    >>> a, b, c = map(Symbol, "abc")
    >>> tuple(map(text, without_minus(total([b, negative(a), c]))))
    ('a', 'b + c')
    """
    terms = zero.terms if isinstance(zero, Sum) else (zero,)
    right = [term for term in terms if not has_minus(term)]
    left = [negative(term) for term in terms if has_minus(term)]
    return total(left), total(right)


def grouped(where: Iterable[tuple[str, Formula]]) -> list[Definition | SolvedSystem]:
    """Return definitions in order, those that one system defines as one."""
    found: dict[object, list[tuple[str, Formula]]] = {}
    for name, formula in where:
        same = (formula.system, formula.arguments) if isinstance(formula, Implicit) else name
        found.setdefault(same, []).append((name, formula))
    return [_group(members) for members in found.values()]


def _group(members: list[tuple[str, Formula]]) -> Definition | SolvedSystem:
    name, formula = members[0]
    if not isinstance(formula, Implicit):
        return Definition(name, formula)
    unknowns = formula.system.unknowns
    names = {unknowns[f.index]: n for n, f in members if isinstance(f, Implicit)}
    renamed = {unknown: Symbol(n) for unknown, n in names.items()}
    zeros = tuple(whole(substitute(zero, renamed)) for zero in equations(formula))
    return SolvedSystem(tuple(names.get(unknown, unknown) for unknown in unknowns), zeros)


def whole(zero: Formula) -> Formula:
    """Return the expression that is zero where this is, without a factor that is a number.

    >>> from ..formula.to_text import text
    >>> from ..formula.tree import number, total
    >>> a, hundredth = Symbol("a"), Number(number(1).value / 100)
    >>> text(whole(Product((hundredth, total([a, number(-7)])))))
    'a - 7'
    """
    match zero:
        case Product((Number(), factor)):
            return factor
        case Product((Number(), *factors)):
            return Product(tuple(factors))
        case _:
            return zero


_OPPOSITE: Mapping[str, Literal["<", "<=", ">", ">="]] = {
    "<": ">",
    ">": "<",
    "<=": ">=",
    ">=": "<=",
}
"""The signs of conditions of which both sides are negative."""


def plus_condition(condition: Require) -> Require:
    """Return a condition turned round where what is compared with zero has a minus before it.

    Of a difference it is said that it is positive, not that another one is negative.
    """
    operator = condition.operator
    match condition.left:
        case Product() as left if has_minus(left):
            opposite = negative(left)
        case Sum(terms) if operator in ("<", "<=") and len(set(map(has_minus, terms))) > 1:
            opposite = total(in_reading_order(map(negative, terms)))
        case _:
            return condition
    if condition.right != ZERO:
        return condition
    return replace(condition, left=opposite, operator=_OPPOSITE.get(operator, operator))
