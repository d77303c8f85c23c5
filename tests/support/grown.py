"""Closed mechanisms grown at random: a drive, and Assur groups that hang on it and on one another.

Points are put at random places; lengths, angles and assembly lines are read off them. Beside
each line of the description stands what it says of coordinates, as one bilinear form: the
reference sees those alone.
"""

import math
import re
from collections.abc import Callable
from itertools import combinations
from random import Random
from typing import NamedTuple

REACH = 0.12
"""How far a new point lies from the one it hangs on, at most, in metres."""

Place = tuple[float, float]


def area(a: Place, b: Place, c: Place) -> float:
    """Return twice the area of a triangle, above zero where its corners turn to the left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


class Form(NamedTuple):
    """(q − p) · (s − r), or (q − p) × (s − r), has a value; ``drive`` says how that runs on.

    With the drive x and the crank r it is r cos x, r sin x, x², r², or grows with r.
    """

    p: str
    q: str
    r: str
    s: str
    is_cross: bool = False
    value: float = 0.0
    drive: str = ""


class Line(NamedTuple):
    """A line whose direction the loops know already: through a point, along a unit vector."""

    start: str
    head: str


class Grown:
    """A mechanism: ``lines`` of text, ``forms``, and the ``kinds`` of its groups."""

    def __init__(self, seed: int) -> None:
        self.seed, self.dice = seed, Random(seed)
        self.places: dict[str, Place] = {"0": (0, 0), "X": (1, 0), "Y": (0, 1)}
        self.fixed, self.pivots = {"0", "X", "Y"}, list[str]()
        self.lines, self.assemblies = list[str](), list[str]()
        self.in_slot: dict[str, tuple[str, str, str, str]] = {}
        self.forms: list[Form] = []
        self.kinds: list[str] = []
        self.moving: list[str] = []
        self.bars: list[Line] = []
        self.guided: set[str] = set()
        (self.crank if self.dice.random() < 0.8 else self.cylinder)()
        for _ in range(self.dice.choice((1, 1, 2, 2, 3))):
            grow = self.dice.choices(list(GROUPS), list(GROUPS.values()))[0]
            grow(self)
            self.kinds.append(grow.__name__)
        self.load()

    # ------------------------------------------------------------------------- points

    def point(self, letter: str, around: str, reach: float = REACH) -> str:
        """Put a point somewhere, near another and not too near to any."""
        while True:
            angle = self.dice.uniform(0, 2 * math.pi)
            size = self.dice.uniform(0.4, 1) * reach
            x, y = self.places[around]
            place = x + size * math.cos(angle), y + size * math.sin(angle)
            if all(math.dist(place, p) > 0.02 for n, p in self.places.items() if n not in "XY"):
                return self.put(letter, place)

    def put(self, letter: str, place: Place) -> str:
        name = f"{letter}{len(self.places)}"
        self.places[name] = place
        return name

    def pivot(self, around: str, reach: float = REACH) -> str:
        name = self.point("P", around, reach)
        self.fixed.add(name)
        self.pivots.append(name)
        x, y = self.places[name]
        self.lines.append(f"pivot {name} at ({x!r} m, {y!r} m)")
        return name

    def hold(self, around: str, besides: set[str]) -> str:
        """Return the point for the far end of a new link: a new pivot, or another pin."""
        others = [p for p in self.moving if p not in besides]
        if others and self.dice.random() < 0.2:
            return self.dice.choice(others)
        return self.pivot(around)

    def toward(self, p: str, q: str) -> Place:
        size = math.dist(self.places[p], self.places[q])
        (px, py), (qx, qy) = self.places[p], self.places[q]
        return (qx - px) / size, (qy - py) / size

    def beyond(self, start: str, along: Place, size: float) -> Place:
        x, y = self.places[start]
        return x + size * along[0], y + size * along[1]

    # -------------------------------------------------------------------- what is said

    def rod(self, p: str, q: str) -> None:
        self.lines.append(f"link {p}{q}")
        self.side(p, q)
        self.bars.append(Line(p, q))

    def side(self, p: str, q: str) -> None:
        size = math.dist(self.places[p], self.places[q])
        self.lines.append(f"{p}{q} = {size!r} m")
        self.forms.append(Form(p, q, p, q, value=size * size))

    def plate(self, p: str, q: str, r: str) -> None:
        """A rigid triangle: two sides, and the angle between them at the first point."""
        self.lines.append(f"link {p}{q}{r}")
        self.side(p, q)
        self.side(p, r)
        (a, b), (c, d) = self.toward(p, q), self.toward(p, r)
        turn = math.atan2(a * d - b * c, a * c + b * d) % (2 * math.pi)
        self.lines.append(f"angle {q}{p}{r} = {turn!r} rad")
        size = math.dist(self.places[p], self.places[q]) * math.dist(self.places[p], self.places[r])
        self.forms.append(Form(p, q, p, r, value=size * math.cos(turn)))
        self.bars.append(Line(p, q))

    def guide(self, pin: str, along: float) -> None:
        """A guide on the ground, through a pivot behind the pin."""
        self.guided.add(pin)
        way = math.cos(along), math.sin(along)
        start = self.put("G", self.beyond(pin, way, -self.dice.uniform(0.05, 0.2)))
        head = self.put("H", self.beyond(start, way, 1.0))
        self.fixed |= {start, head}
        x, y = self.places[start]
        self.lines += [f"pivot {start} at ({x!r} m, {y!r} m)"]
        self.lines += [f"slider {pin} along {along!r} rad through {start}"]
        self.forms.append(Form(start, pin, start, head, is_cross=True))

    def slot(self, pin: str, line: Line) -> None:
        self.guided.add(pin)
        self.lines.append(f"slot {pin} in {line.start}{line.head}")
        self.forms.append(Form(line.start, pin, line.start, line.head, is_cross=True))

    def turns(self, a: str, b: str, c: str) -> None:
        """Say which way round three points turn."""
        self.assemblies.append(self.turn(a, b, c))

    def turn(self, a: str, b: str, c: str) -> str:
        """Return the line that says which way round three points turn."""
        is_left = area(*(self.places[p] for p in (a, b, c))) > 0
        return f"assembly {a}{b}{c} {'ccw' if is_left else 'cw'}"

    def in_one_of_two(self, pin: str, pivot: str, arm: str) -> None:
        """Say of a pin in two slots in words of either's link how it stands in each of them."""
        line, *first = self.in_slot[pin]
        if line in self.assemblies:
            points = self.distinctive(pin, *first)
            said = self.turn(*points) if points else line
            self.assemblies[self.assemblies.index(line)] = said
        self.turns(pin, pivot, arm)

    def distinctive(self, pin: str, pivot: str, arm: str, head: str) -> tuple[str, str, str] | None:
        """Return three points that turn the other way where a slot's link closes otherwise.

        None where all that are looked at turn alike. One is of the link; two are on the ground,
        or one is, and the other is the pin.
        """
        elsewhere = self.other_side(pin, pivot, (arm, head))
        said = [line.split()[1] for line in self.lines if line.startswith("pivot ")]
        fixed = [pin, pivot, *(p for p in said if p != pivot)]
        for corner in (arm, head):
            for triple in ((*pair, corner) for pair in combinations(fixed, 2)):
                areas = (area(*(at[p] for p in triple)) for at in (self.places, elsewhere))
                if math.prod(areas) < 0:
                    return triple
        return None

    def other_side(self, pin: str, pivot: str, link: tuple[str, str]) -> dict[str, Place]:
        """Return the places where a pin is on the other side of the foot of the perpendicular.

        That is from the pivot to the slot, in which the link's last point is.
        """
        centre, place = complex(*self.places[pivot]), complex(*self.places[pin])
        along = complex(*self.toward(pin, link[-1]))
        foot = place + ((centre - place) * along.conjugate()).real * along
        turned = (place - centre) / (2 * foot - place - centre)
        ends = {p: centre + (complex(*self.places[p]) - centre) * turned for p in link}
        return {**self.places, **{p: (end.real, end.imag) for p, end in ends.items()}}

    def stands(self, pin: str, foot: str, along: Place) -> None:
        """Say on which side of the foot of a perpendicular a pin stands on its line."""
        (px, py), (fx, fy) = self.places[pin], self.places[foot]
        ahead = (px - fx) * along[0] + (py - fy) * along[1]
        self.assemblies.append(f"assembly {pin} {'forward' if ahead > 0 else 'back'}")

    # -------------------------------------------------------------------------- drives

    def crank(self) -> None:
        self.size = 0.05
        self.drive, self.start = "phi", self.dice.uniform(-3, 3)
        o = self.put("O", (0.0, 0.0))
        a = self.put("A", (0.05 * math.cos(self.start), 0.05 * math.sin(self.start)))
        self.fixed.add(o)
        self.lines += ["param r = 0.05 m", f"param phi = {self.start!r} rad"]
        self.lines += [f"pivot {o} at (0 m, 0 m)", f"link {o}{a}", f"{o}{a} = r @ phi"]
        self.forms += [Form(o, a, "0", "X", drive="cos"), Form(o, a, "0", "Y", drive="sin")]
        self.moving.append(a)
        self.bars.append(Line(o, a))
        self.pushes = f"torque M on {o}{a}"

    def cylinder(self) -> None:
        """A boom on a cylinder; the cylinder's length is what drives."""
        self.drive, self.places["O"] = "s", (0.0, 0.0)
        self.fixed.add("O")
        self.lines.append("pivot O at (0 m, 0 m)")
        a, c = self.point("A", "O"), self.pivot("O")
        self.start = math.dist(self.places[a], self.places[c])
        e = self.point("E", "O")
        self.size = math.dist((0, 0), self.places[a])
        self.lines += [f"param s = {self.start!r} m", f"param r = {self.size!r} m"]
        self.lines += [f"telescope {c}{a}", f"{c}{a} = s"]
        self.plate("O", a, e)
        self.lines = [f"O{a} = r" if line.startswith(f"O{a} =") else line for line in self.lines]
        arm, *others, angle = self.forms
        self.forms = [arm._replace(drive="rr"), *others, angle._replace(drive="r")]
        self.turns("O", c, a)
        self.forms.append(Form(c, a, c, a, drive="xx"))
        self.moving.append(e)
        self.pushes = f"actuator M between {c} and {a}"

    # -------------------------------------------------------------------------- groups

    def rrr(self) -> None:
        """A pin held by two rods."""
        first = self.dice.choice(self.moving)
        pin = self.point("B", first)
        second = self.hold(pin, {first})
        self.rod(first, pin)
        self.rod(second, pin)
        self.turns(first, pin, second)
        self.moving.append(pin)

    def rrp(self) -> None:
        """A rod to a slider on the ground, or to a pin in the slot of a moving link."""
        first = self.dice.choice(self.moving)
        moving = [b for b in self.bars if first not in b]
        if moving and self.dice.random() < 0.4:
            line = self.dice.choice(moving)
            along = self.toward(*line)
            pin = self.put("S", self.beyond(line.start, along, self.dice.uniform(-0.1, 0.15)))
            self.slot(pin, line)
        else:
            pin = self.point("S", first)
            angle = self.dice.uniform(-3, 3)
            along = math.cos(angle), math.sin(angle)
            self.guide(pin, angle)
        self.rod(first, pin)
        self.stands(pin, first, along)
        self.moving.append(pin)

    def rpr_slot(self) -> None:
        """A pin in the slot of a link on a pivot; the slot may pass the pivot by."""
        pin = self.dice.choice(self.moving)
        pivot = self.pivot(pin)
        arm, guided = self.point("D", pivot), set(self.guided)
        if pin in self.guided or self.dice.random() < 0.5:
            side = 1 if pin in self.guided else self.dice.choice((1, -1))
            head = self.put("C", self.beyond(pivot, self.toward(pivot, pin), 0.1 * side))
            if pin not in self.guided:
                self.assemblies.append(f"assembly {pin} {'forward' if side > 0 else 'back'}")
            elif pin in self.in_slot:
                self.in_one_of_two(pin, pivot, arm)
            self.plate(pivot, head, arm)
            self.slot(pin, Line(pivot, head))
        else:
            head = self.put("C", self.beyond(pin, self.toward(pin, arm), 0.07))
            self.plate(pivot, arm, head)
            self.slot(pin, Line(arm, head))
            self.stands(pin, pivot, self.toward(arm, head))
        if pin not in guided:
            self.in_slot[pin] = self.assemblies[-1], pivot, arm, head
        self.moving.append(arm)

    def rpr_block(self) -> None:
        """A block that slides along a link on a pivot: two of its pins are in the slot."""
        pin = self.dice.choice(self.moving)
        pivot = self.pivot(pin)
        along = self.toward(pivot, pin)
        head = self.put("C", self.beyond(pivot, along, 0.1))
        size = self.dice.uniform(0.02, 0.08) * self.dice.choice((1, -1))
        end = self.put("E", self.beyond(pin, along, size))
        self.rod(pivot, head)
        self.slot(pin, Line(pivot, head))
        self.rod(pin, end)
        self.slot(end, Line(pivot, head))
        self.assemblies.append(f"assembly {end} {'forward' if size > 0 else 'back'}")
        self.moving.append(end)

    def prp(self) -> None:
        """A pin in the slot of a moving link and on a guide of the ground."""
        line = self.dice.choice(self.bars)
        along = self.toward(*line)
        pin = self.put("T", self.beyond(line.start, along, self.dice.uniform(-0.1, 0.15)))
        self.slot(pin, line)
        across = math.atan2(along[1], along[0]) + self.dice.uniform(0.6, 2.5)
        self.guide(pin, across)
        self.moving.append(pin)

    def rpp(self) -> None:
        """A yoke: a pin in the slot of a body that slides on the ground."""
        pin = self.dice.choice(self.moving)
        angle, lean = self.dice.uniform(-3, 3), self.dice.uniform(0.6, 2.5)
        yoke = self.point("W", pin)
        way = math.cos(angle + lean), math.sin(angle + lean)
        self.places[yoke] = self.beyond(pin, way, self.dice.uniform(0.03, 0.1))
        head = self.put("U", self.beyond(yoke, way, 0.1))
        self.guide(yoke, angle)
        self.lines += [f"slide {yoke}{head} along {angle!r} rad"]
        self.lines += [f"{yoke}{head} = 0.1 m @ {angle + lean!r} rad"]
        for axis, size in zip("XY", way, strict=True):
            self.forms.append(Form(yoke, head, "0", axis, value=0.1 * size))
        self.slot(pin, Line(yoke, head))
        self.moving.append(yoke)

    def triad(self) -> None:
        """Class III: a ternary link on three rods, one of which may be a guide instead."""
        first = self.dice.choice(self.moving)
        b = self.point("B", first)
        c, d = self.point("C", b), self.point("D", b)
        self.plate(b, c, d)
        self.rod(first, b)
        held = [first]
        for corner in (c, d):
            if corner == d and self.dice.random() < 0.3:
                self.guide(d, self.dice.uniform(-3, 3))
                continue
            end = self.hold(corner, set(held))
            self.rod(end, corner)
            held.append(end)
        for triple in combinations((*held, b, c, d), 3):
            if triple != (b, c, d) and not set(triple) <= {*held}:
                self.turns(*triple)
        self.moving += [c, d]

    # --------------------------------------------------------------------------- loads

    def load(self) -> None:
        """Put a load on the last point: a force, a couple on a bar, or a pair of forces."""
        last = self.moving[-1]
        others = [p for p in (*self.moving[:-1], *self.pivots) if p != last]
        kind = self.dice.choice(("force", "along", "torque", "pair", "telescope"))
        self.work: tuple[str, str, str, float] = ("force", last, last, self.dice.uniform(-3, 3))
        other = self.dice.choice(others) if others else ""
        turning = [b for b in self.bars if last in b]
        if kind == "torque" and turning:
            p, q = turning[-1]
            self.work = ("torque", p, q, 0.0)
            self.pulls = f"torque F on {p}{q}"
        elif kind in ("pair", "telescope") and other:
            self.work = ("pair", other, last, 0.0)
            self.pulls = f"actuator F between {other} and {last}"
            joined = any({other, last} <= {f.p, f.q} for f in self.forms)
            self.lines += [f"telescope {other}{last}"] * (kind == "telescope" and not joined)
        else:
            self.pulls = f"force F at {last} along {self.work[3]!r} rad"

    def text(self) -> str:
        """Return the description."""
        wide = 0.25 if self.drive == "phi" else 0.02
        unit = "rad" if self.drive == "phi" else "m"
        ends = f"from {self.start - wide} {unit} to {self.start + wide} {unit}"
        lines = [*self.lines, *self.assemblies, f"drive {self.drive} {ends}"]
        return "\n".join([*lines, self.pushes, self.pulls, "find k = M / F"])


