"""The paths of points while the drive moves."""

import math
from itertools import groupby, product

import numpy as np

from ..diagnostics import MechcError, near_miss
from ..diagnostics import plot as messages
from ..pose.places import Plane
from ..units import LENGTH
from .plot import Axis, Curve, Mark, Panel, Plot, Value
from .quantities import Array, Quantity, unit_of
from .query import Query
from .sweep import Sweep, columns, plot_of, refuse_many

CELLS = 720
"""How many straight lines the path of a point is made of."""

STATIONS = 12
"""At how many points the path of a point is marked."""

SAME_PLACE = 1e-9
"""Points nearer to each other than this, in metres, are one: the path comes back to its start."""


def paths(sweep: Sweep, query: Query) -> Plot:
    """Return the paths of points while the drive moves, on equal axes."""
    pairs = [_coordinates(sweep, point) for point in query.paths]
    refuse_many(len(pairs) * len(sweep.settings))
    unit = unit_of(LENGTH, sweep.mechanism)
    curves = tuple(
        _path(sweep, point, pair, setting)
        for (point, pair), setting in product(zip(query.paths, pairs, strict=True), sweep.settings)
    )
    ys = [p.y for curve in curves for piece in curve.pieces for p in piece]
    if not ys:
        raise MechcError([messages.no_curve(query.paths, sweep.x.name)])
    panel = Panel(Axis("y", LENGTH, unit), curves, min(ys), max(ys))
    table = columns(sweep, [q for pair in pairs for q in pair], query.points)
    return plot_of(sweep, Axis("x", LENGTH, unit), (panel,), table)


def _coordinates(sweep: Sweep, point: str) -> tuple[Quantity, Quantity]:
    """Return the coordinates of a point; E599 where it has none."""
    names = f"x_{point}", f"y_{point}"
    if not all(name in sweep.known for name in names):
        points = [name[2:] for name in sweep.known if name.startswith("x_")]
        able = [p for p in points if f"y_{p}" in sweep.known]
        raise MechcError([messages.no_point(point, able, near_miss(point, able))])
    return sweep.known[names[0]], sweep.known[names[1]]


def _path(
    sweep: Sweep, point: str, pair: tuple[Quantity, Quantity], setting: tuple[Value, ...]
) -> Curve:
    """Return the path of a point in pieces, marked at even steps of the drive."""
    across, up = (sweep.function(q, setting) for q in pair)

    def at(grid: Array) -> list[Plane]:
        with np.errstate(all="ignore"):
            xs, ys = across(grid), up(grid)
        return [Plane(float(x), float(y)) for x, y in zip(xs, ys, strict=True)]

    parts = groupby(at(sweep.grid(CELLS + 1)), key=lambda p: bool(np.isfinite(p).all()))
    whole = tuple(tuple(piece) for finite, piece in parts if finite)
    stations = sweep.grid(STATIONS + 1)
    marks = [
        Mark("station", p, float(s))
        for p, s in zip(at(stations), stations, strict=True)
        if np.isfinite(p).all()
    ]
    if len(marks) > 1 and math.dist(marks[0].at, marks[-1].at) < SAME_PLACE:
        marks.pop()
    return Curve(point, setting, tuple(p for p in whole if len(p) > 1), tuple(marks))
