"""What a description gives and what follows from it, for ``mechc check --verbose``.

Where a pose cannot be found this shows what is still missing: points without a place,
parameters without a value, vectors without a direction.
"""

from collections.abc import Iterable, Iterator

from ...formula.evaluate import evaluate
from ...formula.to_text import text
from ...formula.walk import symbols
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
from ...model.values import is_constant, range_of
from ...pose.pose import Pose
from ...source import Source
from ...units import USUAL_UNITS, si_unit
from ..languages.locale import Words
from .speller import TextSpeller


def overview(
    mechanism: Mechanism, pose: Pose | None, source: Source, spell: TextSpeller
) -> Iterator[str]:
    """Yield the points, parameters, vectors and what loops give; ``pose`` is None without one."""
    words = spell.locale.checked
    yield from _headed(words["points"], _points(mechanism, source, spell))
    yield from _headed(words["parameters"], _parameters(mechanism, pose, spell))
    yield from _headed(words["vectors"], _vectors(mechanism, source, spell))
    yield from _headed(words["follows"], _definitions(pose, words) if pose else ())


def _headed(heading: str, rows: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Yield rows of two columns below their heading; nothing where there are none."""
    found = [*rows]
    width = max((len(first) for first, _ in found), default=0)
    yield from [f"  {heading}"] if found else []
    yield from (f"    {first:<{width}}  {second}".rstrip() for first, second in found)


def _points(mechanism: Mechanism, source: Source, spell: TextSpeller) -> Iterator[tuple[str, str]]:
    """Yield each point with its place, and what it is: a pivot, guided, on bodies."""
    words = spell.locale.checked
    places = {
        g.head: words["at"].format(place=_written(g, source, spell))
        for g in mechanism.geometry
        if isinstance(g, Offset) and not g.tail
    }
    pivots = mechanism.fixed
    sliders = {s.point for s in mechanism.each(Slider)}
    bodies: list[Link | Telescope] = [*mechanism.links, *mechanism.telescopes]
    for point in mechanism.spans:
        place = places.get(point, words["placeless"])
        roles = [words["pivot"].format(place=place)] if point in pivots else []
        roles += [words["slider"]] if point in sliders else []
        roles += [words["on"].format(body=b.name) for b in bodies if point in b.points]
        yield point, ", ".join(roles)


def _parameters(
    mechanism: Mechanism, pose: Pose | None, spell: TextSpeller
) -> Iterator[tuple[str, str]]:
    after = {p.name: p for p in (pose.mechanism if pose else mechanism).parameters}
    for parameter in mechanism.parameters:
        found = parameter.value is None and after[parameter.name].dependent
        drives = mechanism.drive and mechanism.drive.parameter == parameter.name
        said = [spell.locale.checked["found"] if found else _value(parameter, spell)]
        said += [_stroke(parameter, mechanism, spell)] if drives else _range(parameter, spell)
        said += [spell.text(parameter.label)] if parameter.label else []
        yield parameter.name, ", ".join(said)


def _value(parameter: Parameter, spell: TextSpeller) -> str:
    if parameter.value is None:
        usual = USUAL_UNITS.get(parameter.dimension, "") or si_unit(parameter.dimension)
        unit = f" ({spell.unit(usual)})" if usual else ""
        return spell.locale.checked["open"].format(unit=unit)
    if parameter.dependent and not is_constant(parameter):
        return f"= {spell.as_described(text(parameter.value))}"
    return f"= {_measured(evaluate(parameter.value, {}), parameter, spell)}"


def _range(parameter: Parameter, spell: TextSpeller) -> list[str]:
    """Return the range of a parameter in words, if it has one."""
    ends = [_measured(evaluate(end, {}), parameter, spell) for end in parameter.range or ()]
    return [f"{spell.locale.range.lower()} {' .. '.join(ends)}"] if ends else []


def _stroke(parameter: Parameter, mechanism: Mechanism, spell: TextSpeller) -> str:
    ends = range_of(parameter.name, mechanism)
    if ends is None:
        return spell.locale.checked["drive"]
    low, high = (_measured(end, parameter, spell) for end in ends)
    return spell.locale.checked["stroke"].format(low=low, high=high)


def _measured(value: float, parameter: Parameter, spell: TextSpeller) -> str:
    return spell.measured(value, parameter.unit or si_unit(parameter.dimension), 9)


def _vectors(mechanism: Mechanism, source: Source, spell: TextSpeller) -> Iterator[tuple[str, str]]:
    """Yield the entries of the geometry as they are written, and what each leaves open."""
    words = spell.locale.checked
    for entry in mechanism.geometry:
        if isinstance(entry, Offset) and not entry.tail:
            continue
        missing = ""
        if isinstance(entry, Arrow) and entry.direction is None:
            missing = words["directionless"]
        elif isinstance(entry, Arrow) and entry.length is None:
            missing = words["lengthless"]
        yield _written(entry, source, spell), missing


def _written(entry: Geometry, source: Source, spell: TextSpeller) -> str:
    return spell.as_described(" ".join(source.written(entry.span).split()))


def _definitions(pose: Pose, words: Words) -> Iterator[tuple[str, str]]:
    """Yield the names that loops and bodies give values to, and what each rests on."""
    for name, formula in pose.definitions:
        yield name, words["from"].format(names=", ".join(sorted(symbols(formula))))
