"""Signs that make no sense: conditions that hold as a rod is in compression, negative sizes."""

import re
from collections.abc import Iterable, Iterator

from ..diagnostics import Diagnostic
from ..diagnostics import sheets as messages
from ..formula.to_text import text
from ..formula.tree import Call, Formula
from ..formula.walk import symbols, walk
from ..model.mechanism import Let, Mechanism
from ..model.parts.written import WrittenSides
from ..model.values import Values, user_defined
from ..units import FORCE, LENGTH, MASS, PRESSURE, TORQUE, in_unit, si_unit
from .calculation import Check

_SIGNED = (FORCE, PRESSURE, TORQUE)


def doubtful(mechanism: Mechanism, checks: Iterable[Check]) -> Iterator[Diagnostic]:
    """Yield a warning on each upper bound that a negative force of a mechanism cannot reach (W265).

    Where the same is bounded from below, too, both signs were thought of.
    """
    checks = [c for c in checks if not c.condition.subject and c.condition.dimension in _SIGNED]
    bounded = [_sides(check)[1][0] for check in checks if check.condition.operator in _ORDERS]
    for check in checks:
        if check.condition.operator not in _ORDERS:
            continue
        (small, value), (_, limit) = _sides(check)
        if value is None or limit is None or not value < 0 < limit or small in bounded:
            continue
        if force := _force(small, mechanism):
            yield _doubt(check, value, force)


_ORDERS = ("<", "<=", ">", ">=")

_Side = tuple[Formula, float | None]


def _sides(check: Check) -> tuple[_Side, _Side]:
    """Return the side that is to be the smaller one, then the larger one."""
    left = check.condition.left, check.left
    right = check.condition.right, check.right
    return (left, right) if check.condition.operator in ("<", "<=") else (right, left)


def _force(formula: Formula, mechanism: Mechanism) -> str:
    """Return the force of a used mechanism that a formula rests on, '' where it rests on none."""
    forces = {t.name for t in mechanism.taken if t.dimension in _SIGNED}
    lets = user_defined(mechanism)
    waiting, seen = sorted(symbols(formula)), set[str]()
    while waiting:
        name = waiting.pop()
        if name in forces:
            return name
        if name in lets and name not in seen:
            waiting.extend(sorted(symbols(lets[name])))
        seen.add(name)
    return ""


def _doubt(check: Check, value: float, force: str) -> Diagnostic:
    condition = check.condition
    unit = condition.unit or si_unit(condition.dimension)
    is_left = condition.operator in ("<", "<=")
    written = condition.written or WrittenSides(condition.left, condition.right)
    side = written.left if is_left else written.right
    return messages.bound_on_a_negative(condition.span, text(side), in_unit(value, unit, 6), force)


# ----------------------------------------------------------------------- negative sizes

_SIZES = (LENGTH, LENGTH.scaled(2), MASS)

_COORDINATE = re.compile(r"[dD]?[xyz](\d*|_.*)")
"""The names of what has a sign by custom: coordinates, and how far they move."""


def negative_sizes(mechanism: Mechanism, values: Values, own: int) -> Iterator[Diagnostic]:
    """Yield a warning on each length, area or mass below zero that the first ``own`` signs give.

    None of coordinates and projections, of what is made of a length with a sign, and where a
    condition names it: there signs were thought of. Neither of what follows from one that is said.
    """
    bounded = frozenset[str]().union(*(symbols(r.left, r.right) for r in mechanism.requires))
    lets, said = {let.name: let for let in mechanism.lets}, set[str]()
    for let in mechanism.lets:
        value = values.get(let.name, 0.0)
        if not value < 0 or let.dimension not in _SIZES or let.span.start >= own:
            continue
        made_of = _made_of(let, lets)
        if made_of & (said | bounded) or _has_sign(let, made_of, lets, values):
            continue
        said.add(let.name)
        unit = let.unit or si_unit(let.dimension)
        yield messages.negative_size(let.span, let.name, in_unit(value, unit, 6))


def _made_of(let: Let, lets: dict[str, Let]) -> set[str]:
    """Return the names that a formula rests on, through others, its own among them."""
    found, waiting = {let.name}, [let.name]
    while waiting:
        name = waiting.pop()
        new = symbols(lets[name].value) - found if name in lets else frozenset()
        found |= new
        waiting.extend(new)
    return found


def _has_sign(let: Let, made_of: set[str], lets: dict[str, Let], values: Values) -> bool:
    """Return whether a size may well be negative, by its name or by what it is made of."""
    formulas = [lets[name].value for name in made_of if name in lets]
    is_projection = any(
        isinstance(p, Call) and p.function in _WAVES for f in formulas for p in walk(f)
    )
    signed = (name for name in made_of - lets.keys() if values.get(name, 0.0) < 0)
    return is_projection or any(signed) or any(map(_COORDINATE.fullmatch, made_of))


_WAVES = ("sin", "cos", "tan", "cot", "sec", "csc")
