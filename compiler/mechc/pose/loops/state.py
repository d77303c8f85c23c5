"""What closing the loops has found so far: definitions, directions, numbers."""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ...algebra.angle import Angle, principal
from ...formula.evaluate import evaluate
from ...formula.names import another
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...model.mechanism import Mechanism
from ...model.values import completed
from ...units import LENGTH
from ..pose import ClosedLoop, Limit, LoopKind, PoseDefinition, SolvedLoop, Vector, turned_by
from ..samples import Values, poses_nearby
from ..terms import AlgebraicTerms
from ..vector_graph import Edge, NameSet, VectorGraph
from .dyads import Closure
from .guide_lines import GuideLine
from .rated import Rated, given_rates

NAMED_DIRECTION_ANGLES = 3
"""The angles that a direction is the sum of, from which on it keeps its name."""


PointSide = tuple[str, bool]
"""A point on a guide, and whether of its two places it has the one farther along it."""


class LoopState:
    """The unknowns found, in order; ``values`` are the default pose and poses near it.

    ``angles`` are the unknown directions, ``named`` the unknowns that the user named, ``twice``
    the doubles of directions that halve an angle.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        terms: AlgebraicTerms,
        graph: VectorGraph,
        lines: Iterable[GuideLine],
        angles: NameSet,
        named: NameSet,
    ) -> None:
        self.mechanism, self.graph, self.angles, self.named = mechanism, graph, angles, named
        self.guide_lines = list(lines)
        self.definitions = terms.definitions
        self.directions: dict[str, Angle] = {}
        self.found: set[str] = set()
        drive = mechanism.drive_name
        self.rated = Rated(given_rates(terms.definitions, drive) if drive else {})
        self.limits: list[Limit] = []
        self.loops: list[ClosedLoop] = []
        self.solved: list[SolvedLoop] = []
        self.values = poses_nearby(mechanism, terms.definitions)
        self.twice: dict[str, Angle] = {}
        self._mirrored: set[str] = set()
        self.signed = frozenset({*_passing_zero(mechanism), *(r.length for r in self.guide_lines)})
        named_items = (
            *mechanism.parameters,
            *mechanism.literals,
            *mechanism.loads,
            *terms.definitions,
        )
        self._taken = {item.name for item in named_items} | graph.sought
        for values in self.values:
            for name in named:
                values.pop(name, None)

    @property
    def base(self) -> Values:
        """Return the default pose, or a pose near it where some parameter has no value."""
        missing = any(p.value is None and p.name not in self.named
                      for p in self.mechanism.parameters)  # fmt: skip
        return self.values[1 if missing else 0]

    @property
    def open_angles(self) -> set[str]:
        """Return the directions still sought."""
        return set(self.angles & self.graph.sought)

    @property
    def is_open(self) -> bool:
        """Return whether a direction, a place on a line or what the user named is still sought."""
        driven = self.mechanism.drive is not None or not (self.angles or self.named)
        places = {line.length for line in self.guide_lines if driven}
        return bool(self.graph.sought & (self.angles | self.named | places))

    def laid(self) -> Iterator[Edge]:
        """Yield the vectors to the pins whose place on a line was found."""
        return (line.edge for line in self.guide_lines if line.length in self.found)

    def free_name(self, stem: str) -> str:
        """Return a name that nothing has, and keep it."""
        name = stem
        while name in self._taken:
            name = another(name)
        self._taken.add(name)
        return name

    def tried(self, closure: Closure, values: Mapping[str, float]) -> Values:
        """Return values with what a closure would add to them; NaN where it does not close."""
        found = completed(values, closure.definitions)
        for name, angle in closure.directions.items():
            if angle.names <= found.keys():
                found[name] = angle.evaluate(found)
        return found

    def take(
        self,
        closure: Closure,
        unknown: NameSet,
        loops: Sequence[Vector],
        kind: LoopKind,
        points: tuple[str, ...],
        again: Set[str] = frozenset(),
        place: PointSide | None = None,
    ) -> None:
        """Enter a closure for good, with the rates that the loops it closes give it.

        ``kind`` and ``points`` are those of the loop that it closes; ``again`` may be names of
        a congruent triangle, ``place`` says which of two places a point has on its guide.
        """
        known = _mentioned(closure) & again
        twins = {f"{name} again": name for name in known}
        apart = {name: Angle.of(twin) for twin, name in twins.items()}
        own = {n: angle.put(apart) for n, angle in closure.directions.items()}
        moving = [turned_by(loop, own) for loop in loops]
        self.rated.enter(closure.definitions, moving, twins)
        self.values = [self.tried(closure, values) for values in self.values]
        self.definitions.extend(closure.definitions)
        self._put_in(closure.directions)
        self._mirrored.update(closure.directions if closure.across else ())
        turn = self._is_clockwise(points) if kind == "triangle" else None
        self.found.update(unknown)
        self.graph.sought.difference_update(unknown)
        names = (*(d.name for d in closure.definitions), *self._name_directions())
        like = next((loop.points for loop in self.solved if not known.isdisjoint(loop.names)), ())
        put_in, placed = tuple(_put_in_by(closure, kind)), place or ("", None)
        self.solved.append(SolvedLoop(kind, points, names, turn, like, known, put_in, *placed))

    def _put_in(self, directions: Mapping[str, Angle]) -> None:
        """Put directions that were found wherever they are mentioned."""
        self.directions = {n: a.put(directions) for n, a in self.directions.items()}
        self.directions.update(directions)
        self.graph.put(directions)
        self.guide_lines = [r._replace(angle=r.angle.put(directions)) for r in self.guide_lines]
        for values in self.values:
            for name in directions:
                values.pop(name, None)

    def _name_directions(self) -> Iterator[str]:
        """Name the directions that are sums of many angles, all of them known by now.

        Those that mirror others stay sums, which cancel with what they mirror.
        """
        open_ = self.angles - self.found
        for name, angle in list(self.directions.items()):
            is_long = len(angle.terms) >= NAMED_DIRECTION_ANGLES and self.directions[name] == angle
            is_long = is_long and name not in self._mirrored
            if is_long and open_.isdisjoint(angle.names):
                self._define_direction(name, angle)
                yield name

    def _define_direction(self, name: str, angle: Angle) -> None:
        """Define a direction under a name, which stands for it wherever it was written out."""
        self.definitions.append(PoseDefinition(name, angle.formula()))
        self.rated.define(name, angle)
        for values in self.values:
            values[name] = angle.evaluate(values)

        def by_name(other: Angle) -> Angle:
            apart = other - angle
            return other if apart.terms else Angle.of(name) + apart

        self.directions = {n: by_name(a) for n, a in self.directions.items()}
        self.guide_lines = [r._replace(angle=by_name(r.angle)) for r in self.guide_lines]
        self.graph.rewrite(by_name)

    def _is_clockwise(self, points: Sequence[str]) -> bool:
        """Return how three points lie at the default pose."""
        places = self.graph.places(points[0], self.base)
        (_, _), (bx, by), (cx, cy) = (places[p] for p in points)
        return bx * cy < by * cx


def _mentioned(closure: Closure) -> frozenset[str]:
    """Return the names in the formulas of a closure."""
    angles = (angle.names for angle in closure.directions.values())
    return symbols(*(d.formula for d in closure.definitions)).union(*angles)


def _passing_zero(mechanism: Mechanism) -> Iterator[str]:
    """Yield the lengths that the user lets run through zero."""
    drive = mechanism.drive
    for parameter in mechanism.parameters:
        ends: list[Formula] = []
        if parameter.range is not None:
            ends += [parameter.range.low, parameter.range.high]
        if drive and drive.parameter == parameter.name and drive.low and drive.high:
            ends += [drive.low, drive.high]
        places = [evaluate(end, {}) for end in ends]
        if parameter.dimension == LENGTH and places and min(places) < 0 < max(places):
            yield parameter.name


def _put_in_by(closure: Closure, kind: LoopKind) -> Iterator[PoseDefinition]:
    """Yield the directions that are put in as those of other vectors, or as mirrored ones.

    Where two equal sides meet on a guide they follow from the angle between these.
    """
    known_by = {closure.across, *closure.alike}
    if kind == "guide" and all(d.name.startswith("len_") for d in closure.definitions):
        known_by.update(closure.directions)
    for name, angle in closure.directions.items():
        if name in known_by:
            yield PoseDefinition(name, principal(angle).formula())
