"""Friction: the pairs of surfaces, each with its factor, its joint, and how it slips.

A pin of several links slips in each of them but the one that carries it.
"""

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import assert_never

from ..algebra.from_formula import to_product
from ..algebra.product import Product
from ..base.frozen import field, frozen
from ..base.named import NamedTuple
from ..formula.tree import Formula, product
from ..kinematics import contacts
from ..kinematics.joint_refs import JointRef, contact_at, members
from ..kinematics.plan import Plan, SpeedFactors
from ..kinematics.release import SpeedReading
from ..model.mechanism import (
    CollarFriction,
    FaceFriction,
    GuideFriction,
    JointFriction,
    PinFriction,
    PivotFriction,
    RopeFriction,
    Screw,
    ThreadFriction,
    WheelFriction,
    coulomb,
)
from ..pose.pose import Pose
from ..power.joint_forces import guiding
from . import slips

GivenForces = Mapping[str, Product]
"""The size of each given load."""


class FrictionPair(NamedTuple):
    """A pair of surfaces: ``factor · |force of the joint|`` resists its ``slip``.

    The factor is the radius of a friction circle in metres, against a relative rotation,
    or a number, against a sliding speed. ``name`` differs from those of the others: ``O``,
    ``B_AB``, ``A_guide``. The mechanism has ``number`` of them: one in each half or branch.
    Frictions ``besides`` press it by themselves, each by so much of it, and not through the joint
    alone.
    Where there is a ``thrust``, that is the force, whatever the joint passes on. Of a rope
    ``tensions`` are to each other, one on either side of a pulley.
    """

    name: str
    joint: JointRef
    factor: Product
    slip: SpeedReading
    number: Fraction = Fraction(1)
    besides: tuple[tuple[str, Product], ...] = ()
    thrust: Formula | None = None
    tensions: Product | None = None

    def speeds(self, plan: Plan) -> SpeedFactors:
        """Return the slip per unit of each drive."""
        return plan.value(self.slip(plan.graph))


@frozen
class LoadedPair:
    """A pair of surfaces in a mechanism under given loads, friction not yet known.

    Its pressing force has perpendicular ``components``, each ``ideal + Σ by[other] · f``
    with f the frictions as they act on the slips. ``slip`` is per unit speed of the
    driving load, times how often the mechanism has the pair and over how often it has
    the load, so that ``friction · |slip|`` is what it adds to the driving load: ``times`` says how
    often that is. ``plans`` are those by which the components were found.
    """

    pair: FrictionPair
    slip: Product
    components: tuple["Component", ...]
    plans: tuple[Plan, ...]
    times: Fraction = Fraction(1)

    @property
    def slip_of_one(self) -> Product:
        """Return the slip of one pair: halves and branches have theirs."""
        return self.slip.scaled(1 / self.times)


@frozen
class Component:
    """One component of a pressing force, and what each friction adds to it.

    That is as much again for every pair, and is made when the coupled equations need it.
    """

    ideal: Product
    by: Mapping[str, Product] = field(on_demand=True)


def friction_pairs(pose: Pose) -> tuple[FrictionPair, ...]:
    """Return all pairs of surfaces with friction, in the order of the text.

    There is none where the coefficient is written as 0, nor on a guide that halves or branches
    share: the side forces on it cancel.
    """
    found = (pair for given in pose.mechanism.friction.joints for pair in _of_joint(given, pose))
    return tuple(pair._replace(number=_number(pair.joint, pose)) for pair in found if pair.factor)


def _of_joint(given: JointFriction, pose: Pose) -> Iterator[FrictionPair]:
    """Yield the pairs of one joint with friction, with slip and what presses them."""
    match given:
        case PinFriction():
            yield from _pin(given, pose)
        case GuideFriction(point, factor):
            yield from _on_guide(point, factor, pose)
        case WheelFriction(id, kind, point, factor):
            joint = JointRef("mesh", point, id)
            yield FrictionPair(f"{point}_{kind}", joint, to_product(factor), slips.rim(joint, pose))
        case ThreadFriction(id, point, factor, thread):
            joint = JointRef("mesh", point, id)
            slip = slips.along_thread(joint, to_product(thread), pose)
            yield FrictionPair(f"{point}_screw", joint, to_product(factor), slip)
        case CollarFriction(id, point, factor, radius):
            joint = JointRef("mesh", point, id)
            slip = slips.on_collar(joint, to_product(radius), pose)
            pair = FrictionPair(f"{point}_collar", joint, to_product(factor), slip)
            yield pair._replace(besides=tuple(_thrusts(joint, pose)))
        case PivotFriction(point, link, factor, radius, thrust):
            joint, slip = JointRef("thrust", point, link), slips.at_radius(link, to_product(radius))
            pair = FrictionPair(f"{point}_collar", joint, to_product(factor), slip)
            yield pair._replace(thrust=thrust)
        case RopeFriction(id, point, factor=factor, tensions=ratio):
            joint = JointRef("mesh", pose.mechanism.joint(id).points[0], id)
            slip = slips.along_rope(given, pose)
            pair = FrictionPair(f"{point}_rope", joint, to_product(factor), slip)
            besides = tuple(_along_the_way(given, pose))
            yield pair._replace(besides=besides, tensions=to_product(ratio))
        case FaceFriction(point, factor):
            yield _face(point, factor, pose)
        case _:
            assert_never(given)


