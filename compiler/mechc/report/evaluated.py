"""The values of a report's formulas at the default pose, with the numbers put in."""

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from fractions import Fraction

from ..base.named import NamedTuple
from ..formula.evaluate import evaluate
from ..formula.names import direction_of, split_name
from ..formula.numeric.rounding import Rounding
from ..formula.tree import Call, Formula, Symbol, is_call, number
from ..formula.walk import symbols, walk
from ..model.mechanism import (
    GRAVITY,
    LoadRatio,
    Mechanism,
    Parameter,
    WithFriction,
)
from ..model.parts import written
from ..model.parts.targets import HOLDING
from ..model.result import Definition
from ..model.values import (
    Chain,
    UsualUnits,
    complete,
    completed,
    defaults,
    dependent,
    is_constant,
    usual_units,
)
from ..study.analysis import Analysis
from ..units import ANGLE, FORCE, NUMBER, UNITS, Dimension, si_unit
from .definitions import FREE_FALL, given_loads, looked_up, usual_weights
from .digits import VALUE_DIGITS
from .dimensions import found_dimension, is_solved, names_in
from .note import NoteLine
from .put_in import GivenQuantity, has_units, in_numbers, values_of, without_rounding
from .sections import ReportOutline, Section, is_joint_force
from .sentences.remarks import asked
from .sentences.speller import own_names

_ALIKE = {"rel_tol": 1e-6, "abs_tol": 1e-12}
"""What a printed formula may be off its value by rounding, next to a zero or a pole, too."""

ITERATED_ZERO = 1e-40
"""What is smaller is what iteration leaves of a zero, in SI."""


class KnownQuantities(NamedTuple):
    """The quantities that formulas mention, and the units of those that none is given for."""

    quantities: Mapping[str, GivenQuantity]
    usual: UsualUnits


def following(mechanism: Mechanism, shown: Set[Formula]) -> Mapping[str, Formula]:
    """Return the values of parameters that follow from given ones, those that are shown left out.

    What moves with the drive has none, and an angle of a drawing is a value itself.
    """
    given = {n: v for n, v in defaults(mechanism).items() if n != mechanism.drive_name}
    values = complete(mechanism, given)
    constants = {p.name for p in mechanism.parameters if is_constant(p)}
    follow = (n for n in dependent(mechanism) if n not in constants)
    wanted = (n for n in follow if n in values and Symbol(n) not in shown)
    return {n: number(Fraction(f"{values[n]:.{VALUE_DIGITS}g}")) for n in wanted}


class Evaluated(NamedTuple):
    """A name, its formula in numbers, and its value; no ``numbers`` where nobody would put them in.

    The numbers of a ratio stand without their unit where all have the same. What has a ``formula``
    can have its numbers put in part by part, from what is ``known``.
    """

    left: Formula
    numbers: Formula | None
    value: GivenQuantity
    angle: bool
    formula: Formula | None = None
    known: KnownQuantities | None = None


def evaluated(whole: ReportOutline, mechanism: Mechanism) -> Iterator[Evaluated]:
    """Yield the definitions and results of a report that have a value, in its order."""
    given = _given(whole, mechanism)
    turned = [section for section in whole.results if not _is_as_printed(section, given)]
    usual = usual_units(mechanism)
    known = KnownQuantities(given, usual)
    yield from _of_looked_up(whole, mechanism, given)
    idle = _idle_directions(whole)
    definitions = (d for d in _definitions(whole, turned) if d.name not in idle)
    yield from _of_definitions(definitions, known)
    shown, early = _named(whole, mechanism), _own_met_early(whole)
    shown |= {parameter.name for parameter in looked_up(mechanism)}
    for section in whole.results:
        accounted = list(_accounted(section, shown))
        if section not in turned:
            yield from _of_definitions(accounted, known)
            parts = _parts_of_force(section, whole, given, mechanism)
            given |= {d.name: quantity for d, quantity in parts}
            yield from _of_definitions([definition for definition, _ in parts], known)
        numbers = KnownQuantities({}, usual) if section in turned else known
        for result in (r for r in section.results if r.name not in early):
            if line := section.lines.get(result.name):
                yield from _of_line(line)
            else:
                forces = _iterated(result, mechanism, given, usual)
                yield from (Evaluated(Symbol(n), None, q, False) for n, q in forces.items())
                given |= forces
                yield from _of_result(result, numbers)
                given |= _value(result, usual)


