"""Drawn mechanisms from their text alone: which velocities their joints allow, and the work.

A second reading of the lines, which shares nothing with the compiler: what moves is the null
space of the joints' conditions at the drawn coordinates, by singular values. The loads that
were found must do no work, together with those that were given, in any of these motions.
"""

import itertools
import math
import re

import numpy as np

UNITS = {"mm": 1e-3, "m": 1.0, "in": 0.0254, "ft": 0.3048, "": 1.0}
AXES = {"x": (1, 0), "-x": (-1, 0), "y": (0, 1), "-y": (0, -1)}
GRAVITY = 9.80665
LINES = {
    "place": r"(?:pivot )?(\w+) at \((.+), (.+)\)$",
    "pivot": r"pivot (\w+)",
    "slider": r"slider (\w+) along (.+)$",
    "link": r"link (\w+)",
    "slide": r"slide (\w+) along (.+)$",
    "slot": r"slot (\w+) in (\w+)(?: guiding (\w+))?$",
    "contact": r"contact (\w+) on (\w+) normal (.+)$",
    "wheels": r"(gear|belt) (\w+) (\S+(?: mm)?)(?: on (\w+))?, (\w+) (\S+(?: mm)?)(?: on (\w+))?"
    r"( inner| crossed)?$",
    "rack": r"rack (\w+) on (\w+) (?:radius )?(.+)$",
    "screw": r"screw (\w+) pitch (.+) on (\w+)$",
    "rope": r"rope (.+)$",
    "mirror": r"mirror across \w+(?: sharing (.+))?$",
    "param": r"param (\w+) = (\S+ mm)$",
    "force": r"force (\w+) at (\w+) along (.+)$",
    "weight": r"weight (\w+) mass (\S+) kg at (\w+)$",
    "torque": r"torque (\w+) on (\w+)$",
    "spread": r"load (\w+) intensity (\S+) kN/m on (\w+) along (.+)$",
    "actuator": r"actuator (\w+) between (\w+) and (\w+)$",
    "spring": r"spring (\S+) N/mm between (\w+) and (\w+) free (.+)$",
    "tension": r"tension (\w+) between (\w+) and (\w+)$",
}


def points_of(name):
    return re.findall(r"[A-Z]\d*", name)


def released(text):
    """Return the lines with each joint whose force is asked for replaced by that force."""
    for name in re.search("find (.*)", text)[1].split(", "):
        kind, _, points = name.partition("_")
        if kind == "R":
            forces = [f"force {name}_{axis} at {points} along {axis}" for axis in "xy"]
            text = text.replace(f"pivot {points} at", "\n".join([*forces, f"{points} at"]))
        elif kind == "N" and len(points_of(points)) == 1:
            line = rf"slider {points} along (\S+)"
            text = re.sub(line, rf"force {name} at {points} along perp \1", text)
        elif kind == "N":
            first, second = points_of(points)
            line = rf"link {points}$|rope {first}, {second}$"
            pair = f"tension {name} between {first} and {second}"
            text = re.sub(line, pair, text, flags=re.MULTILINE)
    return text


