"""What wheels alone lead in a drawn mechanism: it follows the drive from where it is drawn.

A gear, a belt, a rack or a screw ties motions since the drawing: turns of links, ways of
sliders along their guides. ``r·turn`` of two gears is equal but for its sign, as seen from the
arm that carries them; the way of a rack is ``r·turn``. Where all motions but one are known as
formulas of the drive, so is that one.
"""

import math
from collections.abc import Iterator, Mapping

from ...base.frozen import replace
from ...base.named import NamedTuple
from ...diagnostics import Report
from ...diagnostics import drawn_places as messages
from ...formula.evaluate import evaluate
from ...formula.tree import (
    ZERO,
    Call,
    Formula,
    Number,
    degrees,
    negative,
    number,
    product,
    total,
)
from ...formula.walk import symbols
from ..entries import direction_matters, place_matters
from ..mechanism import (
    Absolute,
    AlongLine,
    Arrow,
    Direction,
    Feed,
    Geometry,
    Joint,
    Mechanism,
    Mesh,
    Offset,
    Slider,
)
from ..parts.holding import SizeLetter, Tied
from ..tolerances import VANISHED
from ..values import Values
from .rigidity import Independent, RigidityRow, direction, fixed
from .sketch import Sketch


def with_named_sizes(mechanism: Mechanism, sketch: Sketch) -> Mechanism:
    """Return the mechanism with a name for each radius of a rack and each pitch, if a number.

    In the place of a slider it would not be known as a length.
    """
    joints = tuple(_with_named_size(joint, sketch) for joint in mechanism.joints)
    return replace(mechanism, joints=joints)


def _with_named_size(joint: Joint, sketch: Sketch) -> Joint:
    """Return a rack or a screw of a drawn point with a name for its radius or pitch."""
    if not isinstance(joint, Feed) or joint.point not in sketch.places:
        return joint

    def named(size: SizeLetter) -> Formula:
        if not isinstance(size.formula, Number):
            return size.formula
        return sketch.length_called(f"{size.letter}_{size.of}", size.formula, joint.point)

    return joint.with_sizes([named(size) for size in joint.sizes])


# -------------------------------------------------------------------- what wheels tie


def _ties(mechanism: Mechanism) -> Iterator[tuple[Mesh, tuple[Tied, ...]]]:
    """Yield what wheels tie, each way of a point with the body that it stands for."""
    for mesh in mechanism.meshes:
        yield mesh, tuple(_named(term, mechanism) for term in mesh.tied)


def _named(term: Tied, mechanism: Mechanism) -> Tied:
    return term._replace(body=_guided(term.point, mechanism)) if term.point else term


def _guided(point: str, mechanism: Mechanism) -> str:
    """Return the body that a point of a guide stands for: its slide, or itself."""
    return next((slide.name for slide in mechanism.slides_at(point)), point)


def _matters(term: Tied, mechanism: Mechanism) -> bool:
    if term.point:
        return place_matters(term.point, mechanism)
    links = (link for link in mechanism.links if link.name == term.body)
    return any(direction_matters(link, mechanism) for link in links)


def _led(
    tie: tuple[Tied, ...], motions: Mapping[str, Formula], values: Values
) -> tuple[Tied, Formula] | None:
    """Return the one motion of a tie that is not known, and what it is."""
    unknown = [term for term in tie if term.body not in motions]
    if len(unknown) != 1 or _is_zero(unknown[0].factor, values):
        return None
    (led,) = unknown
    others = ((t.factor, motions[t.body]) for t in tie if t is not led)
    parts = (
        product([(factor, 1), (led.factor, -1), (motion, 1), (number(-1), 1)])
        for factor, motion in others
    )
    return led, total(parts)


def _is_zero(factor: Formula, values: Values) -> bool:
    """Return whether a motion does not count: an arm's, where inner wheels are alike."""
    if not symbols(factor) <= values.keys():
        return False
    return math.isclose(evaluate(factor, values), 0, abs_tol=VANISHED)


# ------------------------------------------------------------------------- the train