def _of_looked_up(
    whole: ReportOutline, mechanism: Mechanism, given: Mapping[str, GivenQuantity]
) -> Iterator[Evaluated]:
    """Yield what choices, tables and lists come to, where nothing else of the report defines it."""
    where = list(_definitions(whole))
    results = (r.formula for section in whole.results for r in section.results)
    used = symbols(*(d.formula for d in where), *results) - {d.name for d in where}
    for parameter in looked_up(mechanism):
        if parameter.name in used & given.keys():
            value = without_rounding(given[parameter.name])
            yield Evaluated(Symbol(parameter.name), None, value, value.unit == "deg")


def hides_units(whole: ReportOutline, mechanism: Mechanism) -> bool:
    """Return whether a number that stands for units of the SI is in a formula of the report."""
    given = _given(whole, mechanism)
    results = (r for section in whole.results for r in section.results)
    results = (r for r in results if r.target is not None)
    formulas = [(d.formula, False) for d in _definitions(whole)]
    formulas += [(r.formula, r.dimension in (NUMBER, ANGLE)) for r in results]
    known = ((f, b) for f, b in formulas if names_in(f) <= given.keys() and not is_solved(f))
    return any(has_units(f, {n: given[n] for n in names_in(f)}, bare) for f, bare in known)


def constants_shown(whole: ReportOutline, mechanism: Mechanism) -> frozenset[Formula]:
    """Return the user's own names of numbers, which stand with their unit where they are given."""
    lines = (line for section in whole.results for line in section.lines.values())
    names = (line.name for line in lines if line.is_number)
    return frozenset(map(Symbol, (*names, *(load.name for load in given_loads(mechanism)))))


def _of_line(line: NoteLine) -> Iterator[Evaluated]:
    """Yield the value of a user-defined formula, if that is news."""
    if line.value and math.isfinite(line.value.value) and not line.is_number:
        numbers = None if line.kind else line.numbers
        yield Evaluated(Symbol(line.name), numbers, line.value, line.value.unit == "deg")


def has_atan2(whole: ReportOutline) -> bool:
    """Return whether a direction of the report, be it of a force, is found from two components."""
    formulas = [d.formula for d in _definitions(whole)]
    formulas += [r.formula for section in whole.results for r in section.results]
    return any(is_call(part, "atan2") for formula in formulas for part in walk(formula))


def named_directions(
    whole: ReportOutline, mechanism: Mechanism, met: Collection[str] | None = None
) -> list[str]:
    """Return the names of directions of vectors that a report has, such as ``phi_AB``, in order.

    They are those of mechc; what the description calls so is what its text says. Of those of a
    drawing the report has all, or those that are ``met`` in its formulas.
    """
    found = [d.name for d in _definitions(whole)]
    drawn = [p.name for p in mechanism.parameters if is_constant(p)]
    found += (name for name in drawn if met is None or name in met)
    own = own_names(mechanism) - {*drawn}
    return [n for n in dict.fromkeys(found) if direction_of(n) and n not in own]


def _idle_directions(whole: ReportOutline) -> set[str]:
    """Return the directions that the position states as sums of others, and no value rests on."""
    formulas = [d.formula for d in _definitions(whole)]
    formulas += [r.formula for section in whole.results for r in section.results]
    stated = (d for section in whole.position for d in section.where)
    plain = {d.name for d in stated if not any(isinstance(f, Call) for f in walk(d.formula))}
    accounts = (e for s in whole.results for p in s.paragraphs for e in p.equations)
    used = symbols(*formulas, *(side for equation in accounts for side in equation))
    return {name for name in plain - used if split_name(name).head == "phi"}


def _definitions(whole: ReportOutline, without: Sequence[Section] = ()) -> Iterator[Definition]:
    for section in whole.position:
        yield from section.where
    yield from (Definition(ratio.name, ratio.formula) for ratio in whole.ratios)
    for result in whole.results:
        if result not in without:
            yield from result.where


def _is_as_printed(section: Section, given: Mapping[str, GivenQuantity]) -> bool:
    """Return whether results with friction are what their printed formulas come to.

    Where a force is zero without friction, friction gives it a sign that no formula has: the
    value is then that of the coupled equations, or of the sign that lets all forces balance. Where
    a slip is 0 for once, it is that next to it.
    """
    values = values_of(given)
    for result in section.results:
        if result.sides:
            return False
        if not isinstance(result.target, WithFriction) or result.default is None:
            continue
        known = completed(values, ((n, f) for n, f in result.where if n not in values))
        if symbols(result.formula) <= known.keys():
            found = evaluate(result.formula, known)
            if math.isfinite(found) and not math.isclose(found, result.default, **_ALIKE):
                return False
    return True


def _named(whole: ReportOutline, mechanism: Mechanism) -> set[str]:
    """Return the names that have a place of their own among the values, or are given."""
    results = {result.name for section in whole.results for result in section.results}
    given = {load.name for load in given_loads(mechanism)}
    given |= {p.name for p in mechanism.parameters if is_constant(p)}
    return (
        (results - _own_met_early(whole))
        | given
        | {definition.name for definition in _definitions(whole)}
    )


