"""What follows from a result at a pose, held against velocities and against nearby poses.

Dead centres and loads across the motion, slopes, lengths that are infinite. Each function yields
what is refuted, in words; nothing where all holds.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

import statements
from mechc.formula.walk import symbols
from mechc.model.mechanism import Force, Mechanism, Torque
from mechc.model.parts.targets import LoadRatio
from mechc.model.values import independent
from mechc.study.analysis import Analysis, DeadCentre, Vanishing
from mechc.syntax import ast
from reference_geometry import assemble_half, defined
from reference_kinematics import Motion
from statements import NEAR, ROUNDED_ZERO, Values, evaluate, order, poses, roots, with_rest

STEP = 1e-6
"""How far a parameter is moved for a slope, in radians or as a part of its size."""


def refuted(
    tree: ast.File | None, mechanism: Mechanism, result: Analysis, seed: int = 0
) -> Iterator[str]:
    """Yield every conclusion from a result that is refuted; dead centres where there is a tree."""
    for pose in poses(mechanism, result, 2, seed):
        yield from slopes(mechanism, result, pose)
        if tree and isinstance(result.target, LoadRatio) and not result.where:
            yield from centres(tree, mechanism, result, pose)
    yield from breaks(mechanism, result, seed)


# ----------------------------------------------------------------------------- slopes


def slopes(mechanism: Mechanism, result: Analysis, pose: Values) -> Iterator[str]:
    """Yield the derivatives that are no slopes of the formula, through all that it rests on."""
    free = {n: pose[n] for n in statements.free(mechanism, pose)}
    for name, derivative in (result.derivatives or {}).items():
        if name not in free or not symbols(result.formula) <= pose.keys():
            continue
        if undefined := symbols(derivative) - pose.keys():
            yield f"d{result.name}/d{name} rests on {undefined}, which nothing defines"
            continue
        stated = evaluate(derivative, pose)
        tried = [_slope(mechanism, result, (free, name, part * STEP)) for part in STEPS]
        found = [slope for slope in tried if slope]
        if found and not any(one.allows(stated) for one in found):
            yield f"d{result.name}/d{name} = {found[0].slope}, not {stated}"


class Slope(NamedTuple):
    """A difference quotient, and the size of what it is a difference of, by the same unit."""

    slope: float
    size: float

    def allows(self, stated: float) -> bool:
        """Return whether a derivative is that, or not finite."""
        near = abs(stated - self.slope) <= 1e-5 * (self.size + abs(stated)) + ROUNDED_ZERO
        return near or not math.isfinite(stated)


def _slope(
    mechanism: Mechanism, result: Analysis, moved: tuple[Values, str, float]
) -> Slope | None:
    """Return the slope of a result by a parameter, None where its values are too rough for one."""
    free, name, part = moved
    size = max(1e-3, abs(free[name]))
    step = part * size
    places = ({**free, name: free[name] + i * step} for i in RULE)
    found = [statements.value(mechanism, result, values) for values in places]
    slope = sum(w * k for w, k in zip(WEIGHTS, found, strict=True)) / step
    if not math.isfinite(slope) or is_rough(found):
        return None
    return Slope(slope, max(map(abs, found)) / size)


STEPS = (1, 30)
"""Steps of slopes: rounding spoils the nearer ones, a bend the farther, what is wrong both."""

STILL = 1e-7
"""Of two speeds near a dead centre, a ratio that is rounding, by whatever power it falls."""

NOISE = 1e-14
"""A speed of nothing but rounding, where the whole motion is 1."""

DISTANCES = (STEP, 100 * STEP, 10_000 * STEP)
"""How near to a dead centre speeds are looked at; the farther the higher the order they vanish."""

RULE, WEIGHTS = (-2, -1, 1, 2), (1 / 12, -2 / 3, 2 / 3, -1 / 12)
"""Places and weights of a difference quotient of fourth order."""


def is_rough(found: list[float]) -> bool:
    """Return whether a curve bends within the steps: a pole or a kink is near, or in the middle."""
    before, across, after = np.diff(found)
    bent = max(abs(before - after), abs(across - before - after))
    return bool(bent > 1e-3 * max(abs(before), abs(after)))


# ----------------------------------------------------------- dead centres, by velocities


def centres(tree: ast.File, mechanism: Mechanism, result: Analysis, pose: Values) -> Iterator[str]:
    """Yield the dead centres at which what is said to stand still moves, and the other way.

    Where a zero of k meets a pole, k is 0/0, and the other values decide what stands still. Where
    two of a kind meet, the one at which a point stands still says nothing of the other's load.
    """
    assert isinstance(result.target, LoadRatio)
    below, above = result.target.below, result.target.above
    zeros, poles = result.zeros, result.poles
    for limits, others, names in ((zeros, poles, (below, above)), (poles, zeros, (above, below))):
        for limit in limits:
            if limit.at is not None and limit.cause != "other":
                alike = (other for other in limits if other.cause != limit.cause)
                against = limit.except_where + tuple(o.factor for o in (*others, *alike))
                yield from _centre(
                    tree, mechanism, limit._replace(except_where=against), names, pose
                )


def _centre(
    tree: ast.File, mechanism: Mechanism, limit: Vanishing, names: tuple[str, str], pose: Values
) -> Iterator[str]:
    loads = {load.name: load for load in mechanism.loads}
    free = {p.name: pose[p.name] for p in independent(mechanism) if p.name in pose}
    assert limit.at is not None
    name, value = limit.at
    if name not in free or not all(isinstance(loads[n], Force | Torque) for n in names):
        return
    x = evaluate(value, free)
    if statements.meets_another(limit, {**free, name: x}):
        return
    asked = [loads[n] for n in names]
    tried = (
        [_speeds(tree, {**free, name: x + part * d}, asked) for part in (1, 10)] for d in DISTANCES
    )
    near, far = next((s for s in tried if all(s) and min(map(min, s)) > NOISE), ([], []))
    if not near:
        return
    first, second = near[0] / near[1], far[0] / far[1]
    stands = first < 0.3 * second or first < STILL
    if stands != isinstance(limit.cause, DeadCentre):
        yield f"{limit.cause} at {name} = {math.degrees(x):.4f}°: {near}, {far}"


def _speeds(tree: ast.File, values: Values, loads: list[Force | Torque]) -> list[float]:
    """Return how fast the points, or links, of loads move; nothing where the motion is not one."""
    motion = Motion(assemble_half(tree, defined(tree, dict(values))))
    if motion.basis.shape[1] != 1:
        return []
    found = []
    for load in loads:
        row = motion.velocity(load.point) if isinstance(load, Force) else motion.turning(load.link)
        found.append(float(np.linalg.norm(row @ motion.basis)))
    return found


# ------------------------------------------------------------------------ what is infinite


def breaks(mechanism: Mechanism, result: Analysis, seed: int) -> Iterator[str]:
    """Yield the conditions under which what is said to be infinite is not."""
    for pose, name, low, high in statements.sweeps(mechanism, result, seed):
        free = {p.name: pose[p.name] for p in independent(mechanism) if p.name in pose}

        def at(x: float, name: str = name, free: Values = free) -> Values:
            return with_rest(mechanism, result, {**free, name: x})

        for limit in result.breaks:
            for x in roots(lambda x, f=limit.factor: evaluate(f, at(x)), low, high):
                own = order(lambda x, f=limit.factor: abs(evaluate(f, at(x))), x, NEAR)
                found = order(lambda x, n=limit.name: abs(at(x).get(n, math.nan)), x, NEAR)
                if own is not None and own > 0.5 and found is not None and found > -0.5:
                    yield f"{limit.name} is not infinite at {name} = {x}: order {found:.2f}"
