"""Random mechanisms with their pose given, whose angles are multiples of one another.

A chain leads from the drive to the load: rods between guides, levers, ternary links. All
directions are multiples of one or two angles plus constants on a grid, so that sines
share zeros, and the ranges are wide enough to hold several of them.
"""

from random import Random

MULTIPLES = ("", "", "", "2*", "3*", "4*", "1/2*", "-", "-2*", "-1/2*")
GRIDS = (1, 5, 7.5, 15, 22.5, 30, 45, 90)


class Chain:
    """A random chain: ``text`` is its description; with ``equal`` lengths some are the same."""

    def __init__(self, seed: int, equal: bool = False) -> None:
        self.equal = equal
        self.dice = Random(f"chain {seed}")
        self.grid = self.dice.choice(GRIDS)
        self.names = ["t", "u"] if self.dice.random() < 0.3 else ["t"]
        self.params: list[str] = []
        self.lines: list[str] = []
        self.points = 0
        for name in self.names:
            low = self.dice.uniform(-180, 180)
            wide = self.dice.choice((5, 40, 120, 300))
            value = low + wide * self.dice.uniform(0.3, 0.7)
            self.params.append(
                f"param {name} = {value:.4f} deg in {low:.3f} deg .. {low + wide:.3f} deg"
            )
        here = self.start()
        for _ in range(self.dice.choice((1, 1, 2, 2, 3, 4))):
            here = self.dice.choice((self.rod, self.rod, self.lever, self.plate))(here)
        self.lines.append(f"force F at {here} along {self.load}")

    @property
    def text(self) -> str:
        return "\n".join([*self.params, *self.lines, "find k = P/F"])

    def point(self) -> str:
        self.points += 1
        return f"A{self.points}"

    def length(self) -> str:
        name = f"l{len(self.params)}"
        value = self.dice.choice((50, 80, 100)) if self.equal else self.dice.randint(40, 140)
        span = f" in {value - 20} mm .. {value + 40} mm" if self.dice.random() < 0.5 else ""
        self.params.append(f"param {name} = {value} mm{span}")
        return name

    def angle(self) -> str:
        constant = self.grid * self.dice.randrange(int(360 / self.grid))
        if self.dice.random() < 0.25:
            return f"{constant} deg"
        symbol = self.dice.choice(MULTIPLES) + self.dice.choice(self.names)
        return f"{symbol} + {constant} deg" if self.dice.random() < 0.6 else symbol

    def start(self) -> str:
        here = self.point()
        if self.dice.random() < 0.6:
            along = self.angle()
            self.lines += [f"slider {here} along {along}", f"force P at {here} along {along}"]
        else:
            pivot = self.point()
            self.lines += [
                f"pivot {pivot}",
                f"link {pivot}{here}",
                f"{pivot}{here} = {self.length()} @ {self.angle()}",
                f"torque P on {pivot}{here}",
            ]
        return here

    def rod(self, here: str) -> str:
        """Hang a slider on a point by a rod."""
        there, self.load = self.point(), self.angle()
        self.lines += [f"link {here}{there}", f"slider {there} along {self.load}"]
        self.lines.append(f"{here}{there} = @ {self.angle()}")
        if self.dice.random() < 0.3:
            self.load = self.angle()
        return there

    def lever(self, here: str) -> str:
        """Hang a lever on a point by a rod; the chain goes on from its other arm."""
        near, pivot, far = self.point(), self.point(), self.point()
        self.lines += [
            f"link {here}{near}",
            f"{here}{near} = @ {self.angle()}",
            f"pivot {pivot}",
            f"link {near}{pivot}{far}",
            f"{pivot}{near} = {self.length()} @ {self.angle()}",
            f"{pivot}{far} = {self.length()} @ {self.angle()}",
        ]
        self.load = self.angle()
        return far

    def plate(self, here: str) -> str:
        """Let a ternary link slide at one corner; a rod on the other one drives a slider."""
        guided, corner = self.point(), self.point()
        self.lines += [
            f"link {here}{guided}{corner}",
            f"slider {guided} along {self.angle()}",
            f"{here}{guided} = {self.length()} @ {self.angle()}",
            f"{here}{corner} = {self.length()} @ {self.angle()}",
        ]
        return self.rod(corner)
