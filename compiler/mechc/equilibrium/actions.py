"""Free bodies: how a mechanism is cut, what acts on each, and the sums that may be written."""

from collections.abc import Iterable, Iterator, Mapping

from ..algebra.angle import QUARTER, Angle
from ..algebra.factors import Opaque
from ..algebra.product import ONE, ZERO, Product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine, sine
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..formula.tree import Call
from ..model.mechanism import (
    Link,
    Mechanism,
    Slide,
)
from ..pose.pose import Arm, Pose, Vector, components, reverse
from .equilibrium import EquilibriumSum, LoadTerms

X, Y = Angle(), QUARTER


class Action(NamedTuple):
    """A force ``along`` a line, ``at`` an arm from a body's first point; a couple has no line.

    It counts ``size`` times. ``pin`` is the pin through which it acts on the body, '' where it
    acts on the body itself.
    """

    name: str
    size: Product
    along: Angle | None
    at: Vector = ()
    pin: str = ""


@frozen
class FreeBody:
    """A link, a slide or a pin by itself, with all that acts on it.

    ``frame`` has the points that moments may be taken about, none where the body cannot turn.
    ``lines`` are the directions in which its forces balance, ``guide`` one of them. ``rods`` are
    the names of the forces in rods that act on it, with the rods.
    """

    name: str
    actions: tuple[Action, ...]
    frame: Mapping[str, Vector]
    lines: tuple[Angle, ...]
    guide: Angle | None
    rods: Mapping[str, str]


def unit(vector: Vector) -> Vector:
    """Return the vector of length 1 in the direction of another."""
    if len(vector) == 1:
        return (Arm(ONE, vector[0].angle),)
    sides = tuple(side.formula() for side in components(vector))
    length = Product.of(Opaque(Call("hypot", sides)))
    return tuple(Arm(arm.length / length, arm.angle) for arm in vector)


def lines_of(actions: Iterable[Action], guide: Angle | None) -> Iterator[Angle]:
    """Yield the directions in which the sums of forces are short, each line once."""
    whole = [*([guide] if guide else []), X, Y]
    whole += [action.along + QUARTER for action in actions if action.along is not None]
    met: set[Angle] = set()
    for line in whole:
        there = Angle(line.terms, line.degrees % 180)
        if there not in met:
            met.add(there)
            yield line


def bent(pose: Pose) -> Iterator[str]:
    """Yield the links that something acts on between their pins, or turns."""
    for load in pose.mechanism.loads:
        yield from load.links
    for joint in pose.mechanism.joints:
        yield from joint.bodies


def balances(body: FreeBody) -> Iterator[EquilibriumSum]:
    """Yield the sums of moments about each point of a body and of forces in each direction."""
    for centre, place in body.frame.items():
        moments = ((action.name, _moment(action, place)) for action in body.actions)
        yield EquilibriumSum(body.name, summed(moments), centre)
    for line in body.lines:
        terms = summed((action.name, part_along(action, line)) for action in body.actions)
        across = next((rod for name, rod in body.rods.items() if name not in terms), "")
        yield EquilibriumSum(body.name, terms, "", line, line == body.guide, across)


def summed(parts: Iterable[tuple[str, Product]]) -> LoadTerms:
    """Return the coefficient of each force in a sum, those that vanish left out."""
    terms: dict[str, list[Product]] = {}
    for name, part in parts:
        terms.setdefault(name, []).append(part)
    sums = {name: add(there) for name, there in terms.items()}
    return {name: part for name, part in sums.items() if part}


def _moment(action: Action, centre: Vector) -> Product:
    """Return the moment of what acts about a point."""
    if action.along is None:
        return action.size
    arm = (*reverse(centre), *action.at)
    return action.size * add(length * sine(action.along - angle) for length, angle in arm)


def part_along(action: Action, line: Angle) -> Product:
    """Return the component of what acts along a line."""
    return ZERO if action.along is None else action.size * cosine(action.along - line)


@frozen
class Cutting:
    """The ``rigid`` bodies, by name with their points: links that are no plain rods, and slides.

    A pin that none of them carries is a body by itself.
    """

    pose: Pose
    rigid: Mapping[str, tuple[str, ...]]

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism that is cut."""
        return self.pose.mechanism

    def points(self, body: str) -> tuple[str, ...]:
        """Return the points of a body; the ground, '', has none."""
        return tuple(self.pose.frames[body]) if body else ()

    def on(self, point: str) -> list[str]:
        """Return the rigid bodies that have a point."""
        return [name for name, points in self.rigid.items() if point in points]

    def host(self, point: str) -> str:
        """Return the body that carries a pin, the pin where none does; '' for the ground."""
        if point in self.mechanism.fixed:
            return ""
        return next(
            (b for b in self.on(point) if self.repeats((point,), self.rigid[b]) == 1), point
        )

    def repeats(self, host: Iterable[str], points: Iterable[str]) -> int:
        """Return how many equal parts put the same on what they share."""
        return int(self.mechanism.repeats(points) / self.mechanism.repeats(host))


def cutting(pose: Pose) -> Cutting:
    """Return how a mechanism, or one of its equal parts, is cut into free bodies."""
    return Cutting(pose, {body.name: body.points for body in _rigid(pose)})


def _rigid(pose: Pose) -> Iterator[Link | Slide]:
    loaded = set(bent(pose))
    for link in pose.mechanism.links:
        if len(link.points) > 2 or link.name in loaded:
            yield link
    yield from pose.mechanism.slides
