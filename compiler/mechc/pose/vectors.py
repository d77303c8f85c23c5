"""Vectors between points: given arms as edges of a graph, paths through it as sums."""

import math
from collections import deque
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Literal

from ..algebra.angle import HALF_TURN, QUARTER, Angle
from ..algebra.intervals import IntervalBox, sign
from ..algebra.product import Product
from ..base.named import NamedTuple
from ..formula.tree import ZERO
from ..formula.walk import symbols
from ..model.boxes import allowed_box, size_box
from ..model.mechanism import (
    Arrow,
    Geometry,
    Mechanism,
    Offset,
    Pivot,
    Require,
    Slider,
    Subject,
    Turn,
)
from ..source import Span
from .directions import Directions
from .pose import Arm, Vector, components, gathered, halved, measured_by, reverse, turned_by
from .terms import AlgebraicTerms
from .vector_graph import Edge

ORIGIN = ""
"""The name of the plane's origin among the points that vectors join."""


def start_of(mechanism: Mechanism, ways: Collection[str]) -> str:
    """Return the point from which places count: the origin, or the first point on the ground.

    ``ways`` are the points that vectors join.
    """
    grounded = [j.point for j in (*mechanism.each(Pivot), *mechanism.each(Slider))]
    return ORIGIN if ORIGIN in ways else next(iter([*grounded, *ways]), ORIGIN)


class Loop(NamedTuple):
    """A closed chain of vectors: points, arms not yet added up, the entry that closed it."""

    points: tuple[str, ...]
    arms: Vector
    span: Span


class Vectors:
    """The graph of points and given vectors.

    ``placeholders`` are the names made up for lengths that are not given. ``ahead`` are the
    lengths that ranges keep positive, where a direction rests on that. ``loops`` are
    the closed chains, one for each vector between points that were connected before.
    """

    def __init__(self, mechanism: Mechanism, terms: AlgebraicTerms, directions: Directions) -> None:
        self._terms, self._directions = terms, directions
        self._mechanism = mechanism
        self._edges: dict[str, dict[str, Vector]] = {}
        self._lengths = {
            frozenset((g.tail, g.head)): terms.length(g.length)
            for g in mechanism.geometry
            if isinstance(g, Arrow) and g.length is not None
        }
        self._cartesian = {
            frozenset((g.tail, g.head)) for g in mechanism.geometry if isinstance(g, Offset)
        }
        self.placeholders: list[str] = []
        self.ahead: list[Product] = []
        self._along_lines: dict[tuple[str, str], Vector] = {}
        self.loops: list[Loop] = []
        self.edges: list[Edge] = []
        for item in mechanism.geometry:
            self._enter(item)

    def path(self, tail: str, head: str, within: Collection[str] | None = None) -> Vector | None:
        """Return the vector along the shortest chain of given ones, None if there is none.

        ``within`` restricts the chain to some points (those of one link).
        """
        points = self.chain(tail, head, within)
        return None if points is None else gathered(self.arms(points))

    def arms(self, points: Sequence[str]) -> Vector:
        """Return the arms along a chain, as given."""
        return tuple(arm for a, b in pairwise(points) for arm in self._edges[a][b])

    def straighten(self, tail: str, head: str) -> Angle:
        """Give two points one arm between them, ``len_AB @ phi_AB``; return its direction.

        Whatever is measured along or across it is then seen to vanish, or not to. It has no name
        where ranges keep the ends apart on an axis, as across a scissor jack, or on the line that
        halves the angle between two equal arms.
        """
        vector = self.path(tail, head)
        assert vector
        if arm := self._of_one_sense(vector):
            self._join(tail, head, (arm,))
            return arm.angle
        names = f"len_{tail}{head}", f"phi_{tail}{head}"
        if {d.name for d in self._terms.definitions}.issuperset(names):
            # The side of a triangle that a loop was closed by.
            arm = Arm(Product.symbol(names[0]), Angle.of(names[1]))
        else:
            arm = Arm(*self._terms.polar(*components(vector), f"{tail}{head}"))
        self._join(tail, head, (arm,))
        return arm.angle

    @cached_property
    def _box(self) -> IntervalBox:
        """What values may be, for vectors whose sense the drawing leaves open."""
        return allowed_box(self._mechanism)

    def _of_one_sense(self, vector: Vector) -> Arm | None:
        """Return a vector as an arm, where its line is plain and ranges keep its ends apart."""
        arm = halved(vector) or _along_axis(vector)
        sense = sign(arm.length, self._box) if arm else None
        if arm is None or sense is None:
            return None
        self.ahead.append(arm.length.scaled(sense))
        return arm if sense > 0 else Arm(-arm.length, arm.angle + HALF_TURN)

    def is_open(self, vector: Vector) -> bool:
        """Return whether a vector rests on a length that is not given."""
        made_up = set(self.placeholders)
        return any(not made_up.isdisjoint(symbols(arm.length.formula())) for arm in vector)

    def given(self) -> Mapping[tuple[str, str], Vector]:
        """Return every vector once, by its two points; the origin's name is empty."""
        ways = ((a, b, arms) for a, heads in self._edges.items() for b, arms in heads.items())
        return {(a, b): arms for a, b, arms in ways if a < b}

    def chain(
        self, tail: str, head: str, within: Collection[str] | None = None
    ) -> list[str] | None:
        """Return the points along the shortest chain of given vectors."""
        came: dict[str, str | None] = {tail: None}
        queue = deque([tail])
        while queue and head not in came:
            point = queue.popleft()
            for neighbour in self._edges.get(point, ()):
                if neighbour not in came and (within is None or neighbour in within):
                    came[neighbour] = point
                    queue.append(neighbour)
        if head not in came:
            return None
        points: list[str] = []
        at: str | None = head
        while at is not None:
            points.append(at)
            at = came[at]
        return points[::-1]

    def _enter(self, item: Geometry) -> None:
        """Enter what one line of the geometry gives between its points."""
        match item:
            case Offset(tail, head, x, y, span):
                arms = (
                    Arm(self._terms.length(x), Angle()),
                    Arm(self._terms.length(y), QUARTER),
                )
                self._connect(tail, head, tuple(a for a in arms if a.length), span)
                if all(a.length for a in arms) and self._directions.of(tail, head) is not None:
                    self.straighten(tail, head)
            case Arrow(tail, head, _, _, span):
                self._enter_polar(tail, head, span)
            case Turn(first, vertex, second, _, span):
                self._enter_polar(vertex, first, span)
                self._enter_polar(vertex, second, span)

    def _enter_polar(self, tail: str, head: str, span: Span) -> None:
        """Join two points by a length and a direction that is known; not if they are joined."""
        if frozenset((tail, head)) in self._cartesian or head in self._edges.get(tail, ()):
            return
        angle = self._directions.of(tail, head)
        if angle is None:
            return
        length = self._lengths.get(frozenset((tail, head)))
        if length is None:
            name = f"len_{tail}{head}"
            self.placeholders.append(name)
            length = Product.symbol(name)
        self._connect(tail, head, (Arm(length, angle),), span)

    def _connect(self, tail: str, head: str, vector: Vector, span: Span) -> None:
        if chain := self.chain(tail, head):
            arms = (*self.arms(chain), *reverse(vector))
            self.loops.append(Loop((*chain, tail), arms, span))
        self.edges.append(Edge(tail, head, vector, span))
        self._join(tail, head, vector)

    def put(self, angles: Mapping[str, Angle], lengths: Mapping[str, Product]) -> None:
        """Replace symbols in all vectors by what they were found to be."""

        def found(vector: Vector) -> Vector:
            return measured_by(turned_by(vector, angles), lengths)

        for ways in self._edges.values():
            for head, vector in ways.items():
                ways[head] = found(vector)
        self._along_lines = {ends: found(vector) for ends, vector in self._along_lines.items()}
        self.loops = [loop._replace(arms=found(loop.arms)) for loop in self.loops]

    def lay(self, edges: Iterable[Edge]) -> None:
        """Enter vectors along lines: as the way to a point, where no given one leads there."""
        for edge in edges:
            if self.chain(edge.tail, edge.head) is None:
                self._join(edge.tail, edge.head, edge.arms)
            else:
                self._along_lines[edge.tail, edge.head] = edge.arms

    def reach(self, tail: str, head: str) -> Vector | None:
        """Return the vector to a point on a line: along the line, where given ones are a sum."""
        given = self.path(tail, head)
        return self._along_lines.get((tail, head), given) if given and len(given) > 1 else given

    def _join(self, tail: str, head: str, vector: Vector) -> None:
        self._edges.setdefault(tail, {})[head] = vector
        self._edges.setdefault(head, {})[tail] = reverse(vector)


