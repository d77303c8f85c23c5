"""A description in numbers: the values given, what follows from them, what conditions allow.

What follows is computed in an order in which each name comes after those that it needs.
Values are SI and radians.
"""

import math
import operator
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from graphlib import CycleError, TopologicalSorter

from ..base.named import NamedTuple
from ..formula.choices import EQUAL, SENSELESS
from ..formula.evaluate import SharedEvaluation, evaluate, solver
from ..formula.numeric.rounding import PrintedNumber
from ..formula.numeric.straight_line import OFTEN, StraightLine, SystemSolver, in_order
from ..formula.tree import Formula, Number, Symbol, System
from ..formula.walk import Mentions, symbols
from ..units import ANGLE, FORCE, LENGTH, TORQUE, UNITS, Dimension, of_length, si_unit
from .mechanism import Let, Mechanism, Parameter, Require
from .result import Result

Values = Mapping[str, float]

_COMPARE: Mapping[str, Callable[[float, float], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "=": lambda left, right: abs(left - right) <= EQUAL * (abs(left) + abs(right)) + SENSELESS,
    "!=": operator.ne,
}


class Chain:
    """Named formulas that may rest on one another, wherever each was written.

    >>> from mechc.formula.tree import Symbol, number, product
    >>> twice = Chain({"c": Symbol("b"), "b": product([(number(2), 1), (Symbol("a"), 1)])})
    >>> twice.complete({"a": 3.0}), twice.complete({"b": 1.0}), twice.complete({})
    ({'a': 3.0, 'b': 6.0, 'c': 6.0}, {'b': 1.0, 'c': 1.0}, {})
    """

    def __init__(
        self, formulas: Mapping[str, Formula], solved: Callable[[System], SystemSolver] = solver
    ) -> None:
        """Take the formulas, and how systems in them are ``solved`` from the second time on."""
        mentions = Mentions()
        self._solved = solved
        needs = {name: mentions.of(formula) for name, formula in formulas.items()}
        order, _ = ordered({name: set(n & formulas.keys()) for name, n in needs.items()})
        self._steps = [(name, formulas[name], needs[name]) for name in order]
        self._codes: dict[frozenset[str], Completion | None] = {}

    @property
    def definitions(self) -> list[tuple[str, Formula]]:
        """Return the formulas, each after those it needs."""
        return [(name, formula) for name, formula, _ in self._steps]

    @property
    def names(self) -> frozenset[str]:
        """Return the names that the formulas define."""
        return frozenset(name for name, _, _ in self._steps)

    def needed_by(self, names: Iterable[str]) -> set[str]:
        """Return all that the formulas of some names use, through one another."""
        used = set(names)
        for name, _, needs in reversed(self._steps):
            used |= needs if name in used else frozenset()
        return used

    def complete(self, values: Values) -> dict[str, float]:
        """Return values with those that follow from them; a name that has one keeps it."""
        known = frozenset(values)
        if known not in self._codes:
            self._codes[known] = None
            return self._once(values)
        return self.completion(known).complete(values)

    def _once(self, values: Values) -> dict[str, float]:
        found = dict(values)
        evaluation = SharedEvaluation(found)
        for name, formula, needs in self._steps:
            if name not in found and needs <= found.keys():
                found[name] = evaluation.of(formula)
        return found

    def completion(self, known: frozenset[str], often: int = OFTEN) -> "Completion":
        """Return as code all that values of these names determine, kept for the same names again.

        It is compiled when it has been used ``often``.
        """
        code = self._codes.get(known)
        if code is None:
            code = self._codes[known] = self._completion(known, often)
        return code

    def _completion(self, known: frozenset[str], often: int) -> "Completion":
        found, followed = set(known), []
        for name, formula, needs in self._steps:
            if name not in found and needs <= found:
                found.add(name)
                followed.append((name, formula))
        return Completion(sorted(known), followed, self._solved, often)


class Completion:
    """Definitions in order as straight-line code; ``names`` are those that they define."""

    def __init__(
        self,
        known: list[str],
        followed: list[tuple[str, Formula]],
        solved: Callable[[System], SystemSolver],
        often: int,
    ) -> None:
        self._given, self.names = in_order(known), [name for name, _ in followed]
        self._code = StraightLine(list(map(Symbol, self.names)), known, solved, followed, often)

    def complete(self, values: Values) -> dict[str, float]:
        """Return values with those that follow from them."""
        return {**values, **dict(zip(self.names, self.following(values), strict=True))}

    def following(self, values: Values) -> list[float]:
        """Return the values of the names that follow, in their order."""
        return self._code.at(self._given(values))


def completed(values: Values, definitions: Iterable[tuple[str, Formula]]) -> dict[str, float]:
    """Return values with definitions that stand in order, as far as their names have values."""
    found = dict(values)
    evaluation, needs = SharedEvaluation(found), Mentions()
    for name, formula in definitions:
        if needs.of(formula) <= found.keys():
            found[name] = evaluation.of(formula)
    return found


def independent(mechanism: Mechanism) -> list[Parameter]:
    """Return the parameters that follow from no other."""
    return [p for p in mechanism.parameters if not p.dependent]


def dependent(mechanism: Mechanism) -> dict[str, Formula]:
    """Return the formulas of the parameters that follow from others."""
    return {p.name: p.value for p in mechanism.parameters if p.dependent and p.value}


def user_defined(mechanism: Mechanism) -> dict[str, Formula]:
    """Return the user's own formulas by their names."""
    return {let.name: let.value for let in mechanism.lets}


def following(
    mechanism: Mechanism,
    definitions: Iterable[tuple[str, Formula]] = (),
    solved: Callable[[System], SystemSolver] = solver,
) -> Chain:
    """Return the dependent parameters and ``definitions``: all that follows from given values."""
    return Chain({**dependent(mechanism), **dict(definitions)}, solved)


def is_constant(parameter: Parameter) -> bool:
    """Return whether a parameter is the name of a number: an angle of a drawing.

    Lengths that are numbers have names, too, as ``literals`` of the mechanism.
    """
    return parameter.dependent and isinstance(parameter.value, Number)


def defaults(mechanism: Mechanism) -> dict[str, float]:
    """Return the values that the user gave; a parameter declared by dimension only is missing."""
    return {p.name: evaluate(p.value, {}) for p in independent(mechanism) if p.value}


def default_pose(mechanism: Mechanism) -> Values:
    """Return the values that the user gave, those that follow from them included.

    A parameter declared by dimension only is missing.
    """
    return complete(mechanism, defaults(mechanism))


def complete(mechanism: Mechanism, given: Values) -> Values:
    """Return the values with the dependent parameters that follow from them."""
    return following(mechanism).complete(given)


NEAR_ZERO = 0.2
"""How far an angle of zero is moved where others are, in radians: no part of it is far enough."""


def bounds(parameter: Parameter) -> tuple[float, float]:
    """Return the range to draw from: the user's, or one about the value, or a usual one."""
    if parameter.range:
        return evaluate(parameter.range.low, {}), evaluate(parameter.range.high, {})
    if parameter.value and not parameter.dependent:
        value = evaluate(parameter.value, {})
        if not value and parameter.dimension == ANGLE:
            return -NEAR_ZERO, NEAR_ZERO
        return value * 0.8, value * 1.25
    return (0.1, 1.4) if parameter.dimension == ANGLE else (0.5, 2.0)


def range_of(name: str, mechanism: Mechanism) -> tuple[float, float] | None:
    """Return the drive's stroke, or a parameter's range, from its lower end; None without."""
    drive = mechanism.drive
    ends = mechanism.parameter(name).range
    if drive and drive.parameter == name and drive.low and drive.high:
        low, high = evaluate(drive.low, {}), evaluate(drive.high, {})
    elif ends is not None:
        low, high = (evaluate(end, {}) for end in ends)
    else:
        return None
    return min(low, high), max(low, high)


def own_stroke(mechanism: Mechanism) -> tuple[Parameter, Formula, Formula] | None:
    """Return the drive's parameter and its stroke, where the range of it is another one."""
    drive = mechanism.drive
    if drive is None or drive.low is None or drive.high is None:
        return None
    parameter = mechanism.parameter(drive.parameter)
    if parameter.range and range_of(drive.parameter, mechanism) == bounds(parameter):
        return None
    return parameter, drive.low, drive.high


class UsualUnits(NamedTuple):
    """The units of a page: of its lengths, its forces and its moments."""

    length: str = "m"
    force: str = "N"
    moment: str = "N*m"

    def of(self, dimension: Dimension) -> str:
        """Return the unit of a value that none is given for, an angle's in degrees.

        >>> usual = UsualUnits("mm", "lbf")
        >>> [usual.of(LENGTH.scaled(power)) for power in (1, 2, 4, -1)]
        ['mm', 'mm^2', 'mm^4', '1/m']
        >>> usual.of(FORCE), usual.of(TORQUE), usual.of(ANGLE)
        ('lbf', 'N*m', 'deg')
        """
        own = {ANGLE: "deg", FORCE: self.force, TORQUE: self.moment}
        return own.get(dimension) or of_length(self.length, dimension) or si_unit(dimension)


def usual_units(mechanism: Mechanism) -> UsualUnits:
    """Return the units in which a description gives quantities first, of the SI where in none.

    Where moments alone are given, or forces alone, the others go with them: lbf with lbf·in.
    """
    given: tuple[Parameter | Let, ...]
    given = (*mechanism.parameters, *mechanism.literals, *mechanism.lets)
    first = {quantity.dimension: quantity.unit for quantity in reversed(given) if quantity.unit}
    length, force, moment = map(first.get, (LENGTH, FORCE, TORQUE))
    in_moment = (unit for unit in (moment or "").split("*") if _measures(unit, FORCE))
    force = force or next(in_moment, "N")
    own = "N*m" if force.endswith("N") else f"{force}*{length}"
    return UsualUnits(length or "m", force, moment or (own if _measures(own, TORQUE) else "N*m"))


def _measures(unit: str, dimension: Dimension) -> bool:
    return unit in UNITS and UNITS[unit].dimension == dimension


def own_unit(name: str, mechanism: Mechanism) -> str:
    """Return the unit that a ``let`` names for its value, '' where it names none."""
    return next((let.unit for let in mechanism.lets if let.name == name), "")


def allowed(mechanism: Mechanism, values: Values) -> bool:
    """Return whether every ``require`` holds; one on what has no value is left out."""
    return all(holds(condition, values) for condition in mechanism.requires)


def holds(condition: Require, values: Values) -> bool:
    """Return whether a condition holds; True where it has no value."""
    if not symbols(condition.left, condition.right) <= values.keys():
        return True
    left, right = evaluate(condition.left, values), evaluate(condition.right, values)
    return compare(left, condition.operator, right)


def valid_form(result: Result, values: Values) -> Result | None:
    """Return the form of a result that has a value: itself, or the one for elsewhere.

    None where a condition of either is broken. What has no value stands. Definitions that
    have a value keep it: what loops find may have been followed there from another pose.
    """
    found = valued_form(result, values)
    return found and found.form


class ValuedForm(NamedTuple):
    """The form of a result that stands, and its value; None where something it needs has none."""

    form: Result
    value: float | None


def valued_form(result: Result, values: Values) -> ValuedForm | None:
    """Return the form of :func:`valid_form` with its value, which is found on the way."""
    known = completed(values, (d for d in result.where if d.name not in values))
    sound = all(holds(guard, known) for guard in result.guards)
    is_known = symbols(result.formula) <= known.keys()
    value = evaluate(result.formula, known) if sound and is_known else None
    if sound and not (value is not None and math.isnan(value)):
        return ValuedForm(result, value)
    if result.elsewhere is None:
        return ValuedForm(result, value) if sound else None
    return valued_form(result.elsewhere, values)


class PrintedForm(NamedTuple):
    """What is seen of a result in a pose: the form that stands, its value, and that as printed."""

    form: Result
    value: float | None
    size: PrintedNumber


def of_sound_form(result: Result, look: Callable[[Result], PrintedForm]) -> PrintedNumber:
    """Return the size of a result in a pose where ``look`` says what is seen of each form.

    Where a form is 0 but for rounding, a sign in it may be what is rounded: the one for elsewhere
    has none such.
    """
    form, value, size = look(result)
    if value and size.number == 0 and form.elsewhere:
        return of_sound_form(form.elsewhere, look)
    return size


def compare(left: float, relation: str, right: float) -> bool:
    """Return whether one value is less than another, or greater, or the like."""
    return _COMPARE[relation](left, right)


MOST_CYCLES = 8
"""Cycles found in one run; more are a broken generator's work."""


NeededNames = Mapping[str, set[str]]


def ordered(needs: NeededNames) -> tuple[list[str], list[list[str]]]:
    """Return the names in order, without those in cycles, and the cycles as ``a b a``.

    >>> ordered({"a": {"b"}, "b": set(), "c": {"d"}, "d": {"c"}})[0]
    ['b', 'a']
    >>> ordered({"a": {"a"}})
    ([], [['a', 'a']])
    """
    cycles: list[list[str]] = []
    while len(cycles) < MOST_CYCLES:
        try:
            return list(_sorter(needs).static_order()), cycles
        except CycleError as error:
            cycle: list[str] = error.args[1]
            # The sorter gives each name before the one that needs it.
            cycles.append(cycle[::-1])
            gone = set(cycle)
            needs = {name: wanted - gone for name, wanted in needs.items() if name not in gone}
    return list(_free(needs)), cycles


def _sorter(needs: NeededNames) -> TopologicalSorter[str]:
    """Return a sorter that is given the names in an order that no hash decides."""
    return TopologicalSorter({name: sorted(wanted) for name, wanted in needs.items()})


def _free(needs: NeededNames) -> Iterator[str]:
    """Yield the names that no cycle blocks."""
    sorter = _sorter(needs)
    with suppress(CycleError):
        sorter.prepare()
    while ready := sorter.get_ready():
        yield from ready
        sorter.done(*ready)
