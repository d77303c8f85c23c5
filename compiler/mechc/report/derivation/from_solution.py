"""The derivation read off the plan: speeds step by step, then the power equation."""

from collections.abc import Iterator, Sequence
from typing import assert_never

from ...formula.layout import has_minus
from ...formula.tree import ZERO, Formula, Sum, Symbol, negative, number, product, total
from ...friction.solution import Solution
from ...frozen import replace
from ...kinematics.forms import parting, projection, spin
from ...kinematics.graph import Form, Kind, Relation
from ...kinematics.graph import Rule as Law
from ...kinematics.plan import Block
from ...model.mechanism import Force, ForcePair, Joint, Speed, SpeedRatio, Torque, WheelPair
from ...power.balance import Balance, Term
from ...study.analysis import Analysis
from ..sentences.wording import positive_first
from .forces import of_forces
from .friction import of_friction
from .last_step import last_steps
from .notation import Named, Names, Notation, linear, times
from .outputs import acting_on
from .position import position_steps
from .ratios import Ratios
from .steps import Derivation, Equation, NamedRatio, PowerTerm, Rule, Step


def derive(solution: Solution, results: Sequence[Analysis]) -> Derivation:
    """Return the derivation of what was asked for, with the results as they are concluded."""
    balance = solution.balance
    writer = _Writer(balance)
    steps = tuple(writer.steps())
    terms = tuple(writer.term(t) for t in balance.terms if any(t.power))
    explanations = (*of_forces(solution), *of_friction(solution))
    balances, ratios = tuple(writer.balances()), tuple(writer.ratios)
    derivation = Derivation(steps, terms, balances, tuple(results), explanations, ratios=ratios)
    position = position_steps(balance.plan.graph.pose, derivation)
    return replace(derivation, position=tuple(position), last_steps=tuple(last_steps(derivation)))


