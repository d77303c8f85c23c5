"""A load from the equilibrium of free bodies, put as a person would write it down."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from ...base.frozen import replace
from ...equilibrium.equilibrium import (
    Equilibrium,
    EquilibriumStep,
    EquilibriumSum,
    FoundForce,
    JointForce,
    LoadTerms,
)
from ...formula.layout import has_minus
from ...formula.tree import ZERO, Formula, Symbol, negative, product, total
from ...formula.walk import symbols
from ...friction.solution import FrictionSolution
from ...model.mechanism import ArcSlot, Mechanism, Reaction
from ...model.parts.targets import whole
from ...pose.pose import Pose
from ...power.balance import AlgebraicResult
from ...power.definitions import intermediates
from ...study.analysis import Analysis
from ..kinds import SentenceKind
from ..readable import turns_of_friction
from ..sentences.order import positive_first
from ..steps import Derivation, Equation, Explanation, Paragraph
from .forces import of_forces
from .friction import of_friction
from .notation import direction_formula
from .per_load import by_forces
from .position import position_steps
from .readable import ReadableDerivation

Places = tuple[str, ...]

_FORCES: Mapping[str, tuple[SentenceKind, Places]] = {
    "rod": (SentenceKind.FORCE_IN_ROD, ("link",)),
    "pivot": (SentenceKind.FORCE_OF_GROUND, ("link", "point")),
    "pin": (SentenceKind.FORCE_AT_PIN, ("link", "point")),
    "crank": (SentenceKind.FORCE_ALONG_ARM, ("link", "point", "arm")),
    "guide": (SentenceKind.FORCE_OF_GUIDE, ("point",)),
    "contact": (SentenceKind.FORCE_OF_TOUCH, ("point", "link")),
    "rim": (SentenceKind.FORCE_OF_RIM, ("first", "rest")),
    "rack": (SentenceKind.FORCE_OF_RACK, ("pivot", "point")),
    "thread": (SentenceKind.FORCE_OF_THREAD, ("link", "point")),
    "rope": (SentenceKind.FORCE_OF_ROPE, ("first",)),
    "couple": (SentenceKind.COUPLE_IN_SLOT, ("link", "rest")),
}
"""The sentence that says what a force is, and the places of its names in it."""

_ACROSS: Mapping[tuple[bool, bool], SentenceKind] = {
    (True, False): SentenceKind.FORCES_ACROSS,
    (True, True): SentenceKind.FORCES_ACROSS_RADIUS,
    (False, False): SentenceKind.PIN_ACROSS,
    (False, True): SentenceKind.PIN_ACROSS_RADIUS,
}
"""The sentence of forces across a rod, on a link or a pin, or across a slot's radius."""


def derive_by_equilibrium(
    solution: FrictionSolution, loads: Iterable[Equilibrium], results: Sequence[Analysis]
) -> Derivation:
    """Return the derivation of what was asked for, by the equilibrium of free bodies.

    A force at a joint that no sums lead to is found by virtual power.
    """
    loads = tuple(loads)
    sums = tuple(explained_by_sums(solution, loads))
    results, sums = by_forces(solution, loads, results, sums)
    explanations = (*sums, *of_friction(solution, results))
    pose = solution.plan.graph.pose
    requires = pose.mechanism.requires
    face = ReadableDerivation(solution.plan, turns_of_friction(results, pose))
    derivation = Derivation((), (), (), tuple(results), explanations, requires=requires)
    derivation = face.derivation(derivation)
    position = position_steps(pose, derivation)
    return replace(derivation, position=tuple(position))


def explained_by_sums(
    solution: FrictionSolution, loads: Iterable[Equilibrium]
) -> Iterator[Explanation]:
    """Yield how results follow from sums of forces and moments; forces without, by a release."""
    writer = _LoadWriter(solution.plan.graph.pose)
    groups = tuple(_results_of_one_force(solution, {each.result: each for each in loads}))
    yield from (writer.explanation(names, found) for names, found in groups)
    yield from of_forces(solution, frozenset(name for names, _ in groups for name in names))


