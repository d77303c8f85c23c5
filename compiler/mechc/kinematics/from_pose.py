"""From the pose to the velocity-constraint graph, and on to its plan."""

from ..diagnostics import Report
from ..pose.pose import Pose
from .builder import Builder
from .plan import Plan
from .planning import plan_of


def plan_velocities(pose: Pose, report: Report) -> Plan:
    """Return the plan by which all velocities follow from the drives.

    Reports E401 where nothing can move, E841 where too much does, and W401 for a redundant
    constraint.
    """
    return plan_of(Builder(pose).graph(), report)
