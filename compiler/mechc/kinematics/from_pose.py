"""From the pose to the velocity-constraint graph, and on to its plan."""

from ..diagnostics import Report
from ..diagnostics import kinematics as messages
from ..model.mechanism import (
    ForceAtJoint,
    LoadForm,
    LoadRatio,
    Mechanism,
    SpeedRatio,
)
from ..pose.pose import Pose
from .carriers import graph_of
from .plan import Plan
from .planning import plan_of


def plan_velocities(pose: Pose, report: Report) -> Plan:
    """Return the plan by which all velocities follow from the drives.

    Reports E401 where nothing can move, E841 where too much does, and W401 for a redundant
    constraint. A frame, of whose joints forces are asked for, need not move.
    """
    finds = pose.mechanism.finds
    asks_for_forces = any(isinstance(f.target, ForceAtJoint) for f in finds)
    plan = plan_of(graph_of(pose), report, may_stand=asks_for_forces)
    if not plan.mobility:
        _check_frame(pose.mechanism, report)
    return plan


def _check_frame(mechanism: Mechanism, report: Report) -> None:
    """Report E402 for what only a motion could give of a frame, else E403 for friction."""
    for find in mechanism.finds:
        if isinstance(find.target, LoadRatio | LoadForm | SpeedRatio):
            report.add(messages.asked_of_a_frame(find.span, find.name))
            return
    for joint in mechanism.friction.joints[:1]:
        report.add(messages.friction_in_a_frame(joint.span))
