"""Signs of slips and forces as names that code computes, at whatever pose it is given."""

from collections.abc import Sequence, Set

from ...algebra.angle import Angle
from ...algebra.factors import Factor, Length
from ...algebra.product import Product
from ...formula.tree import Call, Formula
from ..naming import Meanings
from .names import Inverse, SignNames, bare
from .senses import sense_of


class AtAnyPose(SignNames):
    """Signs and turns as names with formulas of their own."""

    is_read = False

    def __init__(self, taken: Set[str], meanings: Meanings, endings: Sequence[str]) -> None:
        super().__init__(taken, meanings, endings)
        self._own: set[Factor] = set()

    def name_radius(self, name: str, factor: Product) -> Product:
        """Return the radius as it is."""
        return factor

    def name_coefficient(self, name: str, factor: Product) -> Product:
        """Return the coefficient as it is."""
        return factor

    def note_sign(self, name: str, value: Product) -> Product:
        """Return the name of the sign, with a minus for that of the opposite."""
        signed = bare(value)
        if not signed.factors:
            return signed
        factors = Product(1, signed.factors)
        return self._defined(name, Call("sign", (factors.formula(),)), signed)

    def way(self, value: Product) -> int:
        """Return the sign of what stands before a value."""
        return -1 if value.coefficient < 0 else 1

    def note_sense(self, name: str, slip: Product) -> Product:
        """Return the name of the sense, with a minus for that of the opposite."""
        signed = bare(slip)
        if not signed.factors:
            return signed
        sense = sense_of(slip.scaled(signed.coefficient))
        if not isinstance(sense, Call):
            return Product(signed.coefficient)
        return self._defined(name, sense, signed)

    def _defined(self, name: str, sign: Formula, signed: Product) -> Product:
        known = self.define(name, sign)
        self._own.add(Length(known))
        return Product.symbol(known).scaled(signed.coefficient)

    def turn_line(self, name: str, line: Angle, by: Inverse, value: Product) -> Angle:
        """Return the line turned by a named angle, which carries its sign."""
        return self.turn(name, line, by, self.unsquared(value)) if value else line

    def unsquared(self, value: Product) -> Product:
        """Return a product without the squares of signs, which are 1 but at single poses."""
        odd = {f: e for f, e in value.factors.items() if e % 2 or f not in self._own}
        return Product(value.coefficient, {f: 1 if f in self._own else e for f, e in odd.items()})

    def note_arm_beyond(self, arm: Product, radius: Product, ahead: Product) -> bool:
        """Return False: code asks at each pose whether a force turns a lever."""
        return False

    def note_alike(self, value: Product, other: Product) -> None:
        """Do nothing: code has the sign of a value from that."""

    def require_positive(self, value: Product) -> bool:
        """Return True: code asks at each pose whether a value is positive."""
        return True
