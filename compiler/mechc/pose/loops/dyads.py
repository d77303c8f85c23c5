"""Assur groups of two links in closed form, all five kinds of them.

A loop ``D + X + Y = 0`` has a known part D and two unknowns. Their kinds give the
group: two directions (RRR), a direction and a length along a known one (RRP, and RPR with
the guide on a moving link), a direction and a length that turns with it (RPR, the
oscillating cylinder), two lengths (PRP, RPP). Each has at most two closures, told apart
by the sign of one root.

Accuracy: the angles of a triangle with sides d, p, q come from the product of the four
factors d + p + q, p + q − d … (Heron; Kahan, Miscalculating Area and Angles of a
Needle-like Triangle, 2014), which has no cancellation where the triangle is nearly flat.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple

from ...algebra.angle import Angle
from ...algebra.factors import Length
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine, sine
from ...formula.tree import Call, Formula, negative, product, total
from ..pose import Arm, Definition, Limit, LoopKind, Vector, components, gathered
from ..samples import Values, is_behind
from .triangle import along, common_turn, heron, is_of_vector, principal
from .vector_graph import Cycle, Names, known_span, loop_name, mentioned

HALF_TURN, QUARTER = Angle.constant(180), Angle.constant(90)


class Closure(NamedTuple):
    """One way in which a loop closes.

    ``definitions`` are new names with their formulas; ``directions`` are unknown angles as
    angles in known ones and in those names.
    """

    definitions: tuple[Definition, ...]
    directions: Mapping[str, Angle]


class Turning(NamedTuple):
    """The part of a loop that turns with an unknown angle x: ``size @ sense·x + offset``."""

    name: str
    sense: int
    size: Product
    offset: Angle

    def angle_at(self, direction: Angle) -> Angle:
        """Return x where the part points in a direction."""
        return principal((direction - self.offset) * self.sense)

    @property
    def direction(self) -> Angle:
        """Return the direction of the part."""
        return principal(Angle.of(self.name) * self.sense + self.offset)


class Reaching(NamedTuple):
    """The part of a loop of unknown length s: ``scale·s @ direction``."""

    name: str
    scale: Product
    direction: Angle


Namer = Callable[[str], str]
"""Makes a name that nothing else has."""


class Group:
    """A loop with its two unknowns, taken apart."""

    def __init__(
        self,
        cycle: Cycle,
        unknown: Names,
        kept: Names,
        fixed: Names,
        name: Namer,
        values: Values,
        signed: Names = frozenset(),
        defined: Iterable[Definition] = (),
    ) -> None:
        """``kept`` are unknowns that the user named, ``fixed`` the pivots, ``values`` a pose.

        ``signed`` lengths may be negative somewhere on the stroke; ``defined`` was found before.
        Once closures were made, ``kind`` is that of the unknowns, and ``root`` is what has no
        value where there is none.
        """
        self._name, self._kept, self._fixed, self._values = name, kept, fixed, values
        self._signed = signed
        self._vectors = {d.name for d in defined if is_of_vector(d.formula)}
        self._shared: list[Definition] = []
        self.limit: Limit | None = None
        self.kind: LoopKind = "lengths"
        self.root: Call | None = None
        self.cycle, self.unknown = cycle, unknown
        self.known = gathered(
            arm for edge in cycle for arm in edge.arms if unknown.isdisjoint(mentioned((arm,)))
        )
        self.moving = [
            arm for edge in cycle for arm in edge.arms if not unknown.isdisjoint(mentioned((arm,)))
        ]

    def closures(self) -> tuple[Closure, ...] | None:
        """Return the closures, one or two; None for a loop of another kind."""
        turning, reaching = self._parts()
        match turning, reaching:
            case [first, second], []:
                found: Iterable[Closure] = self._two_turns(*self._grounded_last(first, second))
            case [turn], [reach] if turn.name not in mentioned(
                (Arm(reach.scale, reach.direction),)
            ):
                found = self._turn_and_guide(turn, reach)
            case [turn], [reach]:
                found = self._turn_and_slide(turn, reach)
            case [], [reach] if len(self.unknown) == 2:
                (name,) = self.unknown - {reach.name}
                bare = Turning(
                    name, int(dict(reach.direction.terms).get(name, 0)), Product(0), Angle()
                )
                found = self._turn_and_slide(bare, reach) if abs(bare.sense) == 1 else ()
            case [], [first_reach, second_reach]:
                found = self._two_lengths(first_reach, second_reach)
            case _:
                return None
        return tuple(c._replace(definitions=(*self._shared, *c.definitions)) for c in found) or None

    def _parts(self) -> tuple[list[Turning], list[Reaching]]:
        """Return the arms of unknown angle and of unknown length; none where others are there."""
        turns: dict[str, list[Arm]] = {}
        reaches: dict[str, Reaching] = {}
        for arm in self.moving:
            lengths = [n for n in sorted(self.unknown) if Length(n) in arm.length.factors]
            angles = [n for n, _ in arm.angle.terms if n in self.unknown]
            if lengths:
                scale = arm.length / Product.symbol(lengths[0])
                again = lengths[0] in reaches
                if again or not self.unknown.isdisjoint(mentioned((Arm(scale, Angle()),))):
                    return [], []
                reaches[lengths[0]] = Reaching(lengths[0], scale, arm.angle)
            elif len(angles) == 1:
                turns.setdefault(angles[0], []).append(arm)
            else:
                return [], []
        turning = [self._turning(name, arms) for name, arms in sorted(turns.items())]
        if any(t is None for t in turning):
            return [], []
        return [t for t in turning if t], list(reaches.values())

    def _turning(self, name: str, arms: list[Arm]) -> Turning | None:
        senses = {dict(arm.angle.terms)[name] for arm in arms}
        sense = senses.pop()
        if senses or abs(sense) != 1:
            return None
        within = gathered(Arm(a.length, a.angle - Angle.of(name) * sense) for a in arms)
        size, offset = self._polar(within, f"r_{name}")
        return Turning(name, int(sense), size, offset)

    def _grounded_last(self, first: Turning, second: Turning) -> tuple[Turning, Turning]:
        """Put the part that hangs on a pivot last: the direction of the coupler is named."""
        return (
            (second, first) if self._on_pivot(first) > self._on_pivot(second) else (first, second)
        )

    def _on_pivot(self, turn: Turning) -> bool:
        edges = [e for e in self.cycle if turn.name in mentioned(e.arms)]
        return any(p in self._fixed for e in edges for p in (e.tail, e.head))

    def _polar(self, vector: Vector, name: str, positive: bool = False) -> tuple[Product, Angle]:
        """Return a vector as one length and one direction, both named where it is a sum.

        What turns as one body has a direction within it, ``delta``, that does not turn.
        A difference or a place on a line is turned round where it is negative at the default
        pose. What must be ``positive`` elsewhere, too, turns round where it passes zero.
        """
        if len(vector) == 1 and not (positive and self._may_turn(vector[0].length)):
            length, angle = vector[0]
            behind = is_behind(length, [self._values])
            return (-length, angle + HALF_TURN) if behind else (length, angle)
        turn = common_turn(vector)
        within = gathered(Arm(arm.length, arm.angle - turn) for arm in vector)
        parts = tuple(p.formula() for p in components(within))
        size = self._name(f"len_{name}")
        way = self._name(f"delta_{name}" if turn.terms else size.replace("len", "phi", 1))
        self._shared.append(Definition(size, Call("hypot", parts)))
        self._shared.append(Definition(way, Call("atan2", parts[::-1])))
        return Product.symbol(size), turn + Angle.of(way)

    def _may_turn(self, length: Product) -> bool:
        return not self._signed.isdisjoint(mentioned((Arm(length, Angle()),)))

    def _known_side(self, positive: bool) -> tuple[Product, Angle]:
        """Return the known side of the loop; one that has a name keeps it, whatever leads there."""
        ends = known_span(self.cycle, self.unknown)
        for tail, head, turn in ((*ends, Angle()), (*ends[::-1], HALF_TURN)) if ends else ():
            size, way = f"len_{tail}{head}", f"phi_{tail}{head}"
            if len(self.known) > 1 and {size, way} <= self._vectors:
                return Product.symbol(size), Angle.of(way) + turn
        around = dict.fromkeys(e.tail for e in self.cycle)
        name = "".join(ends or around) or "0"
        return self._polar(self.known, name, positive)

    def inner_pin(self) -> str:
        """Return the point between the two unknown edges, '' where they do not meet."""
        loose = [not self.unknown.isdisjoint(mentioned(e.arms)) for e in self.cycle]
        for i, edge in enumerate(self.cycle):
            if loose[i - 1] and loose[i]:
                return edge.tail
        return ""

    # --------------------------------------------------------------------------- closing

    def _two_turns(self, first: Turning, second: Turning) -> Iterable[Closure]:
        """RRR: a triangle of three known sides d, p, q."""
        if not self.known:
            return
        d, psi = self._known_side(positive=True)
        p, q = first.size, second.size
        self.kind = "triangle"
        self.limit = Limit(loop_name(self.cycle), "triangle", self.known, (p, q))
        self.root = area = heron(d, p, q)
        base, tip = (
            Call("atan2", (area, add([a * a, b * b, -(c * c)]).formula()))
            for a, b, c in ((d, p, q), (p, q, d))
        )
        mu = self._named("mu", self.inner_pin() or first.name, tip)
        for sense in (1, -1):
            outside = first.angle_at(psi + HALF_TURN)
            sign = -sense * first.sense
            yield self._hinged(first, second, (outside, sign, base), mu * sense)

    def _hinged(
        self, first: Turning, second: Turning, lead: tuple[Angle, int, Formula], inner_angle: Angle
    ) -> Closure:
        """Return a closure of a triangle: the angle at its base names or gives a direction."""
        outside, sign, base = lead
        if len(self.known) > 1 or first.name in self._kept:
            turn = base if sign > 0 else negative(base)
            named = [Definition(first.name, total([outside.formula(), turn]))]
            other = second.angle_at(first.direction + HALF_TURN - inner_angle)
            return self._closure(named, {second.name: other})
        gamma = self._named("gamma", self._base_point() or first.name, base)
        angle = principal(outside + gamma * sign)
        direction = first.direction.put({first.name: angle})
        other = second.angle_at(direction + HALF_TURN - inner_angle)
        return self._closure([], {first.name: angle, second.name: other})

    def _named(self, letter: str, of: str, formula: Formula) -> Angle:
        """Return an angle of the triangle under a name of its own."""
        stem = f"{letter}_{of}"
        if all(d.formula != formula for d in self._shared):
            self._shared.append(Definition(self._name(stem), formula))
        return Angle.of(next(d.name for d in self._shared if d.formula == formula))

    def _base_point(self) -> str:
        """Return the point at which the first unknown edge leaves the known side."""
        loose = [not self.unknown.isdisjoint(mentioned(e.arms)) for e in self.cycle]
        starts = [e.tail for i, e in enumerate(self.cycle) if loose[i] and not loose[i - 1]]
        return starts[0] if starts else ""

    def triples(self) -> list[tuple[str, str, str]]:
        """Return three points of the loop whose turn tells the closures apart."""
        inner_pin = self.inner_pin()
        loose = [e for e in self.cycle if not self.unknown.isdisjoint(mentioned(e.arms))]
        before = next((e.tail for e in loose if e.head == inner_pin), loose[0].tail)
        after = next((e.head for e in loose if e.tail == inner_pin), loose[-1].head)
        return [(before, inner_pin or loose[0].head, after)]

    def _turn_and_guide(self, turn: Turning, reach: Reaching) -> Iterable[Closure]:
        """RRP: the part that turns spans the distance to the line that is reached along."""
        theta = reach.direction
        height = along(self.known, theta + QUARTER)
        self.kind = "guide"
        self.limit = Limit(loop_name(self.cycle), "guide", (), (turn.size, height))
        sine_of = -(height / turn.size)
        flip = -1 if sine_of.coefficient < 0 else 1
        inclination = Call("asin", (sine_of.scaled(flip).formula(),))
        self.root = inclination
        name = turn.name if turn.name in self._kept else self._name(_inclination(turn.name))
        for forward in (True, False):
            if turn.name in self._kept:
                start = turn.angle_at(theta if forward else theta + HALF_TURN)
                sign = flip * turn.sense * (1 if forward else -1)
                lean = inclination if sign > 0 else negative(inclination)
                named = Definition(turn.name, total([start.formula(), lean]))
                direction, put = turn.direction, {}
            else:
                named = Definition(name, inclination)
                lean_angle = Angle.of(name) * flip
                direction = theta + lean_angle if forward else theta + HALF_TURN - lean_angle
                put = {turn.name: turn.angle_at(direction)}
            behind = (*self.known, Arm(turn.size, direction))
            yield self._closure([named, _reach(reach, -along(behind, theta))], put)

    def _turn_and_slide(self, turn: Turning, reach: Reaching) -> Iterable[Closure]:
        """RPR: the part that is reached along turns with the unknown direction."""
        if not self.known:
            return
        gamma = reach.direction - Angle.of(turn.name) * turn.sense
        lean = turn.offset - gamma
        across, ahead = turn.size * sine(lean), turn.size * cosine(lean)
        d, psi = self._known_side(positive=bool(across))
        self.kind = "slot" if across else "aligned"
        self.limit = Limit(loop_name(self.cycle), "slot", self.known, (across,))
        if not across:
            for side, way in ((d, psi + HALF_TURN), (-d, psi)):
                named = _reach(reach, add([side, -ahead]))
                yield self._closure([named], {turn.name: _aligned(turn, way - gamma)})
            return
        sides = d.formula(), across.formula()
        self.root = root = Call(
            "sqrt", (product([(total([sides[0], negative(sides[1])]), 1), (total(sides), 1)]),)
        )
        for sign in (1, -1):
            stem = root if sign > 0 else negative(root)
            size = product([(total([stem, negative(ahead.formula())]), 1), _inverse(reach.scale)])
            offset = Call("atan2", (across.formula(), stem))
            lead = _aligned(turn, psi + HALF_TURN - gamma).formula()
            angle = total([lead, negative(offset) if turn.sense > 0 else offset])
            yield Closure((Definition(reach.name, size), Definition(turn.name, angle)), {})

    def _two_lengths(self, first: Reaching, second: Reaching) -> Iterable[Closure]:
        """PRP and RPP: two lengths along known directions."""
        angle = sine(first.direction - second.direction)
        if not angle:
            return
        one = -(along(self.known, second.direction + QUARTER) / angle)
        two = along(self.known, first.direction + QUARTER) / angle
        yield self._closure([_reach(first, one), _reach(second, two)], {})

    def _closure(self, definitions: list[Definition], put: Mapping[str, Angle]) -> Closure:
        """Return a closure; a direction that the user named is defined, others are put in."""
        named = [Definition(n, a.formula()) for n, a in put.items() if n in self._kept]
        return Closure(
            (*definitions, *named), {n: a for n, a in put.items() if n not in self._kept}
        )


def _aligned(turn: Turning, direction: Angle) -> Angle:
    return principal(direction * turn.sense)


def _inclination(name: str) -> str:
    return f"beta_{name.removeprefix('phi_')}"


def _reach(reach: Reaching, length: Product) -> Definition:
    return Definition(reach.name, (length / reach.scale).formula())


def _inverse(scale: Product) -> tuple[Formula, int]:
    return scale.formula(), -1
