"""The forces at joints that are asked for, as forces between free bodies or as sums of those."""

from collections.abc import Iterable, Mapping

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import ONE, Product
from ..algebra.trigonometry import cosine
from ..base.frozen import replace
from ..kinematics.joint_refs import held_end
from ..model.mechanism import Axial, Mechanism, Normal, Reaction
from ..model.parts.targets import ResultTarget
from ..pose.pose import Arm, Pose, Vector
from .actions import Action, FreeBody, X, Y, part_along, summed, unit
from .bodies import Cut
from .equilibrium import EquilibriumSum

AXES = {"x": X, "y": Y}


def force_between(target: ResultTarget | None, cut: Cut, pose: Pose) -> str:
    """Return the name that a force at a joint has on free bodies, '' where it is none of theirs."""
    place = 0
    match target:
        case Reaction(point, "", "x" | "y" as part):
            subjects, place = _alone_at(point, pose.mechanism), "xy".index(part)
        case Axial(link) if rope := next((r for r in pose.mechanism.ropes if r.id == link), None):
            subjects = [("rope", rope.route[0])]
        case Axial(link):
            subjects = [("rod", link)]
        case Normal(point):
            bodies = [body.name for body in pose.mechanism.bodies]
            subjects = [("guide", point), *(("contact", point, body) for body in bodies)]
        case _:
            return ""
    found = [f.names[place] for f in cut.forces if (f.kind, *f.subject[:2]) in subjects]
    return found[0] if len(found) == 1 else ""


def _alone_at(pivot: str, mechanism: Mechanism) -> list[tuple[str, ...]]:
    """Return the body that alone is held by a pivot, as the subject of the force there."""
    bodies = [body for body in mechanism.bodies if pivot in body.points]
    joints = [joint for joint in mechanism.joints if pivot in joint.points]
    loads = [load for load in mechanism.loads if pivot in load.points]
    is_alone = len(bodies) == len(joints) == 1 and not loads and pivot not in mechanism.shared
    return [("pivot", bodies[0].name, pivot)] if is_alone else []


def made_up(target: ResultTarget | None, name: str, cut: Cut, pose: Pose) -> EquilibriumSum | None:
    """Return a component of a force at a joint as the sum of what acts there, None without one."""
    match target:
        case Reaction(point, link, "x" | "y" as part):
            actions = _on_link(link, point, cut, pose) if link else _of_ground(point, cut, pose)
            lines = _components(AXES[part], point, link, pose)
        case Axial(link) if link in pose.frames:
            point = held_end(pose.mechanism, pose.mechanism.link(link))
            actions = _on_link(link, point, cut, pose)
            lines = None if _is_shared(point, link, pose) else _outwards(link, point, pose)
        case _:
            return None
    if actions is None or lines is None:
        return None
    parts = [
        (action.name, part_along(action, arm.angle) * arm.length)
        for action in actions
        for arm in lines
    ]
    terms = {name: Product(-1), **summed(parts)}
    return EquilibriumSum(link, terms, along=lines[0].angle, pin=point)


def _components(axis: Angle, point: str, link: str, pose: Pose) -> Vector | None:
    """Return along what a component counts; of what mirrored halves share only along their axis.

    None where equal branches share it: they are turned against each other in space.
    """
    if not _is_shared(point, link, pose):
        return (Arm(ONE, axis),)
    return None if pose.axis is None else (Arm(cosine(pose.axis - axis), pose.axis),)


def _outwards(link: str, point: str, pose: Pose) -> Vector:
    """Return the unit vector of a link of two pins towards one of them."""
    other = next(p for p in pose.mechanism.link(link).points if p != point)
    return unit(pose.vector(link, other, point))


def _on_link(link: str, point: str, cut: Cut, pose: Pose) -> tuple[Action, ...] | None:
    """Return the forces that act on a link through a pin."""
    body = next((b for b in cut.bodies if b.name == link), None)
    if body is not None:
        return tuple(action for action in body.actions if action.pin == point)
    rod = next((f for f in cut.forces if (f.kind, f.subject[0]) == ("rod", link)), None)
    if rod is None:
        return None
    tail, head = pose.mechanism.link(link).points
    pull = 1 if point == head else -1
    return tuple(
        Action(rod.names[0], part.scaled(pull), along)
        for part, along in unit(pose.vector(link, tail, head))
    )


def _of_ground(point: str, cut: Cut, pose: Pose) -> tuple[Action, ...] | None:
    """Return the force of the ground at a pivot or a guide; None where a whole body is guided."""
    if point in pose.mechanism.fixed:
        return tuple(action._replace(size=-action.size) for action in cut.ground[point])
    guides = [f for f in cut.forces if (f.kind, *f.subject) == ("guide", point)]
    return tuple(Action(f.names[0], ONE, pose.guides[point] + QUARTER) for f in guides) or None


def _is_shared(point: str, link: str, pose: Pose) -> bool:
    """Return whether equal parts share what a force acts on."""
    points = pose.frames[link] if link else (point,)
    return any(group.shares(points) for group in pose.mechanism.symmetries)


def called(cut: Cut, names: Mapping[str, str]) -> Cut:
    """Return the free bodies with forces under the names of what was asked for."""

    def named(actions: Iterable[Action]) -> tuple[Action, ...]:
        return tuple(
            action._replace(name=names.get(action.name, action.name)) for action in actions
        )

    def rods(body: FreeBody) -> dict[str, str]:
        return {names.get(force, force): rod for force, rod in body.rods.items()}

    bodies = (replace(body, actions=named(body.actions), rods=rods(body)) for body in cut.bodies)
    ground = {pivot: named(actions) for pivot, actions in cut.ground.items()}
    forces = (f._replace(names=tuple(names.get(n, n) for n in f.names)) for f in cut.forces)
    return Cut(tuple(bodies), ground, tuple(forces))
