"""The pens of pictures: how wide each kind of line is, and of which colour."""

from ..base.named import NamedTuple


class Pen(NamedTuple):
    """How a line is drawn: its width and dashes in millimetres, its colour as ``#rrggbb``."""

    name: str
    width: float
    colour: str = "#000000"
    dashes: tuple[float, ...] = ()


BODY = Pen("body", 0.7)
SYMBOL = Pen("symbol", 0.35)
HATCH = Pen("hatch", 0.18)
AXIS = Pen("axis", 0.18, "#777777", (3.0, 0.8, 0.4, 0.8))
MEASURE = Pen("measure", 0.18, "#1f4e79")
FORCE = Pen("force", 0.5, "#b00020")
VELOCITY = Pen("velocity", 0.5, "#15803d")
RELATIVE = Pen("relative", 0.35, "#1f4e9e")
COPY = Pen("copy", 0.35, "#aaaaaa")
PENS = (BODY, SYMBOL, HATCH, AXIS, MEASURE, FORCE, VELOCITY, RELATIVE, COPY)
