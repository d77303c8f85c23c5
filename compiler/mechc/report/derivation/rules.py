"""The textbook's rule for each relation of the plan, and what it is applied to."""

from collections.abc import Iterator
from typing import assert_never

from ...kinematics.graph import Graph, Relation, SpeedKind
from ...kinematics.graph import Rule as Law
from ...model.mechanism import ArcSlot, Joint, Meshing, WheelPair
from ..kinds import Rule


def rule_of(relation: Relation, graph: Graph) -> tuple[Rule, tuple[str, ...]]:
    """Return the textbook's rule for a relation, and the points and links it is applied to."""
    if arc := graph.pose.mechanism.arc_of(relation.link):
        return _rule_of_circular_slot(relation, arc, graph)
    match relation.rule:
        case Law.PROJECTION:
            return Rule.PROJECTION, relation.points
        case Law.GUIDE:
            return Rule.GUIDE, relation.points
        case Law.ROTATION if graph.spins.get(relation.link) not in relation.form:
            return Rule.PROJECTION, relation.points
        case Law.BODY:
            return Rule.BODY, (relation.link, *relation.points)
        case Law.ROTATION | Law.JOINT | Law.REST:
            return Rule.ROTATION, (relation.link, *relation.points)
        case Law.TURNING:
            return Rule.TURNING, _joint_of(relation, graph).bodies[::-1]
        case Law.SLOT | Law.CONTACT:
            return Rule(relation.rule.value), (*relation.points, relation.link)
        case Law.MESH:
            return _rule_of_mesh(relation, graph)
        case Law.ROPE:
            return Rule.ROPE, relation.points
        case Law.HELD:
            raise ValueError("only a released joint is held, and no step of a motion")
        case _:
            assert_never(relation.rule)


def _rule_of_circular_slot(
    relation: Relation, arc: ArcSlot, graph: Graph
) -> tuple[Rule, tuple[str, ...]]:
    """Return the rule of a relation on the rod that stands for a circular slot: its radius."""
    radius = relation.link
    turns = graph.spins.get(radius) in relation.form
    if relation.rule is Law.PROJECTION or (relation.rule is Law.ROTATION and not turns):
        pin = next(p for p in relation.points if p != arc.centre)
        return Rule.CIRCULAR_SLOT, (radius, pin, arc.link, arc.centre)
    rule = Rule.TURNING_RADIUS if relation.rule is Law.BODY else Rule.RADIUS
    return rule, (radius, *relation.points)


def _rule_of_mesh(relation: Relation, graph: Graph) -> tuple[Rule, tuple[str, ...]]:
    """Return the rule of what meshes and its points, with the link that turns if there is one."""
    joint = _joint_of(relation, graph)
    assert isinstance(joint, Meshing), "no other joint meshes"
    if isinstance(joint, WheelPair) and joint.arm:
        return Rule.ON_ARM, (joint.arm, *relation.points)
    alone = () if len(relation.points) > 1 else (relation.link,)
    return Rule(joint.kind), (*alone, *relation.points)


def rule_of_component(point: str, load: str, graph: Graph) -> tuple[Rule, tuple[str, ...]]:
    """Return the rule for the component of a point's velocity along a load, and its names."""
    velocity = graph.velocities[point]
    if all(graph.unknowns[flow.unknown].kind is SpeedKind.COMPONENT for flow in velocity):
        return Rule.COMPONENT_OF_TWO, (point, load)
    for link, pole in _poles(point, graph):
        if graph.pose.mechanism.arc_of(link):
            continue
        if pole in graph.pose.mechanism.fixed:
            return Rule.COMPONENT_OF_ROTATION, (pole, point, load)
        return Rule.COMPONENT_OF_BODY, (link, pole, point, load)
    return Rule.COMPONENT, (point, load)


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
    if relation.rule is Law.MESH and isinstance(joint := _joint_of(relation, graph), WheelPair):
        return joint.bodies
    return (relation.link or relation.points[0],)


def _joint_of(relation: Relation, graph: Graph) -> Joint:
    """Return the joint that demands a relation."""
    return graph.pose.mechanism.joint(relation.joint)
