"""Frictions that agree with the forces that they make: f = c·n with n = |a + R·f|.

The loads press a pair of surfaces by a, and frictions f change that by R·f. Where frictions are
moderate, each follows from the others again and again until all stay. Where they are not, the
solution is followed from where there is no friction, all coefficients growing alike, t·c, by
Newton's method at every step. The equations are homogeneous in n and the size φ of the loads:
what is kept is the size of both together, so that φ may pass zero, where no load would do,
and come back. On the way |v| is rounded off, which at its end it no longer is.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import product
from operator import mul
from random import Random

from ..base.named import NamedTuple
from ..formula.numeric.elimination import Matrix, eliminate
from ..work import spend

ROUNDS = 400
"""Repetitions at most: what takes more is followed."""

PRODUCTS_A_STEP = 16
"""So many products, each of a friction and what it does to a force, are a step of work."""

ROUNDING_CHANGE = 1e-16
"""A relative change below this is rounding."""

ENDLESS = 1e12
"""Frictions this large against the loads have no end."""

ROUNDED_OFF = 0.03
"""By how much, against all of them, forces are rounded off at the outset, by friction of 1.

More than so much, by as much as friction is larger, no force would be left to turn.
"""

FIRST, SHORTEST = 1 / 8, 1e-6
"""The first step on the way, and the shortest before it is given up."""

PATH_STEPS = 400
"""Steps at most, those that are given up among them: friction is far too large for more."""

PATH_CORRECTIONS = 12
"""Corrections in one step at most, each :data:`SHRINKS` times as long as the one before."""

SHRINKS, LONGEST = 0.5, 0.3
"""How much shorter corrections become, and how long the first may be against the whole."""

NONE = 1e-15
"""A correction below this is rounding."""

ATTEMPTS = 40
"""Corrections from a start that is not followed to, but guessed."""

GUESSED_FORCES = (0.1, 1.0, 10.0, 100.0)
"""How large guessed forces are, against those without friction."""

GUESSES = 1000
"""Starts at random times pairs: near a dead centre few lead to the balance that is looked for."""

TURNED = 0.5
"""The cosine of the angle by which a force may turn in one step: 60 degrees.

