"""A second reading of a description, for tests only: numbers instead of algebra.

It shares nothing with the compiler but the syntax tree and the table of units. Every
link gets the coordinates of its points in a frame of its own; a mirrored mechanism is
unfolded into both halves.
"""

import cmath
import math
import random
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple, TypeVar

from mechc.syntax import ast
from mechc.units import UNITS
from reference_wheels import Rolling, rollings

Values = dict[str, float]
S = TypeVar("S", bound=ast.Statement)

FUNCTIONS = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "cot": lambda x: 1 / math.tan(x),
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
    "sqrt": math.sqrt,
    "hypot": math.hypot,
}


def evaluate(node: ast.Expr, values: Mapping[str, float]) -> float:
    """Return the value of an expression in SI and radians."""
    match node:
        case ast.Number(digits, unit):
            return float(Fraction(digits)) * _factor(unit)
        case ast.Symbol(name):
            return math.pi if name == "pi" else values[name]
        case ast.Sum(terms):
            return math.fsum(sign * evaluate(term, values) for sign, term in terms)
        case ast.Product(factors):
            return math.prod(evaluate(factor, values) ** sign for sign, factor in factors)
        case ast.Power(base, exponent):
            return float(evaluate(base, values) ** evaluate(exponent, values))
        case ast.Call(function, arguments):
            return FUNCTIONS[function](*(evaluate(a, values) for a in arguments))


def _factor(name: str) -> float:
    if not name:
        return 1.0
    unit = UNITS[name]
    return float(unit.factor) * (math.pi if unit.pi else 1.0)


def every(file: ast.File, kind: type[S]) -> list[S]:
    """Return all statements of one kind."""
    return [s for s in file.statements if isinstance(s, kind)]


def defaults(file: ast.File) -> Values:
    """Return the values of the parameters that have one, in the order of the file."""
    return defined(file, {})


def defined(file: ast.File, given: Mapping[str, float]) -> Values:
    """Return the values of parameters and lets, those given instead of the default ones."""
    values = dict(given)
    for p in (*every(file, ast.Param), *every(file, ast.Let)):
        if p.value is not None and p.name.text not in values:
            with suppress(KeyError):
                values[p.name.text] = evaluate(p.value, values)
    return values


def points_of(name: str) -> tuple[str, ...]:
    """Split ``O1AB'`` into its points."""
    return tuple(re.findall(r"[A-Z][0-9]*'*", name))


# ----------------------------------------------------------------- arms and frames


@dataclass
class Arms:
    """What is given of the vectors between points: length and angle, each way round."""

    lengths: dict[tuple[str, str], float]
    angles: dict[tuple[str, str], float]

    def set_length(self, tail: str, head: str, length: float) -> None:
        self.lengths[tail, head] = self.lengths[head, tail] = length

    def set_angle(self, tail: str, head: str, angle: float) -> None:
        self.angles[tail, head], self.angles[head, tail] = angle, angle + math.pi

    def vector(self, tail: str, head: str) -> complex:
        return cmath.rect(self.lengths[tail, head], self.angles[tail, head])

    def between(self, tail: str, head: str) -> complex:
        """Return a vector along whatever chain of given ones leads there."""
        return self.around(tail)[head]

    def around(self, base: str, within: Collection[str] | None = None) -> dict[str, complex]:
        """Return the places of all points that given vectors lead to from a point."""
        placed, queue = {base: 0j}, [base]
        for tail in queue:
            for start, head in self.angles:
                inside = within is None or head in within
                if start == tail and head not in placed and (tail, head) in self.lengths and inside:
                    placed[head] = placed[tail] + self.vector(tail, head)
                    queue.append(head)
        return placed


def arms_of(file: ast.File, values: Values) -> Arms:
    """Return the given lengths and angles; a given turn is taken from the other arm."""
    arms = Arms({}, {})
    waiting: list[ast.Vector | ast.Turn] = [*every(file, ast.Vector), *every(file, ast.Turn)]
    while waiting:
        later = []
        for item in waiting:
            take = _take_vector if isinstance(item, ast.Vector) else _take_turn
            try:
                take(item, values, arms)
            except KeyError:
                later.append(item)
        assert len(later) < len(waiting), "directions rest on one another"
        waiting = later
    _align(file, arms)
    return arms


