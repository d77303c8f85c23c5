"""Forces by the equilibrium of free bodies: cut free, sums written, an order chosen."""

from collections.abc import Iterator, Sequence

from ..diagnostics import Report
from ..diagnostics import derivation as messages
from ..frozen import replace
from ..kinematics.plan import Plan
from ..model.load_kinds import acts_at
from ..model.mechanism import Axial, LoadForm, LoadRatio, Mechanism, Normal, Reaction
from ..model.targets import Target
from ..pose.pose import Pose
from ..power.balance import Solved
from ..power.numbers import pose_values
from .acts import balances
from .bodies import Cut, cut_free
from .equilibrium import Equilibrium, Step
from .order import Names, candidates, steps_to


def by_equilibrium(plan: Plan, solved: Sequence[Solved], report: Report) -> tuple[Equilibrium, ...]:
    """Return the steps to each load that is asked for, then to forces at joints.

    Reports E731 where there are none, E730 of a load that nobody would find so by hand. A force at
    a joint is left out there, and where free bodies have other components of it.
    """
    pose = plan.graph.pose
    cut = cut_free(pose)
    found: list[Equilibrium] = []
    for find in pose.mechanism.finds:
        match find.target:
            case LoadRatio(load) | LoadForm(load) as target:
                if steps := _steps(pose, cut, load, _known(plan, target)):
                    found.append(_equilibrium(find.name, load, cut, steps, pose))
                else:
                    report.add(messages.no_equilibrium_by_hand(find.span, load))
            case _:
                pass
    report.stop_on_errors()
    found += _forces(pose, cut, solved)
    if not found:
        raise report.fail(messages.no_load_to_find(pose.mechanism.span, pose.mechanism.name))
    return tuple(found)


def _forces(pose: Pose, cut: Cut, solved: Sequence[Solved]) -> Iterator[Equilibrium]:
    """Yield the steps to forces at joints, all loads but those that are held being known."""
    loads = frozenset(load.name for load in pose.mechanism.loads)
    for one in solved:
        force = _force(one.result.target, cut, pose)
        if force and one.releases:
            known = loads.difference(one.releases[0].held)
            if steps := _steps(pose, cut, force, known):
                found = _equilibrium(one.result.name, force, cut, steps, pose)
                yield replace(found, is_at_joint=True)


def _force(target: Target | None, cut: Cut, pose: Pose) -> str:
    """Return the name that a force at a joint has on free bodies, '' where they have none for it.

    The ground exerts what it does on the one body at a pivot; where there are several, or halves
    that share it, each has a force of its own, and so have a rope or a load that end there.
    """
    place = 0
    match target:
        case Reaction(point, "", "x" | "y" as part):
            subjects, place = _alone_at(point, pose.mechanism), "xy".index(part)
        case Axial(link):
            subjects = [("rod", link)]
        case Normal(point):
            bodies = [body.name for body in pose.mechanism.bodies]
            subjects = [("guide", point), *(("touch", point, body) for body in bodies)]
        case _:
            return ""
    found = [f.names[place] for f in cut.forces if (f.kind, *f.subject[:2]) in subjects]
    return found[0] if len(found) == 1 else ""


def _alone_at(pivot: str, mechanism: Mechanism) -> list[tuple[str, ...]]:
    """Return the body that alone is held by a pivot, as the subject of the force there."""
    bodies = [body for body in mechanism.bodies if pivot in body.points]
    joints = [joint for joint in mechanism.joints if pivot in joint.points]
    loads = [load for load in mechanism.loads if acts_at(pivot, load)]
    is_alone = len(bodies) == len(joints) == 1 and not loads and pivot not in mechanism.shared
    return [("pivot", bodies[0].name, pivot)] if is_alone else []


def _known(plan: Plan, target: LoadRatio | LoadForm) -> Names:
    """Return the loads that a load is found from: one per degree of freedom."""
    mechanism = plan.graph.pose.mechanism
    loads = frozenset(load.name for load in mechanism.loads)
    if isinstance(target, LoadForm):
        targets = (find.target for find in mechanism.finds) if plan.mobility > 1 else (target,)
        return loads - {t.load for t in targets if isinstance(t, LoadForm)}
    if plan.mobility > 1:
        return frozenset({target.below, *(k.name for k in mechanism.loads if k.tie is not None)})
    return loads - {target.above}


def _steps(pose: Pose, cut: Cut, load: str, known: Names) -> tuple[Step, ...]:
    sums = (balance for body in cut.bodies for balance in balances(body))
    values, made_up = pose_values(pose), frozenset(pose.placeholders)
    ground = frozenset(n for f in cut.forces if f.kind in ("pivot", "guide") for n in f.names)
    return steps_to(load, candidates(sums, known, values, made_up), ground)


def _equilibrium(
    result: str, load: str, cut: Cut, steps: tuple[Step, ...], pose: Pose
) -> Equilibrium:
    met = {name for step in steps for balance in step.balances for name in balance.terms}
    forces = tuple(force for force in cut.forces if not met.isdisjoint(force.names))
    return Equilibrium(result, load, forces, steps, int(pose.mechanism.parts))
