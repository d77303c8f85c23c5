"""The parts of a figure: what is drawn of each body, joint and load, in one half or its twin."""

from collections.abc import Iterator
from typing import assert_never

from ..model import mechanism as model
from ..model.twins import primed
from . import figure as drawn
from .figure import Part
from .half import Half
from .joints import drawn_joint, joints_shown
from .loads import drawn_load
from .outline import outline, rods


def parts(half: Half) -> Iterator[Part]:
    """Yield the drawn part of every body, joint and load."""
    mechanism = half.ways.pose.mechanism
    yield from (_drawn_body(body, half) for body in mechanism.bodies)
    yield from (drawn_joint(joint, half) for joint in joints_shown(mechanism))
    yield from (drawn_load(load, half) for load in mechanism.loads)


def _drawn_body(body: model.Body, half: Half) -> Part:
    """Return the drawn part of a body."""
    points = tuple(map(half.point, body.points))
    match body:
        case model.Link(arc=model.ArcSlot(link, centre, radius)):
            groove = half.length(radius)
            return drawn.ArcSlot(points[1], half.link(link), half.point(centre), groove)
        case model.Link(name):
            bars = rods(body, half.ways.pose.mechanism.geometry)
            named = tuple((half.point(a), half.point(b)) for a, b in bars)
            corners = outline(points, half.points)
            return drawn.Link(half.link(name), points, corners, named, body.label)
        case model.Slide(name):
            along = half.unit(half.ways.pose.slides[name])
            corners = outline(points, half.points)
            guide = half.line(along, *body.points)
            return drawn.Slide(half.link(name), points, corners, along, guide)
        case model.Telescope(name):
            own = name if points == body.points else primed(name)
            return drawn.Telescope(own, (points[0], points[1]))
        case _:
            assert_never(body)
