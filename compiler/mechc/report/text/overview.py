"""What a description gives and what follows from it, for ``mechc check --verbose``.

Where a pose cannot be found this shows what is still missing: points without a place,
parameters without a value, vectors without a direction.
"""

from collections.abc import Iterable, Iterator

from ...formula.to_text import text
from ...formula.walk import evaluate, symbols
from ...model.mechanism import (
    Arrow,
    Geometry,
    Link,
    Mechanism,
    Offset,
    Parameter,
    Slider,
    Telescope,
)
from ...model.values import range_of
from ...pose.pose import Pose
from ...source import Source
from ...units import Dimension, described, in_unit, si_unit


def overview(mechanism: Mechanism, pose: Pose | None, source: Source) -> Iterator[str]:
    """Yield the points, parameters, vectors and what loops give; ``pose`` is None without one."""
    yield from _headed("points", _points(mechanism, source))
    yield from _headed("parameters", _parameters(mechanism, pose))
    yield from _headed("vectors", _vectors(mechanism, source))
    yield from _headed("what follows from them", _definitions(pose) if pose else ())


def _headed(heading: str, rows: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Yield rows of two columns below their heading; nothing where there are none."""
    found = [*rows]
    width = max((len(first) for first, _ in found), default=0)
    yield from [f"  {heading}"] if found else []
    yield from (f"    {first:<{width}}  {second}".rstrip() for first, second in found)


def _points(mechanism: Mechanism, source: Source) -> Iterator[tuple[str, str]]:
    places = {
        g.head: f"at {_written(g, source)}"
        for g in mechanism.geometry
        if isinstance(g, Offset) and not g.tail
    }
    pivots = mechanism.fixed
    sliders = {s.point for s in mechanism.each(Slider)}
    bodies: list[Link | Telescope] = [*mechanism.links, *mechanism.telescopes]
    for point in mechanism.spans:
        roles = [f"pivot {places.get(point, 'without a place')}"] if point in pivots else []
        roles += ["slider"] if point in sliders else []
        yield point, ", ".join([*roles, *(f"on {b.name}" for b in bodies if point in b.points)])


def _parameters(mechanism: Mechanism, pose: Pose | None) -> Iterator[tuple[str, str]]:
    after = {p.name: p for p in (pose.mechanism if pose else mechanism).parameters}
    for parameter in mechanism.parameters:
        found = parameter.value is None and after[parameter.name].dependent
        drives = mechanism.drive and mechanism.drive.parameter == parameter.name
        words = ["found by a loop" if found else _value(parameter)]
        words += [_stroke(parameter, mechanism)] if drives else []
        yield parameter.name, ", ".join(words)


def _value(parameter: Parameter) -> str:
    if parameter.value is None:
        return f"{described(parameter.dimension)} without a value"
    if parameter.dependent:
        return f"= {text(parameter.value)}"
    return f"= {_measured(evaluate(parameter.value, {}), parameter.dimension, parameter.unit)}"


def _stroke(parameter: Parameter, mechanism: Mechanism) -> str:
    ends = range_of(parameter.name, mechanism)
    if ends is None:
        return "the drive"
    low, high = (_measured(end, parameter.dimension, parameter.unit) for end in ends)
    return f"the drive, from {low} to {high}"


def _measured(value: float, dimension: Dimension, unit: str) -> str:
    return in_unit(value, unit or si_unit(dimension), 9)


def _vectors(mechanism: Mechanism, source: Source) -> Iterator[tuple[str, str]]:
    """Yield the entries of the geometry as they are written, and what each leaves open."""
    for entry in mechanism.geometry:
        if isinstance(entry, Offset) and not entry.tail:
            continue
        missing = ""
        if isinstance(entry, Arrow) and entry.direction is None:
            missing = "a loop must give its direction"
        elif isinstance(entry, Arrow) and entry.length is None:
            missing = "its length is open"
        yield _written(entry, source), missing


def _written(entry: Geometry, source: Source) -> str:
    return " ".join(source.written(entry.span).split())


def _definitions(pose: Pose) -> Iterator[tuple[str, str]]:
    """Yield the names that loops and bodies give values to, and what each rests on."""
    for name, formula in pose.definitions:
        yield name, f"from {', '.join(sorted(symbols(formula)))}"
