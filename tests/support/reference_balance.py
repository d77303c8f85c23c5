"""Which loads balance with friction, from coordinates, for tests only.

The equilibrium of all bodies is homogeneous in forces and loads: it is followed from the
coefficients of friction 0 to their values, in small steps, with all forces and both loads
of one size altogether. So the way goes through an infinite drive, and ends only where two
solutions meet. Nothing is shared with the compiler but the syntax tree.
"""

import numpy as np

from reference_forces import Forces
from reference_friction import FrictionPair
from reference_kinematics import Array

STEP = 1 / 64
"""The part of the coefficients by which they grow at most."""

SHORTEST = 1e-9
"""Where such a step is too long, two solutions meet."""


def ratio(forces: Forces, drive: str, load: str, sense: int) -> float | None:
    """Return drive over load where they balance, the drive along its arrow or against it.

    None where no load as directed balances.
    """
    against = forces.loads[load]
    matrix = np.column_stack([forces.matrix, forces.loads[drive], against])
    pairs = forces.friction_pairs(drive)
    start = np.linalg.lstsq(matrix[:, :-1], -against, rcond=1e-11)[0]
    found = np.append(start, 1.0)
    found /= np.linalg.norm(found)
    reached, step = 0.0, STEP
    while reached < 1:
        aim = min(1.0, reached + step)
        following = _balanced(matrix, pairs, sense * aim, found)
        if following is not None and np.linalg.norm(following - found) < 0.1:
            found = following / np.linalg.norm(following)
            reached, step = aim, min(2 * step, STEP)
        elif (step := step / 2) < SHORTEST:
            return None
    return float(found[-2] / found[-1]) if found[-1] > 1e-9 else None


def _balanced(matrix: Array, pairs: list[FrictionPair], part: float, near: Array) -> Array | None:
    """Return forces in balance near others, None where there are none."""
    found = near
    for _ in range(30):
        gap, slopes = matrix @ found, matrix.copy()
        for pair in pairs:
            loaded = found[list(pair.pressing)]
            size, against = np.linalg.norm(loaded), -part * pair.factor * pair.dragged
            gap = gap + against * size
            for column, each in zip(pair.pressing, loaded / (size or 1), strict=True):
                slopes[:, column] += against * each
        right = np.append(-gap, 1 - near @ found)
        change = np.linalg.lstsq(np.vstack([slopes, near]), right, rcond=1e-12)[0]
        found = found + change
        if np.abs(change).max() <= 1e-13 * np.abs(found).max():
            return found if np.abs(gap).max() < 1e-10 * np.abs(found).max() else None
    return None
