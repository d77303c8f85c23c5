"""Gears, belts, racks and screws for the reference: two rims that move together somewhere.

Where two wheels meet, the material points of both have one velocity along the common
tangent. A rack is met by the rim on the right of its guide; a screw acts as a wheel whose
rim goes once around in a pitch. The line of centres may lie anywhere, so it is taken at
random.
"""

import cmath
import math
import random
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from mechc.syntax import ast

Sweep = Mapping[str, Mapping[str, complex]]
"""The points of every body."""

Evaluate = Callable[[ast.Expr], float]


class Rolling(NamedTuple):
    """Two bodies whose points at two places have one velocity along a unit direction."""

    first: str
    first_place: complex
    second: str
    second_place: complex
    along: complex


def rollings(
    file: ast.File, bodies: Sweep, guides: Mapping[str, complex], value: Evaluate
) -> Iterator[Rolling]:
    """Yield what every pair of wheels, every rack and every screw of a description demands."""
    guess = random.Random(1)
    for s in file.statements:
        match s:
            case ast.Gear(inner=same) | ast.Belt(crossed=same):
                normal = cmath.rect(1, guess.uniform(0, 7))
                beside = same if isinstance(s, ast.Gear) else not same
                first = _on(s.first.text, bodies)
                second = _on(s.second.text, bodies)
                yield Rolling(
                    first,
                    bodies[first][s.first.text] + normal * value(s.first_radius),
                    second,
                    bodies[second][s.second.text]
                    + normal * value(s.second_radius) * (1 if beside else -1),
                    1j * normal,
                )
            case ast.Rack(point=point, pivot=pivot, radius=radius):
                wheel = _on(pivot.text, bodies)
                center = bodies[wheel][pivot.text]
                yield _led(point.text, wheel, center, value(radius), bodies, guides)
            case ast.Screw(point=point, link=link, pitch=pitch):
                wheel = next(b for b, places in bodies.items() if b == link.text)
                center = next(iter(_fixed(file) & bodies[wheel].keys()))
                reach = value(pitch) / (2 * math.pi)
                yield _led(point.text, wheel, bodies[wheel][center], reach, bodies, guides)


def _on(point: str, bodies: Sweep) -> str:
    return next(name for name, places in bodies.items() if point in places)


def _fixed(file: ast.File) -> set[str]:
    return {s.point.text for s in file.statements if isinstance(s, ast.Pivot)}


def _led(
    point: str,
    wheel: str,
    center: complex,
    radius: float,
    bodies: Sweep,
    guides: Mapping[str, complex],
) -> Rolling:
    body = _on(point, bodies)
    along = guides[point] if point in guides else guides[body]
    return Rolling(body, bodies[body][point], wheel, center - 1j * along * radius, along)
