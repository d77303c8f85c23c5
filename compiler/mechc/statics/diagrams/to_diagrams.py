"""The free-body diagrams of a mechanism: one for each set of loads that its results speak of.

Sizes of loads are those that the description gives, else one load is given the size 1 and
the other ones follow: forces are then per newton of it, or per newton metre.
"""

import math
from collections.abc import Callable, Iterator, Sequence, Set
from functools import partial

from ...base.frozen import frozen, replace
from ...model.mechanism import Torque
from ...model.parts.linkage import primed
from ...model.result import Result
from ...pose.places import NOWHERE
from ...pose.pose import Pose
from .. import all_forces
from ..poses import with_lets
from ..tolerances import FORCE_CHANGE
from ..unfold import Unfolding
from ..verdict import CONSTANT, MIXED
from .cut_free import PointPositions, StaticsSolution, cut_free, sizes_beyond_rounding
from .diagram import Acting, Diagram, FreeBody, ThreadMotion
from .load_cases import LoadCase, LoadSizes, cases, sizes_of

OTHER, MORE = 1.7, 0.31
"""By what chosen lengths are multiplied to see which forces depend on them, each by more."""

SolveCase = Callable[[Unfolding, LoadCase], StaticsSolution | str]


def diagrams(
    pose: Pose,
    results: tuple[Result, ...],
    values: LoadSizes,
    places: PointPositions,
    sizes: LoadSizes,
    nearby: LoadSizes,
) -> tuple[Diagram, ...]:
    """Return the free bodies under every set of loads, without friction and then with it.

    ``values`` are those of all symbols of the pose, ``places`` where its points are drawn,
    ``sizes`` those of loads that are given. A joint that does not slide has the friction of the
    pose that is ``nearby``, if there is one.
    """
    unfolding = Unfolding(pose, with_lets(pose.mechanism, values))
    near = replace(unfolding, values=with_lets(pose.mechanism, nearby)) if nearby else None
    found = cases(pose.mechanism, results, sizes_of(pose.mechanism, unfolding.values, sizes))
    several = {c.result for i, c in enumerate(found) if c.result in [o.result for o in found[:i]]}
    return tuple(
        diagram
        for case in found
        for diagram in _LoadSetMaker(unfolding, places, case, near).diagrams(
            mixed=case.result in several
        )
    )


@frozen
class _LoadSetMaker:
    """A mechanism at one pose under one set of loads."""

    unfolding: Unfolding
    places: PointPositions
    case: LoadCase
    nearby: Unfolding | None

    def diagrams(self, *, mixed: bool) -> Iterator[Diagram]:
        """Yield the diagram without friction, and one with it if there is any.

        Where friction is all that is overcome, nothing acts without it.
        """
        if self.case.sizes:
            yield self._solved("", all_forces.ideal)
        friction = self.unfolding.pose.mechanism.friction
        if friction.efficiency is not None:
            yield self._empty(friction.sense, CONSTANT)
        elif friction.joints and mixed:
            yield self._empty(friction.sense, MIXED)
        elif friction.joints:
            yield self._solved(
                friction.sense, partial(all_forces.with_friction, nearby=self.nearby)
            )

    def _empty(self, motion: ThreadMotion, trouble: str) -> Diagram:
        case = self.case
        return Diagram(case.result, motion, case.sizes, case.per, case.left_out, (), trouble)

    def _solved(self, motion: ThreadMotion, solve: SolveCase) -> Diagram:
        """Return the free bodies of a case with the sizes of all forces on them."""
        solution = solve(self.unfolding, self.case)
        if isinstance(solution, str):
            return self._empty(motion, solution)
        factor, per = self._scale(solution)
        scaled = solution.times(factor)
        bodies = self._cut(scaled)
        other = solve(self._at_other_lengths(), self.case)
        if not isinstance(other, str):
            bodies = tuple(_marked(bodies, self._cut(other.times(factor)), self._loose()))
        sizes = sizes_beyond_rounding(scaled, bodies, self._torques, self.places)
        sizes |= {n: s for n, s in scaled.sizes.items() if n in self.case.sizes}
        loads = {n: s for n, s in sizes.items() if n not in solution.frictions}
        bodies = tuple(_without({n for n, s in loads.items() if not s}, body) for body in bodies)
        return Diagram(self.case.result, motion, loads, per, self.case.left_out, bodies)

    @property
    def _torques(self) -> frozenset[str]:
        loads = self.unfolding.pose.mechanism.loads
        return frozenset(load.name for load in loads if isinstance(load, Torque))

    def _cut(self, solution: StaticsSolution) -> tuple[FreeBody, ...]:
        return cut_free(solution, self.places)

    def _scale(self, solution: StaticsSolution) -> tuple[float, str]:
        """Return by what forces are multiplied, and the load of which they are per unit then.

        A load whose size is zero here, or has the other sign, can be no measure of the rest.
        """
        if self.case.scale is None:
            return 1.0, self.case.per
        name, size = self.case.scale
        here = solution.sizes[name]
        return (size / here, "") if size * here > 0 else (1.0, next(iter(self.case.sizes)))

    def _at_other_lengths(self) -> Unfolding:
        """Return the same pose where lengths that nothing fixes are longer."""
        pose, values = self.unfolding.pose, self.unfolding.values
        open_ = [name for name, length in pose.placeholders.items() if length is None]
        longer = {name: (OTHER + MORE * i) * values[name] for i, name in enumerate(open_)}
        return replace(self.unfolding, values={**values, **longer})

    def _loose(self) -> frozenset[str]:
        """Return the slides of which nothing says where on them the pins are, in both halves."""
        pose = self.unfolding.pose
        touched = {contact.body for contact in pose.contacts}
        bare = {s.name for s in pose.mechanism.slides if not any(pose.frames[s.name].values())}
        found = (touched & pose.slides.keys()) | bare
        return frozenset((*found, *(primed(name) for name in found)))


def _without(idle: Set[str], body: FreeBody) -> FreeBody:
    """Return a body on which loads of no size have no couple."""
    forces = (
        a._replace(moment=0.0) if a.kind == "load" and a.by in idle else a for a in body.forces
    )
    return body._replace(forces=tuple(forces))


def _marked(
    bodies: Sequence[FreeBody], others: Sequence[FreeBody], loose: Set[str]
) -> Iterator[FreeBody]:
    """Yield bodies with the forces marked that are not the same at other lengths or places."""
    sizes = (math.hypot(*(a.force or NOWHERE)) for body in bodies for a in body.forces)
    rounding = FORCE_CHANGE * max(sizes, default=0.0)
    for body, other in zip(bodies, others, strict=True):
        tilts = body.name in loose
        both = zip(body.forces, other.forces, strict=True)
        forces = (a._replace(chosen=_differ(a, b, rounding) or _tilts(a, tilts)) for a, b in both)
        yield body._replace(forces=tuple(forces))


def _differ(one: Acting, other: Acting, rounding: float) -> bool:
    if one.force is None or other.force is None:
        return False
    return math.dist(one.force, other.force) > rounding


def _tilts(acting: Acting, loose: bool) -> bool:
    return loose and acting.kind == "guide" and acting.moment != 0
