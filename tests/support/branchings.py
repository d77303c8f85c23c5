"""Mechanisms with poses in which a loop lies flat, and in how many ways they can go on from there.

That is told from the loop equations alone, as they are written here: at such a pose their
Jacobian, by all coordinates and the drive, has one direction more than elsewhere along which
nothing gives way to first order. To second order two of all these directions are left, the
tangents of the two ways, and the drive moves along both (H. B. Keller, *Numerical solution of
bifurcation and nonlinear eigenvalue problems*, 1977).
"""

import math
import re
from collections.abc import Callable, Iterator, Sequence
from random import Random
from typing import NamedTuple

import numpy as np

from mechc.api import SolvedMechanism
from mechc.study.stroke.stroke import Stroke

Array = np.ndarray
Equations = Callable[[Array], Array]
"""The gaps of all loops in millimetres, of the coordinates of pins in order, then the drive."""

STEP = 1e-4
"""By how much coordinates are moved to see how gaps change, against the size of the mechanism."""

FLAT = 1e-5
"""A singular value below this part of the largest one is zero but for rounding."""

MOVES = 1e-5
"""The part of a tangent that is the drive's, at least, where the drive moves along it."""


POSES, APART = 6, 2e-3
"""Poses on one side of a branch point that lead to it, and how far apart they are, in radians."""


HEIGHT = 210
"""Where the fixed pin of a joined toggle is, above the origin."""


class Flat(NamedTuple):
    """A mechanism, what its pins and drive must fulfil, and where a loop lies flat.

    ``drive`` is None where that is not known from how it was made.
    """

    text: str
    pins: tuple[str, ...]
    equations: Equations
    drive: float | None


def refuted(flat: Flat, mechanism: SolvedMechanism, stroke: Stroke) -> Iterator[str]:
    """Yield the branch points that are none, and the one that is left out."""
    stated = [branch.drive for branch in stroke.branches]
    if flat.drive is not None and not any(abs(x - flat.drive) < 1e-5 for x in stated):
        yield f"no branch point at {flat.drive}"
    for drive in stated:
        pose = pose_at(mechanism, flat, drive)
        if pose is None:
            yield f"no poses lead to {drive}"
        elif (ways := ways_on(flat.equations, pose)) != 2:
            yield f"{ways} ways on at {drive}"


def pose_at(mechanism: SolvedMechanism, flat: Flat, drive: float) -> np.ndarray | None:
    """Return the coordinates to which poses on one side lead, in millimetres, and the drive."""
    for way in (APART, -APART):
        there = [drive + way * i for i in range(1, POSES + 1)]
        places = [mechanism.points(phi=at) for at in there]
        if all(status == 0 for _, status in places):
            rows = [[1000 * p[f"{c}_{q}"] for q in flat.pins for c in "xy"] for p, _ in places]
            return limit([np.array([*row, at]) for row, at in zip(rows, there, strict=True)])
    return None


def ways_on(equations: Equations, pose: Array) -> int | None:
    """Return in how many ways a drive can go on from a pose; None where no loop is flat there."""
    slopes = _slopes(equations, pose)
    left, sizes, right = np.linalg.svd(slopes)
    rank = int(np.sum(sizes > FLAT * sizes[0]))
    free, held = right[rank:], left[:, rank:]
    if len(free) == 1:
        return None
    assert len(free) == 2, "two loops lie flat at once"
    forms = np.array([[_bend(equations, pose, a, b) @ held[:, 0] for a in free] for b in free])
    tangents = [one @ free for one in _isotropic(forms)]
    return sum(abs(t[-1]) > MOVES * np.linalg.norm(t) for t in tangents)


def limit(poses: Sequence[Array]) -> Array:
    """Return where poses at equal distances lead to: the one before the first of them."""
    number = len(poses)
    weights = [(-1) ** i * math.comb(number, i + 1) for i in range(number)]
    return np.sum([w * pose for w, pose in zip(weights, poses, strict=True)], axis=0)


def _slopes(equations: Equations, pose: Array) -> Array:
    units = STEP * np.eye(len(pose))
    return np.stack([equations(pose + u) - equations(pose - u) for u in units], axis=1) / (2 * STEP)


def _bend(equations: Equations, pose: Array, a: Array, b: Array) -> Array:
    """Return the second derivative of the gaps along two directions."""
    u, v = 10 * STEP * a, 10 * STEP * b
    corners = [equations(pose + s * u + t * v) * s * t for s in (1, -1) for t in (1, -1)]
    return np.sum(corners, axis=0) / (4 * (10 * STEP) ** 2)


def _isotropic(form: Array) -> list[Array]:
    """Return the directions along which a quadratic form of two variables is zero."""
    values, vectors = np.linalg.eigh((form + form.T) / 2)
    low, high = values
    if not low < 0 < high:
        return []
    ends = (math.sqrt(high), math.sqrt(-low)), (math.sqrt(high), -math.sqrt(-low))
    return [vectors @ np.array(end) for end in ends]


# ------------------------------------------------------------------------ mechanisms


def folding(seed: int) -> Flat:
    """Return a random mechanism in which a loop lies flat within the stroke."""
    dice = Random(f"folding {seed}")
    return dice.choice((four_bar, slider_crank, dyad))(dice)


