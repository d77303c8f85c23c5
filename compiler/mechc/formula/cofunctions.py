"""Sines written as cosines, and the other way round, of angles turned by a quarter."""

from collections.abc import Callable

from .layout import has_minus, in_degrees
from .positive_divisors import in_reading_order
from .tree import Call, Formula, Sum, degrees, negative, number, product, total

Quarter = Callable[[Formula], int]
"""By how many degrees an angle is to be turned to be one that a person knows: 90, −90 or 0."""


def as_cofunction(formula: Formula, quarter: Quarter) -> Formula | None:
    """Return a sine as a cosine, or the other way round, of its angle turned by a quarter.

    None where it is not to be turned, and for what is neither.

    >>> from .to_text import text
    >>> text(as_cofunction(Call("cos", (degrees(35),)), lambda angle: -90))
    'sin(11*pi/36)'
    """
    match formula:
        case Call("sin" | "cos" as function, (angle,)) if turn := quarter(angle):
            # cos x = sin(x + 90°), sin x = −cos(x + 90°)
            sign = (1 if function == "cos" else -1) * (1 if turn > 0 else -1)
            other = "sin" if function == "cos" else "cos"
            turned = _plus(angle, turn)
            if _is_opposite(turned, other):
                turned, sign = opposite_angle(turned), sign * (1 if other == "cos" else -1)
            return product([(number(sign), 1), (Call(other, (turned,)), 1)])
    return None


def _is_opposite(angle: Formula, function: str) -> bool:
    """Return whether a function is written of an angle's negative: a constant's, or a cosine's."""
    if isinstance(angle, Sum):
        return function == "cos" and has_minus(angle.terms[0])
    return bool(in_degrees(angle)) and has_minus(angle)


def opposite_angle(angle: Formula) -> Formula:
    if isinstance(angle, Sum):
        return total(in_reading_order(map(negative, angle.terms)))
    return negative(angle)


def _plus(angle: Formula, turn: int) -> Formula:
    """Return an angle with degrees added to its constant, which comes last."""
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    others = [term for term in terms if in_degrees(term) is None]
    constant = sum(size for term in terms if (size := in_degrees(term)) is not None)
    return total([*others, degrees(constant + turn)])
