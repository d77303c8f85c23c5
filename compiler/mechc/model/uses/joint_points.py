"""Where a part is joined to the whole: its points, what they are there, whether it can be so."""

from collections.abc import Iterable, Mapping, Sequence

from ...base.named import NamedTuple
from ...diagnostics import Report
from ...diagnostics import joining as messages
from ...source import Span
from ...syntax import ast
from ...syntax.vocabulary import of_used
from ..statements import every
from .composed import Used
from .part_names import FindName

NOT_OF_A_PART = (ast.Mirror, ast.Copies, ast.Efficiency)
"""What cannot be said of a part."""


class UsedPart(NamedTuple):
    """A used mechanism in the whole: its points by their names there, and where it is used."""

    points: Mapping[str, str]
    used: Used
    span: Span
    statements: tuple[ast.Statement, ...] = ()


class WholeMechanism(NamedTuple):
    """What a part is joined to: statements of the file and of parts above, and these parts."""

    statements: Sequence[ast.Statement]
    parts: Mapping[str, UsedPart]

    @property
    def is_driven(self) -> bool:
        """Whether it has a drive."""
        return any(isinstance(s, ast.Drive) for s in self.statements)


class Joining(NamedTuple):
    """A use, the statements of what it names, and its joined points by what they are in the whole.

    ``met`` are those points, and others that parts below are joined to.
    """

    use: ast.Use
    used: Used
    own: tuple[ast.Statement, ...]
    whole: WholeMechanism
    joined: Mapping[str, str]
    met: frozenset[str]

    @property
    def freed(self) -> set[str]:
        """The parameters whose values stay behind: of what moves it, and those that are named.

        Where it has several drives the first one moves it, and the others keep their values.
        """
        found = {name.text for name in self.use.without}
        if self.whole.is_driven:
            found |= set([s.name.text for s in self.own if isinstance(s, ast.Drive)][:1])
        return found - {name.text for name, _ in self.use.given}


def structural(file: ast.File) -> Mapping[str, frozenset[str]]:
    """Return the points at which parts are joined, by the prefixes of their uses.

    Parts are those that join, and those that others join to.
    """
    found: dict[str, set[str]] = {}
    for use in every(file, ast.Use):
        for pair in use.joining:
            found.setdefault(use.prefix.text, set())
            for prefix, point in (of_used(name.text) for name in pair):
                if prefix:
                    found.setdefault(prefix, set()).add(point)
    return {prefix: frozenset(points) for prefix, points in found.items()}


def points_of_parts(parts: Mapping[str, UsedPart], report: Report) -> FindName:
    """Return the function that names a part's point in the whole; unknown ones are reported."""

    def lookup(prefix: str, point: str, span: Span) -> str | None:
        if (part := parts.get(prefix)) is None:
            report.add(messages.no_such_part(span, prefix, list(parts)))
            return None
        if point not in part.points:
            name, known = part.used.mechanism.name, list(part.points)
            report.add(messages.no_such_point(span, point, name, known, part.used.span))
        return part.points.get(point)

    return lookup


def joints(
    joining: Joining, there: Mapping[str, Span], here: Mapping[str, Span], report: Report
) -> dict[str, str] | None:
    """Return the names of a part's joined points in the whole; None where one is reported."""
    found: dict[str, str] = {}
    for pair in joining.use.joining:
        prefix, where = joining.use.prefix.text, pair[0].span
        sides = sorted(pair, key=lambda name: of_used(name.text)[0] != prefix)
        (first, inside), (second, outside) = (of_used(name.text) for name in sides)
        if first != prefix or second == prefix:
            report.add(messages.joins_no_other(where, prefix))
            return None
        if inside not in there:
            name, heading = joining.used.mechanism.name, joining.used.span
            known = list(there)
            report.add(messages.no_such_point(sides[0].span, inside, name, known, heading))
            return None
        point = _outside(second, outside, sides[1].span, here, joining, report)
        if point is None:
            return None
        if inside in found or point in found.values():
            report.add(messages.joined_twice(where, prefix))
            return None
        found[inside] = point
    return found


def _outside(
    prefix: str,
    point: str,
    span: Span,
    here: Mapping[str, Span],
    joining: Joining,
    report: Report,
) -> str | None:
    """Return the name of a point that a part is joined to; None where there is none, reported."""
    if prefix:
        return points_of_parts(joining.whole.parts, report)(prefix, point, span)
    if point not in here:
        report.add(messages.no_such_point(span, point, "this file", list(here), None))
        return None
    return point


def is_a_part(joining: Joining, report: Report) -> bool:
    """Return whether a mechanism can be a part; report the first reason why it cannot."""
    place, own = joining.use.used.span, joining.own
    if strange := next((s for s in own if isinstance(s, NOT_OF_A_PART)), None):
        report.add(messages.only_of_a_whole(place, strange.span))
        return False
    gravity = next((s for s in own if isinstance(s, ast.Gravity)), None)
    is_heavy = any(isinstance(s, ast.Weight) for s in own)
    says_so = any(isinstance(s, ast.Gravity) for s in joining.whole.statements)
    if gravity and is_heavy and not says_so:
        report.add(messages.which_way_is_down(place, gravity.span))
        return False
    return True


def move_alike(joining: Joining, report: Report) -> bool:
    """Return whether joined points are fixed on both sides or on none, and one of them moves."""
    there, here = _pivots(joining.own), _pivots(joining.whole.statements)
    place = joining.use.prefix.span
    for inside, outside in joining.joined.items():
        if (inside in there) != (outside in here):
            fixed = there[inside] if inside in there else here[outside]
            report.add(messages.fixed_and_moving(place, inside, outside, fixed))
            return False
    fixed_there = [there[p] for p in joining.joined if p in there]
    if fixed_there and len(fixed_there) == len(joining.joined):
        report.add(messages.nothing_passes(place, fixed_there[0]))
        return False
    return True


def _pivots(statements: Iterable[ast.Statement]) -> dict[str, Span]:
    return {s.point.text: s.span for s in statements if isinstance(s, ast.Pivot)}
