"""Forces at joints with friction in closed form, where the driving load has one.

What a joint passes on follows from the bodies that the chain has solved, or, where nothing but
guides and faces has friction, from what presses them.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Protocol

from ..algebra.angle import QUARTER, Angle
from ..algebra.from_formula import to_product
from ..algebra.product import ONE, Product
from ..algebra.sums import add, canonical
from ..base.frozen import replace
from ..base.named import NamedTuple
from ..formula.operations import count_operations
from ..formula.tree import Call, Formula, Sum, Symbol, negative, total
from ..formula.walk import symbols
from ..kinematics.joint_refs import JointRef, members
from ..model.mechanism import ForceAtJoint, Reaction
from ..model.result import Definition
from ..pose.pose import Arm, Pose, Vector
from ..power.definitions import bound_names
from ..power.joint_forces import component, joint_of, line_of, size_of_two
from ..power.reactions import Transmitted
from .chain_bodies import Bodies, BodyForce, EquationsCoupled
from .closed_form import PrintedFormula, readable
from .friction_pairs import LoadedPair
from .linear import LinearSolver
from .normal_forces import load_of
from .sequential import SequentialSolver
from .signs.at_one_pose import SignsAtOnePose
from .signs.conditions import conditions, positive
from .signs.names import SignSymbols
from .solution import FrictionStep, StepKind

X, Y = (Arm(ONE, Angle()),), (Arm(ONE, QUARTER),)


class NamedDrive(NamedTuple):
    """The driving load by the name of its result with friction, and what that rests on."""

    size: Product
    where: tuple[Definition, ...]


class AskedForce(NamedTuple):
    """The force that is asked for, under its name, and the driving load where that has a name."""

    name: str
    target: ForceAtJoint
    pose: Pose
    driving: str
    drive: NamedDrive | None


class ForceComponents(Protocol):
    """A force at a joint by its components, and the steps that lead to it."""

    @property
    def steps(self) -> Sequence[FrictionStep]:
        """Return the steps up to what the force is made of."""
        ...

    @property
    def step(self) -> FrictionStep:
        """Return the step of the force itself, its equations still empty."""
        ...

    def along(self, line: Vector) -> Product:
        """Return a component."""
        ...

    def shown(self, line: Vector) -> Formula:
        """Return a component in the names of what it is made of."""
        ...

    def size(self) -> Product | None:
        """Return the size of the force where it is that of one force."""
        ...


MakeSolver = Callable[[SignSymbols], SequentialSolver | LinearSolver]


def closed_force(
    asked: AskedForce, transmitted: Transmitted, way: MakeSolver, signs: SignsAtOnePose
) -> PrintedFormula:
    """Return a force at a joint as one way of solving gives it, for the signs of one pose.

    Raises :class:`EquationsCoupled` where it does not.
    """
    solver = way(signs)
    solver.solve()
    if isinstance(solver, SequentialSolver):
        found: ForceComponents = OfBodies(solver, asked)
    else:
        found = OfFrictions(solver, transmitted)
    formula = _formula(asked, found)
    step = replace(found.step, equations=_equations(asked, found))
    drive = asked.drive.where if asked.drive and _rests_on(formula, asked.drive) else ()
    where = (*signs.definitions, *drive)
    steps = (*found.steps, step)
    return PrintedFormula(
        formula, tuple(dict.fromkeys(where)), conditions(signs), steps, positive(solver.conditions)
    )


def _rests_on(formula: Formula, drive: NamedDrive) -> bool:
    return not symbols(formula).isdisjoint(d.name for d in drive.where)


def _formula(asked: AskedForce, found: ForceComponents) -> Formula:
    """Return the force, or the part of it that is asked for."""

    def along(line: Vector) -> Formula:
        return _written(found.along(line))

    match asked.target:
        case Reaction(part="size"):
            if (whole := found.size()) is not None:
                return readable(canonical(whole))
            return size_of_two(along(X), along(Y))
        case Reaction(part="direction"):
            return Call("atan2", (along(Y), along(X)))
        case _:
            return along(line_of(asked.target, asked.pose))


def _written(value: Product) -> Formula:
    """Return a component; a sum with a minus before it is one of the opposite terms."""
    found, turned = (readable(v) for v in (canonical(value), -canonical(value)))
    return negative(turned) if isinstance(turned, Sum) else found


def _equations(asked: AskedForce, found: ForceComponents) -> tuple[tuple[Formula, Formula], ...]:
    """Return the equation of the step: a component in the names of what it is made of."""
    if isinstance(asked.target, Reaction) and asked.target.part in ("size", "direction"):
        return ()
    shown = found.shown(line_of(asked.target, asked.pose))
    return ((Symbol(asked.name), shown),)


# ------------------------------------------------------------------------------ free bodies


class OfBodies:
    """A force at a joint as the sum of forces on a body that the chain has solved."""

    def __init__(self, solver: SequentialSolver, asked: AskedForce) -> None:
        self._solver, self._asked, self._bodies = solver, asked, solver.bodies
        joint = joint_of(asked.target, asked.pose)
        if solver.bodies.mechanism.is_on_the_line(members(asked.pose, joint)):
            raise EquationsCoupled
        kind, body, self._forces, self._line = _acting(joint, solver)
        self.step = FrictionStep(kind, body, joint.point)

    @property
    def steps(self) -> Sequence[FrictionStep]:
        """Return the steps up to the last that gives one of the forces."""
        names = (f.name for f, _ in self._forces if f.name not in self._given())
        needed = set(map(self._solver.symbol, names))
        ends = [
            i
            for i, step in enumerate(self._solver.steps)
            if not needed.isdisjoint(_solved_for(step))
        ]
        return tuple(self._solver.steps[: max(ends, default=-1) + 1])

    def _given(self) -> Mapping[str, Product]:
        """Return the forces that need no step: the loads, the driving one by its result's name."""
        drive = self._asked.drive
        known = {self._asked.driving: drive.size} if drive else {}
        return {**self._bodies.task.given, **known}

    def along(self, line: Vector) -> Product:
        """Return a component."""
        return self._along(line, self._size)

    def shown(self, line: Vector) -> Formula:
        """Return a component in the names of forces."""
        return _written(self._along(line, self._by_name))

    def _along(self, line: Vector, size_of: Callable[[str], Product]) -> Product:
        """Return a component; of a guide the one across it alone counts."""
        if len(line) != 1:
            raise EquationsCoupled
        turned = line[0].angle
        if self._line is None:
            return self._sum(turned, size_of)
        across = canonical(self._sum(self._line, size_of))
        return BodyForce("", "", self._line, across).along(turned)

    def _sum(self, line: Angle, size_of: Callable[[str], Product]) -> Product:
        """Return the component of all forces along a line."""
        parts = ((f.scaled(size_of(f.name)).along(line), sign) for f, sign in self._forces)
        return add(part.scaled(sign) for part, sign in parts)

    def size(self) -> Product | None:
        """Return the size of a single force, which counts positive, beside couples.

        That of a lever which carries nothing else is the force of a rod.
        """
        names = [force.name for force, _ in self._forces if force.line is not None]
        is_rod = len(names) == 1 and self._bodies.rod(names[0]) is not None
        if self._line is None and (is_rod or len(self._forces) == len(names) == 1):
            return self._size(names[0])
        return None

    def _size(self, name: str) -> Product:
        """Return the size of a force as it is known; a driving load that is long, by its name."""
        size = self._solved(name)
        if name == self._asked.driving and count_operations(size.formula()) <= PUT_IN_OPERATIONS:
            return size
        return self._given().get(name, size)

    def _by_name(self, name: str) -> Product:
        """Return the size of a force by its name, or as it is given."""
        given = self._given()
        return given[name] if name in given else to_product(self._solver.symbol(name))

    def _solved(self, name: str) -> Product:
        """Return the size of a force that the chain has found."""
        if name not in self._solver.sizes:
            raise EquationsCoupled
        return self._solver.sizes[name]


