"""What stands beside a result with friction: its form for elsewhere, and its status.

A closed form takes for granted that friction turns no force at a joint round. Where one is
turned, code solves the coupled equations instead, in a function of its own. A number, or NaN,
does not tell by itself whether anything moves: the status does.
"""

from collections.abc import Mapping, Sequence

from ..formula.walk import symbols
from ..frozen import replace
from ..model.mechanism import LoadForm, LoadRatio, Mechanism, WithFriction
from ..model.result import Result
from ..model.targets import SIGNS
from .steps import Function, Guard, Input, Solve, Statement, Status, formulas_of, names_of


class Companions:
    """Gives functions their companions, under names that nothing else has."""

    def __init__(
        self, mechanism: Mechanism, results: Sequence[Result], inputs: Mapping[str, Input]
    ) -> None:
        self._results, self._inputs = results, inputs
        self._pairs = mechanism.friction.efficiency is None
        self._taken = {*inputs, *(r.name for r in results)}

    def joined(self, function: Function, other: Function | None, result: Result) -> Function:
        """Return a function with the one for elsewhere and with its status, if it has them."""
        if other:
            title = f"{function.title}, whichever way its joints are pressed"
            name = self._fresh(f"{function.name}_coupled")
            other = replace(other, name=name, title=title)
            names = {i.name for f in (function, other) for i in f.inputs}
            function = replace(function, inputs=self._in_order(names), otherwise=other)
        status = self._status(function, result)
        return replace(function, status=status) if status else function

    def _status(self, function: Function, result: Result) -> Status | None:
        match result.target:
            case WithFriction(LoadRatio() | LoadForm() as of, sense, "exact") if self._pairs:
                ideal = next(r for r in self._results if r.target == of)
                solved = function.otherwise or function
                guards = tuple(g for g in solved.guards if not g.balance)
                name = self._fresh(f"{function.name}_status")
                steps = _needed(solved.steps, guards)
                return Status(name, ideal.name, SIGNS[sense], function.inputs, steps, guards)
            case _:
                return None

    def _in_order(self, names: set[str]) -> tuple[Input, ...]:
        return tuple(item for name, item in self._inputs.items() if name in names)

    def _fresh(self, name: str) -> str:
        while name in self._taken:
            name += "_"
        self._taken.add(name)
        return name


def _needed(steps: Sequence[Statement], guards: Sequence[Guard]) -> tuple[Statement, ...]:
    """Return the steps that solve systems, and those that they and the guards rest on."""
    needed = {name for g in guards for side in (g.left, g.right) for name in symbols(side)}
    kept: list[Statement] = []
    for step in reversed(steps):
        if isinstance(step, Solve) or not needed.isdisjoint(names_of(step)):
            kept.append(step)
            needed |= {name for formula in formulas_of(step) for name in symbols(formula)}
    return tuple(kept[::-1])
