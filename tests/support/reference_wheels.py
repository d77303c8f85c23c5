"""Gears, belts, racks and screws for the reference: two rims that move together somewhere.

Where two wheels meet, the material points of both have one velocity along the common
tangent: of gears where their pitch circles touch, of a belt where a run of it leaves them.
A rack is met by the rim on the right of its guide; a screw acts as a wheel whose rim goes
once around in a pitch. Between pivots the line of centres may lie anywhere, so it is taken
at random; an arm that carries the centres gives it.
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
    """Two bodies whose points at two places have one velocity along a unit direction.

    A body of '' is the ground; the ``arm`` carries wheels that move, and is '' for others.
    """

    first: str
    first_place: complex
    second: str
    second_place: complex
    along: complex
    arm: str = ""


def rollings(
    file: ast.File, bodies: Sweep, guides: Mapping[str, complex], value: Evaluate
) -> Iterator[Rolling]:
    """Yield what every pair of wheels, every rack and every screw of a description demands."""
    guess = random.Random(1)
    for s in file.statements:
        match s:
            case ast.Gear(inner=same) | ast.Belt(crossed=same):
                beside = same if isinstance(s, ast.Gear) else not same
                arm, ends = _arm(s, _fixed(file), bodies), (s.first.text, s.second.text)
                radii = value(s.first_radius), value(s.second_radius) * (1 if beside else -1)
                normal = cmath.rect(1, guess.uniform(0, 7))
                if arm:
                    apart = bodies[arm][ends[1]] - bodies[arm][ends[0]]
                    cosine = round((radii[0] - radii[1]) / abs(apart), 12)
                    normal = apart / abs(apart) * cmath.rect(1, math.acos(cosine))
                wheels = [
                    _wheel(on.text if on else "", point, arm, bodies)
                    for on, point in zip((s.first_link, s.second_link), ends, strict=True)
                ]
                places = [
                    bodies[wheel][point] + normal * radius if wheel else 0
                    for wheel, point, radius in zip(wheels, ends, radii, strict=True)
                ]
                yield Rolling(wheels[0], places[0], wheels[1], places[1], 1j * normal, arm)
            case ast.Rack(point=point, pivot=pivot, radius=radius):
                wheel = _on(pivot.text, bodies)
                center = bodies[wheel][pivot.text]
                yield _led(point.text, wheel, center, value(radius), bodies, guides)
            case ast.Screw(point=point, link=link, pitch=pitch):
                wheel = next(b for b, places in bodies.items() if b == link.text)
                center = next(iter(_fixed(file) & bodies[wheel].keys()))
                reach = value(pitch) / (2 * math.pi)
                yield _led(point.text, wheel, bodies[wheel][center], reach, bodies, guides)


def _arm(s: ast.Gear | ast.Belt, fixed: set[str], bodies: Sweep) -> str:
    """Return the link that carries both centres, '' for the ground."""
    centres = {s.first.text, s.second.text}
    both = (name for name, places in bodies.items() if centres <= places.keys())
    return "" if centres <= fixed else next(both)


def _wheel(named: str, point: str, arm: str, bodies: Sweep) -> str:
    """Return the link that a wheel is fixed to, '' for the ground."""
    if named:
        return "" if named == "ground" else named
    return next(b for b, places in bodies.items() if point in places and b != arm)


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
