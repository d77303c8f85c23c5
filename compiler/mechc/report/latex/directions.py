"""Directions as mathematics."""

from ...formula.tree import ZERO
from ...model.mechanism import Absolute, Direction
from ..languages.locale import Locale
from .notation import Notation, points
from .printer import latex


def math(tex: str) -> str:
    """Return inline mathematics."""
    return f"${tex}$"


def spaced(cell: str) -> str:
    r"""Return a cell of a table with room about its fractions, so that those of two rows part.

    >>> spaced("$a$"), spaced(r"$\frac{a}{2}$")
    ('$a$', '\\rule[-1.4ex]{0pt}{4.2ex}$\\frac{a}{2}$')
    """
    return rf"\rule[-1.4ex]{{0pt}}{{4.2ex}}{cell}" if r"\frac" in cell else cell


def direction(given: Direction, style: Notation) -> str:
    r"""Return a direction as mathematics: an angle, or along or square to a vector."""
    if isinstance(given, Absolute):
        return r"0^\circ" if given.angle == ZERO else latex(given.angle, style, angle=True)
    ends = (given.tail, given.head) if given.quarter < 2 else (given.head, given.tail)
    vector = rf"\overrightarrow{{{''.join(map(points, ends))}}}"
    return rf"\perp {vector}" if given.quarter % 2 else rf"\parallel {vector}"


def spoken(given: Direction, locale: Locale, style: Notation) -> str:
    """Return a direction as sentences say it, in words where the language has some."""
    kind = "absolute" if isinstance(given, Absolute) else "relative"
    return locale.directions[kind].format(angle=math(direction(given, style)))
