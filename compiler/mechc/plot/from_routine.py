"""From the program and what is asked for to a plot."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import groupby, product

import numpy as np

from ..diagnostics import MechcError, near_miss
from ..diagnostics import plot as messages
from ..frozen import frozen, replace
from ..model.mechanism import Mechanism
from ..model.typed import in_si
from ..model.values import defaults, range_of
from ..pose.places import Plane
from ..routine.steps import Input, Routine
from ..units import LENGTH, USUAL_UNITS, Dimension
from .plot import Axis, Column, Curve, Mark, MarkKind, Panel, Plot, Value, Zone
from .quantities import Array, Quantity, quantities, unit_of
from .query import Condition, Given, Query
from .sampling import Function, Trace, limits, pieces, smooth, traced
from .zones import stretches

MOST = 12
"""How many curves a person can tell apart."""

CELLS = 720
"""How many straight lines the path of a point is made of."""

STATIONS = 12
"""At how many places the path of a point is marked."""

TURNING: Mapping[int, MarkKind] = {1: "minimum", -1: "maximum"}

Watch = Callable[[Sequence[Function]], Iterable[Function]]
"""What hands out the functions that are followed, and may tell how many are done."""


def plot(mechanism: Mechanism, routine: Routine, query: Query, watch: Watch = iter) -> Plot:
    """Return the curves that are asked for; ``watch`` sees them done one after another.

    Raises :class:`MechcError` (E583 … E589, E599) where there is no such thing.
    """
    known = quantities(routine, mechanism)
    sweep = _sweep(mechanism, known, query)
    return _paths(sweep, query) if query.paths else _curves(sweep, query, watch)


@frozen
class _Sweep:
    """What varies and between which ends, in which settings; values of all else."""

    mechanism: Mechanism
    known: Mapping[str, Quantity]
    x: Axis
    low: float
    high: float
    settings: tuple[tuple[Value, ...], ...]
    values: Mapping[str, float]

    def function(self, quantity: Quantity, setting: Sequence[Value]) -> Function:
        """Return the values of a quantity at places, with one setting of the family."""
        given = {**self.values, **{value.axis.name: value.value for value in setting}}
        lacking = [i.name for i in quantity.inputs if i.name not in (*given, self.x.name)]
        if lacking:
            raise MechcError([messages.no_value(quantity.name, lacking)])

        def at(places: Array) -> Array:
            found = quantity.at({**given, self.x.name: places})
            return np.broadcast_to(np.asarray(found, dtype=np.float64), places.shape).copy()

        return at

    def axis(self, quantity: Quantity) -> Axis:
        """Return a quantity's axis."""
        unit = unit_of(quantity.dimension, self.mechanism, quantity.unit)
        return Axis(quantity.name, quantity.dimension, unit)

    @property
    def places(self) -> Callable[[int], Array]:
        """Return so many places from one end to the other."""
        return partial(np.linspace, self.low, self.high)


# ------------------------------------------------------------------------ what is asked


def _sweep(mechanism: Mechanism, known: Mapping[str, Quantity], query: Query) -> _Sweep:
    inputs = {i.name: i for q in known.values() for i in q.inputs}
    inputs |= {p.name: _input(p.name, mechanism) for p in mechanism.parameters if not p.dependent}
    name = query.x or _driving(mechanism)
    x = _axis(name, inputs, mechanism)
    low, high = _ends(x, mechanism, query.ends)
    settings = tuple(product(*_family(query, x, inputs, mechanism)))
    return _Sweep(mechanism, known, x, low, high, settings, defaults(mechanism))


def _input(name: str, mechanism: Mechanism) -> Input:
    parameter = mechanism.parameter(name)
    return Input(name, parameter.dimension, parameter.unit)


def _driving(mechanism: Mechanism) -> str:
    """Return the drive; E587 where there is none."""
    if mechanism.drive is None:
        able = [p.name for p in mechanism.parameters if p.range and not p.dependent]
        raise MechcError([messages.nothing_to_vary(able)])
    return mechanism.drive.parameter


def _axis(name: str, inputs: Mapping[str, Input], mechanism: Mechanism) -> Axis:
    """Return the axis of a parameter; E584 where there is none that can be set."""
    if name not in inputs:
        near = near_miss(name, inputs)
        raise MechcError([messages.no_such_parameter(name, list(inputs), near)])
    found = inputs[name]
    return Axis(name, found.dimension, unit_of(found.dimension, mechanism, found.unit))


