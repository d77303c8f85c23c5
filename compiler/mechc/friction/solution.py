"""Everything that was asked for: without friction, with it, and the user's own formulas.

A result with friction is given with the steps by which friction was put into it.
"""

from typing import Literal

from ..base.frozen import frozen
from ..formula.tree import Formula
from ..kinematics.plan import Plan
from ..model.result import Definition, FrictionResult, Result
from ..power.balance import AlgebraicResult, Balance

StepKind = Literal[
    "internal",
    "external",
    "parallel",
    "single",
    "face",
    "lever",
    "slider",
    "pin",
    "straight",
    "ropes",
    "efficiency",
    "first order",
    "iterated",
    "unloaded",
    "pressing",
    "added",
    "rod part",
    "normal part",
    "across",
    "balance",
]
"""What a step is: the tangent that a rod's force takes, a body in balance, a way to sum up;
at the end how a force at a joint follows from what is solved."""


@frozen
class FrictionStep:
    """A rod's line of force, a body in balance, or what all frictions add together.

    ``body`` is a link or a point, or the only pair that is iterated, ``pivot`` the point that a
    lever turns on, or the only pin on which a rod turns with friction. ``sense`` is 1 for a rod
    that is pressed or a lever that turns counter-clockwise, -1 for the opposite. ``equations`` are
    pairs that are equal, ``defined`` what gets a name by it.
    """

    kind: StepKind
    body: str = ""
    pivot: str = ""
    sense: int = 0
    equations: tuple[tuple[Formula, Formula], ...] = ()
    defined: tuple[Definition, ...] = ()


@frozen
class SolvedWithFriction:
    """A result with friction, and the ``steps`` by which it was found."""

    result: FrictionResult
    steps: tuple[FrictionStep, ...] = ()


@frozen
class FrictionSolution:
    """The balance without friction, and all that was asked for, in the order of the text."""

    balance: Balance
    solved: tuple[AlgebraicResult | SolvedWithFriction, ...]

    @property
    def plan(self) -> Plan:
        """Return the plan of velocities that the balance rests on."""
        return self.balance.plan

    @property
    def results(self) -> tuple[Result, ...]:
        """Return the results in the order in which they were asked for."""
        return tuple(s.result for s in self.solved)
