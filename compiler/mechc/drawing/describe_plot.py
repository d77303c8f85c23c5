"""What a plot shows, in words, for whoever cannot see it."""

from collections.abc import Iterator

from ..plot.plot import Axis, Curve, Plot
from ..units import behind


def shown(value: float, axis: Axis, digits: int = 4) -> str:
    """Return an SI value in the unit of an axis, as people write it.

    >>> from mechc.units import ANGLE
    >>> shown(-0.5, Axis("alpha", ANGLE, "deg"))
    '−28.65°'
    """
    number = f"{value / axis.size:.{digits}g}".replace("-", "−")
    return f"{number}{behind('°' if axis.unit == 'deg' else axis.unit)}"


def describe(plot: Plot) -> str:
    """Return what is plotted against what, and where curves turn, vanish or are infinite."""
    return " ".join(_sentences(plot))


def _sentences(plot: Plot) -> Iterator[str]:
    names = ", ".join(dict.fromkeys(curve.name for curve in plot.curves))
    ends = f"from {shown(plot.low, plot.varied)} to {shown(plot.high, plot.varied)}"
    if plot.equal:
        yield f"Path of {names} for {plot.varied.name} {ends}."
    else:
        yield f"{names} against {plot.x.name} {ends}."
    if plot.zone is not None:
        for low, high in plot.zone.stretches:
            yield f"{plot.zone.words} from {shown(low, plot.x)} to {shown(high, plot.x)}."
    for panel in plot.panels:
        for curve in panel.curves:
            yield from _of_curve(curve, plot, panel.y)


def _of_curve(curve: Curve, plot: Plot, y: Axis) -> Iterator[str]:
    settings = (f"{v.axis.name} = {shown(v.value, v.axis)}" for v in curve.setting)
    what = ", ".join([curve.name, *settings])
    if not plot.equal and curve.pieces:
        first, last = curve.pieces[0][0], curve.pieces[-1][-1]
        yield f"{what}: {shown(first.y, y)} at the start, {shown(last.y, y)} at the end."
    for mark in curve.marks:
        x = f"{plot.x.name} = {shown(mark.at.x, plot.x)}"
        if mark.kind in ("minimum", "maximum"):
            yield f"{what} has a {mark.kind} of {shown(mark.at.y, y)} at {x}."
        elif mark.kind == "zero":
            yield f"{what} is 0 at {x}."
        elif mark.kind == "default":
            yield f"{what} is {shown(mark.at.y, y)} at the default pose, {x}."
    for place in curve.poles:
        yield f"{what} is infinite at {plot.x.name} = {shown(place, plot.x)}."
    for place in curve.jumps:
        yield f"{what} jumps at {plot.x.name} = {shown(place, plot.x)}."
