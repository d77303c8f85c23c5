"""Polygons of velocities and of forces by hand: their scale, their places, the order of sides."""

from itertools import pairwise
from types import SimpleNamespace

import pytest

from mechc.drawing.force_polygon import PARALLEL_GAP, _sides, visible
from mechc.drawing.pens import RELATIVE, VELOCITY
from mechc.drawing.vectors import ForceVectors, VelocityVectors
from mechc.drawing.velocity_polygon import LARGE, _behind, _points, _PolygonMaker, velocity_scale
from mechc.figure.figure import Link, Slide, Slot
from mechc.figure.velocities import MotionVelocities, Sliding
from mechc.pose.places import NOWHERE, Plane


def velocities(slidings=(), **points):
    return MotionVelocities(
        "", {name: Plane(*at) for name, at in points.items()}, {}, tuple(slidings)
    )


@pytest.mark.parametrize(
    ("points", "extent"),
    [
        ({"A": (3, 0), "B": (-1, 2)}, 4),
        ({"A": (1, 2), "B": (2, 5)}, 5),
        ({"A": (-3, -7), "B": (-2, -1)}, 7),
    ],
)
def test_a_polygon_is_as_large_as_the_paper_takes_with_its_pole(points, extent):
    assert velocity_scale(velocities(**points)) == pytest.approx(LARGE / extent)


BAR = Link("AB", ("A", "B"), ("A", "B"), (("A", "B"),), "")


def maker(found, *parts):
    return _PolygonMaker(SimpleNamespace(parts=parts), found, VelocityVectors(found), 10.0)


def arrows(of):
    return [(a.tail, a.tip, a.pen) for a in of._arrows(of._nodes())]


def test_velocities_leave_the_pole_and_relative_ones_lead_from_tip_to_tip():
    a, b = Plane(20.0, 0.0), Plane(0.0, 30.0)
    found = arrows(maker(velocities(A=(2, 0), B=(0, 3)), BAR))
    assert found == [(NOWHERE, a, VELOCITY), (NOWHERE, b, VELOCITY), (a, b, RELATIVE)]


def test_what_is_nearly_one_velocity_is_one_place_and_what_rests_is_the_pole():
    pole, node = maker(velocities(A=(2, 0), B=(2.01, 0), C=(0, 0.02)), BAR)._nodes()
    assert (pole.points, node.points) == (("C",), ("A", "B"))
    assert arrows(maker(velocities(A=(2, 0), B=(2.01, 0)), BAR)) == [
        (NOWHERE, Plane(20.0, 0.0), VELOCITY)
    ]


def test_a_pin_slides_from_the_point_of_the_slot_under_it():
    """The pin A moves by (2, 1); along its slot by (0, 1), so that (2, 0) is under it."""
    of = maker(velocities([Sliding("A", "QB", Plane(0.0, 1.0))], A=(2, 1)))
    (found,) = of._sides(of._nodes())
    assert (found.start.at, found.end.at) == (Plane(20.0, 0.0), Plane(20.0, 10.0))
    assert found.points == ("QB", "A")


def test_a_pin_in_a_slide_moves_relative_to_any_point_of_it():
    slot = Slot("A", "XY", "X", "Y", Plane(0.0, 1.0), (NOWHERE, NOWHERE))
    slide = Slide("XY", ("X", "Y"), ("X", "Y"), Plane(1.0, 0.0), (NOWHERE, NOWHERE))
    assert list(maker(velocities(A=(2, 1), X=(2, 0)), slide, slot)._pairs()) == [("X", "A")]


def test_an_arrow_on_a_shorter_one_is_named_beyond_its_tip():
    places = [Plane(10.0, 0.0), Plane(20.0, 0.1), Plane(-15.0, 0.0), Plane(0.0, 5.0)]
    nodes = [(at, ("A",), ()) for at in places]
    assert _behind(Plane(30.0, 0.0), nodes) == Plane(20.0, 0.1)
    assert _behind(Plane(10.0, 0.0), nodes) == NOWHERE


# ---------------------------------------------------------------------------- forces


def test_forces_go_head_to_tail():
    steps = [Plane(3.0, 0.0), Plane(0.0, 4.0), Plane(-3.0, -4.0)]
    ends = [NOWHERE, Plane(3.0, 0.0), Plane(3.0, 4.0), NOWHERE]
    assert _sides(steps) == list(pairwise(ends))


def test_parallel_forces_that_lead_back_are_beside_those_ahead():
    sides = _sides([Plane(10.0, 0.0), Plane(-4.0, 0.0), Plane(-6.0, 0.0)])
    assert [(tail.y, tip.y) for tail, tip in sides] == [
        (0, 0),
        (PARALLEL_GAP, PARALLEL_GAP),
        (PARALLEL_GAP, PARALLEL_GAP),
    ]
    assert [(tail.x, tip.x) for tail, tip in sides] == [(0, 10), (10, 6), (6, 0)]


def test_a_polygon_begins_with_a_load_and_goes_round_counter_clockwise():
    def acting(kind, *force):
        return SimpleNamespace(kind=kind, force=Plane(*force) if force else None)

    up, left, small = acting("pin", 0, 2), acting("pin", -1, 0), acting("pin", 1e-5, 0)
    load, nothing = acting("load", 0, -3), acting("pin", 1e-12, 0)
    body = SimpleNamespace(forces=[left, nothing, load, small, up, acting("pin")])
    forces = ForceVectors(SimpleNamespace(), SimpleNamespace(bodies=[body]), {})
    assert visible(forces, body) == [load, small, up, left]


def test_a_small_force_across_leaves_parallel_ones_beside_each_other():
    sides = _sides([Plane(10.0, 0.0), Plane(0.0, 1e-4), Plane(-10.0, 0.0)])
    assert [round(tail.y, 3) for tail, _ in sides] == [0, 0, PARALLEL_GAP]


def test_a_link_under_a_pin_is_named_by_its_points_and_a_slide_by_its_name():
    figure = SimpleNamespace(parts=[BAR, Link("QC", ("Q", "C"), (), (), "")])
    assert _points(figure, "QC") == ("Q", "C")
    assert _points(figure, "XY") == ("XY",)
