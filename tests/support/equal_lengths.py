"""Four-bars whose lengths are equal by number: parallelograms, straight or crossed, and others.

Their ranges may pass poses in which all sides lie flat, where angles of the loop vanish together.
"""

import math
from random import Random

FRAMES = ((300, 400), (120, 50), (-90, 120), (0, 200), (200, 0), (60, 80), (160, 120), (-80, -60))
LENGTHS = (100, 130, 150, 200)
STARTS = (0, 30, 45, 60, 90, 120, -30)


def four_bar(seed: int) -> str:
    """Return a description; the slider, the cylinder and friction are there by chance."""
    rng = Random(seed)
    start, (x, y) = rng.choice((*STARTS, rng.randrange(-170, 170))), rng.choice(FRAMES)
    crank, coupler, rocker = _sides(rng, round(math.hypot(x, y)))
    lines = [
        f"param phi = {start} deg{_range(rng, start)}",
        "pivot O at (0 mm, 0 mm)",
        f"pivot Q at ({x} mm, {y} mm)",
        "link OA\nlink QBD\nlink AB",
        f"OA = {crank} mm @ phi",
        f"AB = {coupler} mm",
        f"QB = {rocker} mm",
        f"QD = {rng.choice(LENGTHS)} mm @ {rng.choice(('QB', '-QB'))}",
        f"assembly ABQ {rng.choice(('cw', 'ccw'))}",
        *(["drive phi"] if rng.random() < 0.5 else []),
        *_load(rng),
        *(["friction pins 0.1 diameter 10 mm"] if rng.random() < 0.3 else []),
    ]
    if rng.random() < 0.3:
        across = rng.choice(("A and Q", "O and B"))
        lines += [f"actuator N between {across}", "find k = N/F"]
    else:
        lines += ["torque M on OA", "find k = M/F"]
    return "\n".join(lines) + "\n"


def _sides(rng: Random, frame: int) -> tuple[int, int, int]:
    """Return crank, coupler and rocker: of a parallelogram, with equal neighbours, or any.

    None is a kite: folded, its pins lie on one another, and what is between them has no direction.
    """
    a, b, c = (rng.choice(LENGTHS) for _ in range(3))
    return rng.choice(((a, frame, a), (a, frame, a), (a, a, c), (a, b, b)))


def _range(rng: Random, start: int) -> str:
    low, high = start - rng.choice((5, 40)), start + rng.choice((5, 60))
    return f" in {low} deg .. {high} deg" if rng.random() < 0.6 else ""


def _load(rng: Random) -> list[str]:
    """Return a load at the rocker's end, or at a slider that a rod moves."""
    if rng.random() < 0.4:
        return [f"force F at D along {rng.choice((0, 90, 30, -45, 180))} deg"]
    axis, start = rng.choice("xy"), rng.choice("OQ")
    return [
        "link DS",
        f"slider S along {axis} through {start}",
        f"DS = {rng.choice((*LENGTHS, 300, 400))} mm",
        f"assembly S {rng.choice(('forward', 'back'))}",
        f"force F at S along {axis}",
    ]
