"""The syntax tree: what was written, in either notation, with its places.

Nothing is resolved here: names are text, numbers are the digits that were typed,
an order of statements is the order of the file. Both parsers build it and both
printers write it, so ``to_dsl(from_yaml(to_yaml(tree)))`` and ``to_dsl(tree)`` are
the same text (spans aside).

Sums and products are flat (a sum of 2,000 terms is one node), so that a tree is
never deeper than the nesting its author wrote, which the parsers limit to 64.
"""

from fractions import Fraction
from typing import Literal

from ..frozen import field, frozen
from ..source import Span
from ..units import Dimension

# --------------------------------------------------------------------- expressions


@frozen
class Name:
    """An identifier as written: a point ``A``, points ``OBA``, a parameter ``alpha``."""

    text: str
    span: Span = field(compare=False)


@frozen
class Number:
    """A number with the unit attached to it; ``digits`` are as typed, ``unit`` may be ''."""

    digits: str
    unit: str
    span: Span = field(compare=False)

    @property
    def value(self) -> Fraction:
        """Return the number exactly, in its own unit."""
        return Fraction(self.digits)


@frozen
class Symbol:
    """A name in an expression: a parameter, a load, a result, or ``V_D``, ``omega_OB``, ``R_O``."""

    name: str
    span: Span = field(compare=False)


@frozen
class Sum:
    """Terms in the order written, each with its sign (+1 or −1); a lone −x is a Sum too."""

    terms: tuple[tuple[int, "Expr"], ...]
    span: Span = field(compare=False)


@frozen
class Product:
    """Factors in the order written, each with +1 (times) or −1 (divided by)."""

    factors: tuple[tuple[int, "Expr"], ...]
    span: Span = field(compare=False)


@frozen
class Power:
    """``base ^ exponent``."""

    base: "Expr"
    exponent: "Expr"
    span: Span = field(compare=False)


@frozen
class Call:
    """A function of the language by its canonical name (``tg`` is read as ``tan``)."""

    function: str
    arguments: tuple["Expr", ...]
    span: Span = field(compare=False)


Expr = Number | Symbol | Sum | Product | Power | Call


# ---------------------------------------------------------------------- directions


@frozen
class Axis:
    """``x``, ``-x``, ``y`` or ``-y``."""

    axis: Literal["x", "y"]
    sign: int
    span: Span = field(compare=False)


@frozen
class Toward:
    """``AB``, ``-AB``, ``perp AB`` or ``-perp AB``: from A to B, back, turned by ±90 deg."""

    points: Name
    sign: int
    perp: bool
    span: Span = field(compare=False)


Direction = Axis | Toward | Expr
"""An angle counter-clockwise from +x, an axis, or the direction of a vector."""


@frozen
class Polar:
    """``length @ direction``; either may be missing, not both."""

    length: Expr | None
    direction: Direction | None
    span: Span = field(compare=False)


@frozen
class Cartesian:
    """``(x, y)``."""

    x: Expr
    y: Expr
    span: Span = field(compare=False)


# ---------------------------------------------------------------------- statements


@frozen
class Statement:
    """One line of a description. ``comments`` stand above it, ``remark`` behind it."""

    span: Span = field(compare=False)
    comments: tuple[str, ...] = field(default=(), kw_only=True)
    remark: str = field(default="", kw_only=True)


@frozen
class Version(Statement):
    """``mechc 1``."""

    number: str


@frozen
class Heading(Statement):
    """``mechanism NAME "Title"``; the title is '' where there is none."""

    name: Name
    title: str = ""


@frozen
class SheetHeading(Heading):
    """``sheet NAME "Title"``: the heading of a calculation sheet."""


@frozen
class SourceNote(Statement):
    """``source "where it comes from"``."""

    text: str


@frozen
class Param(Statement):
    """``param NAME = VALUE +- TOLERANCE in LOW .. HIGH as "label"``, ``param NAME: dimension``.

    ``replaced`` is the value of the line where one from outside stands in its place.
    """

    name: Name
    value: Expr | None = None
    low: Expr | None = None
    high: Expr | None = None
    dimension: Name | None = None
    label: str = ""
    about: str = ""
    tolerance: Expr | None = None
    replaced: Expr | None = None


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


@frozen
class Gravity(Statement):
    """``gravity along θ``."""

    along: Direction


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


@frozen
class Motion(Statement):
    """``motion tightening`` or ``motion releasing``."""

    sense: Literal["tightening", "releasing"]


@frozen
class Efficiency(Statement):
    """``efficiency eta``."""

    value: Expr


@frozen
class Find(Statement):
    """``find k = P / F``, ``find P``, ``find R_B on AB``; ``name`` is None where none was given."""

    target: Expr
    name: Name | None = None
    on: Name | None = None


