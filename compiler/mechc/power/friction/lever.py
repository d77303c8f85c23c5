"""A lever on a pivot with friction: one quadratic for the force that is not known.

With S the size of a force along e whose arm is a, B the moment of all others and K their
sum, friction at the pivot gives a·S + B = σ·ρ·|S·e + K|, σ the sense of the lever's turn.
Squared, with c and q the components of K along and across e:

    S = (ρ²c − aB + σ·sgn(a)·ρ·√((a·c − B)² + (a² − ρ²)·q²)) / (a² − ρ²)

The root taken is the one that has the sign of σ for small ρ.
"""

from collections.abc import Mapping, Sequence

from ...algebra.angle import Angle
from ...algebra.factors import Opaque
from ...algebra.product import Product
from ...algebra.sums import add
from ...formula.tree import Call
from ...pose.pose import Vector
from .bodies import Pull
from .signs import Signs

Arms = Mapping[str, Vector]
"""Where the points of a lever are, seen from its pivot."""


def on_lever(
    unknown: Pull, known: Sequence[Pull], arms: Arms, radius: Product, signs: Signs
) -> Product:
    """Return the size of the unknown pull; ``radius`` is ρ with the sign σ of the turn."""
    arm = moment(unknown, arms)
    rest = add(moment(p, arms) for p in known)
    if not radius:
        return -(rest / arm)
    line = unknown.line or Angle()
    along = add(p.along(line) for p in known)
    across = add(p.across(line) for p in known)
    if unknown.line is None:
        load = Product.of(Opaque(Call("hypot", (along.formula(), across.formula()))))
        return add((radius * load, -rest)) / arm
    sense = signs.of(f"s_{unknown.name}_arm", arm)
    a, b, c, q = (
        signs.named(f"{letter}_{unknown.name}", value)
        for letter, value in (("a", arm), ("b", rest), ("c", along), ("q", across))
    )
    square, gap = add((a * a, -(radius * radius))), add((a * c, -b))
    root = Opaque(Call("sqrt", (add((gap * gap, square * q * q)).formula(),)))
    above = add((radius * radius * c, -(a * b), sense * radius * Product.of(root)))
    return signs.named(unknown.name, above / square)


def moment(pull: Pull, arms: Arms) -> Product:
    """Return the moment of a pull about the pivot, counter-clockwise."""
    if pull.line is None:
        return pull.couple
    parts = (part.length * pull.across(part.angle) for part in arms[pull.point])
    return add((*parts, pull.couple))
