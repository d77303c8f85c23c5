"""Friction, from coordinates, for tests only: loads of a friction of 1 against each slip.

Which way surfaces slip is stated by the motion that singular values find.
"""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from mechc.syntax import ast
from reference_geometry import cylinders, evaluate, every, points_of
from reference_kinematics import Array, Motion

if TYPE_CHECKING:
    from reference_forces import Forces

RimFriction = ast.GearFriction | ast.BeltFriction | ast.RackFriction


class FrictionPair(NamedTuple):
    """Two surfaces: what presses them, and the loads of a friction of 1 with the motion."""

    factor: float
    pressing: tuple[int, ...]
    dragged: Array


class FrictionPairs:
    """The surfaces with friction where a load drives along its arrow."""

    def __init__(self, forces: "Forces", drive: str) -> None:
        self._forces, self._motion = forces, Motion(forces.half)
        self._tree, self._values, self._half = forces.tree, forces.values, forces.half
        assert self._motion.basis.shape[1] == 1, "friction is asked of one motion"
        self._move = self._motion.basis[:, 0]
        power = forces.loads[drive] @ self._spread()
        assert abs(power) > 1e-9, "the drive does no work"
        self._move = self._move * math.copysign(1.0, power)
        self._rates = self._spread()

    def _spread(self) -> Array:
        """Return the velocities of all rows, in the half that is described."""
        rows = np.zeros(self._forces.height)
        for body, places in self._half.links.items():
            at = self._forces.rows[body]
            rows[at + 2] = self._motion.turning(body) @ self._move
            for point in places:
                at = self._forces.points[point]
                rows[at : at + 2] = self._motion.velocity(point, body) @ self._move
        return rows

    def all(self) -> Iterator[FrictionPair]:
        named = {s.point.text for s in every(self._tree, ast.PinFriction) if s.point}
        for s in self._tree.statements:
            match s:
                case ast.PinFriction(point=None):
                    for point in self._pins() - named:
                        yield from self._pin(point, "", s)
                case ast.PinFriction(point=point):
                    on = self._forces.link(s.link.text) if s.link else ""
                    yield from self._pin(point.text, on, s)
                case ast.GuideFriction(point=point) | ast.RollerFriction(point=point):
                    yield from self._guide(point.text, self._resistance(s))
                case ast.ContactFriction(point=point, coefficient=f):
                    yield from self._face(point.text, evaluate(f, self._values))
                case ast.GearFriction() | ast.BeltFriction() | ast.RackFriction():
                    yield self._rim(s)
                case ast.ScrewFriction():
                    yield self._thread(s)

    def _pins(self) -> set[str]:
        links = [points_of(s.points.text) for s in every(self._tree, ast.Link)]
        links += [ends for _, *ends in cylinders(self._tree)]
        often = [p for points in links for p in points]
        return {p for p in often if often.count(p) > 1 or p in self._carried_by_ground()}

    def _carried_by_ground(self) -> set[str]:
        slides = {p for n in self._half.slides for p in self._half.links[n]}
        fixed = {s.point.text for s in every(self._tree, ast.Pivot)}
        return fixed | {s.point.text for s in every(self._tree, ast.Slider)} | slides

    def _pin(self, point: str, on: str, s: ast.PinFriction) -> Iterator[FrictionPair]:
        f, d = (evaluate(x, self._values) for x in (s.coefficient, s.diameter))
        radius = d / 2 * (math.sin(math.atan(f)) if s.law == "coulomb" else f)
        links = [k.points.text for k in every(self._tree, ast.Link)]
        first = {name: start for name, start, _ in cylinders(self._tree)}
        links = [k for k in (*links, *first) if point in points_of(k)]
        carrier = on or ("" if point in self._carried_by_ground() else links[0])
        for link in links:
            if link == carrier:
                continue
            slip = self._motion.turning(link) - (self._motion.turning(carrier) if carrier else 0)
            sense = sign(slip @ self._move)
            for twin, turn in (("", 1), ("'", -1)):
                body = link + twin
                if body in self._forces.rows:
                    effect = self._forces.on_body(body, 0, 0, sense * turn)
                    if carrier:
                        other = carrier + twin if carrier + twin in self._forces.rows else carrier
                        effect = effect - self._forces.on_body(other, 0, 0, sense * turn)
                    at = point if not twin or point in self._forces.shared else point + "'"
                    held = at if ("pin", body, at, "x") in self._forces.columns else first[link]
                    pressing = (self._forces.columns["pin", body, held, axis] for axis in "xy")
                    yield FrictionPair(radius, tuple(pressing), effect)

    def _resistance(self, s: ast.GuideFriction | ast.RollerFriction) -> float:
        f = evaluate(s.coefficient, self._values)
        if isinstance(s, ast.RollerFriction):
            return f * evaluate(s.axle, self._values) / evaluate(s.wheel, self._values)
        if s.length is None or s.overhang is None:
            return f
        out, long = (evaluate(x, self._values) for x in (s.overhang, s.length))
        match s.law:
            case "linear":
                return f * (3 * out / long + long / (12 * out) if out > long / 6 else 1)
            case "edges":
                return f * max(2 * out / long, 1)
            case _:
                return f * 3 * out / long

    def _guide(self, point: str, factor: float) -> Iterator[FrictionPair]:
        shared = self._forces.shared | {
            n.text for c in every(self._tree, ast.Copies) for n in c.sharing
        }
        body = self._sliding(point)
        if (set(self._half.links[body]) if body else {point}) <= shared:
            return
        along = self._half.slides[body] if body else self._half.guides[point]
        sense = sign(np.array([along.real, along.imag]) @ self._motion.velocity(point) @ self._move)
        for twin in ("", "'"):
            name, other = point + twin, body + twin
            if body and other in self._forces.rows:
                line = self._forces.assembly.slides[other]
                effect = self._forces.on_body(other, sense * line, 0)
                yield FrictionPair(factor, (self._forces.columns["slide", other],), effect)
            elif not body and name in self._forces.points:
                line = self._forces.assembly.guides[name]
                effect = self._forces.on_point(name, sense * line)
                yield FrictionPair(factor, (self._forces.columns["guide", name],), effect)

    def _sliding(self, point: str) -> str:
        """Return the body that slides with a point; a point may slide by itself."""
        return next((n for n in self._half.slides if point in self._half.links[n]), "")

    def _face(self, point: str, factor: float) -> Iterator[FrictionPair]:
        touch = next(t for t in self._half.contacts if t.pin == point)
        slip = self._motion.velocity(point) - self._motion._velocity_at(touch.body, touch.place)
        face = 1j * touch.normal
        sense = sign(np.array([face.real, face.imag]) @ slip @ self._move)
        for pin, body, normal, place in self._forces.assembly.contacts:
            if pin in (point, point + "'"):
                line = 1j * normal * sense * (1 if (pin, body) == touch[:2] else -1)
                effect = self._forces.on_point(pin, line) - self._forces.on_body(body, line, place)
                yield FrictionPair(factor, (self._forces.columns["touch", pin, body],), effect)

    def _rolling(self, kind: type, point: str) -> tuple[int, ast.Statement]:
        """Return where rims roll on one another, among all of them, and the statement."""
        kinds = (ast.Gear, ast.Belt, ast.Rack, ast.Screw)
        pairs = [s for s in self._tree.statements if isinstance(s, kinds)]
        names = [s.first.text if isinstance(s, kinds[:2]) else s.point.text for s in pairs]
        return next((i, s) for i, s in enumerate(pairs) if (type(s), names[i]) == (kind, point))

    def _rim(self, s: RimFriction) -> FrictionPair:
        """Teeth hold back the wheel that is named first, at its rim, or the rack."""
        kinds = {ast.GearFriction: ast.Gear, ast.BeltFriction: ast.Belt, ast.RackFriction: ast.Rack}
        place, pair = self._rolling(kinds[type(s)], s.point.text)
        if isinstance(pair, ast.Rack):
            effect = self._ahead(s.point.text)
        else:
            rolling = self._forces.assembly.rollings[place]
            radius = evaluate(pair.first_radius, self._values)
            effect = self._forces.on_body(rolling.first, 0, 0, radius)
            effect -= self._forces.on_body(rolling.arm, 0, 0, radius)
        effect = effect * sign(effect @ self._rates)
        pressing = (self._forces.columns["roll", str(place)],)
        return FrictionPair(evaluate(s.coefficient, self._values), pressing, effect)

    def _thread(self, s: ast.ScrewFriction) -> FrictionPair:
        """The axial force F presses with F/cos ψ, and friction acts along the thread, at ψ."""
        place, screw = self._rolling(ast.Screw, s.point.text)
        diameter = evaluate(s.thread, self._values)
        slope = math.atan(evaluate(screw.pitch, self._values) / (math.pi * diameter))
        couple = self._forces.on_body(screw.link.text, 0, 0, math.cos(slope) * diameter / 2)
        effect = (couple + math.sin(slope) * self._ahead(s.point.text)) / math.cos(slope)
        effect = effect * sign(effect @ self._rates)
        pressing = (self._forces.columns["roll", str(place)],)
        return FrictionPair(evaluate(s.coefficient, self._values), pressing, effect)

    def _ahead(self, point: str) -> Array:
        """Return a force of 1 along the guide of a point."""
        body = self._sliding(point)
        return self._forces.on_point(
            point, self._half.slides[body] if body else self._half.guides[point]
        )


def sign(value: float) -> float:
    """Return the sign of a slip; 0 for what is only rounding."""
    return math.copysign(1.0, value) if abs(value) > 1e-9 else 0.0
