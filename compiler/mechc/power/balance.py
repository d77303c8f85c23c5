"""The power equations: ``Σ load · speed = 0``, one for each independent motion."""

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..frozen import frozen
from ..kinematics.plan import Plan, Speeds
from ..model.mechanism import Load
from ..model.result import Result


@frozen
class Term:
    """The part of one load: ``count · load · speed``, for each independent motion.

    ``count`` is how often the load acts (mirror, copies, times); ``speed`` its point's
    velocity along its line, or its link's spin. ``tie`` is (other load, factor) for a
    load tied to another.
    """

    load: Load
    count: Product
    speed: Speeds
    line: Angle | None
    tie: tuple[str, Product] | None = None

    @property
    def power(self) -> Speeds:
        """Return the power per unit of the load."""
        return tuple(self.count * s for s in self.speed)


@frozen
class Solved:
    """A result as algebra, before it is turned into a formula.

    ``value`` is None for a let. ``above`` and ``below`` are the loads of a ratio.
    """

    result: Result
    value: Product | None = None
    above: str = ""
    below: str = ""


@frozen
class Balance:
    """The plan with its loads, and what was asked for, solved."""

    plan: Plan
    terms: tuple[Term, ...]
    solved: tuple[Solved, ...]

    @property
    def results(self) -> tuple[Result, ...]:
        """Return the results in the order in which they were asked for."""
        return tuple(s.result for s in self.solved)
