"""User-defined formulas that rest on many others: their intermediates, each defined once."""

from collections.abc import Iterator, Mapping, Sequence

from ...formula.tree import Formula
from ...formula.walk import symbols
from ...frozen import replace
from ...study.analysis import Analysis

LONG = 24
"""Intermediates beyond which those are left out that another result stands for."""


def defined_once(results: Sequence[Analysis]) -> tuple[Analysis, ...]:
    """Return results; long ones without what the results define that they mention.

    Written out in each, a chain of lets would make a document grow with the square of their number.
    """
    formulas = {r.name: r.formula for r in results if not r.coefficients}
    return tuple(_short(r, formulas) if _is_long(r) else r for r in results)


def _is_long(result: Analysis) -> bool:
    return result.target is None and len(result.where) > LONG


def _short(result: Analysis, results: Mapping[str, Formula]) -> Analysis:
    """Return a result with those intermediates alone that lead to other results."""
    defined = dict(result.where)
    wanted, left = set[str](), list(_read(result))
    while left:
        name = left.pop()
        if name in defined and name not in wanted and results.get(name) != defined[name]:
            wanted.add(name)
            left.extend(symbols(defined[name]))
    return replace(result, where=tuple(d for d in result.where if d.name in wanted))


def _read(result: Analysis) -> Iterator[str]:
    """Yield the names that are mentioned of a result."""
    compared = (side for r in (*result.holds, *result.guards) for side in (r.left, r.right))
    for formula in (result.formula, *(result.derivatives or {}).values(), *compared):
        yield from symbols(formula)
