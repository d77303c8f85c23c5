"""One parameter: its dimension, value, range and unit."""

import math
from collections.abc import Iterator, Mapping
from itertools import chain

from ...base.frozen import replace
from ...diagnostics import Report
from ...diagnostics.model import doubts, quantities, sizes
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...syntax import ast
from ...syntax.settings import parse
from ...syntax.vocabulary import points_of
from ...units import ANGLE, DIMENSIONS, LENGTH, NUMBER, UNITS, Dimension
from ..constants import leaves, names_in, out_of_reach
from ..mechanism import Interval, Parameter
from ..names.points import PointTable
from ..names.scope import DESCRIPTION, NameScope, UnitlessNumber
from ..tolerances import SAME_VALUE
from .directions import is_beyond_a_turn, note_units
from .expressions import Reader
from .measured import MeasuredFormula, fits, shown
from .misplaced_units import note_misplaced_unit
from .sorts import Nature

RangeEnds = tuple[MeasuredFormula, MeasuredFormula]


def read_parameter(
    statement: ast.Param, scope: NameScope, known: Mapping[str, Parameter]
) -> Parameter | None:
    """Read a ``param`` line; ``known`` are the parameters that it may depend on."""
    value = Reader(scope, DESCRIPTION).read(statement.value) if statement.value else None
    ends = _range(statement, scope)
    dimension = _dimension(statement, value, ends, scope)
    if dimension is None or not _consistent(statement, dimension, value, ends, scope):
        return None
    name = statement.name.text
    note_misplaced_unit(statement, dimension, scope)
    scope.define(name, dimension)
    given = value or (ends and ends[1])
    if given and statement.dimension is None:
        note_unitless(name, given, scope)
    parameter = Parameter(
        name=name,
        dimension=dimension,
        span=statement.span,
        value=value.formula if value else None,
        range=Interval(ends[0].formula, ends[1].formula) if ends else None,
        unit=_unit(statement, dimension, known),
        label=statement.label,
        about=statement.about,
        dependent=bool(value and symbols(value.formula)),
    )
    parameter = replace(parameter, tolerance=_tolerance(parameter, statement, scope))
    _note_value(parameter, statement, scope)
    _check_range(parameter, statement, scope)
    drawn = Reader(scope, DESCRIPTION).read(statement.replaced) if statement.replaced else None
    replaced = drawn.formula if drawn else None
    return replace(parameter, setting=scope.settings.get(name), replaced=replaced)


def constant(expression: ast.Expr, scope: NameScope, what: str) -> MeasuredFormula | None:
    """Read an expression that may mention no name; ``what`` names it in messages."""
    for symbol in names_in(expression):
        if symbol.name != "pi":
            scope.report.add(quantities.not_constant(symbol.span, symbol.name, what))
            return None
    return Reader(scope, DESCRIPTION).read(expression)


def note_unitless(name: str, given: MeasuredFormula, scope: NameScope) -> None:
    """State of a number without unit that it is one: 30 could be radians, but who means them?"""
    if given.sort.nature is Nature.BARE:
        is_number = not symbols(given.formula)  # what a table has for a name is none
        scope.without_unit(
            name, UnitlessNumber(shown(given.formula), given.span) if is_number else None
        )
    elif given.sort.nature is Nature.UNITLESS:
        scope.without_unit(name, scope.unitless_number(given.formula))


def read_tolerance(
    expression: ast.Expr, dimension: Dimension | None, what: str, scope: NameScope
) -> Formula | None:
    """Read how far a quantity may be off: a positive constant of its dimension."""
    found = constant(expression, scope, "a tolerance")
    if found is None:
        return None
    if dimension and not fits(found, dimension, f"the tolerance {what}", scope):
        return None
    size = evaluate(found.formula, {})
    if not size > 0 or out_of_reach(max(size, 1.0), found.dimension):
        scope.report.add(quantities.tolerance_not_positive(expression.span, what))
        return None
    return found.formula


