"""A load from the equilibrium of free bodies, put as a person would write it down."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from ...equilibrium.equilibrium import Balance, Equilibrium, Found, JointForce, Step, Terms
from ...formula.layout import has_minus
from ...formula.tree import ZERO, Formula, Symbol, negative, product, total
from ...formula.walk import symbols
from ...friction.solution import Solution
from ...frozen import replace
from ...model.mechanism import Reaction
from ...model.targets import whole
from ...pose.pose import Pose
from ...power.balance import Solved
from ...power.definitions import intermediates
from ...study.analysis import Analysis
from ..sentences.wording import positive_first
from .forces import of_forces
from .friction import of_friction
from .notation import direction_formula
from .position import position_steps
from .steps import Derivation, Equation, Explanation, Paragraph, SentenceKind

Places = tuple[str, ...]

_FORCES: Mapping[str, tuple[SentenceKind, Places]] = {
    "rod": (SentenceKind.FORCE_IN_ROD, ("link",)),
    "pivot": (SentenceKind.FORCE_OF_GROUND, ("link", "point")),
    "pin": (SentenceKind.FORCE_AT_PIN, ("link", "point")),
    "crank": (SentenceKind.FORCE_ALONG_ARM, ("link", "point", "arm")),
    "guide": (SentenceKind.FORCE_OF_GUIDE, ("point",)),
    "touch": (SentenceKind.FORCE_OF_TOUCH, ("point", "link")),
    "rim": (SentenceKind.FORCE_OF_RIM, ("first", "rest")),
    "rack": (SentenceKind.FORCE_OF_RACK, ("pivot", "point")),
    "thread": (SentenceKind.FORCE_OF_THREAD, ("link", "point")),
    "rope": (SentenceKind.FORCE_OF_ROPE, ("first",)),
    "couple": (SentenceKind.COUPLE_IN_SLOT, ("link", "rest")),
}
"""The sentence that says what a force is, and the places of its names in it."""


def derive_by_equilibrium(
    solution: Solution, loads: Iterable[Equilibrium], results: Sequence[Analysis]
) -> Derivation:
    """Return the derivation of what was asked for, by the equilibrium of free bodies.

    A force at a joint of which they have other components is found by virtual power.
    """
    pose = solution.plan.graph.pose
    writer = _Writer(pose)
    groups = tuple(_together(solution, {each.result: each for each in loads}))
    by_sums = tuple(writer.explanation(names, found) for names, found in groups)
    met = frozenset(name for names, _ in groups for name in names)
    explanations = (*by_sums, *of_forces(solution, met), *of_friction(solution, results))
    derivation = Derivation((), (), (), tuple(results), explanations)
    return replace(derivation, position=tuple(position_steps(pose, derivation)))


def _together(
    solution: Solution, loads: Mapping[str, Equilibrium]
) -> Iterator[tuple[tuple[str, ...], tuple[Equilibrium, ...]]]:
    """Yield results that are explained together, with the steps to each of their components."""
    ideal = [one for one in solution.solved if isinstance(one, Solved)]
    for force, group in groupby(ideal, lambda one: one.result.target and whole(one.result.target)):
        names = tuple(one.result.name for one in group)
        found = tuple(loads[name] for name in names if name in loads)
        if found and len(found) == (2 if isinstance(force, Reaction) else 1):
            yield names, found


class _Writer:
    """Explains one load after another; a force found for an earlier one is not found anew."""

    def __init__(self, pose: Pose) -> None:
        self._pose = pose
        self._met: set[str] = set()
        self._found: dict[str, Terms] = {}

    def explanation(self, names: tuple[str, ...], found: Sequence[Equilibrium]) -> Explanation:
        """Return how results follow: each force when it is met first, then the sums.

        Where a force has been found already, or has another name, it is said which one is meant.
        """
        paragraphs = [p for equilibrium in found for p in self._paragraphs(equilibrium)]
        if called := [_called(each) for each in found if each.is_at_joint]:
            last = paragraphs.pop() if paragraphs else Paragraph(SentenceKind.EQUILIBRIUM)
            new = [equation for equation in called if equation.left != equation.right]
            paragraphs.append(replace(last, equations=(*last.equations, *new)))
        sides = [side for p in paragraphs for equation in p.equations for side in equation]
        where = tuple(intermediates(self._pose, symbols(*sides)))
        return Explanation(names, tuple(paragraphs), where)

    def _paragraphs(self, equilibrium: Equilibrium) -> Iterator[Paragraph]:
        if not self._found:
            yield Paragraph(SentenceKind.EQUILIBRIUM)
        if equilibrium.parts > 1 and not self._found:
            yield Paragraph(SentenceKind.EQUAL_PARTS)
        for step in equilibrium.steps:
            new = {f.name: f.terms for f in step.found if self._found.get(f.name) != f.terms}
            if new:
                self._found |= new
                yield from self._forces(step, equilibrium.forces)
                yield from _sums(step, self._pose)

    def _forces(self, step: Step, forces: Iterable[JointForce]) -> Iterator[Paragraph]:
        """Yield the explanation of the forces that a step meets first."""
        mentioned = {name for balance in step.balances for name in balance.terms}
        for force in forces:
            if mentioned & {*force.names} and not self._met >= {*force.names}:
                self._met.update(force.names)
                yield _force(force)


def _called(equilibrium: Equilibrium) -> Equation:
    """Return the name of a result and that of the force on free bodies that it is."""
    return Equation(Symbol(equilibrium.result), Symbol(equilibrium.load))


def _force(force: JointForce) -> Paragraph:
    kind = "crank" if force.kind == "pin" and force.subject[-1] else force.kind
    sentence, places = _FORCES[kind]
    names = {place: (name,) for place, name in zip(places, force.subject, strict=False)}
    letters = zip(("force", "other"), map(Symbol, force.names), strict=False)
    return Paragraph(sentence, (), names, dict(letters))


def _sums(step: Step, pose: Pose) -> Iterator[Paragraph]:
    """Yield the sums of a step, the last with what follows."""
    *most, last = step.balances
    found = tuple(map(_solved, step.found))
    for balance in most:
        yield _sum(balance, (), pose)
    yield _sum(last, () if most else found, pose)
    if most:
        yield Paragraph(SentenceKind.SOLVED_TOGETHER, found)


def _sum(balance: Balance, found: tuple[Equation, ...], pose: Pose) -> Paragraph:
    equations = (Equation(_left(balance), ZERO), *found)
    body = "link" if balance.body in pose.frames else "point"
    names = {"link": (balance.body,), "point": (balance.body,)}
    if balance.centre:
        return Paragraph(SentenceKind.MOMENTS, equations, {**names, "point": (balance.centre,)})
    if balance.is_guide:
        return Paragraph(SentenceKind.ALONG, equations, names)
    if balance.across:
        rod = {"rod": (balance.across,)}
        sentence = SentenceKind.FORCES_ACROSS if body == "link" else SentenceKind.PIN_ACROSS
        return Paragraph(sentence, equations, {**names, **rod})
    assert balance.along is not None, "a sum of forces has a direction"
    sentence = SentenceKind.FORCES_ALONG if body == "link" else SentenceKind.PIN_ALONG
    direction = {"direction": direction_formula(balance.along)}
    return Paragraph(sentence, equations, names, direction)


def _left(balance: Balance) -> Formula:
    """Return a sum with most of its terms positive."""
    terms = _terms(balance.terms)
    if 2 * sum(map(has_minus, terms)) > len(terms):
        terms = list(map(negative, terms))
    return total(positive_first(terms))


def _solved(found: Found) -> Equation:
    return Equation(Symbol(found.name), total(positive_first(_terms(found.terms))))


def _terms(terms: Terms) -> list[Formula]:
    return [product([(part.formula(), 1), (Symbol(name), 1)]) for name, part in terms.items()]
