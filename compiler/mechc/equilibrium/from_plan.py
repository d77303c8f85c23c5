"""Forces by the equilibrium of free bodies: cut free, sums written, an order chosen."""

from collections.abc import Iterable, Iterator, Sequence

from ..diagnostics import Report
from ..diagnostics import equilibrium as messages
from ..kinematics.plan import Plan
from ..model.mechanism import LoadForm, LoadRatio, ResultTarget
from ..pose.pose import Pose
from ..power.balance import AlgebraicResult
from ..power.numbers import pose_values
from .actions import balances
from .at_joints import called, force_between, made_up
from .bodies import Cut, cut_free
from .equilibrium import Equilibrium, EquilibriumStep, EquilibriumSum
from .order import ForceNames, candidates, steps_to


def by_equilibrium(
    plan: Plan, solved: Sequence[AlgebraicResult], report: Report
) -> tuple[Equilibrium, ...]:
    """Return the steps to each load that is asked for, then to forces at joints.

    Reports E731 where there are none, E730 of a load that nobody would find so by hand. A force at
    a joint is left out there.
    """
    pose = plan.graph.pose
    cut = _with_names(cut_free(pose), pose, solved)
    found: list[Equilibrium] = []
    for find in pose.mechanism.finds:
        match find.target:
            case LoadRatio(load) | LoadForm(load) as target:
                if steps := _steps(pose, cut, load, _known(plan, target)):
                    found.append(_equilibrium(find.name, target, load, cut, steps, pose))
                else:
                    report.add(messages.no_equilibrium_by_hand(find.span, load))
            case _:
                pass
    report.stop_on_errors()
    found += _forces(pose, cut, solved)
    if not found:
        raise report.fail(messages.no_load_to_find(pose.mechanism.span, pose.mechanism.name))
    return tuple(found)


def at_joints(pose: Pose, solved: Sequence[AlgebraicResult]) -> tuple[Equilibrium, ...]:
    """Return the steps to forces at joints, all loads but those that are held being known.

    Left out are those that no sums lead to.
    """
    return tuple(_forces(pose, _with_names(cut_free(pose), pose, solved), solved))


def _with_names(cut: Cut, pose: Pose, solved: Iterable[AlgebraicResult]) -> Cut:
    """Return the free bodies, forces that are asked for under the names of results."""
    asked = ((force_between(one.result.target, cut, pose), one.result.name) for one in solved)
    return called(cut, {force: name for force, name in asked if force})


def _forces(pose: Pose, cut: Cut, solved: Iterable[AlgebraicResult]) -> Iterator[Equilibrium]:
    """Yield the steps to each force at a joint that sums of forces and moments lead to.

    It is an unknown of the free bodies, or a component, the sum of what acts at the joint.
    """
    loads = frozenset(load.name for load in pose.mechanism.loads)
    for found in solved:
        name, target = found.result.name, found.result.target
        if target is None or not found.releases:
            continue
        unknown = force_between(target, cut, pose)
        component = None if unknown else made_up(target, name, cut, pose)
        force = unknown or (component and name)
        known = loads.difference(found.releases[0].held)
        if force and (steps := _steps(pose, cut, force, known, component)):
            yield _equilibrium(name, target, force, cut, steps, pose)


def _known(plan: Plan, target: LoadRatio | LoadForm) -> ForceNames:
    """Return the loads that a load is found from: one per degree of freedom."""
    mechanism = plan.graph.pose.mechanism
    loads = frozenset(load.name for load in mechanism.loads)
    if isinstance(target, LoadForm):
        targets = (find.target for find in mechanism.finds) if plan.mobility > 1 else (target,)
        return loads - {t.load for t in targets if isinstance(t, LoadForm)}
    if plan.mobility > 1:
        return frozenset({target.below, *(k.name for k in mechanism.loads if k.tie is not None)})
    return loads - {target.above}


def _steps(
    pose: Pose, cut: Cut, load: str, known: ForceNames, more: EquilibriumSum | None = None
) -> tuple[EquilibriumStep, ...]:
    sums = [balance for body in cut.bodies for balance in balances(body)]
    sums += [more] if more else []
    values, made_up = pose_values(pose), frozenset(pose.placeholders)
    ground = frozenset(n for f in cut.forces if f.kind in ("pivot", "guide") for n in f.names)
    return steps_to(load, candidates(sums, known, values, made_up), ground)


def _equilibrium(
    result: str,
    target: ResultTarget,
    load: str,
    cut: Cut,
    steps: tuple[EquilibriumStep, ...],
    pose: Pose,
) -> Equilibrium:
    met = {name for step in steps for balance in step.balances for name in balance.terms}
    forces = tuple(force for force in cut.forces if not met.isdisjoint(force.names))
    return Equilibrium(result, target, load, forces, steps, int(pose.mechanism.parts))