def _tolerance(parameter: Parameter, statement: ast.Param, scope: NameScope) -> Formula | None:
    """Return the tolerance of a parameter; report one that cannot be, or that is hardly meant."""
    if statement.tolerance is None:
        return None
    if parameter.dependent:
        place = statement.tolerance.span
        scope.report.add(quantities.tolerance_of_dependent(place, parameter.name))
        return None
    found = read_tolerance(
        statement.tolerance, parameter.dimension, f"of '{parameter.name}'", scope
    )
    doubt = _doubt(found, parameter, scope.sheet) if found else None
    if doubt:
        place = statement.tolerance.span
        scope.report.add(sizes.tolerance_of_all(place, parameter.name, doubt))
    return found


WIDE = math.radians(10) * (1 - SAME_VALUE)
"""An angle by which nothing that is made is off."""


def _doubt(
    tolerance: Formula, parameter: Parameter, is_sheet: bool
) -> "sizes.ToleranceDoubt | None":
    """Return in which way a tolerance is too large, None where it may be meant."""
    size = evaluate(tolerance, {})
    if parameter.value and _is_of_all(tolerance, parameter.value, parameter, is_sheet):
        return "value"
    if parameter.range:
        low, high = (evaluate(end, {}) for end in parameter.range)
        return "range" if 2 * size > (high - low) * (1 + SAME_VALUE) > 0 else None
    return "angle" if parameter.dimension == ANGLE and size >= WIDE else None


def _is_of_all(tolerance: Formula, given: Formula, parameter: Parameter, is_sheet: bool) -> bool:
    """Return whether a tolerance takes a value to zero that has a sign: an angle has none.

    Of the lengths of a mechanism it is said where a vector has them (W246).
    """
    if symbols(given) or (parameter.dimension == LENGTH and not is_sheet):
        return False
    value, size = (evaluate(f, {}) for f in (given, tolerance))
    low, high = (evaluate(e, {}) for e in parameter.range) if parameter.range else (-1.0, 1.0)
    return 0 < abs(value) <= size and (parameter.dimension != ANGLE or low * high > 0)


def _range(statement: ast.Param, scope: NameScope) -> RangeEnds | None:
    if statement.low is None or statement.high is None:
        return None
    low = constant(statement.low, scope, "an end of a range")
    high = constant(statement.high, scope, "an end of a range")
    return (low, high) if low and high else None


def _dimension(
    statement: ast.Param, value: MeasuredFormula | None, ends: RangeEnds | None, scope: NameScope
) -> Dimension | None:
    """Return the dimension: the one declared, else the value's, else the range's.

    The parsers see to it that there is one of the three.
    """
    name = statement.dimension
    if name:
        if name.text not in DIMENSIONS:
            scope.report.add(quantities.unknown_dimension(name.span, name.text, DIMENSIONS))
        return DIMENSIONS.get(name.text)
    if statement.value:
        return value.dimension if value else None
    if ends:
        low, high = ends
        return low.dimension if high.sort.nature is Nature.ZERO else high.dimension
    assert statement.low, f"nothing is said of '{statement.name.text}'"
    return None


def _consistent(
    statement: ast.Param,
    dimension: Dimension,
    value: MeasuredFormula | None,
    ends: RangeEnds | None,
    scope: NameScope,
) -> bool:
    """Report a value or an end of the range that measures something else."""
    name = statement.name.text
    if _lacks_unit(statement, value, scope):
        return False
    if value and ends and value.sort.nature is Nature.BARE and dimension == NUMBER:
        # A range with a unit says what the value means, not the other way round.
        dimension = next((e.dimension for e in ends if e.sort.nature is not Nature.ZERO), NUMBER)
    sound = value is None or fits(value, dimension, f"'{name}'", scope)
    for end in _different(ends or ()):
        sound = fits(end, dimension, f"the range of '{name}'", scope) and sound
    return sound and (value is not None or statement.value is None)


def _lacks_unit(statement: ast.Param, value: MeasuredFormula | None, scope: NameScope) -> bool:
    """Report a number without unit whose tolerance has one: ``200 +- 0.5 mm``."""
    match statement.tolerance:
        case ast.Number(unit=unit) if unit and value and value.sort.nature is Nature.BARE:
            fits(value, UNITS[unit].dimension, f"'{statement.name.text}'", scope)
            return True
        case _:
            return False