def _own_met_early(whole: ReportOutline) -> set[str]:
    """Return the user's own formulas by whose names an account of friction has called its parts."""
    own = {name for section in whole.results for name in section.lines}
    accounts = (s for s in whole.results if s.paragraphs)
    return {d.name for s in accounts for d in _accounted(s, set()) if d.name in own}


def _accounted(section: Section, shown: set[str]) -> Iterator[Definition]:
    """Yield what results rest on that the account of their friction has introduced; note it."""
    for result in section.results:
        used, needed = symbols(result.formula), list[Definition]()
        for definition in reversed(result.stated):
            if definition.name in used - shown:
                needed.append(definition)
                used |= symbols(definition.formula)
        shown |= {definition.name for definition in needed}
        yield from reversed(needed)


def _parts_of_force(
    section: Section, whole: ReportOutline, given: Mapping[str, GivenQuantity], mechanism: Mechanism
) -> list[tuple[Definition, GivenQuantity]]:
    """Return the forces of solved bodies that one at a joint is said to be made of.

    They are in the account of a force with friction, or in one before it: per unit of a load in
    that of a ratio.
    """
    if not any(is_joint_force(r) and r.default is not None for r in section.results):
        return []
    said = [e.right for p in section.paragraphs for e in p.equations]
    own = {result.name for result in section.results}
    made_of = symbols(*said, *(r.formula for r in section.results)) - given.keys() - own
    values, found = dict(values_of(given)), list[tuple[Definition, GivenQuantity]]()
    usual = usual_units(mechanism)
    equations = ((e, s) for s in whole.results for p in s.paragraphs for e in p.equations)
    for (left, right), at in equations:
        if isinstance(left, Symbol) and left.name in made_of and symbols(right) <= values.keys():
            made_of -= {left.name}
            size, kind = evaluate(right, values), _measure(left.name, mechanism)
            if math.isfinite(size) and kind is not None:
                unit = usual.of(kind.over(_measured_by(at.results[0], mechanism)))
                found.append((Definition(left.name, right), GivenQuantity(size, unit)))
                values[left.name] = size
    return found


def _measure(name: str, mechanism: Mechanism) -> Dimension | None:
    """Return the dimension of a force in an account of friction, or of a load with friction.

    Other names, None, are coefficients of the equation that a force solves.
    """
    of_load = {f"{load.name}{end}": load for load in mechanism.loads for end in ("_f", HOLDING)}
    if name in of_load:
        return of_load[name].dimension
    return FORCE if split_name(name).head in ("S", "n", "N", "R") else None


def _of_definitions(
    definitions: Iterable[Definition], known: KnownQuantities
) -> Iterator[Evaluated]:
    """Yield the values of definitions, of those that have one."""
    for name, formula in definitions:
        if name in known.quantities:
            value = without_rounding(known.quantities[name])
            numbers = in_numbers(formula, known.quantities, value.unit in ("", "deg"))
            yield Evaluated(Symbol(name), numbers, value, value.unit == "deg", formula, known)


def _value(result: Analysis, usual: UsualUnits) -> dict[str, GivenQuantity]:
    """Return the value of a result under its name, for results that rest on it."""
    known = result.default is not None and math.isfinite(result.default)
    value = GivenQuantity(result.default or 0.0, usual.of(result.dimension))
    return {result.name: value} if known else {}


def _iterated(
    result: Analysis, mechanism: Mechanism, given: Mapping[str, GivenQuantity], usual: UsualUnits
) -> dict[str, GivenQuantity]:
    """Return the forces at joints that a result with friction mentions, whatever they rest on.

    Those of a ratio of loads are for a unit of the load below the line.
    """
    named = result.iterated - given.keys()
    if not named or result.default is None:
        return {}
    values = completed(values_of(given), result.where)
    unit = usual.of(FORCE.over(_measured_by(result, mechanism)))
    known = (d.name for d in result.where if d.name in named and d.name in values)
    finite = ((name, values[name]) for name in known if math.isfinite(values[name]))
    return {name: GivenQuantity(size * (abs(size) > ITERATED_ZERO), unit) for name, size in finite}


def _measured_by(result: Analysis, mechanism: Mechanism) -> Dimension:
    """Return the dimension of what the forces in a result are measured by."""
    match result.target:
        case WithFriction(of=LoadRatio(below=below)):
            return next(load.dimension for load in mechanism.loads if load.name == below)
        case _:
            return NUMBER