def _on_guide(point: str, factor: Formula, pose: Pose) -> Iterator[FrictionPair]:
    """Yield the pair of a point and its guide, unless halves or branches share the guide."""
    joint, guide = guiding(point, pose), pose.guide_of(point)
    if guide is None or _is_shared(joint, pose):
        return
    slip = slips.along_guide(point, guide)
    yield FrictionPair(f"{point}_guide", joint, to_product(factor), slip)


def _face(point: str, factor: Formula, pose: Pose) -> FrictionPair:
    """Return the pair of a pin and the face or the slot that it slides along."""
    if found := pose.mechanism.arc_at(point):
        rod, arc = found
        radius = product([(arc.radius, 1), (coulomb(factor), 1)])
        joint, slip = JointRef("pin", arc.centre, rod.name), slips.turning(rod.name, arc.link)
        return FrictionPair(f"{point}_face", joint, to_product(radius), slip)
    contact = contact_at(pose, point)
    slip, joint = slips.sliding(contact), JointRef("contact", point)
    return FrictionPair(f"{point}_face", joint, to_product(factor), slip)


def _pin(pin: PinFriction, pose: Pose) -> Iterator[FrictionPair]:
    links = [name for name in pose.mechanism.turning_at(pin.point) if name != pin.carrier]
    for link in links:
        name = pin.point if len(links) == 1 else f"{pin.point}_{link}"
        slip = slips.turning(link, pin.carrier)
        joint = JointRef("pin", pin.point, link)
        yield FrictionPair(name, joint, to_product(pin.radius), slip)


def _thrusts(joint: JointRef, pose: Pose) -> Iterator[tuple[str, Product]]:
    """Yield the axial force that a unit of friction in a screw's thread adds to its own.

    The collar carries both: all of the load on the nut.
    """
    screw = contacts.mesh_of(pose, joint.of)
    assert isinstance(screw, Screw), "a collar is on a screw"
    for given in pose.mechanism.friction.joints:
        if isinstance(given, ThreadFriction) and given.joint == joint.of:
            yield f"{joint.point}_screw", slips.lead_slope(screw, to_product(given.thread), pose)


def _along_the_way(given: RopeFriction, pose: Pose) -> Iterator[tuple[str, Product]]:
    """Yield by how much less friction on other pulleys of a rope stretches it here."""
    for other in pose.mechanism.friction.joints:
        if isinstance(other, RopeFriction) and other.joint == given.joint and other != given:
            half = Fraction(1 if given.place < other.place else -1, 2)
            yield f"{other.point}_rope", Product(half)


def radii(pairs: Iterable[FrictionPair]) -> dict[str, str]:
    """Return the symbol of the radius of each pin's friction circle, by the name of its pair.

    It is rho where all are alike, else rho and the name of the pair.
    """
    pins = [pair for pair in pairs if pair.joint.kind == "pin"]
    alike = len({pair.factor.formula() for pair in pins}) == 1
    return {pair.name: "rho" if alike else f"rho_{pair.name}" for pair in pins}


def reduced(pair: str) -> str:
    """Return the symbol of the reduced coefficient of a guide, face or pair.

    >>> reduced("C_guide")
    'mu_C'
    """
    return f"mu_{pair.partition('_')[0]}"


def _is_shared(joint: JointRef, pose: Pose) -> bool:
    return any(group.shares(members(pose, joint)) for group in pose.mechanism.symmetries)


def _number(joint: JointRef, pose: Pose) -> Fraction:
    return pose.mechanism.repeats(members(pose, joint))
