"""Forces at joints, by virtual power: the joint released, the driving loads held still.

A reaction is a linear form in the loads that are given; those that drive follow from them,
and do no work while they are held.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import Product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..formula.tree import ZERO
from ..kinematics.joint_refs import JointRef, contact_at, members
from ..kinematics.plan import Plan
from ..kinematics.release import ReleasedLinkage, released_linkage
from ..model.mechanism import Absolute, Force
from ..pose.pose import Pose
from .balance import Release, Term, equations_of
from .loads import shares, terms

HERE = "reaction"
"""The name of the force at a joint while it is a load; no name of a description."""


More = Callable[[Plan], Iterable[Term]]
"""The terms of further loads in a plan."""


class ForceTerm(NamedTuple):
    """A force along a direction, per unit of each given load."""

    direction: Angle
    amounts: Mapping[str, Product]

    def along(self, direction: Angle) -> Mapping[str, Product]:
        """Return the component in another direction."""
        turn = cosine(self.direction - direction)
        return {load: amount * turn for load, amount in self.amounts.items()}


@frozen
class Transmitted:
    """The force at a joint as the sum of pushes, and how each was found."""

    force_terms: tuple[ForceTerm, ...]
    releases: tuple[Release, ...]

    @property
    def plans(self) -> tuple[Plan, ...]:
        """Return the plans by which the pushes were found."""
        return tuple(release.plan for release in self.releases)

    def along(self, direction: Angle) -> dict[str, Product]:
        """Return the component in a direction as a linear form in the given loads."""
        parts: dict[str, list[Product]] = {}
        for push in self.force_terms:
            for load, amount in push.along(direction).items():
                parts.setdefault(load, []).append(amount)
        return {load: add(amounts) for load, amounts in parts.items()}


class Reactions:
    """Finds the force at one joint after another, each once.

    ``driving`` loads are held; ``more`` gives terms of further loads, such as friction.
    Long sums get names that those of the ``known`` plans do not have.
    """

    def __init__(
        self,
        pose: Pose,
        driving: Iterable[str],
        more: More = lambda plan: (),
        known: Iterable[Plan] = (),
    ) -> None:
        self._pose, self._more = pose, more
        self._driving = tuple(driving)
        self._held = [shares(pose.mechanism, name) for name in self._driving]
        self._known: dict[JointRef, Transmitted | None] = {}
        self._taken = frozenset(b.name for plan in known for b in plan.bindings)

    def of(self, joint: JointRef) -> Transmitted | None:
        """Return the force and couple that a joint transmits to the link or point that it holds.

        None where the other joints leave that undetermined.
        """
        if joint not in self._known:
            self._known[joint] = self._find(joint)
        return self._known[joint]

    def _find(self, joint: JointRef) -> Transmitted | None:
        """Return the force that a joint transmits, by a release for each component; else None."""
        releases: list[Release] = []
        for direction in directions(self._pose, joint):
            loose = released_linkage(self._pose, joint, direction, self._held, self._taken)
            powers = self._powers(loose, joint) if loose else ()
            amounts = amounts_of(powers, self._driving) if powers else None
            if loose is None or amounts is None:
                return None
            self._taken |= {binding.name for binding in loose.plan.bindings}
            releases.append(Release(*joint, direction, self._driving, loose.plan, powers, amounts))
        force_terms = tuple(ForceTerm(r.direction, r.amounts) for r in releases)
        return Transmitted(force_terms, tuple(releases))

    def _powers(self, loose: ReleasedLinkage, joint: JointRef) -> tuple[Term, ...]:
        """Return the terms of all loads, that of the joint's force last."""
        plan, span = loose.plan, self._pose.mechanism.span
        load = Force(HERE, joint.loose, Absolute(ZERO, span), span)
        count = Product(self._pose.mechanism.repeats(members(self._pose, joint)))
        here = Term(load, count, loose.parting, None)
        return (*terms(plan), *self._more(plan), here)


def amounts_of(powers: Sequence[Term], driving: Sequence[str]) -> Mapping[str, Product] | None:
    """Return the force at a joint per unit of each load but those that drive.

    The terms are those of the released linkage, that of the force among them. None where it has
    another motion in which a load works, or the force does no work.
    """
    equations = equations_of(powers)
    if equations.number != 1 or HERE not in equations.columns:
        return None
    others = [n for n in equations.columns if n not in (HERE, *driving)]
    return {n: equations.solve(HERE, [HERE], n) for n in others}


def directions(pose: Pose, joint: JointRef) -> tuple[Angle, ...]:
    """Return the directions in which a joint is asked for its force, which add up to all of it.

    What both mirrored halves share is pushed along the line only, as the pushes across it
    cancel.
    """
    shared = pose.mechanism.is_on_the_line(members(pose, joint))
    match joint.kind:
        case "contact":
            return (contact_at(pose, joint.point).normal,)
        case "mesh":
            return (Angle(),)
        case "ground" if joint.point in pose.guides:
            return () if shared else (pose.guides[joint.point] + QUARTER,)
        case _ if shared and pose.axis is not None:
            return (pose.axis,)
        case "slide":
            return () if shared else (pose.slides[joint.of] + QUARTER,)
        case "pin" if len(pose.frames[joint.of]) == 2:
            tail, head = pose.frames[joint.of]
            along = pose.vector(joint.of, tail, head)[0].angle
            return (along, along + QUARTER)
        case _:
            return (Angle(), QUARTER)
