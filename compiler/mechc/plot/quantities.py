"""What can be plotted: results, what loops find, coordinates of points and their rates."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..base.named import NamedTuple
from ..model.mechanism import Let, Mechanism, Parameter
from ..routine.evaluate import at_rest, evaluate, has_senses, pose
from ..routine.steps import Input, PoseProgram, Routine, closed_dimensions
from ..units import ANGLE, USUAL_UNITS, Dimension, si_unit
from .narrowing import Array

ColumnValues = Mapping[str, float | Array]


class PlotQuantity(NamedTuple):
    """A quantity that the program computes, and that can be plotted."""

    name: str
    dimension: Dimension
    inputs: tuple[Input, ...]
    at: Callable[[ColumnValues], object]
    """Its values at those of its inputs."""

    unit: str = ""
    """The unit that the description gives it, '' for none."""

    is_result: bool = False
    at_rest: Callable[[ColumnValues], NDArray[np.bool_]] | None = None
    """Where a joint with friction is at rest: the formula has no value there, its limits have."""


def quantities(routine: Routine, mechanism: Mechanism) -> dict[str, PlotQuantity]:
    """Return all that can be plotted by name: results first, in the order of the text."""
    found = [*_results(routine, mechanism), *_closed(routine, mechanism), *_motion(routine)]
    named: dict[str, PlotQuantity] = {}
    for quantity in found:
        named.setdefault(quantity.name, quantity)
    return named


def _results(routine: Routine, mechanism: Mechanism) -> Iterator[PlotQuantity]:
    units = {let.name: let.unit for let in mechanism.lets}
    for f in routine.functions:
        unit = units.get(f.name, "")
        values, still = partial(evaluate, f), partial(at_rest, f) if has_senses(f) else None
        yield PlotQuantity(f.name, f.dimension, f.inputs, values, unit, True, still)


def _closed(routine: Routine, mechanism: Mechanism) -> Iterator[PlotQuantity]:
    """Yield the angles and lengths that loops find."""
    if routine.pose is None:
        return
    for name, dimension in closed_dimensions(routine.pose, mechanism).items():
        yield PlotQuantity(name, dimension, routine.pose.inputs, partial(_of, routine.pose, name))


def _motion(routine: Routine) -> Iterator[PlotQuantity]:
    if routine.points is None:
        return
    program = routine.points.program
    for q in routine.points.quantities:
        yield PlotQuantity(q.name, q.dimension, program.inputs, partial(_of, program, q.name))


def _of(program: PoseProgram, name: str, values: ColumnValues) -> object:
    found, _ = pose(program, values)
    return found[name]


def unit_of(dimension: Dimension, mechanism: Mechanism, own: str = "") -> str:
    """Return the unit in which a quantity is shown: its own, the first that is written, a usual.

    An angle is in degrees unless it has its own, as everywhere.
    """
    written: tuple[Parameter | Let, ...] = ()
    if dimension != ANGLE:
        written = (*mechanism.parameters, *mechanism.literals, *mechanism.lets)
    first = next((p.unit for p in written if p.dimension == dimension and p.unit), "")
    unit = own or first or USUAL_UNITS.get(dimension, "") or si_unit(dimension)
    return "deg" if unit == "°" else unit
