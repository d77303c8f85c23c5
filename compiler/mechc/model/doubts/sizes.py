"""Angles and lengths that can be meant, and hardly ever are: too large, zero, or far off."""

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import combinations

from ...diagnostics import Diagnostic
from ...diagnostics.model import sizes as messages
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...source import Span
from ...units import ANGLE, LENGTH
from ..entries import body_through, directions
from ..mechanism import Absolute, Arrow, ForcePair, Mechanism, Offset, Parameter
from ..parts.friction import GuideFriction, JointFriction, PinFriction, RopeFriction
from ..tolerances import SAME_VALUE
from ..values import Chain, Values, defaults

TURN = 2 * math.pi * (1 + SAME_VALUE)

FARTHEST = 1e6
"""Lengths in metres beyond which a vector is as good as infinite."""


# -------------------------------------------------------------------------- angles


def beyond_a_turn(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the angles beyond a turn: values, ends of ranges and strokes, directions.

    A rope may be wound around a pulley several times, and wheels lead links round and round.
    """
    ranged = {p.name for p in mechanism.parameters if p.range}
    wraps = (j.wrap for j in mechanism.friction.joints if isinstance(j, RopeFriction))
    wound = {name for wrap in wraps for name in symbols(wrap)}
    if mechanism.meshes:
        wound |= _turning(mechanism)
    for parameter in mechanism.parameters:
        turns = parameter.dimension == ANGLE and parameter.name not in wound
        if turns and not parameter.dependent and not _is_drawn(parameter, mechanism):
            yield from _turn_of(parameter)
    if not mechanism.meshes:
        yield from _turns_written(mechanism, ranged)


def _is_drawn(parameter: Parameter, mechanism: Mechanism) -> bool:
    """Return whether a parameter is the direction of a drawn link, whose range is the stroke."""
    return mechanism.drive is not None and parameter.span == mechanism.drive.span


def _turning(mechanism: Mechanism) -> set[str]:
    """Return the names that directions rest on, and the drive's."""
    given = (d.angle for d in directions(mechanism) if isinstance(d, Absolute))
    driving = {mechanism.drive.parameter} if mechanism.drive else set[str]()
    return driving.union(*map(symbols, given))


def _turns_written(mechanism: Mechanism, ranged: set[str]) -> Iterator[Diagnostic]:
    """Yield the ends of strokes and the directions beyond a turn."""
    drive = mechanism.drive
    angles = mechanism.angles
    is_drawn = drive and _is_drawn(mechanism.parameter(drive.parameter), mechanism)
    if drive and drive.parameter in angles and (is_drawn or drive.parameter not in ranged):
        what = f"an end of the stroke of {drive.parameter}"
        yield from _beyond(drive.span, what, (drive.low, drive.high))
    for direction in directions(mechanism):
        if isinstance(direction, Absolute):
            rest = evaluate(direction.angle, dict.fromkeys(symbols(direction.angle), 0.0))
            if 2 * TURN < abs(rest) < math.inf:
                yield messages.beyond_a_turn(direction.span, "the direction", rest / (2 * math.pi))


def _turn_of(parameter: Parameter) -> Iterator[Diagnostic]:
    value = list(_beyond(parameter.given, f"the value of '{parameter.name}'", (parameter.value,)))
    ends = (parameter.range.low, parameter.range.high) if parameter.range else ()
    yield from value or _beyond(parameter.span, f"an end of the range of '{parameter.name}'", ends)


def _beyond(span: Span, what: str, angles: Iterable[Formula | None]) -> Iterator[Diagnostic]:
    """Yield the remark on the largest of constant angles, if it is beyond a turn."""
    sizes = [evaluate(angle, {}) for angle in angles if angle is not None]
    largest = max(sizes, key=abs, default=0.0)
    if abs(largest) > TURN:
        yield messages.beyond_a_turn(span, what, largest / (2 * math.pi))


# ------------------------------------------------------------------------- lengths


def vanishing_lengths(mechanism: Mechanism, chain: Chain, values: Values) -> Iterator[Diagnostic]:
    """Yield the parameters that may take a length to zero or to infinity, each once.

    A coordinate along a given direction may pass zero.
    """
    given, resting = defaults(mechanism), dict[str, list[Arrow]]()
    for arrow in mechanism.geometry:
        if isinstance(arrow, Arrow) and arrow.length is not None:
            for name in sorted(symbols(arrow.length)):
                resting.setdefault(name, []).append(arrow)
    for parameter in mechanism.parameters:
        for end, where in _reach(parameter, mechanism, values):
            known = chain.complete({**given, parameter.name: end})
            moved = [n for n in known if known[n] != values.get(n)]
            arrows = [a for n in moved for a in resting.get(n, ()) if _fails(a, known)]
            found = next((a for a in arrows if _is_strange(a, known, where, mechanism)), None)
            if found:
                yield _vanishes(found, known, parameter, where)
                break


def _fails(arrow: Arrow, known: Values) -> bool:
    """Return whether a length that has a value is no positive one, or as good as infinite."""
    assert arrow.length is not None
    is_known = symbols(arrow.length) <= known.keys()
    return is_known and not 0 < evaluate(arrow.length, known) < FARTHEST


def _is_strange(arrow: Arrow, known: Values, where: str, mechanism: Mechanism) -> bool:
    """Return whether a length that fails is no coordinate, and no study of sizes."""
    assert arrow.length is not None
    if body_through((arrow.tail, arrow.head), mechanism):
        return where != "the stroke"
    return arrow.direction is None or not abs(evaluate(arrow.length, known)) < FARTHEST


def _vanishes(arrow: Arrow, known: Values, parameter: Parameter, where: str) -> Diagnostic:
    assert arrow.length is not None
    size = evaluate(arrow.length, known)
    shown = f"{size * 1000:.6g} mm" if abs(size) < FARTHEST else "infinity"
    shown = "" if math.isnan(size) else shown
    points = f"{arrow.tail}{arrow.head}"
    return messages.length_vanishes(parameter.span, points, shown, parameter.name, where)


def _reach(
    parameter: Parameter, mechanism: Mechanism, values: Values
) -> Iterator[tuple[float, str]]:
    """Yield how far a parameter may go, and what takes it there."""
    value, drive = values.get(parameter.name), mechanism.drive
    if parameter.range:
        yield evaluate(parameter.range.low, {}), "the range"
        yield evaluate(parameter.range.high, {}), "the range"
    elif drive and drive.parameter == parameter.name:
        yield from ((evaluate(e, {}), "the stroke") for e in (drive.low, drive.high) if e)
    if parameter.tolerance is not None and value is not None:
        size = evaluate(parameter.tolerance, {})
        yield from ((value + sign * size, "the tolerance") for sign in (-1, 1))


USUAL_LENGTH_RATIO = 100.0
"""How many times a length is the largest, or the smallest, of the others: 35 is met in books."""

FAR_OF_ONE = 300
"""The same where there is one other length: an eccentric has a long rod."""

Coordinates = tuple[float, float]


def far_off(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the first of the lengths and places that is far from the rest."""
    found = (
        *_far_places(mechanism, values),
        *_far_parameters(mechanism, values),
        *_far_vectors(mechanism, values),
        *_strange_springs(mechanism, values),
        *_strange_frictions(mechanism, values),
    )
    yield from found[:1]


def _far_parameters(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the parameters that are, of which the largest is first.

    Those written in place, as in ``OA = 100 mm @ x``, give the size of a mechanism, too.
    """
    given, plain = _given(mechanism, values), [size for size, _ in _plain(mechanism)]
    units = Counter(p.unit for p in given)
    if len(units) not in (1, 2):
        return
    sizes = {p.name: abs(values[p.name]) for p in given}
    alone = [p for p in given if len(units) == 1 or units[p.unit] == 1]
    for parameter in sorted(alone, key=lambda p: -sizes[p.name]):
        others = [*plain, *(s for name, s in sizes.items() if name != parameter.name)]
        if len(others) >= 3 - len(units) and _is_far(sizes[parameter.name], others):
            other = next(iter(units.keys() - {parameter.unit}), "")
            yield messages.length_far_off(parameter.given, parameter.name, parameter.unit, other)


def _given(mechanism: Mechanism, values: Values) -> list[Parameter]:
    """Return the parameters that stand in vectors, places and springs, and have a value."""
    springs = (k.tie for k in mechanism.loads if isinstance(k, ForcePair) and k.tie)
    formulas = [f for entry in mechanism.geometry for f in _lengths(entry)]
    used = {name for formula in (*formulas, *springs) for name in symbols(formula)}
    lengths = (p for p in mechanism.parameters if p.dimension == LENGTH and p.name in used)
    return [p for p in lengths if values.get(p.name) and not p.dependent]


def _far_vectors(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the vectors whose length is a number, of which one is far from the rest."""
    plain = _plain(mechanism)
    given = [abs(values[p.name]) for p in _given(mechanism, values)]
    for size, entry in sorted(plain, key=lambda pair: -pair[0]) if not mechanism.drawn else ():
        others = [*given, *(other for other, e in plain if e is not entry)]
        of_one = len(others) == 1 and size > FAR_OF_ONE * others[0]
        is_far = of_one or (len(others) > 1 and _is_far(size, others))
        if is_far and isinstance(entry, Arrow):
            yield messages.length_far_off(entry.span, f"{entry.tail}{entry.head}", "", "")


def _plain(mechanism: Mechanism) -> list[tuple[float, Arrow | Offset]]:
    """Return the lengths and coordinates that are numbers other than zero, and what has them."""
    written = [(f, e) for e in mechanism.geometry for f in _lengths(e)]
    sizes = [(abs(evaluate(f, {})), e) for f, e in written if not symbols(f)]
    return [(s, e) for s, e in sizes if s and isinstance(e, Arrow | Offset)]


def _lengths(entry: object) -> tuple[Formula, ...]:
    match entry:
        case Arrow(length=length) if length is not None:
            return (length,)
        case Offset(x=x, y=y):
            return (x, y)
        case _:
            return ()


MOST_GUIDE_FRICTION = 10.0
"""How many times its normal force a guide resists with at most: of one that jams it is below 5."""


def _strange_frictions(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the pins whose friction circle is larger than the mechanism, and guides like that.

    Of pins that one line gives it is seen that they overlap.
    """
    lines = Counter(joint.span for joint in mechanism.friction.joints)
    lengths = [abs(values[p.name]) for p in _given(mechanism, values)]
    longest = max([*lengths, *(size for size, _ in _plain(mechanism))], default=math.inf)
    for joint in mechanism.friction.joints:
        what = _too_much(joint, longest, values) if lines[joint.span] == 1 else ""
        if what:
            yield messages.friction_far_off(joint.span, what)


def _too_much(joint: JointFriction, longest: float, values: Values) -> str:
    """Return a doubt about the size of a friction in words, '' for none."""
    match joint:
        case PinFriction(point, _, factor) | GuideFriction(point, factor):
            size = evaluate(factor, values) if symbols(factor) <= values.keys() else 0.0
        case _:
            return ""
    if isinstance(joint, GuideFriction):
        resists = f"the guide of {point} resists with {size:.4g} times its normal force"
        return resists if size > MOST_GUIDE_FRICTION else ""
    circle = f"the friction circle of {point} has a radius of {size * 1e3:.4g} mm"
    return f"{circle}, more than every length of the mechanism" if size > longest else ""


def _is_far(size: float, others: Sequence[float]) -> bool:
    return size > USUAL_LENGTH_RATIO * max(others) or size * USUAL_LENGTH_RATIO < min(others)


# -------------------------------------------------------------------------- places


def _far_places(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the drawn points that are far from all others, which are near one another."""
    places = _places(mechanism, values)
    for drawn in mechanism.drawn if len(places) > 2 else ():
        here = places.get(drawn.point)
        others = [place for point, place in places.items() if point != drawn.point]
        if here is None:
            continue
        spread = max(math.dist(*pair) for pair in combinations(others, 2))
        if min(math.dist(here, other) for other in others) > USUAL_LENGTH_RATIO * spread > 0:
            yield messages.place_far_off(drawn.span, drawn.point)


FREE = 10.0
"""How many times as long as drawn a free spring is at most: a hundred of them are a wrong unit."""


def _strange_springs(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the springs that are drawn far from their free length, of which one has the unit."""
    places = _places(mechanism, values)
    for load in mechanism.loads:
        if not isinstance(load, ForcePair) or not load.tie or not load.spring:
            continue
        ends = [places[end] for end in (load.first, load.second) if end in places]
        drawn = math.dist(*ends) if len(ends) == 2 else 0.0
        free = _free(load.tie, f"len_{load.first}{load.second}", values)
        if drawn and free and not 1 / FREE < free / drawn < FREE:
            yield messages.spring_far_off(load.span, load.first + load.second, free / drawn)


def _free(tie: Formula, length: str, known: Values) -> float | None:
    """Return the length at which the force c·(l0 − len) of a spring vanishes, if it is known."""
    rest = symbols(tie) - {length} - known.keys()
    if rest:
        return None
    slack, stretched = (evaluate(tie, {**known, length: size}) for size in (0.0, 1.0))
    return slack / (slack - stretched) if slack != stretched else None


def _places(mechanism: Mechanism, values: Values) -> Mapping[str, Coordinates]:
    """Return the places that are given, of drawn points and of pivots."""
    pivots = (e for e in mechanism.geometry if isinstance(e, Offset) and not e.tail)
    given = [(d.point, d.x, d.y) for d in mechanism.drawn] + [(e.head, e.x, e.y) for e in pivots]
    known = ((p, x, y) for p, x, y in given if symbols(x) | symbols(y) <= values.keys())
    return {point: (evaluate(x, values), evaluate(y, values)) for point, x, y in known}
