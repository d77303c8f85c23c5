"""The power equations: ``Σ load · speed = 0``, one for each independent motion."""

from collections.abc import Mapping

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..frozen import frozen
from ..kinematics.plan import Plan, Speeds
from ..model.mechanism import Load
from ..model.result import Result
from .friction.steps import Step


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
class Release:
    """One component of the force at a joint: a bond that is let go along a direction.

    ``kind``, ``point`` and ``of`` are the bond's; the loads that are ``held`` do no work. Of
    the ``terms`` the last one is that of the force itself, its speed that at which the bond
    parts; ``amounts`` is the force per unit of each load.
    """

    kind: str
    point: str
    of: str
    direction: Angle
    held: tuple[str, ...]
    plan: Plan
    terms: tuple[Term, ...]
    amounts: Mapping[str, Product]


@frozen
class Solved:
    """A result as algebra, before it is turned into a formula.

    ``value`` is None for a let. ``above`` and ``below`` are the loads of a ratio,
    ``releases`` those by which a force at a joint was found, ``steps`` those by which friction
    was.
    """

    result: Result
    value: Product | None = None
    above: str = ""
    below: str = ""
    releases: tuple[Release, ...] = ()
    steps: tuple[Step, ...] = ()


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
