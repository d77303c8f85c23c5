"""Labels by hand: the places that are tried first, boxes that lines cross, lines that lead."""

import math
from itertools import islice

import pytest

from mechc.drawing.drawing import Arc, Polyline, TextRun
from mechc.drawing.labels import LABEL_DISTANCES, AlongArc, AroundPoint, BesideLine, next_to, write
from mechc.drawing.lettering import SIZE, text_size
from mechc.drawing.occupied import Occupied, Rectangle
from mechc.drawing.pens import AXIS, BODY, SYMBOL
from mechc.pose.places import Plane

NAME = (TextRun("A", italic=True),)
WIDTH, HEIGHT = text_size(NAME, SIZE)
ORIGIN, EAST, NORTH = Plane(0.0, 0.0), Plane(40.0, 0.0), Plane(0.0, 40.0)


def near(x, y):
    return pytest.approx((x, y))


def first(name, number=1):
    return [tuple(c.at) for c in islice(name.candidates(WIDTH, HEIGHT), number)]


def test_a_name_of_a_point_is_first_tried_where_it_is_wanted_then_on_either_side():
    there, left, right = first(AroundPoint(ORIGIN, NAME, SYMBOL, 0.0, 1.0), 3)
    assert there == near(1.0 + LABEL_DISTANCES[0] + WIDTH / 2, 0.0)
    assert left == near(right[0], -right[1])
    assert left[1] > 0


@pytest.mark.parametrize(
    ("end", "at"),
    [
        (EAST, (20.0, 0.6 + HEIGHT / 2)),
        (EAST.times(-1), (-20.0, 0.6 + HEIGHT / 2)),
        (NORTH, (-0.6 - WIDTH / 2, 20.0)),
        (NORTH.times(-1), (-0.6 - WIDTH / 2, -20.0)),
    ],
)
def test_a_name_of_a_line_is_first_tried_above_it_or_left_whichever_way_it_leads(end, at):
    one, opposite = first(BesideLine(ORIGIN, end, NAME, BODY), 2)
    assert one == near(*at)
    assert [a + b for a, b in zip(one, opposite, strict=True)] == near(end.x, end.y)


def test_a_name_of_an_arc_is_first_tried_outside_its_middle():
    (found,) = first(AlongArc(Arc(ORIGIN, 10.0, SYMBOL, 0.0, math.pi), NAME, SYMBOL))
    assert found == near(0.0, 10.0 + 0.6 + HEIGHT / 2)


def test_a_name_is_written_beside_what_is_there_and_takes_its_place():
    occupied, name = Occupied(), AroundPoint(ORIGIN, NAME, SYMBOL, 0.0)
    one, other = write(name, occupied), write(name, occupied)
    assert tuple(one.label.at) == near(LABEL_DISTANCES[0] + WIDTH / 2, 0.0)
    assert (one.leader, other.leader) == ((), ())
    boxes = (Rectangle(found.label.at, WIDTH, HEIGHT) for found in (one, other))
    assert not next(boxes).overlaps(next(boxes))


def test_a_line_leads_to_a_name_that_is_far_off():
    walls = [Arc(ORIGIN, radius, SYMBOL) for radius in (0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 6)]
    found = write(AroundPoint(ORIGIN, NAME, SYMBOL, 0.0), Occupied(walls))
    (leader,) = found.leader
    start, end = leader.points
    assert math.hypot(*start) == pytest.approx(1.5)
    assert math.dist(end, found.label.at) < math.dist(start, found.label.at)


def test_there_is_no_room_next_to_a_line_that_others_run_beside():
    lines = [Polyline((Plane(-9.0, y), Plane(50.0, y)), BODY) for y in (-2.5, -1.5, 1.5, 2.5)]
    assert next_to(BesideLine(ORIGIN, EAST, NAME, BODY), Occupied(lines)) is None
    assert next_to(BesideLine(ORIGIN, EAST, NAME, BODY), Occupied()) is not None


@pytest.mark.parametrize(
    ("line", "cuts"),
    [
        ((Plane(-5.0, 0.0), Plane(5.0, 0.0)), True),
        ((Plane(-5.0, 1.5), Plane(5.0, 1.5)), False),
        ((Plane(0.0, -5.0), Plane(0.0, 5.0)), True),
        ((Plane(3.0, -5.0), Plane(3.0, 5.0)), False),
        ((Plane(-3.0, -2.0), Plane(3.0, 2.0)), True),
        ((Plane(-3.0, 0.5), Plane(0.0, 3.5)), False),
        ((Plane(-9.0, 0.0), Plane(-3.0, 0.0)), False),
    ],
)
def test_a_line_passes_through_a_box_or_past_it(line, cuts):
    assert Rectangle(ORIGIN, 4.0, 2.0).cut_by(line) is cuts


def test_lines_that_others_may_cross_are_not_counted():
    bar, axis = (Polyline((Plane(0.0, -5.0), Plane(0.0, 5.0)), pen) for pen in (BODY, AXIS))
    across = Polyline((Plane(-5.0, 0.0), Plane(5.0, 0.0)), BODY)
    assert [Occupied([line]).crossed((across,)) for line in (bar, axis)] == [1, 0]
