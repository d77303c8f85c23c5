"""The steps that lead from the drive to every speed that is needed, under textbooks' names."""

from collections.abc import Generator, Iterator, Sequence

from ...algebra.from_formula import to_product
from ...algebra.product import ONE, Product
from ...formula.layout import has_minus
from ...formula.operations import count_operations
from ...formula.tree import ZERO, Formula, Symbol, product, quotient, total
from ...kinematics.contacts import turning
from ...kinematics.forms import scaled, spin
from ...kinematics.graph import Graph, LinearForm, Relation, SpeedKind
from ...kinematics.plan import Block, Plan
from ...model.mechanism import Force, Load, Speed, SpeedRatio, Torque, WheelPair
from ...power.balance import Balance
from ...units import FREQUENCY, VELOCITY, Dimension
from ..kinds import StepRule
from ..steps import DerivationStep, Equation, NamedRatio, Reason
from .notation import SpeedNotation, WrittenUnknown, WrittenUnknowns, in_written_unknowns, times
from .rules import involved, pole_of, rule_of


def acting_on(load: Load, graph: Graph) -> tuple[str, ...]:
    """Return the described points on which a load acts."""
    return tuple(p for p in load.points if p in graph.velocities)


def output_points(balance: Balance) -> Iterator[str]:
    """Yield the points whose velocities loads and speeds asked for rest on."""
    graph = balance.plan.graph
    for term in balance.terms:
        if any(term.power):
            yield from acting_on(term.load, graph)
    yield from (speed.of for speed in _speeds_asked(graph) if speed.kind == "point")


def needed_unknowns(balance: Balance) -> set[int]:
    """Return the unknown speeds that loads and speeds asked for depend on."""
    plan, graph = balance.plan, balance.plan.graph
    needed = {f.unknown for p in output_points(balance) for f in graph.velocities[p]}
    links = [t.load.link for t in balance.terms if isinstance(t.load, Torque)]
    links += [speed.of for speed in _speeds_asked(graph) if speed.kind == "link"]
    needed |= {u for link in links for u in spin(graph, link)}
    for block in reversed(plan.blocks):
        if not needed.isdisjoint(block.unknowns):
            needed |= {u for r in block.relations for u in plan.relations[r].form}
    return needed


def _speeds_asked(graph: Graph) -> Iterator[Speed]:
    for find in graph.pose.mechanism.finds:
        if isinstance(find.target, SpeedRatio):
            yield find.target.above
            yield find.target.below