def _stroke(dice: Random, at: float) -> str:
    """Return the lines of a drive that passes a value, in degrees."""
    low, high = at - dice.randint(9, 70), at + dice.randint(9, 70)
    return f"param phi = {low + 3} deg\ndrive phi from {low} deg to {high} deg\n"


def four_bar(dice: Random) -> Flat:
    """A four-bar linkage whose longest and shortest links are together as long as the others."""
    a, d, b = dice.randint(20, 80), dice.randint(90, 160), dice.randint(60, 170)
    at, c = (180, a + d - b) if dice.random() < 0.5 else (0, b + (d - a) * dice.choice((1, -1)))
    if c < 15:
        return four_bar(dice)
    text = (
        f"{_stroke(dice, at)}pivot O at (0 mm, 0 mm)\npivot C at ({d} mm, 0 mm)\n"
        f"link OA\nlink AB\nlink CB\nOA = {a} mm @ phi\nAB = {b} mm\nCB = {c} mm\n"
        f"assembly ABC {dice.choice(('cw', 'ccw'))}\n"
        f"torque M on OA\ntorque F on CB\nfind k = M/F\n"
    )

    def equations(z: Array) -> Array:
        ax, ay, bx, by, phi = z
        return np.array(
            [
                ax - a * math.cos(phi),
                ay - a * math.sin(phi),
                math.hypot(bx - ax, by - ay) - b,
                math.hypot(bx - d, by) - c,
            ]
        )

    return Flat(text, ("A", "B"), equations, math.radians(at))


def slider_crank(dice: Random) -> Flat:
    """A crank as long as its rod, so that the slider comes to the crank's pin."""
    a, at = dice.randint(20, 90), dice.choice((90, -90))
    text = (
        f"{_stroke(dice, at)}pivot O at (0 mm, 0 mm)\nslider B along x through O\n"
        f"link OA\nlink AB\nOA = {a} mm @ phi\nAB = {a} mm\n"
        f"assembly B {dice.choice(('forward', 'back'))}\n"
        f"torque M on OA\nforce F at B along -x\nfind k = M/F\n"
    )

    def equations(z: Array) -> Array:
        ax, ay, bx, by, phi = z
        return np.array(
            [
                ax - a * math.cos(phi),
                ay - a * math.sin(phi),
                math.hypot(bx - ax, by - ay) - a,
                by,
            ]
        )

    return Flat(text, ("A", "B"), equations, math.radians(at))


def dyad(dice: Random) -> Flat:
    """A crank and two rods that are straight, or folded, where its pin is farthest or nearest."""
    a, d, b = dice.randint(20, 60), dice.randint(90, 160), dice.randint(20, 150)
    gamma = math.radians(dice.randint(-80, 80))
    x, y = round(d * math.cos(gamma), 3), round(d * math.sin(gamma), 3)
    away, at = math.hypot(x, y), math.degrees(math.atan2(y, x))
    is_far = dice.random() < 0.5
    reach = away + a if is_far else away - a
    c = reach - b if is_far and reach > b + 10 else reach + b
    if not is_far and dice.random() < 0.5 and reach > b + 10:
        c = reach - b
    if is_far and c > reach:
        return dyad(dice)
    if not is_far and c < reach:
        return dyad(dice)
    at += 180 if is_far else 0
    text = (
        f"{_stroke(dice, round(at))}pivot O at (0 mm, 0 mm)\npivot C at ({x} mm, {y} mm)\n"
        f"link OA\nlink AB\nlink CB\nOA = {a} mm @ phi\nAB = {b} mm\nCB = {c!r} mm\n"
        f"assembly ABC {dice.choice(('cw', 'ccw'))}\n"
        f"torque M on OA\nforce F at B along y\nfind k = M/F\n"
    )

    def equations(z: Array) -> Array:
        ax, ay, bx, by, phi = z
        return np.array(
            [
                ax - a * math.cos(phi),
                ay - a * math.sin(phi),
                math.hypot(bx - ax, by - ay) - b,
                math.hypot(bx - x, by - y) - c,
            ]
        )

    return Flat(text, ("A", "B"), equations, math.radians(at))


def toggle(text: str) -> Flat:
    """Return a press of :func:`other_kinds.joined`: a crank joined with a toggle of equal links."""
    found = re.search(r"at \((\d+) mm, (\d+) mm\).*AB = (\d+) mm.*l = (\d+) mm", text, re.DOTALL)
    crank = re.search(r"param r = ([\d.]+)", text)
    assert found
    assert crank
    (x, y, b, length), r = map(float, found.groups()), float(crank[1])

    def equations(z: Array) -> Array:
        ax, ay, bx, by, kx, ky, phi = z
        return np.array(
            [
                ax - x - r * math.cos(phi),
                ay - y - r * math.sin(phi),
                math.hypot(bx - ax, by - ay) - b,
                math.hypot(bx, by - HEIGHT) - length,
                math.hypot(bx - kx, by - ky) - length,
                kx,
            ]
        )

    return Flat(text, ("A", "B", "K1"), equations, None)