def _solved_for(step: FrictionStep) -> Iterator[Formula]:
    """Yield what a step finds: the root of a quadratic equation is defined beside it."""
    yield from (left for left, _ in step.equations)
    yield from (Symbol(definition.name) for definition in step.defined)


PUT_IN_OPERATIONS = 8
"""Operations of a driving load that is put in; one that has more keeps its name."""

SignedForces = Sequence[tuple[BodyForce, int]]


def _acting(
    joint: JointRef, solver: SequentialSolver
) -> tuple[StepKind, str, SignedForces, Angle | None]:
    """Return how a joint's force is found, on which body, and its parts with their signs.

    Where there is a line the joint presses along that alone.
    """
    bodies = solver.bodies
    match joint.kind:
        case "pin":
            return *_at_pin(joint, solver), None
        case "ground" if joint.point in bodies.guides:
            return _of_guide(joint.point, solver)
        case "slide":
            return _of_guide(joint.of, solver)
        case "ground":
            return *_of_pivot(joint.point, solver), None
        case "contact":
            contact = next(t for t in bodies.pose.contacts if t.point == joint.point)
            forces = [f for f in solver.on(_carrier(joint.point, bodies)) if f.point == joint.point]
            own = [(f, 1) for f in forces if f.name == f"R_{joint.point}"]
            return "normal part", joint.point, own, contact.normal
        case _:
            raise EquationsCoupled


