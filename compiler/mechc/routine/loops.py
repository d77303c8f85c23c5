"""Loops that a result does not rest on: without them there is no pose, and no value."""

from collections.abc import Mapping, Sequence

from ..formula.tree import ZERO, Formula
from ..model.result import Result
from ..pose.pose import ClosedLoop
from .scope import Scope, rename
from .steps import Guard


def unseen_loops(result: Result, scope: Scope, loops: Sequence[ClosedLoop]) -> list[ClosedLoop]:
    """Return the loops whose failure to close a result would not show, those needed last first.

    A loop that rests on another one shows the other's failure as well. One of fixed lengths
    alone closes once and for all.
    """
    if not loops:
        return []
    found: list[ClosedLoop] = []
    formulas = [result.formula, *(side for g in result.guards for side in (g.left, g.right))]
    known = _defined(result, formulas, scope)
    if result.target is None and not _rests_on_a_pose(known, scope, loops):
        return []
    for loop in reversed([loop for loop in loops if _concerns(loop, {result.name, *known})]):
        if loop.names.isdisjoint(known) and scope.free(result.name, [loop.margin]):
            found.append(loop)
            known |= _defined(result, [loop.margin], scope)
    return found


def _defined(result: Result, formulas: Sequence[Formula], scope: Scope) -> set[str]:
    return {name for name, _ in scope.definitions(result.name, formulas).formulas}


def _concerns(loop: ClosedLoop, names: set[str]) -> bool:
    """Whether a loop is the mechanism's own, or one of a used mechanism that has the names."""
    return not loop.of or any(name.startswith(f"{loop.of}_") for name in names)


def _rests_on_a_pose(known: set[str], scope: Scope, loops: Sequence[ClosedLoop]) -> bool:
    """Return whether a formula of the user's own uses what a loop or virtual power gives."""
    finds = {name for name, result in scope.results.items() if result.target is not None}
    return not known.isdisjoint(finds.union(*(loop.names for loop in loops)))


def closing_guard(loop: ClosedLoop, names: Mapping[str, str]) -> Guard:
    """Return the condition that a loop closes, with the names that definitions have."""
    return Guard(rename(loop.margin, names), ">=", ZERO, loop.loop)
