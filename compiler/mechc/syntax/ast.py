"""The syntax tree: what was written, in either notation, with its places.

Nothing is resolved here: names are text, numbers are the digits that were typed,
an order of statements is the order of the file. Both parsers build it and both
printers write it, so ``to_dsl(from_yaml(to_yaml(tree)))`` and ``to_dsl(tree)`` are
the same text (spans aside).

Sums and products are flat (a sum of 2,000 terms is one node), so that a tree is
never deeper than the nesting its author wrote, which the parsers limit to 64.
"""

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Literal

from ..source import Span

# --------------------------------------------------------------------- expressions


@dataclass(frozen=True, slots=True)
class Name:
    """An identifier as written: a point ``A``, points ``OBA``, a parameter ``alpha``."""

    text: str
    span: Span = field(compare=False)


@dataclass(frozen=True, slots=True)
class Number:
    """A number with the unit attached to it; ``digits`` are as typed, ``unit`` may be ''."""

    digits: str
    unit: str
    span: Span = field(compare=False)

    @property
    def value(self) -> Fraction:
        """Return the number exactly, in its own unit."""
        return Fraction(self.digits)


@dataclass(frozen=True, slots=True)
class Symbol:
    """A name in an expression: a parameter, a load, a result, or ``V_D``, ``omega_OB``, ``R_O``."""

    name: str
    span: Span = field(compare=False)


@dataclass(frozen=True, slots=True)
class Sum:
    """Terms in the order written, each with its sign (+1 or −1); a lone −x is a Sum too."""

    terms: tuple[tuple[int, "Expr"], ...]
    span: Span = field(compare=False)


@dataclass(frozen=True, slots=True)
class Product:
    """Factors in the order written, each with +1 (times) or −1 (divided by)."""

    factors: tuple[tuple[int, "Expr"], ...]
    span: Span = field(compare=False)


@dataclass(frozen=True, slots=True)
class Power:
    """``base ^ exponent``."""

    base: "Expr"
    exponent: "Expr"
    span: Span = field(compare=False)


@dataclass(frozen=True, slots=True)
class Call:
    """A function of the language by its canonical name (``tg`` is read as ``tan``)."""

    function: str
    arguments: tuple["Expr", ...]
    span: Span = field(compare=False)


Expr = Number | Symbol | Sum | Product | Power | Call


# ---------------------------------------------------------------------- directions


@dataclass(frozen=True, slots=True)
class Axis:
    """``x``, ``-x``, ``y`` or ``-y``."""

    axis: Literal["x", "y"]
    sign: int
    span: Span = field(compare=False)


@dataclass(frozen=True, slots=True)
class Toward:
    """``AB``, ``-AB``, ``perp AB`` or ``-perp AB``: from A to B, back, turned by ±90 deg."""

    points: Name
    sign: int
    perp: bool
    span: Span = field(compare=False)


Direction = Axis | Toward | Expr
"""An angle counter-clockwise from +x, an axis, or the direction of a vector."""


@dataclass(frozen=True, slots=True)
class Polar:
    """``length @ direction``; either may be missing, not both."""

    length: Expr | None
    direction: Direction | None
    span: Span = field(compare=False)


@dataclass(frozen=True, slots=True)
class Cartesian:
    """``(x, y)``."""

    x: Expr
    y: Expr
    span: Span = field(compare=False)


# ---------------------------------------------------------------------- statements


@dataclass(frozen=True, slots=True)
class Statement:
    """One line of a description. ``comments`` stand above it, ``remark`` behind it."""

    span: Span = field(compare=False)
    comments: tuple[str, ...] = field(default=(), kw_only=True)
    remark: str = field(default="", kw_only=True)


@dataclass(frozen=True, slots=True)
class Version(Statement):
    """``mechc 1``."""

    number: str


@dataclass(frozen=True, slots=True)
class Heading(Statement):
    """``mechanism NAME "Title"``; the title is '' where there is none."""

    name: Name
    title: str = ""


@dataclass(frozen=True, slots=True)
class SourceNote(Statement):
    """``source "where it comes from"``."""

    text: str


@dataclass(frozen=True, slots=True)
class Param(Statement):
    """``param NAME = VALUE in LOW .. HIGH as "label"`` or ``param NAME: dimension``."""

    name: Name
    value: Expr | None = None
    low: Expr | None = None
    high: Expr | None = None
    dimension: Name | None = None
    label: str = ""
    about: str = ""


@dataclass(frozen=True, slots=True)
class Pivot(Statement):
    """``pivot O at (x, y)``: a pin fixed to the ground."""

    point: Name
    at: Cartesian | None = None


@dataclass(frozen=True, slots=True)
class Slider(Statement):
    """``slider A along θ through O``: a point guided by the ground."""

    point: Name
    along: Direction
    through: Name | Cartesian | None = None


@dataclass(frozen=True, slots=True)
class Link(Statement):
    """``link OBA "handle"``: one rigid body through its points."""

    points: Name
    label: str = ""


@dataclass(frozen=True, slots=True)
class Slide(Statement):
    """``slide WXY along θ``: a body that only translates."""

    points: Name
    along: Direction


@dataclass(frozen=True, slots=True)
class Slot(Statement):
    """``slot B in OC``: pin B slides along the line OC of the link that carries it."""

    point: Name
    line: Name


@dataclass(frozen=True, slots=True)
class Telescope(Statement):
    """``telescope AB``: a two-part link of variable length."""

    points: Name


@dataclass(frozen=True, slots=True)
class Gear(Statement):
    """``gear O1 r1, O2 r2 inner``."""

    first: Name
    first_radius: Expr
    second: Name
    second_radius: Expr
    inner: bool = False


