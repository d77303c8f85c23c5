"""The verdict of the referee: k by virtual power against k by free bodies, pose by pose.

Where there is none, the reason is one of the sentences below: as it stands in English, and by
it in the other languages.
"""

from collections.abc import Mapping

from ..base.named import NamedTuple
from .tolerances import AGREEMENT, CONDITION_SLACK, EPSILON

OPEN = "equilibrium leaves a force open that is asked for"

UNBALANCED = "no forces at the joints balance the loads"

STANDS = "a joint stands still at that pose, and rounding decides which way it slips"
"""The doubt where friction may as well have the other sign, or none."""

UNSETTLED = "no friction was found that balances at that pose"
"""The doubt where iteration ends: there may be none, or more to find."""

CONSTANT = "an efficiency does not say where friction acts"

MIXED = "forces with friction do not add up, so every load but one needs a size"

SEVERAL = "friction is found where one load follows from all the others"

WITHOUT_FORCES = (OPEN, UNBALANCED, STANDS, UNSETTLED, CONSTANT, MIXED, SEVERAL)
"""Why bodies have no forces: none are drawn, and no pose is judged by them."""

NO_VALUE = "virtual power gives no finite value"

NEAR_SINGULAR = "the pose is within a hair of singular"

NO_MORE = "no more poses meet the conditions of use"

NO_SPEED = "the speed below the line vanishes"

TOO_MUCH = "that takes too much work"

UNJUDGED = (NO_VALUE, NEAR_SINGULAR, NO_MORE, NO_SPEED, TOO_MUCH)
"""Why a pose is not judged whose bodies have forces."""


class Trial(NamedTuple):
    """One pose: the values, the result's name, both answers, and how far apart they may be.

    ``error`` is relative to max(|power|, |statics|, tiny); ``condition`` estimates the
    condition number of the equilibrium equations; the trial agrees when ``error`` is
    below a fixed multiple of condition · eps. The answer ``is_one_of_several`` where other
    forces balance with friction, too.
    """

    result: str
    values: Mapping[str, float]
    power: float
    statics: float
    error: float
    condition: float
    is_one_of_several: bool = False

    @property
    def agrees(self) -> bool:
        """Return whether the two methods agree to within the pose's condition."""
        return self.error <= max(CONDITION_SLACK * self.condition * EPSILON, AGREEMENT)


class Untried(NamedTuple):
    """A result that fewer poses judge than are wanted, and why."""

    result: str
    judged: int
    poses: int
    reason: str

    def __str__(self) -> str:
        """Return this in English.

        >>> str(Untried("k", 2, 4, "the pose is within a hair of singular"))
        'k was judged at 2 of 4 poses: the pose is within a hair of singular'
        """
        return f"{self.result} was judged at {self.judged} of {self.poses} poses: {self.reason}"


class Verdict(NamedTuple):
    """All trials of one compile (the default pose first), and what could not be tried."""

    trials: tuple[Trial, ...]
    remarks: tuple[Untried, ...] = ()

    @property
    def agrees(self) -> bool:
        """Return whether every trial agrees."""
        return all(t.agrees for t in self.trials)

    @property
    def worst(self) -> float:
        """Return the largest relative error, 0 when nothing was tried."""
        return max((t.error for t in self.trials), default=0.0)
