"""What is said along a stroke of ratios and forces, against emitted code that lies close.

Every zero and pole, every jump, every end of a loop and every extremum that the places show must
be stated, and nothing else; the ratio, the status of the pose and the stretches must agree on where
there is a pose at all. Each function yields what is refuted, in words; nothing where all holds.
"""

from collections.abc import Callable, Iterable, Iterator

import numpy as np

from mechc.compilation import Compilation
from mechc.model.parts.targets import (
    Axial,
    Efficiency,
    LoadRatio,
    Normal,
    Reaction,
    ResultTarget,
    SpeedRatio,
    WithFriction,
)
from mechc.routine.evaluate import evaluate, pose
from mechc.routine.steps import Function, PoseProgram
from mechc.study.stroke.run import SAMPLES
from mechc.study.stroke.stroke import Stroke

SAME_FIGURES = 1e-6
"""A turn by a smaller part of a value shows in none of the six figures that are printed."""

PLACES = 2001

ROUNDED_ZERO = 1e-14
"""What is smaller, in SI, is rounding: a load that works against nothing."""

ROUNDED = 1e-6
"""A part of a cell: a place that is this near to a zero, pole or branch point is that place."""

Array = np.ndarray


class Curve:
    """A result, its stroke, and its values at places that lie close together."""

    def __init__(self, compilation: Compilation, stroke: Stroke, name: str) -> None:
        self.name, self.stroke = name, stroke
        self.function = next(f for f in compilation.routine.functions if f.name == name)
        self.pose = compilation.routine.pose
        self.range = stroke.high - stroke.low
        self.places = np.linspace(stroke.low, stroke.high, PLACES)
        self.cell = self.places[1] - self.places[0]
        found = self.at(self.places)
        zero_intervals = self.where_zero()
        self.k = np.where(
            (np.abs(found) < ROUNDED_ZERO) | (zero_intervals & np.isfinite(found)), 0.0, found
        )
        finite = np.abs(self.k[np.isfinite(self.k) & ~zero_intervals])
        self.size = float(np.median(finite)) if finite.size else 0.0
        self.singular = [s for s in stroke.singular if s.result == name]
        self.extrema = [e for e in stroke.extrema if e.result == name]
        self.branches = [b.drive for b in stroke.branches]
        self.poles = [s.drive for s in self.singular if s.value != "0"]
        self.jumps = [s for s in self.singular if s.sides]

    def where_zero(self) -> Array:
        """Return at which places the result is said to be zero throughout, which others refute."""
        parts = [n for n in self.stroke.zero_intervals if n.result == self.name]
        inside = [(self.places >= n.low) & (self.places <= n.high) for n in parts]
        return np.any(inside, axis=0) if inside else np.zeros(PLACES, bool)

    def inputs(
        self, part: Function | PoseProgram, places: Array
    ) -> dict[str, Array | float | None]:
        drive = self.stroke.drive
        return {i.name: places if i.name == drive else i.default for i in part.inputs}

    def at(self, places: Iterable[float]) -> Array:
        there = np.asarray(places)
        found = evaluate(self.function, self.inputs(self.function, there))
        return np.broadcast_to(found, np.shape(there))

    def with_sides(self, place: float) -> Iterable[float]:
        """Return the value at a place, and the limits from both sides."""
        steps = np.array([-1e-7, 1e-7]) * self.range
        here, near, far = (self.at(place + part * steps) for part in (0, 1, 2))
        return (float(here[0]), *map(float, 2 * near - far))

    def is_at_rest(self, place: float) -> bool:
        """Return whether friction holds the mechanism nearby: an efficiency is 0 there."""
        parts = (s for s in self.stroke.standstills if self.name.startswith("eta"))
        return any(s.low - 2 * self.cell <= place <= s.high + 2 * self.cell for s in parts)

    def is_near(self, place: float, others: Iterable[float], cells: float) -> bool:
        return any(abs(place - other) <= cells * self.cell for other in others)


def curves(compilation: Compilation, stroke: Stroke) -> Iterator[Curve]:
    """Yield the ratios without friction that move along the stroke."""
    routine = {f.name: f for f in compilation.routine.functions}
    for result in compilation.results:
        inputs = routine[result.name].inputs if result.name in routine else ()
        is_ratio = isinstance(result.target, LoadRatio | SpeedRatio)
        if is_ratio and stroke.drive in {i.name for i in inputs}:
            yield Curve(compilation, stroke, result.name)