@frozen
class Condition:
    """``a < b < c``: ``operators[i]`` stands between ``operands[i]`` and ``operands[i + 1]``."""

    operands: tuple[Expr, ...]
    operators: tuple[Literal["<", "<=", ">", ">=", "=", "!="], ...]


@frozen
class Branch:
    """``2*a when a < b and c > 0``: a value, and the conditions that all hold where it is meant."""

    value: Expr
    conditions: tuple[Condition, ...]


@frozen
class Choice:
    """``1 when a < b, 2 when a > b else 3``: of the branches one at most is meant."""

    branches: tuple[Branch, ...]
    otherwise: "Expr | Choice | None"
    span: Span = field(compare=False)


@frozen
class Lookup:
    """``m49 at 2*r/d``: what a table has for a value, between two of its rows in proportion.

    ``pitches at exactly d`` takes the row of the value itself, and has none between rows.
    """

    table: Name
    at: Expr
    span: Span = field(compare=False)
    exactly: bool = False


@frozen
class NextSize:
    """``next d_min in pins``: the smallest size of a list that is no less."""

    least: Expr
    sizes: Name
    span: Span = field(compare=False)


LetValue = Expr | Choice | Lookup | NextSize
"""The value of a ``let``."""


@frozen
class Let(Statement):
    """``let p = 4*P/(pi*d^2) in MPa as "label"``."""

    name: Name
    value: LetValue
    unit: Name | None = None
    label: str = ""


@frozen
class Use(Statement):
    """``use cylinder as cyl (P = 2*F)``: another sheet, what is ``given`` to its parameters.

    It is one of the library by its name, or a file by its path from this one's folder.
    ``use clamp as T at (x, y) turned θ joining T.C = B without F``: a mechanism that becomes
    a part of this one, where its origin lies and how it is turned.
    """

    used: Name
    prefix: Name
    given: tuple[tuple[Name, Expr], ...] = ()
    at: Cartesian | None = None
    turned: Expr | None = None
    joining: tuple[tuple[Name, Name], ...] = ()
    without: tuple[Name, ...] = ()


@frozen
class Given(Let):
    """The statement in place of a parameter of a used sheet, and the dimension of that.

    No line says so: it is made where the used sheet is put in.
    """

    parameter: Param = field(kw_only=True)
    measures: Dimension = field(kw_only=True)


@frozen
class Follows(Let):
    """The formula of a load that a ratio of a used mechanism gives, ``C_P = C_k*C_F``.

    No line says so: it is made where the used mechanism is put in.
    """


@frozen
class Translate(Statement):
    """``translate "arm" uk "плече" ru "плечо"``: what a text is in other languages, '' in none."""

    text: str
    en: str = ""
    uk: str = ""
    ru: str = ""


@frozen
class Taken(Statement):
    """A result of a used mechanism: what it measures, and the names of values that it rests on.

    No line says so: it is made where the mechanism is put in. ``asked`` is where the mechanism
    asks for it.
    """

    name: Name
    measures: Dimension
    rests_on: tuple[Symbol, ...]
    asked: Span


@frozen
class Brought(Statement):
    """A prefix under which something is used, what that is, and its loads that nothing gives.

    ``inner`` are its loads that it gives itself, such as weights, ``points`` the points of its
    bodies. No line says so: it stands where a sheet or a mechanism is put in.
    """

    prefix: str
    used: str
    loads: tuple[str, ...]
    inner: tuple[str, ...] = ()
    points: tuple[str, ...] = ()


@frozen
class Table(Statement):
    """``table m49 "Table 4.9" = 1: 0.388, 0.9: 0.400``: pairs of an argument and its value."""

    name: Name
    rows: tuple[tuple[Expr, Expr], ...]
    source: str = ""


@frozen
class Sizes(Statement):
    """``list bores "ISO 15552" = 32 mm, 40 mm``: sizes that there are, from the smallest."""

    name: Name
    sizes: tuple[Expr, ...]
    source: str = ""


@frozen
class Require(Statement):
    """``require 0 deg < alpha + theta < 90 deg``: a chain of comparisons.

    ``operators[i]`` stands between ``operands[i]`` and ``operands[i + 1]``.
    """

    operands: tuple[Expr, ...]
    operators: tuple[Literal["<", "<=", ">", ">=", "=", "!="], ...]


@frozen
class Expect(Statement):
    """``expect k = FORMULA`` or ``expect k = NUMBER +- TOLERANCE at alpha = 35 deg``."""

    subject: Expr
    value: Expr
    at: tuple[tuple[Name, Expr], ...] = ()
    tolerance: Expr | None = None


@frozen
class Reported(Statement):
    """``report scheme``, ``report k``, ``report plot k over alpha``: one thing that a report holds.

    ``over`` is what a plot is against, None for what is no plot.
    """

    name: Name
    over: Name | None = None


@frozen
class File:
    """A whole description: its statements in order, and the comments after the last one."""

    statements: tuple[Statement, ...]
    trailing: tuple[str, ...] = ()