class SpeedSteps:
    """Writes steps in order, naming each unknown by the speed under which it is first met."""

    def __init__(self, balance: Balance) -> None:
        self.balance, self.plan, self._graph = balance, balance.plan, balance.plan.graph
        self._notation = SpeedNotation(balance)
        self._ratios = NamedRatios(balance.reading, self._notation)
        self._names: dict[int, WrittenUnknown] = {}
        self._levered: set[str] = set()
        self._composed: set[str] = set()
        self._turning: dict[int, WrittenUnknown] = {}

    @property
    def names(self) -> WrittenUnknowns:
        """Return the names of the unknowns that the steps so far have met."""
        return self._names

    @property
    def ratios(self) -> Sequence[NamedRatio]:
        """Return the ratios of speeds that the steps so far have given a name."""
        return self._ratios.shown

    def names_at(self, form: LinearForm, *points: str) -> WrittenUnknowns:
        """Return the names of a form's unknowns, by the speed of one of the points if it is met.

        Of a link under a couple it is its angular velocity that is met.
        """
        turning = {u: n for u, n in self._turning.items() if self._graph.unknowns[u].of in points}
        met = self._levered | {n.symbol.name for n in self._names.values()}
        named = ((u, self._notation.of_point(u, point)) for u in form for point in points)
        return {**self._names, **turning, **{u: n for u, n in named if n and n.symbol.name in met}}

    def steps(self) -> Iterator[DerivationStep]:
        """Yield the steps that what was asked for rests on."""
        if held := self._graph.pose.mechanism.held:
            yield DerivationStep(StepRule.HELD, tuple(drive.parameter for drive in held), (), ())
        for drive in self.plan.drives:
            self._names[drive] = self._first_name(drive)
        needed = needed_unknowns(self.balance)
        for block in self.plan.blocks:
            if not needed.isdisjoint(block.unknowns):
                yield from self._block(block)
        for point in output_points(self.balance):
            for flow in self._graph.velocities.get(point, ()):
                if named := self._notation.of_point(flow.unknown, point):
                    yield from self._lever(flow.unknown, named)
        if self.plan.mobility == 1:
            yield from self._turning_under_couples()

    def _turning_under_couples(self) -> Iterator[DerivationStep]:
        """Yield the angular velocities of links under couples that are known by a point's speed."""
        for term in self.balance.terms:
            if isinstance(term.load, Torque) and any(term.power):
                (unknown, *others) = spin(self._graph, term.load.link)
                if self._names[unknown].point and not others and unknown not in self._turning:
                    yield self._turn(unknown)

    def _turn(self, unknown: int) -> DerivationStep:
        """Return the step from the speed of a link's point to its angular velocity."""
        known, named = self._names[unknown], self._notation.of_itself(unknown)
        self._turning[unknown] = named
        pivot = self._pivot_of(self._graph.unknowns[unknown].of)
        rate = Equation(named.symbol, times(known.factor / named.factor, known))
        arm = product([(self._arm(pivot, known.point), 1), (named.symbol, 1)])
        is_positive = self._notation.sign(known.factor / named.factor) > 0
        relation = Equation(known.symbol, arm) if is_positive else rate
        return DerivationStep(StepRule.ARM, (pivot, known.point), (relation,), (rate,))

    def _first_name(self, unknown: int) -> WrittenUnknown:
        """Name a drive by the first loaded point that moves with it."""
        for term in self.balance.terms:
            if isinstance(term.load, Force):
                if named := self._notation.of_point(unknown, term.load.point):
                    return named
            elif isinstance(term.load, Torque) and spin(self._graph, term.load.link).keys() == {
                unknown
            }:
                break
        return self._notation.of_itself(unknown)

    # ---------------------------------------------------------------------- relations

    def _block(self, block: Block) -> Iterator[DerivationStep]:
        relations = [self.plan.relations[r] for r in block.relations]
        if len(relations) == 1:
            yield from self._single(relations[0], block.unknowns[0])
        else:
            for relation in relations:
                if is_of_wheels(relation, self._graph):
                    yield from self._angular(relation, block.unknowns)
            yield self._simultaneous_step(relations, block.unknowns)

    def _single(self, relation: Relation, unknown: int) -> Iterator[DerivationStep]:
        """Yield the lever steps that a relation needs first, then the relation itself."""
        local = yield from self._named_by(relation, unknown)
        self._names[unknown] = local.get(unknown) or self._notation.of_itself(unknown)
        names = {**self._names, **local}
        said, solved = self._written(relation.form, unknown, names)
        said = seen_from_arm(relation, self._graph, names) or said
        results = [solved]
        others = {names[u] for u in relation.form if u != unknown}
        if ratio := self._ratios.show(unknown):
            results += ratio
        elif len(others) > 1 and others != {self._names[d] for d in self.plan.drives}:
            results.append(self._solved(unknown))
        rule, subject = rule_of(relation, self._graph)
        is_projection = rule in (StepRule.PROJECTION, StepRule.CIRCULAR_SLOT)
        ends = relation.points if is_projection else ()
        reasons = tuple(r for point in ends for r in self._plane_motion(point, relation))
        yield DerivationStep(rule, subject, (said,), tuple(results), reasons)

    def _named_by(
        self, relation: Relation, unknown: int
    ) -> Generator[DerivationStep, None, dict[int, WrittenUnknown]]:
        """Yield the steps by which the known speeds of a relation get names; return the names."""
        if is_of_wheels(relation, self._graph):
            yield from self._angular(relation, (unknown,))
            return {u: named for u, named in self._turning.items() if u in relation.form}
        local: dict[int, WrittenUnknown] = {}
        for point in relation.points:
            for u in relation.form:
                if named := self._notation.of_point(u, point):
                    local[u] = named
                    if u != unknown:
                        yield from self._lever(u, named)
        return local

    def _angular(self, relation: Relation, unknowns: Sequence[int]) -> Iterator[DerivationStep]:
        """Yield the angular velocities of wheels and arms that points' speeds are known of."""
        for u in relation.form:
            if u not in unknowns and self._names[u].point and u not in self._turning:
                yield self._turn(u)

    def _plane_motion(self, point: str, relation: Relation) -> Iterator[Reason]:
        """Yield from which other points and rotations a velocity comes, each once."""
        found = pole_of(point, relation, self._graph)
        if found is None or point in self._composed:
            return
        self._composed.add(point)
        link, pole = found
        yield from self._plane_motion(pole, relation)
        is_radius = self._graph.pose.mechanism.arc_of(link) is not None
        yield (
            StepRule.TURNING_RADIUS if is_radius else StepRule.PLANE,
            (link, pole, point),
        )

    def _simultaneous_step(
        self, relations: Sequence[Relation], unknowns: Sequence[int]
    ) -> DerivationStep:
        """Return the step that solves several relations for as many unknown speeds at once.

        In its equations each unknown is named by itself, not by the speed of a point.
        """
        for unknown in unknowns:
            self._names[unknown] = self._notation.of_itself(unknown)
        equations = tuple(map(self._as_it_is, relations))
        results = tuple(equation for u in unknowns for equation in self._solution(u))
        links = tuple(dict.fromkeys(n for r in relations for n in involved(r, self._graph)))
        reasons = tuple(dict.fromkeys(rule_of(r, self._graph) for r in relations))
        return DerivationStep(StepRule.TOGETHER, links, equations, results, reasons)

    def _as_it_is(self, relation: Relation) -> Equation:
        """Return a relation that is solved together with others: of wheels by what turns."""
        turning = self._turning if is_of_wheels(relation, self._graph) else {}
        names = {**self._names, **turning}
        said = seen_from_arm(relation, self._graph, names)
        return said or Equation(in_written_unknowns(relation.form, names), ZERO)

    def _solution(self, unknown: int) -> tuple[Equation, ...]:
        """Return an unknown's named ratio to the drive, if it has one; else the unknown itself."""
        named_ratio = self._ratios.show(unknown)
        return named_ratio or (self._solved(unknown),)

    def _solved(self, unknown: int) -> Equation:
        return Equation(self._names[unknown].symbol, self._by_drives(unknown))

    def _by_drives(self, unknown: int) -> Formula:
        """Return an unknown's symbol in terms of the drives' symbols."""
        speeds = zip(self.balance.reading.speeds[unknown], self.plan.drives, strict=True)
        own = self._names[unknown].factor
        return total(
            times(speed * self._names[drive].factor / own, self._names[drive])
            for speed, drive in speeds
            if speed
        )

    def _written(
        self, form: LinearForm, unknown: int, names: WrittenUnknowns
    ) -> tuple[Equation, Equation]:
        """Return a relation with the new speed on the left, positive, and solved for it."""
        lead = form[unknown] * names[unknown].factor
        rest = {u: -p for u, p in form.items() if u != unknown}
        if self._notation.sign(lead) < 0:
            lead, rest = -lead, {u: -p for u, p in rest.items()}
        right = in_written_unknowns(rest, names)
        apart = in_written_unknowns({u: p / lead for u, p in rest.items()}, names)
        whole = product([(right, 1), (lead.formula(), -1)])
        return (
            Equation(times(lead, names[unknown]), right),
            Equation(names[unknown].symbol, min(apart, whole, key=count_operations)),
        )

    # ------------------------------------------------------------------------- levers

    def _lever(self, unknown: int, named: WrittenUnknown) -> Iterator[DerivationStep]:
        """Yield the step from the speed a pivoted link is known by to another of its points."""
        known = self._names[unknown]
        what = self._graph.unknowns[unknown]
        if what.kind is not SpeedKind.SPIN or named.symbol == known.symbol:
            return
        if named.symbol.name in self._levered:
            return
        self._levered.add(named.symbol.name)
        ratio = known.factor / named.factor
        result = Equation(named.symbol, times(ratio, known))
        pivot = self._pivot_of(what.of)
        arms = [(self._arm(pivot, named.point), 1)]
        if known.point:
            arms.append((self._arm(pivot, known.point), -1))
        said = Equation(named.symbol, product([*arms, (known.symbol, 1)]))
        points = (known.point, named.point) if known.point else (named.point,)
        rule = StepRule.LEVER if known.point else StepRule.ARM
        # Signed speeds may differ in sign from their arms.
        relation = said if self._notation.sign(ratio) > 0 else result
        yield DerivationStep(rule, (pivot, *points), (relation,), (result,))

    def _pivot_of(self, link: str) -> str:
        mechanism = self._graph.pose.mechanism
        return next(p for p in mechanism.link(link).points if p in mechanism.fixed)

    def _arm(self, pivot: str, point: str) -> Formula:
        """Return the length from a pivot to a point, under the name it has."""
        given = f"len_{point}{pivot}"
        known = given in self._graph.pose.placeholders
        return Symbol(given if known else f"len_{pivot}{point}")


