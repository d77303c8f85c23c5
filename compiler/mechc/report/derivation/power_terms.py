"""The power of each load by the speeds that the steps have named, and the power equation."""

from collections.abc import Iterator, Mapping

from ...base.named import NamedTuple
from ...formula.layout import has_minus
from ...formula.tree import ZERO, Formula, Sum, Symbol, negative, number, product, total
from ...kinematics.forms import speed_of_load
from ...kinematics.graph import LinearForm
from ...model.mechanism import Force, ForcePair
from ...power.balance import Term
from ..kinds import StepRule
from ..sentences.order import positive_first
from ..steps import DerivationStep, Equation, PowerTerm
from .notation import in_written_unknowns, times
from .rules import rule_of_component
from .speed_steps import SpeedSteps, acting_on


class AlongLoad(NamedTuple):
    """A speed along a load that has a symbol of its own, and the step that leads to it."""

    symbol: Symbol
    step: DerivationStep


def speeds_along(speeds: SpeedSteps) -> Mapping[str, AlongLoad]:
    """Return the speed along each load of which the velocity of its point is a sum, by the load."""
    found = {}
    for term in speeds.balance.terms:
        if term.line is None or speeds.plan.mobility != 1 or not any(term.power):
            continue
        if along := _speed_along(term, speeds):
            found[term.load.name] = along
    return found


def _speed_along(term: Term, speeds: SpeedSteps) -> AlongLoad | None:
    """Return the speed along a force, or that at which the ends of a pair of forces part."""
    graph = speeds.plan.graph
    form = speed_of_load(graph, term.load)
    match term.load:
        case Force(name, point):
            if len(graph.velocities[point]) < 2:
                return None
            rule, subject = rule_of_component(point, name, graph)
            said = in_written_unknowns(form, speeds.names_at(form, *subject))
            symbol = Symbol(f"V_{point}_{name}")
        case ForcePair(_, first, second):
            if len(form) < 2:
                return None
            said = in_written_unknowns(_moving(form, speeds), speeds.names_at(form, first, second))
            subject = acting_on(term.load, graph)
            symbol, rule = Symbol(f"V_{first}{second}"), StepRule.PARTING
        case _:
            return None
    drive = speeds.names[speeds.plan.drives[0]]
    by_drive = times(speeds.balance.reading.value(form)[0] * drive.factor, drive)
    step = DerivationStep(rule, subject, (Equation(symbol, said),), (Equation(symbol, by_drive),))
    return AlongLoad(symbol, step)


def power_terms(speeds: SpeedSteps, along: Mapping[str, AlongLoad]) -> tuple[PowerTerm, ...]:
    """Return the power of each load that does any, with its point's speed as it is named."""
    return tuple(_power_term(t, speeds, along) for t in speeds.balance.terms if any(t.power))


def _power_term(term: Term, speeds: SpeedSteps, along: Mapping[str, AlongLoad]) -> PowerTerm:
    load = term.load
    at = load.points or load.links
    if load.name in along:
        return PowerTerm(load.name, at[0], term.count.formula(), along[load.name].symbol)
    moving = _moving(speed_of_load(speeds.plan.graph, load), speeds)
    speed = in_written_unknowns(moving, speeds.names_at(moving, *at))
    return PowerTerm(load.name, at[0], term.count.formula(), speed)


def _moving(form: LinearForm, speeds: SpeedSteps) -> LinearForm:
    """Return a form without the unknowns that are zero in every motion."""
    return {u: p for u, p in form.items() if any(speeds.plan.speeds[u])}


def power_equations(speeds: SpeedSteps, terms: tuple[PowerTerm, ...]) -> Iterator[Equation]:
    """Yield the power equation of the terms, or one for each motion where there are several."""
    if not terms:
        return
    if speeds.plan.mobility == 1:
        yield Equation(total(positive_first(map(_power, terms))), ZERO)
        return
    for motion, drive in enumerate(speeds.plan.drives):
        if any(t.power[motion] for t in speeds.balance.terms):
            yield Equation(_in_motion(motion, drive, speeds), ZERO)


def _in_motion(motion: int, drive: int, speeds: SpeedSteps) -> Formula:
    """Return the power in one motion, the other drives being held."""
    named = speeds.names[drive]
    parts = [
        product([(Symbol(t.load.name), 1), (times(t.power[motion] * named.factor, named), 1)])
        for t in speeds.balance.terms
        if t.power[motion]
    ]
    return total(positive_first(parts))


def _power(term: PowerTerm) -> Formula:
    sign, speed = 1, term.speed
    if isinstance(speed, Sum) and all(map(has_minus, speed.terms)):
        sign, speed = -1, negative(speed)
    return product([(number(sign), 1), (term.times, 1), (Symbol(term.load), 1), (speed, 1)])
