"""Closed loops whose sides share parameters: isosceles sliders, kites, crossed and geared bars.

Equal by name, their triangles are isosceles or congruent in every pose: formulas fall together
there, and so do zeros, poles and closures.
"""

from random import Random

AXES = ("x", "y", "-x", "30 deg")


def shared(seed: int) -> str:
    """Return a description; its ranges, its load and its friction are there by chance."""
    rng = Random(seed)
    family = rng.choice((_slider, _four_bar, _slotted, _geared, _scott_russell, _six_bar))
    # how gears press on their pivots would have to be given; nothing loads the pivot of QC
    may_have_friction = family not in (_geared, _slider)
    start = rng.choice((30, 45, 60, 90, 120, rng.randrange(5, 175)))
    lines = [
        f"param a = {rng.choice((40, 50, 60))} mm{_in(rng, 30, 80, 'mm')}",
        f"param b = {rng.choice((90, 100, 130))} mm{_in(rng, 85, 150, 'mm')}",
        f"param phi = {start} deg",
        f"drive phi from {start - rng.choice((5, 40))} deg to {start + rng.choice((5, 60))} deg",
        *family(rng),
        *(
            ["friction pins 0.1 diameter 10 mm"]
            if may_have_friction and rng.random() < 0.25
            else []
        ),
    ]
    return "\n".join(lines) + "\n"


def _in(rng: Random, low: float, high: float, unit: str) -> str:
    return f" in {low} {unit} .. {high} {unit}" if rng.random() < 0.3 else ""


def _side(rng: Random) -> str:
    return rng.choice(("a", "a", "b"))


def _asked(rng: Random, load: str) -> list[str]:
    return [f"force F at {load} along {rng.choice(AXES)}", "torque M on OA", "find k = M/F"]


def _slider(rng: Random) -> list[str]:
    place = rng.choice(("(0 mm, 0 mm)", "(0 mm, a)", "(a, 0 mm)", "(0 mm, b - a)"))
    return [
        "pivot O at (0 mm, 0 mm)",
        "pivot Q at " + place,
        "link OA\nlink AB\nlink QC",
        "OA = a @ phi",
        f"AB = {_side(rng)}",
        "QC = a @ phi",
        f"slider B along {rng.choice(AXES)} through Q",
        f"assembly B {rng.choice(('forward', 'back'))}",
        *_asked(rng, "B"),
    ]


def _four_bar(rng: Random) -> list[str]:
    place = rng.choice(("(a, 0 mm)", "(b, 0 mm)", "(a, b)", "(0 mm, -b)", "(2*a, 0 mm)"))
    return [
        "pivot O at (0 mm, 0 mm)",
        f"pivot Q at {place}",
        "link OA\nlink AB\nlink QB",
        "OA = a @ phi",
        f"AB = {_side(rng)}",
        f"QB = {_side(rng)}",
        f"assembly ABQ {rng.choice(('cw', 'ccw'))}",
        *rng.choice((["torque F on QB", "torque M on OA", "find k = M/F"], _asked(rng, "B"))),
    ]


def _slotted(rng: Random) -> list[str]:
    place = rng.choice(("(a, 0 mm)", "(-a, 0 mm)", "(b, 0 mm)", "(0 mm, -b)"))
    return [
        "pivot O at (0 mm, 0 mm)",
        f"pivot Q at {place}",
        "link OA\nlink QSD",
        "OA = a @ phi",
        "slot A in QS",
        f"QD = {_side(rng)} @ QS",
        f"assembly A {rng.choice(('forward', 'back'))}",
        *_asked(rng, "D"),
    ]


def _geared(rng: Random) -> list[str]:
    sense = rng.choice(("180 deg - phi", "phi", "-phi", "90 deg - phi"))
    mesh = "gear O r, Q r" if "-" in sense else "belt O r, Q r"
    side = _side(rng)
    return [
        "param r = 12 mm",
        "pivot O at (0 mm, 0 mm)",
        f"pivot Q at {rng.choice(('(2*r, 0 mm)', '(2*r, 0 mm)', '(0 mm, 2*r)'))}".replace(
            "2*r", "2*r" if "gear" in mesh else "5*r"
        ),
        "link OA\nlink QD\nlink AB\nlink DB",
        "OA = a @ phi",
        f"QD = {_side(rng)} @ {sense}",
        f"AB = {side}",
        f"DB = {side}",
        mesh,
        f"assembly ABD {rng.choice(('cw', 'ccw'))}",
        *_asked(rng, "B"),
    ]


def _scott_russell(rng: Random) -> list[str]:
    return [
        "pivot O at (0 mm, 0 mm)",
        "link OA\nlink BAC",
        "OA = a @ phi",
        "AB = a",
        f"AC = {_side(rng)} @ BA",
        f"slider B along {rng.choice(('x', 'y'))} through O",
        "assembly B forward",
        *_asked(rng, "C"),
    ]


def _six_bar(rng: Random) -> list[str]:
    place = rng.choice(("(a, 0 mm)", "(b, 0 mm)", "(0 mm, -b)"))
    return [
        "pivot O at (0 mm, 0 mm)",
        f"pivot Q at {place}",
        "link OA\nlink AB\nlink QBD\nlink DS",
        "OA = a @ phi",
        f"AB = {_side(rng)}",
        f"QB = {_side(rng)}",
        f"QD = {_side(rng)} @ {rng.choice(('QB', '-QB', 'perp QB'))}",
        f"DS = {_side(rng)}",
        f"slider S along {rng.choice(AXES)} through {rng.choice('OQ')}",
        f"assembly ABQ {rng.choice(('cw', 'ccw'))}",
        f"assembly S {rng.choice(('forward', 'back'))}",
        *_asked(rng, "S"),
    ]
