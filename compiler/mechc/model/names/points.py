"""Points and the links through them: who carries what, and how users name it."""

from collections import Counter
from collections.abc import Collection, Iterable
from itertools import accumulate, pairwise

from ...base.named import NamedTuple
from ...diagnostics import Report
from ...diagnostics.model import joints
from ...diagnostics.model import names as messages
from ...source import Span
from ...syntax import ast
from ...syntax.vocabulary import points_of
from ..mechanism import Link, Offset


class CircularSlot(NamedTuple):
    """The line that names the body with a circular slot, and the centre of the circle."""

    line: ast.Name
    about: ast.Name


class PointTable:
    """The points of one description, filled while its joints are read.

    ``places`` are where each point was first named; ``carried`` the links through it,
    ``bodies`` the link through a set of points, ``slides`` and ``telescopes`` the names of
    those; ``fixed`` and ``guided`` hold the pivots and the sliders; ``touching`` counts the
    slots and contacts of a point, ``arcs`` gives a pin's circular slot, ``falls`` the ropes that
    run between two points, ``used`` counts what acts at a point or asks for it, ``located`` the
    pivots whose place is given.
    """

    def __init__(self, report: Report) -> None:
        self.report = report
        self.places: dict[str, Span] = {}
        self.carried: dict[str, list[Link]] = {}
        self.links: dict[str, Link] = {}
        self.bodies: dict[frozenset[str], Link] = {}
        self.slides: dict[frozenset[str], ast.Name] = {}
        self.telescopes: dict[frozenset[str], ast.Name] = {}
        self.fixed: set[str] = set()
        self.guided: set[str] = set()
        self.touching: Counter[str] = Counter()
        self.arcs: dict[str, CircularSlot] = {}
        self.falls: dict[frozenset[str], list[str]] = {}
        self.used: Counter[str] = Counter()
        self.located: dict[str, Offset] = {}
        self._strange: set[str] = set()

    def split(self, name: ast.Name) -> tuple[str, ...] | None:
        """Take a name apart into different points; report a repeated one."""
        points = points_of(name.text)
        for point, count in Counter(points).items():
            if count > 1:
                self.report.add(messages.repeated_point(name.span, name.text, point))
                return None
        return points

    def declare(self, name: ast.Name) -> tuple[str, ...] | None:
        """Enter the points of a joint or body."""
        points = self.split(name)
        for point, place in places_in(name).items():
            self.places.setdefault(point, place)
        return points

    def known(self, name: ast.Name, hint: str = "") -> tuple[str, ...] | None:
        """Return the points of a name if all are declared; report others where first met."""
        points = self.split(name)
        strange = [p for p in points or () if p not in self.places]
        places = places_in(name) if strange else {}
        for point in strange:
            if point not in self._strange:
                self._strange.add(point)
                self.report.add(messages.unknown_point(places[point], point, self.places, hint))
        return None if strange else points

    def acting(self, name: ast.Name) -> tuple[str, ...] | None:
        """Return declared points at which something acts, or which something asks for."""
        points = self.known(name)
        self.used.update(points or ())
        return points

    def add(self, link: Link) -> None:
        """Enter a link."""
        self.links[link.name] = link
        self.bodies[frozenset(link.points)] = link
        for point in link.points:
            self.carried.setdefault(point, []).append(link)

    def link(self, name: ast.Name) -> Link | None:
        """Return the link that two or more of its points name; report none or several."""
        hint = messages.undeclared_link(name.text, self.links)
        points = None if self._is_strange(name) else self.known(name, hint)
        if points is None:
            return None
        exact = self.bodies.get(frozenset(points))
        match [exact] if exact else self._through(points):
            case [link]:
                return link
            case []:
                self._report_no_link(name, points)
            case several:
                candidates = [link.name for link in several]
                self.report.add(messages.ambiguous_link(name.span, name.text, candidates))
        return None

    def _is_strange(self, name: ast.Name) -> bool:
        """Return whether several points name a link and none is known; report them once, as one."""
        points = self.split(name) or ()
        if len(points) < 2 or not self.places.keys().isdisjoint(points):
            return False
        if not self._strange.issuperset(points):
            self._report_no_link(name, points)
        self._strange.update(points)
        return True

    def coaxial(self, point: str) -> frozenset[str]:
        """Return a point together with the pivots that are given the same place as it."""
        own = self.located.get(point)
        same = (p for p, at in self.located.items() if own and (at.x, at.y) == (own.x, own.y))
        return frozenset((point, *same))

    def centre(self, pin: str) -> str | None:
        """Return the centre of a pin's circular slot, None where it is no point of its body."""
        arc = self.arcs[pin]
        named = {*points_of(arc.line.text), arc.about.text}
        bodies = (*self.bodies, *self.slides)
        return arc.about.text if any(named <= own for own in bodies) else None

    def _report_no_link(self, name: ast.Name, points: Collection[str]) -> None:
        slide = next((s for own, s in self.slides.items() if own.issuperset(points)), None)
        if slide is not None:
            self.report.add(joints.slide_does_not_turn(name.span, slide.text, slide.span))
            return
        is_telescope = frozenset(points) in self.telescopes
        hint = messages.telescope_as_link(name.text) if is_telescope else ""
        self.report.add(messages.unknown_link(name.span, name.text, self.links, hint))

    def _through(self, points: Iterable[str]) -> list[Link]:
        first, *rest = points
        candidates = self.carried.get(first, [])
        return [link for link in candidates if all(p in link.points for p in rest)]


def places_in(name: ast.Name) -> dict[str, Span]:
    """Return the place of each point inside a name, where the text shows them."""
    points = points_of(name.text)
    if name.span.end - name.span.start != len(name.text):
        return dict.fromkeys(points, name.span)
    ends = list(accumulate(map(len, points), initial=name.span.start))
    return {p: Span(*pair) for p, pair in zip(points, pairwise(ends), strict=True)}