def senses(vectors: Vectors, mechanism: Mechanism) -> Iterator[Require]:
    """Yield the conditions under which lengths are positive that only ranges keep so.

    Beyond the ranges a direction that rests on them would be the opposite one.
    """
    box = size_box(mechanism)
    for length in dict.fromkeys(vectors.ahead):
        factors = [Product.of(f) for f, e in length.factors.items() if e % 2]
        signs = [1 if length.coefficient > 0 else -1, *(sign(f, box) for f in factors)]
        operator: Literal["<", ">"] = ">" if math.prod(s for s in signs if s) > 0 else "<"
        left = math.prod((f for f in factors if sign(f, box) is None), start=Product(1)).formula()
        spans = (p.span for p in mechanism.parameters if p.name in symbols(left))
        if span := next(spans, None):
            yield Require(left, operator, ZERO, span, Subject("ranges", "", ""))


def _along_axis(vector: Vector) -> Arm | None:
    """Return a vector one of whose components vanishes, along the other one's axis."""
    x, y = components(vector)
    if bool(x) == bool(y):
        return None
    return Arm(x or y, Angle.constant(0 if x else 90))


MOST_MISSING_VECTORS = 20
"""Missing vectors among which it is looked whether they give another one."""


class Missing:
    """The vectors that were found missing."""

    def __init__(self, vectors: Vectors) -> None:
        self._vectors = vectors
        self._asked: list[tuple[str, str]] = []

    @property
    def are_any(self) -> bool:
        """Return whether a vector is missing, without which loops stay open."""
        return bool(self._asked)

    def add(self, tail: str, head: str) -> bool:
        """Note a missing vector; return whether it does not follow from those missing before."""
        if len(self._asked) < MOST_MISSING_VECTORS and self._follows(tail, head):
            return False
        self._asked.append((tail, head))
        return True

    def _follows(self, tail: str, head: str) -> bool:
        """Return whether vectors that are asked for and those given join two points."""
        reached, waiting = {tail}, [tail]
        both_ways = [*self._asked, *((b, a) for a, b in self._asked)]
        while waiting:
            here = waiting.pop()
            for start, end in both_ways:
                if end not in reached and self._joined(here, start):
                    reached.add(end)
                    waiting.append(end)
        return any(self._joined(point, head) for point in reached)

    def _joined(self, first: str, second: str) -> bool:
        return first == second or self._vectors.path(first, second) is not None
