"""Statements of links and joints, of where they are, and of what drives them."""

from typing import Literal

from ...base.frozen import frozen
from .description import Statement
from .expressions import Cartesian, Direction, Expr, Name, Polar


@frozen
class Pivot(Statement):
    """``pivot O at (x, y)``: a pin fixed to the ground."""

    point: Name
    at: Cartesian | None = None


@frozen
class Slider(Statement):
    """``slider A along θ through O``: a point guided by the ground."""

    point: Name
    along: Direction
    through: Name | Cartesian | None = None


@frozen
class Link(Statement):
    """``link OBA "handle"``: one rigid body through its points."""

    points: Name
    label: str = ""


@frozen
class Slide(Statement):
    """``slide WXY along θ``: a body that only translates."""

    points: Name
    along: Direction


@frozen
class Slot(Statement):
    """``slot B in OC``: pin B slides along the line OC of the link that carries it.

    ``slot B in OAC about C radius r``: along a circle about point C of the link.
    ``slot B in OC guiding BD``: a block on B, fast in link BD, which turns with OC.
    """

    point: Name
    line: Name
    about: Name | None = None
    radius: Expr | None = None
    guided: Name | None = None


@frozen
class Telescope(Statement):
    """``telescope AB``: a two-part link of variable length."""

    points: Name


@frozen
class Gear(Statement):
    """``gear O1 r1 on O1A, O2 r2 inner``: ``on ground`` of a wheel that is fast in the ground."""

    first: Name
    first_radius: Expr
    second: Name
    second_radius: Expr
    inner: bool = False
    first_link: Name | None = None
    second_link: Name | None = None


@frozen
class Rack(Statement):
    """``rack A on O r``."""

    point: Name
    pivot: Name
    radius: Expr


@frozen
class Contact(Statement):
    """``contact A on BC normal θ``."""

    point: Name
    line: Name
    normal: Direction


@frozen
class Belt(Statement):
    """``belt O1 r1 on O1A, O2 r2 crossed``."""

    first: Name
    first_radius: Expr
    second: Name
    second_radius: Expr
    crossed: bool = False
    first_link: Name | None = None
    second_link: Name | None = None


Fall = tuple[Name, Direction | None]
"""Where a fall of a rope leads to, and its direction where it is written."""


@frozen
class Rope(Statement):
    """``rope A, K along -y, B along y``: from a point over pulleys to another one."""

    start: Name
    falls: tuple[Fall, ...]


@frozen
class Screw(Statement):
    """``screw A pitch p on OB``: turning OB moves slider A by p per turn."""

    point: Name
    pitch: Expr
    link: Name


Transmission = Gear | Rack | Contact | Belt | Screw | Rope
"""A statement of what passes motion on otherwise than by a pin or a guide."""


@frozen
class Drive(Statement):
    """``drive phi from a to b``, ``drive OA from a to b``: a parameter, or a link by its points.

    ``speed`` is how fast it is driven, at a constant rate. ``start`` is where a link is moved
    to from outside (``-D phi_OA=30deg``); no line says so.
    """

    name: Name
    low: Expr | None = None
    high: Expr | None = None
    speed: Expr | None = None
    start: Expr | None = None


@frozen
class Drawn(Statement):
    """``A at (x, y)``: where a point is drawn, at the default pose."""

    point: Name
    at: Cartesian


@frozen
class Vector(Statement):
    """``AB = l @ alpha`` and its kin."""

    points: Name
    value: Polar | Cartesian


@frozen
class Turn(Statement):
    """``angle ABC = gamma``: counter-clockwise at B from BA to BC."""

    points: Name
    angle: Expr


@frozen
class Assembly(Statement):
    """``assembly ABC ccw`` or ``assembly B forward``."""

    points: Name
    mode: Literal["cw", "ccw", "forward", "back"]


@frozen
class Mirror(Statement):
    """``mirror across θ sharing K L``."""

    across: Direction
    sharing: tuple[Name, ...] = ()


@frozen
class Copies(Statement):
    """``copies n sharing A``."""

    number: Expr
    sharing: tuple[Name, ...] = ()
