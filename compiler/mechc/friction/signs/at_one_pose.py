"""Signs of slips and forces as they are at one pose: of a case that is printed."""

import math
from collections.abc import Mapping, Sequence, Set

from ...algebra.angle import Angle
from ...algebra.factors import Factor, Opaque, Trig
from ...algebra.intervals import IntervalBox, NumberInterval, sign
from ...algebra.product import Product, Sum
from ...algebra.sums import add
from ...algebra.trigonometry import cosine, sine
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...model.boxes import POSITIVE
from ...power.tolerances import VANISHED
from ..naming import Meanings, OwnNames
from ..tolerances import ACUTE_MARGIN
from .names import Inverse, SignNames, bare, exact_sign, is_root
from .senses import sense_of

ACUTE = NumberInterval(ACUTE_MARGIN, math.pi / 2 - ACUTE_MARGIN)
"""What a turned line turns by: the arc of a positive sine or tangent."""


class SignsAtOnePose(SignNames):
    """Signs as numbers, and turns as positive angles, as they are at one pose.

    ``box`` are ranges that parameters keep to, so that what has one sign in it needs no
    condition. What a formula of the user's ``own`` stands for bears its name.
    """

    is_read = True

    def __init__(
        self,
        taken: Set[str],
        meanings: Meanings,
        endings: Sequence[str],
        values: Mapping[str, float],
        box: IntervalBox,
        own: OwnNames,
    ) -> None:
        super().__init__(taken, meanings, endings)
        self._own = own
        self._values, self.box = dict(values), dict(box)
        self.conditions: dict[Formula, int] = {}
        self._signs: dict[Factor, int] = {}
        self._alike: dict[Factor, Product] = {}

    def name_radius(self, name: str, factor: Product) -> Product:
        """Return the name of the radius, of a number too: rho^2 reads better than its digits."""
        if not factor:
            return factor
        known = self.define(name, factor.formula())
        if sign(factor, self.box) == 1:
            self.box[known] = POSITIVE
        return Product.symbol(known)

    def name_coefficient(self, name: str, factor: Product) -> Product:
        """Return the coefficient, by a name where it has sums in it, or one of the user's own."""
        has_sums = any(isinstance(f, Sum | Opaque) for f in factor.factors)
        is_named = has_sums or self._own.of(factor.formula())
        return self.name_radius(name, factor) if is_named else factor

    def note_sign(self, name: str, value: Product) -> Product:
        """Return 1, 0 or -1, and note what the sign was taken of."""
        telling = self._in_simpler(value)
        if not telling.factors:
            return telling
        parts = map(self._sign_of, telling.factors)
        return Product(math.prod(parts)).scaled(telling.coefficient)

    def way(self, value: Product) -> int:
        """Return the sign of a value at the pose, without noting it."""
        return -1 if value.evaluate(self._values) < 0 else 1

    def note_sense(self, name: str, slip: Product) -> Product:
        """Return 1, 0 or -1, and note what the slip is the product of."""
        return self.note_sign(name, slip)

    def _in_simpler(self, value: Product) -> Product:
        """Return a product of the same sign, in what is simpler where that is known."""
        telling = bare(value)
        parts = [self._alike.get(f, Product.of(f)) for f in telling.factors]
        return bare(math.prod(parts, start=Product(telling.coefficient)))

    def note_alike(self, value: Product, other: Product) -> None:
        """Note that what has a name has the sign of something simpler."""
        (named,) = value.factors
        self._alike[named] = other

    def _sign_of(self, factor: Factor) -> int:
        """Return the sign of a factor; along a chain the same ones are met again and again."""
        if factor not in self._signs:
            self._signs[factor] = self._looked_at(Product.of(factor))
        return self._signs[factor]

    def _looked_at(self, factor: Product) -> int:
        """Return the sign of a factor; note it where other values would change it."""
        known = 1 if is_root(factor) else sign(factor, self.box)
        known = self._implied(factor) if known is None else known
        if known is not None:
            return known
        sense = evaluate(sense_of(factor), self._values)
        here = 0 if math.isnan(sense) else int(sense)  # where no force balances there is none
        self.conditions[factor.formula()] = here
        return here

    def _implied(self, factor: Product) -> int | None:
        """Return the sign that all terms of a sum have by what is noted.

        None where they differ, one is open, or the factor is no sum.
        """
        (only,) = factor.factors
        if not isinstance(only, Sum):
            return None
        signs = {self._known_sign(term) for term in only.terms}
        return signs.pop() if len(signs) == 1 else None

    def _known_sign(self, value: Product) -> int | None:
        """Return the sign that a product has where all is as noted; None where that is open."""
        telling = self._in_simpler(value)
        signs = [self._signs.get(f) or sign(Product.of(f), self.box) for f in telling.factors]
        known = [s for s in signs if s]
        return (
            math.prod(known) * exact_sign(value.coefficient) if len(known) == len(signs) else None
        )

    def turn_line(self, name: str, line: Angle, by: Inverse, value: Product) -> Angle:
        """Return the line turned by a positive angle, one way or the other.

        A coefficient of friction that is zero for once turns as a small one would.
        """
        if not value:
            return line
        sign = exact_sign(value.coefficient)
        for factor, exponent in value.factors.items():
            sign *= _sign(Product.of(factor, exponent).evaluate(self._values)) or 1
        size = value.scaled(sign)
        known = _angle_of(size) if by == "atan" else None
        if known and abs(known.evaluate(self._values)) < math.pi / 2:
            return line + known * sign
        arc = self.turn(name, line, by, size) - line
        self.box.update((named, ACUTE) for named, _ in arc.terms)
        return line + arc * sign

    def unsquared(self, value: Product) -> Product:
        """Return the product: its signs are numbers."""
        return value

    def note_arm_beyond(self, arm: Product, radius: Product, ahead: Product) -> bool:
        """Return whether the arm exceeds the radius at the pose; note that, or what is so instead.

        That an arm exceeds a radius says more than that it is positive, which need not be said.
        """
        length, least = arm.evaluate(self._values), abs(radius.evaluate(self._values))
        if abs(length) <= least and ahead.evaluate(self._values) > 0:
            self.note_sign("", ahead)
            return False
        side = exact_sign(self.note_sign("", arm).coefficient)
        beyond = add((arm, radius.scaled(-side)))
        known = {f: sign(Product.of(f), self.box) for f in bare(beyond).factors}
        telling = Product(1, {f: 1 for f, of_it in known.items() if of_it is None})
        if telling.factors:
            side *= exact_sign(beyond.coefficient) * math.prod(s for s in known.values() if s)
            self.conditions.pop(arm.formula(), None)
            self.conditions[telling.formula()] = side
        return True

    def require_positive(self, value: Product) -> bool:
        """Note that a value is positive, which at a pose where nothing balances it is not.

        There the sign gives way of what is found last of it, if no other rests on that.
        """
        telling = self._in_simpler(value)
        fresh = [f for f in telling.factors if f not in self._signs]
        signs = {f: self._sign_of(f) for f in telling.factors}
        whole = math.prod(signs.values()) * exact_sign(telling.coefficient)
        if whole > 0:
            return True
        open_ = [f for f in fresh if f.formula() in self.conditions]
        if not open_:
            return False
        last = open_[-1]
        others = math.prod(s for f, s in signs.items() if f != last)
        self._signs[last] = others * exact_sign(telling.coefficient)
        self.conditions[last.formula()] = self._signs[last]
        return bool(self._signs[last])

    def define(self, name: str, formula: Formula) -> str:
        """Return the name of a formula from now on, and note its value."""
        known = super().define(name, formula)
        self._own.note(known, formula)
        self._values[known] = evaluate(formula, self._values)
        return known

    def _named_once(self, name: str, formula: Formula) -> str:
        return self._own.of(formula) or super()._named_once(name, formula)


def _angle_of(tangent: Product) -> Angle | None:
    """Return the angle where a value is written as the tangent of one."""
    sines = (f.angle for f in tangent.factors if isinstance(f, Trig) and f.function == "sin")
    return next((a for a in sines if tangent == sine(a) / cosine(a)), None)


def _sign(value: float) -> int:
    return (value > VANISHED) - (value < -VANISHED)
