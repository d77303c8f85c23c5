"""Remarks on what moves or acts and is part of no result: loose bodies, loads without work."""

from collections.abc import Iterable, Iterator, Sequence

from ..diagnostics import Diagnostic, Report, syntax
from ..diagnostics import power as messages
from ..formula.walk import symbols
from ..kinematics.graph import SpeedKind
from ..model.mechanism import (
    Contact,
    Feed,
    Find,
    Link,
    Load,
    LoadRatio,
    Mechanism,
    ResultTarget,
    Slider,
    SpeedRatio,
    WithFriction,
)
from ..model.result import Result
from .balance import Balance, PowerEquations
from .loads import at_rest, held_drives
from .problem import PowerProblem

LISTED_PARTS = 3
"""Parts that a hint names."""


def looseness(mechanism: Mechanism) -> str:
    """Return the advice to join what is apart, or hangs on one pin alone; '' where nothing does."""
    apart = _apart(mechanism)
    if len(apart) > 1:
        return f"join {_named(apart[0])} to {_named(apart[1])}: nothing does"
    for link in mechanism.links:
        joints = [p for p in link.points if _joined(p, link.name, mechanism)]
        on_the_ground = not mechanism.fixed.isdisjoint(joints)
        if len(joints) < 2 and not on_the_ground and not _held_otherwise(link.name, mechanism):
            where = f"pin {joints[0]} alone" if joints else "nothing"
            return f"hold link {link.name}, which hangs on {where}"
        if _turns_on_its_guide(link, mechanism):
            return f"keep link {link.name} from turning on its guide by `slide {link.name} along …`"
    return ""


def _turns_on_its_guide(link: Link, mechanism: Mechanism) -> bool:
    """Return whether a guide and one contact alone hold a link, of which neither keeps its turn."""
    others = {p for body in mechanism.rigid_bodies if body.name != link.name for p in body.points}
    own = [
        j for j in mechanism.joints if isinstance(j, Slider | Contact) and j.point in link.points
    ]
    is_joined = not others.union(mechanism.fixed).isdisjoint(link.points)
    guides = sum(isinstance(joint, Slider) for joint in own)
    is_met = is_joined or any(link.name in j.bodies for j in mechanism.joints if j not in own)
    return guides == 1 and len(own) == 2 and not is_met


def _named(parts: Sequence[str]) -> str:
    if len(parts) > LISTED_PARTS:
        return f"{parts[0]} and its neighbours"
    return syntax.listed(parts, "and")


def _apart(mechanism: Mechanism) -> list[list[str]]:
    """Return the groups of moving parts that no pin, slot, contact or wheel joins."""
    groups: list[tuple[set[str], list[str]]] = []
    for name, keys in _parts(mechanism):
        met = [group for group in groups if group[0] & keys]
        merged = set(keys).union(*(group[0] for group in met))
        names = [n for group in met for n in group[1]]
        groups = [group for group in groups if group not in met]
        groups.append((merged, [*names, name] if name else names))
    return [names for _, names in groups if names]


def _parts(mechanism: Mechanism) -> Iterable[tuple[str, set[str]]]:
    """Yield moving parts by the points and bodies that they are one with, then what joins them."""
    carried = {p for body in mechanism.rigid_bodies for p in body.points}
    for body in mechanism.links:
        yield f"link {body.name}", {*body.points, f"link {body.name}"} - mechanism.fixed
    for slide in mechanism.slides:
        yield f"slide {slide.name}", {*slide.points, f"link {slide.name}"}
    for joint in mechanism.joints:
        is_part = isinstance(joint, Slider) and joint.point not in carried
        name = f"slider {joint.points[0]}" if is_part else ""
        yield name, {*joint.points, *(f"link {body}" for body in joint.bodies)} - mechanism.fixed


def _joined(point: str, link: str, mechanism: Mechanism) -> bool:
    """Return whether anything but a load holds a link at a point."""
    at = {held for joint in mechanism.joints for held in joint.held}
    others = (b for b in mechanism.rigid_bodies if b.name != link)
    at |= {p for body in others for p in body.points}
    return point in at | mechanism.shared


