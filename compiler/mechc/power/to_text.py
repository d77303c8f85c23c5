"""The balance as text, for ``mechc show power``: the power of each load, and the results."""

from collections.abc import Iterable, Iterator, Mapping

from ..formula.to_text import text
from ..formula.tree import Symbol, product, total
from ..kinematics.graph import Kind
from ..kinematics.plan import Plan
from ..model.result import Result, Vanishing
from ..model.to_text import target_text
from .balance import Balance, Term


def describe(balance: Balance, results: Iterable[Result]) -> str:
    """Return the power of each load in terms of the drives, and the results as concluded."""
    return "\n".join(_lines(balance, results)) + "\n"


def _lines(balance: Balance, results: Iterable[Result]) -> Iterator[str]:
    plan = balance.plan
    for drive in plan.drives:
        yield f"u{drive}: {_drive(plan, drive)}"
    yield "powers"
    for term in balance.terms:
        yield f"  {term.load.name}: {_power(term, plan)}"
        if term.tie:
            other, factor = term.tie
            tie = product([(factor.formula(), 1), (Symbol(other), 1)])
            yield f"    {term.load.name} = {text(tie)}"
    for result in results:
        yield from _result(result)


def _drive(plan: Plan, drive: int) -> str:
    unknown = plan.graph.unknowns[drive]
    spins = unknown.kind is Kind.SPIN
    return f"{'angular velocity of the link' if spins else 'speed of'} {unknown.of}, taken as given"


def _power(term: Term, plan: Plan) -> str:
    parts = [
        product([(Symbol(term.load.name), 1), (power.formula(), 1), (Symbol(f"u{drive}"), 1)])
        for drive, power in zip(plan.drives, term.power, strict=True)
        if power
    ]
    return text(total(parts)) if parts else "0, it does no work"


def _result(result: Result) -> Iterator[str]:
    asked = f" = {target_text(result.target)}" if result.target else ""
    yield f"{result.name}{asked} = {text(result.formula)}"
    yield from (f"  where {name} = {text(formula)}" for name, formula in result.where)
    for load, coefficient in (result.coefficients or {}).items():
        yield f"  coefficient of {load}: {text(coefficient)}"
    yield from (f"  zero where {_vanishing(v)}" for v in result.zeros)
    yield from (f"  infinite where {_vanishing(v)}" for v in result.poles)
    if result.proportional:
        powers = ((Symbol(n), e) for n, e in result.proportional.items() if e)
        yield f"  proportional to {text(product(powers))}"
    if result.independent:
        yield f"  does not depend on {', '.join(result.independent)}"
    yield from (f"  the same with {a} and {b} exchanged" for a, b in result.swaps)
    yield from _by_parameter("trend", result.trends)
    derivatives = {n: text(f) for n, f in (result.derivatives or {}).items()}
    yield from _by_parameter("derivative", derivatives)
    if result.default is not None:
        yield f"  {result.default:.9g} at the default pose"


def _by_parameter(what: str, said: Mapping[str, str] | None) -> Iterator[str]:
    yield from (f"  {what} in {name}: {found}" for name, found in (said or {}).items())


def _vanishing(vanishing: Vanishing) -> str:
    kind = "" if vanishing.kind == "other" else f" ({vanishing.kind})"
    if not vanishing.at:
        return f"{text(vanishing.factor)} = 0{kind}"
    name, value = vanishing.at
    return f"{text(vanishing.factor)} = 0, {name} = {text(value)}{kind}"