class NamedRatios:
    """The named ratios of the plan that formulas are read off; ``shown`` are those in steps."""

    def __init__(self, read: Plan, notation: SpeedNotation) -> None:
        self._read, self._notation = read, notation
        self.shown: list[NamedRatio] = []

    def show(self, unknown: int) -> tuple[Equation, ...]:
        """Show an unknown's ratio to the drive, where it has a name; return its equations."""
        ratio = self._read.ratios.get(unknown)
        if ratio is None:
            return ()
        above, below = unknown, self._read.drives[0]
        dimension = self._rate(above).over(self._rate(below))
        found = NamedRatio(ratio.name, ratio.value.formula(), dimension)
        self.shown.append(found)
        speeds = (self._notation.of_itself(u).symbol for u in (above, below))
        name = Symbol(found.name)
        return Equation(name, quotient(*speeds)), Equation(name, found.formula)

    def _rate(self, unknown: int) -> Dimension:
        kind = self._read.graph.unknowns[unknown].kind
        return FREQUENCY if kind is SpeedKind.SPIN else VELOCITY


def seen_from_arm(relation: Relation, graph: Graph, names: WrittenUnknowns) -> Equation | None:
    """Return ``z₁(ω₁ - ω_arm) = z₂(ω₂ + ω_arm)``: equal speeds of rims relative to the arm.

    Factors that both radii have, such as the module, are left out. None for other relations, and
    where a speed that is zero has no name.
    """
    pair = graph.pose.mechanism.joint(relation.joint) if relation.joint else None
    if not isinstance(pair, WheelPair) or not pair.arm:
        return None
    own, other = (turning(graph, link, pair.arm) for link in pair.wheels)
    if not {*own, *other} <= names.keys():
        return None
    if not pair.same:
        other = scaled(other, -ONE)
    if has_minus(in_written_unknowns(own, names)):
        own, other = scaled(own, -ONE), scaled(other, -ONE)
    first, second = _without_common(to_product(pair.first_radius), to_product(pair.second_radius))
    return Equation(
        product([(first.formula(), 1), (in_written_unknowns(own, names), 1)]),
        product([(second.formula(), 1), (in_written_unknowns(other, names), 1)]),
    )


def is_of_wheels(relation: Relation, graph: Graph) -> bool:
    """Return whether a relation is one of angular velocities, as wheels have it."""
    if not relation.joint:
        return False
    return isinstance(graph.pose.mechanism.joint(relation.joint), WheelPair)


def _without_common(first: Product, second: Product) -> tuple[Product, Product]:
    """Return two products without the factors that both have."""
    share = first / second
    above = {f: e for f, e in share.factors.items() if e > 0}
    below = {f: -e for f, e in share.factors.items() if e < 0}
    return (
        Product(share.coefficient.numerator, above),
        Product(share.coefficient.denominator, below),
    )
