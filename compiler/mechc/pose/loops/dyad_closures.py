"""Assur groups of two links in closed form, all five kinds of them.

A loop ``D + X + Y = 0`` has a known part D and two unknowns. Their kinds give the
group: two directions (RRR), a direction and a length along a known one (RRP, and RPR with
the guide on a moving link), a direction and a length that turns with it (RPR, the
oscillating cylinder), two lengths (PRP, RPP). Each has at most two closures, distinguished
by the sign of one root.

Accuracy: the angles of a triangle with sides d, p, q come from the product of the four
factors d + p + q, p + q − d … (Heron; Kahan, Miscalculating Area and Angles of a
Needle-like Triangle, 2014), which has no cancellation where the triangle is nearly flat.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping

from ...algebra.angle import HALF_TURN, QUARTER, Angle, principal
from ...algebra.factors import Length
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine, sine
from ...base.frozen import replace
from ...formula.names import another
from ...formula.tree import Call, Formula, negative, product, total
from ..pose import Arm, Limit, PoseDefinition, gathered
from ..vector_graph import loop_name, mentioned
from .dyad_sides import DyadSides, along, heron
from .dyads import Closure, Dyad, DyadLoop, Reaching, Turning


def dyad(loop: DyadLoop, sides: DyadSides) -> Dyad | None:
    """Return how a loop closes; None for one of another kind."""
    found = _dyad(loop, sides)
    if found is None or not found.closures:
        return None
    closures = (_by_own_name(_with(sides.definitions, c)) for c in found.closures)
    return replace(found, closures=tuple(closures))


def _with(shared: Iterable[PoseDefinition], closure: Closure) -> Closure:
    own = {d.name for d in closure.definitions}
    others = (d for d in shared if d.name not in own)
    return closure._replace(definitions=(*others, *closure.definitions))


def _dyad(loop: DyadLoop, sides: DyadSides) -> Dyad | None:
    """Return the dyad that a loop is, by its turning and reaching parts; None if it is none."""
    match _parts(loop, sides):
        case [first, second], []:
            return _triangle(loop, *_grounded_last(first, second, loop, sides), sides)
        case [turn], [reach] if turn.name not in mentioned((Arm(reach.scale, reach.direction),)):
            return _guided(loop, turn, reach, sides)
        case [turn], [reach]:
            return _sliding(loop, turn, reach, sides)
        case [], [reach] if len(loop.unknown) == 2:
            bare = _bare(loop, reach)
            return _sliding(loop, bare, reach, sides) if abs(bare.sense) == 1 else None
        case [], [first_reach, second_reach]:
            return _two_lengths(loop, first_reach, second_reach, sides)
        case _:
            return None


def _bare(loop: DyadLoop, reach: Reaching) -> Turning:
    """Return a part of no length that turns with what is reached along."""
    (name,) = loop.unknown - {reach.name}
    return Turning(name, int(dict(reach.direction.terms).get(name, 0)), Product(0), Angle())


def _parts(loop: DyadLoop, sides: DyadSides) -> tuple[list[Turning], list[Reaching]]:
    """Return the arms of unknown angle and of unknown length; none where others are there."""
    turns: dict[str, list[Arm]] = {}
    reaches: dict[str, Reaching] = {}
    for arm in loop.moving:
        lengths = [n for n in sorted(loop.unknown) if Length(n) in arm.length.factors]
        angles = [n for n, _ in arm.angle.terms if n in loop.unknown]
        if lengths:
            scale = arm.length / Product.symbol(lengths[0])
            again = lengths[0] in reaches
            if again or not loop.unknown.isdisjoint(mentioned((Arm(scale, Angle()),))):
                return [], []
            reaches[lengths[0]] = Reaching(lengths[0], scale, arm.angle)
        elif len(angles) == 1:
            turns.setdefault(angles[0], []).append(arm)
        else:
            return [], []
    turning = [_turning(name, arms, sides) for name, arms in sorted(turns.items())]
    if any(t is None for t in turning):
        return [], []
    return [t for t in turning if t], list(reaches.values())


def _turning(name: str, arms: list[Arm], sides: DyadSides) -> Turning | None:
    senses = {dict(arm.angle.terms)[name] for arm in arms}
    sense = senses.pop()
    if senses or abs(sense) != 1:
        return None
    within = gathered(Arm(a.length, a.angle - Angle.of(name) * sense) for a in arms)
    size, offset = sides.polar(within, f"r_{name}")
    return Turning(name, int(sense), size, offset)


def _grounded_last(
    first: Turning, second: Turning, loop: DyadLoop, sides: DyadSides
) -> tuple[Turning, Turning]:
    """Put the part that hangs on a pivot last: the direction of the coupler is named."""

    def is_on_pivot(turn: Turning) -> bool:
        edges = [e for e in loop.cycle if turn.name in mentioned(e.arms)]
        return any(p in sides.fixed for e in edges for p in (e.tail, e.head))

    return (second, first) if is_on_pivot(first) > is_on_pivot(second) else (first, second)


# --------------------------------------------------------------------------- two turns


def _triangle(loop: DyadLoop, first: Turning, second: Turning, sides: DyadSides) -> Dyad | None:
    """RRR: a triangle of three known sides d, p, q."""
    if not loop.known:
        return None
    d, psi = sides.known_side(loop, True, lambda way: first.angle_at(way + HALF_TURN))
    p, q = first.size, second.size
    area = heron(d, p, q)
    base, tip = (
        Call("atan2", (area, add([a * a, b * b, -(c * c)]).formula()))
        for a, b, c in ((d, p, q), (p, q, d))
    )
    mu = sides.angle("mu", loop.inner_pin() or first.name, tip)
    outside = first.angle_at(psi + HALF_TURN)
    closures = tuple(
        _hinged(loop, (first, second), (outside, -sense * first.sense, base), mu * sense, sides)
        for sense in (1, -1)
    )
    limit = Limit(loop_name(loop.cycle), "triangle", loop.known, (p, q))
    return Dyad(loop, "triangle", closures, limit, area)


def _hinged(
    loop: DyadLoop,
    turns: tuple[Turning, Turning],
    lead: tuple[Angle, int, Formula],
    inner_angle: Angle,
    sides: DyadSides,
) -> Closure:
    """Return a closure of a triangle: the angle at its base names or gives a direction."""
    (first, second), (outside, sign, base) = turns, lead
    if len(loop.known) > 1 or first.name in sides.kept:
        put = _turned_alike(first, outside, sign, base, sides)
        named = [] if put else [PoseDefinition(first.name, _turned(outside, sign, base, sides))]
        other = second.angle_at(first.direction.put(put) + HALF_TURN - inner_angle)
        closure = _closure(named, {**put, second.name: other}, sides)
        return closure._replace(across=next(iter(put), ""))
    gamma = sides.angle("gamma", loop.base_point(first.name) or first.name, base)
    angle = principal(outside + gamma * sign)
    direction = first.direction.put({first.name: angle})
    other = second.angle_at(direction + HALF_TURN - inner_angle)
    return _closure([], {first.name: angle, second.name: other}, sides)


def _turned_alike(
    first: Turning, outside: Angle, sign: int, base: Formula, sides: DyadSides
) -> Mapping[str, Angle]:
    """Return the direction of a part that a congruent triangle across a line of symmetry gives.

    None where it is no shorter than by that line, or where the user named it.
    """
    known = None if first.name in sides.kept else sides.turn_by(base)
    if known is None:
        return {}
    angle = outside + known * sign
    shorter = sides.undoubled(angle)
    return {} if shorter == angle else {first.name: principal(shorter)}


def _turned(outside: Angle, sign: int, base: Formula, sides: DyadSides) -> Formula:
    """Return a direction turned by the angle at a triangle's base, one way or the other."""
    known = sides.turn_by(base)
    if known is not None:
        return principal(outside + known * sign).formula()
    return total([outside.formula(), base if sign > 0 else negative(base)])


