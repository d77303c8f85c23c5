"""From a pose and numbers to the figure."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import assert_never

from ..base.frozen import fields, replace
from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..model import mechanism as model
from ..model.mechanism import Mechanism, Parameter
from ..model.parts.linkage import primed
from ..model.values import bounds, completed, defaults, following, independent, usual_units
from ..pose.places import NOWHERE, Plane
from ..pose.pose import Pose
from . import figure as drawn
from .dimensions import dimensions
from .figure import Figure, MirrorLine, Part
from .half import Half
from .joints import drawn_joint, joints_shown
from .layout import FigureLayout, lay_out, points_of
from .linear_vectors import LinearVectors
from .outline import outline, rods
from .tolerances import SAME_PLACE


def draw(pose: Pose, given: Mapping[str, float] | None = None) -> Figure | None:
    """Return the mechanism drawn at given values, None where it cannot be assembled.

    Values are SI and radians; the description gives those that are missing. A parameter to
    which it gives none is drawn in the middle of its range.
    """
    known = {**defaults(pose.mechanism), **(given or {})}
    chosen = {p.name: _middle(p) for p in _open(pose, known)}
    values = _solved(pose, {**chosen, **known})
    layout = None if values is None else _laid_out(pose, values)
    if values is None or layout is None:
        return None
    twins = _twins(layout, pose.mechanism)
    points = {**layout.points, **dict(_images(layout, twins))}
    values |= layout.lengths
    copies, vectors = pose.mechanism.copies, LinearVectors(pose, values)
    return Figure(
        name=pose.mechanism.name,
        title=pose.mechanism.title,
        points=points,
        parts=tuple(_parts(vectors, layout, points, twins)),
        mirror=layout.mirror,
        copies=int(copies.number) if copies else 1,
        axis=_axis(vectors, layout, copies.sharing) if copies else None,
        size=layout.size,
        values=values,
        chosen=(*chosen, *layout.lengths),
        units=usual_units(pose.mechanism),
    )


def _open(pose: Pose, known: Mapping[str, float]) -> list[Parameter]:
    return [p for p in independent(pose.mechanism) if p.name not in known]


def _middle(parameter: Parameter) -> float:
    return sum(bounds(parameter)) / 2


def _solved(pose: Pose, given: Mapping[str, float]) -> dict[str, float] | None:
    """Return all that has a value; None where a loop does not close.

    What closing found and nothing needs may well have none where the loop lies flat.
    """
    values = following(pose.mechanism, pose.definitions).complete(given)
    if not all(map(math.isfinite, values.values())):
        return None
    spare = completed(values, (d for d in pose.closing if d.name not in values))
    return {name: value for name, value in spare.items() if math.isfinite(value)}


def _laid_out(pose: Pose, values: Mapping[str, float]) -> FigureLayout | None:
    """Return the layout, None without points, or where a vector has no value or does not fit."""
    if not any(points_of(pose.mechanism)):
        return None
    try:
        layout = lay_out(LinearVectors(pose, values))
    except ZeroDivisionError:
        return None
    finite = all(math.isfinite(c) for at in layout.points.values() for c in at)
    return layout if finite and layout.gap < SAME_PLACE else None


def _axis(
    vectors: LinearVectors, layout: FigureLayout, sharing: Sequence[str]
) -> MirrorLine | None:
    """Return the line about which copies are: that on which a point of all of them is guided."""
    for point in sharing:
        if vectors.pose.guide_of(point) is not None:
            return MirrorLine(layout.points[point], vectors.guide(point))
    return None


def _twins(layout: FigureLayout, mechanism: Mechanism) -> dict[str, str]:
    """Return the points that the halves do not share, each with the name of its twin."""
    if mechanism.mirror is None:
        return {}
    return {name: primed(name) for name in layout.points if name not in mechanism.mirror.sharing}


def _images(layout: FigureLayout, twins: Mapping[str, str]) -> Iterator[tuple[str, Plane]]:
    """Yield where each twin is."""
    if mirror := layout.mirror:
        for name, twin in twins.items():
            arm = layout.points[name].minus(mirror.at)
            yield twin, mirror.at.plus(arm.reflected(mirror.along))


def _parts(
    vectors: LinearVectors,
    layout: FigureLayout,
    points: Mapping[str, Plane],
    twins: Mapping[str, str],
) -> Iterator[Part]:
    """Yield the parts of the described half, its measurements, then what the twin has of its own.

    What joins points that both halves share, or a point and its twin, is there once.
    """
    mirror = vectors.pose.mechanism.mirror
    shared = frozenset(mirror.sharing if mirror else ())
    images = {**{twin: name for name, twin in twins.items()}, **twins}
    half = Half(vectors, points, layout.size, shared, images, layout.mirror)
    yield from parts(half)
    yield from dimensions(half)
    if mirror is not None:
        both = zip(parts(half), parts(replace(half, sense=-1)), strict=True)
        yield from (image for part, image in both if _names(image) != _names(part))


def _names(part: Part) -> frozenset[str]:
    """Return every name in a part."""
    return frozenset(name for field in fields(part) for name in _texts(getattr(part, field.name)))


def _texts(value: object) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _texts(item)


def parts(half: Half) -> Iterator[Part]:
    """Yield the drawn part of every body, joint and load."""
    mechanism = half.vectors.pose.mechanism
    yield from (_drawn_body(body, half) for body in mechanism.bodies)
    yield from (drawn_joint(joint, half) for joint in joints_shown(mechanism))
    yield from (_drawn_load(load, half) for load in mechanism.loads)


def _drawn_body(body: model.Body, half: Half) -> Part:
    """Return the drawn part of a body."""
    points = tuple(map(half.point, body.points))
    match body:
        case model.Link(arc=model.ArcSlot(link, centre, radius)):
            groove = half.length(radius)
            return drawn.ArcSlot(points[1], half.link(link), half.point(centre), groove)
        case model.Link(name):
            bars = rods(body, half.vectors.pose.mechanism.geometry)
            named = tuple((half.point(a), half.point(b)) for a, b in bars)
            corners = outline(points, half.points)
            return drawn.Link(half.link(name), points, corners, named, body.label)
        case model.Slide(name):
            along = half.unit(half.vectors.pose.slides[name])
            corners = outline(points, half.points)
            guide = half.line(along, *body.points)
            return drawn.Slide(half.link(name), points, corners, along, guide)
        case model.Telescope(name):
            own = name if points == body.points else primed(name)
            return drawn.Telescope(own, (points[0], points[1]))
        case _:
            assert_never(body)


# -------------------------------------------------------------------------------------------- loads


def _drawn_load(load: model.Load, half: Half) -> Part:
    """Return the drawn part of a load."""
    match load:
        case model.Force(spread=model.Spread() as spread):
            return _spread(load, spread, half)
        case model.Force(name, point):
            along, times = half.unit(half.vectors.pose.lines[name]), float(load.times)
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
    values = half.vectors.values
    given = all(symbols(q) <= values.keys() for q in spread.intensities)
    sizes = [evaluate(q, values) for q in spread.intensities if given] or [1.0]
    return drawn.SpreadLoad(
        name=load.name,
        point=half.point(load.point),
        along=half.unit(half.vectors.pose.lines[load.name]),
        times=float(load.times),
        link=half.link(spread.link),
        tail=half.point(spread.tail),
        head=half.point(spread.head),
        tail_intensity=sizes[0],
        head_intensity=sizes[-1],
    )


def _hub(link: str, half: Half) -> Plane:
    """Return the place of a couple: the link's pivot, or its middle."""
    mechanism = half.vectors.pose.mechanism
    points = tuple(half.vectors.pose.frames[link])
    fixed = [p.point for p in mechanism.each(model.Pivot) if p.point in points]
    chosen = [half.at(p) for p in (fixed[:1] or points)]
    total = NOWHERE
    for at in chosen:
        total = total.plus(at)
    return total.times(1 / len(chosen))
