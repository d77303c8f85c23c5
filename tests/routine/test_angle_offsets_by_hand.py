"""Sines and cosines of angles that differ by constants have the values that they had."""

import math
from itertools import product

import pytest

from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Call, Symbol, degrees, total
from mechc.formula.walk import walk
from mechc.routine.angle_offsets import turned_alike

X = Symbol("x")


@pytest.mark.parametrize("turn", [37, -90, 180])
def test_one_angle_is_left_and_no_value_is_another(turn):
    angles = X, total([X, degrees(turn)])
    before = [Call(name, (angle,)) for name, angle in product(("sin", "cos"), angles)]
    after = turned_alike(before)
    for x in (-2.0, 0.3, 1.7):
        found = [evaluate(formula, {"x": x}) for formula in after]
        assert found == pytest.approx([evaluate(formula, {"x": x}) for formula in before])
    left = {p.arguments[0] for f in after for p in walk(f) if isinstance(p, Call)}
    assert {evaluate(angle, {"x": 0.0}) for angle in left if angle != X} <= {math.radians(turn)}
    assert X in left
