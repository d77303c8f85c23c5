"""Directions as mathematics."""

from ...formula.tree import ZERO
from ...model.mechanism import Absolute, Direction
from .notation import Notation, points
from .printer import latex


def math(tex: str) -> str:
    """Return inline mathematics."""
    return f"${tex}$"


def direction(given: Direction, style: Notation) -> str:
    r"""Return a direction as mathematics: an angle, or along or square to a vector."""
    if isinstance(given, Absolute):
        return r"0^\circ" if given.angle == ZERO else latex(given.angle, style, angle=True)
    ends = (given.tail, given.head) if given.quarter < 2 else (given.head, given.tail)
    vector = rf"\overrightarrow{{{''.join(map(points, ends))}}}"
    return rf"\perp {vector}" if given.quarter % 2 else rf"\parallel {vector}"
