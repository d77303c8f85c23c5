"""Ranges of parameters that reach to where a table, a list or a choice has no value."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...diagnostics import Diagnostic, Report
from ...diagnostics.model import sheets as messages
from ...formula.choices import CONDITIONS, SIGNS
from ...formula.evaluate import evaluate
from ...formula.tree import Call, Formula, Symbol
from ...formula.walk import symbols, walk
from ...source import Source
from ...units import in_unit
from ..mechanism import Mechanism, Parameter, Require
from ..results import failures
from ..values import Chain, Values, bounds, defaults, dependent, holds, user_defined

RANGE_PARTS = 12
"""Parts of a range, at whose ends it is looked at."""


def beyond_ranges(mechanism: Mechanism, report: Report) -> Iterator[Diagnostic]:
    """Yield, for each formula that has a value at the default pose, a range that leaves it none.

    Each range of the description's own is run through by itself, where the conditions hold that
    the user wrote. One that was remarked upon is left out.
    """
    given = [r for r in (*mechanism.requires, *mechanism.implied) if _is_of_a_formula(r)]
    ranged = _own_ranges(mechanism, report)
    if not given or not ranged:
        return
    lets: Mapping[str, Formula] = user_defined(mechanism)
    chain, values = Chain({**lets, **dependent(mechanism)}), defaults(mechanism)
    values = {name: value for name, value in values.items() if name not in lets}
    start = chain.complete(values)
    sound = [(r, _needs(r, chain)) for r in given if holds(r, start)]
    written = [(r, _needs(r, chain)) for r in mechanism.requires if r.subject is None]
    for parameter in ranged:
        at = _Samples(parameter.name, values, chain)
        for require, needs in [pair for pair in sound if parameter.name in pair[1]]:
            own = [w for w, needed in written if _formula(require) not in needed]
            value = _first_broken(require, own, _along(parameter, require), at)
            if value is not None:
                sound.remove((require, needs))
                yield _said(require, parameter, value, at.value(value), report.source)


def _own_ranges(mechanism: Mechanism, report: Report) -> list[Parameter]:
    """Return the parameters with a range in the description itself that nothing was said of."""
    said = {diagnostic.span for diagnostic in report.diagnostics}
    ranged = (p for p in mechanism.parameters if p.range and not p.dependent)
    return [p for p in ranged if p.span.end <= len(report.source.text) and p.span not in said]


def _first_broken(
    require: Require, own: Sequence[Require], values: Iterable[float], at: "_Samples"
) -> float | None:
    """Return the first value at which a condition fails while those of the user's hold."""
    for value in values:
        known = at.value(value)
        if not holds(require, known) and all(holds(written, known) for written in own):
            return value
    return None


class _Samples:
    """All values where one parameter has another one, found once for each."""

    def __init__(self, name: str, values: Values, chain: Chain) -> None:
        self._name, self._values, self._chain = name, values, chain
        self._known: dict[float, Values] = {}

    def value(self, at: float) -> Values:
        """Return the value of every name that has one, at a value of the parameter."""
        if at not in self._known:
            self._known[at] = self._chain.complete({**self._values, self._name: at})
        return self._known[at]


def _is_of_a_formula(require: Require) -> bool:
    return require.subject is not None and require.subject.kind != "pose"


def _needs(require: Require, chain: Chain) -> set[str]:
    return chain.needed_by(symbols(require.left) | symbols(require.right))


def _formula(require: Require) -> str:
    assert require.subject is not None
    return require.subject.let


def _along(parameter: Parameter, require: Require) -> Iterator[float]:
    """Yield the ends of a range, then what is between, and what the parameter is compared with.

    A choice may have values one by one, ``4 mm when n = 2``, and none between; so have rows that
    are taken exactly.
    """
    low, high = bounds(parameter)
    yield from (low, high)
    compared = [f for f in walk(require.left) if isinstance(f, Call) and f.function in SIGNS]
    by_rows = require.subject is not None and require.subject.kind == "row"
    if not by_rows and CONDITIONS["="] not in (call.function for call in compared):
        yield from (low + (high - low) * step / RANGE_PARTS for step in range(1, RANGE_PARTS))
        limits = (f for call in compared for f in _against(parameter.name, call))
        yield from (limit for limit in limits if low < limit < high)


def _against(name: str, comparison: Call) -> Iterator[float]:
    """Yield the constant that a parameter itself is compared with."""
    if Symbol(name) in comparison.arguments:
        others = (f for f in comparison.arguments if not symbols(f))
        yield from (evaluate(other, {}) for other in others)


def _said(
    require: Require, parameter: Parameter, value: float, known: Values, source: Source
) -> Diagnostic:
    shown = in_unit(value, parameter.unit, 4) if parameter.unit else f"{value:.4g}"
    why = failures.broken_formula(require, known, source)
    name, ranged = parameter.name, parameter.span
    return messages.range_without_value(require.span, name, shown, why, ranged)
