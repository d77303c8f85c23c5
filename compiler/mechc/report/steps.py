"""The derivation: what a person would write on paper, as data.

Speeds are named ``V_A`` (of point A), angular velocities ``omega_OBA`` (of a link).
Every relation is a pair of formulas; the words for each rule, in each language,
belong to whoever prints.
"""

from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType

from ..base.frozen import frozen, replace
from ..base.named import NamedTuple
from ..formula.tree import Formula
from ..formula.walk import constants, symbols
from ..model.mechanism import Mechanism, Require
from ..model.result import Definition
from ..model.values import user_defined
from ..study.analysis import Analysis
from ..units import Dimension
from .kinds import PositionKind, SentenceKind, StepRule


@frozen
class PositionStep:
    """The position by one loop, or of one vector: directions and lengths, in order.

    ``points`` is what the loop goes through (see ``SolvedLoop``), or the ends of the vector;
    ``definitions`` are those of its names that the derivation needs; ``like`` are the points of
    the triangle that this one is congruent to. ``corners`` are the angles of a triangle among them,
    each with its corner, ``inclined`` the inclination to a guide with the vector inclined.
    Where a loop closes along a guide in two ways, ``pin`` is the point there and ``is_ahead`` says
    whether it has the place farther along the guide. ``part`` is the vector that is found alone.
    """

    kind: PositionKind
    points: tuple[str, ...]
    is_clockwise: bool | None
    definitions: tuple[Definition, ...]
    like: tuple[str, ...] = ()
    corners: tuple[tuple[str, tuple[str, str, str]], ...] = ()
    inclined: tuple[str, str] | None = None
    pin: str = ""
    is_ahead: bool | None = None
    part: str = ""


class Equation(NamedTuple):
    """``left = right``."""

    left: Formula
    right: Formula


Reason = tuple[StepRule, tuple[str, ...]]
"""A rule, and what it is applied to."""


@frozen
class DerivationStep:
    """One numbered step: the rule, the points and link it is applied to, what it gives."""

    rule: StepRule
    subject: tuple[str, ...]
    """Names of the drawing, in an order that the rule gives.

    LEVER, ARM: the pivot, then the points
    PROJECTION: the two ends of the rod
    CIRCULAR_SLOT: its radius, the pin, the link with the slot, the centre
    RADIUS, TURNING_RADIUS: the radius, its ends
    TRANSLATION and its kinds: the link, two points
    TURNING: both links
    SLOT, CONTACT: the pin, the body
    GEAR, BELT: the two pivots
    ON_ARM: the arm, the two centres
    RACK: the pivot, the rack
    PARTING: the two points
    TOGETHER: the links involved
    COMPONENT and its kinds: the pivot, or the link and its other point, then the point and the
    load (``V_A_P`` is the speed of A along P)
    HELD: the coordinates
    """

    relations: tuple[Equation, ...]
    """The relations that the rule states."""

    results: tuple[Equation, ...]
    """The same solved for the new speeds."""

    reasons: tuple[Reason, ...] = ()
    """Of TOGETHER the rules of its relations, of PROJECTION those of the velocities of its ends."""


@frozen
class PowerTerm:
    """The power of one load: ``times · load · speed``; ``speed`` is signed along the load."""

    load: str
    point: str
    times: Formula
    speed: Formula


@frozen
class Paragraph:
    """A sentence with the equations that it leads to.

    ``names`` are the points, links and loads that the sentence mentions, by the places that
    its words have for them; ``formulas`` what it has of mathematics.
    """

    sentence: SentenceKind
    equations: tuple[Equation, ...] = ()
    names: Mapping[str, tuple[str, ...]] = MappingProxyType({})
    formulas: Mapping[str, Formula] = MappingProxyType({})


