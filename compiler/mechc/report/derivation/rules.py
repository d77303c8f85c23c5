"""The textbook's rule for each relation of the plan, and what it is applied to."""

from collections.abc import Iterator
from typing import assert_never

from ...kinematics.graph import Graph, Relation, Rule, SpeedKind
from ...model.mechanism import ArcSlot, Joint, Meshing, WheelPair
from ..kinds import StepRule


def rule_of(relation: Relation, graph: Graph) -> tuple[StepRule, tuple[str, ...]]:
    """Return the textbook's rule for a relation, and the points and links it is applied to."""
    if arc := graph.pose.mechanism.arc_of(relation.link):
        return _rule_of_circular_slot(relation, arc, graph)
    match relation.rule:
        case Rule.PROJECTION:
            return StepRule.PROJECTION, relation.points
        case Rule.GUIDE:
            return StepRule.GUIDE, relation.points
        case Rule.ROTATION if graph.spins.get(relation.link) not in relation.form:
            return StepRule.PROJECTION, relation.points
        case Rule.BODY:
            return StepRule.BODY, (relation.link, *relation.points)
        case Rule.ROTATION | Rule.JOINT | Rule.REST:
            return StepRule.ROTATION, (relation.link, *relation.points)
        case Rule.TURNING:
            return StepRule.TURNING, _joint_of(relation, graph).bodies[::-1]
        case Rule.SLOT | Rule.CONTACT:
            return StepRule(relation.rule.value), (*relation.points, relation.link)
        case Rule.MESH:
            return _rule_of_mesh(relation, graph)
        case Rule.ROPE:
            return StepRule.ROPE, relation.points
        case Rule.HELD:
            raise ValueError("only a released joint is held, and no step of a motion")
        case _:
            assert_never(relation.rule)


def _rule_of_circular_slot(
    relation: Relation, arc: ArcSlot, graph: Graph
) -> tuple[StepRule, tuple[str, ...]]:
    """Return the rule of a relation on the rod that stands for a circular slot: its radius."""
    radius = relation.link
    turns = graph.spins.get(radius) in relation.form
    if relation.rule is Rule.PROJECTION or (relation.rule is Rule.ROTATION and not turns):
        pin = next(p for p in relation.points if p != arc.centre)
        return StepRule.CIRCULAR_SLOT, (radius, pin, arc.link, arc.centre)
    rule = StepRule.TURNING_RADIUS if relation.rule is Rule.BODY else StepRule.RADIUS
    return rule, (radius, *relation.points)


def _rule_of_mesh(relation: Relation, graph: Graph) -> tuple[StepRule, tuple[str, ...]]:
    """Return the rule of what meshes and its points, with the link that turns if there is one."""
    joint = _joint_of(relation, graph)
    assert isinstance(joint, Meshing), "no other joint meshes"
    if isinstance(joint, WheelPair) and joint.arm:
        return StepRule.ON_ARM, (joint.arm, *relation.points)
    alone = () if len(relation.points) > 1 else (relation.link,)
    return StepRule(joint.kind), (*alone, *relation.points)


def rule_of_component(point: str, load: str, graph: Graph) -> tuple[StepRule, tuple[str, ...]]:
    """Return the rule for the component of a point's velocity along a load, and its names."""
    velocity = graph.velocities[point]
    if all(graph.unknowns[flow.unknown].kind is SpeedKind.COMPONENT for flow in velocity):
        return StepRule.COMPONENT_OF_TWO, (point, load)
    for link, pole in _poles(point, graph):
        if graph.pose.mechanism.arc_of(link):
            continue
        if pole in graph.pose.mechanism.fixed:
            return StepRule.COMPONENT_OF_ROTATION, (pole, point, load)
        return StepRule.COMPONENT_OF_BODY, (link, pole, point, load)
    return StepRule.COMPONENT, (point, load)


def pole_of(point: str, relation: Relation, graph: Graph) -> tuple[str, str] | None:
    """Return the link, and the moving point of it, from which a relation takes a point's velocity.

    None where it is known by itself, or by a rotation about a pivot.
    """
    for link, pole in _poles(point, graph):
        if pole not in graph.pose.mechanism.fixed and graph.spins.get(link) in relation.form:
            return link, pole
    return None


def _poles(point: str, graph: Graph) -> Iterator[tuple[str, str]]:
    """Yield each link and point of it whose velocity, with the link's rotation, is a point's."""
    velocity = graph.velocities[point]
    for link, frame in graph.pose.frames.items():
        for pole in frame if point in frame else ():
            known = graph.velocities[pole]
            turning = {flow.unknown for flow in velocity[len(known) :]}
            if velocity[: len(known)] == known and turning == {graph.spins.get(link)}:
                yield link, pole


def involved(relation: Relation, graph: Graph) -> tuple[str, ...]:
    """Return the wheels, the link, or the point that a relation holds for."""
    if relation.rule is Rule.MESH and isinstance(joint := _joint_of(relation, graph), WheelPair):
        return joint.bodies
    return (relation.link or relation.points[0],)


def _joint_of(relation: Relation, graph: Graph) -> Joint:
    """Return the joint that demands a relation."""
    return graph.pose.mechanism.joint(relation.joint)
