"""Points and the links through them: who carries what, and how users name it."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field

from ..diagnostics import Report
from ..diagnostics.model import names as words
from ..source import Span
from ..syntax import ast
from ..syntax.words import points_of
from .mechanism import Link


@dataclass(slots=True)
class Points:
    """The points of one description, filled while its joints are read.

    ``places`` tells where each point was first named; ``carried`` the links through it;
    ``fixed`` and ``guided`` hold the pivots and sliders; ``used`` counts
    what acts at a point or asks for it.
    """

    report: Report
    places: dict[str, Span] = field(default_factory=dict)
    carried: dict[str, list[Link]] = field(default_factory=dict)
    links: dict[str, Link] = field(default_factory=dict)
    fixed: set[str] = field(default_factory=set)
    guided: set[str] = field(default_factory=set)
    used: Counter[str] = field(default_factory=Counter)

    def split(self, name: ast.Name) -> tuple[str, ...] | None:
        """Take a name apart into different points; report a repeated one."""
        points = points_of(name.text)
        for i, point in enumerate(points):
            if point in points[:i]:
                self.report.add(words.repeated_point(name.span, name.text, point))
                return None
        return points

    def declare(self, name: ast.Name) -> tuple[str, ...] | None:
        """Enter the points of a joint or body."""
        points = self.split(name)
        for point in points or ():
            self.places.setdefault(point, within(name, point))
        return points

    def known(self, name: ast.Name) -> tuple[str, ...] | None:
        """Return the points of a name if all of them are declared; report those that are not."""
        points = self.split(name)
        strange = [p for p in points or () if p not in self.places]
        for point in strange:
            self.report.add(words.unknown_point(within(name, point), point, self.places))
        return None if strange else points

    def acting(self, name: ast.Name) -> tuple[str, ...] | None:
        """Return declared points at which something acts, or which something asks for."""
        points = self.known(name)
        self.used.update(points or ())
        return points

    def add(self, link: Link) -> None:
        """Enter a link."""
        self.links[link.name] = link
        for point in link.points:
            self.carried.setdefault(point, []).append(link)

    def link(self, name: ast.Name) -> Link | None:
        """Return the link that two or more of its points name; report none or several."""
        points = self.known(name)
        if points is None:
            return None
        found = self._through(points)
        exact = [link for link in found if len(link.points) == len(points)]
        match exact or found:
            case [link]:
                return link
            case []:
                self.report.add(words.unknown_link(name.span, name.text, self.links))
            case several:
                candidates = [link.name for link in several]
                self.report.add(words.ambiguous_link(name.span, name.text, candidates))
        return None

    def _through(self, points: Iterable[str]) -> list[Link]:
        first, *rest = points
        candidates = self.carried.get(first, [])
        return [link for link in candidates if all(p in link.points for p in rest)]


def within(name: ast.Name, point: str) -> Span:
    """Return the place of one point inside a name, where the text shows it."""
    if name.span.end - name.span.start != len(name.text):
        return name.span
    offset = 0
    for candidate in points_of(name.text):
        if candidate == point:
            break
        offset += len(candidate)
    return Span(name.span.start + offset, name.span.start + offset + len(point))
