"""The normal forces of all pairs of surfaces: by the loads, and by friction elsewhere.

Friction is a load like others, a couple between two links or a force along a guide, so
every pressing force is a linear form in the given loads and in all frictions. Only that a
friction is its factor times the size of a pressing force is not linear.
"""

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from functools import partial
from random import Random

from ..algebra.from_formula import to_product
from ..algebra.product import ZERO, Product
from ..algebra.sums import add
from ..base.frozen import on_demand, replace
from ..formula.numeric.rounding import Rounding
from ..formula.tree import Formula
from ..formula.walk import substitute, symbols
from ..kinematics.plan import Plan
from ..model.mechanism import Torque
from ..model.values import completed, defaults, following, independent
from ..power.balance import PowerEquations, Release, Term
from ..power.loads import occurrences
from ..power.numbers import default_values
from ..power.reactions import Reactions, amounts_of
from ..units import ANGLE
from .friction_pairs import Component, FrictionPair, GivenForces, LoadedPair
from .tolerances import PRECISE


class Undetermined(Exception):
    """Equilibrium leaves open how hard a pair of surfaces is pressed."""

    def __init__(self, pair: FrictionPair) -> None:
        self.pair = pair


class LoadedByAnother(Exception):
    """A load that is neither given nor driving presses a pair of surfaces."""

    def __init__(self, load: str) -> None:
        self.load = load


class Idle(Exception):
    """A pair of surfaces can slip without any load moving."""

    def __init__(self, pair: FrictionPair) -> None:
        self.pair = pair


def loaded_pairs(
    plan: Plan,
    equations: PowerEquations,
    driving: str,
    pairs: Sequence[FrictionPair],
    given: GivenForces,
) -> tuple[LoadedPair, ...]:
    """Return how every pair that is pressed is, and slips, where one load drives.

    Raises :class:`Undetermined` at a pair whose pressing force equilibrium leaves open,
    :class:`LoadedByAnother` where a load has a part in it that is not given, and :class:`Idle`
    where a motion that moves no load changes how it slips.
    """
    pose = plan.graph.pose
    names = {load_of(pair): pair.name for pair in pairs}
    reactions = Reactions(pose, (driving,), partial(_with_others, pairs), (plan,))
    slips = without_slips_at_rest([_slip(pair, plan, equations, driving) for pair in pairs], plan)
    (load,) = (load for load in pose.mechanism.loads if load.name == driving)
    driven = occurrences(pose.mechanism, load)
    loaded = []
    for pair, slip in zip(pairs, slips, strict=True):
        times = pair.number / driven
        if pair.thrust is not None:
            ideal = _thrust_under(pair.thrust, equations, given)
            if isinstance(ideal, str):
                raise LoadedByAnother(ideal)
            loaded.append(LoadedPair(pair, slip, (Component(ideal, {}),), (), times))
            continue
        transmitted = reactions.of(pair.joint)
        if transmitted is None:
            raise Undetermined(pair)
        components = (_component(r, pair, pairs, names, given) for r in transmitted.releases)
        loaded.append(LoadedPair(pair, slip, tuple(components), transmitted.plans, times))
    return tuple(without_unloaded(loaded))


def without_unloaded(loaded: Sequence[LoadedPair]) -> Sequence[LoadedPair]:
    """Return the pairs without those that nothing presses but friction in one another.

    All forces balance with none in them. Beside a dead centre of theirs friction would be followed
    to forces without end, and a jam be said of links that pass on nothing.
    """
    idle = {p.pair.name for p in loaded if not any(c.ideal for c in p.components)}
    while idle and (by_others := [p for p in loaded if _is_loaded_beyond(p, idle)]):
        idle -= {p.pair.name for p in by_others}
    if not idle:
        return loaded
    return [_without_frictions(p, idle) for p in loaded if p.pair.name not in idle]


def _is_loaded_beyond(loaded: LoadedPair, idle: Set[str]) -> bool:
    """Return whether one of some pairs is pressed by friction in others than these."""
    return loaded.pair.name in idle and any(c.by.keys() - idle for c in loaded.components)


def _without_frictions(loaded: LoadedPair, idle: Set[str]) -> LoadedPair:
    """Return a loaded pair without what friction adds that there is none of."""

    def left(component: Component) -> Mapping[str, Product]:
        return {name: part for name, part in component.by.items() if name not in idle}

    parts = (Component(c.ideal, on_demand(partial(left, c))) for c in loaded.components)
    return replace(loaded, components=tuple(parts))


def _with_others(pairs: Sequence[FrictionPair], loose: Plan) -> list[Term]:
    """Return the frictions in a released linkage that has several motions.

    There they decide whether the force at the joint is determined. In one motion it is by the
    loads alone, and what frictions add to it is found when that is asked for.
    """
    return _terms(pairs, loose) if loose.mobility > 1 else []


def _terms(pairs: Sequence[FrictionPair], loose: Plan) -> list[Term]:
    return [term_of(pair, loose) for pair in pairs]


def _slip(pair: FrictionPair, plan: Plan, equations: PowerEquations, driving: str) -> Product:
    slip = equations.per_power(driving, term_of(pair, plan).power)
    if slip is None:
        raise Idle(pair)
    return slip


def load_of(pair: FrictionPair) -> str:
    """Return the name of a friction as a load; no description can have it."""
    return f"friction of {pair.name} {pair.joint.kind}"