def _take_vector(vector: ast.Vector, values: Values, arms: Arms) -> None:
    tail, head = points_of(vector.points.text)
    match vector.value:
        case ast.Polar(length, direction):
            if length is not None:
                arms.set_length(tail, head, evaluate(length, values))
            if direction is not None:
                arms.set_angle(tail, head, angle_of(direction, values, arms))
        case ast.Cartesian(x, y):
            size, turn = cmath.polar(complex(evaluate(x, values), evaluate(y, values)))
            arms.set_length(tail, head, size)
            arms.set_angle(tail, head, turn)


def _take_turn(turn: ast.Turn, values: Values, arms: Arms) -> None:
    first, vertex, second = points_of(turn.points.text)
    by = evaluate(turn.angle, values)
    if (vertex, first) in arms.angles:
        arms.set_angle(vertex, second, arms.angles[vertex, first] + by)
    else:
        arms.set_angle(vertex, first, arms.angles[vertex, second] - by)


def _align(file: ast.File, arms: Arms) -> None:
    """Turn the line of a slot to its pin."""
    for slot in every(file, ast.Slot):
        tail, head, *_ = points_of(slot.line.text)
        placed = arms.angles.get((tail, slot.point.text))
        if placed is not None and (tail, head) not in arms.angles:
            arms.set_angle(tail, head, placed)


def angle_of(direction: ast.Direction, values: Values, arms: Arms) -> float:
    """Return a direction as an angle from +x, in radians."""
    match direction:
        case ast.Axis(axis, sign):
            return (math.pi / 2 if axis == "y" else 0.0) + (0.0 if sign > 0 else math.pi)
        case ast.Toward(points, sign, perp):
            tail, head = points_of(points.text)
            quarter = (math.pi / 2 if perp else 0.0) + (0.0 if sign > 0 else math.pi)
            if (tail, head) in arms.angles:
                return arms.angles[tail, head] + quarter
            return cmath.phase(arms.between(tail, head)) + quarter
        case _:
            return evaluate(direction, values)


def frame(points: tuple[str, ...], arms: Arms, guess: random.Random) -> dict[str, complex]:
    """Return the points of a link from its first one.

    A length that is not given is guessed: it must not matter.
    """
    for pair in list(arms.angles):
        if pair not in arms.lengths:
            arms.set_length(*pair, guess.uniform(0.5, 2.0))
    alone = arms.around(points[0], points)
    placed = alone if set(points) <= alone.keys() else arms.around(points[0])
    return {point: placed[point] for point in points}


# ------------------------------------------------------------ the whole mechanism


class Action(NamedTuple):
    """A load of one name: a force at a point (unit vector) or a couple on a link."""

    name: str
    at: str
    direction: complex | None
    times: float


class PointContact(NamedTuple):
    """A pin in a slot of a body, or in contact with it: the normal, and the pin's place on it."""

    pin: str
    body: str
    normal: complex
    place: complex


@dataclass
class Assembly:
    """Bodies with coordinates, pins to the ground, guides and loads, all numbers."""

    links: dict[str, dict[str, complex]]
    pivots: set[str]
    guides: dict[str, complex]
    slides: dict[str, complex]
    contacts: list[PointContact]
    rollings: list[Rolling]
    ropes: list[dict[str, complex]]
    actions: list[Action]
    lengths: dict[tuple[str, str], float]


def assemble(file: ast.File, values: Values, seed: int = 1, arms: Arms | None = None) -> Assembly:
    """Return the mechanism as numbers, unfolded where it is mirrored.

    ``arms`` are the vectors between its points where loops have to be closed for them.
    """
    whole = _as_described(file, values, seed, arms)
    for axis, shared in _mirrors(file, values, arms):
        _unfold(whole, axis, shared)
    for c in every(file, ast.Copies):
        _multiply(whole, evaluate(c.number, values), {name.text for name in c.sharing})
    return whole


def assemble_half(
    file: ast.File, values: Values, seed: int = 1, arms: Arms | None = None
) -> Assembly:
    """Return the half or branch that is described, the mirror guiding what is shared."""
    half = _as_described(file, values, seed, arms)
    for axis, shared in _mirrors(file, values, arms):
        half.guides |= dict.fromkeys(shared - half.pivots - half.guides.keys(), axis)
    return half


def _mirrors(
    file: ast.File, values: Values, arms: Arms | None
) -> Iterator[tuple[complex, set[str]]]:
    arms = arms or arms_of(file, values)
    for m in every(file, ast.Mirror):
        yield cmath.rect(1, angle_of(m.across, values, arms)), {name.text for name in m.sharing}


