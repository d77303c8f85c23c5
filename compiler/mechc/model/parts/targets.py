"""The targets of ``find``."""

from collections.abc import Mapping
from typing import Literal

from ...base.frozen import frozen, replace
from ...base.named import NamedTuple


class Speed(NamedTuple):
    """``V_D`` (kind ``point``) or ``omega_OB`` (kind ``link``; ``of`` is the link's name).

    Along an ``axis`` it is a component, ``V_D_x``.
    """

    kind: Literal["point", "link"]
    of: str
    axis: Literal["", "x", "y"] = ""

    @property
    def name(self) -> str:
        """Return the quantity's name as it is asked for."""
        prefix, axis = "V" if self.kind == "point" else "omega", self.axis and f"_{self.axis}"
        return f"{prefix}_{self.of}{axis}"


@frozen
class LoadRatio:
    """``P / F``."""

    above: str
    below: str


@frozen
class LoadForm:
    """``P`` as a linear form of all other loads."""

    load: str


@frozen
class SpeedRatio:
    """``V_D / V_A``."""

    above: Speed
    below: Speed


ComponentPart = Literal["x", "y", "size", "direction"]


@frozen
class Reaction:
    """``R_O``, or ``R_B on AB``: the force on the mechanism, or on one link, at a point.

    It is exerted by the ground where ``link`` is empty, else by all that meets the link at
    that pin. ``part`` is a component in N, the size in N, or the direction in radians.
    """

    point: str
    link: str
    part: ComponentPart


@frozen
class Axial:
    """``N_AB``: the force along a rod, or the tension of a rope that runs from A to B.

    ``link`` is the rod, or the rope's id; tension is positive. ``slot`` is the pin in a
    circular slot, which the rod stands for: the force on it is positive towards the centre.
    """

    link: str
    tail: str
    head: str
    slot: str = ""


@frozen
class Normal:
    """``N_A``: what a guide of the ground, a slot or a body in contact exerts on point A.

    Of a guide it counts along the guide's direction turned by +90°; of a slot or contact
    along the normal, so that a push is positive.
    """

    point: str


ForceAtJoint = Reaction | Axial | Normal
"""A force that a joint or a rod passes on."""


Sense = Literal["tightening", "releasing"]

SIGNS: Mapping[Sense, int] = {"tightening": 1, "releasing": -1}
"""The sign with which friction adds to the driving load."""


@frozen
class WithFriction:
    """A ratio, load or force with friction in it, the driving load moving along its arrow or back.

    ``order`` is that of the exact one, or the first in friction.
    """

    of: LoadRatio | LoadForm | ForceAtJoint
    sense: Sense
    order: Literal["exact", "first"] = "exact"


@frozen
class Efficiency:
    """The efficiency of a load ratio: k over k with friction, or the inverse."""

    of: LoadRatio | LoadForm
    sense: Sense


ResultTarget = LoadRatio | LoadForm | SpeedRatio | ForceAtJoint | WithFriction | Efficiency


def whole(target: ResultTarget) -> ResultTarget:
    """Return the force that a component or a direction is a part of; else the target itself.

    >>> whole(WithFriction(Reaction("O", "", "x"), "tightening"))
    WithFriction(of=Reaction(point='O', link='', part='size'), sense='tightening', order='exact')
    """
    match target:
        case WithFriction(Reaction() as force):
            return replace(target, of=whole(force))
        case Reaction():
            return replace(target, part="size")
        case _:
            return target


HOLDING = "_hold"
"""What the name of a result ends in at which the load above the line just holds."""

WITH_FRICTION = ("_f", "_f1", HOLDING)
"""What the names of results with friction end in."""


def drives_from_below(target: ResultTarget | None, name: str, driven: bool | None) -> bool:
    """Return whether the load below the line drives, as ``motion releasing`` of ``N/P`` means.

    Of ``k_hold`` it does as well, but there the load above the line is what is looked at.

    >>> n_f = WithFriction(LoadRatio("N", "P"), "releasing")
    >>> drives_from_below(n_f, "n_f", True), drives_from_below(n_f, "n_hold", True)
    (True, False)
    """
    match target:
        case WithFriction(LoadRatio(), "releasing", "exact"):
            return bool(driven) and not name.endswith(HOLDING)
        case _:
            return False


def drives_the_return(
    target: ResultTarget | None, driven: bool | None, value: float | None
) -> bool:
    """Return whether a load that others would drive back has to drive itself: they are held.

    Its power, that of a unit of its motion, is positive then, as that of k_hold < 0 is.

    >>> k_hold = WithFriction(LoadRatio("P", "F"), "releasing")
    >>> drives_the_return(k_hold, True, 0.2), drives_the_return(k_hold, True, -0.2)
    (False, True)
    """
    match target:
        case WithFriction(LoadRatio() | LoadForm(), sense, "exact") if value is not None:
            return bool(driven) and SIGNS[sense] * value > 0
        case _:
            return False
