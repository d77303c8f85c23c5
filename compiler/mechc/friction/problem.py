"""The problem of friction: the loads of a balance, the pairs with friction, the normal forces."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING

from ..algebra.product import ONE, Product
from ..algebra.sums import add, canonical
from ..base.named import NamedTuple
from ..diagnostics import Diagnostic, Report
from ..diagnostics import friction as messages
from ..diagnostics import reactions as reaction_messages
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..kinematics.joint_refs import unclear
from ..model.mechanism import (
    Efficiency,
    Find,
    LoadForm,
    LoadRatio,
    Mechanism,
    PinFriction,
    Sense,
    WithFriction,
)
from ..model.result import Definition, Result
from ..power.balance import Balance, PowerEquations
from ..power.definitions import bound_sums
from ..power.loads import given_size
from ..power.numbers import is_zero_everywhere
from ..power.reactions import Reactions
from . import closed_forces
from .chain_bodies import Bodies, Task, cut_free
from .closed_form import DefaultPose, DefinedFormula
from .coupled import Coupled, coupled, true_sizes
from .friction_pairs import FrictionPair, LoadedPair, friction_pairs
from .naming import Endings, ForceSizes, Meanings, with_one_meaning
from .normal_forces import Idle, LoadedByAnother, Undetermined, loaded_pairs
from .remarks import remarks_on_fast_pins, remarks_on_pairs_at_rest

if TYPE_CHECKING:
    from .closed_forces import NamedDrive

LoadedPairs = tuple[LoadedPair, ...]


class IdealResult(NamedTuple):
    """A result without friction: which load drives, by how much what is asked exceeds it."""

    ideal: Result
    driving: str
    factor: Product
    given: Mapping[str, Product]


class FrictionProblem:
    """A balance with friction in it; what several results rest on is found once.

    ``driving`` is the load that follows from all others, ``valued`` are those of known size.
    ``in_code`` says what names stand for there, ``endings`` what they end in.
    """

    def __init__(self, balance: Balance, report: Report) -> None:
        self.plan, self.equations, self.report = balance.plan, balance.equations, report
        self.driving = next(iter(balance.driving), "")
        self.valued: Mapping[str, Formula] = dict(self._weights())
        self.taken = _names_in(balance)
        self.in_code, self.endings = Meanings(), Endings()
        self.default = DefaultPose(balance.plan, self.valued, self.taken)
        self._pairs = friction_pairs(balance.plan.graph.pose)
        self._loaded: dict[object, LoadedPairs | None] = {}
        self._reactions: dict[str, Reactions] = {}
        self._bodies: dict[object, Bodies] = {}
        self._exact: dict[tuple[str, Sense], DefinedFormula] = {}
        self._sums: dict[int, tuple[Definition, ...]] = {}
        self._coupled: dict[int, Coupled] = {}
        self._sizes: dict[tuple[int, int], Callable[[], ForceSizes]] = {}
        self._idle: dict[Formula, bool] = {}

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism whose joints have friction."""
        return self.plan.graph.pose.mechanism

    def _weights(self) -> Iterator[tuple[str, Formula]]:
        """Yield the loads of known size, such as weights."""
        for load in self.mechanism.loads:
            size = given_size(self.mechanism, load.name)
            if size is not None and self.equations.owner(load.name)[0] == load.name:
                yield load.name, size

    def loaded(self, find: Find, case: IdealResult) -> LoadedPairs | None:
        """Return the loaded pairs under the loads of a case; None where that is open.

        Reports E510 … E514 there.
        """
        key = _loads(case)
        if key not in self._loaded:
            is_clear = self._is_clear(find, case.driving)
            self._loaded[key] = self._found(find, case) if is_clear else None
        return self._loaded[key]

    def _is_clear(self, find: Find, driving: str) -> bool:
        """Return whether there is one motion, and every pair is loaded as a result can say."""
        if self.equations.number != 1:
            self.report.add(messages.several_degrees_of_freedom(find.span, self.equations.number))
            return False
        error = next(unsuited(find, driving, self._pairs, self.mechanism, self.equations), None)
        if error is not None:
            self.report.add(error)
        return error is None

    def _found(self, find: Find, case: IdealResult) -> LoadedPairs | None:
        """Return the loaded pairs of a case; None where one cannot be found, which is reported."""
        try:
            loaded = loaded_pairs(self.plan, self.equations, case.driving, self._pairs, case.given)
        except Undetermined as found:
            self.report.add(messages.loaded_how_much(find.span, found.pair.joint.point))
        except LoadedByAnother as found:
            self.report.add(
                messages.another_load_presses(find.span, found.load, find.name, case.driving)
            )
        except Idle as found:
            self.report.add(messages.slips_either_way(find.span, found.pair.joint.point))
        else:
            for remark in remarks_on_pairs_at_rest(loaded, self.plan):
                self.report.add(remark)
            return loaded
        return None

    def sums(self, loaded: LoadedPairs) -> tuple[Definition, ...]:
        """Return the named sums that slips and normal forces rest on."""
        key = id(loaded)
        if key not in self._sums:
            self._sums[key] = tuple(self._bound_sums(loaded))
        return self._sums[key]

    def _bound_sums(self, loaded: LoadedPairs) -> Iterator[Definition]:
        yield from bound_sums(self.plan, [p.slip for p in loaded])
        for each in (p for p in loaded if p.pair.thrust is None):
            for plan, component in zip(each.plans, each.components, strict=True):
                if plan.bindings:
                    yield from bound_sums(plan, [component.ideal, *component.by.values()])

    def sizes(
        self, loaded: LoadedPairs, sense: int, endings: Sequence[str]
    ) -> Callable[[], ForceSizes]:
        """Return a function that gives the true sizes of normal forces, once for all of them.

        They are made when they are first asked for, after all that were spoken of before: so
        their names do not depend on what is asked for first.
        """
        key = id(loaded), sense
        self._sizes.setdefault(key, cache(partial(self._sizes_of, loaded, sense, endings)))
        spoken_of = [*self._sizes.values()][: 1 + [*self._sizes].index(key)]
        return lambda: [make() for make in spoken_of][-1]

    def _sizes_of(self, loaded: LoadedPairs, sense: int, endings: Sequence[str]) -> ForceSizes:
        if not loaded:
            return ForceSizes({}, (), sense, ())
        if id(loaded) not in self._coupled:
            self._coupled[id(loaded)] = coupled(loaded, self.taken)
        found = true_sizes(self._coupled[id(loaded)], sense)
        return with_one_meaning(found, (self.in_code, self.default.meanings), endings)

    def bodies(self, case: IdealResult, loaded: LoadedPairs, cranks: bool) -> Bodies:
        """Return the free bodies in a case, once for either sense of motion.

        Raises :class:`EquationsCoupled` where one is none that can be solved by itself.
        """
        key = *_loads(case), cranks
        if key not in self._bodies:
            self._bodies[key] = cut_free(self._task(case, loaded), cranks)
        return self._bodies[key]

    def _task(self, case: IdealResult, loaded: LoadedPairs) -> Task:
        """Return the task of solving the free bodies in a case."""
        pose, driving = self.plan.graph.pose, case.driving
        owners = {load.name: self.equations.owner(load.name) for load in self.mechanism.loads}
        reactions = self._reactions.setdefault(driving, Reactions(pose, (driving,)))
        return Task(pose, driving, case.given, owners, loaded, reactions)

    def exact(
        self, ideal: str, sense: Sense, solve: Callable[[], DefinedFormula]
    ) -> DefinedFormula:
        """Return a result's solution, once for the load with friction and the efficiency."""
        if (ideal, sense) not in self._exact:
            self._exact[ideal, sense] = solve()
        return self._exact[ideal, sense]

    def is_idle(self, driving: Formula, where: Iterable[Definition]) -> bool:
        """Return whether what drives is zero without friction, once for all forces at joints."""
        if driving not in self._idle:
            self._idle[driving] = is_zero_everywhere(driving, where, self.plan.graph.pose)
        return self._idle[driving]

    def drive(self, sense: Sense) -> "NamedDrive | None":
        """Return the driving load by the name of its result with friction, if that is known."""
        wanted = WithFriction(LoadForm(self.driving), sense)
        finds = self.mechanism.finds
        name = next((f.name for f in finds if f.target == wanted), "")
        ideal = next((f.name for f in finds if f.target == wanted.of), "")
        found = self._exact.get((ideal, sense))
        if not name or found is None or found.case is None:
            return None
        case = found.case
        own = Definition(name, case.formula)
        return closed_forces.NamedDrive(Product.symbol(name), (*case.where, own))

    def remark_on_pins(self, case: IdealResult, *, exact: bool) -> None:
        """Remark on pins whose friction depends on the link that they are fast in."""
        for remark in remarks_on_fast_pins(
            self.plan.graph.pose, case.driving, case.given, exact=exact
        ):
            self.report.add(remark)


