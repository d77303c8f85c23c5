"""The pose: every vector and direction that kinematics and statics need, as algebra.

A vector is a sum of ``length @ angle`` terms, never expanded into components:
``((a, alpha - 90°),)`` for an arm, two terms for a Cartesian offset.
"""

import math
from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from types import MappingProxyType
from typing import Literal

from ..algebra.angle import HALF_TURN, Angle
from ..algebra.product import Product
from ..algebra.sums import add, put
from ..algebra.trigonometry import cosine, sine
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..formula.tree import Formula
from ..model.mechanism import Assembly, Mechanism
from ..model.result import ClosedLoop as ClosedLoop
from ..source import Span


class Arm(NamedTuple):
    """One term of a vector: a length (which may carry a sign) at a direction."""

    length: Product
    angle: Angle


Vector = tuple[Arm, ...]
"""A planar vector as a sum of arms; ``()`` is the zero vector."""

BodyFrame = Mapping[str, Vector]
"""The vectors from a body's first point to each of its points."""


class PoseDefinition(NamedTuple):
    """A named intermediate: a dependent parameter that is not simply put in."""

    name: str
    formula: Formula


class Limit(NamedTuple):
    """Where the closures of a loop meet.

    A triangle of sides d, p, q closes where d lies between |p − q| and p + q (``side`` is d,
    ``sizes`` are p and q), a rod where it reaches its guide (``sizes``: its length, and how
    far off the guide it is hinged), a pin in a slot where it is farther away than the slot's
    line passes by (``side``: how far, ``sizes``: the line's distance). Of a system nothing
    more is known.
    """

    loop: str
    group: Literal["triangle", "guide", "slot", "system"]
    side: Vector
    sizes: tuple[Product, ...]

    @property
    def margins(self) -> tuple[Product, ...]:
        """Return the expressions that are positive with two closures, zero where they are one."""
        square = add(a.length * b.length * cosine(a.angle - b.angle)
                     for a in self.side for b in self.side)  # fmt: skip
        match self.group, self.sizes:
            case "triangle", (p, q):
                both = (p * q).scaled(2)
                outer = add([p * p, both, q * q, -square])
                return outer, add([square, -(p * p), both, -(q * q)])
            case "guide", (size, height):
                return add([size, -height]), add([size, height])
            case "slot", (across,):
                return (add([square, -(across * across)]),)
            case _:
                return ()


LoopKind = Literal[
    "triangle", "guide", "slot", "aligned", "equal", "mirrored", "lengths", "vector", "system"
]
"""What the two unknowns of a loop are: two directions (``triangle``), a direction and a length
along a given line (``guide``) or along a line that turns with it (``slot``; ``aligned`` where it
passes through the other end), two ``lengths``. It is ``equal`` where a direction is that of
another vector all the way, by the lengths in it, and ``mirrored`` where both are those of its known
sides, mirrored in the vector that these make. One unknown is that of a ``vector`` between
points that have places; more than two make a ``system``."""

OF_A_TRIANGLE: tuple[LoopKind, ...] = ("triangle", "mirrored")
"""The kinds of loops whose points are the vertices of a triangle."""


class SolvedLoop(NamedTuple):
    """A loop as it was solved: its points, what kind it is, the names it gave, in order.

    The points of a triangle are its vertices, the pin between the unknown sides the second, those
    of one that is mirrored, too; ``is_clockwise`` is how they lie, None for other loops. One that
    is congruent to an earlier one has ``again`` what that gave, and ``like`` are the earlier one's
    points. ``put_in`` are directions that no name stands for in vectors: those of other vectors
    all the way or mirrored, and that of a side that mirrors one of the earlier triangle in a line
    of symmetry. Of a loop that closes along a guide ``pin`` is the point there, and ``is_ahead``
    says of its two places that it has the one farther along the guide, or the other.
    """

    kind: LoopKind
    points: tuple[str, ...]
    names: tuple[str, ...]
    is_clockwise: bool | None = None
    like: tuple[str, ...] = ()
    again: frozenset[str] = frozenset()
    put_in: tuple[PoseDefinition, ...] = ()
    pin: str = ""
    is_ahead: bool | None = None

    @property
    def is_triangle(self) -> bool:
        """Return whether the points are vertices, the pin between the unknown sides the second."""
        return self.kind in OF_A_TRIANGLE


