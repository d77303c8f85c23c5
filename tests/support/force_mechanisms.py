"""Random mechanisms with every joint that presses and has friction, for forces and friction.

A mechanism grows from a drive by groups of no mobility. Directions are given as angles that
may be moved about, so that nothing has to be closed; or, in :func:`closed`, pivots have
places and lengths and a drive are given, and the loops close.
"""

from random import Random
from typing import NamedTuple

from friction_lines import friction_of


class Sample(NamedTuple):
    """A description, and its places where loops have to be closed for them."""

    text: str
    drive: str
    given: str
    asked: tuple[str, ...]
    places: dict[str, tuple[float, float]] | None = None

    def finding(self, *more: str) -> str:
        """Return the description with all forces at joints asked for, and more lines."""
        finds = (f"find {a}" for a in self.asked)
        return "\n".join([self.text, *finds, *more, ""])

    def with_friction(self, dice: Random, *more: str, said: bool = True) -> str:
        """Return the description with friction everywhere, ``q`` times as much as it says."""
        friction = friction_of(self.text, dice, said)
        return "\n".join([self.text, "param q = 1", *friction, *more, ""])


class Growing:
    """A mechanism while it grows: the lines of its description, and what can be built on."""

    def __init__(self, dice: Random) -> None:
        self.dice = dice
        self.lines: list[str] = []
        self.pins: list[str] = []  # moving points, the latest last
        self.rods: list[str] = []
        self.held: list[str] = []  # by the ground
        self.touching: list[str] = []
        self.sliders: dict[str, str] = {}
        self.on: list[str] = []  # forces on links at pins
        self.drive = ""
        self.turning: list[str] = []
        self._points = (f"{c}{n}" for n in ("", *range(1, 9)) for c in "ABCDEGHIJKLSUXYZ")
        self._symbols = iter(range(1, 99))

    # -------------------------------------------------------------------- writing

    def point(self) -> str:
        return next(self._points)

    def pivot(self) -> str:
        self.lines.append(f"pivot {(name := self.point())}")
        self.held.append(name)
        return name

    def angle(self, spread: float = 40) -> str:
        """Declare an angle that may be moved about."""
        name, value = f"t{next(self._symbols)}", round(self.dice.uniform(-180, 180), 1)
        ends = f"{value - spread:.1f} deg .. {value + spread:.1f} deg"
        self.lines.append(f"param {name} = {value} deg in {ends}")
        return name

    def vector(self, tail: str, head: str, angle: str = "") -> None:
        length = f"{self.dice.uniform(40, 160):.1f} mm"
        self.lines.append(f"{tail}{head} = {length} @ {angle or self.angle()}")

    def link(self, *points: str) -> str:
        """Add a body with its vectors from the first point."""
        name = "".join(points)
        self.lines.append(f"link {name}")
        for head in points[1:]:
            self.vector(points[0], head)
        if len(points) == 2:
            self.rods.append(name)
        self.on += [f"{p} on {name}" for p in points]
        return name

    def any_pin(self) -> str:
        """Return a moving point, the latest most often."""
        return self.pins[-1] if self.dice.random() < 0.6 else self.dice.choice(self.pins)

    # -------------------------------------------------------------------- growing

    def crank(self) -> None:
        pivot, pin = self.pivot(), self.point()
        more = (self.point(),) if self.dice.random() < 0.4 else ()
        body = self.link(pivot, pin, *more)
        self.turning.append(body)
        if self.dice.random() < 0.4:
            self.drive = f"torque P on {body}"
        elif self.dice.random() < 0.2:
            base = self.pivot()
            self.vector(base, pin)
            self.drive = f"actuator P between {base} and {pin}"
        else:
            self.drive = f"force P at {pin} along {self.angle()}"
        self.pins += [pin, *more]

    def slider(self) -> None:
        point, along = self.point(), self.angle()
        self.lines.append(f"slider {point} along {along}")
        self.sliders[point] = along
        self.drive = f"force P at {point} along {along}"
        self.pins.append(point)

    def dyad(self) -> None:
        """RRR: a rod, and a rocker of two or three points."""
        start, pin, pivot = self.any_pin(), self.point(), self.pivot()
        more = (self.point(),) if self.dice.random() < 0.5 else ()
        self.link(start, pin, *((self.point(),) if self.dice.random() < 0.2 else ()))
        self.turning.append(self.link(pivot, pin, *more))
        self.pins += [pin, *more]

    def rod_and_slider(self) -> None:
        start, pin, along = self.any_pin(), self.point(), self.angle()
        more = (self.point(),) if self.dice.random() < 0.3 else ()
        self.lines.append(f"slider {pin} along {along}")
        self.link(start, pin, *more)
        self.sliders[pin] = along
        self.pins += [*more, pin]

    def triad(self) -> None:
        """A ternary link held by a rod on a pin and two rods on the ground."""
        start, pins = self.any_pin(), [self.point() for _ in range(3)]
        self.link(start, pins[0])
        self.link(self.pivot(), pins[1])
        self.link(self.pivot(), pins[2])
        self.link(*pins)
        self.pins += pins

    def slot(self) -> None:
        """A lever with a slot that a pin leads."""
        pin, pivot, out, far = self.any_pin(), self.pivot(), self.point(), self.point()
        if pin in self.touching:
            return
        name = f"{pivot}{out}{far}"
        self.lines += [f"link {name}", f"slot {pin} in {pivot}{out}"]
        self.vector(pivot, pin)
        self.vector(pivot, far)
        self.touching.append(pin)
        self.turning.append(name)
        self.pins.append(far)

    def cam(self) -> None:
        """A lever on which a pin presses, anywhere and along any normal."""
        pin, pivot, far = self.any_pin(), self.pivot(), self.point()
        if pin in self.touching:
            return
        self.lines.append(f"contact {pin} on {pivot}{far} normal {self.angle()}")
        self.turning.append(self.link(pivot, far))
        self.rods.pop()
        self.on[-2:] = []
        self.vector(pivot, pin)
        self.touching.append(pin)
        self.pins.append(far)

    def wedge(self) -> None:
        """A body that only translates, pushed by a pin."""
        pin, near, far, along = self.any_pin(), self.point(), self.point(), self.angle()
        if pin in self.touching:
            return
        self.lines.append(f"slide {near}{far} along {along}")
        self.lines.append(f"contact {pin} on {near}{far} normal {self.angle()}")
        self.touching.append(pin)
        self.pins.append(far)

    # ---------------------------------------------------------------------- loads

    def load(self, ratio: bool) -> str:
        """Put the loads on, and return the sizes of those that are given."""
        dice = self.dice
        times = dice.choice(["", "", "", " times 2", " times 1/2"])
        self.lines.append(self.drive + times)
        last = self.pins[-1]
        along = self.sliders.get(last) if dice.random() < 0.5 else None
        self.lines.append(f"force F at {last} along {along or self.angle()}")
        if dice.random() < 0.3:
            part = dice.choice(
                ["0.3*F", "-0.2*F", *(["0.5*P"] if "torque" not in self.drive else [])]
            )
            at = dice.choice(self.pins)
            self.lines.append(f"force T = {part} at {at} along {self.angle()}")
        if dice.random() < 0.2 and self.turning:
            self.lines += ["param e = 0.05 m", f"torque M = e*F on {dice.choice(self.turning)}"]
        if ratio:
            self.lines.append("find k = P / F")
            return "F"
        self.lines.append(f"weight W mass 2 kg at {dice.choice(self.pins)}")
        self.lines.append("gravity along 20 deg" if dice.random() < 0.5 else "gravity along -y")
        self.lines.append("find P")
        return "F W"

    def multiply(self) -> None:
        """Make it one half of a mirror, or one of some copies, around a guide."""
        if not self.sliders or self.dice.random() > 0.35:
            return
        shared, along = self.dice.choice(list(self.sliders.items()))
        what = self.dice.choice([f"mirror across {along}", f"mirror across {along}", "copies 3"])
        self.lines.append(f"{what} sharing {shared}")
        self.lines = [_turned(line, shared, along) for line in self.lines]
        self.lines = [f"gravity along {along}" if "gravity" in x else x for x in self.lines]

    def asked(self) -> tuple[str, ...]:
        """Return the forces at all joints."""
        often = [p for name in self.on for p in [name.split()[0]]]
        grounded = {*self.held, *self.sliders, *self.touching}
        pins = [n for n in self.on if often.count(n.split()[0]) > 1 or n.split()[0] in grounded]
        across = {*self.sliders, *self.touching}
        shared = "\n".join(x for x in self.lines if "sharing" in x).split()
        ground = [p for p in dict.fromkeys([*self.held, *self.sliders]) if p not in shared]
        across = {p for p in across if p not in shared}
        return (
            *(f"R_{p}" for p in ground),
            *(f"R_{n}" for n in pins),
            *(f"N_{r}" for r in self.rods),
            *(f"N_{p}" for p in sorted(across)),
        )


def _turned(line: str, shared: str, along: str) -> str:
    """Let a force on a point that all share act along its guide."""
    words = line.split()
    if words[0] == "force" and words[words.index("at") + 1] == shared:
        words[words.index("along") + 1] = along
    return " ".join(words)


def given(seed: int, groups: int | None = None, ratio: bool = True) -> Sample:
    """Return a random mechanism whose pose is given by angles."""
    dice = Random(seed)
    growing = Growing(dice)
    dice.choice([growing.crank, growing.crank, growing.slider])()
    ways = [growing.dyad, growing.dyad, growing.rod_and_slider, growing.rod_and_slider]
    ways += [growing.triad, growing.slot, growing.cam, growing.wedge]
    for _ in range(dice.choice([1, 1, 2, 2, 3]) if groups is None else groups):
        dice.choice(ways)()
    sizes = growing.load(ratio)
    growing.multiply()
    return Sample("\n".join(growing.lines), "P", sizes, growing.asked())
