"""Directions as vectors: sums of angles without their arcs, in numbers."""

import math

import pytest

from mechc.algebra.angle import Angle
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Symbol
from mechc.routine.direction_vectors import WANTED, DirectionVector, plain, whole

VALUES = {"alpha": 0.4, "beta": 1.1, "x": 3.0, "y": 4.0, "d": 5.0}
EXACT = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "cot": lambda u: 1 / math.tan(u),
    "sec": lambda u: 1 / math.cos(u),
    "csc": lambda u: 1 / math.sin(u),
}


@pytest.mark.parametrize("function", EXACT)
def test_each_function_is_that_of_the_sum_of_angles(function):
    """alpha − beta, and the direction of (3, 4) with its size undivided."""
    unit = whole(
        [
            plain(Angle.of("alpha")),
            plain(Angle.of("beta") * -1),
            DirectionVector(Symbol("x"), Symbol("y"), Symbol("d")),
        ]
    )
    angle = VALUES["alpha"] - VALUES["beta"] + math.atan2(4, 3)
    assert evaluate(WANTED[function](unit), VALUES) == pytest.approx(EXACT[function](angle))


def test_the_opposite_angle_is_the_mirror_image():
    unit = plain(Angle.of("alpha")).back()
    assert evaluate(unit.sin, VALUES) == pytest.approx(-math.sin(VALUES["alpha"]))
    assert evaluate(unit.cos, VALUES) == pytest.approx(math.cos(VALUES["alpha"]))
