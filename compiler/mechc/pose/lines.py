"""The directions that parts of a mechanism have: guides, forces, slides, ropes, the mirror line."""

from collections.abc import Callable, Mapping

from ..algebra.angle import Angle
from ..algebra.intervals import IntervalBox, sign
from ..diagnostics import Report
from ..diagnostics import pose as messages
from ..model.mechanism import AlongLine, Direction, Force, Mechanism, Slider
from .directions import Directions
from .pose import Vector
from .samples import Values, is_behind
from .vector_graph import mentioned
from .vectors import Missing, Vectors

FALL = "a fall of the rope"


class Lines:
    """Directions as angles; one that nothing gives is reported, once for all that ask for it.

    ``poses`` gives the default pose and some near it, ``box`` what values may be; few ask for them.
    """

    def __init__(
        self,
        directions: Directions,
        vectors: Vectors,
        missing: Missing,
        poses: Callable[[], list[Values]],
        box: Callable[[], IntervalBox],
        report: Report,
    ) -> None:
        self._directions, self._vectors = directions, vectors
        self._missing, self._poses, self._box, self._report = missing, poses, box, report

    def of(self, direction: Direction, name: str, for_what: str) -> Angle:
        """Return a direction, of whose angle ``name`` is the name where it has to have one."""
        angle = self._directions.resolve(direction, name)
        if angle is None:
            assert isinstance(direction, AlongLine)
            angle = self._along_path(direction, for_what)
        return angle or Angle()

    def _along_path(self, direction: AlongLine, for_what: str) -> Angle | None:
        """Return the direction of a vector that is a sum, named where it is no single arm.

        A difference on one line has a name, too, where its ends may change places.
        """
        tail, head, quarter = direction.tail, direction.head, direction.quarter
        vector = self._vectors.path(tail, head)
        if vector is None:
            if self._missing.add(tail, head):
                fall_to = head if for_what == FALL else ""
                message = messages.missing_direction(
                    direction.span, f"{tail}{head}", for_what, fall_to=fall_to
                )
                self._report.add(message)
        elif not vector or (len(vector) > 1 and self._vectors.is_open(vector)):
            self._report.add(messages.no_direction_of_its_own(direction.span, f"{tail}{head}"))
        elif sense := self._sense(vector):
            return vector[0].angle + Angle.constant(90 * quarter + (0 if sense > 0 else 180))
        else:
            return self._vectors.straighten(tail, head) + Angle.constant(90 * quarter)
        return None

    def _sense(self, vector: Vector) -> int:
        """Return whether a vector of one arm points ahead, 1, or back; 0 where it may do either.

        Of a length that the pose finds it is as at the default pose. Of several arms it is 0.
        """
        if len(vector) > 1:
            return 0
        length, names = vector[0].length, mentioned(vector) - vector[0].angle.names
        if len(names) > 1 and names <= (box := self._box()).keys():
            sense = sign(length, box) or 0
            self._vectors.ahead += [length.scaled(sense)] if sense else []
            return sense
        return -1 if is_behind(length, self._poses()) else 1


def guides(mechanism: Mechanism, lines: Lines) -> Mapping[str, Angle]:
    """Return the direction of the guide of every slider, by its point."""
    return {
        s.point: lines.of(s.along, f"theta_{s.point}", f"the guide of {s.point}")
        for s in mechanism.each(Slider)
    }


def mirror_line(mechanism: Mechanism, lines: Lines) -> Angle | None:
    """Return the direction of the mirror line; None without a mirror."""
    mirror = mechanism.mirror
    return lines.of(mirror.across, "theta_mirror", "the mirror") if mirror else None


def forces(mechanism: Mechanism, lines: Lines) -> Mapping[str, Angle]:
    """Return the direction of every force."""
    return {
        f.name: lines.of(f.along, f"theta_{f.name}", f"the force {f.name}")
        for f in mechanism.loads
        if isinstance(f, Force)
    }


def slides(mechanism: Mechanism, lines: Lines) -> Mapping[str, Angle]:
    """Return the direction of every body that only translates."""
    return {
        s.name: lines.of(s.along, f"theta_{s.name}", f"the slide {s.name}")
        for s in mechanism.slides
    }


def falls(mechanism: Mechanism, lines: Lines) -> Mapping[str, tuple[Angle, ...]]:
    """Return the directions of the falls of every rope."""
    return {
        rope.id: tuple(lines.of(way, "theta_rope", FALL) for way in rope.ways)
        for rope in mechanism.ropes
    }
