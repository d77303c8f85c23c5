"""What a plot runs over: a parameter between two ends, in settings of a family."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import product

import numpy as np

from ..base.frozen import frozen
from ..diagnostics import MechcError, near_miss
from ..diagnostics import plot as messages
from ..model.formulas.parameters import in_si
from ..model.mechanism import Mechanism
from ..model.values import defaults, range_of
from ..routine.steps import Input
from ..units import USUAL_UNITS, Dimension
from .narrowing import Array, ArrayFunction, is_rounding, with_limits
from .plot import FamilyValue, Panel, Plot, PlotAxis, PlotColumn
from .quantities import PlotQuantity, unit_of
from .query import GivenSetting, Query

MOST_CURVES = 12
"""How many curves a person can distinguish."""


@frozen
class PlotRange:
    """What varies and between which ends, in which settings; values of all else."""

    mechanism: Mechanism
    known: Mapping[str, PlotQuantity]
    x: PlotAxis
    low: float
    high: float
    settings: tuple[tuple[FamilyValue, ...], ...]
    values: Mapping[str, float]

    def function(self, quantity: PlotQuantity, setting: Sequence[FamilyValue]) -> ArrayFunction:
        """Return the values of a quantity on a grid, with one setting of the family.

        They are 0 where nothing but rounding is left of it all over the range.
        """
        values = self._values(quantity, setting)
        return np.zeros_like if is_rounding(values, self.low, self.high) else values

    def _values(self, quantity: PlotQuantity, setting: Sequence[FamilyValue]) -> ArrayFunction:
        """Return a quantity on a grid of the parameter, its limits where a slip is zero.

        Raises an error where something that it needs has no value.
        """
        given = {**self.values, **{value.axis.name: value.value for value in setting}}
        lacking = [i.name for i in quantity.inputs if i.name not in (*given, self.x.name)]
        if lacking:
            raise MechcError([messages.no_value(quantity.name, lacking)])

        def at(grid: Array) -> Array:
            found = quantity.at({**given, self.x.name: grid})
            return np.broadcast_to(np.asarray(found, dtype=np.float64), grid.shape).copy()

        if (still := quantity.at_rest) is None:
            return at
        width = self.high - self.low
        return with_limits(at, lambda grid: still({**given, self.x.name: grid}), width)

    def axis(self, quantity: PlotQuantity) -> PlotAxis:
        """Return a quantity's axis."""
        unit = unit_of(quantity.dimension, self.mechanism, quantity.unit)
        return PlotAxis(quantity.name, quantity.dimension, unit)

    @property
    def grid(self) -> Callable[[int], Array]:
        """Return so many points from one end to the other."""
        return partial(np.linspace, self.low, self.high)


# ------------------------------------------------------------------------ what is asked


def sweep_of(mechanism: Mechanism, known: Mapping[str, PlotQuantity], query: Query) -> PlotRange:
    """Return the sweep of a query: the parameter that varies, its range, and the settings."""
    inputs = {i.name: i for q in known.values() for i in q.inputs}
    inputs |= {p.name: _input(p.name, mechanism) for p in mechanism.parameters if not p.dependent}
    name = query.x or _driving(mechanism)
    x = _axis(name, inputs, mechanism)
    low, high = _ends(x, mechanism, query.ends)
    settings = tuple(product(*_family(query, x, inputs, mechanism)))
    return PlotRange(mechanism, known, x, low, high, settings, defaults(mechanism))


def _input(name: str, mechanism: Mechanism) -> Input:
    parameter = mechanism.parameter(name)
    return Input(name, parameter.dimension, parameter.unit)


def _driving(mechanism: Mechanism) -> str:
    """Return the drive; E587 where there is none."""
    if mechanism.drive is None:
        able = [p.name for p in mechanism.parameters if p.range and not p.dependent]
        raise MechcError([messages.nothing_to_vary(able)])
    return mechanism.drive.parameter


