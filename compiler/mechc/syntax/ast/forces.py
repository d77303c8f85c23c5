"""Statements of loads and of friction."""

from typing import Literal

from ...base.frozen import frozen
from .description import Statement
from .expressions import Direction, Expr, Name


@frozen
class Force(Statement):
    """``force P = tie at A on AB along θ times n``; ``link`` is what carries it at a pin."""

    name: Name
    point: Name
    along: Direction
    tie: Expr | None = None
    times: Expr | None = None
    link: Name | None = None


@frozen
class Torque(Statement):
    """``torque M = tie on OA times n``: positive counter-clockwise."""

    name: Name
    link: Name
    tie: Expr | None = None
    times: Expr | None = None


@frozen
class Actuator(Statement):
    """``actuator P between A on OA and B on BC times n``: pushes A and B apart."""

    name: Name
    first: Name
    second: Name
    times: Expr | None = None
    first_link: Name | None = None
    second_link: Name | None = None


@frozen
class Spring(Statement):
    """``spring c between A on OA and B on BC free l0 times n``."""

    rate: Expr
    first: Name
    second: Name
    free: Expr
    times: Expr | None = None
    first_link: Name | None = None
    second_link: Name | None = None


@frozen
class Distributed(Statement):
    """``load Q intensity q1 to q2 on AB along θ``: a load spread over a stretch of a link.

    Q is its resultant. It is q per unit of length all along, or runs from q1 to q2.
    """

    name: Name
    line: Name
    along: Direction
    intensity: Expr | None = None
    end: Expr | None = None
    times: Expr | None = None


@frozen
class Weight(Statement):
    """``weight W mass m at G on OG times n``."""

    name: Name
    mass: Expr
    point: Name
    times: Expr | None = None
    link: Name | None = None


NamedLoad = Force | Torque | Actuator | Distributed | Weight
"""A statement that declares a load by its name."""

Load = NamedLoad | Spring
"""A statement of a load."""


@frozen
class Gravity(Statement):
    """``gravity along θ``."""

    along: Direction


@frozen
class PinFriction(Statement):
    """``friction pins f diameter d [journal|coulomb]``, or ``friction pin A f diameter d on AB``.

    ``point`` is None for all pins.
    """

    point: Name | None
    coefficient: Expr
    diameter: Expr
    law: Literal["", "journal", "coulomb"] = ""
    link: Name | None = None


@frozen
class GuideFriction(Statement):
    """``friction slider K mu [guide s overhang l] [couple|linear|edges]``."""

    point: Name
    coefficient: Expr
    length: Expr | None = None
    overhang: Expr | None = None
    law: Literal["", "couple", "linear", "edges"] = ""


@frozen
class RollerFriction(Statement):
    """``friction roller A f1 axle d wheel D``."""

    point: Name
    coefficient: Expr
    axle: Expr
    wheel: Expr


@frozen
class ContactFriction(Statement):
    """``friction contact A mu``."""

    point: Name
    coefficient: Expr


@frozen
class GearFriction(Statement):
    """``friction gear O1 c``: what the teeth of a pair lose, as a part of the force they pass."""

    point: Name
    coefficient: Expr


@frozen
class BeltFriction(Statement):
    """``friction belt O1 c``: what a belt loses, as a part of the force that it passes."""

    point: Name
    coefficient: Expr


@frozen
class RackFriction(Statement):
    """``friction rack A c``: what the teeth of rack A lose."""

    point: Name
    coefficient: Expr


@frozen
class ScrewFriction(Statement):
    """``friction screw A mu thread d``: Coulomb friction on a thread of mean diameter d."""

    point: Name
    coefficient: Expr
    thread: Expr


@frozen
class CollarFriction(Statement):
    """``friction collar A mu mean d``, or ``outer D inner d [wear|pressure]``: of screw A.

    Of a pivot with ``thrust W [faces n] [on OA]``: the force along its axis.
    """

    point: Name
    coefficient: Expr
    mean: Expr | None = None
    outer: Expr | None = None
    inner: Expr | None = None
    law: Literal["", "wear", "pressure"] = ""
    thrust: Expr | None = None
    faces: Expr | None = None
    link: Name | None = None


@frozen
class RopeFriction(Statement):
    """``friction rope B mu wrap theta [drum D on OC]``: a rope that slides around a pulley."""

    point: Name
    coefficient: Expr
    wrap: Expr
    drum: Expr | None = None
    link: Name | None = None


Friction = (
    PinFriction
    | GuideFriction
    | RollerFriction
    | ContactFriction
    | GearFriction
    | BeltFriction
    | RackFriction
    | ScrewFriction
    | CollarFriction
    | RopeFriction
)
"""A statement of friction somewhere."""


@frozen
class Motion(Statement):
    """``motion tightening`` or ``motion releasing``."""

    sense: Literal["tightening", "releasing"]


@frozen
class Efficiency(Statement):
    """``efficiency eta``."""

    value: Expr
