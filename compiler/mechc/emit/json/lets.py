"""User-defined formulas that rest on many others: their intermediates, each defined once."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...base.frozen import replace
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...model.result import Definition, Result
from ...study.analysis import Analysis

MOST_INTERMEDIATES = 24
"""Intermediates beyond which those are left out that another result stands for."""


def defined_once(results: Sequence[Analysis]) -> tuple[Analysis, ...]:
    """Return results; long ones without what the results define that they mention.

    Written out in each, a chain of lets would make a document grow with the square of their number.
    What holds of a let elsewhere rests in the same way on what holds of others there.
    """
    here = _defined(results)
    there = _defined([r.elsewhere or r for r in results])
    return tuple(_with_others(r, here, there) if r.target is None else r for r in results)


def _defined(results: Sequence[Result]) -> Mapping[str, Formula]:
    """Return the formulas of results, and of the definitions of those that are no lets."""
    found = {d.name: d.formula for r in results if r.target is not None for d in r.where}
    return found | {r.name: r.formula for r in results if not r.coefficients}


def _with_others(
    result: Analysis, here: Mapping[str, Formula], there: Mapping[str, Formula]
) -> Analysis:
    """Return a let, here and elsewhere, without long rows of what others define."""
    read = (*_sides(result), *(result.derivatives or {}).values())
    where = _short(result.where, (result.formula, *read), here)
    other = result.elsewhere
    if other:
        read = (other.formula, *(side for r in other.guards for side in (r.left, r.right)))
        other = replace(other, where=_short(other.where, read, there))
    return replace(result, where=where, elsewhere=other)


def _short(
    where: tuple[Definition, ...], read: Iterable[Formula], results: Mapping[str, Formula]
) -> tuple[Definition, ...]:
    """Return of many intermediates those alone that lead to other results."""
    if len(where) <= MOST_INTERMEDIATES:
        return where
    defined, wanted = dict(where), set[str]()
    left = [name for formula in read for name in symbols(formula)]
    while left:
        name = left.pop()
        if name in defined and name not in wanted and results.get(name) != defined[name]:
            wanted.add(name)
            left.extend(symbols(defined[name]))
    return tuple(d for d in where if d.name in wanted)


def _sides(result: Analysis) -> Iterator[Formula]:
    """Yield what the conditions of a result compare."""
    yield from (side for r in (*result.holds, *result.guards) for side in (r.left, r.right))