def _loads(case: IdealResult) -> tuple[object, ...]:
    """Return the loads of a case, by which it is known: there may be no pairs with friction."""
    return case.driving, tuple(case.given.items())


def _names_in(balance: Balance) -> frozenset[str]:
    """Return all names that a description and its pose have given."""
    pose = balance.plan.graph.pose
    mechanism = pose.mechanism
    named = (
        *mechanism.parameters,
        *mechanism.literals,
        *mechanism.loads,
        *mechanism.finds,
        *mechanism.lets,
        *pose.definitions,
    )
    return frozenset(item.name for item in named)


def unsuited(
    find: Find,
    driving: str,
    pairs: Iterable[FrictionPair],
    mechanism: Mechanism,
    equations: PowerEquations,
) -> Iterator[Diagnostic]:
    """Yield an error for each pair of surfaces that is pressed as no result can say."""
    loaded_on = unclear(mechanism)
    lines = {k.point: k.span for k in mechanism.friction.joints if isinstance(k, PinFriction)}
    for pair in pairs:
        point = pair.joint.point
        if pair.thrust is not None:
            yield from _thrust(find, driving, point, pair.thrust, equations)
        elif pair.joint.kind == "pin" and point in loaded_on:
            yield reaction_messages.transmission_presses(
                lines.get(point, find.span), point, has_friction=True
            )


