"""The figure as data: points in metres, and the parts that a drawing shows.

Parts are called as in the description and name their points as it does; the twin of A is
``A'``, that of the link OA is ``OA'``. Directions are unit vectors, angles radians,
counter-clockwise from +x.
"""

from collections.abc import Mapping

from ..base.frozen import frozen, replace
from ..base.named import NamedTuple
from ..model.values import UsualUnits
from ..pose.places import Plane as Plane


class Segment(NamedTuple):
    """A stretch of a line: a guide, a face, a groove."""

    start: Plane
    end: Plane


# ------------------------------------------------------------------ bodies, joints


@frozen
class Link:
    """A rigid body.

    ``rods`` are the pairs of points between which it is drawn as bars; ``outline`` are the
    points at its corners, counter-clockwise: two where it is straight.
    """

    name: str
    points: tuple[str, ...]
    outline: tuple[str, ...]
    rods: tuple[tuple[str, str], ...]
    label: str


@frozen
class Slide:
    """A body that only translates along ``along``; ``guide`` is the line on which it does."""

    name: str
    points: tuple[str, ...]
    outline: tuple[str, ...]
    along: Plane
    guide: Segment


@frozen
class Telescope:
    """A link of variable length between two points."""

    name: str
    points: tuple[str, str]


@frozen
class Pivot:
    """A pin on the ground, whose hatch lies in the direction ``ground`` of it."""

    point: str
    ground: Plane


@frozen
class Slider:
    """A point that the ground guides; ``through`` is a point of its line, or empty."""

    point: str
    along: Plane
    guide: Segment
    through: str


@frozen
class Slot:
    """A pin in a groove of a body; ``along`` is the direction from ``tail`` to ``head``.

    A ``guided`` link is fast in a block on the pin.
    """

    point: str
    body: str
    tail: str
    head: str
    along: Plane
    groove: Segment
    guided: str = ""


@frozen
class ArcSlot:
    """A pin in a circular groove of a body, ``radius`` metres about the body's ``centre``."""

    point: str
    body: str
    centre: str
    radius: float


@frozen
class Contact:
    """A point that touches the face of a body, which pushes it along ``normal``."""

    point: str
    body: str
    normal: Plane
    face: Segment


@frozen
class Gears:
    """Two gears, fixed to the links on their pivots; one is inside the other where ``inner``.

    ``touch`` is the pitch point.
    """

    first: str
    first_link: str
    first_radius: float
    second: str
    second_link: str
    second_radius: float
    inner: bool
    touch: Plane


@frozen
class Belt:
    """A belt or chain about two wheels, fixed to the links on their pivots.

    ``runs`` are its straight stretches, from the first wheel to the second; there are none
    where the wheels are too near to each other.
    """

    first: str
    first_link: str
    first_radius: float
    second: str
    second_link: str
    second_radius: float
    crossed: bool
    runs: tuple[Segment, ...]


@frozen
class Rack:
    """A rack on a guided point, driven by a gear on ``pivot``.

    ``line`` is its pitch line, ``touch`` the pitch point; the wheel is on the left of
    ``along`` where ``radius`` is positive, else on the right.
    """

    point: str
    pivot: str
    link: str
    radius: float
    along: Plane
    line: Segment
    touch: Plane


@frozen
class Screw:
    """A screw that moves ``point`` by ``pitch`` along ``axis`` for each turn of ``link``."""

    point: str
    link: str
    pitch: float
    along: Plane
    axis: Segment


# --------------------------------------------------------------------------- loads


@frozen
class Rope:
    """A rope through ``points``, over a pulley at each but the first and the last one.

    ``runs`` are its straight stretches, ``pulleys`` the radii of the pulleys between.
    """

    points: tuple[str, ...]
    runs: tuple[Segment, ...]
    pulleys: tuple[float, ...]


@frozen
class Force:
    """A force on a point, or a weight; it counts ``times`` over.

    ``link`` is the link that carries it at a shared pin, empty where it acts on the pin.
    """

    name: str
    point: str
    along: Plane
    weight: bool
    times: float
    link: str


@frozen
class SpreadLoad:
    """A load spread over a body from ``tail`` to ``head``; its resultant acts at ``point``.

    ``tail_intensity`` and ``head_intensity`` are those at the ends, in N/m, or 1 where open.
    """

    name: str
    point: str
    along: Plane
    times: float
    link: str
    tail: str
    head: str
    tail_intensity: float
    head_intensity: float


@frozen
class Torque:
    """A couple on a link, drawn ``at`` a place; it counts ``times`` over."""

    name: str
    link: str
    at: Plane
    counterclockwise: bool
    times: float


@frozen
class Actuator:
    """A pair of forces that pushes two points apart; links as those of a :class:`Force`."""

    name: str
    first: str
    second: str
    first_link: str
    second_link: str


@frozen
class Spring:
    """A spring between two points; links as those of a :class:`Force`."""

    name: str
    first: str
    second: str
    first_link: str
    second_link: str


# -------------------------------------------------------------------- measurements


@frozen
class DimensionLine:
    """A distance measured along ``along``: its formula, and its value, which is positive."""

    tail: str
    head: str
    along: Plane
    text: str
    value: float


@frozen
class AngleMark:
    """A mark of the angle at ``vertex``, from the direction ``start`` on by ``sweep``."""

    vertex: str
    start: float
    sweep: float
    text: str


Joint = (
    Link | Slide | Telescope
    | Pivot | Slider | Slot | ArcSlot | Contact | Gears | Belt | Rack | Screw | Rope
)  # fmt: skip
Load = Force | SpreadLoad | Torque | Actuator | Spring
Measure = DimensionLine | AngleMark
Part = Joint | Load | Measure


@frozen
class MirrorLine:
    """The line between the halves, or about which the copies are, through a point of it."""

    at: Plane
    along: Plane


@frozen
class Figure:
    """A mechanism drawn at one pose: both mirrored halves, one branch of copies.

    ``values`` are those of the pose, in SI and radians: parameters, what loops give, and
    the lengths that were chosen, as nothing gives them. ``chosen`` names these, and the
    parameters without a value. ``copies`` is the number of branches about ``axis``.
    ``size`` is the length of a usual vector, by which symbols can be scaled; the ``units`` are
    those of the description.
    """

    name: str
    title: str
    points: Mapping[str, Plane]
    parts: tuple[Part, ...]
    mirror: MirrorLine | None
    copies: int
    axis: MirrorLine | None
    size: float
    values: Mapping[str, float]
    chosen: tuple[str, ...]
    units: UsualUnits


def with_links_called(figure: Figure, texts: Mapping[str, str]) -> Figure:
    """Return a figure in which links are called by what their labels are in ``texts``."""
    parts = (
        replace(part, label=texts.get(part.label, part.label)) if isinstance(part, Link) else part
        for part in figure.parts
    )
    return replace(figure, parts=tuple(parts))
