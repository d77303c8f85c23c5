"""From the mechanism to its pose: directions found, loops checked, frames laid out."""

from collections.abc import Mapping

from ..algebra.angle import Angle
from ..diagnostics import Report
from ..diagnostics import pose as messages
from ..formula.walk import symbols
from ..frozen import replace
from ..model.mechanism import (
    Along,
    Direction,
    Force,
    ForcePair,
    Link,
    Mechanism,
    Slide,
    Slider,
    Telescope,
)
from ..model.results import failures
from ..model.values import holds
from .bodies import aligned, on_the_line, touches
from .closure import Closure, Condition, across
from .directions import Directions
from .drawn import drawn_elsewhere, driven_to, given_by_hand
from .force_pairs import Pairing, thrust_line
from .idle import contradictions, remarks
from .loops.closed import Closed, Open
from .loops.closing import close
from .loops.guide_lines import with_lines
from .loops.vector_graph import chained, mentioned
from .pose import Pose, Vector
from .pruning import pruned
from .queries import with_directions
from .samples import poses_nearby
from .terms import Terms
from .unfound import explained, unfound_angles
from .vectors import Missing, Vectors
from .wheels import misfits, radii


def solve_pose(mechanism: Mechanism, report: Report) -> Pose:
    """Return the pose of a mechanism whose directions are given.

    Reports E301 and E305 where a direction is missing, E302 where two disagree, E303
    and E304 where a loop does not close for independent symbols. W302 remarks on gears
    that do not reach one another.
    """
    for fault in contradictions(mechanism.assemblies):
        report.add(fault)
    report.stop_on_errors()
    mechanism = with_lines(replace(mechanism, geometry=aligned(mechanism)))
    terms = Terms(mechanism)
    directions = Directions(mechanism, terms, report)
    vectors = Vectors(mechanism, terms, directions)
    closed = close(mechanism, terms, directions, vectors, report)
    mechanism = closed.mechanism
    for fault in unfound_angles(mechanism, vectors, closed.found, closed.left):
        report.add(fault)
    report.stop_on_errors()
    mechanism = with_directions(mechanism, vectors, report)
    survey = _Survey(mechanism, terms, directions, vectors, report)
    pose = survey.pose(closed)
    unfound = survey.report_unfound(pose, closed.found, closed.left)
    survey.close_loops(pose, unfound)
    report.stop_on_errors()
    _remark(pose, vectors, closed, report)
    return driven_to(pruned(pose), report)


def _remark(pose: Pose, vectors: Vectors, closed: Closed, report: Report) -> None:
    """Remark on what the default pose breaks: conditions on what was found, centre distances.

    E318 reports an assembly that it refutes; W301 remarks on others that decide nothing.
    """
    default = poses_nearby(pose.mechanism, pose.definitions)[0]
    for assembly in closed.idle:
        for remark in remarks(assembly, vectors, default):
            report.add(remark)
    given = {p.name for p in pose.mechanism.parameters} - closed.found
    lets = {let.name for let in pose.mechanism.lets}
    for condition in pose.mechanism.requires:
        is_given = symbols(condition.left) | symbols(condition.right) <= given
        if not is_given and not holds(condition, default):
            report.add(failures.broken(condition, default, report.source, lets))
    for fault in drawn_elsewhere(pose.mechanism.drawn, vectors, default):
        report.add(fault)
    for misfit in misfits(pose, vectors, default):
        report.add(messages.gears_apart(*misfit))


