"""The checks of a calculation note: conditions in numbers, and by what factor each holds."""

import math
from collections.abc import Container, Iterator, Mapping, Sequence

from ..base.named import NamedTuple
from ..formula.evaluate import evaluate
from ..formula.tree import Formula, Symbol
from ..formula.walk import symbols
from ..model.dependence import below, rests_on
from ..model.mechanism import Mechanism, Require
from ..model.result import Result
from ..model.values import compare, user_defined
from ..units import si_unit
from .put_in import GivenQuantity, values_of


class NoteCheck(NamedTuple):
    """A condition, its sides in numbers, and by what factor it holds, if that has a meaning.

    One that ``fails`` has no such factor. There are no numbers where ``missing`` parameters, that
    it rests on, have no value.
    """

    label: str
    left: Formula
    operator: str
    right: Formula
    values: tuple[GivenQuantity, GivenQuantity] | None
    reserve: float | None
    decides: bool
    missing: tuple[str, ...] = ()
    fails: bool = False


def checks(
    mechanism: Mechanism, results: Sequence[Result], given: Mapping[str, GivenQuantity]
) -> Iterator[NoteCheck]:
    """Yield the conditions of a sheet at ``given`` values, one with the least reserve as deciding.

    None decides where one fails, nor where a single one has a reserve.
    """
    lets = user_defined(mechanism)
    inputs = {p.name for p in mechanism.parameters}
    found = [_check(r, given, lets, inputs) for r in mechanism.requires if not r.subject]
    found = [_with_missing(check, mechanism, results) for check in found]
    yield from _with_the_least(found)


def _check(
    require: Require,
    given: Mapping[str, GivenQuantity],
    lets: Mapping[str, Formula],
    inputs: Container[str],
) -> NoteCheck:
    """Return a condition with the values of its sides, and by what factor it holds."""
    assert require.written
    left, right, label = require.written.left, require.written.right, require.written.label
    values = _sides(require, given)
    fails = values is not None and not compare(values[0].value, require.operator, values[1].value)
    compared = values if not fails and not _is_range(require, lets, inputs) else None
    reserve = _reserve(compared[0].value, compared[1].value, require.operator) if compared else None
    return NoteCheck(
        label, left, require.operator, right, values, reserve, decides=False, fails=fails
    )


def _with_missing(check: NoteCheck, mechanism: Mechanism, results: Sequence[Result]) -> NoteCheck:
    """Return a check; one without numbers has the parameters that have no value."""
    if check.values:
        return check
    used = below(symbols(check.left, check.right), rests_on(mechanism, results))
    missing = (p.name for p in mechanism.parameters if p.value is None and p.name in used)
    return check._replace(missing=tuple(missing))


def _is_range(require: Require, lets: Mapping[str, Formula], inputs: Container[str]) -> bool:
    """Return whether a given quantity is held against a number: for what a formula is meant.

    A reserve is that of what was calculated.
    """
    sides = [require.left, require.right]
    for i, side in enumerate(sides):
        while isinstance(side, Symbol) and side.name in lets:
            side = sides[i] = lets[side.name]
    bare = [s for s in sides if isinstance(s, Symbol) and s.name in inputs]
    return len(bare) == 1 and any(not symbols(s) for s in sides)


def _sides(
    require: Require, given: Mapping[str, GivenQuantity]
) -> tuple[GivenQuantity, GivenQuantity] | None:
    """Return both sides in the unit that they are written in; None where one has no value."""
    values = values_of(given)
    if not symbols(require.left) | symbols(require.right) <= values.keys():
        return None
    unit = require.unit or si_unit(require.dimension)
    left, right = (evaluate(side, values) for side in (require.left, require.right))
    return GivenQuantity(left, unit), GivenQuantity(right, unit)


def _reserve(left: float, right: float, operator: str) -> float | None:
    """Return how many times a positive limit is above what is held against it."""
    small, large = (left, right) if operator in ("<", "<=") else (right, left)
    sound = operator in ("<", "<=", ">", ">=") and small > 0 and large > 0
    return large / small if sound and math.isfinite(large / small) else None


def _with_the_least(checks: Sequence[NoteCheck]) -> Iterator[NoteCheck]:
    """Yield checks, of several that one with the least reserve as deciding, if all hold."""
    reserves = [check.reserve for check in checks if check.reserve is not None]
    all_hold = not any(check.fails for check in checks)
    least = min(reserves) if all_hold and len(reserves) > 1 else None
    for check in checks:
        yield check._replace(decides=check.reserve is not None and check.reserve == least)
