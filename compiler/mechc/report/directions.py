"""Directions of links that formulas have as sums of angles, under names of their own.

A loop gives φ_AB and the angle μ_B between its sides, and a ternary link has δ_BQC as well: who
writes by hand has φ_QC = φ_AB + μ_B + δ_BQC, where formulas mention that often enough.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar, get_args

from ..algebra.angle import RADIAN, Angle
from ..base.frozen import fields, replace
from ..base.named import NamedTuple
from ..formula.differences import MOST_READ_OPERATIONS
from ..formula.layout import has_minus, in_degrees
from ..formula.names import VECTOR_POINTS, direction_of
from ..formula.operations import count_operations
from ..formula.rewriting import plus_first, rewritten
from ..formula.tree import (
    Call,
    Formula,
    Number,
    Product,
    Sum,
    Symbol,
    degrees,
    negative,
    number,
    product,
    total,
)
from ..formula.walk import reached, symbols, walk
from ..model.result import Definition
from ..pose.pose import Pose
from ..study.analysis import Analysis

if TYPE_CHECKING:
    from .steps import Derivation, PositionStep

T = TypeVar("T")

OFTEN: Mapping[int, int] = {2: 3}
"""How often a sum of so many angles has to stand in results to be worth a name."""

AT_LEAST = 2
"""How often one of more angles has to."""

HALF_TURN = 180


class NamedDirection(NamedTuple):
    """The direction of a vector by its name: the sum of angles, and 0° or 180° more."""

    name: str
    angles: tuple[Formula, ...]
    degrees: int = 0

    @property
    def formula(self) -> Formula:
        """Return the sum that the name stands for."""
        turn = (degrees(self.degrees),) if self.degrees else ()
        return plus_first(total([*self.angles, *turn]))


def directions(results: Sequence[Analysis], pose: Pose) -> tuple[NamedDirection, ...]:
    """Return the directions that results have often, those of more angles first."""
    found = sorted(_candidates(pose), key=lambda each: -len(each.angles))
    taken = {*_names(pose), *(d.name for r in results for d in r.where)}
    formulas = [
        f for f in dict.fromkeys(_formulas(results)) if count_operations(f) <= MOST_READ_OPERATIONS
    ]
    chosen: list[NamedDirection] = []
    for each in found:
        shown = [f for f in formulas if symbols(f) >= symbols(*each.angles)]
        times = sum(_without(node, each) is not None for f in shown for node in walk(f))
        if times >= OFTEN.get(len(each.angles), AT_LEAST) and each.name not in taken:
            chosen.append(each)
            taken.add(each.name)
            formulas = [_in_formula(f, [each]) for f in formulas]
    return tuple(chosen)


def _formulas(results: Iterable[Analysis]) -> Iterator[Formula]:
    """Yield the formulas that are read of results, and of what they rest on."""
    for result in results:
        yield result.formula
        yield from (d.formula for d in result.where if d.name not in result.inside)


def _names(pose: Pose) -> Iterator[str]:
    """Yield the names that quantities have."""
    mechanism = pose.mechanism
    named = (mechanism.parameters, mechanism.literals, mechanism.loads, mechanism.finds)
    yield from (item.name for items in (*named, mechanism.lets) for item in items)
    yield from (definition.name for definition in (*pose.definitions, *pose.closing))


def _candidates(pose: Pose) -> Iterator[NamedDirection]:
    """Yield the directions of vectors from first points of links that are sums loops give."""
    of_loops = {definition.name for definition in pose.definitions}
    met: set[tuple[Formula, ...]] = set()
    for link in pose.mechanism.links:
        for point, vector in pose.frames[link.name].items():
            if len(vector) == 1 and len(angles := _added(vector[0].angle)) >= VECTOR_POINTS:
                rest = vector[0].angle.degrees % (2 * HALF_TURN)
                is_found = not of_loops.isdisjoint(symbols(*angles))
                if not is_found or angles in met or rest not in (0, HALF_TURN):
                    continue
                met.add(angles)
                yield NamedDirection(f"phi_{link.points[0]}{point}", angles, int(rest))


def _added(angle: Angle) -> tuple[Formula, ...]:
    """Return the angles of which a direction is the sum, ``()`` where it is another formula.

    That of another vector is first, an angle that the description gives last.
    """
    if any(name == RADIAN or times not in (1, -1) for name, times in angle.terms):
        return ()
    order = sorted(angle.terms, key=lambda term: (not direction_of(term[0]), _is_given(term[0])))
    return tuple(Symbol(n) if times > 0 else negative(Symbol(n)) for n, times in order)


def _is_given(name: str) -> bool:
    """Return whether an angle is that of a rigid link, by its name: ``delta_BQC``."""
    return name.startswith("delta_")


def _without(node: Formula, direction: NamedDirection) -> tuple[list[Formula], int] | None:
    """Return a sum without the angles of a direction, and how often it stands in their place.

    That is so often that least is left: of μ − 2φ_DB with φ_OB = φ_DB − μ it is -1, and -φ_DB
    is left. Each angle of the direction is in the sum, with the same sign.
    """
    if not isinstance(node, Sum):
        return None
    met = {}
    for angle in direction.angles:
        size = _size(angle)
        found = [n for term in node.terms if (n := _times(term, size))]
        if len(found) != 1:
            return None
        met[size] = found[0] * (1 if size == angle else -1)
    if len({count > 0 for count in met.values()}) > 1:
        return None
    often = min(met.values(), key=lambda n: sum(abs(count - n) for count in met.values()) + abs(n))
    others = [term for term in node.terms if not any(_times(term, size) for size in met)]
    for angle in direction.angles:
        left = met[_size(angle)] - often
        others += [product([(number(left), 1), (angle, 1)])] if left else []
    return others, often


def _times(term: Formula, angle: Formula) -> int:
    """Return how often an angle is in a term that is a multiple of it, 0 in another one."""
    match term:
        case Symbol():
            return int(term == angle)
        case Product((Number(value), each)) if each == angle and value.denominator == 1:
            return int(value)
    return 0


# ---------------------------------------------------------------------------------- in formulas


def named(value: T, chosen: Sequence[NamedDirection]) -> T:
    """Return a value of a report with the names of directions in all its formulas."""
    if not chosen:
        return value
    known: dict[Formula, Formula] = {}

    def of(formula: Formula) -> Formula:
        if formula not in known:
            known[formula] = _in_formula(formula, chosen)
        return known[formula]

    return _mapped(value, of)  # type: ignore[no-any-return]


def _in_formula(formula: Formula, chosen: Sequence[NamedDirection]) -> Formula:
    if count_operations(formula) > MOST_READ_OPERATIONS:
        return formula
    for each in chosen:
        if symbols(formula) >= symbols(*each.angles):
            formula = plus_first(rewritten(formula, partial(_by_name, direction=each)))
    return formula


def _by_name(formula: Formula, direction: NamedDirection) -> Formula | None:
    """Return a sum with the name of a direction; a function of one that has half a turn, or of
    its opposite, without these.
    """
    match formula:
        case Sum() if found := _without(formula, direction):
            others, often = found
            name = product([(number(often), 1), (Symbol(direction.name), 1)])
            return _turned([*others, name], -often * direction.degrees)
        case Call("sin" | "cos" as function, (Sum(terms),)) if direction.degrees:
            turns = [term for term in terms if (in_degrees(term) or 1) % HALF_TURN == 0]
            if turns and direction.name in symbols(*terms):
                rest = _function_of(function, total(term for term in terms if term not in turns))
                halves = sum((in_degrees(term) or 0) // HALF_TURN for term in turns)
                return negative(rest) if halves % 2 else rest
        case Call("sin" | "cos" | "tan" | "cot" as function, (angle,)):
            if _is_turned(angle) and direction.name in symbols(angle):
                return _function_of(function, angle)
    return None


def _is_turned(angle: Formula) -> bool:
    """Return whether an angle is the opposite of one without a minus."""
    return all(map(has_minus, angle.terms)) if isinstance(angle, Sum) else has_minus(angle)


def _function_of(function: str, angle: Formula) -> Formula:
    """Return a sine or cosine of an angle, or of what it is the opposite of, as ``−sin φ``."""
    if not _is_turned(angle):
        return Call(function, (angle,))
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    size = Call(function, (total(map(negative, terms)),))
    return size if function == "cos" else negative(size)


def _size(term: Formula) -> Formula:
    return negative(term) if has_minus(term) else term


def _turned(terms: Iterable[Formula], turn: int) -> Formula:
    """Return a sum of angles with so many degrees added to its constant, minuses last."""
    listed = list(terms)
    constant = turn + sum(size for term in listed if (size := in_degrees(term)) is not None)
    angles = sorted((term for term in listed if in_degrees(term) is None), key=has_minus)
    return total([*angles, degrees(constant)] if constant else angles)


def _mapped(value: Any, of: Callable[[Formula], Formula]) -> Any:
    """Return a value with each formula in its fields, parts and entries as a function has it."""
    if isinstance(value, get_args(Formula)):
        return of(value)
    if isinstance(value, tuple):
        parts = [_mapped(part, of) for part in value]
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    if isinstance(value, Mapping):
        return {key: _mapped(part, of) for key, part in value.items()}
    held = {f.name: getattr(value, f.name) for f in fields(value) if not f.on_demand}
    changed = {name: new for name, old in held.items() if (new := _mapped(old, of)) != old}
    return replace(value, **changed) if changed else value


# -------------------------------------------------------------------------------- what they are


def in_results(
    results: Sequence[Analysis], chosen: Sequence[NamedDirection]
) -> tuple[Analysis, ...]:
    """Return results by the names of directions, each with what these stand for."""
    return tuple(
        replace(r, where=_with_directions(r.where, r, chosen))
        for r in named(tuple(results), chosen)
    )


def in_derivation(derivation: "Derivation", pose: Pose) -> "Derivation":
    """Return a derivation in which the directions that results have often have names."""
    chosen = directions(derivation.results, pose)
    if not chosen:
        return derivation
    found = named(derivation, chosen)
    position = tuple(_defining(found.position, chosen))
    return replace(found, results=in_results(derivation.results, chosen), position=position)


def _definition(direction: NamedDirection, chosen: Sequence[NamedDirection]) -> Definition:
    """Return the definition of a direction, by that of another one that is a part of it."""
    parts = [each for each in chosen if len(each.angles) < len(direction.angles)]
    return Definition(direction.name, _in_formula(direction.formula, parts))


def _with_directions(
    where: Sequence[Definition], result: Analysis, chosen: Sequence[NamedDirection]
) -> tuple[Definition, ...]:
    """Return definitions with those of directions, each after what it is the sum of."""
    own = {d.name: d for d in (_definition(each, chosen) for each in chosen)}
    mentioned = _mentioned(result)
    formulas = {name: d.formula for name, d in own.items()}
    wanted = reached(mentioned & own.keys(), formulas) & own.keys()
    return tuple(_in_order(where, [d for name, d in own.items() if name in wanted]))


def _mentioned(result: Analysis) -> frozenset[str]:
    """Return the names in the formulas of a result and of what is said of it."""
    met: list[Formula] = []

    def noted(formula: Formula) -> Formula:
        met.append(formula)
        return formula

    _mapped(result, noted)
    return symbols(*met)


def _in_order(where: Sequence[Definition], added: Sequence[Definition]) -> Iterator[Definition]:
    """Yield definitions, added ones as soon as all is there that they rest on."""
    left = sorted(added, key=lambda d: len(symbols(d.formula)))
    open_names = {d.name for d in (*where, *added)}
    for definition in where:
        yield definition
        open_names.discard(definition.name)
        while ready := [d for d in left if open_names.isdisjoint(symbols(d.formula))]:
            for each in ready:
                yield each
                left.remove(each)
                open_names.discard(each.name)


def _defining(
    position: Sequence["PositionStep"], chosen: Sequence[NamedDirection]
) -> Iterator["PositionStep"]:
    """Yield the steps of the position, with directions where all is found that they rest on."""
    every = [d for step in position for d in step.definitions]
    added = [_definition(each, chosen) for each in chosen]
    order = [d.name for d in _in_order(every, added)]
    by_name = {d.name: d for d in added}
    for step in position:
        definitions: list[Definition] = []
        for definition in step.definitions:
            definitions.append(definition)
            place = order.index(definition.name) + 1
            while place < len(order) and order[place] in by_name:
                definitions.append(by_name[order[place]])
                place += 1
        yield replace(step, definitions=tuple(definitions))