Where friction is large against the loads, a force and its opposite balance nearly alike: what
turns at once is another solution.
"""

LITTLE = 1e-4
"""A force this small against all of them together may turn as it likes: it may be rounding."""

STALLED = 1e-9
"""Corrections this short that no longer shrink are rounding, too."""

WeightedComponents = Sequence[tuple[float, Sequence[float]]]
"""Perpendicular components of a force: without friction, and what each friction adds."""


class SurfacePair(NamedTuple):
    """A pair of surfaces: its coefficient, and what presses it."""

    factor: float
    components: WeightedComponents


def friction_sizes(pairs: Sequence[SurfacePair]) -> list[float] | None:
    """Return the frictions that grow from none; None where none are found."""
    found = _repeated(pairs)
    return _followed(pairs) if found is None else found


def other_friction_sizes(pairs: Sequence[SurfacePair]) -> Iterator[list[float]]:
    """Yield frictions that agree with their forces as well, from various starts.

    They are no more than are found: there may be others.
    """
    way = _Way(pairs)
    size = max((math.hypot(*(ideal for ideal, _ in cs)) for cs in way.pairs), default=0.0)
    for start in _starts(len(pairs)):
        found = way.near([times * size for times in start])
        if found is not None:
            yield way.frictions(found)


def _starts(count: int) -> Iterator[list[float]]:
    """Yield guessed sizes of forces: one alone, all alike, then at random over eight decades."""
    for times, i in product(GUESSED_FORCES, range(count + 1)):
        yield [times if i in (j, count) else 0.0 for j in range(count)]
    dice = Random(count)
    for _ in range(GUESSES // max(1, count)):
        yield [10.0 ** dice.uniform(-5, 3) for _ in range(count)]


def _repeated(pairs: Sequence[SurfacePair]) -> list[float] | None:
    """Let frictions follow from one another until all stay; None where they do not soon."""
    work = 1 + len(pairs) * sum(len(p.components) for p in pairs) // PRODUCTS_A_STEP
    frictions, most = [0.0] * len(pairs), math.inf
    for _ in range(ROUNDS):
        spend(work)
        after = [p.factor * _size(p.components, frictions) for p in pairs]
        largest = max(after, default=0.0)
        change = max((abs(a - b) for a, b in zip(after, frictions, strict=True)), default=0.0)
        if change <= ROUNDING_CHANGE * largest:
            return after
        most = min(most, ENDLESS * largest)
        if not largest <= most:
            return None
        frictions = after
    return None


def _size(components: WeightedComponents, frictions: Sequence[float]) -> float:
    return math.hypot(*(ideal + sum(map(mul, frictions, by)) for ideal, by in components))


def _followed(pairs: Sequence[SurfacePair]) -> list[float] | None:
    """Follow frictions from none of them; None where they end, or the loads are reversed."""
    way = _Way(pairs)
    found = way.followed()
    return way.frictions(found) if found is not None and found[-1] > 0 else None


class _Way:
    """The way from no friction to all of it; unknowns are sizes of forces, and of the loads.

    All are per unit of ``loads``, the size of what presses all pairs without friction.
    """

    def __init__(self, pairs: Sequence[SurfacePair]) -> None:
        self._factors = [p.factor for p in pairs]
        self._loads = math.hypot(*(ideal for p in pairs for ideal, _ in p.components)) or 1.0
        self.pairs = [[self._scaled(*c) for c in p.components] for p in pairs]
        by = (b for components in self.pairs for _, row in components for b in row)
        self._roundness = ROUNDED_OFF / max(1.0, math.hypot(*by))

    def _scaled(self, ideal: float, by: Sequence[float]) -> tuple[float, list[float]]:
        return ideal / self._loads, [b * f for b, f in zip(by, self._factors, strict=True)]

    def frictions(self, found: Sequence[float]) -> list[float]:
        """Return frictions under the loads as they are."""
        size = self._loads / found[-1]
        return [f * n * size for f, n in zip(self._factors, found, strict=False)]

    def near(self, start: Sequence[float]) -> list[float] | None:
        """Return forces and loads with all friction near a start, if Newton's method finds any."""
        found = [*start, 1.0]
        for _ in range(ATTEMPTS):
            residuals, matrix = self._equations(found, found, 1.0)
            if not eliminate(matrix, residuals):
                return None
            found = [x - r for x, r in zip(found, residuals, strict=True)]
            if math.hypot(*residuals) <= NONE * math.hypot(*found):
                return found if found[-1] > 0 else None
        return None

    def followed(self) -> list[float] | None:
        """Return forces and loads at the end."""
        here, step = 0.0, FIRST
        forces = (math.hypot(self._roundness, *(ideal for ideal, _ in cs)) for cs in self.pairs)
        found = [*forces, 1.0]
        side = self._side(found, here)
        for _ in range(PATH_STEPS):
            aim = min(1.0, here + step)
            ahead = self._corrected(found, aim, side)
            if ahead is not None and not self._turns(found, here, ahead, aim):
                here, found, step = aim, ahead, 2 * step
            else:
                step /= 2
            if here == 1.0 or step < SHORTEST:
                break
        return found if here == 1.0 else None

    def _turns(
        self, before: Sequence[float], here: float, ahead: Sequence[float], aim: float
    ) -> bool:
        """Return whether a force turns round from one place of the way to the next."""
        pairs = zip(self._directions(before, here), self._directions(ahead, aim), strict=True)
        return any(sum(map(mul, *both)) < TURNED for both in pairs)

    def _directions(self, found: Sequence[float], part: float) -> Iterator[list[float]]:
        """Yield the directions of forces, what rounds them off being a component, too."""
        least = max(self._rounded(found, part), LITTLE * math.hypot(*found))
        for components in self.pairs:
            sides = [least, *self._sides(components, found, part)]
            size = math.hypot(*sides)
            yield [side / size for side in sides]

    def _rounded(self, found: Sequence[float], part: float) -> float:
        return self._roundness * (1 - part) * found[-1]

    @staticmethod
    def _sides(components: WeightedComponents, found: Sequence[float], part: float) -> list[float]:
        """Return the components of a force."""
        *forces, load = found
        return [a * load + part * sum(map(mul, by, forces)) for a, by in components]

    def _side(self, found: Sequence[float], part: float) -> int:
        residuals, matrix = self._equations(found, found, part)
        return eliminate(matrix, residuals)

    def _corrected(self, before: Sequence[float], part: float, side: int) -> list[float] | None:
        """Return the solution near the one before, None where Newton's method finds none."""
        found, last = list(before), 0.0
        whole = math.hypot(*before)
        for _ in range(PATH_CORRECTIONS):
            residuals, matrix = self._equations(found, before, part)
            if eliminate(matrix, residuals) != side:
                return None
            size = math.hypot(*residuals) / whole
            if last and size > SHRINKS * last:
                return found if last < STALLED else None
            if not size <= LONGEST:
                return None
            found = [x - r for x, r in zip(found, residuals, strict=True)]
            if size <= NONE:
                return found
            last = size
        return None

    def _equations(
        self, found: Sequence[float], before: Sequence[float], part: float
    ) -> tuple[list[float], Matrix]:
        """Return residuals and slopes; forces and loads keep their size along those before."""
        forces, rounded = found[:-1], self._rounded(found, part)
        residuals, matrix = [], []
        for i, components in enumerate(self.pairs):
            sides = self._sides(components, found, part)
            size = math.hypot(rounded, *sides)
            units = [side / size if size else 0.0 for side in sides]
            row = [
                -part * sum(u * by[j] for u, (_, by) in zip(units, components, strict=True))
                for j in range(len(forces))
            ]
            row[i] += 1.0
            rest = self._roundness * (1 - part) * rounded / size if size else 0.0
            row.append(-rest - sum(u * a for u, (a, _) in zip(units, components, strict=True)))
            residuals.append(forces[i] - size)
            matrix.append(row)
        length = math.hypot(*before)
        along = [x / length for x in before]
        residuals.append(sum(map(mul, along, found)) - length)
        return residuals, [*matrix, along]
