"""From a balance of powers and a figure to velocities in numbers, in their sense and size."""

import math
from collections.abc import Iterator, Mapping

from ..base.frozen import frozen, replace
from ..formula.evaluate import evaluate
from ..model.mechanism import Torque
from ..model.values import Chain
from ..pose.motion import Motion
from ..power.balance import Balance, Term
from .figure import Figure
from .tolerances import NO_SPEED, SAME_VELOCITY
from .velocities import MotionVelocities, rates

OTHER, MORE = 1.7, 0.31
"""By what chosen lengths are multiplied to see which velocities depend on them, each by more."""


def velocities(
    balance: Balance, figure: Figure, motion: Motion | None
) -> tuple[MotionVelocities, ...]:
    """Return the velocities of each independent motion, but for one that its drive cannot move.

    They have the sense in which the drive of the description moves, else that in which the
    load does work that a ratio has above the line, and the size that the drive's speed gives
    them.
    """
    made = (_MotionMaker(balance, figure, motion, i).made() for i in range(balance.plan.mobility))
    return tuple(found for found in made if found is not None)


@frozen
class _MotionMaker:
    """One independent motion of a mechanism at the pose of its figure."""

    balance: Balance
    figure: Figure
    motion: Motion | None
    drive: int

    def made(self) -> MotionVelocities | None:
        """Return the velocities in their sense and size; None at a dead centre."""
        plan, figure = self.balance.plan, self.figure
        try:
            here = rates(plan, figure, figure.values, self.drive)
            there = rates(plan, figure, self._at_other_lengths(), self.drive)
            pace = self._pace(here)
        except (KeyError, ZeroDivisionError):
            return None
        if not math.isfinite(here.largest) or not here.largest:
            return None
        per = "" if self._is_timed else self._reference(here)
        found, other = (v.times(pace / (v.speed(per) if per else 1.0)) for v in (here, there))
        return replace(found, per=per, chosen=frozenset(_different(found, other)))

    def _at_other_lengths(self) -> Mapping[str, float]:
        """Return the values of the same pose where lengths that nothing fixes are longer."""
        lengths, values = self.balance.plan.graph.pose.placeholders, self.figure.values
        open_ = [name for name, length in lengths.items() if length is None]
        longer = {name: (OTHER + MORE * i) * values[name] for i, name in enumerate(open_)}
        return {**values, **longer}

    # ------------------------------------------------------------------- sense and size

    @property
    def _is_timed(self) -> bool:
        """Return whether velocities are known in metres a second."""
        quantities = self.motion.quantities if self.motion else ()
        return self._is_alone and any(q.kind == "velocity" and q.axis for q in quantities)

    @property
    def _is_alone(self) -> bool:
        return self.balance.plan.mobility == 1

    def _pace(self, here: MotionVelocities) -> float:
        """Return the factor of velocities; 1 or −1, the sense, where that is open."""
        rate = self._rate(here) if self._is_alone else 0.0
        return rate if self._is_timed else math.copysign(1.0, rate or self._work() or 1.0)

    def _rate(self, here: MotionVelocities) -> float:
        """Return how fast the drive goes, as it is given or by itself; 0 where that is open."""
        above = below = 0.0
        for point, axis, rate in self._slopes():
            plain = here.points[point].x if axis == "x" else here.points[point].y
            above, below = above + rate * plain, below + plain * plain
        return above / below if below else 0.0

    def _slopes(self) -> Iterator[tuple[str, str, float]]:
        """Yield how fast coordinates of points grow in time, or along the stroke."""
        if self.motion is None:
            return
        definitions = (*self.balance.plan.graph.pose.definitions, *self.motion.definitions)
        values = Chain(dict(definitions)).complete(self.figure.values)
        for quantity in self.motion.quantities:
            if quantity.kind in ("velocity", "slope") and quantity.axis:
                yield quantity.of, quantity.axis, evaluate(quantity.formula, values)

    def _work(self) -> float:
        """Return the power of a unit of the driving load, which it takes up when it is released."""
        term, friction = self._driving, self.balance.plan.graph.pose.mechanism.friction
        sense = -1 if friction.sense == "releasing" else 1
        return sense * term.power[self.drive].evaluate(self.figure.values) if term else 0.0

    @property
    def _driving(self) -> Term | None:
        """Return the load that the first ratio has above the line."""
        above = next((s.above for s in self.balance.solved if s.above), "")
        return next((t for t in self.balance.terms if t.load.name == above), None)

    def _reference(self, here: MotionVelocities) -> str:
        """Return the point whose speed is the unit: where that load acts, else the fastest one."""
        moving = (p for p in self._loaded() if here.speed(p) > NO_SPEED * here.largest)
        return next(moving, max(here.points, key=here.speed))

    def _loaded(self) -> tuple[str, ...]:
        """Return the points that the driving load acts on, those of its link for a couple."""
        load = self._driving.load if self._driving else None
        if isinstance(load, Torque):
            return self.balance.plan.graph.pose.mechanism.link(load.link).points
        return load.points[::-1] if load else ()


def _different(one: MotionVelocities, other: MotionVelocities) -> Iterator[str]:
    """Yield the points and links whose velocities aren't the same."""
    for point, velocity in one.points.items():
        if math.dist(velocity, other.points[point]) > SAME_VELOCITY * one.largest:
            yield point
    for link, spin in one.spins.items():
        if abs(spin - other.spins[link]) > SAME_VELOCITY * abs(spin):
            yield link
