"""Angles that are only turned by, carried as their cosine and sine.

A loop that closes gives a direction as ``atan2(y, x)`` plus others, and k then takes its
sine: three functions where a root does. ``cos = x/r``, ``sin = y/r`` and the rules for
sums of angles give the same; the formula for the reader stays in angles.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from ..algebra.angle import Angle
from ..algebra.from_formula import to_angle
from ..algebra.trigonometry import cosine, sine
from ..formula.tree import (
    ONE,
    Call,
    Formula,
    Number,
    Product,
    Sum,
    Symbol,
    negative,
    product,
    total,
)
from ..formula.walk import children, rebuild, symbols

Definitions = Sequence[tuple[str, Formula]]

FEW = (-2, -1, 1, 2)
"""Multiples of an angle that are written out."""


class Unit(NamedTuple):
    """The cosine and the sine of an angle."""

    cos: Formula
    sin: Formula

    def turned(self, by: "Unit") -> "Unit":
        """Return the unit vector of a sum of two angles."""
        return Unit(
            total([_times(self.cos, by.cos), negative(_times(self.sin, by.sin))]),
            total([_times(self.sin, by.cos), _times(self.cos, by.sin)]),
        )

    def back(self) -> "Unit":
        """Return the unit vector of the opposite angle."""
        return Unit(self.cos, negative(self.sin))


WANTED: Mapping[str, Callable[[Unit], Formula]] = {
    "sin": lambda u: u.sin,
    "cos": lambda u: u.cos,
    "tan": lambda u: _over(u.sin, u.cos),
    "cot": lambda u: _over(u.cos, u.sin),
    "sec": lambda u: _over(ONE, u.cos),
    "csc": lambda u: _over(ONE, u.sin),
}
"""Each function of an angle, from its unit vector."""


class Known(NamedTuple):
    """What is known of the names so far.

    ``units`` are carried angles, ``sums`` those that are sums of carried ones, ``sizes``
    the names of the hypotenuses that were asked for anyway.
    """

    units: dict[str, Unit]
    sums: dict[str, Angle]
    sizes: dict[frozenset[Formula], str]


def in_unit_vectors(
    definitions: Definitions, formulas: Sequence[Formula], kept: Iterable[str], taken: set[str]
) -> tuple[list[tuple[str, Formula]], list[Formula]]:
    """Return definitions and formulas with polar angles carried as unit vectors.

    ``kept`` are names that must stay defined, ``taken`` those that a new one may not have.
    """
    known = Known({}, {}, {})
    written: list[tuple[str, Formula]] = []
    for name, formula in definitions:
        written.append((name, _rewritten(formula, known)))
        angle = to_angle(formula)
        if isinstance(formula, Call) and formula.function == "hypot":
            known.sizes[frozenset(map(_unsigned, formula.arguments))] = name
        elif angle is not None and any(n in known.units for n in angle.names):
            known.sums[name] = angle.put(known.sums)
        elif unit := _polar(formula, known):
            cos, sin = (_fresh(f"{f}_{name}", taken) for f in ("cos", "sin"))
            rewritten = [_rewritten(part, known) for part in unit]
            written += zip((cos, sin), rewritten, strict=True)
            known.units[name] = Unit(Symbol(cos), Symbol(sin))
    results = [_rewritten(f, known) for f in formulas]
    return _reached(written, results, kept), results


def _reached(
    definitions: Definitions, results: Iterable[Formula], kept: Iterable[str]
) -> list[tuple[str, Formula]]:
    """Return the definitions that something needs."""
    used = {*kept, *(name for f in results for name in symbols(f))}
    found: list[tuple[str, Formula]] = []
    for name, formula in reversed(definitions):
        if name in used:
            found.append((name, formula))
            used |= symbols(formula)
    return found[::-1]


def _fresh(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    taken.add(name)
    return name


def _polar(formula: Formula, known: Known) -> Unit | None:
    """Return the unit vector of an angle made of arc tangents, known units and plain angles."""
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    plain: list[Formula] = []
    found: list[Unit] = []
    for term in terms:
        sign, inner = _signed(term)
        if isinstance(inner, Call) and inner.function == "atan2":
            y, x = inner.arguments
            unit = _of_components(y, x, known)
        elif isinstance(inner, Symbol) and inner.name in known.units:
            unit = known.units[inner.name]
        else:
            plain.append(term)
            continue
        found.append(unit if sign > 0 else unit.back())
    if not found:
        return None
    if plain:
        angle = to_angle(total(plain))
        if angle is None:
            return None
        found.append(_plain(angle))
    whole = found[0]
    for unit in found[1:]:
        whole = whole.turned(unit)
    return whole


def _signed(term: Formula) -> tuple[int, Formula]:
    match term:
        case Product((Number(value), *rest)) if value == -1:
            return -1, rest[0] if len(rest) == 1 else Product(tuple(rest))
        case _:
            return 1, term


def _unsigned(term: Formula) -> Formula:
    return _signed(term)[1]


def _of_components(y: Formula, x: Formula, known: Known) -> Unit:
    squares = total([_times(x, x), _times(y, y)])
    name = known.sizes.get(frozenset((_unsigned(x), _unsigned(y))))
    size = Symbol(name) if name else Call("sqrt", (squares,))
    return Unit(_over(x, size), _over(y, size))


def _plain(angle: Angle) -> Unit:
    """Return the unit vector of an angle that is not carried; of a negative one, turned back."""
    if all(c < 0 for _, c in angle.terms):
        return _plain(-angle).back() if angle.terms else _constant(angle)
    return Unit(Call("cos", (angle.formula(),)), Call("sin", (angle.formula(),)))


def _constant(angle: Angle) -> Unit:
    return Unit(cosine(angle).formula(), sine(angle).formula())


def _rewritten(formula: Formula, known: Known) -> Formula:
    """Return a formula with functions of carried angles written by their unit vectors."""
    if isinstance(formula, Call) and formula.function in WANTED:
        angle = to_angle(formula.arguments[0])
        if angle is not None and (unit := _turned(angle.put(known.sums), known.units)):
            return WANTED[formula.function](unit)
    parts = children(formula)
    if not parts:
        return formula
    return rebuild(formula, tuple(_rewritten(p, known) for p in parts))


def _turned(angle: Angle, units: Mapping[str, Unit]) -> Unit | None:
    """Return the unit vector of an angle that mentions carried ones; None for others."""
    carried = [(units[n], c) for n, c in angle.terms if n in units]
    if not carried or any(c not in FEW for _, c in carried):
        return None
    rest = Angle(tuple((n, c) for n, c in angle.terms if n not in units), angle.degrees)
    turns = [u for unit, c in carried for u in _repeated(unit, int(c))]
    if rest.terms or rest.degrees:
        turns.append(_plain(rest))
    whole = turns[0]
    for unit in turns[1:]:
        whole = whole.turned(unit)
    return whole


def _repeated(unit: Unit, times: int) -> list[Unit]:
    return [unit if times > 0 else unit.back()] * abs(times)


def _times(a: Formula, b: Formula) -> Formula:
    return product([(a, 1), (b, 1)])


def _over(a: Formula, b: Formula) -> Formula:
    return product([(a, 1), (b, -1)])
