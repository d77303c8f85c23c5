"""What comes with a result with friction: its form for elsewhere, and its status.

A closed form takes for granted that friction turns no force at a joint round. Where one is
turned, code solves the coupled equations instead, in a function of its own. A number, or NaN,
does not show by itself whether anything moves: the status does.
"""

from collections.abc import Sequence, Set
from functools import cache, partial

from ..base.frozen import replace
from ..formula.tree import Formula
from ..model.mechanism import LoadForm, LoadRatio, Sense, WithFriction
from ..model.parts.targets import SIGNS
from ..model.result import DrivingLoad, FrictionResult
from .functions import AskedResult, steps_to
from .scope import ProgramScope, rename
from .steps import (
    Function,
    Guard,
    Input,
    ProgramStatement,
    ResultStatus,
    Solve,
    leading_to,
    mentioned,
    names_in,
    names_of,
    sides_of,
)


class Companions:
    """Gives functions their companions, under names that nothing else has."""

    def __init__(self, scope: ProgramScope, inputs: Sequence[Input]) -> None:
        self._scope, self._inputs = scope, inputs
        self._pairs = scope.mechanism.friction.efficiency is None
        self._taken = {*(i.name for i in inputs), *scope.results}
        self._steps_to = cache(partial(steps_to, names=self._taken))
        """Steps to the loads that drive, the same for many forces at joints."""

    def joined(self, function: Function, other: Function | None, asked: AskedResult) -> Function:
        """Return a function with the one for elsewhere and with its status, if it has them."""
        if other:
            title = f"{function.title}, whichever way its joints are pressed"
            name = self._fresh(f"{function.name}_coupled")
            other = replace(other, name=name, title=title)
            names = {i.name for f in (function, other) for i in f.inputs}
            function = replace(function, inputs=self._in_order(names), otherwise=other)
        status = self._status(function, asked) if self._pairs else None
        return replace(function, status=status) if status else function

    def _status(self, function: Function, asked: AskedResult) -> ResultStatus | None:
        """Return the program that says whether the mechanism moves, for a result with friction."""
        match asked.result.target:
            case WithFriction(LoadRatio() | LoadForm() as of, sense, "exact"):
                ideal = next(r for r in self._scope.results.values() if r.target == of)
                solved = function.otherwise or function
                guards = _of_the_pose(solved.guards)
                name = self._fresh(f"{function.name}_status")
                steps = _solving(solved.steps, list(sides_of(guards)))
                is_idle = isinstance(asked.result, FrictionResult) and asked.result.is_idle
                return ResultStatus(
                    name, ideal.name, SIGNS[sense], function.inputs, steps, guards, is_idle
                )
            case WithFriction(_, sense, "exact"):
                return self._of_a_force(function, asked, sense)
            case _:
                return None

    def _of_a_force(self, function: Function, asked: AskedResult, sense: Sense) -> ResultStatus:
        """Return the status of a force at a joint: it does not state whether the drive moves."""
        result = asked.result
        assert isinstance(result, FrictionResult), "a force with friction"
        assert result.drive, "it says what drives"
        known = self._scope.definitions(result.name, [*result.drive, *asked.needed])
        guards = _of_the_pose(asked.guards(known.names))
        loads = tuple(rename(load, known.names) for load in result.drive)
        steps, (ideal, load) = self._steps_to(tuple(known.formulas), loads, guards)
        ends = [ideal, load, *sides_of(guards)]
        steps = _solving(steps, ends)
        used = mentioned(steps, ends).difference(*map(names_of, steps))
        used |= {i.name for i in function.inputs}
        name = self._fresh(f"{function.name}_status")
        drive = DrivingLoad(ideal, load)
        inputs = self._in_order(used)
        return ResultStatus(name, drive, SIGNS[sense], inputs, steps, guards, result.is_idle)

    def _in_order(self, names: Set[str]) -> tuple[Input, ...]:
        return tuple(item for item in self._inputs if item.name in names)

    def _fresh(self, name: str) -> str:
        while name in self._taken:
            name += "_"
        self._taken.add(name)
        return name


def _of_the_pose(guards: Sequence[Guard]) -> tuple[Guard, ...]:
    """Return the conditions without which there is no pose."""
    return tuple(g for g in guards if not g.balance)


def _solving(
    steps: Sequence[ProgramStatement], ends: Sequence[Formula]
) -> tuple[ProgramStatement, ...]:
    """Return the steps that solve systems, and those that they and the formulas rest on."""
    unknowns = (n for step in steps if isinstance(step, Solve) for n in step.names)
    return leading_to({*names_in(ends), *unknowns}, steps)
