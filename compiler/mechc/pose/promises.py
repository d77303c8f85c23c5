"""What a pose promises, as a check for tests and for whoever finds poses."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set

from ..algebra.product import ONE
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Force, ForcePair, Slider
from ..model.values import completed, defaults, following, independent
from .pose import BodyFrame, Pose, PoseDefinition, Vector, evaluate_vector
from .tolerances import LOOP_GAP

DRIVE_STEP = 1e-5
"""By how much the drive is moved, in SI, to see what changes with it."""

RATE_GAP = 1e-4
"""By how much a rate may differ from what a step of the drive makes of it."""


def broken_promises(pose: Pose) -> list[str]:
    """Return a sentence for each promise of this folder that a pose breaks."""
    return [*_names(pose), *_missing(pose), *_frames(pose), *_gaps(pose), *_wrong_rates(pose)]


def known_names(pose: Pose) -> set[str]:
    """Return the names that formulas of a pose may have: parameters, open lengths, definitions."""
    parameters = {p.name for p in pose.mechanism.parameters}
    return parameters | set(pose.placeholders) | {d.name for d in pose.definitions}


def _names(pose: Pose) -> Iterator[str]:
    """Yield the faults in the order of names, and the names that nothing defines."""
    if pose.free != tuple(p.name for p in independent(pose.mechanism)):
        yield "the free names are not the independent parameters in declared order"
    given = {p.name for p in pose.mechanism.parameters} | set(pose.placeholders)
    yield from _order(pose.definitions, given)
    yield from _order(pose.closing, given)
    known, closing = known_names(pose), {d.name for d in pose.closing}
    for where, formula in _formulas(pose):
        yield from (f"{where} uses {n}" for n in sorted(symbols(formula) - known))
    for ends, vector in pose.vectors.items():
        used = frozenset[str]().union(*map(symbols, _of_vector(vector)))
        yield from (f"vector {''.join(ends)} uses {n}" for n in sorted(used - known - closing))


def _order(definitions: Sequence[PoseDefinition], given: Set[str]) -> Iterator[str]:
    """Yield the names defined from later or unknown ones, and those defined twice."""
    known = set(given)
    for name, formula in definitions:
        yield from (f"{name} uses {n} too early" for n in sorted(symbols(formula) - known))
        known.add(name)
    counted = Counter(name for name, _ in definitions)
    yield from (f"{name} is defined {n} times" for name, n in counted.items() if n > 1)


def _formulas(pose: Pose) -> Iterator[tuple[str, Formula]]:
    """Yield the formulas of vectors, directions and radii, each with what it belongs to."""
    for link, frame in pose.frames.items():
        for point, vector in frame.items():
            yield from ((f"vector to {point} of {link}", f) for f in _of_vector(vector))
    for kind, angles in (("guide", pose.guides), ("line", pose.lines), ("slide", pose.slides)):
        yield from ((f"{kind} of {name}", angle.formula()) for name, angle in angles.items())
    for contact in pose.contacts:
        yield f"{contact.kind} of {contact.point}", contact.normal.formula()
        yield from ((f"{contact.kind} of {contact.point}", f) for f in _of_vector(contact.reach))
    yield from (("radius", radius.formula()) for radius in pose.radii.values())


def _of_vector(vector: Vector) -> Iterator[Formula]:
    for length, angle in vector:
        yield from (length.formula(), angle.formula())


def _missing(pose: Pose) -> Iterator[str]:
    """Yield the links, guides, slides and forces that have no vector or direction."""
    mechanism = pose.mechanism
    bodies = (body.name for body in mechanism.rigid_bodies)
    yield from (f"body {name} has no frame" for name in bodies if name not in pose.frames)
    guided = (s.point for s in mechanism.each(Slider))
    yield from (f"guide of {p} has no direction" for p in guided if p not in pose.guides)
    slides = (s.name for s in mechanism.slides)
    yield from (f"slide {name} has no direction" for name in slides if name not in pose.slides)
    forces = (k.name for k in mechanism.loads if isinstance(k, Force | ForcePair))
    yield from (f"force {name} has no direction" for name in forces if name not in pose.lines)
    if mechanism.mirror is not None and pose.axis is None:
        yield "the mirror line has no direction"


def _frames(pose: Pose) -> Iterator[str]:
    for body in pose.mechanism.rigid_bodies:
        frame = pose.frames.get(body.name, {})
        if frame and set(frame) != set(body.points):
            yield f"the frame of {body.name} is of other points"
        elif frame and frame[body.points[0]] != ():
            yield f"the frame of {body.name} begins elsewhere than at {body.points[0]}"


# ---------------------------------------------------------------- at the default pose


def _values(pose: Pose, shift: float = 0.0) -> dict[str, float]:
    """Return the numbers at the default pose, or where the drive is shifted from it.

    Lengths that are left open have one where a loop fixes them.
    """
    given = defaults(pose.mechanism)
    if shift and pose.mechanism.drive:
        given[pose.mechanism.drive.parameter] += shift
    chain = following(pose.mechanism, pose.definitions)
    found = chain.complete(given)
    open_lengths = [(n, p.formula()) for n, p in pose.placeholders.items() if p is not None]
    return chain.complete(completed(found, open_lengths))


def _gaps(pose: Pose) -> Iterator[str]:
    """Yield the bodies that do not reach the points at which others hold them."""
    values, places = _values(pose), dict[str, complex]()
    waiting = {name: frame for name, frame in pose.frames.items() if _is_numeric(frame, values)}
    while waiting:
        met = [name for name, frame in waiting.items() if not places.keys().isdisjoint(frame)]
        name = (met or list(waiting))[0]
        places = places if met else {}
        there = {p: complex(*evaluate_vector(v, values)) for p, v in waiting.pop(name).items()}
        base = next((p for p in there if p in places), next(iter(there)))
        shift = places.get(base, 0j) - there[base]
        size = max(map(abs, (*there.values(), *places.values())))
        for point, offset in there.items():
            gap = abs(places.setdefault(point, offset + shift) - offset - shift)
            if gap > LOOP_GAP * size:
                yield f"body {name} misses {point} by {gap:.3g} m"


def _is_numeric(frame: BodyFrame, values: Mapping[str, float]) -> bool:
    return all(symbols(f) <= values.keys() for v in frame.values() for f in _of_vector(v))


def _wrong_rates(pose: Pose) -> Iterator[str]:
    """Yield a sentence for each rate that is not the change of its name with the drive."""
    drive = pose.mechanism.drive
    if drive is None or not pose.rates:
        return
    if pose.rates.get(drive.parameter) != ONE:
        yield f"the drive {drive.parameter} does not have the rate 1"
    here, before, after = (_values(pose, shift) for shift in (0.0, -DRIVE_STEP, DRIVE_STEP))
    for name in [d.name for d in pose.definitions if d.name in pose.rates]:
        rate = pose.rates[name].evaluate(here)
        change = (after[name] - before[name]) / (2 * DRIVE_STEP)
        if abs(rate - change) > RATE_GAP * (1 + abs(rate)):
            yield f"{name} changes by {change:.6g}, not {rate:.6g}, per unit of the drive"
