"""What is drawn of each load, in one half or its twin."""

from typing import assert_never

from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..model import mechanism as model
from ..pose.places import NOWHERE, Plane
from . import figure as drawn
from .figure import Part
from .half import Half


def drawn_load(load: model.Load, half: Half) -> Part:
    """Return the drawn part of a load."""
    match load:
        case model.Force(spread=model.Spread() as spread):
            return _spread(load, spread, half)
        case model.Force(name, point):
            along, times = half.unit(half.ways.pose.lines[name]), float(load.times)
            link = load.link and half.link(load.link)
            return drawn.Force(name, half.point(point), along, load.weight, times, link)
        case model.Torque(name, link):
            at, times = _hub(link, half), float(load.times)
            return drawn.Torque(name, half.link(link), at, half.sense > 0, times)
        case model.ForcePair(name, first, second):
            kind = drawn.Spring if load.spring else drawn.Actuator
            links = (link and half.link(link) for link in (load.first_link, load.second_link))
            return kind(name, half.point(first), half.point(second), *links)
        case _:
            assert_never(load)


def _spread(load: model.Force, spread: model.Spread, half: Half) -> drawn.SpreadLoad:
    """Return the drawn part of a distributed load, an even one where its intensity is open."""
    values = half.ways.values
    given = all(symbols(q) <= values.keys() for q in spread.intensities)
    sizes = [evaluate(q, values) for q in spread.intensities if given] or [1.0]
    return drawn.SpreadLoad(
        load.name,
        half.point(load.point),
        half.unit(half.ways.pose.lines[load.name]),
        float(load.times),
        half.link(spread.link),
        half.point(spread.tail),
        half.point(spread.head),
        sizes[0],
        sizes[-1],
    )


def _hub(link: str, half: Half) -> Plane:
    """Return the place of a couple: the link's pivot, or its middle."""
    mechanism = half.ways.pose.mechanism
    points = tuple(half.ways.pose.frames[link])
    fixed = [p.point for p in mechanism.each(model.Pivot) if p.point in points]
    chosen = [half.at(p) for p in (fixed[:1] or points)]
    total = NOWHERE
    for at in chosen:
        total = total.plus(at)
    return total.times(1 / len(chosen))
