"""Random planar mechanisms with their pose given, and k by a third method.

A mechanism grows from cranks and sliders by groups of no mobility: dyads with two rods
(RRR), with a rod and a slider (RRP), and triads of a ternary link held by three rods,
which have to be solved as one block. Points are put at random places and every vector is
then written from them. A rod whose length would be one too many for a loop that does not
pass through the ground is described by its direction alone.

The expected k comes from neither virtual power on a graph nor equilibrium: the velocities
of all points and the angular velocities of all bodies are the null space of the rigid-body
constraints, found by singular values, and the loads' work on it must vanish.
"""

import math
from dataclasses import dataclass, field, replace
from itertools import combinations
from random import Random

import numpy as np


@dataclass(frozen=True)
class Sample:
    """A description, its k, and the condition of the velocity constraints."""

    linkage: "Linkage"
    k: float
    condition: float

    @property
    def text(self) -> str:
        return self.linkage.text()


@dataclass(frozen=True)
class Style:
    """How a linkage is written down: by which choices, turned and scaled by what."""

    choices: int = 0
    turn: str = ""
    scale: str = ""
    find: str = "find k = P / F"

    def angle(self, degrees: float) -> str:
        return f"{degrees!r} deg" + (f" + {self.turn}" if self.turn else "")


@dataclass(frozen=True)
class Bar:
    """A body: its points in order, and whether its (only) length stays open."""

    points: tuple[str, ...]
    open: bool = False

    @property
    def name(self) -> str:
        return "".join(self.points)


@dataclass(frozen=True)
class Load:
    """A force on a point, or a torque on a bar; ``part`` is its size per unit of ``of``."""

    name: str
    at: str
    angle: float | None
    times: str = ""
    of: str = ""
    part: float = 1.0

    @property
    def factor(self) -> float:
        top, _, bottom = self.times.partition("/")
        return float(top or 1) / float(bottom or 1)


