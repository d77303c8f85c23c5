"""Branches to follow by their arc length, as the sides of their equations and the slopes of these.

Sides are functions of the unknowns and of the share of a way, in numbers as in arrays.
"""

import math

import numpy as np


def curve(x, at, along):
    """Return ``t = along(x)`` as one equation: where its slope is zero the curve turns back."""
    step = 1e-6
    slope = (along(x + step) - along(x - step)) / (2 * step)
    return along(x) - at, slope


def of_one(along):
    """Return the sides of ``along(x) = t``."""

    def sides(unknowns, share):
        residual, slope = curve(unknowns[0], share, along)
        return [residual], [[slope, -1.0]]

    return sides


def wave(height):
    """Rise to a hill of a height, fall into a valley, and rise to all heights; from 0 on."""
    return lambda x: height * (6.75 * x * (1 - x) ** 2)


def layer(width):
    """Turn from one straight line to another that is fifty times as steep, within a width."""
    return lambda x: x - 0.98 * (np.sqrt((x - 0.5) ** 2 + width**2) + (x - 0.5)) / 2


def begun(along):
    """Return where a curve begins, near 0."""
    x = 0.0
    for _ in range(5):
        residual, slope = curve(x, 0.0, along)
        x -= float(residual / slope)
    return x


CURVES = {
    "hill below the end": (wave(0.7), 1),
    "hill just below the end": (wave(1 - 1e-6), 1),
    "hill above the end": (wave(1.3), 0),
    "sharp hill": (lambda x: 0.4 - np.sqrt((x - 0.4) ** 2 + 1e-12), 1),
    "corner, where no tangent goes on": (lambda x: 0.4 - abs(x - 0.4), 2),
    "flat": (layer(1e-4), 0),
    "no more": (lambda x: np.where(x < 0.6, x, np.nan), 2),
    "gap": (lambda x: x + (x > 0.5), 2),
}


def crossing(unknowns, share):
    """The sides of y·(t - 1/2 - y²) = 0, x = t: three branches cross at t = 1/2, y = 0."""
    x, y = unknowns
    rest = share - 0.5
    return [x - share, y * (rest - y * y)], [[1.0, 0.0, -1.0], [0.0, rest - 3 * y * y, y]]


def nearly_crossing(falls, rises, apart):
    """Return the sides of two lines across t = 1/2, parted into an upper and a lower branch."""

    def sides(unknowns, share):
        (y,), u = unknowns, share - 0.5
        above, below = y + falls * u, y - rises * u
        return [above * below - apart], [[above + below, falls * below - rises * above]]

    return sides


def upper(falls, rises, apart, share):
    """Return y on the upper of these branches."""
    u = share - 0.5
    middle, half = (rises - falls) * u / 2, (rises + falls) * u / 2
    return middle + math.sqrt(half * half + apart)


NEARLY_CROSSING = [(0.5, 2.0, 0.003), (0.3, 3.0, 0.01), (0.3, 1.5, 0.001)]
"""How the lines fall and rise, and how far the branches are apart."""


def bent(slope, bend):
    """Return the sides of t = slope x + bend x²: the share grows ever faster along it."""

    def sides(x, t):
        return [slope * x[0] + bend * x[0] * x[0] - t], [[slope + 2 * bend * x[0], -1.0]]

    return sides


def bent_end(slope, bend):
    """Return x where the share is 1."""
    return (math.sqrt(slope * slope + 4 * bend) - slope) / (2 * bend)


BENDS = [(0.365, 0.25), (0.065, 0.5), (0.4, 0.5), (0.715, 1)]
"""Square to a tangent such a way is past its end."""


def own_friction(unknowns, share):
    """The sides of a force x that its own friction alone makes, of the load q, on a circle.

    With all of the share x = |1.5 x|, so that x = 0 is the solution. What is rounded off makes a
    fold where q = 0, at t = 2/3.
    """
    x, q = unknowns
    force, left = 1.5 * share * x, 0.03 * (1.0 - share)
    size = np.sqrt(force * force + left * left * q * q + 1e-60)
    by_share = (0.03 * left * q * q - 1.5 * x * force) / size
    slopes = [1.0 - 1.5 * share * force / size, -left * left * q / size, by_share]
    return [x - size, x * x + q * q - 1.0], [slopes, [2 * x, 2 * q, 0.0]]


def steep(unknowns, outer):
    """The sides of ``x - 2 e x³ = p`` with a fold at x² = 1/(6 e), and a kink of another slope."""
    (x,), (p, e) = unknowns, outer
    return [x - 2 * e * x**3 - p], [[1 - 6 * e * x * x]]


def steep_along(unknowns, outer, changes):
    """The same with the slope by the share of a way on which p and e change."""
    residuals, ((slope,),) = steep(unknowns, outer)
    return residuals, [[slope, -2 * unknowns[0] ** 3 * changes[1] - changes[0]]]
