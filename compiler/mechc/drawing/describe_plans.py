"""Plans in words, for whoever cannot see them."""

import math
from collections.abc import Iterator, Mapping

from ..formula.names import split_points
from ..pose.places import Plane
from .acting import Forces, heading, in_words
from .drawing import Run
from .force_polygon import visible
from .lettering import figures
from .speeds import Speeds


def say_velocities(speeds: Speeds, words: Mapping[str, str]) -> str:
    """Return how fast every point moves, and in which direction."""
    said = "; ".join(_velocities(speeds))
    return f"{words['velocities']}: {said}."


def _velocities(speeds: Speeds) -> Iterator[str]:
    velocities = speeds.velocities
    for point, velocity in velocities.points.items():
        if split_points(point) and velocities.speed(point) > 0:
            size = speeds.size(velocities.speed(point), point)
            yield _towards((*speeds.name(point), *size), velocity)


def say_forces(forces: Forces) -> str:
    """Return the forces on every body in the order of its polygon."""
    said = "; ".join(_bodies(forces))
    return f"{in_words(heading(forces.diagram, forces.words))}: {said}." if said else ""


def _bodies(forces: Forces) -> Iterator[str]:
    for body in forces.described:
        acting = visible(forces, body)
        sides = ", ".join(
            _towards((*forces.name(body, one), *forces.size(one)), one.force)
            for one in acting
            if one.force
        )
        if sides:
            yield f"{forces.called(body.name)}: {sides}"


def _towards(runs: tuple[Run, ...], vector: Plane) -> str:
    angle = round(math.degrees(vector.angle) % 360, 1) % 360
    return f"{in_words(runs)} ∠ {figures(angle)}°"
