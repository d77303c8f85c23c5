"""What statics is asked for: a question for each answer of virtual power."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import assert_never

from ..base.named import NamedTuple
from ..formula.tree import ONE, Formula, Symbol
from ..formula.walk import substitute, symbols
from ..model.mechanism import (
    Axial,
    Efficiency,
    ForceAtJoint,
    LoadForm,
    LoadRatio,
    Mechanism,
    Normal,
    Reaction,
    Require,
    SpeedRatio,
    WithFriction,
)
from ..model.result import Definition, Result
from . import friction_loads, joint_forces, speeds
from .answers import Answer, load_coefficient, load_ratio
from .balanced import Balanced


class Question(NamedTuple):
    """What virtual power answers with a formula, and how statics is asked for the same.

    With friction several forces may balance; then it is asked for ``others``.
    """

    name: str
    formula: Formula
    where: tuple[Definition, ...]
    ask: Callable[[Balanced], Answer]
    guards: tuple[Require, ...] = ()
    others: Callable[[Balanced], Iterable[Answer]] = lambda at: ()


def questions(results: tuple[Result, ...], mechanism: Mechanism) -> Iterator[Question]:
    """Yield what statics is asked for, so that every result is checked that does not follow."""
    given = {load.name for load in mechanism.loads if load.tie is not None}
    given |= {let.name for let in mechanism.lets}
    for result in results:
        name, formula, where = result.name, result.formula, result.where
        match target := result.target:
            case LoadRatio(above, below):
                yield Question(name, formula, where, partial(load_ratio, above=above, below=below))
            case LoadForm(load):
                yield from _coefficients(result, load, given, mechanism)
            case Reaction(part="direction"):
                pass  # it follows from the components, which are checked
            case Reaction() | Axial() | Normal():
                yield from _forces(result, target, mechanism)
            case WithFriction(Reaction(part="direction")):
                pass  # it follows from the components, which are checked
            case WithFriction(order="exact") if mechanism.friction.efficiency is None:
                yield _with_friction(result, target, mechanism)
            case WithFriction() | Efficiency():
                pass  # an approximation, and quotients of what is checked
            case SpeedRatio():
                yield Question(name, formula, where, partial(speeds.speed_ratio, target=target))
            case None:
                pass
            case _:
                assert_never(target)


def _coefficients(
    result: Result, load: str, given: set[str], mechanism: Mechanism
) -> Iterator[Question]:
    """Yield the question for a load under each other one alone: none has any other size here."""
    coefficients = result.coefficients or {}
    where = _without_sizes(result.where, mechanism)
    known = given | coefficients.keys()
    for other, formula in coefficients.items():
        ask = partial(load_coefficient, load=load, other=other, known=known)
        yield Question(f"{result.name}/{other}", formula, where, ask)


def _forces(result: Result, target: ForceAtJoint, mechanism: Mechanism) -> Iterator[Question]:
    """Yield the question for a force at a joint under each given load alone.

    The size of a force is checked where one load makes it; under several it follows from
    the components.
    """
    coefficients = result.coefficients or _single(result, mechanism)
    for load, formula in coefficients.items():
        ask = partial(
            joint_forces.joint_force, target=target, given=load, known=coefficients.keys()
        )
        where = _without_sizes(result.where, mechanism)
        yield Question(f"{result.name}/{load}", formula, where, ask)


def _without_sizes(where: Iterable[Definition], mechanism: Mechanism) -> tuple[Definition, ...]:
    """Return definitions without those of loads, each of which is 1 here, or 0."""
    loads = {load.name for load in mechanism.loads}
    return tuple(d for d in where if d.name not in loads)


def _with_friction(result: Result, target: WithFriction, mechanism: Mechanism) -> Question:
    """Return the question for a load or force with friction, other loads being 1 or known."""
    known = {d.name: d.formula for d in result.where}
    asked = _asked(target, mechanism)
    free = [load.name for load in mechanism.loads if load.tie is None or load.name in known]
    if isinstance(target.of, LoadRatio):
        free = [target.of.below]
    sizes = (Definition(n, ONE) for n in free if n != asked and n not in known)
    where = (*sizes, *result.where)

    def loaded(at: Balanced) -> tuple[str, Mapping[str, float]]:
        driving = asked or _left(mechanism, at)
        found = at.formulas(where)
        return driving, {n: found.of(Symbol(n)) for n in free if n != driving}

    def ask(at: Balanced) -> Answer:
        return friction_loads.with_friction(at, target, *loaded(at))

    def others(at: Balanced) -> Iterator[Answer]:
        return friction_loads.others_with_friction(at, target, *loaded(at))

    return Question(result.name, result.formula, where, ask, result.guards, others)


def _asked(target: WithFriction, mechanism: Mechanism) -> str:
    """Return the load asked for, which follows from the others; '' for none."""
    asked = [target.of, *(find.target for find in mechanism.finds)]
    for one in asked:
        if isinstance(one, LoadRatio):
            return one.above
        if isinstance(one, LoadForm):
            return one.load
    return ""


def _left(mechanism: Mechanism, at: Balanced) -> str:
    """Return the load that has no size and that the joints alone do not balance."""
    valued = {let.name for let in mechanism.lets}
    free = (k.name for k in mechanism.loads if k.tie is None and k.name not in valued)
    last = len(at.system.unknowns)
    return next((n for n in free if at.eliminated((n,), None)[0].determined(last)), "")


def _single(result: Result, mechanism: Mechanism) -> Mapping[str, Formula]:
    """Return the size of a force per unit of its load; nothing where several make it."""
    loads = symbols(result.formula) & {load.name for load in mechanism.loads}
    return {n: substitute(result.formula, {n: ONE}) for n in loads} if len(loads) == 1 else {}
