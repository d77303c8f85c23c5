"""From the pose to the velocity-constraint graph, and on to its plan."""

from collections.abc import Collection, Iterator

from ..diagnostics import Diagnostic, Report
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

    Reports E401 where nothing can move, E404 where a load is on a loose end, E841 where too much
    moves, and W401 for a redundant constraint. A frame, of whose joints forces are asked for,
    need not move.
    """
    finds = pose.mechanism.finds
    asks_for_forces = any(isinstance(f.target, ForceAtJoint) for f in finds)
    graph = graph_of(pose)
    for loose in _loose_ends(pose.mechanism, graph.velocities.keys()):
        report.add(loose)
    report.stop_on_errors()
    plan = plan_of(graph, report, may_stand=asks_for_forces)
    if not plan.mobility:
        _check_frame(pose.mechanism, report)
    return plan


def _loose_ends(mechanism: Mechanism, moved: Collection[str]) -> Iterator[Diagnostic]:
    """Yield E404 for the ends of telescopes that nothing else carries, though they are asked for.

    ``moved`` are the points of links, pivots and sliders.
    """
    asked = {point for load in mechanism.loads for point in load.points}
    speeds = (f.target for f in mechanism.finds if isinstance(f.target, SpeedRatio))
    asked |= {speed.of for pair in speeds for speed in (pair.above, pair.below)}
    for telescope in mechanism.telescopes:
        for point in telescope.points:
            if point in asked and point not in moved:
                yield messages.loose_end_of_telescope(telescope.span, telescope.name, point)


def _check_frame(mechanism: Mechanism, report: Report) -> None:
    """Report E402 for what only a motion could give of a frame, else E403 for friction."""
    for find in mechanism.finds:
        if isinstance(find.target, LoadRatio | LoadForm | SpeedRatio):
            report.add(messages.asked_of_a_frame(find.span, find.name))
            return
    for joint in mechanism.friction.joints[:1]:
        report.add(messages.friction_in_a_frame(joint.span))
