"""Directions: given ones, those that follow from turns and from one another."""

from collections.abc import Iterator, Mapping

from ..algebra.angle import HALF_TURN, Angle
from ..diagnostics import Report
from ..diagnostics import pose as messages
from ..model.mechanism import (
    Absolute,
    AlongLine,
    Arrow,
    Direction,
    Mechanism,
    Offset,
    Slider,
    Slot,
    Turn,
)
from ..source import Span
from .terms import AlgebraicTerms

PointPair = tuple[str, str]


class Directions:
    """The direction of every pair of points that has one angle.

    Made from the geometry by going round until nothing new follows: a direction that is
    written, a turn at a point one of whose arms is known, ``AB = l @ perp CD``. Where
    nothing more follows, the next vector of which only the length is given gets a direction
    of its own, ``phi_AB``, which is ``sought``: a loop must give it.
    """

    def __init__(self, mechanism: Mechanism, terms: AlgebraicTerms, report: Report) -> None:
        self._terms, self._report = terms, report
        self._known: dict[PointPair, tuple[Angle, Span]] = {}
        self.sought: dict[str, tuple[str, str, Span]] = {}
        self._oblique: dict[frozenset[str], Offset] = {}
        waiting = [g for g in mechanism.geometry if not isinstance(g, Offset)]
        for offset in mechanism.geometry:
            if isinstance(offset, Offset):
                self._note_offset(offset)
        for tail, head in _slid_along(mechanism):
            self._name(tail, head)
        while waiting:
            left = [g for g in waiting if not self._follow(g)]
            if len(left) == len(waiting):
                self._seek(left[0])
            waiting = left

    def of(self, tail: str, head: str) -> Angle | None:
        """Return the direction from one point to another, if it is known."""
        known = self._known.get((tail, head))
        return known[0] if known else None

    def resolve(self, direction: Direction, name: str) -> Angle | None:
        """Return a direction as an angle, None while it rests on one that is not known."""
        match direction:
            case Absolute(formula, _):
                return self._terms.angle(formula, name)
            case AlongLine(tail, head, quarter, _):
                known = self.of(tail, head)
                return None if known is None else known + Angle.constant(90 * quarter)

    def put(self, values: Mapping[str, Angle]) -> None:
        """Replace symbols in all directions by what they were found to be."""
        self._known = {pair: (angle.put(values), at) for pair, (angle, at) in self._known.items()}

    def _seek(self, item: Arrow | Turn) -> None:
        """Give a direction that nothing gives a name."""
        tail, head = (item.tail, item.head) if isinstance(item, Arrow) else _arm(item)
        if isinstance(item, Arrow) and isinstance(item.direction, AlongLine):
            tail, head = item.direction.tail, item.direction.head
        name = f"phi_{tail}{head}"
        self.sought[name] = (tail, head, item.span)
        self._note(tail, head, Angle.of(name), item.span)

    def _follow(self, item: Arrow | Turn) -> bool:
        """Take what an entry says of directions; False if it must wait for others."""
        match item:
            case Arrow(tail, head, _, None, _):
                return (tail, head) in self._known
            case Arrow(tail, head, _, direction, span):
                assert direction is not None
                if isinstance(direction, AlongLine):
                    self._name(direction.tail, direction.head)
                angle = self.resolve(direction, f"theta_{tail}{head}")
                if angle is not None:
                    self._note(tail, head, angle, span)
                return angle is not None
            case Turn():
                return self._follow_turn(item)

    def _follow_turn(self, turn: Turn) -> bool:
        """Note the direction that an angle gives from another; return whether either is known."""
        gamma = self._terms.angle(turn.angle, f"turn_{turn.first}{turn.vertex}{turn.second}")
        self._name(turn.vertex, turn.first)
        self._name(turn.vertex, turn.second)
        first, second = self.of(turn.vertex, turn.first), self.of(turn.vertex, turn.second)
        if first is not None:
            self._note(turn.vertex, turn.second, first + gamma, turn.span)
        elif second is not None:
            self._note(turn.vertex, turn.first, second - gamma, turn.span)
        return first is not None or second is not None

    def _name(self, tail: str, head: str) -> None:
        """Give a vector of two components an angle of its own, as another entry asks for it."""
        if offset := self._oblique.pop(frozenset((tail, head)), None):
            x, y = self._terms.length(offset.x), self._terms.length(offset.y)
            _, angle = self._terms.polar(x, y, f"{offset.tail}{offset.head}")
            self._note(offset.tail, offset.head, angle, offset.span)

    def _note_offset(self, offset: Offset) -> None:
        """A component that is literally zero leaves the direction of the other axis."""
        x, y = self._terms.length(offset.x), self._terms.length(offset.y)
        if bool(x) != bool(y):
            sign = (x or y).coefficient
            angle = Angle.constant((0 if x else 90) + (0 if sign > 0 else 180))
            self._note(offset.tail, offset.head, angle, offset.span)
        elif x and y:
            self._oblique[frozenset((offset.tail, offset.head))] = offset

    def _note(self, tail: str, head: str, angle: Angle, span: Span) -> None:
        known = self._known.get((tail, head))
        if known is None:
            self._known[tail, head] = angle, span
            self._known[head, tail] = angle + HALF_TURN, span
        elif not _same(known[0], angle):
            self._report.add(messages.directions_disagree(span, f"{tail}{head}", known[1]))


def _slid_along(mechanism: Mechanism) -> Iterator[PointPair]:
    """Yield the lines of slots, and those of guides with a place: loops close along them."""
    for slider in mechanism.each(Slider):
        if isinstance(slider.along, AlongLine) and slider.through:
            yield slider.along.tail, slider.along.head
    yield from ((slot.tail, slot.head) for slot in mechanism.each(Slot))


def _arm(turn: Turn) -> PointPair:
    """Return the first arm of a turn."""
    return turn.vertex, turn.first


def _same(a: Angle, b: Angle) -> bool:
    difference = a - b
    return not difference.terms and difference.degrees % 360 == 0