def forces(compilation: Compilation, stroke: Stroke) -> Iterator[Curve]:
    """Yield forces at joints, and what friction makes of results, that move along the stroke.

    Where a ratio without friction is infinite they may be, too; that is stated of the ratio.
    """
    routine = {f.name: f for f in compilation.routine.functions}
    infinite = [s.drive for s in stroke.singular if s.value == "infinite"]
    for result in compilation.results:
        inputs = routine[result.name].inputs if result.name in routine else ()
        if is_force(result.target) and stroke.drive in {i.name for i in inputs}:
            curve = Curve(compilation, stroke, result.name)
            curve.poles += infinite
            yield curve


def is_force(target: ResultTarget | None) -> bool:
    match target:
        case Reaction(part="direction") | WithFriction(Reaction(part="direction")):
            return False
        case Reaction() | Axial() | Normal() | WithFriction() | Efficiency():
            return True
        case _:
            return False


def refuted(compilation: Compilation, stroke: Stroke) -> Iterator[str]:
    """Yield every statement on a ratio or a force along a stroke that code refutes."""
    for curve in curves(compilation, stroke):
        yield from said_of(curve, CHECKS)
    signed = {r.name for r in compilation.results if not is_of_size(r.target)}
    for curve in forces(compilation, stroke):
        checks = CHECKS_OF_FORCES if curve.name in signed else CHECKS_OF_FORCES[:-1]
        yield from said_of(curve, checks)


def is_of_size(target: ResultTarget | None) -> bool:
    """Return whether nothing is said of where a result is zero."""
    of = target.of if isinstance(target, WithFriction) else target
    is_first = isinstance(target, WithFriction) and target.order == "first"
    is_signed = isinstance(of, Axial | Normal) or (isinstance(of, Reaction) and of.part != "size")
    return is_first or not is_signed


def said_of(curve: Curve, checks: Iterable[Callable[[Curve], Iterator[str]]]) -> Iterator[str]:
    for check in checks:
        yield from (f"{curve.name}, {check.__name__}: {said}" for said in check(curve))


def where_there_is_a_pose(seen: Curve) -> Iterator[str]:
    finite = np.isfinite(seen.k)
    if seen.pose:
        _, status = pose(seen.pose, seen.inputs(seen.pose, seen.places))
        differs = (np.broadcast_to(status, finite.shape) == 0) != finite
        known = [*seen.branches, *(s.drive for s in seen.singular)]
        differs &= [not seen.is_near(x, known, ROUNDED) for x in seen.places]
        yield from (f"pose and result disagree at {x}" for x in seen.places[differs][:1])
    stated = np.zeros(PLACES, bool)
    ends = list(seen.branches)
    for stretch in seen.stroke.stretches:
        stated |= (seen.places >= stretch.low) & (seen.places <= stretch.high)
        ends += [stretch.low, stretch.high]
    known = stated | ~(finite & ~narrow(seen, finite))
    apart = np.array([not seen.is_near(x, ends, 1.0) for x in seen.places])
    yield from (f"no pose at {x}" for x in seen.places[stated & ~finite & apart][:1])
    yield from (f"a pose at {x} is left out" for x in seen.places[~known & apart][:1])


