"""Do the loops close? Exactly, for independent symbols, before any number is put in.

Closure is linear in the lengths that were left open. Going through the loops one by
one, the equations must stay consistent at a random point of a finite field: the first
that does not ties symbols which were given as independent.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from ..algebra.angle import QUARTER, Angle
from ..algebra.factors import ConstantSymbol, Factor, Length, Trig
from ..algebra.modular import ModularPoint
from ..algebra.product import Product, Sum
from ..algebra.sums import add
from ..algebra.trigonometry import cosine
from ..base.named import NamedTuple
from ..diagnostics import Diagnostic
from ..diagnostics import open_loops as open_messages
from ..diagnostics import pose as messages
from ..formula.evaluate import evaluate
from ..formula.to_text import text
from ..formula.tree import Formula
from ..formula.walk import constants
from ..model.mechanism import Mechanism, Pivot
from ..model.values import Values
from ..source import Span
from .pose import Arm, Vector, evaluate_vector
from .tolerances import LOOP_GAP

ArmCounts = dict[str, int]
"""A linear equation in the open lengths, modulo the prime; the constant stands under ''."""


SamplePoses = Callable[[], Sequence[Values]]
"""Gives some poses in numbers."""


class ClosureCondition(NamedTuple):
    """A sum of arms whose component along each of some directions must vanish."""

    name: str
    arms: Vector
    across: tuple[Angle, ...]
    span: Span


class ClosingEquations:
    """The equations so far, in echelon form.

    Of the symbols some are ``defined``; some are ``given`` by the description, while others come
    from a drawing. Angles are ``brought`` in by parts that are joined, with their values.
    """

    def __init__(
        self,
        open_lengths: Iterable[str],
        defined: Iterable[str] = (),
        given: Iterable[str] | None = None,
        brought: Iterable[str] = (),
    ) -> None:
        self._brought = frozenset(brought)
        self._open, self._defined = frozenset(open_lengths), frozenset(defined)
        self._given = None if given is None else frozenset(given)
        self._point = ModularPoint()
        self._rows: list[tuple[str, ArmCounts]] = []

    def check(self, condition: ClosureCondition, poses: SamplePoses) -> Diagnostic | None:
        """Take a condition in; return the error if it cannot hold for independent symbols.

        ``poses`` begin with the default one; most conditions are decided without them.
        """
        for direction in self._directions(condition):
            row = self._reduced(self._row(condition.arms, direction))
            unknowns = [name for name, v in row.items() if name and v]
            if unknowns:
                self._rows.append((unknowns[0], row))
            elif row.get("") and not self._holds_by_definition(condition.arms, direction, poses):
                return self._refused(condition, direction, poses()[0])
        return None

    def _directions(self, condition: ClosureCondition) -> Sequence[Angle]:
        """Return the directions to project on: along an open arm and across it, where one is."""
        if len(condition.across) == 2:
            for length, angle in condition.arms:
                if not self._open.isdisjoint(_names(length)):
                    return angle, across(angle)
        return condition.across

    def _holds_by_definition(self, arms: Vector, direction: Angle, poses: SamplePoses) -> bool:
        """Return whether arms add up to zero because some of their angles were defined so.

        Algebra takes ``beta = asin(a/l*sin(alpha))`` for one more free symbol; numbers at a
        few poses show.
        """
        counted = tuple(arm for arm in arms if cosine(arm.angle - direction))
        named = _symbols(counted) | dict(direction.terms).keys()
        if self._defined.isdisjoint(named) or self._mentions_open(counted):
            return False
        return not any(abs(_along(counted, direction, values)) > LOOP_GAP for values in poses())

    def _row(self, arms: Vector, direction: Angle) -> ArmCounts:
        row: ArmCounts = {}
        for length, angle in arms:
            name = next((n for n in _names(length) if n in self._open), "")
            size = length / Product.symbol(name) if name else length
            value = (size * cosine(angle - direction)).residue(self._point)
            row[name] = (row.get(name, 0) + value) % self._point.prime
        return row

    def _reduced(self, row: ArmCounts) -> ArmCounts:
        prime = self._point.prime
        for pivot, known in self._rows:
            factor = row.get(pivot, 0) * pow(known[pivot], -1, prime) % prime
            if factor:
                for name, value in known.items():
                    row[name] = (row.get(name, 0) - factor * value) % prime
        return row

    def _refused(
        self, condition: ClosureCondition, direction: Angle, values: Mapping[str, float]
    ) -> Diagnostic:
        """Return the error at a loop that does not close, cannot move, or ties its symbols."""
        gap = _gap(condition, values) if not self._mentions_open(condition.arms) else 0.0
        if gap:
            brought = sorted(_symbols(condition.arms) & self._brought)
            shown = _metres(gap)
            return messages.loop_does_not_close(condition.span, condition.name, shown, brought)
        names = sorted(_symbols(condition.arms) - self._open)
        if self._given is not None and self._given.isdisjoint(names):
            return open_messages.loop_holds_fast(condition.span, condition.name)
        relation = ""
        if not self._mentions_open(condition.arms):
            left = add(a.length * cosine(a.angle - direction) for a in condition.arms)
            relation = _relation(left.formula())
        if self._given is not None:
            names = [name for name in names if name in self._given]
            relation = ""
        return messages.loop_ties_symbols(condition.span, condition.name, names, relation)

    def _mentions_open(self, arms: Vector) -> bool:
        return not self._open.isdisjoint(_symbols(arms))


def _gap(condition: ClosureCondition, values: Mapping[str, float]) -> float:
    """Return how far the arms miss closure at the values given; 0 if closed or not all given."""
    try:
        x, y = evaluate_vector(condition.arms, values)
        longest = max(abs(a.length.evaluate(values)) for a in condition.arms)
        parts = [
            x * math.cos(t) + y * math.sin(t)
            for t in (d.evaluate(values) for d in condition.across)
        ]
    except (KeyError, ZeroDivisionError):
        return 0.0
    gap = math.hypot(*parts)
    return gap if gap > LOOP_GAP * longest else 0.0


def _along(arms: Vector, direction: Angle, values: Values) -> float:
    """Return the part of a sum of arms along a direction, relative to the longest arm."""
    try:
        (x, y), t = evaluate_vector(arms, values), direction.evaluate(values)
        longest = max(abs(arm.length.evaluate(values)) for arm in arms)
    except (KeyError, ZeroDivisionError):
        return 0.0
    return (x * math.cos(t) + y * math.sin(t)) / longest


def _relation(left: Formula) -> str:
    """Return an equation, with the values of what has a name here alone."""
    known = (f"{c.name} = {_metres(evaluate(c, {}))}" for c in constants([left]))
    return ", ".join([f"{text(left)} = 0", *known])


def _metres(gap: float) -> str:
    return f"{gap * 1000:.4g} mm"


def _symbols(arms: Iterable[Arm]) -> set[str]:
    return {n for arm in arms for n in (*_names(arm.length), *dict(arm.angle.terms))}


def _names(product: Product) -> Iterator[str]:
    for factor in product.factors:
        yield from _factor_names(factor)


def _factor_names(factor: Factor) -> Iterator[str]:
    if isinstance(factor, Length) and not isinstance(factor, ConstantSymbol):
        yield factor.name
    elif isinstance(factor, Trig):
        yield from dict(factor.angle.terms)
    elif isinstance(factor, Sum):
        for term in factor.terms:
            yield from _names(term)


def across(direction: Angle) -> Angle:
    """Return the normal of a direction."""
    return direction + QUARTER


def given_by_hand(mechanism: Mechanism) -> frozenset[str]:
    """Return the parameters that stand in the description, without the drive and what is drawn.

    What lies between pivots at coordinates, lengths and angles, is drawn as well.
    """
    pivots = (pivot.span for pivot in mechanism.each(Pivot))
    places, drive = [*(drawn.span for drawn in mechanism.drawn), *pivots], mechanism.drive_name
    declared = (p for p in mechanism.parameters if p.name != drive)
    return frozenset(p.name for p in declared if not any(_is_in(p.span, at) for at in places))


def _is_in(span: Span, place: Span) -> bool:
    return place.start <= span.start and span.end <= place.end
