"""Friction at pins: which of them have it, what turns on each, and what the pin is fast in."""

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations

from ...diagnostics.model import friction as messages
from ...diagnostics.model import sizes
from ...formula.tree import Formula, number, product
from ...source import Span
from ...syntax import ast
from ...units import LENGTH
from ..formulas.expressions import Reader
from ..linkage.fast_pins import FastPins, is_held
from ..mechanism import Arrow, Link, Mechanism, Offset, Telescope
from ..names.scope import DESCRIPTION, NameScope
from ..parts.friction import PinFriction, coulomb
from .coefficients import coefficient, positive_length, value_of

HALF = number(Fraction(1, 2))


class Pins:
    """Reads the friction of pins; ``named`` are those that have a line of their own."""

    def __init__(self, named: set[str], built: Mechanism, scope: NameScope) -> None:
        self._named, self._built, self._scope = named, built, scope
        self._carriers = FastPins(built, scope.values)

    def read(self, statement: ast.PinFriction) -> Iterator[PinFriction]:
        """Yield the pins that a line speaks of; report one at which nothing turns."""
        radius = _radius(statement, self._scope)
        if radius is None:
            return
        if statement.point is None:
            yield from self._all_others(statement, radius)
        elif statement.point.text in self._scope.points.places:
            pin = self._one(statement.point, statement.link, radius, statement.span)
            yield from (pin,) if pin else ()

    def _all_others(self, statement: ast.PinFriction, radius: Formula) -> Iterator[PinFriction]:
        """Yield the pins that have no line of their own; report where there are no pins at all."""
        self._remark_on_overlap(statement)
        points = dict.fromkeys(p for body in self._bodies() for p in body.points)
        pins = [point for point in points if self._is_pin(point)]
        if not pins and not self._built.ropes:
            self._scope.report.add(messages.friction_of_no_pins(statement.span))
        for point in pins:
            if point not in self._named:
                yield self._pin(point, radius, statement.span)

    def _one(
        self, named: ast.Name, fast: ast.Name | None, radius: Formula, span: Span
    ) -> PinFriction | None:
        """Return the pin at a point, ``fast`` in a link if that is said; None where it is wrong."""
        point = named.text
        if not self._is_pin(point):
            self._scope.report.add(messages.nothing_turns(named.span, point))
            return None
        if fast is None:
            return self._pin(point, radius, span)
        link = self._scope.points.link(fast)
        if link and point not in link.points:
            self._scope.report.add(messages.pin_of_another(fast.span, point, link.name))
            return None
        return PinFriction(point, link.name, radius, span) if link else None

    def _remark_on_overlap(self, statement: ast.PinFriction) -> None:
        """Say which pins would be thicker than they are apart on one body."""
        wanted = Reader(self._scope, DESCRIPTION).wanted(statement.diameter, LENGTH, "")
        diameter = value_of(wanted, self._scope) if wanted else None
        if diameter is None:
            return
        for ends, apart in (*self._lengths(), *self._drawn_lengths()):
            if not apart < diameter:
                continue
            together = any(set(ends) <= set(body.points) for body in self._bodies())
            free = self._named.isdisjoint(ends) and all(map(self._is_pin, ends))
            if together and free:
                place = statement.diameter.span
                self._scope.report.add(sizes.pins_overlap(place, diameter, ends, apart))
                return

    def _lengths(self) -> Iterator[tuple[tuple[str, str], float]]:
        """Yield the lengths of vectors that have values, by their ends."""
        for arrow in self._built.geometry:
            if isinstance(arrow, Arrow) and arrow.length is not None:
                apart = value_of(arrow.length, self._scope)
                if apart is not None:
                    yield (arrow.tail, arrow.head), apart

    def _drawn_lengths(self) -> Iterator[tuple[tuple[str, str], float]]:
        """Yield how far apart the points of each body are drawn, by their names."""
        written = [(drawn.point, drawn.x, drawn.y) for drawn in self._built.drawn]
        offsets = (entry for entry in self._built.geometry if isinstance(entry, Offset))
        written += [(entry.head, entry.x, entry.y) for entry in offsets if not entry.tail]
        known = {point: [value_of(part, self._scope) for part in at] for point, *at in written}
        places = {p: (x, y) for p, (x, y) in known.items() if x is not None and y is not None}
        for body in self._bodies():
            for ends in combinations((p for p in body.points if p in places), 2):
                yield ends, math.dist(*(places[point] for point in ends))

    def _is_pin(self, point: str) -> bool:
        """Return whether bodies turn on one another at a point."""
        bodies = len(self._at(point))
        return bodies > 1 or (bodies == 1 and is_held(point, self._built))

    def _at(self, point: str) -> list[str]:
        """Return the bodies that turn on a pin."""
        return [body.name for body in self._bodies() if point in body.points]

    def _bodies(self) -> tuple[Link | Telescope, ...]:
        return (*self._built.rigid_links, *self._built.telescopes)

    def _pin(self, point: str, radius: Formula, span: Span) -> PinFriction:
        """Return a pin with what it is taken to be fast in."""
        carrier = self._carriers.of(point)
        return PinFriction(point, carrier, radius, span, assumed=bool(carrier))


def remark_on_pairs(built: Mechanism, scope: NameScope) -> None:
    """Say which pairs of forces act at points, so that their ends are no pins with friction."""
    for load in built.pairs_at_pins():
        ends, loose = (load.first, load.second), built.loose_ends(load)
        can_be_held = not load.joins_twins  # a telescope is in one half
        found = messages.pair_without_pins(load.span, load.name, ends, loose, can_be_held)
        scope.report.add(found)


def _radius(statement: ast.PinFriction, scope: NameScope) -> Formula | None:
    """Return the radius of a friction circle; None where an error was reported."""
    of = statement.point.text if statement.point else ""
    f = coefficient(statement.coefficient, of, scope)
    diameter = positive_length(statement.diameter, "the diameter of a pin", scope)
    if f is None or diameter is None:
        return None
    if statement.law == "coulomb":
        f = coulomb(f)
    diameter = scope.named("d", of, diameter, LENGTH, statement.diameter.span, "pin")
    return product([(HALF, 1), (f, 1), (diameter, 1)])
