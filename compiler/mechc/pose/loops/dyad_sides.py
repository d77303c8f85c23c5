"""The sides and angles of the triangle of a dyad, under names, and what these are defined by."""

from collections.abc import Callable, Iterable

from ...algebra.angle import HALF_TURN, Angle
from ...algebra.from_formula import to_angle
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine
from ...formula.layout import has_minus
from ...formula.tree import Call, Formula, Sum, is_call, negative, product, total
from ...formula.tree import Product as Factors
from ..pose import Arm, PoseDefinition, Vector, components, gathered, halved
from ..samples import Values, is_behind
from ..vector_graph import NameSet, known_span, mentioned
from .dyads import DyadLoop

Namer = Callable[[str], str]
"""Makes a name that nothing else has."""


HALF_TURN_MORE = 1.5
"""What half a turn behind an angle counts, in signs before a component."""


def _burden(vector: Vector, lead: Callable[[Angle], Angle], turn: Angle) -> float:
    """Return how much more is written for the direction of a vector, and what it leads to.

    These are the signs before its components, and half a turn in what follows from it.
    """
    signs = [has_minus(part.formula()) for part in _within(vector)]
    follows = lead(Angle.of("") + turn).degrees
    return sum(signs) + HALF_TURN_MORE * (follows % 360 == HALF_TURN.degrees)


def _within(vector: Vector) -> tuple[Product, Product]:
    """Return the components of a vector in axes that turn with it."""
    turn = common_turn(vector)
    return components(gathered(Arm(arm.length, arm.angle - turn) for arm in vector))