def _different(ends: tuple[MeasuredFormula, ...]) -> tuple[MeasuredFormula, ...]:
    """Return the ends of a range, one of them where both are the same sort of quantity."""
    first, *others = ends or (None,)
    alike = first is not None and all(first.sort == other.sort for other in others)
    return ends[:1] if alike else ends


def _unit(statement: ast.Param, dimension: Dimension, known: Mapping[str, Parameter]) -> str:
    """Return the first unit of this dimension that the user wrote, here or in what it uses."""
    parts = [part for part in (statement.value, statement.high) if part]
    for unit in chain.from_iterable(_units(part, known) for part in parts):
        if unit and UNITS[unit].dimension == dimension:
            return unit
    return ""


def _units(expression: ast.Expr, known: Mapping[str, Parameter]) -> Iterator[str]:
    for leaf in leaves(expression):
        match leaf:
            case ast.Number(unit=unit):
                yield unit
            case ast.Symbol(name=name) if name in known:
                yield known[name].unit


def _note_value(parameter: Parameter, statement: ast.Param, scope: NameScope) -> None:
    """Keep the default value for later checks; report a formula that has none."""
    formula, name = parameter.value, parameter.name
    scope.sizes[name] = 1.0
    if not formula or not statement.value:
        return
    if scope.report.source.is_setting(statement.value.span):
        scope.settings[name] = statement.value.span
    size = scope.size(formula)
    if out_of_reach(size, parameter.dimension):
        scope.report.add(quantities.out_of_reach(statement.value.span, parameter.dimension))
        return
    known = symbols(formula) <= scope.values.keys()
    if math.isfinite(size):
        scope.sizes[name] = size
    elif known:
        scope.report.add(quantities.no_value(statement.value.span))
    if known and math.isfinite(size):
        scope.values[name] = size


def _check_range(parameter: Parameter, statement: ast.Param, scope: NameScope) -> None:
    """Note a range in the scope; report one that is none, or that the value lies outside of."""
    if parameter.range is None or statement.low is None or statement.high is None:
        return
    edge = statement.low.span.to(statement.high.span)
    low, high = (evaluate(end, {}) for end in parameter.range)
    if any(out_of_reach(end, parameter.dimension) for end in (low, high)):
        scope.report.add(quantities.out_of_reach(edge, parameter.dimension))
        return
    scope.ranges[parameter.name] = low, high
    scope.lower_ends[parameter.name] = statement.low.span
    if parameter.dimension != ANGLE or not is_beyond_a_turn(low, high):
        what = f"the range of '{parameter.name}'"
        note_units((statement.low, statement.high), what, edge, scope)
    value = scope.values.get(parameter.name)
    if parameter.dependent:
        scope.report.add(quantities.range_of_dependent(edge, parameter.name))
    elif not low < high:
        scope.report.add(quantities.range_backwards(edge, parameter.name, low == high))
    elif value is not None and statement.value and not low <= value <= high:
        span = statement.value.span
        scope.report.add(quantities.value_outside_range(span, parameter.name, edge))


def warn_unused(parameters: Mapping[str, Parameter], scope: NameScope) -> None:
    """Warn of parameters that no formula mentions, those of what is used left out."""
    own = len(scope.report.source.text)
    for name, parameter in parameters.items():
        if name not in scope.used and parameter.span.start < own:
            is_vector = len(points_of(name)) > 1
            scope.report.add(doubts.unused_parameter(parameter.span, name, is_vector))


ORIGIN = "value"
"""What messages call the text of a value, which stands in no file."""


def in_si(name: str, text: str, dimension: Dimension) -> float:
    """Return a value for a name in SI and radians.

    Raises :class:`MechcError` where the text is no constant that measures ``dimension``.

    >>> from ...units import LENGTH
    >>> in_si("a", "2.5 in", LENGTH), in_si("a", "30mm", LENGTH)
    (0.0635, 0.03)
    """
    _, (value, source) = parse(f"{name}={text}", ORIGIN)
    report = Report(source)
    scope = NameScope(report, PointTable(report))
    found = constant(value, scope, "a value")
    if found is not None:
        fits(found, dimension, f"the value of {name}", scope)
    report.stop_on_errors()
    assert found is not None
    return evaluate(found.formula, {})