def _ends(
    x: Axis, mechanism: Mechanism, written: tuple[Given, Given] | None
) -> tuple[float, float]:
    """Return the ends of the range; E585 where there are none."""
    parameters = {p.name for p in mechanism.parameters}
    found = range_of(x.name, mechanism) if x.name in parameters else None
    if written is not None:
        low, high = sorted(_si(x.name, end, x.dimension) for end in written)
        found = low, high
    if found is None or not found[0] < found[1]:
        unit = f" {USUAL_UNITS.get(x.dimension, '')}".rstrip()
        raise MechcError([messages.no_range(x.name, f"10{unit} .. 80{unit}")])
    return found


def _family(
    query: Query, x: Axis, inputs: Mapping[str, Input], mechanism: Mechanism
) -> Iterator[list[Value]]:
    """Yield the values of each parameter of the family; E584 for what is along the axis."""
    for name, given in query.family:
        if name == x.name:
            others = [other for other in inputs if other != name]
            raise MechcError([messages.no_such_parameter(name, others, "it is along the axis")])
        axis = _axis(name, inputs, mechanism)
        yield [Value(axis, _si(name, value, axis.dimension)) for value in given]


def _si(name: str, given: Given, dimension: Dimension) -> float:
    """Return a value in SI that may be text with its unit."""
    return in_si(name, given, dimension) if isinstance(given, str) else float(given)


def _asked(sweep: _Sweep, query: Query) -> list[Quantity]:
    """Return the quantities that are asked for; else the first that varies, and has a value."""
    if query.ys:
        return _known(sweep, query.ys)
    results = [q for q in sweep.known.values() if q.is_result]
    varying = [q for q in results if sweep.x.name in {i.name for i in q.inputs}] or results
    if not varying:
        raise MechcError([messages.nothing_of_this_name("nothing", list(sweep.known), "")])
    given = {*sweep.values, sweep.x.name, *(v.axis.name for s in sweep.settings for v in s)}
    complete = (q for q in varying if {i.name for i in q.inputs} <= given)
    return [next(complete, varying[0])]


def _known(sweep: _Sweep, names: Sequence[str]) -> list[Quantity]:
    """Return quantities by name; E583 where there is none."""
    strange = [name for name in names if name not in sweep.known]
    if strange:
        able = list(sweep.known)
        found = [messages.nothing_of_this_name(n, able, near_miss(n, able)) for n in strange]
        raise MechcError(found)
    return [sweep.known[name] for name in names]


# -------------------------------------------------------------------------------- curves


def _curves(sweep: _Sweep, query: Query, watch: Watch) -> Plot:
    """Return results against a parameter: a panel for each dimension."""
    asked = _asked(sweep, query)
    _count(len(asked) * len(sweep.settings))
    axes = {q.name: sweep.axis(q) for q in asked}
    together = groupby(sorted(asked, key=lambda q: _rank(q, asked)), key=lambda q: q.dimension)
    panels = tuple(_panel(sweep, list(group), axes, watch) for _, group in together)
    if not panels or not any(curve.pieces for panel in panels for curve in panel.curves):
        raise MechcError([messages.no_curve([q.name for q in asked], sweep.x.name)])
    columns = _columns(sweep, asked, query.points)
    return replace(_plot(sweep, sweep.x, panels, columns), zone=_zone(sweep, query.zone))


def _zone(sweep: _Sweep, conditions: Sequence[Condition]) -> Zone | None:
    """Return where conditions hold; E598 where there are several settings."""
    if not conditions:
        return None
    if len(sweep.settings) > 1:
        raise MechcError([messages.zone_of_a_family()])
    (setting,) = sweep.settings
    sides = zip(_known(sweep, [c.name for c in conditions]), conditions, strict=True)
    functions = [_side(sweep.function(q, setting), q, condition) for q, condition in sides]
    words = " and ".join(f"{c.name} {c.sign} {c.bound}" for c in conditions)
    return Zone(words, stretches(functions, sweep.low, sweep.high))


def _side(function: Function, quantity: Quantity, condition: Condition) -> Function:
    """Return how far a quantity is on the side of its bound."""
    bound = _si(condition.name, condition.bound, quantity.dimension)
    if condition.sign == ">=":
        return lambda x: function(x) - bound
    return lambda x: bound - function(x)


def _rank(quantity: Quantity, asked: Sequence[Quantity]) -> int:
    """Return where the first quantity of this dimension stands."""
    return [q.dimension for q in asked].index(quantity.dimension)


def _count(number: int) -> None:
    if number > MOST:
        raise MechcError([messages.too_many_curves(number, MOST)])


def _plot(sweep: _Sweep, x: Axis, panels: tuple[Panel, ...], columns: tuple[Column, ...]) -> Plot:
    mechanism = sweep.mechanism
    parameters = {p.name for p in mechanism.parameters}
    given = range_of(sweep.x.name, mechanism) if sweep.x.name in parameters else None
    inside = given is None or (given[0] <= sweep.low and sweep.high <= given[1])
    return Plot(
        mechanism.title or mechanism.name,
        x,
        sweep.x,
        sweep.low,
        sweep.high,
        panels,
        columns,
        None if inside else given,
        equal=x is not sweep.x,
    )