def _of_guide(body: str, solver: SequentialSolver) -> tuple[StepKind, str, SignedForces, Angle]:
    """Return the force that balances all others on a slider across its guide."""
    if solver.bodies.kind(body) != "slider":
        raise EquationsCoupled
    across = solver.bodies.guide(body) + QUARTER
    return "across", body, [(force, -1) for force in solver.on(body)], across


def _carrier(point: str, bodies: Bodies) -> str:
    """Return the body that carries the point of a contact."""
    body = next((b for b in bodies.solvable() if point in bodies.points(b)), None)
    if body is None:
        raise EquationsCoupled
    return body


def _at_pin(joint: JointRef, solver: SequentialSolver) -> tuple[StepKind, str, SignedForces]:
    """Return the force on a link at one of its pins."""
    bodies = solver.bodies
    if joint.of in bodies.levers:
        if joint.point != bodies.pivot(joint.of):
            return "rod part", joint.of, _of_only_rod(joint.point, joint.of, solver)
        return "balance", joint.of, [(force, -1) for force in solver.on(joint.of)]
    rod = bodies.rod(f"S_{joint.of}")
    if rod is None:
        raise EquationsCoupled
    return "rod part", rod.name, [(solver.of_rod(rod, joint.point), -1)]


def _of_only_rod(point: str, lever: str, solver: SequentialSolver) -> SignedForces:
    """Return the force of the only rod, and nothing else, that acts on a lever at a point."""
    forces = [force for force in solver.on(lever) if force.point == point]
    if len(forces) != 1 or solver.bodies.rod(forces[0].name) is None:
        raise EquationsCoupled
    return [(forces[0], 1)]


def _of_pivot(point: str, solver: SequentialSolver) -> tuple[StepKind, str, SignedForces]:
    """Return the force of the ground on the only link at a pivot."""
    links = [k for k in solver.bodies.mechanism.links if point in k.points]
    if len(links) != 1:
        raise EquationsCoupled
    kind, body, forces = _at_pin(JointRef("pin", point, links[0].name), solver)
    return kind, body, (*forces, *((load, -1) for load in solver.bodies.loads_at(point)))


# -------------------------------------------------------------------------------- frictions


class OfFrictions:
    """A force at a joint as it is without friction, and what each friction adds to it."""

    step = FrictionStep("added")

    def __init__(self, solver: LinearSolver, transmitted: Transmitted) -> None:
        self._solver, self._transmitted = solver, transmitted

    @property
    def steps(self) -> Sequence[FrictionStep]:
        """Return the step of what presses."""
        return (self._solver.pressing(),)

    def along(self, line: Vector) -> Product:
        """Return the component along a line, of frictions by the values that were found."""
        return add(self._terms(line, self._solver.friction))

    def shown(self, line: Vector) -> Formula:
        """Return the component along a line, a term for each load and each friction by its name."""
        return total(
            canonical(term).formula() for term in self._terms(line, self._solver.friction_by_name)
        )

    def _terms(self, line: Vector, friction: Callable[[LoadedPair], Product]) -> list[Product]:
        """Return the terms of a component."""
        frictions = {load_of(p.pair): friction(p) for p in self._solver.loaded}
        amounts = component(self._transmitted, line)
        if any(any(bound_names(amount)) for amount in amounts.values()):
            raise EquationsCoupled
        loads = {load: frictions.get(load, Product.symbol(load)) for load in amounts}
        return [amount * loads[load] for load, amount in amounts.items() if amount]

    def size(self) -> Product | None:
        """Return None: there are as many forces as frictions."""
        return None
