"""A lever on a pivot with friction: one quadratic for the force that is not known.

With S the size of a force along e whose arm is a, b the moment that all others have against
it and K their sum, friction at the pivot gives a·S − b = σ·ρ·|S·e + K|, σ the sense of the
lever's turn. Squared, with c and q the components of K along and across e:

    S = (a·b + ρ²c + σ·sgn(a)·ρ·√((a·c + b)² + (a² − ρ²)·q²)) / (a² − ρ²)

The root taken is the one that has the sign of σ for small ρ. It solves the equation before
squaring where a² > ρ², or else σ·(a·c + b) < 0; elsewhere no force turns the lever. Where all
forces are parallel, q = 0, it is the quotient that a·S − b = ±ρ·(S + c) gives at once, as
long as friction does not exceed the arm.
"""

from collections.abc import Sequence

from ..algebra.angle import Angle
from ..algebra.factors import Opaque
from ..algebra.product import ONE, Product, Sum
from ..algebra.sums import add
from ..base.named import NamedTuple
from ..formula.tree import (
    Call,
    Formula,
    Symbol,
    negative,
    number,
    power,
    product,
    quotient,
    total,
)
from ..formula.walk import substitute
from ..power.magnitudes import root
from .chain_bodies import Arms, BodyForce, EquationsCoupled
from .signs.names import SignSymbols

TWO = number(2)


class LeverPivot(NamedTuple):
    """A lever's pivot: the radius of its friction circle, and the sign of friction there."""

    pivot: str
    radius: Product
    turn: Product


LeverSides = tuple[Formula, Formula]


class BalancingForce(NamedTuple):
    """The size of the force that balances a lever; it does so where ``turns`` is positive.

    ``quadratic`` is the equation of which it is a root, where it is one; then it may be known what
    it is ``alike`` in sign.
    """

    size: Product
    turns: Product = ONE
    quadratic: LeverSides | None = None
    alike: Product | None = None


def on_lever(
    unknown: BodyForce,
    known: Sequence[BodyForce],
    arms: Arms,
    bearing: LeverPivot | None,
    signs: SignSymbols,
) -> BalancingForce:
    """Return the size of the unknown force on a lever that is in balance."""
    if unknown.line is not None and unknown.size != ONE:
        part = ONE / unknown.size
        found = on_lever(unknown.scaled(part), known, arms, bearing, signs)
        return _in_whole(found, unknown, part)
    arm = unknown.moment(arms)
    rest = add(p.moment(arms) for p in known)
    if bearing is None:
        return BalancingForce(-(rest / arm))
    line = unknown.line or Angle()
    along = add(p.along(line) for p in known)
    across = add(p.across(line) for p in known)
    if unknown.line is None:
        load = _size(along, across, f"s_{bearing.pivot}_load", signs)
        return BalancingForce(add((bearing.turn * bearing.radius * load, -rest)) / arm)
    return _with_friction(unknown.name, (arm, rest, along, across), bearing, signs)


def _with_friction(
    name: str, parts: Sequence[Product], bearing: LeverPivot, signs: SignSymbols
) -> BalancingForce:
    """Return the force along a line that balances a lever; a negative arm is reversed."""
    arm, rest, along, across = parts
    way = signs.way(arm)
    arm, rest = (arm, -rest) if way > 0 else (_opposite(arm), rest)
    across = -across if across.coefficient < 0 else across
    bearing = bearing._replace(turn=bearing.turn.scaled(way))
    label = _label(name)
    turn = signs.unsquared(signs.note_sign(f"s_{label}_arm", arm) * bearing.turn)
    if not turn:
        return BalancingForce(rest / arm)
    if not across:
        return _parallel(label, (arm, rest, along), bearing.radius, turn, signs)
    ahead = -(bearing.turn * add((arm * along, rest)))
    is_beyond, made = signs.note_arm_beyond(arm, bearing.radius, ahead), (arm, rest, along, across)
    found = _root(name, made, bearing, turn, signs)
    return found._replace(alike=_sense(made, bearing, signs)) if is_beyond else found


def _opposite(value: Product) -> Product:
    """Return the opposite of a value, of a sum that of its terms."""
    match list(value.factors.items()):
        case [(Sum() as only, 1)]:
            return add(term.scaled(-value.coefficient) for term in only.terms)
        case _:
            return -value