# -------------------------------------------------------------------- a turn and a length


def _guided(loop: DyadLoop, turn: Turning, reach: Reaching, sides: DyadSides) -> Dyad:
    """RRP: the part that turns spans the distance to the line that is reached along."""
    height = along(loop.known, reach.direction + QUARTER)
    if not height:
        return Dyad(loop, "guide", tuple(_along_the_guide(loop, turn, reach, sides)))
    sine_of = -(height / turn.size)
    flip = -1 if sine_of.coefficient < 0 else 1
    inclination = Call("asin", (sine_of.scaled(flip).formula(),))
    limit = Limit(loop_name(loop.cycle), "guide", (), (turn.size, height))
    lean = _inclined if turn.name in sides.kept else _leaning(sides.name(_beta(turn.name)))
    closures = []
    for forward in (True, False):
        named, direction, put = lean(turn, reach.direction, flip, forward, inclination)
        behind = (*loop.known, Arm(turn.size, direction))
        length = _reach(reach, -along(behind, reach.direction))
        closures.append(_closure([named, length], put, sides))
    return Dyad(loop, "guide", tuple(closures), limit, inclination)


def _along_the_guide(
    loop: DyadLoop, turn: Turning, reach: Reaching, sides: DyadSides
) -> Iterator[Closure]:
    """Yield how a part lies that begins on the line that it ends on."""
    for line in (reach.direction, reach.direction + HALF_TURN):
        behind = (*loop.known, Arm(turn.size, line))
        length = _reach(reach, -along(behind, reach.direction))
        yield _closure([length], {turn.name: turn.angle_at(line)}, sides)


Lean = tuple[PoseDefinition, Angle, Mapping[str, Angle]]
"""What is defined, the direction of the part that turns, and what is put in for an unknown."""


def _inclined(turn: Turning, line: Angle, flip: int, forward: bool, inclination: Call) -> Lean:
    """Return how a part turns whose direction the user named: by that name."""
    start = turn.angle_at(line if forward else line + HALF_TURN)
    sign = flip * turn.sense * (1 if forward else -1)
    lean = inclination if sign > 0 else negative(inclination)
    return PoseDefinition(turn.name, total([start.formula(), lean])), turn.direction, {}


