"""A plot in words, for whoever cannot see it."""

from collections.abc import Iterator

from ...formula.names import split_ratio
from ...plot.plot import Curve, Mark, Plot, PlotAxis
from ...units import behind
from ..describe import Words


def shown(value: float, axis: PlotAxis, digits: int = 4) -> str:
    """Return an SI value in the unit of an axis, as people write it.

    >>> from mechc.units import ANGLE
    >>> shown(-0.5, PlotAxis("alpha", ANGLE, "deg"))
    '−28.65°'
    >>> from mechc.units import FORCE
    >>> shown(17110.2, PlotAxis("R", FORCE, "N")), shown(-2.5e9, PlotAxis("R", FORCE, "N"))
    ('17110 N', '−2.5·10⁹ N')
    """
    number = _figures(value / axis.size, digits).replace("-", "−")
    unit = "°" if axis.unit == "deg" else axis.unit.replace("*", "·")
    return f"{number}{behind(unit.replace('^2', '²').replace('^3', '³'))}"


WHOLE = 1e6
"""Numbers below this that have no decimals stand without powers of ten."""

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def _figures(value: float, digits: int) -> str:
    """Return a number of so many figures, a power of ten as people write it."""
    number, _, power = f"{value:.{digits}g}".partition("e")
    if not power:
        return number
    if 1 <= abs(value) < WHOLE:
        return f"{float(f'{value:.{digits}g}'):.0f}"
    return f"{number}·10{str(int(power)).translate(_RAISED)}"


def describe(plot: Plot, words: Words) -> str:
    """Return the description of a plot: its axes, and where curves turn, vanish or are infinite.

    ``words`` are those of a language.
    """
    return " ".join(_sentences(plot, words))


def _sentences(plot: Plot, words: Words) -> Iterator[str]:
    """Yield what a plot shows over which range, where its condition holds, and each curve."""
    names = ", ".join(dict.fromkeys(_plain(curve.name) for curve in plot.curves))
    low, high = shown(plot.low, plot.varied), shown(plot.high, plot.varied)
    what = words["path" if plot.equal else "against"]
    yield what.format(names=names, x=plot.varied.name, low=low, high=high)
    if plot.zone is not None:
        what = words["and"].join(plot.zone.conditions)
        for ends in plot.zone.stretches:
            low, high = (shown(end, plot.x) for end in ends)
            yield words["holds"].format(what=what, low=low, high=high)
    for panel in plot.panels:
        for curve in panel.curves:
            yield from _of_curve(curve, plot, panel.y, words)


def _of_curve(curve: Curve, plot: Plot, y: PlotAxis, words: Words) -> Iterator[str]:
    """Yield the values of a curve at its ends, then its marks, poles and jumps."""
    settings = (f"{v.axis.name} = {shown(v.value, v.axis)}" for v in curve.setting)
    what = ", ".join([_plain(curve.name), *settings])
    if not plot.equal and curve.pieces:
        ends = curve.pieces[0][0], curve.pieces[-1][-1]
        first, last = ("∞" if p.x in curve.poles else shown(p.y, y) for p in ends)
        yield words["ends"].format(what=what, first=first, last=last)
    for mark in curve.marks:
        if mark.kind != "station":
            yield _of_mark(mark, what, curve, plot, y, words)
    for place in curve.poles:
        yield words["pole"].format(what=what, at=_at(place, curve, plot, words))
    for place in curve.jumps:
        yield words["jump"].format(what=what, at=_at(place, curve, plot, words))


def _of_mark(mark: Mark, what: str, curve: Curve, plot: Plot, y: PlotAxis, words: Words) -> str:
    at = _at(mark.at.x, curve, plot, words)
    return words[mark.kind].format(what=what, y=shown(mark.at.y, y), at=at)


def _at(place: float, curve: Curve, plot: Plot, words: Words) -> str:
    """Return a place of the axis, and that it is a dead centre if it is."""
    at = f"{plot.x.name} = {shown(place, plot.x)}"
    return f"{at} ({words['dead_centre']})" if place in curve.dead_centres else at


def _plain(name: str) -> str:
    return "/".join(split_ratio(name))