def _panel(
    sweep: _Sweep, group: Sequence[Quantity], axes: Mapping[str, Axis], watch: Watch
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
    sweep: _Sweep,
    quantity: Quantity,
    setting: tuple[Value, ...],
    trace: Trace,
    function: Function,
) -> Curve:
    parts = tuple(
        tuple(Plane(float(x), float(y)) for x, y in zip(xs, ys, strict=True))
        for xs, ys in pieces(trace)
    )
    marks = [Mark(TURNING[t.sense], Plane(t.x, t.y)) for t in trace.turns]
    marks += [Mark("zero", Plane(x, 0.0)) for x in trace.zeros]
    marks += _default(sweep, setting, function)
    return Curve(quantity.name, setting, parts, tuple(marks), trace.poles, trace.jumps)


def _default(sweep: _Sweep, setting: Sequence[Value], function: Function) -> Iterator[Mark]:
    """Yield the pose of the description, if it is on the curve."""
    x = sweep.values.get(sweep.x.name, math.nan)
    is_described = all(v.value == sweep.values.get(v.axis.name) for v in setting)
    if is_described and sweep.low <= x <= sweep.high:
        y = float(function(np.array([x]))[0])
        if math.isfinite(y):
            yield Mark("default", Plane(x, y))


def _columns(sweep: _Sweep, asked: Sequence[Quantity], points: int) -> tuple[Column, ...]:
    """Return the table: what varies, then every quantity in every setting."""
    places = sweep.places(points)
    columns = [Column(sweep.x, (), tuple(map(float, places)))]
    with np.errstate(all="ignore"):
        for quantity, setting in product(asked, sweep.settings):
            values = sweep.function(quantity, setting)(places)
            columns.append(Column(sweep.axis(quantity), setting, tuple(map(float, values))))
    return tuple(columns)


# --------------------------------------------------------------------------------- paths


def _paths(sweep: _Sweep, query: Query) -> Plot:
    """Return the paths of points while the drive moves, on equal axes."""
    pairs = [_coordinates(sweep, point) for point in query.paths]
    _count(len(pairs) * len(sweep.settings))
    unit = unit_of(LENGTH, sweep.mechanism)
    curves = tuple(
        _path(sweep, point, pair, setting)
        for (point, pair), setting in product(zip(query.paths, pairs, strict=True), sweep.settings)
    )
    ys = [p.y for curve in curves for piece in curve.pieces for p in piece]
    if not ys:
        raise MechcError([messages.no_curve(query.paths, sweep.x.name)])
    panel = Panel(Axis("y", LENGTH, unit), curves, min(ys), max(ys))
    columns = _columns(sweep, [q for pair in pairs for q in pair], query.points)
    return _plot(sweep, Axis("x", LENGTH, unit), (panel,), columns)


def _coordinates(sweep: _Sweep, point: str) -> tuple[Quantity, Quantity]:
    """Return the coordinates of a point; E599 where it has none."""
    names = f"x_{point}", f"y_{point}"
    if not all(name in sweep.known for name in names):
        points = [name[2:] for name in sweep.known if name.startswith("x_")]
        able = [p for p in points if f"y_{p}" in sweep.known]
        raise MechcError([messages.no_point(point, able, near_miss(point, able))])
    return sweep.known[names[0]], sweep.known[names[1]]


def _path(
    sweep: _Sweep, point: str, pair: tuple[Quantity, Quantity], setting: tuple[Value, ...]
) -> Curve:
    """Return the path of a point in pieces, marked at even places of the drive."""
    across, up = (sweep.function(q, setting) for q in pair)

    def at(places: Array) -> list[Plane]:
        with np.errstate(all="ignore"):
            xs, ys = across(places), up(places)
        return [Plane(float(x), float(y)) for x, y in zip(xs, ys, strict=True)]

    parts = groupby(at(sweep.places(CELLS + 1)), key=lambda p: bool(np.isfinite(p).all()))
    whole = tuple(tuple(piece) for finite, piece in parts if finite)
    stations = sweep.places(STATIONS + 1)
    marks = [
        Mark("station", p, float(s))
        for p, s in zip(at(stations), stations, strict=True)
        if np.isfinite(p).all()
    ]
    if len(marks) > 1 and math.dist(marks[0].at, marks[-1].at) < 1e-9:
        marks.pop()
    return Curve(point, setting, tuple(p for p in whole if len(p) > 1), tuple(marks))
