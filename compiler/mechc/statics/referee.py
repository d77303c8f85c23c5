"""The referee: every result against the equilibrium of the free bodies, pose by pose.

It compares at the default pose and at three random feasible ones. A disagreement is a bug
in mechc, whatever was written: nothing may be emitted then.
"""

import math
from collections.abc import Iterable, Iterator
from itertools import islice

from ..base.named import NamedTuple
from ..diagnostics import Diagnostic, MechcError, Report
from ..diagnostics import statics as messages
from ..formula.numeric.rounding import Rounding
from ..model.result import Result
from ..model.values import defaults
from ..pose.pose import Pose
from ..source import Span
from ..work import Allowance, WorkLimitError, most_of_what_is_left, within_part
from . import counted, surfaces
from .answers import Answer
from .balanced import Balanced
from .contacts import pulling, slack
from .geometry_check import worst_gap
from .poses import Replay, Values, broken_at_default, candidates, free_values, varies
from .questions import Question, questions
from .tolerances import SINGULAR_CONDITION, SMALLEST
from .verdict import (
    NEAR_SINGULAR,
    NO_MORE,
    NO_VALUE,
    STANDS,
    TOO_MUCH,
    UNSETTLED,
    Trial,
    Untried,
    Verdict,
)

CHECKED_POSES = 4
"""How many poses a result is checked at, where there are others than the default one."""

POSE_DRAWS = 40
"""How many poses are drawn, at most, to find them."""


class RefereeDisagrees(MechcError):
    """Virtual power and statics give different answers: a bug in mechc, not in the description."""

    def __init__(self, report: Report, verdict: Verdict) -> None:
        super().__init__(report.sorted(), report.source)
        self.verdict = verdict


class CrossChecked(NamedTuple):
    """The trials of one question, and why other poses were passed over."""

    trials: tuple[Trial, ...]
    troubles: tuple[str, ...]


def cross_check(pose: Pose, results: tuple[Result, ...], report: Report) -> Verdict:
    """Return the verdict on all results that ask for a ratio or for a load.

    Raises :class:`RefereeDisagrees` where the two methods differ by more than the
    condition of the pose explains, where virtual power has an answer at every pose and
    equilibrium at none, or where the pose does not fit the description. A result that no
    pose can decide earns a warning.
    """
    poses, wanted = Replay(candidates(pose, POSE_DRAWS)), CHECKED_POSES if varies(pose) else 1
    _measure(pose, poses, report)
    balanced = Replay(Balanced(pose, values) for values in poses)
    for at in islice(balanced, 1):
        _check_contacts(results, at, report)
    trials: list[Trial] = []
    remarks: list[Untried] = []
    part = most_of_what_is_left()
    for question in questions(results, pose.mechanism):
        checked = _cross_check(question, iter(balanced), wanted, part)
        trials.extend(checked.trials)
        _remark_on(question, checked, pose, report)
        if len(checked.trials) < wanted:
            remarks.append(_untried(question.name, checked, wanted))
    if remarks and next(iter(poses), None) is None:
        report.add(_nothing_checked(pose, report))
    verdict = Verdict(tuple(trials), tuple(remarks))
    _stop_on_disagreement(verdict, pose.mechanism.span, report)
    return verdict


def _check_contacts(results: tuple[Result, ...], at: Balanced, report: Report) -> None:
    """Report bodies in contact that pull, ropes that push, and friction that acts at no pin."""
    for fault in pulling(results, at):
        report.add(fault)
    _refuse_slack(slack(results, at), at.pose, report)
    if at.pose.mechanism.friction.everywhere:
        _count_pins(at, report)


def _remark_on(question: Question, checked: CrossChecked, pose: Pose, report: Report) -> None:
    """Warn of an answer that is one of several, and of a question without a trial."""
    if one := next((trial for trial in checked.trials if trial.is_one_of_several), None):
        report.add(_one_of_several(one, pose))
    if checked.troubles and not checked.trials:
        is_fixed = all(p.dependent for p in pose.mechanism.parameters)
        report.add(_unchecked(question.name, checked.troubles, pose.mechanism.span, is_fixed))


def _refuse_slack(faults: Iterable[Diagnostic], pose: Pose, report: Report) -> None:
    """Report ropes that push; that an arrow is to be turned is not known before their falls are."""
    for fault in faults:
        report.add(fault)
        for find in pose.mechanism.finds:
            report.withdraw("W502", find.span)


def _measure(pose: Pose, poses: Iterable[Values], report: Report) -> None:
    """See that the mechanism stands as described at the poses that are checked first."""
    gaps = (worst_gap(pose, values) for values in islice(poses, CHECKED_POSES))
    gap = next((gap for gap in gaps if gap is not None), None)
    if gap is not None:
        report.add(messages.pose_does_not_close(pose.mechanism.span, gap.what, gap.size))


def _count_pins(at: Balanced, report: Report) -> None:
    """See that friction acts at every pin where it is said to act."""
    at_pins = ((p.on, p.actions) for p in surfaces.pairs_of(at) if p.kind == "pin")
    for pin in counted.uncounted(at, at_pins):
        report.add(messages.friction_not_counted(at.pose.mechanism.span, pin))


