"""A drawing in the making: what is drawn so far, layer by layer, and where there is room."""

from collections.abc import Iterable, Iterator
from enum import IntEnum

from ..pose.places import Plane
from .drawing import Arc, Drawing, Label, Shape
from .labels import BesideLine, PlacedName, next_to, write
from .occupied import Occupied, Rectangle, stretches

MARGIN = 3.0
"""How much paper there is around a drawing, in millimetres."""


class Layer(IntEnum):
    """What covers what: a later layer what is in an earlier one."""

    COPIES = 0
    AXES = 1
    GROUND = 2
    WHEELS = 3
    PLATES = 4
    BODIES = 5
    JOINTS = 6
    PINS = 7
    LOADS = 8
    MEASURES = 9


class Sheet:
    """Shapes by layer, and labels."""

    def __init__(self) -> None:
        self._shapes: list[tuple[Layer, Shape]] = []
        self._names: list[PlacedName] = []
        self._labels: list[Label] = []
        self.occupied = Occupied()

    def draw(self, layer: Layer, shapes: Iterable[Shape]) -> None:
        """Draw shapes in a layer, over what it has already."""
        for shape in shapes:
            self._shapes.append((layer, shape))
            self.occupied.add(shape)

    def shade(self, layer: Layer, shapes: Iterable[Shape]) -> None:
        """Draw shapes in a layer that labels may cover."""
        self._shapes += [(layer, shape) for shape in shapes]

    def name(self, name: PlacedName) -> None:
        """Take what is to be written when all is drawn, so that no line crosses it."""
        self._names.append(name)

    def name_next_to(self, name: BesideLine) -> bool:
        """Write a name next to its line over what is drawn so far; return whether there is room."""
        label = next_to(name, self.occupied)
        if label is not None:
            self._labels.append(label)
        return label is not None

    def name_now(self, name: PlacedName) -> None:
        """Write a name where there is room for it over what is drawn so far."""
        label, leader = write(name, self.occupied)
        self._labels.append(label)
        self._shapes += [(Layer.MEASURES, line) for line in leader]

    def write(self, label: Label) -> None:
        """Write a label where it is."""
        self._labels.append(label)
        self.occupied.write(Rectangle(label.at, label.width, label.height))

    def extent(self, labels: Iterable[Label] = ()) -> tuple[Plane, Plane]:
        """Return the lower left and the upper right corner of all that is drawn, and of labels."""
        places = [*self._places(), *(end for label in labels for end in _corners(label))]
        xs, ys = [p.x for p in places], [p.y for p in places]
        return Plane(min(xs), min(ys)), Plane(max(xs), max(ys))

    def finished(self, title: str, description: str) -> Drawing:
        """Return the drawing, with names where there is room for them."""
        for name in self._names:
            self.name_now(name)
        labels = tuple(self._labels)
        low, high = self.extent(labels)
        margin = Plane(MARGIN, MARGIN)
        ordered = sorted(self._shapes, key=lambda pair: pair[0])
        shapes = tuple(shape for _, shape in ordered)
        return Drawing(title, description, shapes, labels, low.minus(margin), high.plus(margin))

    def _places(self) -> Iterator[Plane]:
        for _, shape in self._shapes:
            if isinstance(shape, Arc) and shape.whole:
                reach = Plane(shape.radius, shape.radius)
                yield from (shape.centre.minus(reach), shape.centre.plus(reach))
            else:
                yield from (end for stretch in stretches(shape) for end in stretch)


def _corners(label: Label) -> tuple[Plane, Plane]:
    box = Rectangle(label.at, label.width, label.height)
    return box.low, box.high