def _sense(parts: Sequence[Product], bearing: LeverPivot, signs: SignSymbols) -> Product | None:
    """Return a product with the sign of the force, by the moment that it balances; None if long.

    Where the arm exceeds the radius, a·S − σ·ρ·|S·e + K| grows with a·S, so that S has the sign
    of (b + σ·ρ·|K|)/a.
    """
    arm, rest, along, across = parts
    others = root(add((along * along, across * across)))
    if any(isinstance(factor, Opaque) for factor in others.factors):
        return None
    load = others * signs.note_sign(f"s_{bearing.pivot}_load", others)
    return arm * add((bearing.turn * bearing.radius * load, rest))


def _in_whole(found: BalancingForce, unknown: BodyForce, part: Product) -> BalancingForce:
    """Return the size of a force from that of the part of it that acts."""
    size = found.size * part
    found = found._replace(alike=found.alike and found.alike * part)
    if found.quadratic is None:
        return found._replace(size=size)
    acting = {unknown.name: (Product.symbol(unknown.name) * unknown.size).formula()}
    left, right = (substitute(side, acting) for side in found.quadratic)
    return found._replace(size=size, quadratic=(left, right))


def _label(name: str) -> str:
    return name.removeprefix("S_").removeprefix("R_")


def _size(along: Product, across: Product, name: str, signs: SignSymbols) -> Product:
    """Return the size of a force; one along a line is what stands before its sine and cosine."""
    whole = root(add((along * along, across * across)))
    if any(isinstance(factor, Opaque) for factor in whole.factors):
        return Product.of(Opaque(Call("hypot", (along.formula(), across.formula()))))
    return whole * signs.note_sign(name, whole)


def _parallel(
    label: str, parts: Sequence[Product], radius: Product, turn: Product, signs: SignSymbols
) -> BalancingForce:
    """Return the force where all are parallel; the pivot takes (a·c + b)/a without friction."""
    arm, rest, along = parts
    side = signs.note_sign(f"s_{label}_pivot", add((arm * along, rest)))
    lever = turn * side * radius
    left = add((arm, -lever))
    if not left:
        raise EquationsCoupled
    return BalancingForce(add((lever * along, rest)) / left, arm * left)


def _root(
    name: str, parts: Sequence[Product], bearing: LeverPivot, turn: Product, signs: SignSymbols
) -> BalancingForce:
    """Return the root of the quadratic, with what it is made of by names.

    In code the radius has the sign of the turn: where that is zero, there is no friction.
    """
    a, b, c, q = (
        signs.name_value(f"{letter}_{_label(name)}", part).formula()
        for letter, part in zip("abcq", parts, strict=True)
    )
    sense, signed = (ONE, turn * bearing.radius) if turn.factors else (turn, bearing.radius)
    radius = signs.name_value(f"rho_{bearing.pivot}", signed).formula()
    gap = total([product([(a, 1), (c, 1)]), b])
    square = total([power(a, TWO), negative(power(radius, TWO))])
    inside = total([power(gap, TWO), product([(square, 1), (q, 2)])])
    above = [
        product([(a, 1), (b, 1)]),
        product([(radius, 2), (c, 1)]),
        product([(sense.formula(), 1), (radius, 1), (Call("sqrt", (inside,)), 1)]),
    ]
    root = quotient(total(above), square)
    ahead = product([(bearing.turn.formula(), 1), (negative(gap), 1)])
    turns = Call("max", (square, ahead))
    quadratic = _quadratic(Symbol(name), (a, b, c, q), radius)
    return BalancingForce(Product.of(Opaque(root)), Product.of(Opaque(turns)), quadratic)


def _quadratic(size: Formula, parts: Sequence[Formula], radius: Formula) -> LeverSides:
    """Return both sides of (a·S − b)² = ρ²·((S + c)² + q²)."""
    a, b, c, q = parts
    moments = total([product([(a, 1), (size, 1)]), negative(b)])
    squares = total([power(total([size, c]), TWO), power(q, TWO)])
    return power(moments, TWO), product([(radius, 2), (squares, 1)])
