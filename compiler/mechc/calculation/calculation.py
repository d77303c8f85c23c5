"""What comes of a calculation sheet."""

from ..base.frozen import frozen
from ..model.mechanism import Require
from ..model.result import Result
from ..pose.pose import Pose


@frozen
class Check:
    """A condition of use with the values of both sides, in SI; None where one has no value."""

    condition: Require
    left: float | None
    right: float | None


@frozen
class Calculation:
    """The formulas of a sheet as results, in the order of the text, and its conditions."""

    pose: Pose
    results: tuple[Result, ...]
    checks: tuple[Check, ...]