def narrow(seen: Curve, finite: Array) -> Array:
    """Return where there is a pose on so short a part that it may be missed, as is said."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], finite, [False]])))
    missed = np.zeros(PLACES, bool)
    for start, end in edges.reshape(-1, 2):
        missed[start:end] = (end - start) * seen.cell <= seen.range / SAMPLES
    return missed


def changes_of_sign(seen: Curve) -> Iterator[str]:
    """Wherever k changes its sign it is zero, infinite, or jumps, and that is stated."""
    stated = [s.drive for s in seen.singular]
    for i in range(PLACES - 1):
        here, there = seen.k[i : i + 2]
        if not here * there < 0 or seen.is_near(seen.places[i], seen.branches, 2.0):
            continue
        middle = seen.places[i] + seen.cell / 2
        if not seen.is_near(middle, stated, 0.500001):
            yield f"{here} … {there} at {middle}"


def singular_poses(seen: Curve) -> Iterator[str]:
    """Where k is said to be zero it is small nearby, and large where it is said to be infinite.

    Next to a pole a zero is steep: k is then far smaller nearer by.
    """
    for singular in seen.singular:
        beside = np.array([-1e-7, -1e-10, 1e-10, 1e-7]) * seen.range + singular.drive
        sizes = np.abs(seen.at(beside))
        sizes = sizes[np.isfinite(sizes)]
        small = max(1e-3 * seen.size, 1e-2 * sizes.max(initial=0.0)) + 1e-12
        if singular.value == "0" and sizes.size and not sizes.min() < small:
            yield f"{sizes.min()} beside {singular}"
        if singular.value == "infinite" and sizes.size and not sizes.max() > 20 * seen.size:
            yield f"{sizes.max()} beside {singular}"


def extrema(seen: Curve) -> Iterator[str]:
    """What turns without a word, and what is said to turn and does not.

    The latter is looked at within half a cell, or nearer than the next one that is stated.
    """
    stated = [e.drive for e in seen.extrema]
    for i in range(2, PLACES - 2):
        five, place = seen.k[i - 2 : i + 3], seen.places[i]
        steps = np.sign(np.diff(five))
        turns = abs(steps.sum()) == 0 and steps[0] == steps[1] == -steps[2] == -steps[3] != 0
        least = max(1e-9 * seen.size, SAME_FIGURES * abs(five[2]))
        if not turns or abs(five[2] - five[0]) < least or seen.is_at_rest(place):
            continue
        if seen.is_near(place, seen.poles, 3.0) or seen.is_near(place, seen.branches, 4.0):
            continue
        if not seen.is_near(place, stated, 2.0):
            yield f"k turns at {place}"
    for place, value in ((e.drive, e.value) for e in seen.extrema):
        if value == 0 and seen.is_at_rest(place):  # on one side nothing moves
            continue
        if not seen.is_near(place, [*seen.poles, *seen.branches], 3.0):
            away = (abs(other - place) / 4 for other in stated if other != place)
            step = min([seen.cell / 2, *away])
            before, here, after = seen.at([place - step, place, place + step])
            if before < here < after or before > here > after:
                yield f"k does not turn at {place}"


def values_of_extrema(seen: Curve) -> Iterator[str]:
    """Where an extremum is stated a result has its value, or is that far away at this place alone.

    There a joint does not slide for an instant: it has no friction in code.
    """
    jumps = [jump.drive for jump in seen.jumps]
    for extremum in seen.extrema:
        if seen.is_near(extremum.drive, jumps, ROUNDED):
            continue
        k, *sides = seen.with_sides(extremum.drive)
        is_met = [abs(x - extremum.value) <= 1e-6 * max(seen.size, abs(x)) for x in (k, *sides)]
        if not is_met[0] and not all(is_met[1:]):
            yield f"{k} at {extremum}"


def sides_of_jumps(seen: Curve) -> Iterator[str]:
    """Sides of jumps that no values next to these lead to, and jumps that are none.

    It is looked at two distances: at the nearer one code may be rounding, next to what is infinite.
    """
    for jump in seen.jumps:
        by_distance = [beside_jump(seen, jump.drive, x * seen.range) for x in (1e-7, 1e-6)]
        beside = by_distance[0]
        stated = jump.sides or ()
        if not any(np.allclose(sides, stated, rtol=1e-3, atol=1e-12) for sides in by_distance):
            yield f"{beside} beside {jump}"
        if not abs(beside[0] - beside[1]) > SAME_FIGURES * np.abs(beside).max():
            yield f"{beside} beside {jump}: no jump"


def beside_jump(seen: Curve, place: float, step: float) -> Array:
    """Return the limits from both sides of a place, by values one and two steps away."""
    near, far = (seen.at(np.array([-x, x]) + place) for x in (step, 2 * step))
    return 2 * near - far


def jumps(seen: Curve) -> Iterator[str]:
    """Wherever k differs much more between two places than beside them, and keeps doing so."""
    stated = [*(s.drive for s in seen.singular), *seen.branches]
    stated += [end for s in seen.stroke.stretches for end in (s.low, s.high)]
    for i in range(1, PLACES - 2):
        before, step, after = apart(seen.k[i - 1 : i + 3])
        if step > 5 * max(before, after) and step > 1e-6 * seen.size:
            place = between(seen, i)
            sides = seen.at(np.array([-1e-8, 1e-8]) * seen.range + place)
            is_jump = apart(sides)[0] > 0.1 * step
            if is_jump and not seen.is_near(place, stated, 1.0):
                yield f"k jumps at {place}"


@np.errstate(invalid="ignore")
def apart(values: Array) -> Array:
    """Return by how much each value differs from the next; NaN where both are infinite."""
    return np.abs(np.diff(values))


@np.errstate(invalid="ignore")
def between(seen: Curve, i: int) -> float:
    """Return the place in a cell about which k differs most."""
    low, high = seen.places[i : i + 2]
    before, after = seen.k[i : i + 2]
    for _ in range(30):
        middle = (low + high) / 2
        here = seen.at([middle])[0]
        if abs(here - before) < abs(here - after):
            low, before = middle, here
        else:
            high, after = middle, here
    return float(low)


CHECKS: tuple[Callable[[Curve], Iterator[str]], ...] = (
    values_of_extrema,
    sides_of_jumps,
    jumps,
    where_there_is_a_pose,
    changes_of_sign,
    singular_poses,
    extrema,
)

CHECKS_OF_FORCES = (
    values_of_extrema,
    sides_of_jumps,
    jumps,
    singular_poses,
    extrema,
    changes_of_sign,
)
"""The last one is for forces that have a sign."""
