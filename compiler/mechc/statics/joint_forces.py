"""Forces at joints out of the equations of equilibrium."""

import math
from collections.abc import Mapping, Set

from ..model.mechanism import Axial, ForceAtJoint, Normal, Reaction
from .answers import Answer, combination, one_of, unknown_bases
from .assembly import Plane
from .balanced import Balanced
from .equations import EquilibriumSystem, UnknownForce
from .unfold import Unfolding

Weights = Mapping[int, float]
"""A force as a combination of the unknowns of a system, by their columns."""


def joint_force(at: Balanced, target: ForceAtJoint, given: str, known: Set[str]) -> Answer:
    """Return a force at a joint where ``given`` is 1 and the rest of ``known`` loads are 0."""
    unknown, right = unknown_bases(at, at.tied[given], known), one_of(at, at.tied[given])
    parts = []
    for weights in wanted_of(target, at, at.system):
        last = next(iter(weights)) if len(weights) == 1 else None
        factors, _ = at.eliminated(unknown, last)
        parts.append(combination(at.system, factors, right, weights))
    if len(parts) == 1:
        return parts[0]
    trouble = next((p.trouble for p in parts if p.trouble), "")
    size = math.hypot(*(p.value for p in parts))
    return Answer(size, sum(p.influence for p in parts), trouble)


def wanted_of(
    target: ForceAtJoint, unfolding: Unfolding, system: EquilibriumSystem
) -> tuple[Weights, ...]:
    """Return a force as a combination of unknowns, or both components of one whose size counts."""
    axes = {"x": Plane(1.0, 0.0), "y": Plane(0.0, 1.0)}
    match target:
        case Reaction(point, link, part):
            asked = [axes[part]] if part in axes else list(axes.values())
            return tuple(_on_link_or_point(system, unfolding, point, link, a) for a in asked)
        case Axial(link) if link in {rope.id for rope in unfolding.pose.mechanism.ropes}:
            by = next(i for i, unknown in enumerate(system.unknowns) if unknown.by == link)
            return ({by: 1.0},)
        case Axial(link, tail, head):
            end, other = (tail, head) if _is_loaded(link, head, unfolding) else (head, tail)
            arm = unfolding.arm(link, other, end)
            along = arm.times(1 / math.hypot(*arm))
            return (_on_link_or_point(system, unfolding, end, link, along),)
        case Normal(point):
            return (_normal(system, unfolding, point),)


def _is_loaded(link: str, point: str, unfolding: Unfolding) -> bool:
    """Return whether a load acts on a link itself at a point, so that a pin gives not all of it."""
    return any((link, point) in load.ends for load in unfolding.pose.mechanism.loads)


def _on_link_or_point(
    system: EquilibriumSystem, unfolding: Unfolding, point: str, link: str, along: Plane
) -> Weights:
    """Return a component of the force on a link at a point, or of the ground on the point."""
    weights: dict[int, float] = {}
    for column, (by, on, component) in enumerate(system.unknowns):
        match component:
            case "x" | "y" if on == point and by == (link or "ground"):
                part = along.x if component == "x" else along.y
                weights[column] = -part if link else part
            case "normal" if on == point and by == "guide" and not link:
                normal = unfolding.direction_of_guide(point).turned()
                weights[column] = normal.dot(along)
            case "tension" if by == link:
                tail, head = unfolding.pose.frames[link]
                arm = unfolding.arm(link, tail, head)
                share = arm.dot(along) / math.hypot(*arm)
                weights[column] = share if point == head else -share
    return weights


def _normal(system: EquilibriumSystem, unfolding: Unfolding, point: str) -> Weights:
    """Return the force of a contact or slot, else that of a guide on the point or its slide."""
    held = {point, *(s.name for s in unfolding.pose.mechanism.slides_at(point))}

    def fits(unknown: UnknownForce) -> bool:
        return unknown.on in held and unknown.component in ("slot", "contact", "normal")

    touching = [i for i, u in enumerate(system.unknowns) if fits(u)]
    kinds = {system.unknowns[i].component: i for i in touching}
    return {next(kinds[kind] for kind in ("contact", "slot", "normal") if kind in kinds): 1.0}