class Train(NamedTuple):
    """A drawn mechanism whose wheels are followed from the drawing on, at its ``values``."""

    mechanism: Mechanism
    sketch: Sketch
    values: Values

    def followers(self, held: Independent) -> Iterator[Geometry]:
        """Yield where links and sliders are that nothing but wheels leads, wheel after wheel."""
        if not any(self._free(held)):
            return
        motions = {"": ZERO, **dict(self._given())}
        ties = [tie for _, tie in _ties(self.mechanism)]
        while one := next(filter(None, (_led(tie, motions, self.values) for tie in ties)), None):
            led, motion = one
            motions[led.body] = motion
            row = self._row(led)
            if row is not None and held.takes(row):
                yield self._placed(led, motion)

    def check(self, held: Independent, report: Report) -> None:
        """Report E516 for what wheels alone lead, where the leader's motion is no formula."""
        for mesh, term in self._free(held):
            if _matters(term, self.mechanism):
                report.add(messages.wheels_alone_lead(mesh.span, term.body, mesh.id))

    def _free(self, held: Independent) -> Iterator[tuple[Mesh, Tied]]:
        """Yield the terms of motions that wheels tie and nothing else holds."""
        for mesh, tie in _ties(self.mechanism):
            for term in tie:
                row = self._row(term)
                if row is not None and held.lacks(row):
                    yield mesh, term

    def _given(self) -> Iterator[tuple[str, Formula]]:
        """Yield the motions since the drawing that the geometry gives."""
        for entry in self.mechanism.geometry:
            if not self.sketch.has(entry):
                continue
            for link in self.mechanism.links:
                if isinstance(entry, Arrow) and {entry.tail, entry.head} <= set(link.points):
                    yield from self._turn(link.name, entry)
            yield from self._way(entry)

    def _turn(self, link: str, entry: Arrow) -> Iterator[tuple[str, Formula]]:
        """Yield the turn of a link; full turns of the drive since the drawing are none."""
        towards = entry.direction
        if isinstance(towards, Absolute) and symbols(towards.angle) <= self.values.keys():
            drawn = self.sketch.start(entry.tail, entry.head)
            x, y = self.sketch.way(entry.tail, entry.head)
            full = round((evaluate(towards.angle, self.values) - math.atan2(y, x)) / math.tau)
            yield link, total([towards.angle, negative(drawn), degrees(-360 * full)])

    def _way(self, entry: Geometry) -> Iterator[tuple[str, Formula]]:
        """Yield the way of a point along its guide, where its place on the ground is given."""
        match entry:
            case Arrow(tail, head, length, Absolute(angle)) if length is not None:
                vector = tuple(product([(length, 1), (part, 1)]) for part in _unit(angle))
            case Offset(tail, head, x, y):
                vector = x, y
            case _:
                return
        guide = self._guide(head) if tail in {"", *self.mechanism.fixed} else None
        way = _along(guide, vector) if guide else None
        if guide and way and symbols(way) <= self.values.keys():
            drawn = _along(guide, self.sketch.offset(tail, head))
            yield _guided(head, self.mechanism), total([way, negative(drawn)])

    def _guide(self, point: str) -> Formula | None:
        """Return the direction of a point's guide; None where it is no angle of the ground."""
        found = [s.along for s in self.mechanism.each(Slider) if s.point == point]
        found += [s.along for s in self.mechanism.slides_at(point)]
        return self._angle(found[0]) if found else None

    def _angle(self, direction: Direction) -> Formula | None:
        match direction:
            case Absolute(angle):
                return angle
            case AlongLine(tail, head, quarter) if {tail, head} <= self.mechanism.fixed:
                if self.sketch.has_all((tail, head)):
                    return total([self.sketch.start(tail, head), degrees(90 * quarter)])
        return None

    def _arm(self, term: Tied) -> tuple[str, str] | None:
        """Return a drawn arm of a link; None of the ground."""
        links = (link for link in self.mechanism.links if link.name == term.body)
        return next((arm for link in links for arm in self.sketch.arms(link.points)), None)

    def _row(self, term: Tied) -> RigidityRow | None:
        """Return the row of a motion; None where nothing drawn takes part in it."""
        if not term.point:
            arm = self._arm(term)
            return direction(*arm, self.sketch) if arm else None
        guide = self._guide(term.point)
        if guide is None or not symbols(guide) <= self.values.keys():
            return None
        return fixed(term.point, evaluate(guide, self.values) - math.pi / 2)

    def _placed(self, term: Tied, motion: Formula) -> Geometry:
        """Return where a link or a slider is after a motion from its drawn place."""
        if term.point:
            return self._moved(term.point, motion)
        arm = self._arm(term)
        assert arm is not None
        span = self.sketch.span(arm[1])
        return Arrow(*arm, None, Absolute(total([self.sketch.start(*arm), motion]), span), span)

    def _moved(self, point: str, way: Formula) -> Geometry:
        guide, sketch = self._guide(point), self.sketch
        assert guide is not None
        x, y = sketch.offset("", point)
        along, up = (product([(way, 1), (part, 1)]) for part in _unit(guide))
        return Offset("", point, total([x, along]), total([y, up]), sketch.span(point))


def _unit(angle: Formula) -> tuple[Formula, Formula]:
    """Return the components of a unit vector."""
    return Call("cos", (angle,)), Call("sin", (angle,))


def _along(guide: Formula, vector: tuple[Formula, ...]) -> Formula:
    """Return the component of a vector along a guide."""
    return total(
        product([(part, 1), (unit, 1)]) for part, unit in zip(vector, _unit(guide), strict=True)
    )