def _of_result(result: Analysis, known: KnownQuantities) -> Iterator[Evaluated]:
    """Yield the value of a result, if it is finite and no number as it stands."""
    if result.default is None or not math.isfinite(result.default) or not symbols(result.formula):
        return
    bare = result.dimension in (ANGLE, NUMBER)
    numbers = in_numbers(result.formula, known.quantities, bare)
    value = GivenQuantity(result.default, known.usual.of(result.dimension))
    yield Evaluated(asked(result), numbers, value, value.unit == "deg", result.formula, known)


def _given(whole: ReportOutline, mechanism: Mechanism) -> dict[str, GivenQuantity]:
    """Return the quantities that formulas mention, each in the unit that it was given in."""
    where = list(_definitions(whole))
    shown = _named(whole, mechanism)
    where += [d for section in whole.results for d in _accounted(section, shown)]
    values = _values(where, mechanism)
    given = _given_units(where, whole, mechanism)
    units = _with_found_units(given, where, values, usual_units(mechanism))
    known = {name: value for name, value in values.items() if math.isfinite(value)}
    return {name: GivenQuantity(known[name], unit) for name, unit in units.items() if name in known}


def _usual_g(mechanism: Mechanism) -> dict[str, float]:
    """Return the usual g by its name where a weight is by that."""
    return {FREE_FALL.name: float(GRAVITY.value)} if usual_weights(mechanism) else {}


def _values(where: Sequence[Definition], mechanism: Mechanism) -> dict[str, float]:
    """Return the values of quantities, and of definitions with what follows from them."""
    # A constant of the drawing stands in ``where`` in its unit, among parameters in SI.
    chain = Chain({**dict(where), **dependent(mechanism)})
    known = defaults(mechanism) | _usual_g(mechanism)
    values = chain.complete(known | dict.fromkeys(_zeros(chain, known), 0.0))
    constants = (*mechanism.literals, *given_loads(mechanism))
    return values | {p.name: evaluate(p.value, {}) for p in constants if p.value}


def _given_units(
    where: Iterable[Definition], whole: ReportOutline, mechanism: Mechanism
) -> dict[str, str]:
    """Return the units of the quantities of a description, and of ratios of a derivation."""
    named = (*mechanism.parameters, *mechanism.literals, *given_loads(mechanism))
    usual = usual_units(mechanism)
    units = {p.name: _unit(p) for p in named}
    units |= dict.fromkeys(_usual_g(mechanism), "m/s^2") | _of_loads(where, mechanism)
    bare = (p for p in looked_up(mechanism) if not p.unit)
    units |= {p.name: _written_unit(p) or usual.of(p.dimension) for p in bare}
    return units | {r.name: usual.of(r.dimension) for r in whole.ratios}


def _with_found_units(
    given: Mapping[str, str],
    where: Iterable[Definition],
    values: Mapping[str, float],
    usual: UsualUnits,
) -> dict[str, str]:
    """Return units with those of definitions, each after those of what it rests on."""
    units = dict(given)
    angles = {name for name, unit in units.items() if unit == "deg"}
    for definition in where:
        if definition.name not in units:
            unit = found_unit(definition, usual, angles, values, units)
            units |= {} if unit is None else {definition.name: unit}
            angles |= {definition.name} if unit == "deg" else set()
    return units


def _written_unit(parameter: Parameter) -> str:
    """Return the first unit of its dimension that a quantity is written with, '' without one."""
    found = written.units(parameter.written.formula) if parameter.written else []
    return next((u for u in found if u in UNITS and UNITS[u].dimension == parameter.dimension), "")


def _zeros(chain: Chain, given: Mapping[str, float]) -> Iterator[str]:
    """Yield the names of which nothing but rounding is left."""
    rounding = Rounding(given)
    rounding.define(chain.definitions)
    return (n for n, _ in chain.definitions if n in rounding.values and rounding.values[n].is_zero)


def _of_loads(where: Iterable[Definition], mechanism: Mechanism) -> dict[str, str]:
    """Return the units of the loads that have a formula, such as weights."""
    units = {load.name: si_unit(load.dimension) for load in mechanism.loads}
    return {d.name: units[d.name] for d in where if d.name in units}


def _unit(parameter: Parameter) -> str:
    return "deg" if parameter.dimension == ANGLE else parameter.unit or si_unit(parameter.dimension)


def found_unit(
    definition: Definition,
    usual: UsualUnits,
    angles: Iterable[str],
    values: Mapping[str, float],
    units: Mapping[str, str],
) -> str | None:
    """Return the unit of what a loop or an account of friction gives; None if it is not known."""
    plain = {"": NUMBER} | {unit: UNITS[unit].dimension for unit in units.values() if unit in UNITS}
    dimensions = {name: plain[unit] for name, unit in units.items() if unit in plain}
    found = found_dimension(definition, angles, values, dimensions)
    return None if found is None else usual.of(found)
