"""The motion of a document: its quantities with values, and what they rest on."""

from types import SimpleNamespace

import pytest

from mechc.emit.json.document import moved
from mechc.formula.tree import Symbol, product, total
from mechc.pose.motion import Motion, MotionQuantity
from mechc.pose.pose import PoseDefinition
from mechc.units import LENGTH

A, B, T = map(Symbol, "abt")
NEEDED = (
    PoseDefinition("one", total([A, B])),
    PoseDefinition("two", product([(Symbol("one"), 2)])),
)
IDLE = PoseDefinition("idle", A)
PLACE = MotionQuantity(
    "x_C", "x_C", "place", "C", "x", LENGTH, product([(Symbol("two"), 1), (T, 1)])
)


MOTION = Motion((PLACE,), (NEEDED[0], IDLE, NEEDED[1]))


def compiled(values=None, motion=MOTION):
    figure = None if values is None else SimpleNamespace(values=values)
    return SimpleNamespace(motion=motion, figure=figure)


def test_only_what_a_quantity_rests_on_is_defined_at_whatever_remove():
    found = moved(compiled())
    assert [d.name for d in found.definitions] == ["one", "two"]


def test_quantities_have_their_values_at_the_pose_of_the_figure():
    ((quantity, value),) = moved(compiled({"a": 1.0, "b": 2.0, "t": 0.5})).quantities
    assert (quantity, value) == (PLACE, pytest.approx(4.5))


def test_a_quantity_has_no_value_where_nothing_is_drawn_or_something_is_open():
    for values in (None, {"a": 1.0, "t": 0.5}):
        assert moved(compiled(values)).quantities == ((PLACE, None),)


def test_what_does_not_move_has_no_motion():
    assert moved(compiled(motion=None)) is None
