"""Conditions of a sheet at its values: they hold, fail, or have a side without a value."""

import pytest

from mechc.calculation.calculation import Check
from mechc.calculation.from_pose import holds
from mechc.formula.tree import ZERO
from mechc.model.mechanism import Require
from small_poses import HERE

BELOW = Require(ZERO, "<", ZERO, HERE)


@pytest.mark.parametrize(
    ("left", "right", "known"),
    [(1.0, 2.0, True), (2.0, 1.0, False), (None, 1.0, True), (1.0, None, True), (None, None, True)],
)
def test_a_condition_holds_unless_its_values_say_otherwise(
    left: float | None, right: float | None, known: bool
) -> None:
    assert holds(Check(BELOW, left, right)) is known
