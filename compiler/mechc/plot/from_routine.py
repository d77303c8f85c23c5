"""From the program and what is asked for to a plot."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby, pairwise, product

import numpy as np

from ..base.frozen import replace
from ..diagnostics import MechcError, near_miss
from ..diagnostics import plot as messages
from ..model.mechanism import Mechanism
from ..pose.places import Plane
from ..routine.steps import Routine
from ..units import LENGTH
from .curves import limits, pieces, smooth
from .narrowing import NEAR_POINT, Array, ArrayFunction, narrowed, on
from .plot import Curve, FamilyValue, Mark, MarkKind, Panel, Plot, PlotAxis, Zone
from .quantities import PlotQuantity, quantities, unit_of
from .query import Query, ZoneCondition
from .sampling import Trace, traced
from .sweep import PlotRange, columns, in_units, known, plot_of, refuse_many, sweep_of

TURNING: Mapping[int, MarkKind] = {1: "minimum", -1: "maximum"}

Watch = Callable[[Sequence[ArrayFunction]], Iterable[ArrayFunction]]
"""What hands out the functions that are followed, and may show how many are done."""


def plot(mechanism: Mechanism, routine: Routine, query: Query, watch: Watch = iter) -> Plot:
    """Return the curves that are asked for; ``watch`` sees them done one after another.

    Raises :class:`MechcError` (E583 … E589, E599) where there is no such thing.
    """
    sweep = sweep_of(mechanism, quantities(routine, mechanism), query)
    return paths(sweep, query) if query.paths else _curves(sweep, query, watch)


def _asked(sweep: PlotRange, query: Query) -> list[PlotQuantity]:
    """Return the quantities that are asked for; else the first that varies, and has a value."""
    if query.ys:
        return known(sweep, query.ys)
    results = [q for q in sweep.known.values() if q.is_result]
    varying = [q for q in results if sweep.x.name in {i.name for i in q.inputs}] or results
    if not varying:
        raise MechcError([messages.nothing_of_this_name("nothing", list(sweep.known), "")])
    given = {*sweep.values, sweep.x.name, *(v.axis.name for s in sweep.settings for v in s)}
    complete = (q for q in varying if {i.name for i in q.inputs} <= given)
    return [next(complete, varying[0])]


def _curves(sweep: PlotRange, query: Query, watch: Watch) -> Plot:
    """Return results against a parameter: a panel for each dimension."""
    asked = _asked(sweep, query)
    refuse_many(len(asked) * len(sweep.settings))
    axes = {q.name: sweep.axis(q) for q in asked}
    together = groupby(sorted(asked, key=lambda q: _rank(q, asked)), key=lambda q: q.dimension)
    panels = tuple(_panel(sweep, list(group), axes, watch) for _, group in together)
    if not panels or not any(curve.pieces for panel in panels for curve in panel.curves):
        raise MechcError([messages.no_curve([q.name for q in asked], sweep.x.name)])
    table = columns(sweep, asked, query.points)
    return replace(plot_of(sweep, sweep.x, panels, table), zone=_zone(sweep, query.zone))


def _zone(sweep: PlotRange, conditions: Sequence[ZoneCondition]) -> Zone | None:
    """Return where conditions hold; E598 where there are several settings."""
    if not conditions:
        return None
    if len(sweep.settings) > 1:
        raise MechcError([messages.zone_of_a_family()])
    (setting,) = sweep.settings
    sides = zip(known(sweep, [c.name for c in conditions]), conditions, strict=True)
    functions = [_side(sweep.function(q, setting), q, condition) for q, condition in sides]
    words = tuple(f"{c.name} {c.sign} {c.bound}" for c in conditions)
    return Zone(words, stretches(functions, sweep.low, sweep.high))


def _side(
    function: ArrayFunction, quantity: PlotQuantity, condition: ZoneCondition
) -> ArrayFunction:
    """Return how far a quantity is on the side of its bound."""
    bound = in_units(condition.name, condition.bound, quantity.dimension)
    if condition.sign == ">=":
        return lambda x: function(x) - bound
    return lambda x: bound - function(x)


def _rank(quantity: PlotQuantity, asked: Sequence[PlotQuantity]) -> int:
    """Return where the first quantity of this dimension stands."""
    return [q.dimension for q in asked].index(quantity.dimension)


def _panel(
    sweep: PlotRange, group: Sequence[PlotQuantity], axes: Mapping[str, PlotAxis], watch: Watch
) -> Panel:
    """Return the panel of quantities of one dimension."""
    pairs = [(q, setting) for q in group for setting in sweep.settings]
    functions = [sweep.function(*pair) for pair in pairs]
    with np.errstate(all="ignore"):
        traces = [traced(f, sweep.low, sweep.high) for f in watch(functions)]
        there = [t for t in traces if np.isfinite(t.ys).any()]
        low, high = limits(there) if there else (0.0, 1.0)
        traces = [smooth(f, t, low, high) for f, t in zip(functions, traces, strict=True)]
    curves = (
        _curve(sweep, q, setting, trace, f)
        for (q, setting), trace, f in zip(pairs, traces, functions, strict=True)
    )
    return Panel(axes[group[0].name], tuple(curves), low, high)


def _curve(
    sweep: PlotRange,
    quantity: PlotQuantity,
    setting: tuple[FamilyValue, ...],
    trace: Trace,
    function: ArrayFunction,
) -> Curve:
    """Return the curve of a quantity: its pieces, and marks where it turns, is zero, is default."""
    parts = tuple(
        tuple(Plane(float(x), float(y)) for x, y in zip(xs, ys, strict=True))
        for xs, ys in pieces(trace)
    )
    x_least, y_least = NEAR_POINT * (sweep.high - sweep.low), _least(trace.ys)
    turns = ((t, Plane(_clean(t.x, x_least), _clean(t.y, y_least))) for t in trace.turns)
    marks = [Mark(TURNING[t.sense], at) for t, at in turns]
    marks += [Mark("zero", Plane(_clean(x, x_least), 0.0)) for x in trace.zeros]
    marks += _default(sweep, setting, function)
    return Curve(quantity.name, setting, parts, tuple(marks), trace.poles, trace.jumps)


def _least(values: Array) -> float:
    """Return the size below which a value counts as zero, against half of those that there are.

    Next to a pole values have any size.
    """
    sizes = np.abs(values[np.isfinite(values)])
    return NEAR_POINT * float(np.median(sizes)) if sizes.size else 0.0


def _clean(value: float, least: float) -> float:
    """Return a value, 0 where only rounding is left of it."""
    return value if abs(value) > least else 0.0


def _default(
    sweep: PlotRange, setting: Sequence[FamilyValue], function: ArrayFunction
) -> Iterator[Mark]:
    """Yield the pose of the description, if it is on the curve."""
    x = sweep.values.get(sweep.x.name, math.nan)
    is_described = all(v.value == sweep.values.get(v.axis.name) for v in setting)
    if is_described and sweep.low <= x <= sweep.high:
        y = float(function(np.array([x]))[0])
        if math.isfinite(y):
            yield Mark("default", Plane(x, y))


AxisEnds = tuple[float, float]


def stretches(functions: Sequence[ArrayFunction], low: float, high: float) -> tuple[AxisEnds, ...]:
    """Return the stretches of a range on which no function is negative.

    >>> [(round(a, 9), round(b, 9)) for a, b in stretches([np.sin], 1.0, 8.0)]
    [(1.0, 3.141592654), (6.283185307, 8.0)]
    """
    edges = {low, high}
    with np.errstate(all="ignore"):
        for function in functions:
            edges |= set(_edges(function, traced(function, low, high).xs))
        grid = sorted(edges)
        middles = np.array([(a + b) / 2 for a, b in pairwise(grid)])
        holds = np.all([f(middles) >= 0 for f in functions], axis=0)
    return tuple(_joined([pair for pair, so in zip(pairwise(grid), holds, strict=True) if so]))


def _edges(function: ArrayFunction, xs: Array) -> list[float]:
    """Return the last points at which a function is not negative, before and behind it is."""
    holds = function(xs) >= 0
    cells = np.flatnonzero(holds[:-1] != holds[1:])
    good = np.where(holds[cells], xs[cells], xs[cells + 1])
    bad = np.where(holds[cells], xs[cells + 1], xs[cells])
    return list(map(float, narrowed(lambda x: on(function, x) >= 0, good, bad)[0]))


def _joined(found: Sequence[AxisEnds]) -> list[AxisEnds]:
    """Return stretches with those that touch as one."""
    joined: list[AxisEnds] = []
    for low, high in found:
        if joined and joined[-1][1] == low:
            joined[-1] = joined[-1][0], high
        else:
            joined.append((low, high))
    return joined


# -------------------------------------------------------------------------------------------- paths


PATH_LINES = 720
"""How many straight lines the path of a point is made of."""

STATIONS = 12
"""At how many points the path of a point is marked."""

SAME_PLACE = 1e-9
"""Points nearer to each other than this, in metres, are one: the path comes back to its start."""


def paths(sweep: PlotRange, query: Query) -> Plot:
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
    panel = Panel(PlotAxis("y", LENGTH, unit), curves, min(ys), max(ys))
    table = columns(sweep, [q for pair in pairs for q in pair], query.points)
    return plot_of(sweep, PlotAxis("x", LENGTH, unit), (panel,), table)


def _coordinates(sweep: PlotRange, point: str) -> tuple[PlotQuantity, PlotQuantity]:
    """Return the coordinates of a point; E599 where it has none."""
    names = f"x_{point}", f"y_{point}"
    if not all(name in sweep.known for name in names):
        points = [name[2:] for name in sweep.known if name.startswith("x_")]
        able = [p for p in points if f"y_{p}" in sweep.known]
        raise MechcError([messages.no_point(point, able, near_miss(point, able))])
    return sweep.known[names[0]], sweep.known[names[1]]


def _path(
    sweep: PlotRange,
    point: str,
    pair: tuple[PlotQuantity, PlotQuantity],
    setting: tuple[FamilyValue, ...],
) -> Curve:
    """Return the path of a point in pieces, marked at even steps of the drive."""
    across, up = (sweep.function(q, setting) for q in pair)

    def at(grid: Array) -> list[Plane]:
        with np.errstate(all="ignore"):
            xs, ys = across(grid), up(grid)
        return [Plane(float(x), float(y)) for x, y in zip(xs, ys, strict=True)]

    parts = groupby(at(sweep.grid(PATH_LINES + 1)), key=lambda p: bool(np.isfinite(p).all()))
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
