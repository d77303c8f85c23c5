"""Figures 3 to 5 of Hodunko, Pavlenko 2019 as data: forces of V jaws against an angle.

Run it from anywhere; one row is one point of all curves of a figure, in degrees and newtons:
python examples/hodunko-2019/figures.py > figures.csv
"""

import csv
import sys
from collections.abc import Iterator

import numpy as np

import mechc

JAWS = mechc.load("prism_jaws")

FORCES = ("P_1", "P_3", "P_4", "dP_far", "dP_near", "P_p1", "P_p2", "P_p3", "P_p4")

ALPHA, BETA, PHI = np.arange(80.0, 151.0), np.arange(0.0, 181.0), np.arange(-10.0, 11.0)

FIGURES = {
    "3a": (ALPHA, 0.0, 10.0),
    "3b": (ALPHA, 45.0, 10.0),
    "4a": (120.0, BETA, 0.0),
    "4b": (120.0, BETA, 10.0),
    "5": (120.0, 45.0, PHI),
}
"""alpha, beta and phi of each figure; G = I = 20 N, f = 0.1, k = 1.25 are those of the sheet."""


def rows() -> Iterator[list[str]]:
    """Yield the heading, then the points of each figure in turn."""
    yield ["figure", "alpha", "beta", "phi", *FORCES]
    for figure, given in FIGURES.items():
        angles = np.broadcast_arrays(*given)
        alpha, beta, phi = np.radians(angles)
        found = JAWS.evaluate(alpha=alpha, beta=beta, phi=phi)
        for point in zip(*angles, *(found[force] for force in FORCES), strict=True):
            yield [figure, *(f"{round(value, 9) + 0:.12g}" for value in point)]


csv.writer(sys.stdout, lineterminator="\n").writerows(rows())