def _as_described(file: ast.File, values: Values, seed: int, arms: Arms | None = None) -> Assembly:
    arms, guess = arms or arms_of(file, values), random.Random(seed)
    links = {
        s.points.text: frame(points_of(s.points.text), arms, guess) for s in every(file, ast.Link)
    }
    for number, s in enumerate(every(file, ast.Distributed)):
        points = links[_owner(file, s.line.text)]
        (tail, head), far = points_of(s.line.text), spread(s, values)[0][1]
        points[f"M{number or ''}"] = points[tail] + far * (points[head] - points[tail])
    slides = {
        s.points.text: cmath.rect(1, angle_of(s.along, values, arms))
        for s in every(file, ast.Slide)
    }
    guides = {
        s.point.text: cmath.rect(1, angle_of(s.along, values, arms))
        for s in every(file, ast.Slider)
    }
    carried = {p for points in links.values() for p in points}
    slides |= {p: along for p, along in guides.items() if p not in carried}
    links |= {name: dict.fromkeys(points_of(name), 0j) for name in slides}
    contacts = list(_touches(file, values, arms, links, slides))
    for name, first, second in cylinders(file):
        links[name] = {first: 0j}
        reach = arms.between(first, second)
        contacts.append(PointContact(second, name, 1j * reach / abs(reach), reach))
    return Assembly(
        links,
        {s.point.text for s in every(file, ast.Pivot)},
        guides,
        slides,
        contacts,
        [
            *rollings(file, links, guides | slides, lambda e: evaluate(e, values)),
            *_blocks(file, arms, links, contacts),
        ],
        [_rope(s, values, arms) for s in every(file, ast.Rope)],
        _actions(file, values, arms),
        arms.lengths,
    )


def _rope(rope: ast.Rope, values: Values, arms: Arms) -> dict[str, complex]:
    """Return the force of a tension of 1 on each point that the rope runs over."""
    pulls: dict[str, complex] = {}
    tail = rope.start.text
    for point, along in rope.falls:
        head = point.text
        toward = along or ast.Toward(ast.Name(tail + head, point.span), 1, False, point.span)
        way = cmath.rect(1, angle_of(toward, values, arms))
        pulls[tail] = pulls.get(tail, 0) + way
        pulls[head] = pulls.get(head, 0) - way
        tail = head
    return pulls


def cylinders(file: ast.File) -> Iterator[tuple[str, str, str]]:
    """Yield the telescopes whose ends have friction: a body at one end, led by the other one.

    That presses the body across, and a pair of forces inside acts on both.
    """
    if every(file, ast.PinFriction):
        pairs = (*every(file, ast.Actuator), *every(file, ast.Spring))
        loaded = [{s.first.text, s.second.text} for s in pairs]
        for s in every(file, ast.Telescope):
            if set(points_of(s.points.text)) in loaded:
                yield s.points.text, *points_of(s.points.text)


def _touches(
    file: ast.File,
    values: Values,
    arms: Arms,
    links: dict[str, dict[str, complex]],
    slides: Collection[str],
) -> Iterator[PointContact]:
    for s in (*every(file, ast.Slot), *every(file, ast.Contact)):
        tail, head, *_ = points_of(s.line.text)
        if isinstance(s, ast.Contact):
            normal = angle_of(s.normal, values, arms)
        elif s.about:
            normal = cmath.phase(arms.between(s.about.text, s.point.text))
        else:
            normal = cmath.phase(arms.between(tail, head)) + math.pi / 2
        body = next(name for name, points in links.items() if {tail, head} <= points.keys())
        pin, first = s.point.text, next(iter(links[body]))
        place = 0j if body in slides else arms.between(first, pin)
        yield PointContact(pin, body, cmath.rect(1, normal), place)


def _blocks(
    file: ast.File,
    arms: Arms,
    links: Mapping[str, Mapping[str, complex]],
    contacts: Iterable[PointContact],
) -> Iterator[Rolling]:
    """Yield the second place at which the block of a guided link touches its slot."""
    for s in every(file, ast.Slot):
        if s.guided:
            tail, head = points_of(s.line.text)
            ahead = arms.between(tail, head) / abs(arms.between(tail, head))
            touch = next(t for t in contacts if t.pin == s.point.text)
            there = links[s.guided.text][s.point.text] + ahead
            yield Rolling(s.guided.text, there, touch.body, touch.place + ahead, 1j * ahead)


