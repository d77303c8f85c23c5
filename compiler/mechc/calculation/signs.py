"""Conditions that hold only because a force counts as negative: a rod in compression."""

from collections.abc import Iterable, Iterator

from ..diagnostics import Diagnostic
from ..diagnostics import sheets as messages
from ..formula.to_text import text
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Mechanism
from ..model.written import WrittenSides
from ..units import FORCE, PRESSURE, TORQUE, in_unit, si_unit
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
    lets = {let.name: let.value for let in mechanism.lets}
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