@dataclass
class Linkage:
    """A linkage while it grows."""

    dice: Random
    places: dict[str, tuple[float, float]] = field(default_factory=dict)
    bars: list[Bar] = field(default_factory=list)
    pivots: list[str] = field(default_factory=list)
    guides: dict[str, float] = field(default_factory=dict)
    loads: list[Load] = field(default_factory=list)
    drivers: list[Load] = field(default_factory=list)
    symmetry: tuple[str, str, str] | None = None

    # -------------------------------------------------------------------- growth

    def point(self) -> str:
        """Add a point somewhere, not too near to any other, and return its name."""
        number = len(self.places)
        name = "ABCDEGHIJKLMNOQRSTUVWXYZ"[number % 24] + (str(number // 24) if number > 23 else "")
        while True:
            place = self.dice.uniform(-1, 1), self.dice.uniform(-1, 1)
            if all(math.dist(place, other) > 0.15 for other in self.places.values()):
                self.places[name] = place
                return name

    def pivot(self) -> str:
        self.pivots.append(name := self.point())
        return name

    def base(self, number: int) -> list[str]:
        """Return distinct points to hang a group on: old ones, or new pivots."""
        old = self.dice.sample(list(self.places), min(number, len(self.places)))
        return [p if self.dice.random() < 0.6 else self.pivot() for p in old] + [
            self.pivot() for _ in range(number - len(old))
        ]

    def crank(self) -> None:
        pivot, pin = self.pivot(), self.point()
        more = (self.point(),) if self.dice.random() < 0.4 else ()
        self.bars.append(bar := Bar((pivot, pin, *more)))
        if self.dice.random() < 0.4:
            self.drivers.append(Load("P", bar.name, None))
        else:
            self.drivers.append(Load("P", pin, self.angle()))

    def slider(self) -> None:
        point = self.point()
        self.guides[point] = self.angle()
        along = self.guides[point] if self.dice.random() < 0.6 else self.angle()
        self.drivers.append(Load("P", point, along))

    def angle(self) -> float:
        """Return a direction in degrees, often a round one."""
        if self.dice.random() < 0.5:
            return float(self.dice.choice([0, 90, 180, 30, -45, 120, 75]))
        return self.dice.uniform(-180, 180)

    def dyad(self) -> None:
        """Hang two bars on two points."""
        first, second = self.base(2)
        loop = self.connected(first, second)
        pin = self.point()
        for end in (first, second):
            ternary = not loop and self.dice.random() < 0.35
            more = (self.point(),) if ternary else ()
            self.bars.append(Bar((end, pin, *more), open=loop))

    def rod_and_slider(self) -> None:
        (end,) = self.base(1)
        pin = self.point()
        self.guides[pin] = self.angle()
        more = (self.point(),) if self.dice.random() < 0.3 else ()
        self.bars.append(Bar((end, pin, *more)))

    def triad(self) -> None:
        """Hold a ternary link by three rods, of which at most two close a loop."""
        ends = self.base(3)
        loops = [pair for pair in combinations(ends, 2) if self.connected(*pair)]
        if len(loops) > 1:
            ends[-1] = self.pivot()
            loops = [pair for pair in loops if set(pair) <= set(ends)]
        pins = [self.point() for _ in range(3)]
        for end, pin in zip(ends, pins, strict=True):
            self.bars.append(Bar((end, pin), open=any(end in pair for pair in loops)))
        self.bars.append(Bar(tuple(pins)))

    def connected(self, first: str, second: str) -> bool:
        """Return whether two points hang together without the ground."""
        return second in _component(self.bars, first)

    # --------------------------------------------------------------------- loads

    def load(self) -> None:
        """Put the drives and the output on, with ties and multiples."""
        free = [p for p in self.places if p not in self.pivots]
        twisted = [bar.name for bar in self.bars[-2:] if not bar.open]
        if twisted and self.dice.random() < 0.25:
            output = Load("F", self.dice.choice(twisted), None, self.times())
        else:
            output = Load("F", self.dice.choice(free[-4:]), self.angle(), self.times())
        names = iter(("P", "Q"))
        drives = [Load(next(names), d.at, d.angle, self.times()) for d in self.drivers]
        self.loads = [*drives, output]
        if self.dice.random() < 0.3 and output.angle is not None:
            part = self.dice.choice([0.3, -0.2, 1.5])
            self.loads.append(Load("T", self.dice.choice(free), self.angle(), "", "F", part))

    def times(self) -> str:
        return self.dice.choice(["", "", "", "2", "3", "1/2"])

    def multiply(self) -> None:
        """Make it one half of a mirror, or one of some copies, around a guide.

        A load on a point that all share acts along its guide.
        """
        if not self.guides or self.dice.random() > 0.35:
            return
        shared = self.dice.choice(list(self.guides))
        if self.dice.random() < 0.5:
            self.symmetry = ("mirror", shared, "")
        else:
            self.symmetry = ("copies", shared, self.dice.choice(["2", "3", "5"]))
        along = self.guides[shared]
        self.loads = [
            replace(load, angle=along) if load.at == shared else load for load in self.loads
        ]

    def count(self, at: str) -> float:
        """Return how often a load there does its work."""
        if self.symmetry is None or self.symmetry[1] == at:
            return 1.0
        return float(self.symmetry[2] or 2)

    # ------------------------------------------------------------------ variants

    def relabelled(self, seed: int) -> "Linkage":
        """Return the same linkage with the names of its points exchanged."""
        new = list(self.places)
        Random(seed).shuffle(new)
        name = dict(zip(self.places, new, strict=True))
        bars = [Bar(tuple(name[p] for p in bar.points), bar.open) for bar in self.bars]
        name.update({old.name: bar.name for old, bar in zip(self.bars, bars, strict=True)})
        symmetry = self.symmetry
        return replace(
            self,
            places={name[p]: place for p, place in self.places.items()},
            bars=bars,
            pivots=[name[p] for p in self.pivots],
            guides={name[p]: angle for p, angle in self.guides.items()},
            loads=[replace(load, at=name[load.at]) for load in self.loads],
            symmetry=symmetry and (symmetry[0], name[symmetry[1]], symmetry[2]),
        )

    def untied(self) -> "Linkage":
        """Return the linkage without the loads that are tied to others."""
        return replace(self, loads=[load for load in self.loads if not load.of])

    def with_the_output_twice(self) -> "Linkage":
        """Return the linkage with a load G where F is."""
        doubled = [replace(load, name="G") for load in self.loads if load.name == "F"]
        return replace(self, loads=self.loads + doubled)

    # ---------------------------------------------------------------------- text

    def text(self, style: Style = Style()) -> str:
        """Return the description in the language."""
        writer = Writer(style)
        for bar in self.bars:
            self._vectors(bar, writer)
        lines = [*writer.parameters, *(f"pivot {p}" for p in self.pivots)]
        lines += [f"slider {p} along {style.angle(a)}" for p, a in self.guides.items()]
        lines += [f"link {bar.name}" for bar in self.bars]
        lines += writer.vectors + self._symmetry(style)
        lines += [_load_text(load, style) for load in self.loads]
        return "\n".join(["mechanism random", *lines, style.find, ""])

    def _symmetry(self, style: Style) -> list[str]:
        if self.symmetry is None:
            return []
        kind, shared, number = self.symmetry
        if kind == "mirror":
            return [f"mirror across {style.angle(self.guides[shared])} sharing {shared}"]
        return [f"copies {number} sharing {shared}"]

    def _vectors(self, bar: Bar, writer: "Writer") -> None:
        tail, *heads = bar.points
        needed = len(heads) > 1 or self._in_a_loop(bar) or bar.name in {x.at for x in self.loads}
        idle = not needed and writer.dice.random() < 0.5
        for head in heads:
            (x0, y0), (x1, y1) = self.places[tail], self.places[head]
            writer.vector(tail + head, x1 - x0, y1 - y0, bar.open or idle)

    def _in_a_loop(self, bar: Bar) -> bool:
        """Return whether the bar's ends hang together without it and without the ground."""
        others = [b for b in self.bars if b is not bar]
        return bar.points[1] in _component(others, bar.points[0])

    # --------------------------------------------------------------- third method

    def constraints(self) -> np.ndarray:
        """Return the rigid-body constraints on the points' velocities and bodies' turning."""
        index = {p: 2 * i for i, p in enumerate(self.places)}
        width = 2 * len(self.places) + len(self.bars)
        rows = []
        for i, bar in enumerate(self.bars):
            tail, *heads = bar.points
            for head in heads:
                x, y = np.subtract(self.places[head], self.places[tail])
                for axis, lever in ((0, -y), (1, x)):
                    row = np.zeros(width)
                    row[index[head] + axis], row[index[tail] + axis] = 1, -1
                    row[2 * len(self.places) + i] = -lever
                    rows.append(row)
        for point in self.pivots:
            rows += [np.eye(1, width, index[point] + axis)[0] for axis in (0, 1)]
        for point, angle in self.guides.items():
            row = np.zeros(width)
            row[index[point]] = -math.sin(math.radians(angle))
            row[index[point] + 1] = math.cos(math.radians(angle))
            rows.append(row)
        return np.array(rows)

    def work(self, load: Load) -> np.ndarray:
        """Return the work of one unit of a load per velocity."""
        row = np.zeros(2 * len(self.places) + len(self.bars))
        size = load.factor * load.part * self.count(load.at)
        if load.angle is None:
            number = [bar.name for bar in self.bars].index(load.at)
            row[2 * len(self.places) + number] = size
        else:
            at = 2 * list(self.places).index(load.at)
            row[at] = size * math.cos(math.radians(load.angle))
            row[at + 1] = size * math.sin(math.radians(load.angle))
        return row

    def solve(self) -> tuple[float, float] | None:
        """Return k and the condition, None where the linkage is near singular or k extreme."""
        matrix = self.constraints()
        mobility = len(self.drivers)
        _, sizes, modes = np.linalg.svd(matrix)
        rank = matrix.shape[1] - mobility
        if rank > len(sizes) or sizes[rank - 1] < 1e-3 * sizes[0] or np.any(sizes[rank:] > 1e-9):
            return None
        motion = modes[rank:].T
        unknown = np.array([self.work(x) @ motion for x in self.loads if x.name in "PQ"]).T
        known = sum(self.work(x) @ motion for x in self.loads if x.name in "FT")
        if np.linalg.svd(unknown, compute_uv=False)[-1] < 1e-3:
            return None
        k = float(np.linalg.solve(unknown, -known)[0])
        return (k, float(sizes[0] / sizes[rank - 1])) if 1e-3 < abs(k) < 1e3 else None


class Writer:
    """Writes vectors, and declares the parameters that they need."""

    def __init__(self, style: Style) -> None:
        self.style, self.dice = style, Random(style.choices)
        self.parameters: list[str] = []
        self.vectors: list[str] = []
        if style.turn:
            self.parameters.append(f"param {style.turn} = 10 deg")
        if style.scale:
            self.parameters.append(f"param {style.scale} = 3")

    def vector(self, name: str, x: float, y: float, open_length: bool) -> None:
        cartesian = self.dice.random() < 0.15 and not (self.style.turn or open_length)
        write = self._cartesian if cartesian else self._polar
        write(name, x, y, open_length)

    def _length(self, name: str, value: float) -> str:
        self.parameters.append(f"param {name} = {value!r} m")
        return f"{self.style.scale}*{name}" if self.style.scale else name

    def _cartesian(self, name: str, x: float, y: float, _: bool) -> None:
        number = len(self.vectors) + 1
        pair = self._length(f"x{number}", x), self._length(f"y{number}", y)
        self.vectors.append(f"{name} = ({', '.join(pair)})")

    def _polar(self, name: str, x: float, y: float, open_length: bool) -> None:
        number = len(self.vectors) + 1
        offset = self.dice.choice([0, 0, 90, -90, 45])
        angle = math.degrees(math.atan2(y, x)) - offset
        self.parameters.append(
            f"param t{number} = {angle!r} deg in {angle - 2!r} deg .. {angle + 2!r} deg"
        )
        length = "" if open_length else self._length(f"l{number}", math.hypot(x, y)) + " "
        turned = f" + {self.style.turn}" if self.style.turn else ""
        constant = f" {'+' if offset > 0 else '-'} {abs(offset)} deg" if offset else ""
        self.vectors.append(f"{name} = {length}@ t{number}{constant}{turned}")


def _load_text(load: Load, style: Style) -> str:
    tie = f" = {load.part}*{load.of}" if load.of else ""
    times = f" times {load.times}" if load.times else ""
    if load.angle is None:
        return f"torque {load.name}{tie} on {load.at}{times}"
    return f"force {load.name}{tie} at {load.at} along {style.angle(load.angle)}{times}"


def _component(bars: list[Bar], start: str) -> set[str]:
    """Return the points that hang together with one, over bars alone."""
    found, grown = {start}, True
    while grown:
        size = len(found)
        for bar in bars:
            if found & set(bar.points):
                found |= set(bar.points)
        grown = len(found) > size
    return found


def grow(dice: Random, groups: int | None = None) -> Linkage:
    """Return a random linkage with its loads."""
    linkage = Linkage(dice)
    for _ in range(2 if dice.random() < 0.1 else 1):
        dice.choice([linkage.crank, linkage.slider])()
    ways = [linkage.dyad, linkage.dyad, linkage.rod_and_slider, linkage.triad]
    for _ in range(dice.choice([1, 1, 2, 2, 3, 4]) if groups is None else groups):
        dice.choice(ways)()
    linkage.load()
    linkage.multiply()
    return linkage


def sample(seed: int, groups: int | None = None) -> Sample:
    """Return the well-conditioned random mechanism of a seed."""
    dice = Random(seed)
    while True:
        linkage = grow(dice, groups)
        solved = linkage.solve()
        if solved is not None:
            return Sample(linkage, *solved)