def _results_of_one_force(
    solution: FrictionSolution, loads: Mapping[str, Equilibrium]
) -> Iterator[tuple[tuple[str, ...], tuple[Equilibrium, ...]]]:
    """Yield results that are explained together, with the steps to each of their components."""
    ideal = [one for one in solution.solved if isinstance(one, AlgebraicResult)]
    for force, group in groupby(ideal, lambda one: one.result.target and whole(one.result.target)):
        names = tuple(one.result.name for one in group)
        found = tuple(loads[name] for name in names if name in loads)
        if found and len(found) == (2 if isinstance(force, Reaction) else 1):
            yield names, found


class _LoadWriter:
    """Explains one load after another; a force found for an earlier one is not found anew."""

    def __init__(self, pose: Pose) -> None:
        self._pose = pose
        self._met: set[str] = set()
        self._found: dict[str, LoadTerms] = {}

    def explanation(self, names: tuple[str, ...], found: Sequence[Equilibrium]) -> Explanation:
        """Return how results follow: each force when it is met first, then the sums.

        Where a force has been found already, or has another name, it is said which one is meant.
        """
        paragraphs = [p for equilibrium in found for p in self._paragraphs(equilibrium)]
        called = [_called(each) for each in found if each.result != each.load and each.is_at_joint]
        if called:
            last = paragraphs.pop() if paragraphs else Paragraph(SentenceKind.EQUILIBRIUM)
            paragraphs.append(replace(last, equations=(*last.equations, *called)))
        paragraphs = list(_merged(paragraphs))
        sides = [side for p in paragraphs for equation in p.equations for side in equation]
        where = tuple(intermediates(self._pose, symbols(*sides)))
        return Explanation(names, tuple(paragraphs), where)

    def _paragraphs(self, equilibrium: Equilibrium) -> Iterator[Paragraph]:
        """Yield the paragraphs of a load: the steps whose forces have not been found before."""
        if not self._found:
            yield Paragraph(SentenceKind.EQUILIBRIUM)
        if equilibrium.parts > 1 and not self._found:
            yield Paragraph(SentenceKind.EQUAL_PARTS)
        for step in equilibrium.steps:
            new = {f.name: f.terms for f in step.found if self._found.get(f.name) != f.terms}
            if new:
                self._found |= new
                yield from self._forces(step, equilibrium.forces)
                yield from self._sums(step, equilibrium)

    def _forces(self, step: EquilibriumStep, forces: Iterable[JointForce]) -> Iterator[Paragraph]:
        """Yield the explanation of the forces that a step meets first."""
        mentioned = {name for balance in step.balances for name in balance.terms}
        for force in forces:
            if mentioned & {*force.names} and not self._met >= {*force.names}:
                self._met.update(force.names)
                yield _paragraph_on(force, self._pose)

    def _sums(self, step: EquilibriumStep, equilibrium: Equilibrium) -> Iterator[Paragraph]:
        """Yield the sums of a step, and the forces that follow: from one sum, or from several."""
        found = tuple(map(_solved, step.found))
        *others, last = step.balances
        if last.pin:
            yield _sum_of_joint_forces(last, found, equilibrium, self._pose.mechanism)
        elif others:
            yield from (_sum(balance, (), self._pose) for balance in step.balances)
            yield Paragraph(SentenceKind.SOLVED_TOGETHER, found)
        else:
            is_result = self._is_result(step, equilibrium)
            yield _sum(last, () if is_result else found, self._pose)

    def _is_result(self, step: EquilibriumStep, equilibrium: Equilibrium) -> bool:
        """Return whether a step gives a force in given loads, as the result is stated."""
        (found,) = step.found
        is_found = equilibrium.is_at_joint and equilibrium.result == found.name
        loads = {load.name for load in self._pose.mechanism.loads} - self._found.keys()
        return is_found and loads >= found.terms.keys()


def _sum_of_joint_forces(
    balance: EquilibriumSum,
    found: tuple[Equation, ...],
    equilibrium: Equilibrium,
    mechanism: Mechanism,
) -> Paragraph:
    """Return the sum of other forces that the force at a pin is, and why it is that."""
    sentence = _reason_for_sum(balance, equilibrium, mechanism)
    return Paragraph(sentence, found, {"point": (balance.pin,), "link": (balance.body,)})


