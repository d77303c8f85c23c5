"""The sides and angles of a dyad under names, with the definitions that these need."""

from collections.abc import Callable, Iterable
from fractions import Fraction

from ...algebra.angle import Angle
from ...algebra.from_formula import to_angle
from ...algebra.product import Product
from ...algebra.trigonometry import cosine
from ...formula.tree import Call, Formula, Sum, negative, total
from ..pose import Arm, Definition, Vector, components, gathered
from ..samples import Values, is_behind
from ..vector_graph import Names, known_span, mentioned
from .dyads import Loop
from .triangle import common_turn, is_of_vector, is_same_angle

HALF_TURN = Angle.constant(180)

Namer = Callable[[str], str]
"""Makes a name that nothing else has."""


def _halved(vector: Vector) -> Arm | None:
    """Return the sum of two vectors of one length: along the line that halves their angle."""
    if len(vector) != 2:
        return None
    (length, one), (other_length, other) = vector
    if length == -other_length:
        other += HALF_TURN
    elif length != other_length:
        return None
    half = Fraction(1, 2)
    size = length.scaled(2) * cosine((one - other) * half)
    return Arm(size, (one + other) * half)


class Sides:
    """Names sides and angles; ``definitions`` are those that the names given so far need.

    ``kept`` are unknowns that the user named, ``fixed`` the pivots, ``values`` a pose.
    ``signed`` lengths may be negative somewhere on the stroke; ``defined`` was found before.
    ``again`` are names of angles found before that are those of this triangle, too.
    """

    def __init__(
        self,
        name: Namer,
        kept: Names,
        fixed: Names,
        values: Values,
        signed: Names = frozenset(),
        defined: Iterable[Definition] = (),
    ) -> None:
        self.name, self.kept, self.fixed = name, kept, fixed
        self._values, self._signed = values, signed
        self._defined = tuple(defined)
        self._vectors = {d.name for d in self._defined if is_of_vector(d.formula)}
        self.definitions: list[Definition] = []
        self.again: set[str] = set()

    def polar(self, vector: Vector, name: str, positive: bool = False) -> tuple[Product, Angle]:
        """Return a vector as one length and one direction, both named where it is a sum.

        What turns as one body has a direction within it, ``delta``, that does not turn.
        A difference or a place on a line is turned round where it is negative at the default
        pose. What must be ``positive`` elsewhere, too, turns round where it passes zero.
        """
        if len(vector) == 1 and not (positive and self._may_turn(vector[0].length)):
            length, angle = vector[0]
            behind = is_behind(length, [self._values])
            return (-length, angle + HALF_TURN) if behind else (length, angle)
        if not positive and (halved := _halved(vector)):
            return self.polar((halved,), name)
        turn = common_turn(vector)
        within = gathered(Arm(arm.length, arm.angle - turn) for arm in vector)
        parts = tuple(p.formula() for p in components(within))
        size = self.name(f"len_{name}")
        way = self.name(f"delta_{name}" if turn.terms else size.replace("len", "phi", 1))
        self.definitions.append(Definition(size, Call("hypot", parts)))
        self.definitions.append(Definition(way, Call("atan2", parts[::-1])))
        return Product.symbol(size), turn + Angle.of(way)

    def _may_turn(self, length: Product) -> bool:
        return not self._signed.isdisjoint(mentioned((Arm(length, Angle()),)))

    def known_side(self, loop: Loop, positive: bool) -> tuple[Product, Angle]:
        """Return the known side of the loop; one that has a name keeps it, whatever leads there."""
        ends = known_span(loop.cycle, loop.unknown)
        for tail, head, turn in ((*ends, Angle()), (*ends[::-1], HALF_TURN)) if ends else ():
            size, way = f"len_{tail}{head}", f"phi_{tail}{head}"
            if len(loop.known) > 1 and {size, way} <= self._vectors:
                return Product.symbol(size), Angle.of(way) + turn
        around = dict.fromkeys(e.tail for e in loop.cycle)
        name = "".join(ends or around) or "0"
        return self.polar(loop.known, name, positive)

    def angle(self, letter: str, of: str, formula: Formula) -> Angle:
        """Return an angle of the triangle under a name of its own, or of a congruent triangle."""
        known = (
            d for d in (*self._defined, *self.definitions) if is_same_angle(d.formula, formula)
        )
        named = next(known, None)
        if named is None:
            named = Definition(self.name(f"{letter}_{of}"), formula)
            self.definitions.append(named)
        elif named not in self.definitions:
            self.again.add(named.name)
        return Angle.of(named.name)

    def turn_by(self, formula: Formula) -> Angle | None:
        """Return an angle as the turn between two directions that a congruent triangle has.

        None where there is none: ``phi_AB = phi_OA + 180° − formula`` is one.
        """
        for name, found in self._defined:
            *lead, last = found.terms if isinstance(found, Sum) else (found,)
            outside = to_angle(total(lead))
            for sign in (1, -1):
                turn = last if sign > 0 else negative(last)
                if lead and outside and is_same_angle(turn, formula):
                    self.again.add(name)
                    return (Angle.of(name) - outside) * sign
        return None