def _leaning(name: str) -> Callable[[Turning, Angle, int, bool, Call], Lean]:
    """Return how a part turns by its inclination to the line, which has this name."""

    def lean(turn: Turning, line: Angle, flip: int, forward: bool, inclination: Call) -> Lean:
        by = Angle.of(name) * flip
        direction = line + by if forward else line + HALF_TURN - by
        return PoseDefinition(name, inclination), direction, {turn.name: turn.angle_at(direction)}

    return lean


def _sliding(loop: DyadLoop, turn: Turning, reach: Reaching, sides: DyadSides) -> Dyad | None:
    """RPR: the part that is reached along turns with the unknown direction."""
    if not loop.known:
        return None
    gamma = reach.direction - Angle.of(turn.name) * turn.sense
    lean = turn.offset - gamma
    across, ahead = turn.size * sine(lean), turn.size * cosine(lean)
    is_whole = not turn.size and reach.scale == Product(1)
    d, psi = sides.known_side(
        loop,
        bool(across),
        lambda way: _aligned(turn, way + HALF_TURN - gamma),
        reach.name if is_whole else "",
    )
    limit = Limit(loop_name(loop.cycle), "slot", loop.known, (across,))
    if not across:
        closures = tuple(
            _closure(
                _reached(reach, add([side, -ahead]), sides),
                {turn.name: _aligned(turn, way - gamma)},
                sides,
            )
            for side, way in ((d, psi + HALF_TURN), (-d, psi))
        )
        return Dyad(loop, "aligned", closures, limit)
    root = _difference_of_squares(d.formula(), across.formula())
    lead = _aligned(turn, psi + HALF_TURN - gamma).formula()
    return Dyad(loop, "slot", tuple(_slid(turn, reach, (across, ahead), root, lead)), limit, root)


def _slid(
    turn: Turning, reach: Reaching, arm: tuple[Product, Product], root: Call, lead: Formula
) -> Iterator[Closure]:
    """Yield the closures of a slot whose line passes a pivot at a distance."""
    across, ahead = (part.formula() for part in arm)
    for stem in (root, negative(root)):
        size = product([(total([stem, negative(ahead)]), 1), (reach.scale.formula(), -1)])
        offset = Call("atan2", (across, stem))
        angle = total([lead, negative(offset) if turn.sense > 0 else offset])
        yield Closure((PoseDefinition(reach.name, size), PoseDefinition(turn.name, angle)), {})


def _difference_of_squares(a: Formula, b: Formula) -> Call:
    """Return √(a² − b²) by its factors, without cancellation where they are nearly equal."""
    return Call("sqrt", (product([(total([a, negative(b)]), 1), (total([a, b]), 1)]),))


# ---------------------------------------------------------------------------- two lengths


def _two_lengths(
    loop: DyadLoop, first: Reaching, second: Reaching, sides: DyadSides
) -> Dyad | None:
    """PRP and RPP: two lengths along known directions."""
    angle = sine(first.direction - second.direction)
    if not angle:
        return None
    one = -(along(loop.known, second.direction + QUARTER) / angle)
    two = along(loop.known, first.direction + QUARTER) / angle
    closure = _closure([_reach(first, one), _reach(second, two)], {}, sides)
    return Dyad(loop, "lengths", (closure,))


def _closure(
    definitions: list[PoseDefinition], put: Mapping[str, Angle], sides: DyadSides
) -> Closure:
    """Return a closure; a direction that the user named is defined, others are put in."""
    named = [PoseDefinition(n, a.formula()) for n, a in put.items() if n in sides.kept]
    return Closure((*definitions, *named), {n: a for n, a in put.items() if n not in sides.kept})


def _by_own_name(closure: Closure) -> Closure:
    """Return a closure in which the direction of a vector that is itself sought has its name.

    The side that is known leads from end to end of a telescope EG: its direction, phi_EG_2 as the
    name is taken, is what is sought as phi_EG.
    """
    for name, angle in closure.directions.items():
        side = next((d for d in closure.definitions if angle == Angle.of(d.name)), None)
        if side and side.name == another(name) and len(closure.directions) == 1:
            others = (d for d in closure.definitions if d is not side)
            definitions = (*others, PoseDefinition(name, side.formula))
            return closure._replace(definitions=definitions, directions={})
    return closure


def _aligned(turn: Turning, direction: Angle) -> Angle:
    return principal(direction * turn.sense)


def _beta(name: str) -> str:
    """Return the name of the inclination of a part whose direction has a name."""
    return f"beta_{name.removeprefix('phi_')}"


def _reached(reach: Reaching, length: Product, sides: DyadSides) -> list[PoseDefinition]:
    """Return how far is reached; none where the known side has this name already."""
    if length == Product.symbol(reach.name):
        return []
    side = next((d for d in sides.definitions if d.name == reach.name), None)
    return [PoseDefinition(side.name, negative(side.formula))] if side else [_reach(reach, length)]


def _reach(reach: Reaching, length: Product) -> PoseDefinition:
    return PoseDefinition(reach.name, (length / reach.scale).formula())
