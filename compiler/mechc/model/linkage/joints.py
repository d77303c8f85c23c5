"""Pivots, sliders and links, and the points that they declare."""

from collections.abc import Iterable, Sequence
from itertools import pairwise

from ...diagnostics import drawn_places as drawn_words
from ...diagnostics.model import doubts, names
from ...diagnostics.model import joints as messages
from ...source import Span
from ...syntax import ast
from ...syntax.vocabulary import reads_as_value
from ...units import LENGTH, UNITS
from ..constants import last_digit, leaves
from ..formulas.directions import read_direction, read_place, value_of
from ..mechanism import Drawn, Geometry, Joint, Link, Offset, Pivot, Slider
from ..names.points import CircularSlot, PointTable
from ..names.scope import NameScope
from ..parts.joints import rope_id
from ..statements import every

ACCOUNTED = 2
"""Units of the last digit of coordinates that a gap may be wide."""


def declare_points(file: ast.File, points: PointTable) -> None:
    """Enter the points of every joint and body, and the links through them."""
    for statement in file.statements:
        match statement:
            case ast.Pivot(point=name):
                points.declare(name)
                points.fixed.add(name.text)
            case ast.Slider(point=name):
                points.declare(name)
                points.guided.add(name.text)
            case ast.Slide(points=name):
                _add_slide(name, points)
            case ast.Telescope(points=name):
                carried = points.declare(name) or ()
                points.used.update(carried)
                points.telescopes[frozenset(carried)] = name
            case ast.Slot(point=name) | ast.Contact(point=name):
                points.touching[name.text] += 1
                if isinstance(statement, ast.Slot) and statement.about:
                    points.arcs[name.text] = CircularSlot(statement.line, statement.about)
            case ast.Rope(start=name, falls=falls):
                _add_rope([name.text, *(point.text for point, _ in falls)], points)
            case ast.Link(points=name, label=label):
                _add_link(name, label, points)
                if reads_as_value(label):
                    points.report.add(doubts.label_is_value(statement.span, name.text, label))
    _check_joints(file, points)
    for arc in points.arcs.values():
        points.known(arc.about)


def _add_link(name: ast.Name, label: str, points: PointTable) -> None:
    carried = points.declare(name)
    if carried is None:
        return
    if not _is_again(name, carried, points):
        points.add(Link(name.text, carried, name.span, label))


def _add_rope(route: Sequence[str], points: PointTable) -> None:
    for ends in dict.fromkeys(map(frozenset, pairwise(route))):
        points.falls.setdefault(ends, []).append(rope_id(route))


def _add_slide(name: ast.Name, points: PointTable) -> None:
    carried = points.declare(name)
    if carried and not _is_again(name, carried, points):
        points.used.update(carried)
        points.slides[frozenset(carried)] = name


def _is_again(name: ast.Name, carried: Sequence[str], points: PointTable) -> bool:
    """Report a second body through the same points."""
    key = frozenset(carried)
    if other := points.bodies.get(key) or points.slides.get(key):
        points.report.add(messages.link_again(name.span, name.text, other.span))
    return other is not None


def _check_joints(file: ast.File, points: PointTable) -> None:
    """Report points that are pivot or slider twice, or both."""
    first: dict[str, tuple[str, Span]] = {}
    joints: list[ast.Pivot | ast.Slider] = [*every(file, ast.Pivot), *every(file, ast.Slider)]
    for statement in joints:
        what = "pivot" if isinstance(statement, ast.Pivot) else "slider"
        point, span = statement.point.text, statement.point.span
        before = first.get(point)
        if before is None:
            first[point] = what, span
        elif before[0] == what:
            points.report.add(messages.joint_again(span, what, point, before[1]))
        else:
            points.report.add(messages.pivot_and_slider(span, point, before[1]))


def read_pivots(file: ast.File, scope: NameScope) -> tuple[list[Pivot], list[Geometry]]:
    """Return the pivots, and the places given for them."""
    pivots: list[Pivot] = []
    places: list[Geometry] = []
    for statement in every(file, ast.Pivot):
        point = statement.point.text
        pivots.append(Pivot(point, statement.span))
        if statement.at and (place := read_place("", point, statement.at, scope)):
            places.append(place)
    return pivots, places


def read_drawn(file: ast.File, scope: NameScope) -> tuple[list[Drawn], list[Offset]]:
    """Return where points are drawn, and the places of pivots among them.

    Reports a second place, and one without a value.
    """
    first = {s.point.text: s.at.span for s in every(file, ast.Pivot) if s.at}
    found: list[Drawn] = []
    fixed: list[Offset] = []
    for statement in every(file, ast.Drawn):
        point, span = statement.point.text, statement.at.span
        place = read_place("", point, statement.at, scope)
        hint = names.point_of_link(point, scope.points.links)
        if not scope.points.known(statement.point, hint) or place is None:
            continue
        if first.setdefault(point, span) != span:
            scope.report.add(drawn_words.drawn_again(span, point, first[point]))
        elif point in scope.points.fixed:
            fixed.append(place)
        elif value_of(place.x, scope) is None or value_of(place.y, scope) is None:
            scope.report.add(drawn_words.place_without_value(span, point))
        else:
            found.append(_drawn(statement, place))
    return found, fixed


def _drawn(statement: ast.Drawn, place: Offset) -> Drawn:
    """Return a point as it is drawn, and how far it may be off by the last digits written."""
    parts = (leaf for part in (statement.at.x, statement.at.y) for leaf in leaves(part))
    lengths = [
        number
        for number in parts
        if isinstance(number, ast.Number) and number.unit and UNITS[number.unit].dimension == LENGTH
    ]
    slack = float(min((ACCOUNTED * last_digit(n) for n in lengths if n.value), default=0))
    unit = next((n.unit for n in lengths), "")
    return Drawn(place.head, place.x, place.y, slack, unit, statement.span)


def read_sliders(
    file: ast.File, scope: NameScope
) -> tuple[list[Slider], list[Pivot], list[Geometry]]:
    """Return the sliders, with a fixed point and its place for each ``through (x, y)``."""
    sliders: list[Slider] = []
    pivots: list[Pivot] = []
    places: list[Geometry] = []
    for statement in every(file, ast.Slider):
        along = read_direction(statement.along, scope)
        through = _through(statement, scope)
        if isinstance(through, Offset):
            pivots.append(Pivot(through.head, through.span))
            places.append(through)
            through = through.head
        if along:
            sliders.append(Slider(statement.point.text, along, statement.span, through))
    return sliders, pivots, places


def _through(statement: ast.Slider, scope: NameScope) -> str | Offset | None:
    """Return the pivot, or the made-up fixed point (``A_0`` for slider A), of a guide."""
    match statement.through:
        case None:
            return None
        case ast.Cartesian() as place:
            return read_place("", f"{statement.point.text}_0", place, scope)
        case ast.Name() as name:
            if not scope.points.acting(name):
                return None
            if name.text not in scope.points.fixed:
                scope.report.add(messages.guide_through_moving_point(name.span, name.text))
            return name.text


def warn_idle(joints: Iterable[Joint], points: PointTable) -> None:
    """Warn of pivots and sliders that hold no link and that nothing uses."""
    for joint in joints:
        if not isinstance(joint, Pivot | Slider):
            continue
        point, what = joint.point, type(joint).__name__.lower()
        if point in points.places and point not in points.carried and not points.used[point]:
            points.report.add(messages.idle_joint(joint.span, what, point))
