"""Is one formula equal to another? Exactly, at random points of a finite field.

>>> from .formula import Call, Number, Symbol, power, number, total
>>> s, c = (power(Call(f, (Symbol("t"),)), number(2)) for f in ("sin", "cos"))
>>> equal(total([s, c]), number(1))
True
>>> equal(s, c)
False
"""

from typing import assert_never

from .formula import Call, Formula, Number, Pi, Power, Product, Sum, Symbol
from .from_formula import to_angle
from .modular import Point

_TRIES = 3


def equal(left: Formula, right: Formula) -> bool:
    """Tell whether two formulas are the same function of their symbols.

    True is a proof up to a chance of some 1e-50. False is certain for what angle
    algebra sees; functions it does not look into (roots, arc functions) count as
    unknown quantities of their own, so two forms of one such function may be called
    different: compare numerically then.
    """
    return all(_agree(left, right, seed) for seed in range(_TRIES))


def _agree(left: Formula, right: Formula, seed: int) -> bool:
    point = Point(seed)
    try:
        return residue(left, point) == residue(right, point)
    except ZeroDivisionError:
        return False


def residue(formula: Formula, point: Point) -> int:
    """Return the value of a formula at a random point of a finite field."""
    match formula:
        case Number(value):
            return point.rational(value)
        case Symbol(name):
            return point.length(name)
        case Sum(terms):
            return sum(residue(t, point) for t in terms) % point.prime
        case Product(factors):
            result = 1
            for factor in factors:
                result = result * residue(factor, point) % point.prime
            return result
        case Power(base, Number(value)) if value.denominator == 1:
            return point.power(residue(base, point), value.numerator)
        case Call(function, (argument,)) if (angle := to_angle(argument)) is not None:
            sin, cos = point.trig("sin", angle), point.trig("cos", angle)
            match function:
                case "sin":
                    return sin
                case "cos":
                    return cos
                case "tan":
                    return sin * point.power(cos, -1) % point.prime
                case "cot":
                    return cos * point.power(sin, -1) % point.prime
                case "sec":
                    return point.power(cos, -1)
                case "csc":
                    return point.power(sin, -1)
            return point.length(str(formula))
        case Pi() | Power() | Call():
            return point.length(str(formula))
        case _:
            assert_never(formula)
