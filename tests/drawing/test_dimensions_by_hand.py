"""The marks of dimensions by hand: where their heads are, and which way these point."""

import math

import pytest

from mechc.drawing.dimensions import SMALL_HEAD, MeasureLine, _with_heads
from mechc.drawing.drawing import Arc, Polyline
from mechc.drawing.pens import MEASURE
from mechc.pose.places import NOWHERE, Plane

RADIUS = 20.0


def tip_and_foot(head):
    """Return where the head of an arrow ends, and the middle of its other side."""
    assert isinstance(head, Polyline)
    tip, left, right = head.points
    return tip, left.plus(right).times(0.5)


@pytest.mark.parametrize("start", [0.0, 2.5])
@pytest.mark.parametrize("sweep", [1.2, -1.2])
def test_the_heads_of_an_angle_point_along_its_arc_to_its_sides(start, sweep):
    arc, *heads = _with_heads(Arc(NOWHERE, RADIUS, MEASURE, start, sweep))
    part = SMALL_HEAD / RADIUS / abs(sweep)
    for head, end, inside in zip(heads, (0.0, 1.0), (part, 1 - part), strict=True):
        tip, foot = tip_and_foot(head)
        assert tip == arc.at(end)
        assert math.dist(foot, arc.at(inside)) < SMALL_HEAD / 100


def test_a_short_arc_has_no_heads():
    short = Arc(NOWHERE, RADIUS, MEASURE, 0.0, 2.9 * SMALL_HEAD / RADIUS)
    assert [*_with_heads(short)] == [short]


@pytest.mark.parametrize(("length", "inwards"), [(10.0, 1), (3.0, -1)])
def test_the_heads_of_a_length_come_from_outside_where_there_is_no_room(length, inwards):
    line, *heads = MeasureLine(NOWHERE, Plane(length, 0.0), ()).shapes()
    assert line == Polyline((NOWHERE, Plane(length, 0.0)), MEASURE)
    for head, at, way in zip(heads, (0.0, length), (1, -1), strict=True):
        tip, foot = tip_and_foot(head)
        assert tip == Plane(at, 0.0)
        assert foot.x == pytest.approx(at + way * inwards * SMALL_HEAD)
