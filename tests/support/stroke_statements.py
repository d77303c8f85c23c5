"""What is said along a stroke of standstills, efficiencies and dead centres, against code.

Each function yields what sampling refutes, in words; nothing where all holds. Zeros, poles and
extrema are looked at in ``test_stroke_random``.
"""

import math
import re
from collections.abc import Iterator, Mapping

import numpy as np

from friction_statements import NEAR, STATES, Ratios, run
from mechc.api import SolvedMechanism
from mechc.compilation import Compilation
from mechc.study.analysis import Acted, DeadCentre
from mechc.study.stroke.stroke import Stroke

DENSE = 801
"""Places along a stroke."""

INSIDE = (1e-8, 1e-6)
"""How far from a dead centre velocities are compared, as parts of the stroke."""

FALLS = 0.5
"""The speed of what stands still is less than this part nearer by: at an end of a loop a tenth."""

ROUNDED = 1e-6
"""What angles of links that lie on one another leave of a zero, at half the digits."""

CLEAR = 1e-3
"""A part of a part at its ends, next to which rounding grows: a loop may end there."""

STILL = 1e-7
"""A share of speed that is rounding."""


def refuted(compilation: Compilation, stroke: Stroke) -> Iterator[str]:
    """Yield every statement on friction along a stroke that sampling refutes."""
    results = {r.name: r for r in compilation.results}
    places = np.linspace(stroke.low, stroke.high, DENSE + 2)[1:-1]
    for result in results.values():
        if result.locking:
            yield from stuck(Ratios(compilation, result), stroke, result.name, places)
    for name, efficiency in stroke.efficiency_ranges:
        yield from run(Ratios(compilation, results[name]), results[name], efficiency)


def stuck(ratios: Ratios, stroke: Stroke, name: str, places: np.ndarray) -> Iterator[str]:
    """Yield where code has another state than the stroke says; of dead centres nothing is said."""
    parts = [s for s in stroke.standstills if s.result == name]
    ends = [end for s in (*parts, *stroke.stretches) for end in (s.low, s.high)]
    ends += [s.drive for s in stroke.singular]
    near = NEAR * (stroke.high - stroke.low)
    k, _ = ratios.along(stroke.drive, places)
    moving = places[k != 0]
    states = np.broadcast_to(ratios.states({stroke.drive: moving}), moving.shape)
    for x, code in zip(moving, states, strict=True):
        if int(code) not in STATES or any(abs(x - end) < near for end in ends):
            continue
        said = next((s.state for s in parts if s.low <= x <= s.high), "free")
        if said != STATES[int(code)]:
            yield f"{name} at {stroke.drive} = {x!r}: said {said}, is {STATES[int(code)]}"
            return


def zero_throughout(mechanism: SolvedMechanism, stroke: Stroke) -> Iterator[str]:
    """Yield where a result is not zero on a part on which it is said to be, but for rounding."""
    for part in stroke.zero_intervals:
        width = part.high - part.low
        places = np.linspace(part.low + CLEAR * width, part.high - CLEAR * width, DENSE)
        is_constant = not mechanism[part.result].free_symbols
        values = {} if is_constant else {stroke.drive: places}
        found = mechanism.evaluate(**values)[part.result]
        if np.nanmax(np.abs(found), initial=0.0) > ROUNDED:
            yield f"{part.result} is {np.nanmax(np.abs(found))} between {part.low} and {part.high}"


def moving(mechanism: SolvedMechanism, stroke: Stroke) -> Iterator[str]:
    """Yield the dead centres at which what is said to stand still moves."""
    for pose in stroke.singular:
        if isinstance(pose.kind, DeadCentre):
            near, far = (
                shares(mechanism, stroke, pose.kind, [pose.drive + way * d for way in (-1, 1)])
                for d in (part * (stroke.high - stroke.low) for part in INSIDE)
            )
            if near and far and min(near) > max(STILL, FALLS * max(far)):
                yield f"{pose.kind} at {stroke.drive} = {pose.drive!r}: {far}, then {near}"


def shares(
    mechanism: SolvedMechanism, stroke: Stroke, kind: DeadCentre, places: list[float]
) -> list[float]:
    """Return the speed of what stands still as a part of the other's, where there is a pose."""
    found = []
    for at in places:
        rates, status = mechanism.points(**{stroke.drive: at})
        if status == 0:
            still, other = (abs(rate(rates, stroke.drive, acted)) for acted in kind)
            if math.isfinite(still + other) and other:
                found.append(still / other)
    return found


def rate(rates: Mapping[str, float], drive: str, acted: Acted) -> float:
    """Return how fast, by the drive, a point, the end of a link, or a distance moves, SI.

    Points of the ground have no rates.
    """
    if len(split := re.findall(r"[A-Z][0-9]*'*", acted.name)) == 1:
        return math.hypot(*(rates.get(f"d{c}_{acted.name}_d{drive}", 0.0) for c in "xy"))
    first, last = split[0], split[1]
    along = [rates[f"{c}_{last}"] - rates[f"{c}_{first}"] for c in "xy"]
    names = [(f"d{c}_{last}_d{drive}", f"d{c}_{first}_d{drive}") for c in "xy"]
    speed = [rates.get(head, 0.0) - rates.get(tail, 0.0) for head, tail in names]
    if acted.is_distance:
        return sum(a * v for a, v in zip(along, speed, strict=True)) / math.hypot(*along)
    return math.hypot(*speed)
