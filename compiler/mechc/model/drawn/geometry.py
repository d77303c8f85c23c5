"""Drawn places: what they give of lengths, angles and directions.

``A at (20 mm, 34.64 mm)`` says where a pin is at the default pose. From here on there are
only vectors: each derived length and direction becomes a parameter with a name, a constant
where the coordinates are numbers (:class:`~.sketch.Sketch`).

Without a drive, and with no length or direction given besides, every link lies as it is
drawn. Otherwise links get their shapes only, and directions follow from the loops; what is
given holds, and of several closures the one nearest to the drawn places is meant.
"""

from collections.abc import Collection, Iterable, Iterator

from ...diagnostics import Report
from ...diagnostics import drawn as messages
from ...formula.walk import symbols
from ...frozen import replace
from ..entries import points_of
from ..mechanism import Drawn, Drive, Geometry, Mechanism, Offset, Parameter, Pivot
from ..values import Chain, defaults, dependent
from .as_drawn import as_drawn
from .checks import faults
from .closing import closing
from .driving import fault_of, is_outside, with_driven
from .sketch import Sketch


def with_drawn(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism with the geometry that the drawn places give.

    It is drawn with the values of the description: one from ``outside`` moves what is drawn, as
    an argument of the code does, and makes no other mechanism of it.

    Reports E320 and E323 where a link cannot be driven, E321, E322 and E327 where points
    coincide, are off their lines or have no place, E326 where a range leaves out a value.
    """
    described = tuple(map(_as_described, mechanism.parameters))
    return _with_drawn(replace(mechanism, parameters=described), report)


def _as_described(parameter: Parameter) -> Parameter:
    """Return a parameter with the value that its own line has, if it has one."""
    value = parameter.replaced
    if value is None:
        return parameter
    dependent = bool(symbols(value))
    return replace(parameter, value=value, dependent=dependent, outside=parameter.value)


def _with_drawn(mechanism: Mechanism, report: Report) -> Mechanism:
    sketch = Sketch(mechanism, Chain(dependent(mechanism)).complete(defaults(mechanism)))
    for fault in faults(mechanism, sketch):
        report.add(fault)
    report.stop_on_errors()
    drive = mechanism.drive
    if drive and drive.ends:
        if undriven := fault_of(drive, drive.ends, mechanism, sketch):
            raise report.fail(undriven)
        mechanism = with_driven(mechanism, drive, drive.ends, sketch.unit)
    is_given = _is_given(mechanism, sketch)
    drawn = closing(mechanism, sketch, report) if is_given else as_drawn(mechanism, sketch)
    for point in without_effect(mechanism, drawn):
        report.add(messages.place_unused(point.span, point.point, unplaced_pivot(mechanism)))
    parameters = (*drawn.parameters, *sketch.parameters.values())
    given = {p.name for p in mechanism.parameters if p.value}
    return replace(drawn, parameters=_in_range(parameters, given, drive, report))


def _in_range(
    parameters: Iterable[Parameter], given: Collection[str], drive: Drive | None, report: Report
) -> tuple[Parameter, ...]:
    """Report a value of the drawing outside the range given; a stroke is no such range.

    Values that are ``given`` are none of the drawing.
    """
    found = list[Parameter]()
    for parameter in parameters:
        outside = parameter.name not in given and is_outside(parameter)
        is_stroke = drive is not None and drive.ends and parameter.name == drive.parameter
        if outside and not is_stroke:
            report.add(messages.drawn_outside_range(parameter.span, parameter.name))
        found.append(replace(parameter, range=None) if outside else parameter)
    report.stop_on_errors()
    return tuple(found)


def _is_given(mechanism: Mechanism, sketch: Sketch) -> bool:
    """Return whether more is given of the pose than the places of points."""
    pairs = (g for g in mechanism.geometry if not isinstance(g, Offset) or g.tail)
    return mechanism.drive is not None or any(map(sketch.has, pairs))


def without_effect(before: Mechanism, drawn: Mechanism) -> Iterator[Drawn]:
    """Yield the drawn points of which no vector was made, and that no placed point is tied to.

    ``before`` is the mechanism without the vectors that its drawing gives.
    """
    own = set(map(id, before.geometry))
    made = [entry for entry in drawn.geometry if id(entry) not in own]
    used = {point for entry in made for point in points_of(entry)} | _tied(drawn.geometry)
    yield from (each for each in before.drawn if each.point not in used)


def _tied(geometry: tuple[Geometry, ...]) -> set[str]:
    """Return the points to which vectors lead from the origin of coordinates."""
    found, left = {""}, list(geometry)
    while near := [entry for entry in left if not found.isdisjoint(points_of(entry))]:
        found.update(point for entry in near for point in points_of(entry))
        left = [entry for entry in left if entry not in near]
    return found


def unplaced_pivot(mechanism: Mechanism) -> str:
    """Return the first pivot that has no place, '' where all have one."""
    placed = {g.head for g in mechanism.geometry if isinstance(g, Offset) and not g.tail}
    pivots = (pivot.point for pivot in mechanism.each(Pivot))
    return next((point for point in pivots if point not in placed), "")