GROUPS: dict[Callable[[Grown], None], float] = {
    Grown.rrr: 3,
    Grown.rrp: 3,
    Grown.rpr_slot: 2,
    Grown.rpr_block: 1,
    Grown.prp: 1,
    Grown.rpp: 1,
    Grown.triad: 1.5,
}
"""The groups, and how often each is to grow."""


WIDE = {"phi": (2.6, "rad"), "s": (0.05, "m")}


def wide(grown: Grown) -> str:
    """Return a description with a stroke that goes beyond what the loops allow."""
    (size, unit), start = WIDE[grown.drive], grown.start
    stroke = f"drive {grown.drive} from {start - size!r} {unit} to {start + size!r} {unit}"
    lines = [line for line in grown.text().split("\n") if not line.startswith("drive ")]
    return "\n".join([*lines, stroke])


def swept(grown: Grown) -> str:
    """Return a description with a range about its crank's default angle."""

    def ranged(found: re.Match[str]) -> str:
        middle = float(found[1])
        return f"{found[0]} in {middle - 1.5!r} rad .. {middle + 1.5!r} rad"

    return re.sub(r"param phi = (\S+) rad", ranged, grown.text())


def without_drive(description: str) -> str:
    """Return a description whose drive is an angle with a range, and no drive."""
    (line,) = re.findall(r"^drive (\w+) from (.+) to (.+)$", description, re.MULTILINE)
    name, low, high = line
    ranged = re.sub(rf"(?m)^(param {name} .+)$", rf"\1 in {low} .. {high}", description)
    return re.sub(r"(?m)^drive .+\n?", "", ranged)


LAID_OUT = ("pivot", "slider", "link", "slot", "telescope", "slide")
LOADED = ("torque", "force", "actuator", "find")


def drawn(grown: Grown) -> str:
    """Return a description by the places of its pins, of which lengths and angles follow."""
    (size, unit), start = WIDE[grown.drive], grown.start
    lines = grown.text().split("\n")
    kept = [line for line in lines if line.split()[0] in (*LAID_OUT, *LOADED)]
    (crank,) = (line.split()[0] for line in lines if re.search(" = (r @ phi|s)$", line))
    pivots = {line.split()[1] for line in kept if line.startswith("pivot ")}
    named = {p for line in kept for p in re.findall(r"[A-Z]\d*", line.split(" along ")[0])}
    places = {p: at for p, at in grown.places.items() if p in named - pivots}
    kept += [f"{p} at ({x!r} m, {y!r} m)" for p, (x, y) in places.items()]
    kept.append(f"drive {crank} from {start - size!r} {unit} to {start + size!r} {unit}")
    return "\n".join(kept)
