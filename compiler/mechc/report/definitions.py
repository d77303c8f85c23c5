"""What stands behind *where*: the names that a result mentions, each told once."""

from collections.abc import Iterable, Set
from typing import NamedTuple

from ..formula.tree import ZERO, Formula, Implicit, Number, Product, Symbol
from ..formula.walk import equations, substitute
from ..model.mechanism import GRAVITY, Force, Load, Mechanism, Torque
from ..model.result import Definition, Result
from ..units import ANGLE, NUMBER, si_unit

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


def lettered(where: Iterable[Definition], usual: Set[str]) -> list[Definition]:
    """Return definitions with each of the usual weights as ``m·g``."""
    return [Definition(n, by_letter(f)) if n in usual else Definition(n, f) for n, f in where]


def literal_unit(load: Load, given: Formula | None = None) -> str:
    """Return the unit of a load whose size, ``given`` or tied, is a number; else ''."""
    if not isinstance(given or load.tie, Number):
        return ""
    return "N*m" if isinstance(load, Torque) else "N"


def literal_sizes(mechanism: Mechanism) -> dict[str, str]:
    """Return the loads whose size the description gives as a number, with its unit."""
    given = {let.name: let.value for let in mechanism.lets}
    units = {load.name: literal_unit(load, given.get(load.name)) for load in mechanism.loads}
    return {name: unit for name, unit in units.items() if unit}


def literal_units(results: Iterable[Result]) -> dict[str, str]:
    """Return the results that are numbers in some unit of the SI, with the unit; no angles."""
    numbers = (r for r in results if isinstance(r.formula, Number) and r.formula != ZERO)
    return {r.name: si_unit(r.dimension) for r in numbers if r.dimension not in (ANGLE, NUMBER)}


class Solved(NamedTuple):
    """The unknowns of one system, those defined by their defined names, and what is zero."""

    names: tuple[str, ...]
    zeros: tuple[Formula, ...]


def grouped(where: Iterable[tuple[str, Formula]]) -> list[Definition | Solved]:
    """Return definitions in order, those that one system defines as one."""
    found: dict[object, list[tuple[str, Formula]]] = {}
    for name, formula in where:
        same = (formula.system, formula.arguments) if isinstance(formula, Implicit) else name
        found.setdefault(same, []).append((name, formula))
    return [_group(members) for members in found.values()]


def _group(members: list[tuple[str, Formula]]) -> Definition | Solved:
    name, formula = members[0]
    if not isinstance(formula, Implicit):
        return Definition(name, formula)
    unknowns = formula.system.unknowns
    names = {unknowns[f.index]: n for n, f in members if isinstance(f, Implicit)}
    renamed = {unknown: Symbol(n) for unknown, n in names.items()}
    zeros = tuple(whole(substitute(zero, renamed)) for zero in equations(formula))
    return Solved(tuple(names.get(unknown, unknown) for unknown in unknowns), zeros)


def whole(zero: Formula) -> Formula:
    """Return what is zero where this is, without a number that only multiplies it.

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
