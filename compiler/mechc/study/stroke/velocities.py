"""Velocity ratios along the stroke: how fast the loads' points move, per unit of the drive's speed.

The drive's speed is that of what it moves: the crank that it turns, the slider or the pair
of points that it shifts, else its own rate, written ``s'``.
"""

from collections.abc import Iterable, Iterator

from ...algebra.angle import rational
from ...algebra.product import Product
from ...algebra.sums import add, canonical
from ...base.named import NamedTuple
from ...formula.tree import Symbol
from ...formula.walk import symbols
from ...kinematics.plan import Plan
from ...model.mechanism import Arrow, ForcePair
from ...model.parts.linkage import primed
from ...power.balance import Balance, Term
from ...units import FREQUENCY, VELOCITY, Dimension
from .branches import rates_of
from .stroke import SpeedOf


class StrokeVelocity(NamedTuple):
    """A speed, or a ratio of two, and what it is ``about``."""

    about: tuple[SpeedOf, ...]
    dimension: Dimension
    value: Product

    @property
    def name(self) -> str:
        """Return the name of the speed, or of both."""
        return "/".join(speed.name for speed in self.about)


def velocities(balance: Balance) -> Iterator[StrokeVelocity]:
    """Yield the speed of each load's point along the load, or of its link, by the drive's."""
    plan = balance.plan
    drive = _drive(balance) if plan.mobility == 1 else None
    if drive is None or not drive.value:
        return
    open_lengths = plan.graph.pose.placeholders.keys()
    for speed in _distinct(balance.terms):
        ratio = canonical(speed.value / drive.value)
        if speed.name != drive.name and open_lengths.isdisjoint(symbols(ratio.formula())):
            dimension = speed.dimension.over(drive.dimension)
            yield StrokeVelocity((*speed.about, *drive.about), dimension, ratio)


def _distinct(terms: Iterable[Term]) -> Iterator[StrokeVelocity]:
    """Yield the speeds, named with the load too where loads act on a point in several ways."""
    speeds: dict[str, dict[str, StrokeVelocity]] = {}
    for term in terms:
        speed = _of_load(term)
        alike = speeds.setdefault(speed.name, {})
        if all(known.value != speed.value for known in alike.values()):
            alike[term.load.name] = speed
    for alike in speeds.values():
        for load, speed in alike.items():
            yield speed if len(alike) == 1 else _with_load(speed, load)


def _with_load(speed: StrokeVelocity, load: str) -> StrokeVelocity:
    """Return a speed under a name that has the load, too."""
    (about,) = speed.about
    return speed._replace(about=(about._replace(name=f"{about.name}({load})"),))


def _of_load(term: Term) -> StrokeVelocity:
    """Return the speed against which a load works."""
    load, speed = term.load, term.load.against
    about = SpeedOf(speed.name, speed.kind, speed.of, load.name if speed.kind == "load" else "")
    # Across the mirror the term has the first point's half of the rate.
    halves = 2 if isinstance(load, ForcePair) and load.joins_twins else 1
    dimension = FREQUENCY if speed.kind == "spin" else VELOCITY
    return StrokeVelocity((about,), dimension, term.speed[0].scaled(halves))


def _spin(link: str, spin: Product) -> StrokeVelocity:
    return StrokeVelocity((SpeedOf(f"omega_{link}", "spin", link),), FREQUENCY, spin)


def _drive(balance: Balance) -> StrokeVelocity | None:
    candidates = (_crank(balance.plan), _shifted(balance), _own_rate(balance.plan))
    return next((found for found in candidates if found is not None), None)


def _crank(plan: Plan) -> StrokeVelocity | None:
    """Return the spin of a link on a pivot that turns as fast as the drive."""
    pose = plan.graph.pose
    assert pose.mechanism.drive is not None
    drive = pose.mechanism.drive.parameter
    pivots = pose.mechanism.fixed
    for link in pose.mechanism.links:
        angles = (arm.angle for vector in pose.frames[link.name].values() for arm in vector)
        turns = any(a.terms in (((drive, 1),), ((drive, -1),)) for a in angles)
        if turns and not pivots.isdisjoint(link.points):
            return _spin(link.name, plan.spin(link.name)[0])
    return None


def _shifted(balance: Balance) -> StrokeVelocity | None:
    """Return the speed of what a drive shifts that is a length of the description."""
    pose = balance.plan.graph.pose
    assert pose.mechanism.drive is not None
    length = Symbol(pose.mechanism.drive.parameter)
    arrows = (a for a in pose.mechanism.geometry if isinstance(a, Arrow) and a.length == length)
    found = (_along_arrow(arrow, balance) for arrow in arrows)
    return next(filter(None, found), None)


def _along_arrow(arrow: Arrow, balance: Balance) -> StrokeVelocity | None:
    """Return the speed at which a vector grows: of a pair of forces, or of a point in its guide."""
    for term in balance.terms:
        if set(term.load.points) == {arrow.tail, arrow.head}:
            return _of_load(term)
    pose = balance.plan.graph.pose
    guide = pose.guide_of(arrow.head)
    if guide is None or arrow.tail not in pose.mechanism.fixed:
        return None
    speed = balance.plan.component(arrow.head, guide)[0]
    return StrokeVelocity((SpeedOf(f"V_{arrow.head}", "guide", arrow.head),), VELOCITY, speed)


def _own_rate(plan: Plan) -> StrokeVelocity | None:
    """Return the drive's rate, from a link whose direction is known to move with it."""
    pose = plan.graph.pose
    assert pose.mechanism.drive is not None
    drive, rates = pose.mechanism.drive.parameter, rates_of(pose)
    dimension = pose.mechanism.parameter(drive).dimension
    per_second = Dimension(dimension.length, dimension.mass, dimension.time - 1)
    for link in pose.mechanism.links:
        vectors = [v for v in pose.frames[link.name].values() if len(v) == 1]
        for vector in vectors:
            terms = vector[0].angle.terms
            pace = add(rates[n].scaled(rational(c)) for n, c in terms if n in rates)
            spin = plan.spin(link.name)[0]
            if pace and spin:
                return StrokeVelocity(
                    (SpeedOf(primed(drive), "rate", drive),), per_second, spin / pace
                )
    return None
