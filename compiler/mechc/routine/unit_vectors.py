"""Angles that are only turned by, carried as the vectors that they are the directions of.

A loop that closes gives a direction as ``atan2(y, x)`` plus others, and k then takes its
sine: three functions where a root does, and in a triangle of known sides not even that.
The formula for the reader stays in angles.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ..algebra.angle import Angle
from ..algebra.from_formula import to_angle
from ..formula.sharing import each_part
from ..formula.tree import (
    ONE,
    Call,
    Definitions,
    Formula,
    Sum,
    Symbol,
    is_call,
    negative,
    number,
    power,
    product,
    total,
)
from ..formula.walk import Once, children, rebuild, symbols
from .direction_vectors import WANTED, DirectionVector, factors, plain, whole
from .lengths import fresh, signed, size, sizes, unsigned, with_roots

MULTIPLES = (-2, -1, 1, 2)
"""Multiples of an angle that are written out."""

MOST_DIVIDING_SUMS = 2
"""Sums of angles that may divide by the size of a vector; for more it is divided out at once."""

MOST_SIZE_FACTORS = 6
"""Factors of a size beyond which it is divided out at once: far from what underflows."""

CARRIED_ANGLES = 3
"""Angles in a sum that has a name from which on it is carried as one direction."""

MOST_EXPANDED_ANGLES = 5
"""Angles in a sum that is written out; each doubles what there is to compute."""


def in_unit_vectors(
    definitions: Definitions, formulas: Sequence[Formula], kept: Iterable[str], taken: set[str]
) -> tuple[list[tuple[str, Formula]], list[Formula]]:
    """Return definitions and formulas with polar angles carried as vectors.

    ``kept`` are names that must stay defined, ``taken`` those that a new one may not have.
    Where no root is left that is NaN if an angle is, the angle's size keeps it.
    """
    uses, careful = _uses(definitions, formulas), set[str]()
    while True:
        turning = _Turning(sizes(definitions), uses, {*taken}, careful)
        for name, formula in definitions:
            turning.define(name, formula)
        found = [turning.rewritten(f) for f in formulas]
        needed = reached(turning.written, found, kept)
        lost = turning.lost([*(f for _, f in needed), *found])
        if not lost:
            rooted, found = with_roots(needed, found, turning.taken)
            return reached(rooted, found, kept), found
        careful |= lost


def reached(
    definitions: Definitions, results: Iterable[Formula], kept: Iterable[str]
) -> list[tuple[str, Formula]]:
    """Return the definitions that something needs."""
    used = {*kept, *(name for f in results for name in symbols(f))}
    found: list[tuple[str, Formula]] = []
    for name, formula in reversed(definitions):
        if name in used:
            found.append((name, formula))
            used |= symbols(formula)
    return found[::-1]


def _uses(definitions: Definitions, results: Sequence[Formula]) -> Counter[str]:
    """Return in how many sums of angles each name occurs, signs and constants aside."""
    sums: dict[str, Angle] = {}
    asked: set[frozenset[str]] = set()
    for name, formula in (*definitions, *(("", f) for f in results)):
        angle = to_angle(formula)
        if angle is not None:
            sums[name] = angle.put(sums)
        elif isinstance(formula, Sum):
            asked |= {
                frozenset((name, t.name))
                for t in map(unsigned, formula.terms)
                if isinstance(t, Symbol)
            }
        asked |= {frozenset(a.put(sums).names) for a in _turned_by(formula)}
    return Counter(name for names in asked for name in names)


def _turned_by(formula: Formula) -> Iterator[Angle]:
    for part in each_part([formula]):
        if isinstance(part, Call) and part.function in WANTED:
            angle = to_angle(part.arguments[0])
            if angle is not None:
                yield angle


class _Turning:
    """Writes definitions in terms of the vectors of those before.

    ``units`` are carried angles, ``sums`` those that are sums of carried ones, ``roots``
    what is NaN where a carried angle is, and no size of its vector.
    """

    def __init__(
        self,
        lengths: Mapping[frozenset[Formula], str],
        uses: Mapping[str, int],
        taken: set[str],
        careful: Set[str],
    ) -> None:
        self.lengths, self.uses, self.taken, self.careful = lengths, uses, taken, careful
        self.units: dict[str, DirectionVector] = {}
        self.sums: dict[str, Angle] = {}
        self.roots: dict[str, Formula] = {}
        self.written: list[tuple[str, Formula]] = []
        self.used: set[str] = set()
        self.rewritten = Once(self._rewritten)
        self.defined: set[str] = set()

    def lost(self, formulas: Iterable[Formula]) -> set[str]:
        """Return the angles in use whose roots are not."""
        there = {part for part in each_part(formulas) if _is_root(part)}
        return {n for n, root in self.roots.items() if n in self.used and root not in there}

    def define(self, name: str, formula: Formula) -> None:
        """Add a definition, and the vector of an angle."""
        self.written.append((name, self.rewritten(formula)))
        self.defined.add(name)
        angle = to_angle(formula)
        if angle is not None and any(n in self.units for n in angle.names):
            self._define_sum(name, angle.put(self.sums))
            self.rewritten.forget()
        elif units := self._polar(name, formula):
            self.units[name] = self._direction_of_sum(name, units)
            self.rewritten.forget()

    def _define_sum(self, name: str, angle: Angle) -> None:
        """Add an angle that carried ones make up: a direction of its own where they are many."""
        turns = self._turns(angle)
        if CARRIED_ANGLES <= len(turns) <= MOST_EXPANDED_ANGLES:
            self.units[name] = self._direction_of_sum(name, turns)
        else:
            self.sums[name] = angle

    def _direction_of_sum(self, name: str, units: list[DirectionVector]) -> DirectionVector:
        """Return the direction of an angle that is the sum of those of unit vectors.

        Components of several get names; cosine and sine do where the size is long, or often used.
        """
        unit = DirectionVector(*map(self.rewritten, whole(units)))
        if len(units) > 1:
            unit = DirectionVector(
                self._named(f"x_{name}", unit.x), self._named(f"y_{name}", unit.y), unit.size
            )
        if self.uses[name] <= MOST_DIVIDING_SUMS and factors(unit.size) <= MOST_SIZE_FACTORS:
            return unit
        return DirectionVector(
            self._named(f"cos_{name}", unit.cos), self._named(f"sin_{name}", unit.sin)
        )

    def _named(self, name: str, formula: Formula) -> Formula:
        title = fresh(name, self.taken)
        self.written.append((title, formula))
        return Symbol(title)

    # ---------------------------------------------------------------------- reading

    def _polar(self, name: str, formula: Formula) -> list[DirectionVector]:
        """Return the terms of an angle as unit vectors: arc functions, carried and plain angles."""
        terms = formula.terms if isinstance(formula, Sum) else (formula,)
        others: list[Formula] = []
        found: list[DirectionVector] = []
        for term in terms:
            sign, inner = signed(term)
            unit = self._of_one_term(name, inner)
            if unit:
                found.append(unit if sign > 0 else unit.back())
            else:
                others.append(term)
        angle = to_angle(total(others))
        if not found or angle is None:
            return []
        if others:
            found.append(plain(angle))
        return found if len(found) <= MOST_EXPANDED_ANGLES else []

    def _of_one_term(self, name: str, formula: Formula) -> DirectionVector | None:
        """Return the direction of an arc function or of a carried angle; None of others."""
        match formula:
            case Call("atan2", (y, x)):
                return DirectionVector(x, y, self._size(name, x, y))
            case Call("asin", (sine,)) if name not in self.careful:
                return DirectionVector(self._other_leg(name, sine), sine)
            case Call("acos", (cosine,)) if name not in self.careful:
                return DirectionVector(cosine, self._other_leg(name, cosine))
            case Call("atan", (slope,)):
                return DirectionVector(
                    ONE, slope, Call("sqrt", (total([ONE, power(slope, number(2))]),))
                )
            case Symbol(other) if other in self.units:
                self.used.add(other)
                return self.units[other]
        return None

    def _other_leg(self, name: str, leg: Formula) -> Formula:
        """Return the sine that goes with a cosine, or the reverse; it is not negative.

        There is no cancellation where the leg is near 1.
        """
        less, more = total([ONE, negative(leg)]), total([ONE, leg])
        other = Call("sqrt", (product([(less, 1), (more, 1)]),))
        self.roots[name] = self.rewritten(other)
        return other

    def _size(self, name: str, x: Formula, y: Formula) -> Formula:
        length = self.lengths.get(frozenset(map(unsigned, (x, y))))
        if length in self.defined:
            return Symbol(length)
        if name not in self.careful and (known := size(x, y, self.lengths.values())):
            root = next((unsigned(c) for c in (y, x) if _is_root(c)), None)
            if root:
                self.roots[name] = self.rewritten(root)
            return known
        return Call("sqrt", (total(power(unsigned(c), number(2)) for c in (x, y)),))

    # ---------------------------------------------------------------------- writing

    def _rewritten(self, formula: Formula) -> Formula:
        """Return a formula with functions of carried angles written by their vectors."""
        if isinstance(formula, Call) and formula.function in WANTED:
            angle = to_angle(formula.arguments[0])
            if angle is not None and (unit := self._turned(angle.put(self.sums))):
                return WANTED[formula.function](unit)
        parts = children(formula)
        return rebuild(formula, tuple(map(self.rewritten, parts))) if parts else formula

    def _turned(self, angle: Angle) -> DirectionVector | None:
        """Return the direction of an angle that mentions carried ones; None for others."""
        turns = self._turns(angle)
        return whole(turns) if 0 < len(turns) <= MOST_EXPANDED_ANGLES else None

    def _turns(self, angle: Angle) -> list[DirectionVector]:
        """Return the directions that an angle is the sum of; none where it has no carried one."""
        carried = {n: c for n, c in angle.terms if n in self.units}
        if not carried or any(c not in MULTIPLES for c in carried.values()):
            return []
        self.used |= carried.keys()
        turns = [u for n, c in carried.items() for u in _repeated(self.units[n], int(c))]
        rest = Angle(tuple(t for t in angle.terms if t[0] not in carried), angle.degrees)
        return [plain(rest), *turns] if rest.terms or rest.degrees else turns


def _is_root(formula: Formula) -> bool:
    bare = unsigned(formula)
    return is_call(bare, "sqrt")


def _repeated(unit: DirectionVector, times: int) -> list[DirectionVector]:
    return [unit if times > 0 else unit.back()] * abs(times)
