"""Closed mechanisms by coordinates: loop equations by Newton, work by differences.

A third method. It shares nothing with the compiler but the syntax tree: every point has
two unknown coordinates, every statement of the geometry is an equation between them. What
the compiler found for the default pose is only where the iteration starts.
"""

import math

import numpy as np

from mechc.formula.evaluate import evaluate as number
from mechc.model.mechanism import Slot
from mechc.pose.places import placed
from mechc.statics import geometry_check
from mechc.syntax import ast
from mechc.syntax.vocabulary import points_of
from reference_geometry import evaluate, every

STEP = 1e-5
"""The part of the drive by which it is moved to difference the work."""


class Assembled:
    """The points of a description at one value of its drive."""

    def __init__(self, tree, values, places):
        self.tree, self.values = tree, values
        self.points = sorted(places)
        self.index = {p: 2 * i for i, p in enumerate(self.points)}
        start = np.array([places[p] for p in self.points], dtype=float)
        self.x = (start + self.origin(places)).ravel()

    def origin(self, places):
        """Return by how much the places are to be moved for a pivot to stand where it is given."""
        for s in every(self.tree, ast.Pivot):
            if s.at:
                given = [evaluate(c, self.values) for c in (s.at.x, s.at.y)]
                return np.subtract(given, places[s.point.text])
        return np.zeros(2)

    def at(self, point, x=None):
        x = self.x if x is None else x
        i = self.index[point]
        return x[i : i + 2]

    def direction(self, direction, x):
        """Return a unit vector."""
        match direction:
            case ast.Axis(axis, sign):
                return sign * np.array([1.0, 0.0] if axis == "x" else [0.0, 1.0])
            case ast.Toward(name, sign, perp):
                tail, head = points_of(name.text)
                v = self.at(head, x) - self.at(tail, x)
                v = sign * v / np.hypot(*v)
                return np.array([-v[1], v[0]]) if perp else v
            case _:
                angle = evaluate(direction, self.values)
                return np.array([math.cos(angle), math.sin(angle)])

    def equations(self, x):
        """Yield everything that must vanish."""
        for s in every(self.tree, ast.Pivot):
            if s.at:
                place = [evaluate(c, self.values) for c in (s.at.x, s.at.y)]
                yield from self.at(s.point.text, x) - place
        for s in every(self.tree, ast.Vector):
            yield from self.vector(s, x)
        for s in every(self.tree, ast.Turn):
            first, vertex, second = (self.at(p, x) for p in points_of(s.points.text))
            gamma = evaluate(s.angle, self.values)
            a, b = complex(*(first - vertex)), complex(*(second - vertex))
            yield (b / a * np.exp(-1j * gamma)).imag
        for s in every(self.tree, ast.Slider):
            if s.through is not None:
                place = self.at(s.point.text, x) - self.start(s.through, x)
                yield cross(place, self.direction(s.along, x))
        for s in every(self.tree, ast.Slot):
            if s.about and s.radius:
                place = self.at(s.point.text, x) - self.at(s.about.text, x)
                yield np.hypot(*place) - evaluate(s.radius, self.values)
                continue
            tail, head = points_of(s.line.text)
            line = self.at(head, x) - self.at(tail, x)
            yield cross(self.at(s.point.text, x) - self.at(tail, x), line / np.hypot(*line))

    def start(self, through, x):
        """Return the place that a guide passes through."""
        if isinstance(through, ast.Name):
            return self.at(through.text, x)
        return np.array([evaluate(c, self.values) for c in (through.x, through.y)])

    def vector(self, s, x):
        tail, head = points_of(s.points.text)
        v = self.at(head, x) - self.at(tail, x)
        match s.value:
            case ast.Cartesian() as place:
                yield from v - [evaluate(c, self.values) for c in (place.x, place.y)]
            case ast.Polar(length=length, direction=direction):
                along = self.direction(direction, x) if self.is_given(direction) else None
                size = evaluate(length, self.values) if length else None
                if along is not None and size is not None:
                    yield from v - size * along
                elif along is not None:
                    yield cross(v, along)
                else:
                    yield np.hypot(*v) - size

    def is_given(self, direction):
        """Tell a direction that is known from none and from one that the loops are to give."""
        if isinstance(direction, ast.Axis | ast.Toward) or direction is None:
            return direction is not None
        try:
            evaluate(direction, self.values)
        except KeyError:
            return False
        return True

    def assembled(self):
        """Solve all equations, by Newton's method on what may be more equations than unknowns."""
        for _ in range(60):
            f = np.array(list(self.equations(self.x)))
            jacobian = np.empty((len(f), len(self.x)))
            for i in range(len(self.x)):
                h = np.zeros_like(self.x)
                h[i] = 1e-7
                ahead, behind = (list(self.equations(self.x + s * h)) for s in (1, -1))
                jacobian[:, i] = (np.array(ahead) - np.array(behind)) / 2e-7
            step = np.linalg.lstsq(jacobian, f, rcond=1e-9)[0]
            self.x = self.x - step
            if np.max(np.abs(step)) < 1e-14:
                break
        gap = np.max(np.abs(list(self.equations(self.x))))
        assert gap < 1e-10, f"does not close: {gap}"
        return self


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def ratio(compilation, tree, values, above, below):
    """Return above/below by the work of both loads in a small step of the drive."""
    drive = compilation.pose.mechanism.drive.parameter
    start = places(compilation, values)
    poses = {}
    for sign in (-1, 0, 1):
        moved = {**values, drive: values[drive] + sign * STEP * max(abs(values[drive]), 0.1)}
        poses[sign] = Assembled(tree, moved, start).assembled()
    work = {name: _work(name, tree, poses) for name in (above, below)}
    return -work[below] / work[above]


