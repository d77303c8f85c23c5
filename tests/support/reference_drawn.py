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
    "slot": r"slot (\w+) in (\w+)$",
    "contact": r"contact (\w+) on (\w+) normal (.+)$",
    "wheels": r"(gear|belt) (\w+) (\S+(?: mm)?)(?: on (\w+))?, (\w+) (\S+(?: mm)?)(?: on (\w+))?"
    r"( inner| crossed)?$",
    "rack": r"rack (\w+) on (\w+) (.+)$",
    "screw": r"screw (\w+) pitch (.+) on (\w+)$",
    "rope": r"rope (.+)$",
    "mirror": r"mirror across \w+(?: sharing (.+))?$",
    "param": r"param (\w+) = (\S+ mm)$",
    "force": r"force (\w+) at (\w+) along (.+)$",
    "weight": r"weight (\w+) mass (\S+) kg at (\w+)$",
    "torque": r"torque (\w+) on (\w+)$",
    "actuator": r"actuator (\w+) between (\w+) and (\w+)$",
}


def points_of(name):
    return re.findall(r"[A-Z]\d*", name)


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
        for point, line in self.lines["slot"]:
            tail, head = points_of(line)
            yield self.relative(point, self.body(line), across(self.way(tail, head)))
        for point, name, normal in self.lines["contact"]:
            yield self.relative(point, self.body(name), self.unit(normal))
        yield from self.transmissions()

    def transmissions(self):
        for kind, first, r1, on1, second, r2, on2, how in self.lines["wheels"]:
            arm = sum(self.turning(b) for b in self.bodies if {first, second} <= {*b})
            sense = -1 if (kind == "gear") == (how is None) else 1
            rims = [
                self.size(r) * (self.wheel(o, on) - arm)
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

    def wheel(self, centre, on):
        if on == "ground":
            return 0
        return self.turning(self.body(on) if on else next(b for b in self.bodies if centre in b))

    # ------------------------------------------------------------------- loads

    def weights(self):
        return {name: float(mass) * GRAVITY for name, mass, _ in self.lines["weight"]}

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
        for name, first, second in self.lines["actuator"]:
            way = self.way(first, second)
            yield name, self.velocity(second, way) - self.velocity(first, way)


def across(way):
    return np.array([-way[1], way[0]])


def length(text):
    size, _, unit = text.partition(" ")
    return float(size) * UNITS[unit]