def term_of(pair: FrictionPair, plan: Plan) -> Term:
    """Return a friction as a term of the power equations: it does work with its slip."""
    load = Torque(load_of(pair), "", plan.graph.pose.mechanism.span)
    return Term(load, Product(pair.number), pair.speeds(plan), None)


def _component(
    release: Release,
    pair: FrictionPair,
    pairs: Sequence[FrictionPair],
    names: Mapping[str, str],
    given: GivenForces,
) -> Component:
    """Return a component of a pressing force by a release; friction in it is found on demand.

    Raises :class:`LoadedByAnother` where a load is in it that is neither given nor driving.
    """
    amounts, known = release.amounts, names.keys() | given.keys()
    for load, amount in amounts.items():
        if amount and load not in known:
            raise LoadedByAnother(load)
    ideal = add(amounts[n] * size for n, size in given.items() if n in amounts)
    return Component(ideal, on_demand(partial(_by_frictions, release, pair, pairs, names)))


def _by_frictions(
    release: Release, pair: FrictionPair, pairs: Sequence[FrictionPair], names: Mapping[str, str]
) -> Mapping[str, Product]:
    """Return the share of a unit of each friction in a component of a normal force."""
    amounts: Mapping[str, Product] | None = release.amounts
    if release.plan.mobility == 1:
        powers = (*_terms(pairs, release.plan), release.terms[-1])
        amounts = amounts_of(powers, release.held)
    assert amounts is not None, "the joint was released so that it parts"
    besides = dict(pair.besides)
    by = {
        name: add((amounts.get(load, ZERO), besides.get(name, ZERO)))
        for load, name in names.items()
    }
    return {name: part for name, part in by.items() if part}


def scaled(loaded: Sequence[LoadedPair], factor: Product) -> tuple[LoadedPair, ...]:
    """Return the loaded pairs with their slips multiplied by a factor."""
    return tuple(replace(p, slip=p.slip * factor) for p in loaded)


def _thrust_under(
    thrust: Formula, equations: PowerEquations, given: Mapping[str, Product]
) -> Product | str:
    """Return a force along an axis under given loads, or the load that is not among them."""
    sizes = {}
    for load in sorted(symbols(thrust) & equations.owners.keys()):
        base, factor = equations.owner(load)
        if base not in given:
            return load
        sizes[load] = (factor * given[base]).formula()
    return to_product(substitute(thrust, sizes))


# --------------------------------------------------------------------------------- what never slips


NEARBY_POSES = 4
"""At so many poses besides the default one a slip is nothing but rounding if it is zero."""

NEARBY_DRAWS = 24
"""Draws to find these poses, at most."""

SPREAD = 0.1
"""How far a parameter is moved: radians, or parts of what else it is."""


def without_slips_at_rest(slips: Sequence[Product], plan: Plan) -> list[Product]:
    """Return slips, per unit speed of the drive; exactly zero where they are so at any pose.

    What is joined to one rigid part turns as one. The algebra takes an angle of a triangle for any
    angle, so that the slip of a pin in it is a difference that vanishes by the law of sines alone:
    its value is rounding, and so its sign would be.
    """
    values = completed(default_values(plan), ((b.name, b.value.formula()) for b in plan.bindings))
    doubtful = [i for i, slip in enumerate(slips) if slip and _is_small(slip, values)]
    found = list(slips)
    if doubtful:
        poses = list(_poses(plan))
        for i in doubtful:
            if _vanishes(found[i], poses):
                found[i] = Product(0)
    return found


def _is_small(slip: Product, values: Mapping[str, float]) -> bool:
    """Return whether a slip has no sign at the default pose."""
    try:
        return abs(slip.evaluate(values)) <= PRECISE
    except (KeyError, ZeroDivisionError, ValueError, OverflowError):
        return False


def _poses(plan: Plan) -> Iterator[Rounding]:
    """Yield the default pose and random ones about it, with what rounding makes of them."""
    pose, chance = plan.graph.pose, Random(1)
    given = {**defaults(pose.mechanism), **dict.fromkeys(pose.placeholders, 1.0)}
    moved = sorted(p.name for p in independent(pose.mechanism) if p.name in given)
    angles = {p.name for p in pose.mechanism.parameters if p.dimension == ANGLE}
    chain = following(pose.mechanism, pose.definitions)
    for i in range(NEARBY_DRAWS):
        shifts = {n: chance.uniform(-SPREAD, SPREAD) * bool(i) for n in moved}
        there = {n: given[n] + s if n in angles else given[n] * (1 + s) for n, s in shifts.items()}
        rounding = Rounding({**given, **there})
        rounding.define(chain.definitions)
        rounding.define((b.name, b.value.formula()) for b in plan.bindings)
        yield rounding


def _vanishes(slip: Product, poses: Sequence[Rounding]) -> bool:
    """Return whether a slip is rounding at the default pose and at enough others.

    Next to a pose where what it is divided by is zero it is rounded too much to tell.
    """
    formula, zeros = slip.formula(), 0
    for pose in poses:
        try:
            found = pose.of(formula)
        except KeyError:
            continue
        if math.isnan(found.value):
            continue
        if not found.is_zero:
            return False
        zeros += found.error <= PRECISE
    return zeros > NEARBY_POSES