def _cross_check(
    question: Question, poses: Iterator[Balanced], wanted: int, part: Allowance
) -> CrossChecked:
    """Try poses until enough of them give an answer by both methods, or the part is used up."""
    trials: list[Trial] = []
    troubles: list[str] = []
    for at in poses:
        trial = _try_within(part, question, at)
        if isinstance(trial, Trial):
            trials.append(trial)
        else:
            troubles.append(trial)
        if len(trials) == wanted or part.left < 0:
            break
    return CrossChecked(tuple(trials), tuple(troubles))


def _try_within(part: Allowance, question: Question, at: Balanced) -> Trial | str:
    try:
        with within_part(part):
            return _try(question, at)
    except WorkLimitError:
        if part.left >= 0:
            raise
        return TOO_MUCH


def _try(question: Question, at: Balanced) -> Trial | str:
    """Return both answers at one pose, or the reason that they cannot be compared there."""
    power = _evaluate(question, at)
    if not math.isfinite(power):
        return NO_VALUE
    first = _compared(question, at, power, question.ask(at))
    if first != UNSETTLED and (isinstance(first, str) or first.agrees):
        return first
    others = (_compared(question, at, power, other) for other in question.others(at))
    same = next((o for o in others if isinstance(o, Trial) and o.agrees), None)
    return same._replace(is_one_of_several=True) if same else first


def _compared(question: Question, at: Balanced, power: float, answer: Answer) -> Trial | str:
    """Return both answers, or why they do not do."""
    if answer.trouble:
        return answer.trouble
    if power and answer.condition > SINGULAR_CONDITION:
        if not _is_rounding(question, at):
            return NEAR_SINGULAR
        power = 0.0
    size, condition = max(abs(power), abs(answer.value)), answer.condition
    if not power:  # what is zero is off by a part of what it was made of
        size, condition = answer.influence, 1.0
    error = abs(power - answer.value) / max(size, SMALLEST)
    trial = Trial(question.name, dict(at.values), power, answer.value, error, condition)
    return answer.doubt if answer.doubt and not trial.agrees else trial


def _evaluate(question: Question, at: Balanced) -> float:
    found = at.formulas(question.where)
    if not all(found.of(g.left) > found.of(g.right) for g in question.guards):
        return math.nan
    return found.of(question.formula)


def _is_rounding(question: Question, at: Balanced) -> bool:
    """Return whether nothing is left of the answer of virtual power but rounding.

    A load between two points of one rigid part does no work, though that part is several links.
    """
    rounding = Rounding({name: at.values[name] for name in at.pose.free if name in at.values})
    rounding.define(at.pose.definitions)
    missing = {n: v for n, v in at.values.items() if n not in rounding.values}
    rounding.values.update(Rounding(missing).values)
    rounding.define(question.where)
    return rounding.of(question.formula).is_zero


def _one_of_several(trial: Trial, pose: Pose) -> Diagnostic:
    span = next(f.span for f in pose.mechanism.finds if f.name == trial.result)
    given = defaults(pose.mechanism).items()
    is_default = all(trial.values.get(name) == value for name, value in given)
    place = {} if is_default else free_values(pose, trial.values)
    return messages.several_balances(span, trial.result, trial.power, place)


def _untried(name: str, checked: CrossChecked, wanted: int) -> Untried:
    last = checked.troubles[-1] if checked.troubles else NO_MORE
    return Untried(name, len(checked.trials), wanted, last)


def _unchecked(name: str, troubles: tuple[str, ...], span: Span, is_fixed: bool) -> Diagnostic:
    """Return a warning, or an error where only equilibrium failed, and at every pose.

    Where the mechanism ``is_fixed`` there is no parameter that could have another value.
    """
    if not {NO_VALUE, NEAR_SINGULAR, STANDS, UNSETTLED, TOO_MUCH} & set(troubles):
        return messages.no_equilibrium(span, name, troubles[-1])
    return messages.not_checked(span, name, troubles[-1], is_fixed)


def _nothing_checked(pose: Pose, report: Report) -> Diagnostic:
    """Return the warning that no pose was found, at a condition that the default one breaks.

    It stands instead of that on the default pose, W221, and has its words.
    """
    if broken := broken_at_default(pose):
        why = "no pose was found that meets the conditions of use"
        if noted := report.withdraw("W221", broken.span):
            why = f"{why}; {noted.message}"
        return messages.not_checked(broken.span, "what is asked for", why)
    return messages.not_checked(pose.mechanism.span, "what is asked for", "no pose was found")


def _stop_on_disagreement(verdict: Verdict, span: Span, report: Report) -> None:
    for trial in verdict.trials:
        if not trial.agrees:
            report.add(messages.methods_disagree(span, trial.result, trial.power, trial.statics))
            break
    if any(d.code in messages.BUGS for d in report.diagnostics):
        raise RefereeDisagrees(report, verdict)
