"""Loads whose size the description gives, taken as inputs instead."""

from collections.abc import Iterable, Set

from ..frozen import replace
from ..model.mechanism import Mechanism
from ..model.result import Definition, FrictionResult, Result


def given_loads(mechanism: Mechanism, results: Iterable[Result]) -> frozenset[str]:
    """Return the loads that results take from the description: weights, and those with a let."""
    loads = {load.name for load in mechanism.loads}
    asked = {r.name for r in results if r.target is not None}
    used = {d.name for r in results for d in r.where} | {let.name for let in mechanism.lets}
    return frozenset((loads & used) - asked)


def freed(
    mechanism: Mechanism, results: Iterable[Result], names: Set[str]
) -> tuple[Mechanism, tuple[Result, ...]]:
    """Return a mechanism and its results with loads of these names given by nothing."""
    loads = (replace(k, tie=None) if k.name in names else k for k in mechanism.loads)
    others = (r for r in results if r.name not in names)
    return replace(mechanism, loads=tuple(loads)), tuple(_freed(r, names) for r in others)


def _freed(result: Result, names: Set[str]) -> Result:
    where = _without(result.where, names)
    elsewhere = _freed(result.elsewhere, names) if result.elsewhere else None
    changed = replace(result, where=where, elsewhere=elsewhere)
    if not isinstance(changed, FrictionResult) or changed.case is None:
        return changed
    case = replace(changed.case, where=_without(changed.case.where, names))
    return replace(changed, case=case)


def _without(where: Iterable[Definition], names: Set[str]) -> tuple[Definition, ...]:
    return tuple(d for d in where if d.name not in names)
