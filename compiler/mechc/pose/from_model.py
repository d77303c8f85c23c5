"""From the mechanism to its pose: directions found, loops checked, frames laid out."""

from collections.abc import Iterator, Mapping, Set
from functools import cache, partial

from ..algebra.angle import QUARTER, Angle
from ..base.frozen import replace
from ..base.named import NamedTuple
from ..diagnostics import Report
from ..formula.tree import Formula
from ..model.boxes import allowed_box
from ..model.mechanism import ForcePair, Link, Mechanism, RopeFriction, Slider
from ..source import Span
from . import assembly_checks, force_pairs, lines
from .asked_vectors import with_directions
from .bodies import aligned, contacts, frames, on_the_line
from .closure_check import ClosingEquations, ClosureCondition, across, given_by_hand
from .directions import Directions
from .given_angles import in_given_angles
from .loops.closing import close
from .loops.guide_lines import with_lines
from .missing_directions import explained, unfound_angles
from .pose import Closed, Pose
from .pruning import pruned
from .remarks import moved_from_drawing, remark_on_conditions, remark_on_drawing
from .samples import poses_nearby
from .terms import AlgebraicTerms
from .vector_graph import chained, mentioned
from .vectors import Missing, Vectors, senses


def solve_pose(mechanism: Mechanism, report: Report) -> Pose:
    """Return the pose of a mechanism whose directions are given.

    Reports E301 and E305 where a direction is missing, E302 where two disagree, E303
    and E304 where a loop does not close for independent symbols. W302 remarks on gears
    that do not reach one another.
    """
    if mechanism.assemblies:
        for fault in assembly_checks.contradictions(mechanism.assemblies):
            report.add(fault)
    report.stop_on_errors()
    mechanism = with_lines(replace(mechanism, geometry=aligned(mechanism)))
    terms = AlgebraicTerms(mechanism)
    directions = Directions(mechanism, terms, report)
    vectors = Vectors(mechanism, terms, directions)
    closed = close(mechanism, terms, directions, vectors, report)
    mechanism = closed.mechanism
    for fault in unfound_angles(mechanism, vectors, closed.found, closed.left):
        report.add(fault)
    report.stop_on_errors()
    mechanism = with_directions(mechanism, vectors, report)
    read = _PoseReading(mechanism, terms, directions, vectors, Missing(vectors), report)
    pose = _pose(read, closed)
    unfound = _links_without_direction(pose, read, closed)
    if not read.missing.are_any:
        for fault in explained(mechanism, vectors, read.sought(closed), unfound, closed.left):
            report.add(fault)
    _check_loops(pose, read, unfound.keys())
    report.stop_on_errors()
    remark_on_drawing(pose, vectors, closed, report)
    moved = moved_from_drawing(pruned(pose), report)
    remark_on_conditions(moved, closed, report)
    return _without_guides_of_slides(in_given_angles(moved))


def _without_guides_of_slides(pose: Pose) -> Pose:
    """Return a pose without the guides that only said where drawn slides run, for loops to close.

    A slide has a guide of its own, and what holds it twice leaves open which of them is pressed.
    """
    placed = {s.point for s in pose.mechanism.each(Slider) if s.is_of_slide}
    if not placed:
        return pose
    joints = pose.mechanism.joints
    held = tuple(j for j in joints if not (isinstance(j, Slider) and j.is_of_slide))
    guides = {point: along for point, along in pose.guides.items() if point not in placed}
    return replace(pose, mechanism=replace(pose.mechanism, joints=held), guides=guides)


class _PoseReading(NamedTuple):
    """What a pose is read from, and the vectors that were found missing on the way."""

    mechanism: Mechanism
    terms: AlgebraicTerms
    directions: Directions
    vectors: Vectors
    missing: Missing
    report: Report

    def sought(self, closed: Closed) -> Mapping[str, tuple[str, str, Span]]:
        """Return the directions that a loop was to give, and none did."""
        return {n: at for n, at in self.directions.sought.items() if n not in closed.found}


