"""The results in the order of a report: those of one joint together, each name defined once.

:func:`chosen` keeps those that a description wants in its report, and what they rest on.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import zip_longest
from types import MappingProxyType
from typing import TYPE_CHECKING

from ..algebra.from_formula import to_product
from ..algebra.product import Product as AlgebraicProduct
from ..base.frozen import frozen, replace
from ..base.named import NamedTuple
from ..formula.operations import count_operations
from ..formula.rewriting import plus_first
from ..formula.tree import ZERO, Call, Formula, Implicit, Product, Sum, Symbol, System
from ..formula.walk import constants, symbols
from ..model.mechanism import Mechanism, Parameter
from ..model.parts.targets import (
    Efficiency,
    LoadForm,
    LoadRatio,
    SpeedRatio,
    WithFriction,
    whole,
)
from ..model.result import Definition
from ..study.analysis import Analysis, Multiple
from . import proportional_results, steps
from .definitions import NameLetters, as_written, given_loads, letters
from .derivation import friction
from .note import NoteLine, own_lines
from .sentences.remarks import own_conditions, reaction

if TYPE_CHECKING:
    from .steps import Derivation, Explanation, NamedRatio, Paragraph, PositionStep

MOST_SIZE_OPERATIONS = 24
"""The size of a force that takes more operations is given by the components."""


@frozen
class Section:
    """Results that are shown under one heading, how they came about, and what they rest on.

    ``units`` are those of loads and lets that are numbers, ``literals`` the lengths that are,
    ``lines`` the formulas of the user's own among the results, as they are written.
    """

    paragraphs: "tuple[Paragraph, ...]"
    results: tuple[Analysis, ...]
    where: tuple[Definition, ...]
    has_usual_g: bool = False
    units: Mapping[str, str] = MappingProxyType({})
    literals: tuple[Parameter, ...] = ()
    lines: Mapping[str, NoteLine] = MappingProxyType({})


@frozen
class PositionSection:
    """The position by one loop, as it is written, and the lengths given by numbers met in it."""

    step: "PositionStep"
    where: tuple[Definition, ...]
    literals: tuple[Parameter, ...]


class ReportOutline(NamedTuple):
    """A report in order: the position, ratios of speeds, the results under their headings."""

    position: tuple[PositionSection, ...]
    ratios: "tuple[NamedRatio, ...]"
    results: tuple[Section, ...]


def outline(
    derivation: "Derivation", mechanism: Mechanism, given: Iterable[Parameter] = ()
) -> ReportOutline:
    """Return the outline of a report, each name defined once and where it is first needed.

    What is ``given`` above, such as the angles of a drawing, is not defined again.
    """
    of_position = [d for step in derivation.position for d in step.definitions]
    shown, known = ShownNames(), letters(mechanism, derivation.results, of_position)
    shown.stated(given)
    position = tuple(_position(derivation, mechanism, shown, known))
    shown.definitions(Definition(r.name, r.formula) for r in derivation.ratios)
    results = tuple(_results(derivation, mechanism, shown, known))
    return ReportOutline(position, derivation.ratios, results)


def _position(
    derivation: "Derivation", mechanism: Mechanism, shown: "ShownNames", known: NameLetters
) -> Iterator[PositionSection]:
    for step in derivation.position:
        shown.definitions(step.definitions)
        where = tuple(as_written(step.definitions, known))
        numbers = shown.new_literals((d.formula for d in where), mechanism)
        yield PositionSection(step, where, tuple(numbers))


def _results(
    derivation: "Derivation", mechanism: Mechanism, earlier: "ShownNames", known: NameLetters
) -> Iterator[Section]:
    """Yield the sections of results, each with what was not stated in an earlier one."""
    lines = own_lines(mechanism, derivation.results)
    stated = {*lines}
    for explanation, results in _by_explanation(derivation, _found(derivation, mechanism)):
        earlier.equations(explanation)
        rested = earlier.new_definitions(
            [Symbol(d.name) for d in explanation.where], explanation.where
        )
        named = _by_their_parts(results, explanation)
        results = [in_short(r, derivation.results) for r in named]
        stated.update(explanation.times_the_load())
        needed = (d for r in results for d in earlier.of(r, stated))
        fresh = [*rested, *needed]
        conditioned = earlier.conditioned(_conditioned_once(results))
        once = earlier.said_once(conditioned, known.positive)
        shown = tuple(_by_exact(r, derivation) for r in once if not earlier.has_said(r, lines))
        if not shown:
            continue
        weighs = any(d.name in known.usual for d in fresh)
        where = tuple(as_written(fresh, known))
        said = (side for p in explanation.paragraphs for pair in p.equations for side in pair)
        found = (r.formula for r in shown if r.name not in lines)
        formulas = [*said, *found, *(d.formula for d in where)]
        numbers = tuple(earlier.new_literals(formulas, mechanism))
        own = {r.name: lines[r.name] for r in shown if r.name in lines}
        paragraphs = tuple(_before_results(explanation.paragraphs, shown))
        yield Section(paragraphs, shown, where, weighs, known.units, numbers, own)


def _by_their_parts(results: Iterable[Analysis], explanation: "Explanation") -> Sequence[Analysis]:
    """Return the components of a force with friction by the forces that they are said to be.

    They are so where that of one is much shorter: ``R_O_x_f = S_AB_f*cos(beta) - P_f``. What these
    forces are stands before it.
    """
    said = {e.left: e.right for p in explanation.paragraphs for e in p.equations}
    pairs = [(result, said.get(Symbol(result.name), result.formula)) for result in results]
    if not any(is_joint_force(r) and _is_much_shorter(f, r.formula) for r, f in pairs):
        return [result for result, _ in pairs]
    return [replace(r, formula=f) if is_joint_force(r) else r for r, f in pairs]


def is_joint_force(result: Analysis) -> bool:
    """Return whether a result is a force at a joint, or in a rod, with friction."""
    target = result.target
    return isinstance(target, WithFriction) and not isinstance(target.of, LoadRatio | LoadForm)


def _is_much_shorter(one: Formula, other: Formula) -> bool:
    operations = count_operations(other)
    return operations > max(MOST_SIZE_OPERATIONS, 2 * count_operations(one))


def _before_results(
    paragraphs: "Sequence[Paragraph]", results: Iterable[Analysis]
) -> "Iterator[Paragraph]":
    """Yield paragraphs, the last one without its equations if results repeat all of them."""
    yield from paragraphs[:-1]
    for last in paragraphs[-1:]:
        repeated: dict[Formula, AlgebraicProduct] = {
            Symbol(r.name): to_product(r.formula) for r in results
        }
        is_new = any(repeated.get(e.left) != to_product(e.right) for e in last.equations)
        yield last if is_new else replace(last, equations=())


class ShownNames:
    """The names that a report has defined, so that nothing is defined twice."""

    def __init__(self) -> None:
        self._results: set[str] = set()
        self._known: dict[str, Formula] = {}
        self._ratios: dict[Formula, str] = {}
        self._of_loads: dict[frozenset[str], Analysis] = {}
        self._conditions: dict[tuple[tuple[Formula, str, Formula], ...], str] = {}
        self._accounted: set[str] = set()
        self._stated: set[str] = set()

    def of(self, result: Analysis, lines: Collection[str] = ()) -> list[Definition]:
        """Return the new ones of a result's definitions, and note them.

        What stands in ``lines`` of its own is none of them, nor what it alone rests on.
        """
        where = [d for d in result.stated if d.name not in lines]
        fresh = self.new_definitions([result.formula], where)
        self._results.add(result.name)
        return fresh

    def new_definitions(
        self, formulas: Iterable[Formula], where: Sequence[Definition]
    ) -> list[Definition]:
        """Return the definitions that formulas rest on and that are new, and note them."""
        needed = self._needed(formulas, where)
        new = [d for d in needed if not self._is_known(d)]
        systems = {d.formula.system for d in new if isinstance(d.formula, Implicit)}
        fresh = [d for d in needed if d in new or _system(d) in systems]
        self._known |= dict(fresh)
        return fresh

    def _is_known(self, definition: Definition) -> bool:
        """Return whether a name stands for a formula already, which may lead by another term."""
        known, formula = self._known.get(definition.name), definition.formula
        return known == formula or (
            known is not None and not isinstance(formula, Implicit) and known == plus_first(formula)
        )

    def said_once(
        self, results: Iterable[Analysis], positive: Collection[str]
    ) -> Iterator[Analysis]:
        """Yield results, a ratio that an earlier one is equal to, or its inverse, with its name.

        So is one that is an earlier one times a factor of lengths that are ``positive``.
        """
        for result in results:
            is_ratio = isinstance(result.target, LoadRatio | SpeedRatio) and symbols(result.formula)
            known = self._ratios.setdefault(result.formula, result.name) if is_ratio else ""
            if known not in ("", result.name):
                yield replace(result, same_as=known, derivatives=None)
            elif inverse := self._inverse_of(result):
                yield replace(result, inverse_of=inverse, derivatives=None)
            elif is_ratio and (found := self._multiple_of(result, positive)):
                yield replace(result, multiple_of=found)
            else:
                yield result

    def _multiple_of(self, result: Analysis, positive: Collection[str]) -> Multiple | None:
        """Return the earlier ratio that a result is a multiple of; None if there is none.

        None as well where what is said of the result is of a parameter that the factor has, and
        where nothing is said of it.
        """
        followed = {n for n in result.trends or {} if n not in (result.proportional or {})}
        followed |= {extent.parameter for extent in result.extents}
        if not followed and not result.zeros and not result.poles:
            return None
        others = {name: f for f, name in self._ratios.items() if name != result.name}
        found = proportional_results.multiple(result.formula, others, positive) if others else None
        return found if found and followed.isdisjoint(symbols(found.factor)) else None

    def _inverse_of(self, result: Analysis) -> str:
        """Return the name of the earlier ratio of the same two loads, upside down; '' if none."""
        if not isinstance(result.target, LoadRatio) or not symbols(result.formula):
            return ""
        loads = result.target.above, result.target.below
        known = self._of_loads.setdefault(frozenset(loads), result)
        is_inverse = isinstance(known.target, LoadRatio) and known.target.above == loads[1]
        return known.name if is_inverse else ""

    def conditioned(self, results: Iterable[Analysis]) -> Iterator[Analysis]:
        """Yield results, one with several conditions that an earlier one had with its name."""
        for result in results:
            holds = tuple((r.left, r.operator, r.right) for r in own_conditions(result))
            known = self._conditions.setdefault(holds, result.name)
            is_known = known != result.name and len(holds) > 1
            yield replace(result, holds_as=known) if is_known else result

    def stated(self, given: Iterable[Parameter]) -> None:
        """Note quantities that stand whole in what is given, whatever form results have them in."""
        for parameter in given:
            if parameter.value is not None:
                self._known[parameter.name] = parameter.value
                self._stated.add(parameter.name)

    def definitions(self, where: Iterable[Definition]) -> None:
        """Note names with what they stand for."""
        self._known |= {d.name: d.formula for d in where}

    def equations(self, explanation: "Explanation") -> None:
        """Note the names that the equations of an account define."""
        for paragraph in explanation.paragraphs:
            for left, right in paragraph.equations:
                if isinstance(left, Symbol):
                    self._known[left.name] = right
                    self._accounted.add(left.name)

    def has_said(self, result: Analysis, lines: Mapping[str, NoteLine]) -> bool:
        """Return whether an account of friction has found a formula of the user's own.

        One that has a text is said again, with it.
        """
        line = lines.get(result.name)
        return line is not None and not line.label and result.name in self._accounted

    def new_literals(
        self, formulas: Iterable[Formula], mechanism: Mechanism
    ) -> Iterator[Parameter]:
        """Yield the lengths given by numbers that are met here first, and note them."""
        met = {constant.name for constant in constants(formulas)}
        for literal in mechanism.literals:
            if literal.name in met and literal.name not in self._known:
                self._known[literal.name] = literal.value or ZERO
                yield literal

    def _needed(self, formulas: Iterable[Formula], where: Sequence[Definition]) -> list[Definition]:
        """Return the definitions that formulas rest on, not looking behind shown results."""
        used = {name for formula in formulas for name in symbols(formula)}
        needed = []
        for definition in reversed(where):
            if definition.name in used - self._results - self._stated:
                needed.append(definition)
                used |= symbols(definition.formula)
        return needed[::-1]


def _system(definition: Definition) -> System | None:
    formula = definition.formula
    return formula.system if isinstance(formula, Implicit) else None


def _found(derivation: "Derivation", mechanism: Mechanism) -> list[Analysis]:
    """Return the results but for loads that are given, if there are others."""
    given = {load.name for load in given_loads(mechanism)}
    found = [r for r in derivation.results if not is_idle_direction(r)]
    return [r for r in found if r.name not in given] or found


def _by_explanation(
    derivation: "Derivation", results: Sequence[Analysis]
) -> "Iterator[tuple[Explanation, Sequence[Analysis]]]":
    """Yield each explanation with the results that it is of; one without any is by itself."""
    owners = {
        name: explanation for explanation in derivation.explanations for name in explanation.results
    }
    left = list(results)
    while left:
        explanation = owners.get(left[0].name) or steps.Explanation((left[0].name,), ())
        yield explanation, [r for r in left if r.name in explanation.results]
        left = [r for r in left if r.name not in explanation.results]


def _conditioned_once(results: Sequence[Analysis]) -> Iterator[Analysis]:
    """Yield results shown together, the conditions of the last for those that have the same."""
    for result, after in zip_longest(results, results[1:]):
        alike = after is not None and after.holds == result.holds
        yield replace(result, holds=()) if alike else result


def _by_exact(result: Analysis, derivation: "Derivation") -> Analysis:
    """Return a result of first order by the exact one, if that is equal to it."""
    name = friction.exact_name(result, derivation.results)
    return replace(result, formula=Symbol(name)) if name else result


def in_short(result: Analysis, results: Iterable[Analysis]) -> Analysis:
    """Return a direction, or a long size, by the components of the force among the results.

    Where these are not there, as in a notebook that shows one result, it is as it is.
    """
    parts = _components(result, results)
    sides = tuple(Symbol(part.name) for part in parts)
    only = [Symbol(part.name) for part in parts if part.formula != ZERO]
    match _part(result), result.formula:
        case "direction", formula if sides and symbols(formula):
            return replace(result, formula=Call("atan2", sides[::-1]))
        case "size", Call("abs", (Sum() | Product(),)) if len(only) == 1:
            return replace(result, formula=Call("abs", (*only,)))
        case "size", formula if sides and count_operations(formula) > MOST_SIZE_OPERATIONS:
            return replace(result, formula=Call("hypot", sides))
        case _:
            return result


def is_idle_direction(result: Analysis) -> bool:
    """Return whether a result is the direction of a force that is zero in every pose.

    There is nothing to be said of it.
    """
    return result.formula == Call("atan2", (ZERO, ZERO))


def _part(result: Analysis) -> str:
    force = reaction(result)
    return force.part if force else ""


def _components(result: Analysis, results: Iterable[Analysis]) -> tuple[Analysis, ...]:
    """Return the components of a force at a joint among results; none where one is missing."""
    force = whole(result.target) if result.target else None
    beside = {_part(r): r for r in results if r.target and whole(r.target) == force}
    return (beside["x"], beside["y"]) if {"x", "y"} <= beside.keys() else ()


def chosen(derivation: "Derivation", mechanism: Mechanism) -> "Derivation":
    """Return a derivation with the results that the report holds; all where it names none.

    What friction makes of a result belongs to it.
    """
    named = {part.name for part in mechanism.reported if not part.over}
    results = derivation.results
    wanted = {r.name for r in results if r.name in named}
    if not wanted:
        return derivation
    wanted |= {r.name for r in results if _is_of(r, [o for o in results if o.name in wanted])}
    for result in reversed(results):
        if result.name in wanted:
            wanted |= {n for d in result.where for n in symbols(d.formula)}
            wanted |= symbols(result.formula)
    return replace(derivation, results=tuple(r for r in results if r.name in wanted))


def _is_of(result: Analysis, others: Sequence[Analysis]) -> bool:
    """Return whether a result is another one with friction, or the efficiency of it."""
    match result.target:
        case WithFriction(of=of) | Efficiency(of=of):
            return any(other.target == of for other in others)
        case _:
            return False