class PointContact(NamedTuple):
    """A pin that slides along a body: in a slot of it, or touching a face.

    ``reach`` is the vector from the body's point ``tail`` to the pin, () on a body that only
    translates. ``normal`` is the direction in which the body pushes the pin; in a slot it
    may push either way.
    """

    kind: Literal["slot", "contact"]
    point: str
    body: str
    tail: str
    reach: Vector
    normal: Angle
    span: Span


class OpenUnknowns(NamedTuple):
    """What loops leave open: all their unknowns, and how many of these they do not determine."""

    unknown: frozenset[str]
    missing: int


ALL_CLOSED = OpenUnknowns(frozenset(), 0)
"""No loop is left."""


class Closed(NamedTuple):
    """The mechanism with the parameters that were found made dependent, and the names found.

    ``rates`` are the derivatives by the drive of all that moves with it; ``limits`` are where
    the closures of the loops meet, ``loops`` those that may fail to close. ``left`` are the
    unknowns of the loops that did not close, ``idle`` the lines that decided nothing. Lengths
    that are ``put_in`` are no longer mentioned by vectors.
    """

    mechanism: Mechanism
    found: frozenset[str]
    rates: Mapping[str, Product]
    limits: tuple[Limit, ...]
    loops: tuple[ClosedLoop, ...]
    left: OpenUnknowns
    idle: tuple[Assembly, ...]
    put_in: frozenset[str] = frozenset()
    solved: tuple[SolvedLoop, ...] = ()


@frozen
class Pose:
    """A mechanism with its directions found.

    ``mechanism`` is the described one, in which what closing its loops found is a formula: reports
    list what is given by the description, and code computes by this one.
    ``frames[link][point]`` is the vector from the link's first point to the point;
    ``guides[point]`` the direction of a slider's guide; ``lines[force]`` the direction
    of a force; ``axis`` the mirror line's direction. ``definitions`` give the named
    intermediates in an order in which each uses only parameters and earlier ones.
    ``placeholders`` are the made-up names of lengths that were not given (``len_BK``
    for ``BK = @ …``), with a numeric value that follows from closure where a loop
    fixes it, and which a result must not depend on. ``free`` are the names of the
    independent parameters, in declared order. ``rates`` are the derivatives by the drive of
    the names that move with it, the drive's own being 1; empty without a drive.
    ``slides[body]`` is the direction of a body that only translates; ``lines`` has also the
    direction in which a pair of forces pushes its second point, or its first one where the
    second is the twin of it. ``radii`` is what each radius and pitch comes to.
    ``limits`` are where the closures of the loops meet, in names that ``closing`` defines,
    those among them that nothing else needs; ``put_in`` are those of ``closing`` that vectors
    do not mention, as they are one product. ``loops`` are the loops that may fail to close,
    each after those that it rests on. ``vectors`` are those between two points that
    the description gives, or that a loop gives it a place by, whatever bodies they are on; they
    may mention names that only ``closing`` defines.
    ``left[point]`` is the direction of a guide that was released, along which a rack or a nut
    is still led. ``solved`` states how the definitions follow from the loops, each loop after those
    that it rests on. ``falls[rope]`` are the directions of a rope's falls, by its id.
    """

    mechanism: Mechanism
    frames: Mapping[str, BodyFrame]
    guides: Mapping[str, Angle]
    lines: Mapping[str, Angle]
    axis: Angle | None
    definitions: tuple[PoseDefinition, ...]
    placeholders: Mapping[str, Product | None]
    free: tuple[str, ...]
    rates: Mapping[str, Product] = MappingProxyType({})
    slides: Mapping[str, Angle] = MappingProxyType({})
    contacts: tuple[PointContact, ...] = ()
    radii: Mapping[Formula, Product] = MappingProxyType({})
    limits: tuple[Limit, ...] = ()
    loops: tuple[ClosedLoop, ...] = ()
    closing: tuple[PoseDefinition, ...] = ()
    put_in: tuple[PoseDefinition, ...] = ()
    vectors: Mapping[tuple[str, str], Vector] = MappingProxyType({})
    left: Mapping[str, Angle] = MappingProxyType({})
    solved: tuple[SolvedLoop, ...] = ()
    falls: Mapping[str, tuple[Angle, ...]] = MappingProxyType({})

    def vector(self, link: str, tail: str, head: str) -> Vector:
        """Return the vector between two points of one link."""
        frame = self.frames[link]
        return gathered((*reverse(frame[tail]), *frame[head]))

    @property
    def guides_and_line(self) -> Mapping[str, Angle]:
        """Return the guides' directions, the mirror line guiding what both halves share."""
        mirror, axis = self.mechanism.mirror, self.axis
        if mirror is None or axis is None:
            return self.guides
        return {**self.guides, **{p: axis for p in mirror.sharing if p not in self.guides}}

    def guide_of(self, point: str) -> Angle | None:
        """Return the direction in which a slider, or a point of a slide, is guided."""
        if point in self.guides:
            return self.guides[point]
        slides = self.mechanism.slides_at(point)
        return self.slides[slides[0].name] if slides else self.left.get(point)

    def moved_along(self, point: str) -> Angle:
        """Return the direction in which a point is guided that a rack or a screw moves."""
        guide = self.guide_of(point)
        assert guide is not None, "the model lets racks and screws move guided points only"
        return guide


