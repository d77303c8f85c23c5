"""Loads by the equilibrium of free bodies: cut free, sums written, an order chosen."""

from ..diagnostics import Report
from ..diagnostics import derivation as messages
from ..kinematics.plan import Plan
from ..model.mechanism import LoadForm, LoadRatio
from ..pose.pose import Pose
from ..power.numbers import pose_values
from .balances import balances
from .bodies import Cut, cut_free
from .equilibrium import Equilibrium, Step
from .order import Names, candidates, steps_to


def loads_by_equilibrium(plan: Plan, report: Report) -> tuple[Equilibrium, ...]:
    """Return the steps that lead to each load that is asked for, in the order of the text.

    Reports E731 where none is, E730 of one that nobody would find so by hand.
    """
    pose = plan.graph.pose
    cut = cut_free(pose)
    found = []
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
    if not found:
        raise report.fail(messages.no_load_to_find(pose.mechanism.span, pose.mechanism.name))
    return tuple(found)


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