class Drawn:
    """A description's lines by their kinds, and the motions that they allow."""

    def __init__(self, text):
        lines = [re.sub(r'\s*"[^"]*"', "", line) for line in text.splitlines()]
        self.lines = {
            kind: [m.groups() for line in lines if (m := re.match(pattern, line))]
            for kind, pattern in LINES.items()
        }
        self.sizes = {name: length(value) for name, value in self.lines["param"]}
        self.at = {p: np.array([length(x), length(y)]) for p, x, y in self.lines["place"]}
        self.bodies = [points_of(name) for (name,) in self.lines["link"]]
        self.columns = {point: 2 * i for i, point in enumerate(self.at)}
        rows = np.array(list(self.conditions()))
        _, sizes, vectors = np.linalg.svd(rows)
        self.motions = vectors[np.sum(sizes > 1e-9 * sizes[0]) :]

    # ------------------------------------------------------------------------ rows

    def velocity(self, point, way):
        row = np.zeros(2 * len(self.at) + len(self.bodies))
        row[self.columns[point] : self.columns[point] + 2] = way
        return row

    def turning(self, body):
        row = np.zeros(2 * len(self.at) + len(self.bodies))
        row[2 * len(self.at) + self.bodies.index(body)] = 1
        return row

    def relative(self, point, body, way):
        """Return the velocity of a point relative to a body, along a direction."""
        row = self.velocity(point, way) - self.velocity(body[0], way)
        if body in self.bodies:
            x, y = self.at[point] - self.at[body[0]]
            row -= (x * way[1] - y * way[0]) * self.turning(body)
        return row

    def unit(self, along):
        if along in AXES:
            return np.array(AXES[along], dtype=float)
        if along.startswith("perp "):
            return across(self.unit(along[5:]))
        if along.endswith(" deg"):
            angle = math.radians(float(along[:-4]))
            return np.array([math.cos(angle), math.sin(angle)])
        tail, head = points_of(along)
        return self.way(tail, head)

    def way(self, tail, head):
        step = self.at[head] - self.at[tail]
        return step / np.hypot(*step)

    def body(self, name):
        points = points_of(name)
        return next((b for b in self.bodies if {*points} <= {*b}), points)

    # ------------------------------------------------------------------ joints

    def conditions(self):
        for (point,) in self.lines["pivot"]:
            yield from (self.velocity(point, axis) for axis in np.eye(2))
        for point, along in self.lines["slider"]:
            yield self.velocity(point, across(self.unit(along)))
        for body in self.bodies:
            for point in body[1:]:
                yield from (self.relative(point, body, axis) for axis in np.eye(2))
        for name, along in self.lines["slide"]:
            first, *others = points_of(name)
            yield self.velocity(first, across(self.unit(along)))
            for point in others:
                yield from (self.relative(point, [first], axis) for axis in np.eye(2))
        for point, line, guided in self.lines["slot"]:
            tail, head = points_of(line)
            yield self.relative(point, self.body(line), across(self.way(tail, head)))
            if guided:
                yield self.turning(self.body(guided)) - self.turning(self.body(line))
        for point, name, normal in self.lines["contact"]:
            yield self.relative(point, self.body(name), self.unit(normal))
        yield from self.transmissions()

    def transmissions(self):
        for kind, first, r1, on1, second, r2, on2, how in self.lines["wheels"]:
            arms = [b for b in self.bodies if self.on_axis(first, b) and self.on_axis(second, b)]
            arm = sum(self.turning(body) for body in arms)
            sense = -1 if (kind == "gear") == (how is None) else 1
            rims = [
                self.size(r) * (self.wheel(o, on, arms) - arm)
                for o, r, on in ((first, r1, on1), (second, r2, on2))
            ]
            yield rims[0] - sense * rims[1]
        for point, pivot, radius in self.lines["rack"]:
            yield self.along_guide(point) - self.size(radius) * self.wheel(pivot, None)
        for point, pitch, name in self.lines["screw"]:
            turn = self.turning(self.body(name))
            yield self.along_guide(point) - length(pitch) / math.tau * turn
        for (route,) in self.lines["rope"]:
            ends = [part.partition(" along ") for part in route.split(", ")]
            falls = list(itertools.pairwise(ends))
            ways = [self.unit(on) if on else self.way(a, b) for (a, *_), (b, _, on) in falls]
            steps = zip(falls, ways, strict=True)
            yield sum(self.velocity(b, w) - self.velocity(a, w) for ((a, *_), (b, *_)), w in steps)

    def size(self, text):
        return self.sizes.get(text) or length(text)

    def along_guide(self, point):
        (along,) = [along for p, along in self.lines["slider"] if p == point]
        return self.velocity(point, self.unit(along))

    def on_axis(self, point, body):
        return any(self.distance(point, other) < 1e-12 for other in body)

    def wheel(self, centre, on, arms=()):
        if on == "ground":
            return 0
        others = (b for b in self.bodies if centre in b and b not in arms)
        return self.turning(self.body(on) if on else next(others))

    # ------------------------------------------------------------------- loads

    def known(self):
        """Return the value of each weight, spread load and spring, as the lines give it."""
        values = {name: float(mass) * GRAVITY for name, mass, _ in self.lines["weight"]}
        for name, intensity, line, _ in self.lines["spread"]:
            values[name] = 1000 * float(intensity) * self.distance(*points_of(line))
        for rate, first, second, free in self.lines["spring"]:
            stretch = self.distance(first, second) - length(free)
            values[f"S_{first}{second}"] = -1000 * float(rate) * stretch
        return values

    def distance(self, first, second):
        return np.hypot(*(self.at[first] - self.at[second]))

    def work(self, values):
        """Return the power of all loads in each motion, and the size of its greatest part."""
        parts = np.array([values[name] * self.motions @ row for name, row in self.loads()])
        return parts.sum(axis=0), np.abs(parts).max()

    def loads(self):
        """Yield the name and the row of each load; twice what the halves do not share."""
        shared = [points_of(line[0] or "") for line in self.lines["mirror"]]

        def number(point):
            return 2 if shared and point not in shared[0] else 1

        for name, point, along in self.lines["force"]:
            yield name, number(point) * self.velocity(point, self.unit(along))
        for name, _, point in self.lines["weight"]:
            yield name, number(point) * self.velocity(point, AXES["-y"])
        for name, body in self.lines["torque"]:
            yield name, self.turning(self.body(body))
        for name, _, line, along in self.lines["spread"]:
            ends = [self.velocity(point, self.unit(along)) for point in points_of(line)]
            yield name, sum(ends) / 2
        springs = [(f"S_{a}{b}", a, b) for _, a, b, _ in self.lines["spring"]]
        for name, first, second in (*self.lines["actuator"], *springs):
            yield name, self.parting(first, second)
        for name, first, second in self.lines["tension"]:
            yield name, -self.parting(first, second)

    def parting(self, first, second):
        """Return the row of the speed at which two points move apart."""
        way = self.way(first, second)
        return self.velocity(second, way) - self.velocity(first, way)


def across(way):
    return np.array([-way[1], way[0]])


def length(text):
    size, _, unit = text.partition(" ")
    return float(size) * UNITS[unit]
