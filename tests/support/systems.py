"""Systems made by hand, in formulas and once more in plain floats."""

import math
import random
from typing import NamedTuple

from mechc.formula.tree import Call, Formula, Symbol, System, negative, product, total

TRIAD_UNKNOWNS = ("theta", "beta", "gamma", "delta")


def s(name: str) -> Symbol:
    return Symbol(name)


def cos(x: Formula) -> Call:
    return Call("cos", (x,))


def sin(x: Formula) -> Call:
    return Call("sin", (x,))


def times(*factors: Formula) -> Formula:
    return product((f, 1) for f in factors)


class Triad(NamedTuple):
    """A ternary link on three rods; one hangs on the crank r@phi, two on fixed pins.

    The link is at ``theta``, the rods at ``beta`` (from the crank's pin to the link),
    ``gamma`` and ``delta`` (from the fixed pins to the link).
    """

    values: dict[str, float]
    start: tuple[float, ...]

    def system(self) -> System:
        """Return the two closed loops, along x and y each."""
        loops = (("d", s("theta"), "c", s("gamma"), "2"), ("e", turned(), "h", s("delta"), "3"))
        equations = tuple(loop(*one, axis) for one in loops for axis in "xy")
        return System(TRIAD_UNKNOWNS, equations, tuple(self.values.items()), self.start)

    def residuals(self, unknowns: tuple[float, ...], **changes: float) -> list[float]:
        """Return the gap of the loops, as complex numbers give it."""
        v = self.values | changes
        theta, beta, gamma, delta = unknowns
        pin = v["r"] * turn(v["phi"]) + v["b"] * turn(beta)
        first = pin + v["d"] * turn(theta) - v["c"] * turn(gamma) - complex(v["x2"], v["y2"])
        second = (
            pin
            + v["e"] * turn(theta + v["epsilon"])
            - v["h"] * turn(delta)
            - complex(v["x3"], v["y3"])
        )
        return [first.real, first.imag, second.real, second.imag]


def turn(angle: float) -> complex:
    return complex(math.cos(angle), math.sin(angle))


def turned() -> Formula:
    return total([s("theta"), s("epsilon")])


def loop(arm: str, at: Formula, rod: str, rod_at: Formula, pin: str, axis: str) -> Formula:
    along = cos if axis == "x" else sin
    return total(
        [
            times(s("r"), along(s("phi"))),
            times(s("b"), along(s("beta"))),
            times(s(arm), along(at)),
            negative(times(s(rod), along(rod_at))),
            negative(s(axis + pin)),
        ]
    )


def triad(seed: int = 27) -> Triad:
    """Return a triad of random lengths, in a pose drawn at random and closed by its fixed pins."""
    draw = random.Random(seed)
    v = {"phi": draw.uniform(0, 6), "r": draw.uniform(0.1, 0.4), "epsilon": draw.uniform(0.5, 1.5)}
    v |= {name: draw.uniform(0.5, 1.5) for name in ("b", "c", "h", "d", "e")}
    start = tuple(draw.uniform(-3, 3) for _ in range(4))
    open_ = Triad(v | dict.fromkeys(("x2", "y2", "x3", "y3"), 0.0), start)
    gaps = dict(zip(("x2", "y2", "x3", "y3"), open_.residuals(start), strict=True))
    return Triad(v | gaps, start)
