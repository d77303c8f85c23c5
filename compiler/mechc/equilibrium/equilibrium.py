"""A load found from the equilibrium of free bodies, step by step, as data.

Forces have names: loads their own, ``N_AB`` the force in a rod, ``X_O`` and ``Y_O`` the
components of the force at a pin, ``R_B_n`` and ``R_B_t`` those along an arm and across it,
``N_K`` what presses at a guide, a slot or a contact.
"""

from collections.abc import Mapping
from typing import Literal

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..model.parts.targets import ForceAtJoint, ResultTarget

JointForceKind = Literal[
    "rod", "pivot", "pin", "guide", "contact", "rim", "rack", "thread", "rope", "couple"
]
"""What passes a force on. A ``couple`` is that of a link in a slot that turns with it."""

LoadTerms = Mapping[str, Product]
"""A linear form in forces: how often each counts, by its name."""


class JointForce(NamedTuple):
    """A force to be found: its component or two, on what, and by what.

    ``subject`` are names of the drawing: of a rod its link; of a pivot the body that it acts on
    and the point, of a pin also the arm that its components are along and across, '' where they
    are those along x and y; of a guide the point, of a contact the pin and the body that pushes it;
    of a rim the centres of the wheels, of a rack the wheel's and its point; of a thread the screw
    and the nut; of a couple the link in the slot and the body that has it. A pin's and a pivot's
    act on the body, a couple on the link in the slot, others on the point: along the guide, across
    it to the left, or along the normal. That of a rim turns the first wheel counter-clockwise.
    """

    kind: JointForceKind
    names: tuple[str, ...]
    subject: tuple[str, ...]


class EquilibriumSum(NamedTuple):
    """A sum over all that acts on a body that is zero, counter-clockwise moments positive.

    Of moments it has the ``centre``; of forces the direction ``along``, which is that of the
    guide of the body or pin where it ``is_guide``. ``across`` is the rod that has no part in it.
    With a ``pin`` it is no sum over a body, but of what makes up the force there, on the body or,
    where that is '', of the ground.
    """

    body: str
    terms: LoadTerms
    centre: str = ""
    along: Angle | None = None
    is_guide: bool = False
    across: str = ""
    pin: str = ""


class FoundForce(NamedTuple):
    """A force in loads and in forces that were found before."""

    name: str
    terms: LoadTerms


class EquilibriumStep(NamedTuple):
    """The forces found next, from one sum, or from several that are solved together."""

    balances: tuple[EquilibriumSum, ...]
    found: tuple[FoundForce, ...]


@frozen
class Equilibrium:
    """The steps to a load or a force at a joint, the last of which gives it.

    ``load`` is its name on free bodies, ``forces`` are those that the steps mention. ``result`` is
    the name of what was asked for, the ``target``; ``parts`` is how many equal parts the mechanism
    has, of which one is looked at.
    """

    result: str
    target: ResultTarget
    load: str
    forces: tuple[JointForce, ...]
    steps: tuple[EquilibriumStep, ...]
    parts: int = 1

    @property
    def is_at_joint(self) -> bool:
        """Return whether a force at a joint was asked for, and not a load."""
        return isinstance(self.target, ForceAtJoint)