@dataclass(frozen=True, slots=True)
class Rack(Statement):
    """``rack A on O r``."""

    point: Name
    pivot: Name
    radius: Expr


@dataclass(frozen=True, slots=True)
class Contact(Statement):
    """``contact A on BC normal θ``."""

    point: Name
    line: Name
    normal: Direction


@dataclass(frozen=True, slots=True)
class Belt(Statement):
    """``belt O1 r1, O2 r2 crossed``."""

    first: Name
    first_radius: Expr
    second: Name
    second_radius: Expr
    crossed: bool = False


@dataclass(frozen=True, slots=True)
class Screw(Statement):
    """``screw A pitch p on OB``: turning OB moves slider A by p per turn."""

    point: Name
    pitch: Expr
    link: Name


@dataclass(frozen=True, slots=True)
class Drive(Statement):
    """``drive phi from a to b``."""

    name: Name
    low: Expr | None = None
    high: Expr | None = None


@dataclass(frozen=True, slots=True)
class Vector(Statement):
    """``AB = l @ alpha`` and its kin."""

    points: Name
    value: Polar | Cartesian


@dataclass(frozen=True, slots=True)
class Turn(Statement):
    """``angle ABC = gamma``: counter-clockwise at B from BA to BC."""

    points: Name
    angle: Expr


@dataclass(frozen=True, slots=True)
class Assembly(Statement):
    """``assembly ABC ccw`` or ``assembly B forward``."""

    points: Name
    mode: Literal["cw", "ccw", "forward", "back"]


@dataclass(frozen=True, slots=True)
class Force(Statement):
    """``force P = tie at A along θ times n``."""

    name: Name
    point: Name
    along: Direction
    tie: Expr | None = None
    times: Expr | None = None


@dataclass(frozen=True, slots=True)
class Torque(Statement):
    """``torque M = tie on OA times n``: positive counter-clockwise."""

    name: Name
    link: Name
    tie: Expr | None = None
    times: Expr | None = None


@dataclass(frozen=True, slots=True)
class Actuator(Statement):
    """``actuator P between A and B times n``: pushes A and B apart."""

    name: Name
    first: Name
    second: Name
    times: Expr | None = None


@dataclass(frozen=True, slots=True)
class Spring(Statement):
    """``spring c between A and B free l0 times n``."""

    rate: Expr
    first: Name
    second: Name
    free: Expr
    times: Expr | None = None


@dataclass(frozen=True, slots=True)
class Weight(Statement):
    """``weight W mass m at G times n``."""

    name: Name
    mass: Expr
    point: Name
    times: Expr | None = None


@dataclass(frozen=True, slots=True)
class Gravity(Statement):
    """``gravity along θ``."""

    along: Direction


@dataclass(frozen=True, slots=True)
class Mirror(Statement):
    """``mirror across θ sharing K L``."""

    across: Direction
    sharing: tuple[Name, ...] = ()


@dataclass(frozen=True, slots=True)
class Copies(Statement):
    """``copies n sharing A``."""

    number: Expr
    sharing: tuple[Name, ...] = ()


@dataclass(frozen=True, slots=True)
class PinFriction(Statement):
    """``friction pins f diameter d [journal|coulomb]``, or ``friction pin A f diameter d on AB``.

    ``point`` is None for all pins.
    """

    point: Name | None
    coefficient: Expr
    diameter: Expr
    law: Literal["", "journal", "coulomb"] = ""
    link: Name | None = None


@dataclass(frozen=True, slots=True)
class GuideFriction(Statement):
    """``friction slider K mu [guide s overhang l] [couple|linear|edges]``."""

    point: Name
    coefficient: Expr
    length: Expr | None = None
    overhang: Expr | None = None
    law: Literal["", "couple", "linear", "edges"] = ""


@dataclass(frozen=True, slots=True)
class RollerFriction(Statement):
    """``friction roller A f1 axle d wheel D``."""

    point: Name
    coefficient: Expr
    axle: Expr
    wheel: Expr


@dataclass(frozen=True, slots=True)
class ContactFriction(Statement):
    """``friction contact A mu``."""

    point: Name
    coefficient: Expr


@dataclass(frozen=True, slots=True)
class Motion(Statement):
    """``motion tightening`` or ``motion releasing``."""

    sense: Literal["tightening", "releasing"]


@dataclass(frozen=True, slots=True)
class Efficiency(Statement):
    """``efficiency eta``."""

    value: Expr


@dataclass(frozen=True, slots=True)
class Find(Statement):
    """``find k = P / F``, ``find P``, ``find R_B on AB``; ``name`` is None where none was given."""

    target: Expr
    name: Name | None = None
    on: Name | None = None


@dataclass(frozen=True, slots=True)
class Let(Statement):
    """``let p = 4*P/(pi*d^2)``."""

    name: Name
    value: Expr


@dataclass(frozen=True, slots=True)
class Require(Statement):
    """``require 0 deg < alpha + theta < 90 deg``: a chain of comparisons.

    ``operators[i]`` stands between ``operands[i]`` and ``operands[i + 1]``.
    """

    operands: tuple[Expr, ...]
    operators: tuple[Literal["<", "<=", ">", ">=", "=", "!="], ...]


@dataclass(frozen=True, slots=True)
class Expect(Statement):
    """``expect k = FORMULA`` or ``expect k = NUMBER at alpha = 35 deg, beta = 7 deg``."""

    subject: Expr
    value: Expr
    at: tuple[tuple[Name, Expr], ...] = ()


@dataclass(frozen=True, slots=True)
class File:
    """A whole description: its statements in order, and the comments after the last one."""

    statements: tuple[Statement, ...]
    trailing: tuple[str, ...] = ()
