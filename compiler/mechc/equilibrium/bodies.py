"""What acts on every link and pin that is cut free, one half or branch of equal ones.

A rod that nothing acts on between its pins passes a force along itself. A pin that one
body alone carries is part of it; where several meet, the first carries the pin and the
others are held by two components. The ground is cut off at each body by itself. What equal
parts share is balanced along the line of symmetry alone, each part counted as often as
there are such parts.
"""

from collections.abc import Iterable, Iterator, Mapping

from ..algebra.angle import Angle
from ..base.named import NamedTuple
from ..model.mechanism import Mechanism
from ..pose.pose import Pose, Vector
from .actions import Action, Cutting, FreeBody, cutting, lines_of
from .equilibrium import JointForce
from .exerted import Exerted, by_joints, by_loads


class Cut(NamedTuple):
    """All free bodies, what acts on the ground at each pivot, and the forces between them."""

    bodies: tuple[FreeBody, ...]
    ground: Mapping[str, tuple[Action, ...]]
    forces: tuple[JointForce, ...]


def cut_free(pose: Pose) -> Cut:
    """Return every body of a mechanism, or of one of its equal parts, cut free."""
    cut = cutting(pose)
    exerted = tuple(_named_apart(by_joints(cut), pose.mechanism))
    forces = tuple(each.force for each in exerted)
    actions: dict[str, list[Action]] = {name: [] for name in cut.rigid}
    for body, action in (*(action for each in exerted for action in each.actions), *by_loads(cut)):
        actions.setdefault(body, []).append(action)
    rods = {f.names[0]: f.subject[0] for f in forces if f.kind == "rod"}
    fixed = pose.mechanism.fixed
    bodies = (_free_body(name, actions[name], rods, cut) for name in actions if name not in fixed)
    return Cut(tuple(bodies), {p: tuple(actions.get(p, ())) for p in fixed}, forces)


def _named_apart(exerted: Iterable[Exerted], mechanism: Mechanism) -> Iterator[Exerted]:
    """Yield what joints exert under names that neither parameters, loads nor others have."""
    taken = {p.name for p in mechanism.parameters} | {load.name for load in mechanism.loads}
    for force, actions in exerted:
        free: dict[str, str] = {}
        for name in force.names:
            unused = name
            while unused in taken:
                unused += "_"
            taken.add(unused)
            free[name] = unused
        renamed = tuple((body, action._replace(name=free[action.name])) for body, action in actions)
        yield Exerted(force._replace(names=tuple(free.values())), renamed)


def _free_body(name: str, actions: list[Action], rods: Mapping[str, str], cut: Cutting) -> FreeBody:
    """Return a body with what acts on it, and the sums that may be written for it."""
    pose, mechanism = cut.pose, cut.mechanism
    points = cut.rigid.get(name, (name,))
    on_it = {a.name: rods[a.name] for a in actions if a.name in rods}
    guide = pose.slides[name] if name in pose.slides else pose.guides.get(name)
    frame: Mapping[str, Vector] = {}
    if any(group.shares(points) for group in mechanism.symmetries):
        line = _line_of_symmetry(cut)
        lines = [] if line is None else [line]
    elif name in pose.slides:
        lines = [pose.slides[name]]
    else:
        frame = pose.frames[name] if name in cut.rigid else {}
        lines = list(lines_of(actions, guide))
    return FreeBody(name, tuple(actions), frame, tuple(lines), guide, on_it)


def _line_of_symmetry(cut: Cutting) -> Angle | None:
    """Return the line along which what equal parts share can move."""
    if cut.pose.axis is not None:
        return cut.pose.axis
    shared = cut.mechanism.shared
    return next((g for p, g in cut.pose.guides.items() if p in shared), None)
