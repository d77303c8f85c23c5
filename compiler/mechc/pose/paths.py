"""The positions of all points, as vectors from the origin."""

from collections import deque
from collections.abc import Collection, Iterator

from ..model.mechanism import Link
from ..syntax.vocabulary import points_of
from .pose import Pose, Vector, gathered, measured_by, reverse
from .vector_graph import mentioned
from .vectors import start_of


def paths(pose: Pose, lagging: Collection[Link] = ()) -> dict[str, Vector]:
    """Return the vector from the origin to every point that the description gives a place.

    Without a place of any pivot the origin is at the first pivot. A point is left out to which
    only vectors of open length lead, and one that stands for the place of a guide.
    Links that are ``lagging`` lead nowhere: what is said of their directions holds at one pose.
    """
    ways: dict[str, dict[str, Vector]] = {}
    for tail, head, vector in _given(pose, lagging):
        ways.setdefault(tail, {}).setdefault(head, vector)
        ways.setdefault(head, {}).setdefault(tail, reverse(vector))
    start = start_of(pose.mechanism, ways)
    found: dict[str, Vector] = {start: ()}
    waiting = deque([start])
    while waiting:
        here = waiting.popleft()
        for there, vector in ways.get(here, {}).items():
            if there not in found:
                found[there] = gathered((*found[here], *vector))
                waiting.append(there)
    return {point: vector for point, vector in found.items() if points_of(point)}


def _given(pose: Pose, lagging: Collection[Link]) -> Iterator[tuple[str, str, Vector]]:
    """Yield the vectors whose length and direction are known, by their points."""
    known = {name: value for name, value in pose.placeholders.items() if value is not None}
    closed = {name for name, _ in (*pose.closing, *pose.definitions)}
    values = closed | {parameter.name for parameter in pose.mechanism.parameters} | known.keys()
    lost = [set(link.points) for link in lagging]
    for tail, head, vector in _vectors(pose):
        if any({tail, head} <= points for points in lost):
            continue
        if mentioned(vector) <= values:
            yield tail, head, measured_by(vector, known)


def _vectors(pose: Pose) -> Iterator[tuple[str, str, Vector]]:
    for (tail, head), vector in pose.vectors.items():
        yield tail, head, vector
    for frame in pose.frames.values():
        first, *others = frame
        yield from ((first, point, frame[point]) for point in others if frame[point])
    for contact in pose.contacts:
        if contact.reach:
            yield contact.tail, contact.point, contact.reach