def _work(name, tree, poses):
    middle = poses[0]
    total = 0.0
    for s in tree.statements:
        if isinstance(s, ast.Force) and name in (s.name.text, _tied(s)):
            size = evaluate(s.tie, {**middle.values, name: 1.0}) if s.tie else 1.0
            moved = poses[1].at(s.point.text) - poses[-1].at(s.point.text)
            total += size * float(moved @ middle.direction(s.along, middle.x)) * _times(s)
        elif isinstance(s, ast.Torque) and s.name.text == name:
            tail, head = points_of(s.link.text)[:2]
            turned = [complex(*(p.at(head) - p.at(tail))) for p in (poses[1], poses[-1])]
            total += float(np.angle(turned[0] / turned[1])) * _times(s)
        elif isinstance(s, ast.Actuator) and s.name.text == name:
            ends = s.first.text, s.second.text
            apart = [np.hypot(*(p.at(ends[1]) - p.at(ends[0]))) for p in (poses[1], poses[-1])]
            total += float(apart[0] - apart[1]) * _times(s)
    shared = {n.text for m in every(tree, ast.Mirror) for n in m.sharing}
    mirrored = bool(every(tree, ast.Mirror))
    acts_on = next((s.point.text for s in every(tree, ast.Force) if s.name.text == name), "")
    return total * (2 if mirrored and acts_on not in shared else 1)


def _times(s):
    return evaluate(s.times, {}) if s.times else 1.0


def _tied(s):
    return next((n.name for n in _symbols(s.tie)), "") if s.tie else ""


def _symbols(node):
    match node:
        case ast.Symbol():
            if node.name[0].isupper():
                yield node
        case ast.Product(factors):
            for _, factor in factors:
                yield from _symbols(factor)


def places(compilation, values):
    """Return where the compiler puts the points: a start for the iteration, no more."""
    full = dict(values)
    for definition in compilation.pose.definitions:
        full[definition.name] = number(definition.formula, full)
    for name in compilation.pose.placeholders:
        full.setdefault(name, 0.1)
    pose = compilation.pose
    edges = [*geometry_check._links(pose, full), *geometry_check._vectors(pose, full)]
    found = placed(edges)
    starts = {p: tuple(place.at) for p, place in found.items() if p}
    for slot in pose.mechanism.each(Slot):
        starts.setdefault(slot.head, starts[slot.point])
    return starts
