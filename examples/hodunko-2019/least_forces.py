"""The least forces of V jaws that friction allows, beside those of Hodunko, Pavlenko 2019.

Run it from anywhere; one row is one place of the jaws of figure 5, in degrees and newtons:
python examples/hodunko-2019/least_forces.py > least.csv

Each face presses along its normal, and rubs by up to f times that. The sum of the normal
forces that carry the part is least at a corner of what is possible: this linear programme
has so few corners that all of them are tried.
"""

import csv
import sys
from collections.abc import Iterator
from itertools import combinations

import numpy as np

import mechc

JAWS = mechc.load("prism_jaws")


def edges(alpha: float, phi: float, f: float) -> np.ndarray:
    """Return the edges of the four friction cones: level, upright, moment over the radius."""
    below, above = alpha / 2 + phi, alpha / 2 - phi
    normals = [
        (np.sin(below), np.cos(below)),
        (np.sin(above), -np.cos(above)),
        (-np.sin(below), np.cos(below)),
        (-np.sin(above), -np.cos(above)),
    ]
    return np.array([(x - s * y, y + s * x, s) for x, y in normals for s in (f, -f)])


def least(alpha: float, beta: float, phi: float, G: float, I: float, f: float) -> float:  # noqa: E741
    """Return the least sum of normal forces that balances the weight and the force of inertia."""
    needed = np.array([-I * np.sin(beta), G + I * np.cos(beta), 0.0])
    sums = []
    for corner in combinations(edges(alpha, phi, f), 3):
        matrix = np.transpose(corner)
        if abs(np.linalg.det(matrix)) > 1e-12:
            forces = np.linalg.solve(matrix, needed)
            if forces.min() > -1e-9:
                sums.append(forces.sum())
    return min(sums)


def rows() -> Iterator[list[str]]:
    """Yield the heading, then the sums at each place of the vertices."""
    yield ["phi", "P_c", "least"]
    for phi in range(-10, 11):
        given = {n: v for n, v in JAWS.defaults.items() if n != "k"} | {"phi": np.radians(phi)}
        yield [f"{phi}", f"{JAWS.evaluate(**given)['P_c']:.9g}", f"{least(**given):.9g}"]


if __name__ == "__main__":
    csv.writer(sys.stdout, lineterminator="\n").writerows(rows())