class DyadSides:
    """Names sides and angles; ``definitions`` are those that the names given so far need.

    ``kept`` are unknowns that the user named, ``fixed`` the pivots, ``values`` a pose.
    ``signed`` lengths may be negative somewhere on the stroke; ``defined`` was found before.
    ``again`` are names of angles found before that are those of this triangle, too, ``twice``
    the doubles of directions, to which those of this loop are added.
    """

    def __init__(
        self,
        name: Namer,
        kept: NameSet,
        fixed: NameSet,
        values: Values,
        signed: NameSet = frozenset(),
        defined: Iterable[PoseDefinition] = (),
        twice: dict[str, Angle] | None = None,
    ) -> None:
        self.name, self.kept, self.fixed = name, kept, fixed
        self._values, self._signed = values, signed
        self._defined, self._twice = tuple(defined), {} if twice is None else twice
        self._vectors = {d.name for d in self._defined if is_of_vector(d.formula)}
        self.definitions: list[PoseDefinition] = []
        self.again: set[str] = set()

    def polar(
        self, vector: Vector, name: str, positive: bool = False, called: str = ""
    ) -> tuple[Product, Angle]:
        """Return a vector as one length and one direction, both named where it is a sum.

        What turns as one body has a direction within it, ``delta``, that does not turn.
        A difference or a place on a line is turned round where it is negative at the default
        pose. What must be ``positive`` elsewhere, too, turns round where it passes zero.
        The length of a sum may be ``called`` by a name that is sought.
        """
        if len(vector) == 1 and not (positive and self._may_turn(vector[0].length)):
            length, angle = vector[0]
            behind = is_behind(length, [self._values])
            return (-length, angle + HALF_TURN) if behind else (length, angle)
        if not positive and (arm := halved(vector)):
            return self.polar((arm,), name)
        turn = common_turn(vector)
        parts = tuple(p.formula() for p in _within(vector))
        size = called or self.name(f"len_{name}")
        like = size if size.startswith("len_") else f"len_{name}"
        way = self.name(f"delta_{name}" if turn.terms else like.replace("len", "phi", 1))
        self.definitions.append(PoseDefinition(size, Call("hypot", parts)))
        self.definitions.append(PoseDefinition(way, Call("atan2", parts[::-1])))
        return Product.symbol(size), turn + Angle.of(way)

    def _may_turn(self, length: Product) -> bool:
        return not self._signed.isdisjoint(mentioned((Arm(length, Angle()),)))

    def known_side(
        self, loop: DyadLoop, positive: bool, lead: Callable[[Angle], Angle], reached: str = ""
    ) -> tuple[Product, Angle]:
        """Return the known side of the loop; one that has a name keeps it, whatever leads there.

        ``lead`` gives the direction that follows from that of the side. Of both ways along a sum
        of vectors that one has a name which is shorter to write and leads there without half a
        turn. Back along the side its length is what is ``reached``, if that is all of it.
        """
        size, psi = self._known_side(loop, positive, lead, reached)
        if (half := halved(loop.known)) and len(psi.terms) == 1:
            self._twice[psi.terms[0][0]] = half.angle * 2
        return size, psi

    def _known_side(
        self, loop: DyadLoop, positive: bool, lead: Callable[[Angle], Angle], reached: str
    ) -> tuple[Product, Angle]:
        """Return length and direction of the known side of a loop, by the shorter formulas."""
        ends = known_span(loop.cycle, loop.unknown)
        for tail, head, turn in ((*ends, Angle()), (*ends[::-1], HALF_TURN)) if ends else ():
            length, direction = f"len_{tail}{head}", f"phi_{tail}{head}"
            if len(loop.known) > 1 and {length, direction} <= self._vectors:
                return Product.symbol(length), Angle.of(direction) + turn
        back = tuple(Arm(arm.length, arm.angle + HALF_TURN) for arm in loop.known)
        is_sum = len(back) > 1 and (positive or not halved(back))
        if ends and is_sum and _burden(back, lead, HALF_TURN) < _burden(loop.known, lead, Angle()):
            size, way = self.polar(back, "".join(ends[::-1]), positive, reached)
            return size, way + HALF_TURN
        around = dict.fromkeys(e.tail for e in loop.cycle)
        name = "".join(ends or around) or "0"
        return self.polar(loop.known, name, positive)

    def undoubled(self, angle: Angle) -> Angle:
        """Return an angle, by whole turns, without twice the direction of a sum of equal arms.

        Such a sum halves the angle of its arms, forwards or backwards: twice its direction is
        the sum of theirs.
        """
        for name, factor in angle.terms:
            if name in self._twice and factor % 2 == 0:
                angle += (self._twice[name] - Angle.of(name) * 2) * (factor // 2)
        return angle

    def angle(self, letter: str, of: str, formula: Formula) -> Angle:
        """Return an angle of the triangle under a name of its own, or of a congruent triangle."""
        known = (
            d for d in (*self._defined, *self.definitions) if is_same_angle(d.formula, formula)
        )
        named = next(known, None)
        if named is None:
            named = PoseDefinition(self.name(f"{letter}_{of}"), formula)
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


def along(vector: Vector, direction: Angle) -> Product:
    """Return the component of a vector along a direction."""
    return add(arm.length * cosine(arm.angle - direction) for arm in vector)


def common_turn(vector: Vector) -> Angle:
    """Return the symbols by which all arms turn alike."""
    alike = set.intersection(*(set(arm.angle.terms) for arm in vector))
    return Angle(tuple(sorted((n, c) for n, c in alike if n in vector[0].angle.names)))


def heron(d: Product, p: Product, q: Product) -> Call:
    """Return four times the area of a triangle.

    The factors stay apart: two that are alike would else make a square, whose root has no sign.
    """
    factors = (add([p, q, d]), add([p, q, -d]), add([d, p, -q]), add([d, q, -p]))
    return Call("sqrt", (product((f.formula(), 1) for f in factors),))


def is_of_vector(formula: Formula) -> bool:
    """Return whether something is the length or the direction of a vector between two points."""
    return is_call(formula, "hypot", "atan2")


def is_same_angle(one: Formula, other: Formula) -> bool:
    """Return whether two angles are those of a triangle of the same three sides, in any order."""
    if one == other:
        return True
    match one, other:
        case Call("atan2", (Call("sqrt", (Factors(here),)), x)), Call(
            "atan2", (Call("sqrt", (Factors(there),)), y)
        ):
            return x == y and frozenset(here) == frozenset(there)
    return False
