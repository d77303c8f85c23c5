"""How friction comes into a result, body after body, as a teacher would write it."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from typing import assert_never

from ..formula.tree import Call, Formula, Sum, Symbol, product, total
from ..formula.walk import symbols
from ..frozen import replace
from ..model.mechanism import LoadForm, LoadRatio, Reaction, WithFriction
from ..power.balance import Balance, Solved
from ..power.friction.steps import Step
from .steps import Account, Equation, Passage, Saying
from .wording import positive_first

_LINES: Mapping[str, Saying] = {
    "crossed": Saying.CROSSED,
    "outer": Saying.OUTER,
    "parallel": Saying.PARALLEL,
    "single": Saying.SINGLE,
    "face": Saying.FACE,
}

_ONCE = {*_LINES, "iterated"}
"""Steps that are the same for all results."""

_FIRST_ORDER = {"force": Symbol("r"), "turn": Symbol("Omega"), "speed": Symbol("v")}
_CHANGES = product([(Symbol("D"), 1), (Symbol("n"), 1)])
_ITERATED = {
    "sizes": Symbol("n"),
    "parts": Symbol("r"),
    "changes": _CHANGES,
    "whole": Call("abs", (total([Symbol("r"), _CHANGES]),)),
}


def of_friction(balance: Balance) -> Iterator[Account]:
    """Yield an account of every result with friction that was found in steps."""
    told = _Told()
    for place, group in groupby(balance.solved, _place):
        solved = tuple(group)
        steps = solved[0].steps
        if place is None or not steps:
            continue
        passages = [p for step in steps for p in _passages(step, told.new(step), place)]
        names = tuple(s.result.name for s in solved)
        yield Account(names, (*_opening(place, steps), *passages))


def _place(solved: Solved) -> WithFriction | None:
    """Return what a result with friction is of, the same for all parts of one force."""
    match solved.result.target:
        case WithFriction(Reaction() as force, sense):
            return WithFriction(replace(force, part="size"), sense)
        case WithFriction() as target:
            return target
        case _:
            return None


class _Told:
    """What was told of earlier results, so that nothing is told twice."""

    def __init__(self) -> None:
        self._known: dict[str, Formula] = {}
        self._lines: set[tuple[str, str]] = set()

    def new(self, step: Step) -> list[Equation] | None:
        """Return the definitions of a step that are new; None for a line that was told before."""
        changed: set[str] = set()
        for name, formula in step.defined:
            if self._known.get(name) != formula or changed & symbols(formula):
                changed.add(name)
                self._known[name] = formula
        line = (step.kind, step.body)
        if step.kind in _ONCE and line in self._lines and not changed:
            return None
        self._lines.add(line)
        return [Equation(Symbol(d.name), d.formula) for d in step.defined if d.name in changed]


def _opening(target: WithFriction, steps: Sequence[Step]) -> Iterator[Passage]:
    """Say which way friction acts, and what forces are measured by."""
    if steps[0].kind in ("first order", "iterated"):
        return
    tightens = target.sense == "tightening"
    signs = {"radius": Symbol("rho"), "force": Symbol("S")}
    yield Passage(Saying.TIGHTENING, formulas=signs) if tightens else Passage(Saying.RELEASING)
    if isinstance(target.of, LoadRatio):
        yield Passage(Saying.UNIT, names={"load": (target.of.below,)})


def _passages(step: Step, new: Sequence[Equation] | None, asked: WithFriction) -> Iterator[Passage]:
    """Yield what a step says; the load that is asked for is left to the result."""
    if new is None:
        return
    pairs = (pair for pair in step.equations if pair[0] != _driving(asked))
    equations = [Equation(_ordered(left), right) for left, right in pairs]
    balanced = (*equations[:1], *new, *equations[1:])
    match step.kind:
        case "crossed" | "outer" | "parallel" | "single":
            names = {"link": (step.body,)}
            yield Passage(Saying.PRESSED if step.sense > 0 else Saying.PULLED, names=names)
            yield Passage(_LINES[step.kind], tuple(new), names)
        case "face":
            yield Passage(Saying.FACE, tuple(new), {"point": (step.body,)})
        case "lever":
            turns = {1: Saying.TURNS_LEFT, -1: Saying.TURNS_RIGHT}
            names = {"link": (step.body,), "point": (step.pivot,)}
            yield Passage(turns.get(step.sense, Saying.MOMENTS), balanced, names)
        case "slider":
            yield Passage(Saying.ALONG, balanced, {"point": (step.body,)})
        case "pin":
            yield Passage(Saying.KNEE, (*equations, *new), {"point": (step.body,)})
        case "first order":
            yield Passage(Saying.FIRST_ORDER, (*new, *equations), formulas=_FIRST_ORDER)
        case "iterated":
            yield Passage(Saying.ITERATED, formulas=_ITERATED)
        case _:
            assert_never(step.kind)


def _driving(asked: WithFriction) -> Formula | None:
    """Return the load that a result is of."""
    match asked.of:
        case LoadRatio(above, _):
            return Symbol(above)
        case LoadForm(load):
            return Symbol(load)
        case _:
            return None


def _ordered(side: Formula) -> Formula:
    return total(positive_first(side.terms)) if isinstance(side, Sum) else side