def _reason_for_sum(
    balance: EquilibriumSum, equilibrium: Equilibrium, mechanism: Mechanism
) -> SentenceKind:
    if balance.body:
        is_rod = any((f.kind, *f.subject) == ("rod", balance.body) for f in equilibrium.forces)
        return SentenceKind.ROD if is_rod else SentenceKind.MADE_UP
    if balance.pin not in mechanism.fixed:
        return SentenceKind.SMOOTH
    is_shared = balance.pin in mechanism.shared
    return SentenceKind.SHARED if is_shared else SentenceKind.MADE_UP_BY_GROUND


def _called(equilibrium: Equilibrium) -> Equation:
    """Return the name of a result and that of the force on free bodies that it is."""
    return Equation(Symbol(equilibrium.result), Symbol(equilibrium.load))


def _merged(paragraphs: Iterable[Paragraph]) -> Iterator[Paragraph]:
    """Yield paragraphs, those that say the same of different components as one."""
    alike = groupby(paragraphs, lambda p: (p.sentence, {**p.names}, {**p.formulas}))
    for _, group in alike:
        first, *others = group
        more = (equation for other in others for equation in other.equations)
        yield replace(first, equations=(*first.equations, *more)) if others else first


def _paragraph_on(force: JointForce, pose: Pose) -> Paragraph:
    """Return a sentence on a force: its joint, rod or rope, and the letters of its components."""
    if force.kind == "rod" and (arc := pose.mechanism.arc_of(force.subject[0])):
        return _of_circular_slot(force, arc, pose.mechanism)
    kind = "crank" if force.kind == "pin" and force.subject[-1] else force.kind
    sentence, places = _FORCES[kind]
    names = {place: (name,) for place, name in zip(places, force.subject, strict=False)}
    letters = zip(("force", "other"), map(Symbol, force.names), strict=False)
    return Paragraph(sentence, (), names, dict(letters))


def _of_circular_slot(force: JointForce, arc: ArcSlot, mechanism: Mechanism) -> Paragraph:
    """Return a sentence on the force of a rod that takes the place of a circular slot."""
    (rod,), (letter,) = force.subject, force.names
    names = {"link": (arc.link,), "point": mechanism.link(rod).points[1:], "rest": (arc.centre,)}
    formulas = {"force": Symbol(letter)}
    return Paragraph(SentenceKind.FORCE_OF_CIRCULAR_SLOT, names=names, formulas=formulas)


def _sum(balance: EquilibriumSum, found: tuple[Equation, ...], pose: Pose) -> Paragraph:
    """Return a sum of forces or moments in words: about a point, along a guide, across a rod."""
    equations = tuple(dict.fromkeys((Equation(_left(balance), ZERO), *found)))
    body = "link" if balance.body in pose.frames else "point"
    names = {"link": (balance.body,), "point": (balance.body,)}
    if balance.centre:
        return Paragraph(SentenceKind.MOMENTS, equations, {**names, "point": (balance.centre,)})
    if balance.is_guide:
        return Paragraph(SentenceKind.ALONG, equations, names)
    if balance.across:
        rod = {"rod": (balance.across,)}
        is_slot = pose.mechanism.arc_of(balance.across) is not None
        sentence = _ACROSS[body == "link", is_slot]
        return Paragraph(sentence, equations, {**names, **rod})
    assert balance.along is not None, "a sum of forces has a direction"
    sentence = SentenceKind.FORCES_ALONG if body == "link" else SentenceKind.PIN_ALONG
    direction = {"direction": direction_formula(balance.along)}
    return Paragraph(sentence, equations, names, direction)


def _left(balance: EquilibriumSum) -> Formula:
    """Return a sum with most of its terms positive."""
    terms = _terms(balance.terms)
    if 2 * sum(map(has_minus, terms)) > len(terms):
        terms = list(map(negative, terms))
    return total(positive_first(terms))


def _solved(found: FoundForce) -> Equation:
    return Equation(Symbol(found.name), total(positive_first(_terms(found.terms))))


def _terms(terms: LoadTerms) -> list[Formula]:
    return [product([(part.formula(), 1), (Symbol(name), 1)]) for name, part in terms.items()]
