"""The velocity-constraint graph: unknown speeds as nodes, rules of mechanics as edges.

Speeds are taken so that most rules have two terms: the angular velocity of a link on
a pivot, the speed of a point along its guide, and, for a pin that only rods hold, the
projections of its velocity on two of them.
"""

from collections.abc import Mapping

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..base.string_enum import Word
from ..pose.pose import Pose
from ..source import Span


class SpeedKind(Word):
    """What an unknown speed is."""

    SPIN = "spin"
    """Angular velocity of a link, counter-clockwise."""
    SLIDE = "slide"
    """Speed of a point along its guide."""
    COMPONENT = "component"
    """Projection of a point's velocity on a direction."""


class UnknownSpeed(NamedTuple):
    """One unknown speed; ``of`` is a link for SPIN, a point otherwise."""

    kind: SpeedKind
    of: str
    direction: Angle | None = None


class Flow(NamedTuple):
    """What one unknown contributes to a velocity: ``size · unknown`` in a direction."""

    size: Product
    direction: Angle
    unknown: int


Velocity = tuple[Flow, ...]
"""A point's velocity as a linear form in the unknowns; ``()`` for a point at rest."""

LinearForm = Mapping[int, Product]
"""A scalar linear form in the unknowns."""


class Rule(Word):
    """Which rule of mechanics a relation is."""

    PROJECTION = "projection"
    """The ends of a rod have equal projections on it."""
    ROTATION = "rotation"
    """The difference of two velocities of a link is its rotation."""
    BODY = "body"
    """A point's velocity is another point's of its link and the link's rotation."""
    JOINT = "joint"
    """A point of two links has one velocity."""
    GUIDE = "guide"
    """A point on a guide does not move across it."""
    REST = "rest"
    """A second point of the link is pinned to the ground."""
    TURNING = "turning"
    """A link in a slot turns with the link that has it."""
    SLOT = "slot"
    """A pin in a slot and the link under it have equal velocities across the slot."""
    CONTACT = "contact"
    """Two bodies that touch have equal velocities along the common normal."""
    MESH = "mesh"
    """Rims, teeth or a thread do not slip: ω₁r₁ = ∓ω₂r₂, V = ωr, V = ωp/2π."""
    ROPE = "rope"
    """A rope keeps its length: its falls together grow by nothing."""
    HELD = "held"
    """Nothing moves that way while a joint is released."""


class Relation(NamedTuple):
    """``Σ form[u] · u = 0``, from a rule applied to points of a link.

    ``along`` is the direction on which velocities were projected, ``joint`` the ``id`` of the
    wheels, the rack, the screw or the guided slot that demands it.
    """

    rule: Rule
    link: str
    points: tuple[str, ...]
    along: Angle
    form: LinearForm
    span: Span
    joint: str = ""


@frozen
class Graph:
    """Unknowns, what every point's velocity and every link's spin is in them, and relations.

    ``spins`` holds links with an unknown of their own; a rod's spin follows from its ends.
    """

    pose: Pose
    unknowns: tuple[UnknownSpeed, ...]
    velocities: Mapping[str, Velocity]
    spins: Mapping[str, int]
    relations: tuple[Relation, ...]