class _Survey:
    """Reads frames and named directions off the vectors, reporting what is missing."""

    def __init__(
        self,
        mechanism: Mechanism,
        terms: Terms,
        directions: Directions,
        vectors: Vectors,
        report: Report,
    ) -> None:
        self._mechanism, self._terms = mechanism, terms
        self._directions, self._vectors, self._report = directions, vectors, report
        self._missing = Missing(vectors)

    def pose(self, closed: Closed) -> Pose:
        """Return all directions and frames, read in the order of their definitions."""
        guides, axis = self.guides(), self.axis()
        lines = {**self.lines(), **self.thrusts()}
        held = tuple(touches(self._mechanism, self._directions, self._vectors, self.direction))
        frames, slides = self.frames(), self.slides()
        return Pose(
            mechanism=self._mechanism,
            frames=frames,
            guides=guides,
            lines=lines,
            axis=axis,
            definitions=tuple(self._terms.definitions),
            placeholders=dict.fromkeys(self._vectors.placeholders),
            free=tuple(p.name for p in self._mechanism.parameters if not p.dependent),
            rates=closed.rates,
            slides=slides,
            touches=held,
            radii={radius: self._terms.length(radius) for radius in radii(self._mechanism)},
            limits=closed.limits,
            loops=closed.loops,
            closing=tuple(self._terms.definitions),
            put_in=tuple(d for d in self._terms.definitions if d.name in closed.put_in),
            vectors=self._vectors.given(),
            solved=closed.solved,
            falls=self.falls(),
        )

    def falls(self) -> Mapping[str, tuple[Angle, ...]]:
        """Return the directions of the falls of every rope."""
        return {rope.id: tuple(self._fall(w) for w in rope.ways) for rope in self._mechanism.ropes}

    def _fall(self, way: Direction) -> Angle:
        return self.direction(way, "theta_rope", "a fall of the rope")

    def frames(self) -> Mapping[str, Mapping[str, Vector]]:
        """Return the frames of links and slides."""
        frames = {link.name: self.frame(link) for link in self._mechanism.links}
        frames |= {slide.name: self.layout(slide) for slide in self._mechanism.slides}
        return frames | {t.name: self.stretched(t) for t in self._mechanism.cylinders}

    def stretched(self, telescope: Telescope) -> Mapping[str, Vector]:
        """Return the vector between the ends of a telescope as one arm along it.

        The pair of forces inside has seen to that, or reported what is missing.
        """
        first, second = telescope.points
        return {first: (), second: self._vectors.path(first, second) or ()}

    def frame(self, link: Link) -> Mapping[str, Vector]:
        """Return the vectors from a link's first point to each of its points."""
        base = link.points[0]
        frame: dict[str, Vector] = {base: ()}
        for point in link.points[1:]:
            vector = self._vectors.path(base, point, link.points) or self._vectors.path(base, point)
            if not vector:
                self._report_missing(link, base, point, vector)
                vector = ()
            frame[point] = vector
        return frame

    def layout(self, slide: Slide) -> Mapping[str, Vector]:
        """Return the vectors from a slide's first point, as far as they are given.

        Velocities need none of them; where one is missing the guide's couple is open.
        """
        base = slide.points[0]
        paths = {p: self._vectors.path(base, p) or () for p in slide.points}
        return {p: () if self._vectors.is_open(path) else path for p, path in paths.items()}

    def _report_missing(self, link: Link, base: str, point: str, found: Vector | None) -> None:
        name = f"link {link.name}"
        if found is None and self._missing.is_first(base, point):
            self._report.add(messages.missing_direction(link.span, f"{base}{point}", name))
        elif found is not None:
            self._report.add(messages.points_coincide(link.span, f"{base}{point}"))

    def guides(self) -> Mapping[str, Angle]:
        """Return the direction of every guide."""
        return {
            s.point: self.direction(s.along, f"theta_{s.point}", f"the guide of {s.point}")
            for s in self._mechanism.each(Slider)
        }

    def lines(self) -> Mapping[str, Angle]:
        """Return the direction of every force."""
        return {
            f.name: self.direction(f.along, f"theta_{f.name}", f"the force {f.name}")
            for f in self._mechanism.loads
            if isinstance(f, Force)
        }

    def axis(self) -> Angle | None:
        """Return the direction of the mirror line."""
        mirror = self._mechanism.mirror
        return self.direction(mirror.across, "theta_mirror", "the mirror") if mirror else None

    def slides(self) -> Mapping[str, Angle]:
        """Return the direction of every body that only translates."""
        return {
            s.name: self.direction(s.along, f"theta_{s.name}", f"the slide {s.name}")
            for s in self._mechanism.slides
        }

    def thrusts(self) -> Mapping[str, Angle]:
        """Return the direction in which each pair of forces pushes its second point."""
        pairs = [t for t in self._mechanism.loads if isinstance(t, ForcePair)]
        return {t.name: thrust_line(t, self._pairing()) for t in pairs}

    def _pairing(self) -> Pairing:
        return Pairing(self._mechanism, self._terms, self._vectors, self.axis(), self._report)

    def direction(self, direction: Direction, name: str, for_what: str) -> Angle:
        """Return a direction as an angle; report one that nothing gives."""
        angle = self._directions.resolve(direction, name)
        if angle is None:
            assert isinstance(direction, Along)
            angle = self._along_path(direction, for_what)
        return angle or Angle()

    def _along_path(self, direction: Along, for_what: str) -> Angle | None:
        """Return the direction of a vector that is a sum, named where it is no single arm."""
        tail, head, quarter, span = (
            direction.tail,
            direction.head,
            direction.quarter,
            direction.span,
        )
        vector = self._vectors.path(tail, head)
        if vector is None:
            if self._missing.is_first(tail, head):
                self._report.add(messages.missing_direction(span, f"{tail}{head}", for_what))
        elif not vector or (len(vector) > 1 and self._vectors.is_open(vector)):
            self._report.add(messages.no_direction_of_its_own(span, f"{tail}{head}"))
        elif len(vector) > 1:
            return self._vectors.straighten(tail, head) + Angle.constant(90 * quarter)
        else:
            sign = -1 if vector[0].length.coefficient < 0 else 1
            return vector[0].angle + Angle.constant(90 * quarter + (0 if sign > 0 else 180))
        return None

    def report_unfound(self, pose: Pose, found: frozenset[str], left: Open) -> frozenset[str]:
        """Report why the directions of links are open that no loop gives; name directions."""
        sought = {n: at for n, at in self._directions.sought.items() if n not in found}
        needed: dict[str, Link] = {}
        for link in self._mechanism.links:
            used = {n for vector in pose.frames[link.name].values() for n in mentioned(vector)}
            needed |= dict.fromkeys(sorted(used & sought.keys() - needed.keys()), link)
        causes = explained(self._mechanism, self._vectors, sought, needed, left)
        for fault in () if self._missing.are_any else causes:
            self._report.add(fault)
        return frozenset(needed)

    def close_loops(self, pose: Pose, unfound: frozenset[str]) -> None:
        """Report every loop that does not close for independent symbols, all of them known."""
        given = given_by_hand(self._mechanism) if self._mechanism.drawn else None
        closure = Closure(pose.placeholders, {d.name for d in pose.definitions}, given)
        values = poses_nearby(self._mechanism, pose.definitions)
        slots = on_the_line([t for t in pose.touches if t.kind == "slot"], self._vectors)
        for condition in (*self._loops(), *self._guide_lines(pose), *slots):
            if unfound & mentioned(condition.arms):
                continue
            if fault := closure.check(condition, values):
                self._report.add_first(fault)

    def _loops(self) -> list[Condition]:
        everywhere = (Angle(), Angle.constant(90))
        return [
            Condition(chained(p or "origin" for p in loop.points), loop.arms, everywhere, loop.span)
            for loop in self._vectors.loops
        ]

    def _guide_lines(self, pose: Pose) -> list[Condition]:
        """Return the condition of every guide that is said to pass through a point."""
        conditions = []
        for slider in self._mechanism.each(Slider):
            chain = slider.through and self._vectors.chain(slider.point, slider.through)
            if chain:
                arms, normal = self._vectors.arms(chain), across(pose.guides[slider.point])
                name = chained(chain)
                conditions.append(Condition(name, arms, (normal,), slider.span))
        return conditions
