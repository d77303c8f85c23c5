"""Friction in equilibrium: free bodies with friction as a load.

On each pair of surfaces friction is its factor times the force that equilibrium gives
there, against the slip. What the pressing forces are depends on friction again: see
:mod:`.friction_sizes`. Slips have their signs from statics too: by the motion in which the
driving load does work.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial

from ..base.named import NamedTuple
from ..formula.evaluate import evaluate
from ..formula.tree import Formula
from ..model.mechanism import LoadForm, LoadRatio, Sense, WithFriction
from ..model.parts.targets import SIGNS
from .answers import Answer
from .balanced import Balanced, Tie, gather, ties, untied, with_loads
from .equations import EquilibriumSystem, equilibrium
from .friction_sizes import SurfacePair, friction_sizes, other_friction_sizes
from .joint_forces import Weights, wanted_of
from .sparse_elimination import EliminatedSystem, SparseRow, factor
from .surfaces import FrictionSurfaces, pairs_of
from .tolerances import EPSILON, INCONSISTENT, NO_SLIP, SAME_TERM
from .unfold import Unfolding
from .verdict import OPEN, STANDS, UNBALANCED, UNSETTLED

SolutionVector = Sequence[float]
"""The unknowns under a load."""


class DrivingSystem(NamedTuple):
    """Equations with the driving load as their last unknown, in a ``unit`` of its own.

    ``drive`` is its column; ``columns`` are what a unit of each load puts on the right-hand side,
    ``factors`` the equations ready for any of that.
    """

    system: EquilibriumSystem
    columns: Mapping[str, Mapping[int, float]]
    factors: EliminatedSystem
    drive: int
    unit: float


class RightSide(NamedTuple):
    """A part of the right-hand side, and the unknowns that balance it."""

    right: SparseRow
    found: SolutionVector


class Responses(NamedTuple):
    """What balances the given loads, and a friction of 1 in each pair, whatever way it moves.

    ``slips`` are the signs with which the pairs slip as the driving load drives along its arrow;
    ``thrusts`` are the forces along axes.
    """

    question: DrivingSystem
    loads: RightSide
    pairs: tuple[FrictionSurfaces, ...]
    thrusts: Mapping[str, float]
    slips: tuple[float, ...]
    each: tuple[SolutionVector, ...]


class FrictionForces(NamedTuple):
    """Friction under given loads: its size at each pair, and against which slip.

    ``loads`` is the part that the given loads make by themselves, ``against`` that of a friction
    of 1 against each slip.
    """

    question: DrivingSystem
    loads: RightSide
    pairs: tuple[FrictionSurfaces, ...]
    senses: tuple[float, ...]
    against: tuple[RightSide, ...]
    frictions: tuple[float, ...]

    @property
    def parts(self) -> list[tuple[RightSide, float]]:
        """Return the parts under which all balances, each so many times over."""
        return [(self.loads, 1.0), *zip(self.against, self.frictions, strict=True)]


class FrictionLoading(NamedTuple):
    """All that :class:`FrictionForces` has but its sizes, and what they follow from."""

    question: DrivingSystem
    loads: RightSide
    pairs: tuple[FrictionSurfaces, ...]
    senses: tuple[float, ...]
    against: tuple[RightSide, ...]
    surfaces: list[SurfacePair]

    def under(self, frictions: Iterable[float]) -> FrictionForces:
        """Return the forces of friction where the frictions have these sizes."""
        return FrictionForces(*self[:-1], tuple(frictions))


def with_friction(
    unfolding: Unfolding, target: WithFriction, driving: str, given: Mapping[str, float]
) -> Answer:
    """Return a driving load or a force at a joint, where the other loads have given sizes."""
    loaded = _loaded(unfolding, target.sense, driving, given)
    if isinstance(loaded, str):
        return Answer(math.nan, math.inf, loaded)
    found = friction_sizes(loaded.surfaces)
    if found is None:
        return Answer(math.nan, math.inf, UNSETTLED)
    return _answered(unfolding, target, driving, loaded.under(found))


def others_with_friction(
    unfolding: Unfolding, target: WithFriction, driving: str, given: Mapping[str, float]
) -> Iterator[Answer]:
    """Yield the same for other frictions that balance, as far as some are found."""
    loaded = _loaded(unfolding, target.sense, driving, given)
    if not isinstance(loaded, str):
        for found in other_friction_sizes(loaded.surfaces):
            yield _answered(unfolding, target, driving, loaded.under(found))


def friction_forces(
    unfolding: Unfolding,
    sense: Sense,
    driving: str,
    given: Mapping[str, float],
    nearby: Unfolding | None = None,
) -> FrictionForces | str:
    """Return friction at every pair of surfaces, or why none is known that balances.

    Where a pair does not slip its friction is against the slip of a pose ``nearby``, if there is
    one: so forces come to what they are the nearer that is.
    """
    slipping = _responses(unfolding, driving, given)
    near = _responses(nearby, driving, given) if nearby else slipping
    if isinstance(slipping, str) or isinstance(near, str):
        return slipping if isinstance(slipping, str) else str(near)
    slips = (a or b for a, b in zip(slipping.slips, near.slips, strict=True))
    loaded = _in_sense(slipping._replace(slips=tuple(slips)), SIGNS[sense])
    found = friction_sizes(loaded.surfaces)
    return UNSETTLED if found is None else loaded.under(found)


def _answered(
    unfolding: Unfolding, target: WithFriction, driving: str, found: FrictionForces
) -> Answer:
    multiple = ties(unfolding.pose.mechanism, unfolding.values)[driving].factor
    weights = _weights(target, unfolding, found.question, multiple)
    answer = _combined([_answer(found.question, w, found.parts) for w in weights])
    return answer if all(found.senses) else answer._replace(doubt=STANDS)


def _loaded(
    unfolding: Unfolding, sense: Sense, driving: str, given: Mapping[str, float]
) -> FrictionLoading | str:
    """Return the forces of loads and frictions on all pairs of surfaces, or why these are open."""
    find = partial(_responses, unfolding, driving, given)
    asked = driving, *sorted(given.items())
    found = unfolding.once(asked, find) if isinstance(unfolding, Balanced) else find()
    return found if isinstance(found, str) else _in_sense(found, SIGNS[sense])


def _in_sense(found: Responses, sign: int) -> FrictionLoading:
    """Return the forces of loads and frictions in one of the two senses of motion."""
    question, loads, pairs, thrusts, slips, each = found
    senses = tuple(-sign * slip for slip in slips)
    against = tuple(map(partial(_part_against, question), pairs, senses, each))
    responses = [[s * x for x in r] for s, r in zip(senses, each, strict=True)]
    surfaces = _loaded_surfaces(question, pairs, senses, (loads.found, thrusts), responses)
    return FrictionLoading(question, loads, pairs, senses, against, surfaces)


def _responses(unfolding: Unfolding, driving: str, given: Mapping[str, float]) -> Responses | str:
    """Return the reactions to the given loads and to each friction, or why they are open."""
    tied = ties(unfolding.pose.mechanism, unfolding.values)
    pairs = tuple(pairs_of(unfolding))
    question = _question(unfolding, pairs, tied[driving].base)
    if not question.factors.determined(question.drive):
        return OPEN
    right = _right_side(question, tied, given)
    ideal = question.factors.solve(right)
    if question.factors.gap(ideal, right) > INCONSISTENT:
        return UNBALANCED
    frictions = [_against(question, pair, 1.0) for pair in pairs]
    each = tuple(question.factors.solve(friction) for friction in frictions)
    adjoint = question.factors.adjoint(question.drive)
    slips = tuple(map(partial(_slip, question, adjoint), frictions, each))
    thrusts = {p.name: _size(p.thrust, unfolding, tied, given) for p in pairs if p.thrust}
    return Responses(question, RightSide(right, ideal), pairs, thrusts, slips, each)


def _right_side(
    question: DrivingSystem, tied: Mapping[str, Tie], given: Mapping[str, float]
) -> dict[int, float]:
    """Return the right-hand side of the equations: the given loads, row by row."""
    right: dict[int, float] = {}
    for base, size in untied(given, tied).items():
        for i, amount in question.columns[base].items():
            right[i] = right.get(i, 0.0) - amount * size
    return right


def _size(
    thrust: Formula, unfolding: Unfolding, tied: Mapping[str, Tie], given: Mapping[str, float]
) -> float:
    """Return a force along an axis, under loads of given sizes."""
    bases = untied(given, tied)
    loads = {n: bases[tie.base] * tie.factor for n, tie in tied.items() if tie.base in bases}
    return evaluate(thrust, {**unfolding.values, **loads})


def _weights(
    target: WithFriction, unfolding: Unfolding, question: DrivingSystem, factor_: float
) -> tuple[Weights, ...]:
    if isinstance(target.of, LoadRatio | LoadForm):
        return ({question.drive: factor_ * question.unit},)
    return wanted_of(target.of, unfolding, question.system)


def _answer(
    question: DrivingSystem, weights: Weights, parts: Sequence[tuple[RightSide, float]]
) -> Answer:
    """Return a combination of unknowns under several loads, each so many times over."""
    value = influence = 0.0
    adjoints = {column: question.factors.adjoint(column) for column in weights}
    for (load, found), size in parts:
        sizes = question.factors.weights(found, load)
        rounding = EPSILON * max(sizes, default=0.0)
        for column, weight in weights.items():
            value += weight * size * found[column]
            if column != question.drive:  # the weight is rounded: a component of a direction
                influence += abs(size) * (rounding + abs(found[column]))
            shares = zip(adjoints[column], sizes, strict=True)
            influence += abs(weight * size) * sum(abs(share) * s for share, s in shares)
    return Answer(value, influence)


def _combined(parts: Sequence[Answer]) -> Answer:
    """Return the only part, or the size of two that are perpendicular."""
    if len(parts) == 1:
        return parts[0]
    size = math.hypot(*(part.value for part in parts))
    return Answer(size, sum(part.influence for part in parts))


def _question(unfolding: Unfolding, pairs: Sequence[FrictionSurfaces], drive: str) -> DrivingSystem:
    system = equilibrium(unfolding.assembly(*((p.name, p.actions) for p in pairs)))
    tied = ties(unfolding.pose.mechanism, unfolding.values)
    columns = {**gather(system, tied), **{p.name: dict(system.loads[p.name]) for p in pairs}}
    rows, units = with_loads(system, {drive: columns[drive]})
    last = len(system.unknowns)
    return DrivingSystem(system, columns, factor(rows, last + 1, last), last, units[drive])


def _slip(
    question: DrivingSystem,
    adjoint: Sequence[float],
    friction: dict[int, float],
    response: SolutionVector,
) -> float:
    """Return the sign of the slip behind a friction of 1 as the load drives along its arrow.

    That load balances the friction alone, so that the slip is minus its size, as :mod:`.speeds`
    has it. Near a dead centre what is none has the size of rounding that grew with all forces.
    """
    slip = -question.unit * response[question.drive]
    sound = all(map(math.isfinite, response))
    sound = sound and question.factors.gap(response, friction) <= INCONSISTENT
    if not sound or abs(slip) <= NO_SLIP:
        return 0.0
    sizes = question.factors.weights(response, friction)
    parts = sum(abs(share) * size for share, size in zip(adjoint, sizes, strict=True))
    is_rounding = abs(response[question.drive]) <= SAME_TERM * parts
    return 0.0 if is_rounding else math.copysign(1.0, slip)


def _against(question: DrivingSystem, pair: FrictionSurfaces, sense: float) -> dict[int, float]:
    """Return the right-hand side of a friction of 1 in a pair."""
    return {i: -v * sense for i, v in question.columns[pair.name].items()}


def _part_against(
    question: DrivingSystem, pair: FrictionSurfaces, sense: float, response: SolutionVector
) -> RightSide:
    """Return a friction of 1 against a slip, none where nothing slips; a response to one of 1."""
    found = [sense * x if sense else 0.0 for x in response]
    return RightSide(_against(question, pair, sense), found)


def _loaded_surfaces(
    question: DrivingSystem,
    pairs: Sequence[FrictionSurfaces],
    senses: Sequence[float],
    without: tuple[SolutionVector, Mapping[str, float]],
    responses: Sequence[SolutionVector],
) -> list[SurfacePair]:
    """Return the normal forces of each pair: without friction, and per unit of each friction."""
    ideal, thrusts = without
    names = [pair.name for pair in pairs]
    found = []
    for pair in pairs:
        if pair.name in thrusts:
            found.append(SurfacePair(pair.factor, [(thrusts[pair.name], [0.0] * len(pairs))]))
            continue
        more = dict(pair.besides)
        own = [more.get(name, 0.0) * s for name, s in zip(names, senses, strict=True)]
        components = [
            (ideal[c], [r[c] + part for r, part in zip(responses, own, strict=True)])
            for c in _pressing(question.system, pair)
        ]
        found.append(SurfacePair(pair.factor, components))
    return found


def _pressing(system: EquilibriumSystem, pair: FrictionSurfaces) -> tuple[int, ...]:
    return tuple(
        i
        for i, u in enumerate(system.unknowns)
        if (u.by, u.on) == (pair.by, pair.on) and u.component != "couple"
    )