def _held_otherwise(link: str, mechanism: Mechanism) -> bool:
    """Return whether a slot or a face of the link itself, or a wheel, holds it."""
    holding = (joint for joint in mechanism.joints if not isinstance(joint, Feed))
    return any(link in joint.bodies for joint in holding)


def warn_of_idle_motions(problem: PowerProblem) -> None:
    """Name what the idle motions are measured by: links that turn, points that move."""
    mechanism, idle = problem.mechanism, problem.equations.idle_motions
    asks_for_loads = any(not isinstance(f.target, SpeedRatio) for f in mechanism.finds)
    if not idle or not asks_for_loads:
        return
    plan = problem.plan
    drives = [plan.graph.unknowns[plan.drives[i]] for i in idle]
    spans = {f"link {k.name}": k.span for k in mechanism.links}
    spans |= {f"point {p}": span for p, span in mechanism.spans.items()}
    named = [f"{'link' if d.kind is SpeedKind.SPIN else 'point'} {d.of}" for d in drives]
    what = sorted(dict.fromkeys(named), key=lambda name: spans[name])
    problem.report.add(messages.idle_freedom(spans[what[0]], what))


def refuse_unbalanced(problem: PowerProblem) -> None:
    """Report E544 where all that acts does work, and balances only where it is zero.

    Where rounding alone keeps loads from balancing nothing follows from them: E546.
    """
    finds = (f for f in problem.mechanism.finds if not isinstance(f.target, SpeedRatio))
    of_forces = [f for f in finds if not _is_of_tied(f.target, problem.equations)]
    if not of_forces:
        return
    if problem.balances_at_zero_alone and not problem.equations.idle_loads:
        problem.report.add(unbalanced(problem, of_forces[0]))
    elif problem.cancels_but_for_rounding:
        working = [k.name for k in _working(problem)]
        problem.report.add(messages.balanced_but_for_rounding(of_forces[0].span, working))
    problem.report.stop_on_errors()


def _is_of_tied(target: ResultTarget | None, equations: PowerEquations) -> bool:
    """Return whether a result is a ratio of loads tied to each other, which the tie gives."""
    match target:
        case LoadRatio(above, below):
            return equations.owner(above)[0] == equations.owner(below)[0]
        case _:
            return False


def unbalanced(problem: PowerProblem, find: Find) -> Diagnostic:
    """Return E544: nothing balances the loads that do work."""
    working = _working(problem)
    tied = [k.name for k in working if k.tie is not None]
    return messages.nothing_balances(find.span, [k.name for k in working], tied)


def _working(problem: PowerProblem) -> list[Load]:
    """Return the loads that do work, each by itself or with what it is tied to."""
    equations = problem.equations
    return [k for k in problem.mechanism.loads if equations.owner(k.name)[0] in equations.columns]


def warn_of_idle_loads(balance: Balance, results: Sequence[Result], report: Report) -> None:
    """Warn of loads without work that no result has, but not in a frame.

    With friction a load without work may press a joint: all results have to be known.
    """
    mechanism = balance.plan.graph.pose.mechanism
    if not balance.plan.mobility:
        return
    shown = [let.value for let in mechanism.lets]
    for result in results:
        shown += [result.formula, *(d.formula for d in result.where)]
    seen = {name for formula in shown for name in symbols(formula)}
    overcome = {load for result in results for load in _overcome(result)}
    spans = {load.name: load.span for load in mechanism.loads}
    held = held_drives(mechanism)
    for name in balance.equations.idle_loads:
        if name in seen - overcome and not held:
            _warn_of_zero_ratios(name, mechanism, report)
        elif name not in seen | overcome:
            rest = next(at_rest(k, mechanism) for k in mechanism.loads if k.name == name)
            report.add(messages.load_does_no_work(spans[name], name, held, rest))


def _overcome(result: Result) -> Iterator[str]:
    """Yield the load below the line of a ratio with friction that is not zero, as of a brake."""
    match result.target:
        case WithFriction(of=LoadRatio(below=load)) if result.default:
            yield load


def _warn_of_zero_ratios(load: str, mechanism: Mechanism, report: Report) -> None:
    """Warn of each ratio to a load that does no work, and is asked for by reactions alone."""
    for find in mechanism.finds:
        if isinstance(find.target, LoadRatio) and find.target.below == load:
            report.add(messages.result_zero(find.span, find.name, load))