def reverse(vector: Vector) -> Vector:
    """Return the vector from head to tail: the same lengths, directions turned round."""
    return tuple(Arm(arm.length, arm.angle + HALF_TURN) for arm in vector)


def turned_by(vector: Vector, values: Mapping[str, Angle]) -> Vector:
    """Return a vector with symbols in its directions replaced by what they were found to be."""
    return tuple(Arm(arm.length, arm.angle.put(values)) for arm in vector)


def measured_by(vector: Vector, values: Mapping[str, Product]) -> Vector:
    """Return a vector with symbols in its lengths replaced by what they were found to be."""
    return tuple(Arm(put(arm.length, values), arm.angle) for arm in vector)


def gathered(arms: Iterable[Arm]) -> Vector:
    """Return a vector with arms of one line added up, and none that vanishes.

    An arm points the way in which its length is positive, as far as that can be seen.
    """
    lines: dict[Angle, list[Product]] = {}
    for length, angle in arms:
        back = _turned_back(angle, lines)
        lines.setdefault(back or _wrapped(angle), []).append(-length if back else length)
    sums = ((add(lengths), angle) for angle, lengths in lines.items())
    return tuple(_positive(Arm(length, angle)) for length, angle in sums if length)


def halved(vector: Vector) -> Arm | None:
    """Return the sum of two vectors of one length: along the line that halves their angle."""
    if len(vector) != 2:
        return None
    (length, one), (other_length, other) = vector
    if length == -other_length:
        other += HALF_TURN
    elif length != other_length:
        return None
    half = Fraction(1, 2)
    return Arm(length.scaled(2) * cosine((one - other) * half), (one + other) * half)


def _positive(arm: Arm) -> Arm:
    if arm.length.coefficient > 0:
        return arm
    return Arm(-arm.length, arm.angle + HALF_TURN)


def _wrapped(angle: Angle) -> Angle:
    return Angle(angle.terms, angle.degrees % 360)


def _turned_back(angle: Angle, lines: Collection[Angle]) -> Angle | None:
    opposite = _wrapped(angle + HALF_TURN)
    return opposite if opposite in lines else None


def components(vector: Vector) -> tuple[Product, Product]:
    """Return the components of a vector along x and y."""
    x = add(arm.length * cosine(arm.angle) for arm in vector)
    return x, add(arm.length * sine(arm.angle) for arm in vector)


def evaluate_vector(vector: Vector, values: Mapping[str, float]) -> tuple[float, float]:
    """Return the components of a vector at numeric values of all its symbols."""
    x = y = 0.0
    for length, angle in vector:
        size, turn = length.evaluate(values), angle.evaluate(values)
        x += size * math.cos(turn)
        y += size * math.sin(turn)
    return x, y
