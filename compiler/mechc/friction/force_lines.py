"""The lines along which bodies act on each other, turned by the friction between them.

A rod's force is along the common tangent of the friction circles at its ends, that on a face
along the normal turned by the angle of friction. Neither depends on how large the forces are.
"""

from collections.abc import Iterator

from ..algebra.angle import HALF_TURN, Angle
from ..algebra.product import ONE, ZERO, Product
from ..algebra.sums import add
from ..model.mechanism import Link, Rack
from ..pose.pose import PointContact
from . import surfaces
from .chain_bodies import Bodies, BodyForce, pitch, under
from .friction_pairs import radii, reduced
from .notes import Notes
from .signs.names import SignSymbols
from .surfaces import Surface


class ForceLines:
    """The forces on each body under a unit of their size; each line is found, and noted, once."""

    def __init__(self, bodies: Bodies, signs: SignSymbols, sense: int, notes: Notes) -> None:
        self._bodies, self._signs, self._sense, self._notes = bodies, signs, sense, notes
        self._radii = radii(p.pair for p in bodies.task.loaded)
        self._lines: dict[str, Angle] = {}
        self._senses: dict[str, Product] = {}

    def on(self, body: str) -> Iterator[BodyForce]:
        """Yield the forces on a body, those of rods under a unit of force."""
        yield from self._bodies.loads_on(body)
        for rod, point in self._bodies.rods_at(body):
            yield self.of_rod(rod, point)
        for contact, is_under in self._bodies.contacts_at(body):
            line = self._face(contact)
            place, ahead = (under(contact), line + HALF_TURN) if is_under else (contact.point, line)
            yield BodyForce(f"R_{contact.point}", place, ahead)
        for rack, is_wheel in self._bodies.racks_at(body):
            along = self._bodies.pose.moved_along(rack.point)
            if is_wheel:
                yield BodyForce(f"S_{rack.point}", pitch(rack), along + HALF_TURN)
            else:
                yield BodyForce(f"S_{rack.point}", rack.point, along, self._passed_on(rack))

    def of_rod(self, rod: Link, point: str) -> BodyForce:
        """Return the force of a rod, under a unit axial force, on the body at a point."""
        line, surface = self._line(rod), surfaces.of_rod(self._bodies, rod, point)
        sense, counted = self.sense_of(rod), self.counted(rod)
        couple = sense * counted * self.resistance(surface) if surface else ZERO
        is_ahead = (point == rod.points[1]) == (counted == ONE)
        return BodyForce(
            f"S_{rod.name}", point, line if is_ahead else line + HALF_TURN, ONE, couple
        )

    def counted(self, rod: Link) -> Product:
        """Return 1 where compression counts as positive, -1 where people read of tension."""
        is_tension = self._signs.is_read and self.sense_of(rod) == -ONE
        return -ONE if is_tension else ONE

    def _line(self, rod: Link) -> Angle:
        """Return the line of a rod's force: the tangent of the friction circles at its ends."""
        if rod.name not in self._lines:
            self._lines[rod.name] = self._tangent(rod)
        return self._lines[rod.name]

    def _tangent(self, rod: Link) -> Angle:
        """Return the common tangent of a rod's friction circles, and note how it was found.

        The sine of its angle to the rod is what the radii come to together, over the length.
        """
        direction, length = self._bodies.vector(rod)
        resistances = self._resistances(rod)
        offset = add(resistances.values())
        turn = -(self.sense_of(rod) * offset) / length if offset else ZERO
        tangent = self._signs.turn_line(f"delta_{rod.name}", direction, "asin", turn)
        if resistances and self._signs.is_read:
            self._notes.rod(rod, self.sense_of(rod), resistances, turn)
        return tangent

    def _resistances(self, rod: Link) -> dict[str, Product]:
        """Return the friction of the pins on which a rod turns, by their points."""
        found = ((p, self.resistance(surface)) for p, surface in self.surfaces(rod).items())
        return {p: resistance for p, resistance in found if resistance}

    def _face(self, contact: PointContact) -> Angle:
        """Return the line of the force on a pin: the normal turned by the angle of friction."""
        name, surface = f"R_{contact.point}", surfaces.of_face(self._bodies, contact)
        if surface and name not in self._lines:
            side = self._signs.note_sign(f"s_{contact.point}", surface.across)
            turn = -(self.resistance(surface) * side)
            label = f"phi_{contact.point}"
            self._lines[name] = self._signs.turn_line(label, contact.normal, "atan", turn)
            if self._signs.is_read:
                self._notes.face(contact.point)
        return self._lines.get(name, contact.normal)

    def _passed_on(self, rack: Rack) -> Product:
        """Return the part of a gear's force that its rack gets, friction in the teeth taken off."""
        surface = surfaces.of_rack(self._bodies, rack)
        if surface is None:
            return ONE
        side = self._signs.note_sign(f"s_{rack.point}", surface.across)
        return add((ONE, -(self.resistance(surface) * side)))

    def surfaces(self, rod: Link) -> dict[str, Surface]:
        """Return the frictions of a rod, by the ends at which it has any."""
        ends = ((p, surfaces.of_rod(self._bodies, rod, p)) for p in rod.points)
        return {p: surface for p, surface in ends if surface}

    def sense_of(self, rod: Link) -> Product:
        """Return the sign of a rod's force in the ideal mechanism, 1 for compression."""
        if rod.name not in self._senses:
            force = surfaces.compression(self._bodies, rod)
            self._senses[rod.name] = self._signs.note_sign(f"s_{rod.name}", force)
        return self._senses[rod.name]

    def resistance(self, surface: Surface) -> Product:
        """Return the factor of friction with the sign of the slip."""
        return self.factor(surface) * self.slip(surface)

    def factor(self, surface: Surface) -> Product:
        """Return the factor of friction, the radius of a friction circle by its name."""
        label = self._radii.get(surface.name)
        if label:
            return self._signs.name_radius(label, surface.factor)
        return self._signs.name_coefficient(reduced(surface.name), surface.factor)

    def slip(self, surface: Surface) -> Product:
        """Return the sign of the slip in the motion that is meant."""
        sign = self._signs.note_sense(f"sigma_{surface.name}", surface.slip)
        return sign.scaled(self._sense * surface.turn)
