"""Free-body diagrams as data: each body cut free, with all that acts on it.

Bodies and points are called as in the figure: the twin of A is ``A'``, that of the link OA
is ``OA'``. Forces are in newtons, couples in newton metres, counter-clockwise.
"""

import math
from collections.abc import Iterable, Mapping
from typing import Literal

from ...base.named import NamedTuple
from ...model.parts.joints import MeshKind
from ...pose.places import Plane as Plane

ActionKind = Literal[
    "load", "pin", "ground", "guide", "slot", "contact", MeshKind, "rope", "friction"
]
"""What an action comes from: a load, a joint, or the friction there."""

Gap = Literal["", "indeterminate", "transmission"]
"""Why a force isn't known: equilibrium leaves it open, or how teeth,
belts and threads press on the bearings is undetermined."""


ThreadMotion = Literal["", "tightening", "releasing"]

AT_PINS = ("pin", "ground")
"""Where the couple of friction shifts the force off its point; elsewhere it is a couple."""


class Acting(NamedTuple):
    """A force at a point of a body and a couple with it.

    ``by`` is the load, the body, the pin or ``ground`` that it comes from, or ``branches``: the
    other copies. ``point`` is empty where there is no force. ``force`` is None where it isn't
    known, and ``gap`` then says why.
    The couple at a pin is friction's, at the guide of a body that only translates that of the
    guide. ``chosen`` where the force depends on lengths that nothing gives.
    """

    kind: ActionKind
    by: str
    point: str
    force: Plane | None
    moment: float = 0.0
    gap: Gap = ""
    chosen: bool = False

    @property
    def offset(self) -> float | None:
        """Return how far off its point the line of action passes, in metres.

        Positive is on the right of the force's direction: the moment is then
        counter-clockwise. At a pin this is the radius of the friction circle.

        >>> Acting("pin", "AB", "A", Plane(0.0, 4.0), 2.0).offset
        0.5
        """
        size = math.hypot(*self.force) if self.force else 0.0
        return self.moment / size if size else None

    def about(self, centre: Plane, places: Mapping[str, Plane]) -> float:
        """Return the moment about a place, with points where they are drawn."""
        if not self.force or not self.point:
            return self.moment
        arm = places[self.point].minus(centre)
        return self.moment + arm.turned().dot(self.force)


class FreeBody(NamedTuple):
    """A link, a slide, or a pin on which more acts than the two links that it joins.

    A ``twin`` is in the half that the mirror adds.
    """

    name: str
    kind: Literal["link", "slide", "slider", "pin"]
    forces: tuple[Acting, ...]
    twin: bool


class Diagram(NamedTuple):
    """All free bodies under one set of loads, at one pose.

    ``loads`` are the sizes of those that act. Where ``per`` names one, its size is 1 and
    stands for any other: nothing gives it. ``left_out`` are loads that act as well, but whose
    sizes have nothing to do with that one. ``motion`` is the sense in which friction resists,
    empty where it is left out. ``trouble`` says why there are no bodies. Of copies one branch is
    shown, with its share of the loads that are common.
    """

    result: str
    motion: ThreadMotion
    loads: Mapping[str, float]
    per: str
    left_out: tuple[str, ...]
    bodies: tuple[FreeBody, ...]
    trouble: str = ""


def friction_circles(diagrams: Iterable[Diagram]) -> dict[str, float]:
    """Return the radii of the friction circles, in metres, by the points of their pins."""
    return {
        acting.point: abs(acting.offset)
        for diagram in diagrams
        for body in diagram.bodies
        for acting in body.forces
        if acting.kind in AT_PINS and acting.offset
    }
