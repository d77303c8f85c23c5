"""Friction in closed form, along a chain from the loads to the drive.

Free bodies are solved one after another, each with one force left unknown:

- a *rod* pushes along a line turned by arcsin((±ρ₁ ± ρ₂)/L), the common tangent of the
  friction circles at its ends;
- a *lever* balances moments about its pivot, whose friction makes that a quadratic;
- a *face*, of a slot or contact, pushes along its normal turned by the angle of friction;
- a *slider* balances along its guide, with the guide's factor times the force across;
- a *pin* between two rods balances both ways. Its friction is exact there only if both
  rods carry the same force, as in a symmetric toggle.

Where a body has more unknowns the chain ends (:class:`EquationsCoupled`): its equations are
coupled, and :mod:`.iterated` solves them.
"""

from collections.abc import Sequence
from typing import assert_never

from ..algebra.factors import Opaque
from ..algebra.product import ONE, ZERO, Product
from ..algebra.sums import add, canonical
from ..formula.tree import Formula
from ..model.mechanism import Link
from . import surfaces
from .chain_bodies import Bodies, BodyForce, BodyKind, EquationsCoupled
from .force_lines import ForceLines
from .lever_quadratic import LeverPivot, LeverSides, on_lever
from .notes import Notes
from .signs.conditions import SignCondition
from .signs.names import SignSymbols
from .solution import FrictionStep


