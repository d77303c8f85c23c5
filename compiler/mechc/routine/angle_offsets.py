"""Directions of one body, in which every correction of Newton's method takes one sine.

Vectors of a body point at its angle plus constants; ``sin(x + c)`` is written with the
sine and cosine of x where another constant goes with x.
"""

from collections import defaultdict
from collections.abc import Sequence

from ..algebra.angle import Angle, Rational
from ..algebra.from_formula import to_angle
from ..formula.tree import Call, Formula, is_call
from ..formula.walk import children, rebuild, walk
from .direction_vectors import plain

Offsets = defaultdict[Angle, set[Rational]]
"""The constants that go with an angle."""


def turned_alike(formulas: Sequence[Formula]) -> tuple[Formula, ...]:
    """Return formulas in which no angle occurs with two constants.

    >>> from ..formula.to_text import text
    >>> from ..formula.tree import Symbol, degrees, total
    >>> x = Symbol("x")
    >>> two = [Call("sin", (angle,)) for angle in (x, total([x, degrees(90)]))]
    >>> [text(f) for f in turned_alike(two)]
    ['sin(x)', 'cos(x)']
    """
    offsets = Offsets(set)
    for formula in formulas:
        for part in walk(formula):
            if angle := _turn(part):
                offsets[_bare(angle)].add(angle.degrees)
    return tuple(_written(f, offsets) for f in formulas)


def _turn(formula: Formula) -> Angle | None:
    """Return the angle of a sine or cosine."""
    if is_call(formula, "sin", "cos"):
        return to_angle(formula.arguments[0])
    return None


def _bare(angle: Angle) -> Angle:
    return Angle(angle.terms)


def _written(formula: Formula, offsets: Offsets) -> Formula:
    angle = _turn(formula)
    if angle and angle.terms and angle.degrees and len(offsets[_bare(angle)]) > 1:
        unit = plain(_bare(angle)).turned(plain(Angle.constant(angle.degrees)))
        return unit.sin if formula == Call("sin", children(formula)) else unit.cos
    parts = children(formula)
    return rebuild(formula, tuple(_written(p, offsets) for p in parts)) if parts else formula