def _thrust(
    find: Find, driving: str, point: str, thrust: Formula, equations: PowerEquations
) -> Iterator[Diagnostic]:
    """Yield an error for a thrust that spoils a ratio, or that the driving load itself makes."""
    loads = symbols(thrust) & equations.owners.keys()
    if any(equations.owner(load)[0] == driving for load in loads):
        yield messages.thrust_of_the_drive(find.span, point, driving)
    elif not loads and _is_ratio(find):
        given = f"the given thrust at {point}"
        yield messages.another_load_presses(find.span, given, find.name, driving)


def _is_ratio(find: Find) -> bool:
    """Return whether a ratio of two loads is asked for with friction."""
    target = find.target
    return isinstance(target, WithFriction | Efficiency) and isinstance(target.of, LoadRatio)


def case_of_loads(
    of: LoadRatio | LoadForm, ideal: Result, equations: PowerEquations
) -> IdealResult:
    """Return the loads under which a ratio or a form of loads is looked at."""
    match of:
        case LoadRatio(above, below):
            upper, factor = equations.owner(above)
            lower, share = equations.owner(below)
            return IdealResult(ideal, upper, factor, {lower: ONE / share})
        case LoadForm(load):
            return IdealResult(ideal, load, ONE, _others(load, equations))


def case_of_force(driving: str, ideal: Result, equations: PowerEquations) -> IdealResult:
    """Return the loads under which a force at a joint is looked at: all of them."""
    return IdealResult(ideal, driving, ONE, _others(driving, equations))


def _others(driving: str, equations: PowerEquations) -> Mapping[str, Product]:
    """Return all other free loads as they are: one that does no work loads the joints, too."""
    names = (*equations.columns, *equations.idle_loads)
    return {n: Product.symbol(n) for n in names if n != driving}


def without_friction(case: IdealResult, equations: PowerEquations) -> Product:
    """Return the driving load that balances those given."""
    columns = equations.columns
    works = (columns[n][0] * size for n, size in case.given.items() if n in columns)
    return canonical(-(add(works) / columns[case.driving][0]))
