"""Forces at joints from coordinates, for tests only: every body by itself, in equilibrium.

Each body has three equations and each pin two; what stands on a pin, links, ground, guide
and loads, meets there. All of them are one dense matrix, solved by least squares. Friction
makes the equations nonlinear: couples and forces of the size of what presses, against slips
whose signs are those of the motion by singular values. Newton's method takes the friction
up from nothing, step by step. Nothing is shared with the compiler but the syntax tree.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

import numpy as np

from mechc.syntax import ast
from reference_friction import FrictionPair, FrictionPairs
from reference_geometry import (
    Action,
    Arms,
    Values,
    angle_of,
    arms_of,
    assemble,
    assemble_half,
    cylinders,
    evaluate,
    every,
    known_spread,
    points_of,
)
from reference_kinematics import GRAVITY, Array, null_space

Weights = Mapping[tuple[str, ...], float]
"""A force at a joint as a combination of unknowns."""


def arms_at(places: Mapping[str, Sequence[float]]) -> Arms:
    """Return all vectors between points whose places are known."""
    arms = Arms({}, {})
    for tail, start in places.items():
        for head, end in places.items():
            x, y = end[0] - start[0], end[1] - start[1]
            if (x or y) and (head, tail) not in arms.angles:
                arms.set_length(tail, head, math.hypot(x, y))
                arms.set_angle(tail, head, math.atan2(y, x))
    return arms


class Forces:
    """The equilibrium of a description at given values."""

    def __init__(self, tree: ast.File, values: Values, arms: Arms | None = None) -> None:
        self.tree, self.values = tree, values
        self.arms = arms or arms_of(tree, values)
        self.assembly = assemble(tree, values, arms=arms)
        self.half = assemble_half(tree, values, arms=arms)
        self.shared = {n.text for m in every(tree, ast.Mirror) for n in m.sharing}
        self.copies = [evaluate(c.number, values) for c in every(tree, ast.Copies)]
        bodies = self.assembly.links
        carried = dict.fromkeys(p for places in bodies.values() for p in places)
        points = dict.fromkeys([*carried, *sorted(self.assembly.pivots)])
        self.rows = {name: 3 * i for i, name in enumerate(bodies)}
        self.points = {p: 3 * len(bodies) + 2 * i for i, p in enumerate(points)}
        self.height = 3 * len(bodies) + 2 * len(points)
        self.columns: dict[tuple[str, ...], int] = {}
        self.matrix = np.array([self._column(*u) for u in self._unknowns()]).T
        self.loads = self._loads()

    # ---------------------------------------------------------------- free bodies

    def _column(self, key: tuple[str, ...], effect: Array) -> Array:
        self.columns[key] = len(self.columns)
        return effect

    def on_point(self, point: str, force: complex) -> Array:
        """Return the terms of a force on a pin in the equations."""
        effect = np.zeros(self.height)
        at = self.points[point]
        effect[at : at + 2] = force.real, force.imag
        return effect

    def on_body(self, body: str, force: complex, arm: complex, couple: float = 0.0) -> Array:
        """Return the terms of a force and a couple on a body in the equations; '' is the ground."""
        effect = np.zeros(self.height)
        if not body:
            return effect
        moment = (arm.conjugate() * force).imag + couple
        at = self.rows[body]
        effect[at : at + 3] = force.real, force.imag, moment
        return effect

    def _unknowns(self) -> Iterator[tuple[tuple[str, ...], Array]]:
        whole = self.assembly
        for body, places in whole.links.items():
            for point, arm in places.items():
                for axis, unit in (("x", 1), ("y", 1j)):
                    effect = self.on_body(body, unit, arm) - self.on_point(point, unit)
                    yield ("pin", body, point, axis), effect
        for point in sorted(whole.pivots):
            for axis, unit in (("x", 1), ("y", 1j)):
                yield ("ground", point, axis), self.on_point(point, unit)
        for point, along in whole.guides.items():
            if point not in whole.slides:
                yield ("guide", point), self.on_point(point, 1j * along)
        for body, along in whole.slides.items():
            yield ("slide", body), self.on_body(body, 1j * along, 0)
            yield ("couple", body), self.on_body(body, 0, 0, 1)
        for pin, body, normal, place in whole.contacts:
            effect = self.on_point(pin, normal) - self.on_body(body, normal, place)
            yield ("touch", pin, body), effect
        for i, pulls in enumerate(whole.ropes):
            yield ("rope", str(i)), sum(self.on_point(p, pull) for p, pull in pulls.items())
        led = self._led()
        for i, (first, at, second, there, along, _) in enumerate(whole.rollings):
            point = led[i] if i < len(led) else ""
            ahead = self.on_point(point, along) if point else self.on_body(first, along, at)
            yield ("roll", str(i)), ahead - self.on_body(second, along, there)

    def _led(self) -> list[str]:
        """Return the slider of each rack and screw, which no link carries; "" for the others."""
        kinds = (ast.Gear, ast.Belt, ast.Rack, ast.Screw)
        pairs = (s for s in self.tree.statements if isinstance(s, kinds))
        points = [s.point.text if isinstance(s, kinds[2:]) else "" for s in pairs]
        return [p if p in self.assembly.guides else "" for p in points]

    # ---------------------------------------------------------------------- loads

    def _loads(self) -> dict[str, Array]:
        """Return the terms of a unit of each load, those tied to others taken apart."""
        part = 1 / self.copies[0] if self.copies else 1.0
        effects: dict[str, Array] = {}
        for load in (*self.assembly.actions, *self._thrusts()):
            effect = part * load.times * self._effect(load)
            effects[load.name] = effects.get(load.name, np.zeros(self.height)) + effect
        for s in (*every(self.tree, ast.Force), *every(self.tree, ast.Torque)):
            if s.tie is not None:
                owner, factor = self._owner(s.tie, effects)
                effects[owner] = effects[owner] + factor * effects.pop(s.name.text)
        return effects

    def _effect(self, load: Action) -> Array:
        if load.direction is None:
            return self.on_body(load.at, 0, 0, 1)
        if load.at in self.rows:
            return self.on_body(load.at, load.direction, 0)
        return self.on_point(load.at, load.direction)

    def _owner(self, tie: ast.Expr, loads: Mapping[str, Array]) -> tuple[str, float]:
        known = {**self.values, **dict.fromkeys(loads, 0.0)}
        parts = {n: evaluate(tie, {**known, n: 1.0}) for n in loads}
        return next((n, part) for n, part in parts.items() if part)

    def _thrusts(self) -> Iterator[Action]:
        for s in (*every(self.tree, ast.Actuator), *every(self.tree, ast.Spring)):
            first, second = s.first.text, s.second.text
            name = s.name.text if isinstance(s, ast.Actuator) else f"S_{first}{second}"
            times = evaluate(s.times, self.values) if s.times else 1.0
            times *= self.copies[0] if self.copies else 1.0
            if second == first + "'":
                apart = self._across(first)
            else:
                apart = self.arms.between(first, second)
            apart /= abs(apart)
            pushes = [(second, apart), (first, -apart)]
            for body, start, end in cylinders(self.tree):
                if {start, end} == {first, second}:
                    pushes = [(p if p == end else body, v) for p, v in pushes]
            if self.shared and second != first + "'":
                axis = self._axis()
                twin = {p: p if p in self.shared else p + "'" for p in (first, second)}
                if twin[first] != first or twin[second] != second:
                    pushes += [(twin[p], axis * axis * v.conjugate()) for p, v in pushes]
            yield from (Action(name, point, push, times) for point, push in pushes)

    def _axis(self) -> complex:
        (mirror,) = every(self.tree, ast.Mirror)
        angle = angle_of(mirror.across, self.values, self.arms)
        return complex(math.cos(angle), math.sin(angle))

    def _across(self, point: str) -> complex:
        """Return the vector from a point to its twin."""
        axis = self._axis()
        from_line = self.arms.between(next(iter(self.shared)), point)
        return axis * axis * from_line.conjugate() - from_line

    def known(self) -> Values:
        """Return the sizes of weights and springs."""
        g = self.values.get("g", GRAVITY)
        found = {
            w.name.text: evaluate(w.mass, self.values) * g for w in every(self.tree, ast.Weight)
        }
        found |= known_spread(self.tree, self.values, self.arms)
        for s in every(self.tree, ast.Spring):
            first, second = s.first.text, s.second.text
            free, rate = (evaluate(x, self.values) for x in (s.free, s.rate))
            apart = self._across if second == first + "'" else self.arms.between
            length = abs(apart(first) if second == first + "'" else apart(first, second))
            found[f"S_{first}{second}"] = rate * (free - length)
        return found

    # ------------------------------------------------------------------ what is asked

    def weights(self, name: str, on: str = "") -> list[Weights]:
        """Return the force of ``R_O``, ``R_B`` on AB, ``N_AB``, ``N_K`` by unknowns."""
        kind, points = name.split("_", 1)
        if kind == "R" and on:
            return [{("pin", self.link(on), points, axis): 1.0} for axis in "xy"]
        if kind == "R":
            return self._ground(points)
        ends = points_of(points)
        if len(ends) == 1:
            return [self._normal(points)]
        if (rope := self._rope(ends)) is not None:
            return [{("rope", str(rope)): 1.0}]
        link = self.link(points)
        arm = self.half.links[link][ends[1]] - self.half.links[link][ends[0]]
        unit = arm / abs(arm)
        parts = (("x", unit.real), ("y", unit.imag))
        return [{("pin", link, ends[1], axis): part for axis, part in parts}]

    def _rope(self, ends: Sequence[str]) -> int | None:
        """Return the number of the rope that runs between two points, None where none does."""
        for i, rope in enumerate(every(self.tree, ast.Rope)):
            route = [rope.start.text, *(point.text for point, _ in rope.falls)]
            if {*ends} in [{*fall} for fall in pairwise(route)]:
                return i
        return None

    def link(self, part: str) -> str:
        """Return the link that has these points."""
        wanted = set(points_of(part))
        return next(n for n in self.half.links if wanted <= set(points_of(n)))

    def _ground(self, point: str) -> list[Weights]:
        if point in self.assembly.pivots:
            return [{("ground", point, axis): 1.0} for axis in "xy"]
        normal = 1j * self.assembly.guides[point]
        column = ("guide", point) if ("guide", point) in self.columns else ("slide", point)
        return [{column: normal.real}, {column: normal.imag}]

    def _normal(self, point: str) -> Weights:
        bodies = [n for n in self.assembly.slides if point in points_of(n)]
        choices = [("touch", *t[:2]) for t in self.half.contacts if t.pin == point]
        choices += [("guide", point), *(("slide", b) for b in bodies)]
        return {next(c for c in choices if c in self.columns): 1.0}

    def friction_pairs(self, drive: str) -> list[FrictionPair]:
        """Return all surfaces with friction, in both halves, where a load drives as drawn."""
        return [pair for pair in FrictionPairs(self, drive).all() if pair.factor]

    # -------------------------------------------------------------------- solving

    def solve(
        self, drive: str, given: Values, sense: int = 0, steps: int = 8
    ) -> tuple[Array, float]:
        """Return all unknowns, the driving load last, and the condition of the equations.

        ``sense`` is 1 where the drive moves along its arrow, -1 against it, 0 without friction.
        """
        matrix = np.column_stack([self.matrix, self.loads[drive]])
        right = -sum((size * self.loads[n] for n, size in given.items()), np.zeros(self.height))
        pairs = self.friction_pairs(drive) if sense else []
        found = np.linalg.lstsq(matrix, right, rcond=1e-11)[0]
        jacobian = matrix
        for part in np.linspace(1 / steps, 1, steps) if pairs else ():
            for _ in range(40):
                gap = matrix @ found - right
                jacobian = matrix.copy()
                for pair in pairs:
                    loaded = found[list(pair.pressing)]
                    size = float(np.linalg.norm(loaded))
                    against = -sense * part * pair.factor * pair.dragged
                    gap = gap + against * size
                    slope = loaded / size if size else 0 * loaded
                    for column, each in zip(pair.pressing, slope, strict=True):
                        jacobian[:, column] += against * each
                step = np.linalg.lstsq(jacobian, -gap, rcond=1e-11)[0]
                found = found + step
                if np.abs(step).max() <= 1e-14 * np.abs(found).max():
                    break
        self._check(found, matrix, right, pairs, sense)
        sizes = np.linalg.svd(jacobian, compute_uv=False)
        return found, float(sizes[0] / min(s for s in sizes if s > 1e-10 * sizes[0]))

    def _check(
        self, found: Array, matrix: Array, right: Array, pairs: Sequence[FrictionPair], sense: int
    ) -> None:
        """Put the solution into the equilibrium of every body once more."""
        gap = matrix @ found - right
        for pair in pairs:
            gap = gap - sense * pair.factor * pair.dragged * np.linalg.norm(
                found[list(pair.pressing)]
            )
        if np.abs(gap).max() > 1e-11 * np.abs(found).max():
            raise NoBalance(f"gap of {np.abs(gap).max()}")

    def value(self, found: Array, weights: Weights) -> float:
        """Return a force at a joint."""
        return math.fsum(found[self.columns[key]] * part for key, part in weights.items())

    def is_open(self, drive: str, weights: Weights) -> bool:
        """Tell whether equilibrium leaves a force at a joint open."""
        modes = null_space(np.column_stack([self.matrix, self.loads[drive]]))
        row = sum(modes[self.columns[key]] * part for key, part in weights.items())
        return bool(np.abs(row).max() > 1e-7) if modes.size else False


class NoBalance(Exception):
    """The equations have no solution there: locked, or too much friction."""
