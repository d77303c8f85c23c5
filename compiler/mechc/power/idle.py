"""Remarks on what the power equations do not see: loads without work, motions without load."""

from collections.abc import Iterable

from ..diagnostics import power as messages
from ..formula.walk import symbols
from ..kinematics.graph import Kind
from ..model.mechanism import SpeedRatio
from .balance import Solved
from .problem import Problem


def warn_of_idle_motions(problem: Problem) -> None:
    """Name what the idle motions are measured by: links that turn, points that move."""
    mechanism, idle = problem.mechanism, problem.equations.idle_motions
    asks_for_loads = any(not isinstance(f.target, SpeedRatio) for f in mechanism.finds)
    if not idle or not asks_for_loads:
        return
    plan = problem.plan
    drives = [plan.graph.unknowns[plan.drives[i]] for i in idle]
    spans = {f"link {k.name}": k.span for k in mechanism.links}
    spans |= {f"point {p}": span for p, span in mechanism.spans.items()}
    named = [f"{'link' if d.kind is Kind.SPIN else 'point'} {d.of}" for d in drives]
    what = sorted(dict.fromkeys(named), key=lambda name: spans[name])
    problem.report.add(messages.idle_freedom(spans[what[0]], what))


def warn_of_idle_loads(problem: Problem, solved: Iterable[Solved]) -> None:
    """Warn of loads without work, but not in a frame, nor where friction or a find has them."""
    mechanism = problem.mechanism
    if mechanism.friction.joints or not problem.plan.mobility:
        return
    shown = [let.value for let in mechanism.lets]
    for result in (one.result for one in solved):
        shown += [result.formula, *(d.formula for d in result.where)]
    seen = {name for formula in shown for name in symbols(formula)}
    for name in problem.equations.idle_loads:
        if name not in seen:
            at = problem.loads[name].span
            problem.report.add(messages.load_does_no_work(at, name, problem.held_drives))
