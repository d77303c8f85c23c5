"""The results that a description wants in its report, and those that they rest on."""

from collections.abc import Sequence

from ..formula.walk import symbols
from ..frozen import replace
from ..model.mechanism import Mechanism
from ..model.targets import Efficiency, WithFriction
from ..study.analysis import Analysis
from .derivation.steps import Derivation


def chosen(derivation: Derivation, mechanism: Mechanism) -> Derivation:
    """Return a derivation with the results that the report holds; all where it names none.

    What friction makes of a result belongs to it.
    """
    named = {part.name for part in mechanism.reported if not part.over}
    results = derivation.results
    wanted = {r.name for r in results if r.name in named}
    if not wanted:
        return derivation
    wanted |= {r.name for r in results if _is_of(r, [o for o in results if o.name in wanted])}
    for result in reversed(results):
        if result.name in wanted:
            wanted |= {n for d in result.where for n in symbols(d.formula)}
            wanted |= symbols(result.formula)
    return replace(derivation, results=tuple(r for r in results if r.name in wanted))


def _is_of(result: Analysis, others: Sequence[Analysis]) -> bool:
    """Return whether a result is another one with friction, or the efficiency of it."""
    match result.target:
        case WithFriction(of=of) | Efficiency(of=of):
            return any(other.target == of for other in others)
        case _:
            return False