class SequentialSolver:
    """Solves body after body; ``sizes`` are the forces known so far, in units of the load."""

    def __init__(self, bodies: Bodies, signs: SignSymbols, sense: int) -> None:
        self._bodies, task = bodies, bodies.task
        self._driving, self._signs = task.driving, signs
        self.sizes: dict[str, Product] = dict(task.given)
        self.conditions: list[SignCondition] = []
        self._notes = Notes(bodies, signs)
        self._given = task.given
        self._lines = ForceLines(bodies, signs, sense, self._notes)
        self._squared: dict[str, LeverSides] = {}
        self._forces: dict[str, list[BodyForce]] = {}

    @property
    def bodies(self) -> Bodies:
        """Return the free bodies that are solved."""
        return self._bodies

    @property
    def steps(self) -> list[FrictionStep]:
        """Return the steps taken so far."""
        return self._notes.steps

    def solve(self) -> Sequence[Product]:
        """Return the driving load alone. Raises :class:`EquationsCoupled` where the chain ends."""
        left = list(self._bodies.solvable())
        while self._driving not in self.sizes:
            body = next(filter(self._solves, left), None)
            if body is None:
                raise EquationsCoupled
            left.remove(body)
        return (canonical(self.sizes[self._driving]),)

    def _solves(self, body: str) -> bool:
        """Return whether a body has no more unknowns than equations; it is then solved."""
        kind, forces = self._bodies.kind(body), self.on(body)
        unknown = [p for p in forces if p.name not in self.sizes]
        if len(unknown) != (2 if kind == "pin" else 1):
            return False
        known = [p.scaled(self.sizes[p.name]) for p in forces if p.name in self.sizes]
        friction = self._balance(kind, body, unknown, known)
        if self._signs.is_read:
            free = [p.scaled(self._given.get(p.name) or Product.symbol(p.name)) for p in forces]
            found = {p.name: self.sizes[p.name] for p in unknown}
            self._notes.balance(kind, body, free, friction, found, self._squared.get(body))
        return True

    def on(self, body: str) -> list[BodyForce]:
        """Return the forces on a body, which do not change as their sizes are found."""
        if body not in self._forces:
            self._forces[body] = list(self._lines.on(body))
        return self._forces[body]

    def symbol(self, name: str) -> Formula:
        """Return the name of a force in the steps."""
        return self._notes.symbol(name)

    def of_rod(self, rod: Link, point: str) -> BodyForce:
        """Return the force of a rod, under a unit of its size, on the body at one of its pins."""
        return self._lines.of_rod(rod, point)

    def _balance(
        self, kind: BodyKind, body: str, unknown: Sequence[BodyForce], known: Sequence[BodyForce]
    ) -> Product:
        """Find the unknown sizes; return friction per unit of what presses, with its sign."""
        match kind:
            case "lever":
                return self._lever(body, unknown[0], known)
            case "slider":
                return self._slider(body, unknown[0], known)
            case "pin":
                return self._pin(body, unknown, known)
            case _:
                assert_never(kind)

    def _lever(self, body: str, unknown: BodyForce, known: Sequence[BodyForce]) -> Product:
        """Find the unknown force on a lever; return the resistance of its pivot."""
        surface, pivot = surfaces.of_pivot(self._bodies, body), self._bodies.pivot(body)
        lines, bearing = self._lines, None
        if surface:
            bearing = LeverPivot(pivot, lines.factor(surface), lines.slip(surface))
        arms = self._bodies.arms(body)
        size, turns, quadratic, alike = on_lever(unknown, known, arms, bearing, self._signs)
        if quadratic:
            self._squared[body] = quadratic
        self._determine(unknown, size, alike)
        if quadratic:
            self.conditions.append(SignCondition(ONE, turns))
        elif turns.factors:
            self._keep(ONE, turns)
        return lines.resistance(surface) if surface else ZERO

    def _slider(self, body: str, unknown: BodyForce, known: Sequence[BodyForce]) -> Product:
        """Σ F·(e − σ c n) = 0 along the guide e, n its normal on the side that is pressed.

        Which side that is does not depend on the guide's own friction, so it follows from
        the balance without that, in which the lines of rods and faces are turned already.
        """
        guide, surface = self._bodies.guide(body), surfaces.of_guide(self._bodies, body)
        against, side = ZERO, ZERO
        if not unknown.along(guide):
            raise EquationsCoupled
        if surface:
            free = -(add(p.along(guide) for p in known) / unknown.along(guide))
            pushed = add(p.across(guide) for p in (*known, unknown.scaled(free)))
            side = self._signs.note_sign(f"s_{body}", canonical(pushed))
            against = self._lines.resistance(surface) * side

        def along(force: BodyForce) -> Product:
            return add((force.along(guide), -(against * force.across(guide))))

        size = -(add(map(along, known)) / along(unknown))
        self._determine(unknown, size)
        if surface:
            pressing = add(p.across(guide) for p in (*known, unknown.scaled(size)))
            self._keep(side, pressing)
        return against

    def _pin(self, body: str, unknown: Sequence[BodyForce], known: Sequence[BodyForce]) -> Product:
        for one, other in (unknown, unknown[::-1]):
            if one.line is None or other.line is None or not one.across(other.line):
                raise EquationsCoupled
            parts = add(p.across(other.line) for p in known)
            self._determine(one, -(parts / one.across(other.line)))
        if surfaces.at_pin(self._bodies, body) and not self._are_alike(body):
            raise EquationsCoupled
        return ZERO

    def _are_alike(self, body: str) -> bool:
        """Return whether both rods at a pin carry the same force, whatever the pose."""
        rods = [rod for rod, _ in self._bodies.rods_at(body)]
        if len(rods) != 2:
            return False
        first, second = (self.sizes[f"S_{rod.name}"] for rod in rods)
        return not add((first * first, -(second * second)))

    def _determine(self, force: BodyForce, size: Product, alike: Product | None = None) -> None:
        """Note the size of a force, and the signs that it and friction where it acts must keep."""
        rod, size = self._bodies.rod(force.name), canonical(size)
        if force.name != self._driving and any(isinstance(f, Opaque) for f in size.factors):
            size = self._signs.name_value(force.name, size)
            if alike is not None:
                self._signs.note_alike(size, alike)
        self.sizes[force.name] = size
        if rod and self._lines.surfaces(rod):
            self._keep(self._lines.sense_of(rod) * self._lines.counted(rod), self.sizes[force.name])
        if surface := self._surface_of(force.name):
            side = self._signs.note_sign(f"s_{force.name.partition('_')[2]}", surface.across)
            self._keep(side, self.sizes[force.name])

    def _surface_of(self, force: str) -> surfaces.Surface | None:
        """Return the friction of the face, or of the teeth of a rack, on which a force acts."""
        if contact := self._bodies.contact(force):
            return surfaces.of_face(self._bodies, contact)
        rack = self._bodies.rack(force)
        return surfaces.of_rack(self._bodies, rack) if rack else None

    def _keep(self, sign: Product, force: Product) -> None:
        """Note that a force keeps its ideal sign; one that only friction brings about has none."""
        if not force:
            return
        if not sign or not self._signs.require_positive(sign * force):
            raise EquationsCoupled
        self.conditions.append(SignCondition(sign, force))