def _axis(name: str, inputs: Mapping[str, Input], mechanism: Mechanism) -> PlotAxis:
    """Return the axis of a parameter; E584 where there is none that can be set."""
    if name not in inputs:
        near = near_miss(name, inputs)
        raise MechcError([messages.no_such_parameter(name, list(inputs), near)])
    found = inputs[name]
    return PlotAxis(name, found.dimension, unit_of(found.dimension, mechanism, found.unit))


def _ends(
    x: PlotAxis, mechanism: Mechanism, written: tuple[GivenSetting, GivenSetting] | None
) -> tuple[float, float]:
    """Return the ends of the range; E585 where there are none."""
    parameters = {p.name for p in mechanism.parameters}
    found = range_of(x.name, mechanism) if x.name in parameters else None
    if written is not None:
        low, high = sorted(in_units(x.name, end, x.dimension) for end in written)
        found = low, high
    if found is None or not found[0] < found[1]:
        unit = f" {USUAL_UNITS.get(x.dimension, '')}".rstrip()
        raise MechcError([messages.no_range(x.name, f"10{unit} .. 80{unit}")])
    return found


def _family(
    query: Query, x: PlotAxis, inputs: Mapping[str, Input], mechanism: Mechanism
) -> Iterator[list[FamilyValue]]:
    """Yield the values of each parameter of the family; E584 for what is along the axis."""
    for name, given in query.family:
        if name == x.name:
            others = [other for other in inputs if other != name]
            raise MechcError([messages.no_such_parameter(name, others, "it is along the axis")])
        axis = _axis(name, inputs, mechanism)
        yield [FamilyValue(axis, in_units(name, value, axis.dimension)) for value in given]


def in_units(name: str, given: GivenSetting, dimension: Dimension) -> float:
    """Return a value in SI that may be text with its unit."""
    return in_si(name, given, dimension) if isinstance(given, str) else float(given)


def known(sweep: PlotRange, names: Sequence[str]) -> list[PlotQuantity]:
    """Return quantities by name; E583 where there is none."""
    able = list(sweep.known)

    def hint(name: str) -> str:
        unused = name in sweep.mechanism.brought
        return messages.asked_for(name) if unused else near_miss(name, able)

    strange = [name for name in names if name not in sweep.known]
    if strange:
        raise MechcError(messages.nothing_of_this_name(n, able, hint(n)) for n in strange)
    return [sweep.known[name] for name in names]


def columns(sweep: PlotRange, asked: Sequence[PlotQuantity], points: int) -> tuple[PlotColumn, ...]:
    """Return the table: what varies, then every quantity in every setting."""
    grid = sweep.grid(points)
    columns = [PlotColumn(sweep.x, (), tuple(map(float, grid)))]
    with np.errstate(all="ignore"):
        for quantity, setting in product(asked, sweep.settings):
            values = sweep.function(quantity, setting)(grid)
            columns.append(PlotColumn(sweep.axis(quantity), setting, tuple(map(float, values))))
    return tuple(columns)


def refuse_many(number: int) -> None:
    """Raise E589 where there are more curves than a person can distinguish."""
    if number > MOST_CURVES:
        raise MechcError([messages.too_many_curves(number, MOST_CURVES)])


def plot_of(
    sweep: PlotRange, x: PlotAxis, panels: tuple[Panel, ...], columns: tuple[PlotColumn, ...]
) -> Plot:
    """Return a plot of a sweep; its axis is another quantity where paths are shown."""
    mechanism = sweep.mechanism
    parameters = {p.name for p in mechanism.parameters}
    given = range_of(sweep.x.name, mechanism) if sweep.x.name in parameters else None
    inside = given is None or (given[0] <= sweep.low and sweep.high <= given[1])
    return Plot(
        title=mechanism.title or mechanism.name,
        x=x,
        varied=sweep.x,
        low=sweep.low,
        high=sweep.high,
        panels=panels,
        columns=columns,
        given=None if inside else given,
        equal=x is not sweep.x,
    )