class _Writer:
    """Writes steps in order, naming each unknown by the speed under which it is first met."""

    def __init__(self, balance: Balance) -> None:
        self._balance, self._plan, self._graph = balance, balance.plan, balance.plan.graph
        self._read = balance.reading
        self._notation = Notation(balance)
        self._ratios = Ratios(balance.reading, self._notation)
        self._names: dict[int, Named] = {}
        self._levered: set[str] = set()
        self._along: dict[str, Symbol] = {}
        self._pivots = self._graph.pose.mechanism.fixed

    @property
    def ratios(self) -> Sequence[NamedRatio]:
        """Return the ratios of speeds that the steps have given a name."""
        return self._ratios.found

    # -------------------------------------------------------------------------- steps

    def steps(self) -> Iterator[Step]:
        """Yield the steps that what was asked for rests on."""
        if held := self._graph.pose.mechanism.held:
            yield Step(Rule.HELD, tuple(drive.parameter for drive in held), (), ())
        for drive in self._plan.drives:
            self._names[drive] = self._first_name(drive)
        needed = self._needed()
        for block in self._plan.blocks:
            if not needed.isdisjoint(block.unknowns):
                yield from self._block(block)
        yield from self._levers_of_outputs()
        for term in self._balance.terms:
            yield from self._along_load(term)

    def _first_name(self, unknown: int) -> Named:
        """Name a drive by the first loaded point that moves with it."""
        for term in self._balance.terms:
            if isinstance(term.load, Force):
                if named := self._notation.of_point(unknown, term.load.point):
                    return named
            elif isinstance(term.load, Torque) and spin(self._graph, term.load.link).keys() == {
                unknown
            }:
                break
        return self._notation.of_itself(unknown)

    def _block(self, block: Block) -> Iterator[Step]:
        relations = [self._plan.relations[r] for r in block.relations]
        if len(relations) == 1:
            yield from self._single(relations[0], block.unknowns[0])
        else:
            yield self._together(relations, block.unknowns)

    def _single(self, relation: Relation, unknown: int) -> Iterator[Step]:
        """Yield the lever steps that a relation needs first, then the relation itself."""
        local: dict[int, Named] = {}
        for point in relation.points:
            for u in relation.form:
                if named := self._notation.of_point(u, point):
                    local[u] = named
                    if u != unknown:
                        yield from self._lever(u, named)
        self._names[unknown] = local.get(unknown) or self._notation.of_itself(unknown)
        names = {**self._names, **local}
        said, solved = self._written(relation.form, unknown, names)
        results = [solved]
        others = {names[u] for u in relation.form if u != unknown}
        if ratio := self._ratios.of(unknown):
            results += ratio
        elif len(others) > 1 and others != {self._names[d] for d in self._plan.drives}:
            results.append(self._solved(unknown))
        rule, subject = self._rule(relation)
        yield Step(rule, subject, (said,), tuple(results))

    def _together(self, relations: Sequence[Relation], unknowns: Sequence[int]) -> Step:
        for unknown in unknowns:
            self._names[unknown] = self._notation.of_itself(unknown)
        equations = tuple(Equation(linear(r.form, self._names), ZERO) for r in relations)
        results = tuple(e for u in unknowns for e in self._ratios.of(u) or (self._solved(u),))
        links = tuple(dict.fromkeys(name for r in relations for name in self._involved(r)))
        return Step(Rule.TOGETHER, links, equations, results)

    def _solved(self, unknown: int) -> Equation:
        return Equation(self._names[unknown].symbol, self._by_drives(unknown))

    def _by_drives(self, unknown: int) -> Formula:
        """Return an unknown's symbol in terms of the drives' symbols."""
        speeds = zip(self._read.speeds[unknown], self._plan.drives, strict=True)
        own = self._names[unknown].factor
        return total(
            times(speed * self._names[drive].factor / own, self._names[drive])
            for speed, drive in speeds
            if speed
        )

    def _written(self, form: Form, unknown: int, names: Names) -> tuple[Equation, Equation]:
        """Return a relation with the new speed on the left, positive, and solved for it."""
        lead = form[unknown] * names[unknown].factor
        rest = {u: -p for u, p in form.items() if u != unknown}
        if self._notation.sign(lead) < 0:
            lead, rest = -lead, {u: -p for u, p in rest.items()}
        solved = {u: p / lead for u, p in rest.items()}
        left = times(lead, names[unknown])
        return (
            Equation(left, linear(rest, names)),
            Equation(names[unknown].symbol, linear(solved, names)),
        )

    def _rule(self, relation: Relation) -> tuple[Rule, tuple[str, ...]]:
        """Return the textbook's rule for a relation and what it is applied to."""
        turns = self._graph.spins.get(relation.link) in relation.form
        match relation.rule:
            case Law.PROJECTION:
                return Rule.PROJECTION, relation.points
            case Law.GUIDE:
                return Rule.GUIDE, relation.points
            case Law.ROTATION if not turns:
                return Rule.PROJECTION, relation.points
            case Law.BODY:
                return Rule.BODY, (relation.link, *relation.points)
            case Law.ROTATION | Law.JOINT | Law.REST:
                return Rule.ROTATION, (relation.link, *relation.points)
            case Law.TURNING:
                return Rule.TURNING, self._joint_of(relation).bodies[::-1]
            case Law.SLOT | Law.CONTACT:
                return Rule(relation.rule.value), (*relation.points, relation.link)
            case Law.GEAR | Law.BELT | Law.RACK:
                joint = self._joint_of(relation)
                if isinstance(joint, WheelPair) and joint.arm:
                    return Rule.ON_ARM, (joint.arm, *relation.points)
                return Rule(relation.rule.value), relation.points
            case Law.SCREW:
                return Rule.SCREW, (relation.link, *relation.points)
            case Law.ROPE:
                return Rule.ROPE, relation.points
            case Law.HELD:
                raise ValueError("only a released joint is held, and no step of a motion")
            case _:
                assert_never(relation.rule)

    def _involved(self, relation: Relation) -> tuple[str, ...]:
        """Return the wheels, the link, or the point that a relation holds for."""
        if relation.rule in (Law.GEAR, Law.BELT):
            return self._joint_of(relation).bodies
        return (relation.link or relation.points[0],)

    def _joint_of(self, relation: Relation) -> Joint:
        """Return the joint that demands a relation."""
        return self._graph.pose.mechanism.joint(relation.joint)

    # ------------------------------------------------------------------------- levers

    def _lever(self, unknown: int, named: Named) -> Iterator[Step]:
        """Yield the step from the speed a pivoted link is known by to another of its points."""
        known = self._names[unknown]
        what = self._graph.unknowns[unknown]
        if what.kind is not Kind.SPIN or named.symbol == known.symbol:
            return
        if named.symbol.name in self._levered:
            return
        self._levered.add(named.symbol.name)
        ratio = known.factor / named.factor
        result = Equation(named.symbol, times(ratio, known))
        pivot = next(p for p in self._points(what.of) if p in self._pivots)
        arms = [(self._arm(pivot, named.point), 1)]
        if known.point:
            arms.append((self._arm(pivot, known.point), -1))
        said = Equation(named.symbol, product([*arms, (known.symbol, 1)]))
        points = (known.point, named.point) if known.point else (named.point,)
        rule = Rule.LEVER if known.point else Rule.ARM
        # Signed speeds may differ in sign from their arms.
        relation = said if self._notation.sign(ratio) > 0 else result
        yield Step(rule, (pivot, *points), (relation,), (result,))

    def _arm(self, pivot: str, point: str) -> Formula:
        """Return the length from a pivot to a point, under the name it has."""
        given = f"len_{point}{pivot}"
        known = given in self._graph.pose.placeholders
        return Symbol(given if known else f"len_{pivot}{point}")

    def _levers_of_outputs(self) -> Iterator[Step]:
        for point in self._output_points():
            for flow in self._graph.velocities.get(point, ()):
                if named := self._notation.of_point(flow.unknown, point):
                    yield from self._lever(flow.unknown, named)

    def _points(self, link: str) -> Sequence[str]:
        return self._graph.pose.mechanism.link(link).points

    # ------------------------------------------------------------------------ outputs

    def _speeds_asked(self) -> Iterator[Speed]:
        for find in self._graph.pose.mechanism.finds:
            if isinstance(find.target, SpeedRatio):
                yield find.target.above
                yield find.target.below

    def _output_points(self) -> Iterator[str]:
        for term in self._balance.terms:
            if any(term.power) and not isinstance(term.load, Torque):
                yield from acting_on(term.load, self._graph)
        yield from (s.of for s in self._speeds_asked() if s.kind == "point")

    def _needed(self) -> set[int]:
        """Return the unknowns that loads and speeds asked for depend on."""
        needed = {f.unknown for p in self._output_points() for f in self._graph.velocities[p]}
        links = [t.load.link for t in self._balance.terms if isinstance(t.load, Torque)]
        links += [s.of for s in self._speeds_asked() if s.kind == "link"]
        needed |= {u for link in links for u in spin(self._graph, link)}
        for block in reversed(self._plan.blocks):
            if not needed.isdisjoint(block.unknowns):
                needed |= {u for r in block.relations for u in self._plan.relations[r].form}
        return needed

    # -------------------------------------------------------------------------- power

    def term(self, term: Term) -> PowerTerm:
        """Return the power of one load with its point's speed as it is named."""
        load = term.load
        match load:
            case Force(_, point):
                assert term.line is not None
                form, at = projection(self._graph.velocities[point], term.line), point
            case ForcePair(_, first):
                assert term.line is not None
                form, at = parting(self._graph, load, term.line), first
            case Torque(_, link):
                form, at = spin(self._graph, link), link
            case _:
                assert_never(load)
        moving = {u: p for u, p in form.items() if any(self._plan.speeds[u])}
        speed = self._along.get(load.name) or linear(moving, self._names_at(moving, at))
        return PowerTerm(load.name, at, term.count.formula(), speed)

    def _names_at(self, form: Form, at: str) -> Names:
        """Return the names of a form's unknowns, by the speed of a point where it has one."""
        own = {u: named for u in form if (named := self._notation.of_point(u, at))}
        return {**self._names, **own}

    def _along_load(self, term: Term) -> Iterator[Step]:
        """Yield the step to the speed along a load of a point whose velocity is a sum."""
        if term.line is None or self._plan.mobility != 1 or not any(term.power):
            return
        if isinstance(term.load, ForcePair):
            yield from self._parting(term.load, term)
        if not isinstance(term.load, Force):
            return
        name, point = term.load.name, term.load.point
        velocity = self._graph.velocities[point]
        if len(velocity) < 2:
            return
        form = projection(velocity, term.line)
        self._along[name] = symbol = Symbol(f"V_{point}_{name}")
        drive = self._names[self._plan.drives[0]]
        said = Equation(symbol, linear(form, self._names_at(form, point)))
        result = Equation(symbol, times(self._read.value(form)[0] * drive.factor, drive))
        yield Step(Rule.COMPONENT, (point, name), (said,), (result,))

    def _parting(self, load: ForcePair, term: Term) -> Iterator[Step]:
        """Yield the step to the rate of the distance between the ends of a pair of forces."""
        assert term.line is not None
        form = parting(self._graph, load, term.line)
        if len(form) < 2:
            return
        symbol = Symbol(f"V_{load.first}{load.second}")
        self._along[load.name] = symbol
        drive = self._names[self._plan.drives[0]]
        named = {u: p for u, p in form.items() if any(self._plan.speeds[u])}
        said = Equation(symbol, linear(named, self._names))
        result = Equation(symbol, times(self._read.value(form)[0] * drive.factor, drive))
        yield Step(Rule.PARTING, acting_on(load, self._graph), (said,), (result,))

    def balances(self) -> Iterator[Equation]:
        """Yield the power equation, or one for each motion."""
        terms = [self.term(t) for t in self._balance.terms if any(t.power)]
        if not terms:
            return
        if self._plan.mobility == 1:
            yield Equation(total(positive_first(_power(t) for t in terms)), ZERO)
            return
        for motion, drive in enumerate(self._plan.drives):
            if any(t.power[motion] for t in self._balance.terms):
                yield Equation(self._motion(motion, drive), ZERO)

    def _motion(self, motion: int, drive: int) -> Formula:
        """Return the power in one motion, the other drives being held."""
        named = self._names[drive]
        parts = [
            product([(_load(t), 1), (times(t.power[motion] * named.factor, named), 1)])
            for t in self._balance.terms
            if t.power[motion]
        ]
        return total(positive_first(parts))


def _load(term: Term) -> Formula:
    return Symbol(term.load.name)


def _power(term: PowerTerm) -> Formula:
    sign, speed = 1, term.speed
    if isinstance(speed, Sum) and all(map(has_minus, speed.terms)):
        sign, speed = -1, negative(speed)
    return product([(number(sign), 1), (term.times, 1), (Symbol(term.load), 1), (speed, 1)])
