"""A drawing as data: shapes and labels in millimetres on paper, x to the right, y upwards."""

import math
from typing import Literal

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..pose.places import Plane as Plane
from .pens import Pen

Fill = Literal["", "white", "light", "solid"]
"""What is inside a closed shape: nothing, paper, a tint, the colour of its pen."""


ARC_STEP = math.radians(10)
"""How far apart the points are by which the way of an arc is looked at."""


class Polyline(NamedTuple):
    """Straight lines from point to point, back to the first one where ``closed``."""

    points: tuple[Plane, ...]
    pen: Pen
    closed: bool = False
    fill: Fill = ""


class Arc(NamedTuple):
    """A part of a circle, from the direction ``start`` on by ``sweep`` radians; all by default."""

    centre: Plane
    radius: float
    pen: Pen
    start: float = 0.0
    sweep: float = math.tau
    fill: Fill = ""

    @property
    def whole(self) -> bool:
        """Return whether it is a full circle."""
        return abs(self.sweep) >= math.tau

    def at(self, part: float) -> Plane:
        """Return the point after a part of the sweep."""
        angle = self.start + part * self.sweep
        return self.centre.plus(Plane(math.cos(angle), math.sin(angle)).times(self.radius))

    def way(self) -> tuple[Plane, ...]:
        """Return points along it, near enough to one another to find what lies on it."""
        steps = max(2, math.ceil(abs(self.sweep) / ARC_STEP))
        return tuple(self.at(i / steps) for i in range(steps + 1))


Shape = Polyline | Arc


class TextRun(NamedTuple):
    """A piece of text in one type.

    ``level`` is −1 in an index, −2 in an index of that, +1 in an exponent.

    A ``unit`` is written in the letters of a language.
    """

    text: str
    italic: bool = False
    level: int = 0
    unit: bool = False


class Label(NamedTuple):
    """Text in the middle of a box around ``at``; ``width`` and ``height`` are those of the box."""

    at: Plane
    runs: tuple[TextRun, ...]
    pen: Pen
    size: float
    width: float
    height: float


@frozen
class Drawing:
    """Shapes in the order in which they cover each other, labels, and what the picture shows.

    ``low`` and ``high`` are the corners of the paper. At the heights ``between``, from the top
    down, rows of pictures meet.
    """

    title: str
    description: str
    shapes: tuple[Shape, ...]
    labels: tuple[Label, ...]
    low: Plane
    high: Plane
    between: tuple[float, ...] = ()