@frozen
class Explanation:
    """How results were found that are explained together, such as the components of one force.

    ``where`` is what the equations rest on.
    """

    results: tuple[str, ...]
    paragraphs: tuple[Paragraph, ...]
    where: tuple[Definition, ...] = ()

    def times_the_load(self) -> Iterator[str]:
        """Yield the names of forces that are those per unit of a load, times the load."""
        for paragraph in self.paragraphs:
            if paragraph.sentence is SentenceKind.TIMES_THE_LOAD:
                yield from (name for e in paragraph.equations for name in symbols(e.left))


class SpeedChain(NamedTuple):
    """The ratio of two speeds as a product of ratios found one after another: ``V_K/V_A``."""

    ratio: Formula
    links: tuple[Formula, ...]
    product: Formula


class NamedRatio(NamedTuple):
    """The ratio of a speed to the drive's, under the name that results have it by."""

    name: str
    formula: Formula
    dimension: Dimension


@frozen
class LastStep:
    """The solution of the power equation: a ratio of loads in the speeds that were named.

    ``chain`` is the ratio of these speeds, None where one relation gave it.
    """

    chain: SpeedChain | None
    ratio: Equation


@frozen
class Derivation:
    """The velocity steps, the power equation (or several, at mobility m), the results.

    ``explanations`` are those of results that need more than the power equation, ``position`` how
    what all of these mention follows from the loops, ``last_steps`` what the power equation
    gives. ``ratios`` are those of speeds that the steps have given a name. ``requires`` are the
    conditions of use, in names of the position where they ask something of the pose.
    """

    steps: tuple[DerivationStep, ...]
    terms: tuple[PowerTerm, ...]
    balances: tuple[Equation, ...]
    results: tuple[Analysis, ...]
    explanations: tuple[Explanation, ...] = ()
    position: tuple[PositionStep, ...] = ()
    last_steps: tuple[LastStep, ...] = ()
    ratios: tuple[NamedRatio, ...] = ()
    requires: tuple[Require, ...] = ()


def names_met(derivation: Derivation, mechanism: Mechanism) -> frozenset[str]:
    """Return the names in the formulas of a derivation, those of numbers among them.

    So are those in formulas of the description that these rest on, and in its tables.
    """
    sides = (side for condition in _conditions(derivation) for side in condition)
    formulas = [*_formulas(derivation), *sides]
    formulas += [cell for table in mechanism.tables for row in table.rows for cell in row]
    found = _names(formulas)
    values = {p.name: p.value for p in mechanism.parameters if p.value}
    values |= user_defined(mechanism)
    values |= {load.name: load.tie for load in mechanism.loads if load.tie}
    while more := _names(values.pop(name) for name in found & values.keys()):
        found |= more
    return found


def _names(formulas: Iterable[Formula]) -> frozenset[str]:
    listed = tuple(formulas)
    return symbols(*listed) | {constant.name for constant in constants(listed)}


def _formulas(derivation: Derivation) -> Iterator[Formula]:
    """Yield the formulas of a derivation."""
    for step in derivation.steps:
        for equation in (*step.relations, *step.results):
            yield from equation
    yield from (side for equation in derivation.balances for side in equation)
    yield from (d.formula for step in derivation.position for d in step.definitions)
    for explanation in derivation.explanations:
        yield from (side for p in explanation.paragraphs for pair in p.equations for side in pair)
        yield from (d.formula for d in explanation.where)
    for result in derivation.results:
        yield result.formula
        yield from (d.formula for d in result.where)


def _conditions(derivation: Derivation) -> Iterator[tuple[Formula, Formula]]:
    holds = (h for result in derivation.results for h in result.holds)
    yield from ((each.left, each.right) for each in (*derivation.requires, *holds))


def unexplained(derivation: Derivation) -> Derivation:
    """Leave out how the results came about, so that they define what they rest on themselves.

    What is shown together still is.
    """
    together = tuple(Explanation(e.results, ()) for e in derivation.explanations)
    return replace(derivation, explanations=together, position=(), ratios=())


def calculated(results: tuple[Analysis, ...]) -> Derivation:
    """Return the derivation of a calculation sheet: its results, whose formulas are given."""
    return Derivation((), (), (), results)
