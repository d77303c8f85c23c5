"""Remarks on what the power equations do not see: loads without work, motions without load."""

from collections.abc import Iterator, Sequence

from ..diagnostics import Report
from ..diagnostics import power as messages
from ..formula.walk import symbols
from ..kinematics.graph import Kind
from ..model.mechanism import LoadRatio, SpeedRatio, WithFriction
from ..model.result import Result
from .balance import Balance
from .loads import at_rest, held_drives
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
    seen |= {load for result in results for load in _overcome(result)}
    spans = {load.name: load.span for load in mechanism.loads}
    for name in balance.equations.idle_loads:
        if name not in seen:
            rest = next(at_rest(k, mechanism) for k in mechanism.loads if k.name == name)
            held = held_drives(mechanism)
            report.add(messages.load_does_no_work(spans[name], name, held, rest))


def _overcome(result: Result) -> Iterator[str]:
    """Yield the load below the line of a ratio with friction that is not zero, as of a brake."""
    match result.target:
        case WithFriction(of=LoadRatio(below=load)) if result.default:
            yield load
