"""Guides and slots as vectors of open length, for loops that close through them."""

from collections.abc import Iterator
from typing import NamedTuple

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..model.mechanism import Mechanism
from ..source import Span
from .compass import Compass
from .pose import Arm
from .web import Edge


class Rail(NamedTuple):
    """A line on which a pin slides: where it starts, its direction, the name of the distance."""

    start: str
    pin: str
    angle: Angle
    span: Span

    @property
    def length(self) -> str:
        """Return the name of the distance from the start to the pin."""
        return f"len_{self.start}{self.pin}"

    @property
    def edge(self) -> Edge:
        """Return the vector from the start to the pin."""
        arm = Arm(Product.symbol(self.length), self.angle)
        return Edge(self.start, self.pin, (arm,), self.span)


def rails(mechanism: Mechanism, compass: Compass) -> Iterator[Rail]:
    """Yield the guides that pass through a point, then the slots."""
    for slider in mechanism.sliders:
        angle = compass.resolve(slider.along, f"theta_{slider.point}")
        if slider.through and angle is not None:
            yield Rail(slider.through, slider.point, angle, slider.span)
    for slot in mechanism.slots:
        if (angle := compass.of(slot.tail, slot.head)) is not None:
            yield Rail(slot.tail, slot.point, angle, slot.span)
