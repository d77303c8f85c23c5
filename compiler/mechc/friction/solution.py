"""Everything that was asked for: without friction, with it, and the user's own formulas."""

from ..frozen import frozen
from ..kinematics.plan import Plan
from ..model.result import FrictionResult, Result
from ..power.balance import Balance, Solved
from .steps import Step


@frozen
class SolvedWithFriction:
    """A result with friction, and the ``steps`` by which it was found."""

    result: FrictionResult
    steps: tuple[Step, ...] = ()


@frozen
class Solution:
    """The balance without friction, and all that was asked for, in the order of the text."""

    balance: Balance
    solved: tuple[Solved | SolvedWithFriction, ...]

    @property
    def plan(self) -> Plan:
        """Return the plan of velocities that the balance rests on."""
        return self.balance.plan

    @property
    def results(self) -> tuple[Result, ...]:
        """Return the results in the order in which they were asked for."""
        return tuple(s.result for s in self.solved)
