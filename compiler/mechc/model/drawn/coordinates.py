"""What moves a drawn mechanism, where it stands as drawn: the drive, and what no loop gives."""

import cmath
import math
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from copy import copy

from ...base.frozen import replace
from ...diagnostics import Report
from ..entries import mentioned
from ..mechanism import Arrow, Geometry, Mechanism, Pivot, Slider, Slot
from ..values import default_pose
from .driving import drawn_value, with_value
from .geared import Train
from .rigidity import Independent, RigidityRow, direction, fixed, rows_of, turn
from .sketch import Sketch


def with_coordinates(mechanism: Mechanism, sketch: Sketch, report: Report) -> Mechanism:
    """Return the mechanism with all that moves it standing as drawn.

    Drives have their values of the drawing, where they have none. Where all pins are drawn, so
    has a parameter that no loop gives one; what wheels alone lead moves as they do, and a
    link that nothing turns has the direction of the drawing. Reports E516.
    """
    waiting = {p.name: p for p in mechanism.parameters if p.value is None}
    ranks = _in_general(sketch) if _is_elsewhere(mechanism, sketch) else sketch
    held = Independent(_held(mechanism, waiting, ranks))
    is_whole = sketch.has_all(_pins(mechanism))
    driven = {drive.parameter for drive in mechanism.drives}
    found = {
        name: with_value(waiting[name], value)
        for name, value in _drawn_values(mechanism, waiting, held, sketch, ranks)
        if is_whole or name in driven
    }
    parameters = tuple(found.get(p.name, p) for p in mechanism.parameters)
    valued = replace(mechanism, parameters=parameters)
    if not is_whole:
        return valued
    standing = (*_led(valued, held, sketch, report), *_standing(mechanism, held, sketch, ranks))
    return replace(valued, geometry=(*mechanism.geometry, *standing))


MOVED_ASIDE = 0.01
"""How far points are moved, as a part of the drawing, to see how they hang together in general."""


def _is_elsewhere(mechanism: Mechanism, sketch: Sketch) -> bool:
    """Return whether a length is given that the drawing has not, so that it has another pose.

    Drawn in one line, rods hold their pin less than where they are in truth. What wheels lead is
    looked at where it is drawn.
    """
    slack = {d.point: d.slack for d in mechanism.drawn}
    given = (e for e in mechanism.geometry if isinstance(e, Arrow) and sketch.has(e))
    return not mechanism.meshes and any(
        abs(math.hypot(*sketch.way(e.tail, e.head)) - length)
        > slack.get(e.tail, 0.0) + slack.get(e.head, 0.0) + sketch.rounding
        for e in given
        if (length := sketch.value_of(e.length)) is not None
    )


def _in_general(sketch: Sketch) -> Sketch:
    """Return a drawing with its points moved a little, each in another direction."""
    far, moved = MOVED_ASIDE * sketch.size, copy(sketch)
    ways = (cmath.rect(far, 1.0 + n * n) for n in range(len(sketch.places)))
    moved.places = {
        point: place._replace(at=(place.at[0] + way.real, place.at[1] + way.imag))
        for (point, place), way in zip(sketch.places.items(), ways, strict=True)
    }
    return moved


def _drawn_values(
    mechanism: Mechanism,
    waiting: Collection[str],
    held: Independent,
    sketch: Sketch,
    ranks: Sketch,
) -> Iterator[tuple[str, float]]:
    """Yield parameters as measured in the drawing: drives, and those that no loop gives.

    What ``waiting`` parameters give is held from then on, as at the places of ``ranks``.
    """
    drives = [drive.parameter for drive in mechanism.drives]
    parts = [part for entry in mechanism.geometry for part in _parts(entry)]
    left = {n: _of(n, parts) for part in parts for n in sorted(mentioned(part) & set(waiting))}
    while left:
        by_loop = [n for n in left if any(_follows(part, held, ranks) for part in left[n])]
        name = next((d for d in drives if d in left), next(iter(by_loop or left)))
        given = left.pop(name)
        value = _measured(name, given, sketch)
        if value is not None and (name in drives or name not in by_loop):
            yield name, value
        for part in given:
            if mentioned(part).isdisjoint(left):
                _hold(part, held, ranks)


def _measured(name: str, parts: Iterable[Geometry], sketch: Sketch) -> float | None:
    """Return a parameter as measured in the drawing, by the first part that shows it."""
    values = (drawn_value(name, part, sketch) for part in parts)
    return next((value for value in values if value is not None), None)


def _hold(part: Geometry, held: Independent, sketch: Sketch) -> None:
    for row in rows_of(part, sketch):
        held.takes(row)


def _parts(entry: Geometry) -> tuple[Geometry, ...]:
    """Return the length and the direction of a vector by themselves."""
    if isinstance(entry, Arrow) and entry.length and entry.direction:
        return replace(entry, direction=None), replace(entry, length=None)
    return (entry,)


def _of(name: str, parts: Iterable[Geometry]) -> list[Geometry]:
    return [part for part in parts if name in mentioned(part)]


def _follows(part: Geometry, held: Independent, sketch: Sketch) -> bool:
    """Return whether what an entry gives is held already."""
    rows = list(rows_of(part, sketch))
    return bool(rows) and not any(map(held.lacks, rows))


def _led(
    mechanism: Mechanism, held: Independent, sketch: Sketch, report: Report
) -> Iterator[Geometry]:
    """Yield where links and sliders are that wheels alone lead, as the drive moves."""
    if mechanism.drive is None:
        return
    values = default_pose(mechanism)
    train = Train(mechanism, sketch, values)
    yield from train.followers(held)
    train.check(held, report)


def _pins(mechanism: Mechanism) -> frozenset[str]:
    """Return the points at which bodies are joined."""
    carried = Counter(p for body in mechanism.bodies for p in body.points)
    ground = mechanism.fixed | {s.point for s in mechanism.each(Slider)}
    return frozenset(p for p, number in carried.items() if number > 1 or p in ground)


def _standing(
    mechanism: Mechanism, held: Independent, sketch: Sketch, ranks: Sketch
) -> Iterator[Geometry]:
    """Yield the drawn directions of links that nothing turns."""
    for link in mechanism.links:
        arm = next(sketch.arms(link.points), None)
        if arm and held.takes(direction(*arm, ranks)):
            yield Arrow(*arm, None, sketch.direction(*arm), sketch.span(arm[1]))


def _held(mechanism: Mechanism, waiting: Collection[str], sketch: Sketch) -> Iterator[RigidityRow]:
    """Yield the rows that hold the drawn points: pivots, guides, slots, vectors.

    A vector holds none while a parameter in it is ``waiting`` for its value.
    """
    for pivot in mechanism.each(Pivot):
        yield from (fixed(pivot.point, turned) for turned in (0.0, math.pi / 2))
    guided = [(s.point, s.along) for s in mechanism.each(Slider)]
    guided += [(s.points[0], s.along) for s in mechanism.slides]
    for point, along in guided:
        if (turned := sketch.turned(along)) is not None:
            yield fixed(point, turned)
    for slot in mechanism.each(Slot):
        if sketch.has_all((slot.tail, slot.head, slot.point)):
            yield turn(slot.head, slot.tail, slot.point, sketch)
    for entry in mechanism.geometry:
        for part in _parts(entry):
            if mentioned(part).isdisjoint(waiting):
                yield from rows_of(part, sketch)
