"""Steps of friction stated for earlier results: a name has one meaning, a line stands once."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...algebra.from_formula import to_product
from ...algebra.product import Product as AlgebraicProduct
from ...base.frozen import replace
from ...formula.tree import ONE, ZERO, Formula, Symbol, is_call, product
from ...formula.walk import substitute, symbols
from ...friction.solution import FrictionStep
from ...model.mechanism import (
    LoadForm,
    LoadRatio,
    Mechanism,
    ThreadFriction,
    WheelFriction,
    WithFriction,
)
from ...model.parts.targets import HOLDING
from ...model.result import Definition
from ..kinds import SentenceKind
from ..steps import Equation, Paragraph

_ONCE = {"internal", "external", "parallel", "single", "face", "iterated"}
"""Steps that are the same for all results."""


class EarlierSteps:
    """The names and lines of the steps entered so far, so that nothing is stated twice."""

    def __init__(self, mechanism: Mechanism, iterated: Iterable[Definition] = ()) -> None:
        """Begin with the angles of friction, and the forces that results find by iteration.

        The names of loads are those that these have without friction.
        """
        joints, loads = mechanism.friction.joints, [load.name for load in mechanism.loads]
        self.turns = set(mechanism.friction.parameters)
        """Names of angles by which friction turns a force, those of friction itself."""
        points = (point for body in mechanism.bodies for point in body.points)
        sizes = (size.name for size in (*mechanism.parameters, *mechanism.literals))
        self.named = frozenset((*loads, *points, *sizes))
        """Names of the description, none of which a letter of the page may be."""
        self._known: dict[str, Formula] = {}
        self._lines: set[tuple[str, str]] = set()
        self._found: dict[str, Formula] = {name: Symbol(name) for name in loads} | dict(iterated)
        self._sentences: set[tuple[SentenceKind, tuple[tuple[str, Formula], ...]]] = set()
        self._equations: set[tuple[Formula, Formula]] = set()
        self._stated: set[Equation] = set()
        self._per_unit: dict[str, dict[AlgebraicProduct, Formula]] = {}
        self._threads = {f"{j.point}_screw" for j in joints if isinstance(j, ThreadFriction)}
        self._rims = {f"{j.point}_{j.kind}" for j in joints if isinstance(j, WheelFriction)}

    def is_of_thread(self, name: str) -> bool:
        """Return whether a force ``n_A_screw`` or a slip ``v_A_screw`` is that of a thread."""
        return _joint_of(name) in self._threads

    def is_of_rim(self, name: str) -> bool:
        """Return whether a force ``n_O1_gear`` or a slip is that of a gear, a belt or a rack."""
        return _joint_of(name) in self._rims

    def enter_forces(
        self, steps: Sequence[FrictionStep], asked: WithFriction, result: str
    ) -> Sequence[FrictionStep]:
        """Enter the forces of a result; return its steps, with a new name for each that differs.

        The force in a rod is another one while the drive moves than while it just holds.
        """
        found = {left.name: right for left, right in _forces(steps) if left != driving(asked)}
        found = {name: found.get(getattr(f, "name", ""), f) for name, f in found.items()}
        others = self._others(found)
        endings = (ending(asked), f"_{result}")
        longer = next(
            e for e in endings if all(self._found.get(n + e, found[n]) == found[n] for n in others)
        )
        names = {name: Symbol(name + longer) for name in others}
        self._found |= {names.get(n, Symbol(n)).name: formula for n, formula in found.items()}
        steps = [renamed(step, names) for step in steps] if names else steps
        if isinstance(asked.of, LoadRatio) and asked.order == "exact":
            own = {driving(asked): Symbol(result)}
            known = self._per_unit.setdefault(asked.of.below, {})
            known |= {to_product(f): own.get(left, left) for left, f in _in_order(steps)}
        return steps

    def multiplied(self, steps: Sequence[FrictionStep]) -> tuple[Symbol, list[Equation]] | None:
        """Return a load, and the forces of a last step as it times those found per unit of it.

        They are so where each has the same formula for a load of 1: with one load all forces are
        proportional to it. None where they are not, and where nothing is found before that step.
        """
        *before, last = steps
        found = list(_in_order(before))
        met = symbols(*(side for pair in last.equations for side in pair))
        for load, per_unit in self._per_unit.items():
            ones: dict[str, Formula] = {load: ONE}
            for left, right in found:
                of_one = substitute(right, ones)
                ones[left.name] = per_unit.get(to_product(of_one), of_one)
            wanted = [f for f, _ in found if f.name in met and ones[f.name] != f]
            if wanted and all(ones[f.name] in per_unit.values() for f in wanted):
                unit = Symbol(load)
                times = ((f, product([(unit, 1), (ones[f.name], 1)])) for f in wanted)
                return unit, [Equation(*pair) for pair in times]
        return None

    def enter_equations(
        self, steps: Sequence[FrictionStep], asked: WithFriction
    ) -> Sequence[FrictionStep]:
        """Enter the equations of steps; return those of a force at a joint that say something new.

        A load is derived as a whole, what came before it or not.
        """
        new = [s for s in steps if not s.equations or not self._equations.issuperset(s.equations)]
        self._equations |= {equation for step in steps for equation in step.equations}
        return steps if driving(asked) else new

    def _others(self, found: Mapping[str, Formula]) -> set[str]:
        """Return the names that mean something else already, and those that rest on them."""
        others = {n for n, formula in found.items() if self._found.get(n, formula) != formula}
        for _ in found:
            others |= {n for n, f in found.items() if n in self._found and symbols(f) & others}
        return others

    def enter(self, step: FrictionStep) -> list[Equation] | None:
        """Enter a step; return its definitions that are new, None for a line shown before."""
        changed: set[str] = set()
        for name, formula in step.defined:
            if is_call(formula, "asin", "atan"):
                self.turns.add(name)
            if self._known.get(name) != formula or changed & symbols(formula):
                changed.add(name)
                self._known[name] = formula
        line = (step.kind, step.body)
        if step.kind in _ONCE and line in self._lines and not changed:
            return None
        self._lines.add(line)
        return [Equation(Symbol(d.name), d.formula) for d in step.defined if d.name in changed]

    def enter_lines(self, equations: Iterable[Equation]) -> Iterator[Equation]:
        """Enter equations; yield those but for quantities that an earlier one has stated."""
        for equation in equations:
            is_stated = equation in self._stated
            self._stated |= {equation} if isinstance(equation.left, Symbol) else set()
            if not is_stated:
                yield equation

    def enter_sentences(self, paragraphs: Iterable[Paragraph]) -> Iterator[Paragraph]:
        """Enter paragraphs; yield those whose sentence no earlier one had of the same formulas."""
        for paragraph in paragraphs:
            said = paragraph.sentence, tuple(paragraph.formulas.items())
            if said not in self._sentences:
                self._sentences.add(said)
                yield paragraph


def _joint_of(name: str) -> str:
    """Return the joint of a force or a slip: ``A_screw`` of ``n_A_screw_hold``."""
    return "_".join(name.split("_")[1:3])


def _forces(steps: Iterable[FrictionStep]) -> Iterator[tuple[Symbol, Formula]]:
    """Yield the unknowns that steps solve for, and what they are.

    Forces that are iterated have names of their own in each result already.
    """
    for step in steps:
        if step.kind == "iterated":
            continue
        named = {definition.name for definition in step.defined}
        for left, right in step.equations:
            if isinstance(left, Symbol) and left.name not in named and right != ZERO:
                yield left, right


def _in_order(steps: Iterable[FrictionStep]) -> Iterator[tuple[Symbol, Formula]]:
    """Yield what steps define and the unknowns that they solve for, as they rest on each other."""
    for step in steps:
        yield from ((Symbol(name), formula) for name, formula in step.defined)
        yield from _forces([step])


def renamed(step: FrictionStep, names: Mapping[str, Formula]) -> FrictionStep:
    """Return a step with other names in its formulas."""
    equations = ((substitute(a, names), substitute(b, names)) for a, b in step.equations)
    defined = (d._replace(formula=substitute(d.formula, names)) for d in step.defined)
    return replace(step, equations=tuple(equations), defined=tuple(defined))


def ending(asked: WithFriction) -> str:
    """Return the ending of a name with friction that stands for something else without it."""
    return HOLDING if asked.sense == "releasing" else "_f"


def driving(asked: WithFriction) -> Symbol | None:
    """Return the load that a result is of."""
    match asked.of:
        case LoadRatio(above, _):
            return Symbol(above)
        case LoadForm(load):
            return Symbol(load)
        case _:
            return None