def _actions(file: ast.File, values: Values, arms: Arms) -> list[Action]:
    down = [angle_of(g.along, values, arms) for g in every(file, ast.Gravity)] or [-math.pi / 2]
    found = []
    for s in file.statements:
        times = getattr(s, "times", None)
        size = 1.0 if times is None else evaluate(times, values)
        match s:
            case ast.Force(name=name, point=point, along=along):
                turn = angle_of(along, values, arms)
                found.append(Action(name.text, point.text, cmath.rect(1, turn), size))
            case ast.Distributed(name=name, line=line, along=along):
                push = cmath.rect(1, angle_of(along, values, arms))
                for point, share in zip(points_of(line.text), spread(s, values)[0], strict=True):
                    found.append(Action(name.text, point, push, size * share))
            case ast.Weight(name=name, point=point):
                found.append(Action(name.text, point.text, cmath.rect(1, down[0]), size))
            case ast.Torque(name=name, link=link):
                found.append(Action(name.text, _owner(file, link.text), None, size))
    return found


def spread(s: ast.Distributed, values: Values) -> tuple[tuple[float, float], float]:
    """Return which parts of a spread load its ends take, and its size for a unit of length.

    The ends of a beam take l(2q₁ + q₂)/6 and l(q₁ + 2q₂)/6 of a load that varies evenly.
    """
    ends = [evaluate(q, values) for q in (s.intensity, s.end) if q is not None]
    first, last = (ends[0], ends[-1]) if ends else (1.0, 1.0)
    whole = 3 * (first + last)
    return ((2 * first + last) / whole, (first + 2 * last) / whole), (first + last) / 2


def known_spread(file: ast.File, values: Values, arms: Arms) -> Values:
    """Return the sizes of the spread loads whose intensity is given."""
    return {
        s.name.text: spread(s, values)[1] * abs(arms.between(*points_of(s.line.text)))
        for s in every(file, ast.Distributed)
        if s.intensity
    }


def _owner(file: ast.File, part: str) -> str:
    wanted = set(points_of(part))
    links = [s.points.text for s in every(file, ast.Link)]
    return next(name for name in links if wanted <= set(points_of(name)))


def _unfold(half: Assembly, axis: complex, shared: set[str]) -> None:
    def twin(point: str) -> str:
        return point if point in shared else point + "'"

    def reflect(vector: complex) -> complex:
        return axis * axis * vector.conjugate()

    for name, points in list(half.links.items()):
        if not set(points) <= shared:
            half.links[name + "'"] = {twin(p): reflect(v) for p, v in points.items()}
    for touch in list(half.contacts):
        body = touch.body if set(half.links[touch.body]) <= shared else touch.body + "'"
        if (twin(touch.pin), body) != (touch.pin, touch.body):
            normal, place = reflect(touch.normal), reflect(touch.place)
            half.contacts.append(PointContact(twin(touch.pin), body, normal, place))
    for first, at, second, there, along, arm in list(half.rollings):
        names = [
            b if set(half.links.get(b, ())) <= shared else b + "'" for b in (first, second, arm)
        ]
        twins = Rolling(names[0], reflect(at), names[1], reflect(there), reflect(along), names[2])
        half.rollings.extend([twins] if names[:2] != [first, second] else [])
    for pulls in list(half.ropes):
        if not set(pulls) <= shared:
            half.ropes.append({twin(p): reflect(pull) for p, pull in pulls.items()})
    for name, along in list(half.slides.items()):
        if name + "'" in half.links:
            half.slides[name + "'"] = reflect(along)
    half.pivots |= {twin(p) for p in half.pivots}
    half.guides |= {twin(p): reflect(v) for p, v in half.guides.items() if p not in shared}
    half.guides |= dict.fromkeys(shared - half.pivots - half.guides.keys(), axis)
    for load in list(half.actions):
        if load.direction is None:
            half.actions.append(Action(load.name, load.at + "'", None, -load.times))
        elif load.at not in shared:
            half.actions.append(load._replace(at=twin(load.at), direction=reflect(load.direction)))


def _multiply(branch: Assembly, number: float, shared: set[str]) -> None:
    branch.actions[:] = [
        load if load.at in shared else load._replace(times=load.times * number)
        for load in branch.actions
    ]
