"""The normal forces of all pairs of surfaces: by the loads, and by friction elsewhere.

Friction is a load like others, a couple between two links or a force along a guide, so
every pressing force is a linear form in the given loads and in all frictions. Only that a
friction is its factor times the size of a pressing force is not linear.
"""

from collections.abc import Mapping, Sequence

from ..algebra.from_formula import to_product
from ..algebra.product import ZERO, Product
from ..algebra.sums import add
from ..formula.tree import Formula
from ..formula.walk import substitute, symbols
from ..frozen import replace
from ..kinematics.plan import Plan
from ..model.mechanism import Torque
from ..power.balance import Equations, Term
from ..power.loads import occurrences
from ..power.reactions import ForceTerm, Reactions
from .pairs import Component, FrictionPair, Given, LoadedPair
from .standing import without_standing


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
    plan: Plan, equations: Equations, driving: str, pairs: Sequence[FrictionPair], given: Given
) -> tuple[LoadedPair, ...]:
    """Return how every pair is pressed and slips where one load drives.

    Raises :class:`Undetermined` at a pair whose pressing force equilibrium leaves open,
    :class:`LoadedByAnother` where a load has a part in it that is not given, and :class:`Idle`
    where a motion that moves no load changes how it slips.
    """
    pose = plan.graph.pose
    names = {load_of(pair): pair.name for pair in pairs}
    reactions = Reactions(
        pose, (driving,), lambda loose: [term_of(pair, loose) for pair in pairs], (plan,)
    )
    slips = without_standing([_slip(pair, plan, equations, driving) for pair in pairs], plan)
    (load,) = (load for load in pose.mechanism.loads if load.name == driving)
    driven = occurrences(pose.mechanism, load)
    pressed = []
    for pair, slip in zip(pairs, slips, strict=True):
        times = pair.number / driven
        if pair.thrust is not None:
            ideal = _thrust_under(pair.thrust, equations, given)
            if isinstance(ideal, str):
                raise LoadedByAnother(ideal)
            pressed.append(LoadedPair(pair, slip, (Component(ideal, {}),), (), times))
            continue
        transmitted = reactions.of(pair.joint)
        if transmitted is None:
            raise Undetermined(pair)
        besides = dict(pair.besides)
        components = (_component(push, names, given, besides) for push in transmitted.force_terms)
        pressed.append(LoadedPair(pair, slip, tuple(components), transmitted.plans, times))
    return tuple(pressed)


def _slip(pair: FrictionPair, plan: Plan, equations: Equations, driving: str) -> Product:
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
    push: ForceTerm, names: Mapping[str, str], given: Given, besides: Mapping[str, Product]
) -> Component:
    known = names.keys() | given.keys()
    for load, amount in push.amounts.items():
        if amount and load not in known:
            raise LoadedByAnother(load)
    ideal = add(push.amounts[n] * size for n, size in given.items() if n in push.amounts)
    by = {
        name: add((push.amounts.get(load, ZERO), besides.get(name, ZERO)))
        for load, name in names.items()
    }
    return Component(ideal, {name: part for name, part in by.items() if part})


def scaled(pressed: Sequence[LoadedPair], factor: Product) -> tuple[LoadedPair, ...]:
    """Return the loaded pairs with their slips multiplied by a factor."""
    return tuple(replace(p, slip=p.slip * factor) for p in pressed)


def _thrust_under(
    thrust: Formula, equations: Equations, given: Mapping[str, Product]
) -> Product | str:
    """Return a force along an axis under given loads, or the load that is not among them."""
    sizes = {}
    for load in sorted(symbols(thrust) & equations.owners.keys()):
        base, factor = equations.owner(load)
        if base not in given:
            return load
        sizes[load] = (factor * given[base]).formula()
    return to_product(substitute(thrust, sizes))