def _pose(read: _PoseReading, closed: Closed) -> Pose:
    """Return all directions and frames, read in the order of their definitions."""
    mechanism, terms, directions, vectors, missing, report = read
    poses = partial(poses_nearby, mechanism, terms.definitions)
    box = partial(allowed_box, mechanism)
    named = lines.Lines(directions, vectors, missing, poses, box, report)
    guides, axis = lines.guides(mechanism, named), lines.mirror_line(mechanism, named)
    of_loads = {**lines.forces(mechanism, named), **_thrusts(read, axis)}
    held = tuple(contacts(mechanism, directions, vectors, named.of))
    laid_out = frames(mechanism, vectors, missing, report)
    slides = lines.slides(mechanism, named)
    return Pose(
        mechanism=_with_senses(mechanism, vectors),
        frames=laid_out,
        guides=guides,
        lines=of_loads,
        axis=axis,
        definitions=tuple(terms.definitions),
        placeholders=dict.fromkeys(vectors.placeholders),
        free=tuple(p.name for p in mechanism.parameters if not p.dependent),
        rates=closed.rates,
        slides=slides,
        contacts=held,
        radii={radius: terms.length(radius) for radius in _radii(mechanism)},
        limits=closed.limits,
        loops=closed.loops,
        closing=tuple(terms.definitions),
        put_in=tuple(d for d in terms.definitions if d.name in closed.put_in),
        vectors=vectors.given(),
        solved=closed.solved,
        falls=lines.falls(mechanism, named),
    )


def _radii(mechanism: Mechanism) -> Iterator[Formula]:
    """Yield the radius of every wheel, drum and circular slot and the pitch of every screw."""
    yield from (link.arc.radius for link in mechanism.links if link.arc)
    for joint in mechanism.joints:
        yield from (size.formula for size in joint.sizes)
    for friction in mechanism.friction.joints:
        if isinstance(friction, RopeFriction) and friction.reach is not None:
            yield friction.reach


def _with_senses(mechanism: Mechanism, vectors: Vectors) -> Mechanism:
    """Return a mechanism that has what keeps lengths positive that its ranges alone keep so."""
    if not vectors.ahead:
        return mechanism
    return replace(mechanism, requires=(*mechanism.requires, *senses(vectors, mechanism)))


def _thrusts(read: _PoseReading, axis: Angle | None) -> Mapping[str, Angle]:
    """Return the direction in which each pair of forces pushes its second point."""
    pairs = [load for load in read.mechanism.loads if isinstance(load, ForcePair)]
    if not pairs:
        return {}
    pairing = force_pairs.Pairing(read.mechanism, read.terms, read.vectors, axis, read.report)
    return {pair.name: force_pairs.thrust_line(pair, pairing) for pair in pairs}


def _links_without_direction(pose: Pose, read: _PoseReading, closed: Closed) -> Mapping[str, Link]:
    """Return the directions that no loop gives, each with the first link that needs it."""
    sought, needed = read.sought(closed).keys(), dict[str, Link]()
    for link in pose.mechanism.links:
        used = {n for vector in pose.frames[link.name].values() for n in mentioned(vector)}
        needed |= dict.fromkeys(sorted(used & sought - needed.keys()), link)
    return needed


def _check_loops(pose: Pose, read: _PoseReading, unfound: Set[str]) -> None:
    """Report every loop that does not close for independent symbols, all of them known."""
    mechanism, vectors = read.mechanism, read.vectors
    given = given_by_hand(mechanism) if mechanism.drawn else None
    defined = {d.name for d in pose.definitions}
    closure = ClosingEquations(pose.placeholders, defined, given, mechanism.brought_angles)
    poses = cache(partial(poses_nearby, mechanism, pose.definitions))
    slots = on_the_line([t for t in pose.contacts if t.kind == "slot"], vectors)
    for condition in (*_loops(vectors), *_guide_lines(pose, vectors), *slots):
        if unfound & mentioned(condition.arms):
            continue
        if fault := closure.check(condition, poses):
            read.report.add_first(fault)


def _loops(vectors: Vectors) -> list[ClosureCondition]:
    """Return the condition of every loop: it closes in any direction."""
    everywhere = (Angle(), QUARTER)
    return [
        ClosureCondition(
            chained(p or "origin" for p in loop.points), loop.arms, everywhere, loop.span
        )
        for loop in vectors.loops
    ]


def _guide_lines(pose: Pose, vectors: Vectors) -> Iterator[ClosureCondition]:
    """Yield the condition of every guide that is said to pass through a point."""
    for slider in pose.mechanism.each(Slider):
        chain = slider.through and vectors.chain(slider.point, slider.through)
        if chain:
            normal = across(pose.guides[slider.point])
            yield ClosureCondition(chained(chain), vectors.arms(chain), (normal,), slider.span)
