"""What a formula measures, and how that follows from its parts.

A :class:`Sort` is a dimension and how firmly it is known. Angle is a dimension in sums,
comparisons and function arguments; in products it is a pure number. So ``mu*alpha`` or
``s/r`` may serve as either, while ``alpha`` cannot be added to 1 nor ``30`` to ``alpha``. The
involute function ``tan(alpha) - alpha`` is an angle, and ``tan(alpha)`` alone is none.
"""

from collections.abc import Sequence
from enum import Enum
from fractions import Fraction

from ...base.named import NamedTuple
from ...units import ANGLE, NUMBER, Dimension


class Nature(Enum):
    """How firmly a dimension is known."""

    FIRM = "as stated"
    LOOSE = "a computed ratio: a pure number or an angle, as needed"
    VALUE = "the value of a sine or the like: a pure number, which may be added to an angle"
    BARE = "made of literals without unit"
    UNITLESS = "made of parameters given without unit: a pure number, never an angle"
    ZERO = "the literal 0: of any dimension"


class Sort(NamedTuple):
    """What a formula measures."""

    dimension: Dimension
    nature: Nature = Nature.FIRM

    @staticmethod
    def of(dimension: Dimension) -> "Sort":
        """Return the sort of a declared quantity; a pure number may serve as an angle."""
        return Sort(dimension, Nature.LOOSE if dimension == NUMBER else Nature.FIRM)

    def fits(self, wanted: Dimension) -> bool:
        """Return whether such a formula may stand where a dimension is wanted.

        >>> Sort(NUMBER, Nature.LOOSE).fits(ANGLE), Sort(NUMBER, Nature.BARE).fits(ANGLE)
        (True, False)
        """
        if self.nature is Nature.VALUE:
            return wanted == NUMBER
        return agreed(self, Sort(wanted)) is not None


def agreed(a: Sort, b: Sort) -> Sort | None:
    """Return the sort of a sum of two, None where they cannot be added.

    >>> agreed(Sort(ANGLE), Sort(NUMBER, Nature.LOOSE)) == Sort(ANGLE)
    True
    """
    match a.nature, b.nature:
        case Nature.ZERO, _:
            return b
        case _, Nature.ZERO:
            return a
        case (Nature.UNITLESS, Nature.BARE | Nature.LOOSE) | (
            Nature.BARE | Nature.LOOSE,
            Nature.UNITLESS,
        ):
            return Sort(NUMBER, Nature.UNITLESS)
        case Nature.LOOSE, Nature.FIRM if b.dimension in (NUMBER, ANGLE):
            return b
        case Nature.FIRM, Nature.LOOSE if a.dimension in (NUMBER, ANGLE):
            return a
        case (Nature.LOOSE, Nature.LOOSE | Nature.BARE | Nature.VALUE) | (
            Nature.BARE | Nature.VALUE,
            Nature.LOOSE,
        ):
            return Sort(NUMBER, Nature.LOOSE)
        case (Nature.VALUE, Nature.FIRM) if b.dimension == ANGLE:
            return b
        case (Nature.FIRM, Nature.VALUE) if a.dimension == ANGLE:
            return a
    if a.dimension != b.dimension:
        return None
    return Sort(a.dimension, a.nature if a.nature == b.nature else Nature.FIRM)


def multiplied(factors: Sequence[tuple[Sort, int]]) -> Sort:
    """Return the sort of a product of factors, each with its exponent (±1).

    Literals leave the sort of a single other factor alone: ``2*alpha`` is an angle. So do
    counts that an angle is divided by; the quotient may serve as a pure number, too. An angle
    times an angle, or divided by one, is none any more.
    """
    solid = [(s, e) for s, e in factors if s.nature not in (Nature.BARE, Nature.ZERO)]
    if not solid:
        return Sort(NUMBER, Nature.BARE)
    if all(s.nature is Nature.UNITLESS for s, _ in solid):
        return Sort(NUMBER, Nature.UNITLESS)
    if len(solid) == 1 and solid[0][1] == 1:
        return solid[0][0]
    others = [(s.nature, e) for s, e in solid if (s, e) != (Sort(ANGLE), 1)]
    if len(others) == len(solid) - 1 and all(o == (Nature.UNITLESS, -1) for o in others):
        return Sort(ANGLE, Nature.LOOSE)
    dimension = NUMBER
    for sort, exponent in factors:
        dimension = dimension.joined(sort.dimension.scaled(exponent))
    angles = [exponent for sort, exponent in solid if sort == Sort(ANGLE)]
    if dimension == NUMBER and len(angles) > 1 and sum(angles) != 1:
        return Sort(NUMBER, Nature.VALUE)
    return Sort.of(dimension)


def raised(base: Sort, exponent: Fraction) -> Sort:
    """Return the sort of a power with a constant exponent."""
    if exponent == 1 or base.nature in (Nature.BARE, Nature.ZERO, Nature.UNITLESS):
        return base
    return Sort.of(base.dimension.scaled(exponent))
