"""Formulas with numbers put in for their symbols, as calculation notes have them.

Values on the way to a result are put in with the units in which they are read.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise

from ..base.frozen import replace
from ..base.named import NamedTuple
from ..formula.evaluate import evaluate
from ..formula.layout import TRIGONOMETRIC, diameters_behind, over_line, squares
from ..formula.operations import count_operations
from ..formula.tree import (
    HALF,
    Call,
    Constant,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    degrees,
    negative,
    power,
    product,
    total,
)
from ..formula.walk import children, constants, rebuild, symbols
from ..model.mechanism import Mechanism
from ..model.parts.written import WrittenTable
from ..model.values import UsualUnits, Values, completed
from ..study.analysis import Analysis
from ..study.tolerances import SAME_RATIO
from ..syntax.vocabulary import split_quantity
from ..units import (
    ANGLE,
    NUMBER,
    UNITS,
    Dimension,
    in_unit,
    size_of,
)
from .digits import VALUE_DIGITS
from .dimensions import found_dimension, is_homogeneous, is_plain, is_solved, names_in, with_symbols

COMPUTED = 12
"""Digits beyond which a number was computed, not written by hand: ``102.277600186942 N``."""

MOST_SHOWN_OPERATIONS = 60
"""A formula of more operations than this is given by its value alone."""

ONE_ROW = 1e-12
"""A number nearer to a row of a table than this part is that row: a unit has rounded it."""

DEGREE_DECIMALS = 9
"""Decimals of an angle in degrees, beyond which there is nothing but rounding."""


class GivenQuantity(NamedTuple):
    """A value in SI, and the unit that it is given in."""

    value: float
    unit: str

    def text(self, digits: int) -> str:
        """Return the value to so many digits in its unit: ``5 mm``."""
        return in_unit(self.value, self.unit, digits)


def values_of(given: Mapping[str, GivenQuantity]) -> dict[str, float]:
    """Return quantities as numbers, in SI and radians."""
    return {name: quantity.value for name, quantity in given.items()}


def put_in(formula: Formula, given: Mapping[str, GivenQuantity]) -> Formula:
    """Return a formula with quantities for symbols, in brackets where a power is taken of one.

    A sine or cosine is that of its angle in degrees, whatever this is a sum of; a cosine is even.

    >>> from ..formula.to_text import text
    >>> from ..formula.tree import product, total
    >>> a, alpha, beta = map(Symbol, ("a", "alpha", "beta"))
    >>> formula = product([(a, 1), (Call("sin", (total([alpha, beta]),)), 1)])
    >>> ten = GivenQuantity(math.radians(10), "deg")
    >>> text(put_in(formula, {"a": GivenQuantity(0.04, "mm"), "alpha": ten, "beta": ten}))
    '40 mm*sin(pi/9)'
    >>> lengths = {"a": GivenQuantity(0.04, "mm"), "beta": GivenQuantity(-0.06, "mm")}
    >>> text(put_in(total([a, beta]), lengths))
    '40 mm - 60 mm'
    >>> text(put_in(Call("cos", (negative(alpha),)), {"alpha": ten}))
    'cos(pi/18)'
    """
    match formula:
        case Call(function, (angle,)) if function in TRIGONOMETRIC and symbols(angle):
            return _of_degrees(function, evaluate(angle, values_of(given)))
        case Call("hypot", sides) if symbols(formula):
            return put_in(power(squares(sides), HALF), given)
        case Call("abs", (inner,)):
            return Call("abs", (_without_minus(_argument(inner, given))[1],))
        case Call(function, arguments):
            return Call(function, tuple(_argument(a, given) for a in arguments))
        case Constant() | Power(Number()):
            return formula
        case Sum((Symbol(name) as first, *others)) if not isinstance(first, Constant):
            begun = _argument(first, given)  # nothing stands before its sign
            return total((begun, *(_term(term, given) for term in others)))
        case Sum(terms):
            return total(_term(term, given) for term in terms)
        case Product(factors) if sum(bool(symbols(f)) for f in factors) > 1:
            return _in_front([_factor(factor, given) for factor in diameters_behind(factors)])
        case Symbol(name) if given[name].unit == "deg":
            return in_degrees(given[name].value, VALUE_DIGITS)
        case Symbol(name):
            return _constant(given[name], bracketed=given[name].value < 0)
        case Power(Symbol(name) as base, exponent) if not isinstance(base, Constant):
            base = _constant(given[name], _is_bracketed(given[name], exponent))
            return Power(base, put_in(exponent, given))
        case Power(base, exponent):
            return _power(put_in(base, given), put_in(exponent, given))
        case _:
            parts = children(formula)
            found = tuple(put_in(part, given) for part in parts)
            return rebuild(formula, found) if parts else formula


def _of_degrees(function: str, angle: float) -> Formula:
    """Return a function of an angle in degrees, none of them negative; a minus is before it."""
    turn = _within_a_turn(angle)
    value = Call(function, (in_degrees(abs(turn), VALUE_DIGITS),))
    return negative(value) if turn < 0 and function != "cos" else value


def _is_bracketed(quantity: GivenQuantity, exponent: Formula) -> bool:
    """Return whether a quantity that a power is taken of stands in brackets.

    It does with a unit, a power of ten or a minus; not under a root, and below a line for a
    minus alone.
    """
    if exponent == HALF:
        return False
    is_long = bool(quantity.unit) or "e" in quantity.text(VALUE_DIGITS)
    is_divisor = exponent == Number(Fraction(-1))
    return (is_long and not is_divisor) or quantity.value < 0


def _in_front(factors: Iterable[Formula]) -> Formula:
    """Return a product with the minuses of its sines and of its numbers before all of it.

    >>> from ..formula.to_text import text
    >>> from ..formula.tree import number
    >>> sine, ten = Call("sin", (degrees(10),)), Constant("10 mm", number(1))
    >>> text(_in_front([ten, negative(sine), ten])), text(_in_front([number(-1), negative(sine)]))
    ('-10 mm*sin(pi/18)*10 mm', 'sin(pi/18)')
    >>> load = Constant("(-5 N)", number(-5))
    >>> text(_in_front([load, sine])), text(_in_front([number(-1), sine, Power(load, number(-1))]))
    ('-5 N*sin(pi/18)', 'sin(pi/18)/5 N')
    """
    parts = [_without_minus(factor) for factor in factors]
    sign = math.prod(sign for sign, _ in parts)
    plain = [factor for _, factor in parts]
    if sign < 0:
        plain = _opposite(plain)
    return Product(tuple(plain)) if len(plain) > 1 else plain[0]


def _opposite(factors: Sequence[Formula]) -> list[Formula]:
    """Return factors, the first of which is a number with the other sign, if it is no 1."""
    first, *others = factors
    if not isinstance(first, Number):
        return [Number(Fraction(-1)), *factors]
    return others if first.value == -1 and others else [Number(-first.value), *others]


def _without_minus(factor: Formula) -> tuple[int, Formula]:
    """Return the sign of a sine, a number put in, or a power of one, and it without its minus."""
    match factor:
        case Product((Number(value), (Call() | Power(Call())) as sine)) if value == -1:
            return -1, sine
        case Constant(name, value) if name.startswith("(-"):
            return -1, Constant(name.removeprefix("(-").removesuffix(")"), negative(value))
        case Power(
            Constant() as base, Number(Fraction(numerator=n, denominator=1)) as exponent
        ) if n % 2:
            sign, size = _without_minus(base)
            return sign, Power(size, exponent)
        case _:
            return 1, factor


def _power(base: Formula, exponent: Formula) -> Formula:
    """Return a power; one of (−s) is written −s^n for an odd n, and s^n for an even one."""
    sign, size = _without_minus(base)
    if sign > 0 or not isinstance(exponent, Number) or exponent.value.denominator != 1:
        return Power(base, exponent)
    positive = Power(size, exponent)
    return negative(positive) if exponent.value.numerator % 2 else positive


def _term(formula: Formula, given: Mapping[str, GivenQuantity]) -> Formula:
    """Return a term in numbers: a negative quantity changes the sign that it is joined by."""
    match formula:
        case Symbol(name) | Product((Number(Fraction(numerator=-1, denominator=1)), Symbol(name))):
            quantity = given.get(name, GivenQuantity(0, ""))
            if quantity.value < 0 and quantity.unit != "deg":
                size = _constant(quantity._replace(value=-quantity.value), bracketed=False)
                return negative(size) if isinstance(formula, Symbol) else size
    return put_in(formula, given)


def _factor(formula: Formula, given: Mapping[str, GivenQuantity]) -> Formula:
    """Return a factor in numbers; an angle among others is one by itself, not so many pi."""
    if isinstance(formula, Symbol) and not isinstance(formula, Constant):
        return _constant(given[formula.name], bracketed=given[formula.name].value < 0)
    return put_in(formula, given)


def _argument(formula: Formula, given: Mapping[str, GivenQuantity]) -> Formula:
    """Return the argument of a function, with its value put in; it has brackets already."""
    if isinstance(formula, Symbol) and not isinstance(formula, Constant):
        quantity = given[formula.name]
        return put_in(formula, given) if quantity.unit == "deg" else _constant(quantity, False)
    return put_in(formula, given)


def _constant(quantity: GivenQuantity, bracketed: bool) -> Constant:
    text = quantity.text(VALUE_DIGITS)
    return Constant(f"({text})" if bracketed else text, Number(Fraction(quantity.value)))


def _within_a_turn(angle: float) -> float:
    """Return an angle of a sine or cosine from -180° to 360°, without whole turns beyond.

    >>> [round(math.degrees(_within_a_turn(math.radians(a)))) for a in (-674, -300, -100, 267)]
    [46, 60, -100, 267]
    """
    beyond = angle < -math.pi or angle > 2 * math.pi
    return math.remainder(angle, 2 * math.pi) if beyond else angle


def without_rounding(quantity: GivenQuantity) -> GivenQuantity:
    """Return a quantity that was computed; an angle that rounding alone made is zero.

    >>> without_rounding(GivenQuantity(-4e-17, "deg")).value
    0.0
    """
    is_nothing = quantity.unit == "deg" and not round(math.degrees(quantity.value), DEGREE_DECIMALS)
    return GivenQuantity(0.0, "deg") if is_nothing else quantity


def in_degrees(angle: float, digits: int) -> Formula:
    """Return an angle in radians as degrees, to so many digits; rounding alone makes none.

    Beyond 100° two decimals are kept, as next to a multiple of 90° they decide a cosine.

    >>> in_degrees(1e-15, 4)
    Number(value=Fraction(0, 1))
    >>> from ..formula.layout import in_degrees as back
    >>> float(back(in_degrees(math.radians(266.9662), 4)))
    266.97
    """
    turn = round(math.degrees(angle), DEGREE_DECIMALS)
    digits += abs(turn) >= 100
    return degrees(Fraction(f"{turn:.{digits}g}"))


def in_numbers(formula: Formula, given: Mapping[str, GivenQuantity], bare: bool) -> Formula | None:
    """Return a formula with its numbers put in, if it is short and all of them are known."""
    names = names_in(formula)
    if not names <= given.keys() or not names or count_operations(formula) > MOST_SHOWN_OPERATIONS:
        return None
    if is_solved(formula) or _is_value(formula, given):
        return None
    if has_units(formula, {name: given[name] for name in names}, bare):
        return None
    units = {given[n].unit for n in names} - {"", "deg"}
    named = with_symbols(formula)
    if over_line(formula) == formula:
        named = over_line(named)
    if bare and len(units) == 1:
        return put_in(named, {n: _bare(q) for n, q in given.items()})
    return put_in(named, given)


def _is_value(formula: Formula, given: Mapping[str, GivenQuantity]) -> bool:
    """Return whether the numbers put in would be the value: of a symbol, a minus before one too.

    So they would of a multiple of an angle.
    """
    match formula:
        case Symbol():
            return True
        case Product((Number(times), Symbol(name))):
            return times == -1 or given[name].unit == "deg"
        case _:
            return False


def has_units(formula: Formula, given: Mapping[str, GivenQuantity], is_number: bool) -> bool:
    """Return whether a number of the formula has a unit: others must not be put in next to it.

    What ``is_number`` itself, or an angle, is the same in all units where none has.
    """
    units = {name: UNITS.get(q.unit) for name, q in given.items()}
    dimensions = {name: unit.dimension if unit else NUMBER for name, unit in units.items()}
    known = all(units[name] for name, q in given.items() if q.unit)
    values = {name: q.value for name, q in given.items()}
    is_sound = is_plain if is_number else is_homogeneous
    return known and not is_sound(with_symbols(formula), values, dimensions)


def _bare(quantity: GivenQuantity) -> GivenQuantity:
    """Return a quantity without its unit, an angle as it is."""
    if quantity.unit == "deg":
        return quantity
    return GivenQuantity(quantity.value / size_of(quantity.unit), "")


WrittenTables = Mapping[str, WrittenTable]
"""Tables by their names."""


def tables_of(mechanism: Mechanism) -> WrittenTables:
    """Return the tables and lists of a description as pages have them, by their names."""
    return {table.name: _shortened(table) for table in mechanism.tables}


def _shortened(table: WrittenTable) -> WrittenTable:
    """Return a table as pages have it: numbers that were computed have the digits of values."""
    rows = (tuple(_short(cell) for cell in row) for row in table.rows)
    return replace(table, rows=tuple(rows))


def _short(cell: Formula) -> Formula:
    digits = sum(map(str.isdigit, cell.name)) if isinstance(cell, Constant) else 0
    if not isinstance(cell, Constant) or digits < COMPUTED:
        return cell
    number, unit = split_quantity(cell.name)
    return replace(cell, name=f"{float(number):.{VALUE_DIGITS}g} {unit}".rstrip())


def line_between(table: WrittenTable, asked: float) -> Formula | None:
    """Return the straight line between the rows around what is asked for: y1 + (x - x1)/….

    None where that is a row itself, or where no two rows lie around it.
    """
    rows = [(cell, evaluate(cell, {}), value) for cell, value in table.rows]
    for before, after in pairwise(sorted(rows, key=lambda row: row[1])):
        if before[1] < asked < after[1] and not _is_one_of(asked, before[1], after[1]):
            low, high = map(_as_written, (before[2], after[2]))
            first, last = map(_as_written, (before[0], after[0]))
            way, rise = _less(last, first), _less(high, low)
            part = product([(_less(_asked(asked, first), first), 1), (way, -1), (rise, 1)])
            return total([low, part])
    return None


def _less(one: Formula, other: Formula) -> Formula:
    return total([one, negative(other)])


def _is_one_of(asked: float, *rows: float) -> bool:
    return any(math.isclose(asked, row, rel_tol=ONE_ROW) for row in rows)


def _asked(value: float, row: Formula) -> Constant:
    """Return the value asked for in the unit of a row."""
    unit = next((split_quantity(c.name)[1] for c in constants([row])), "")
    return Constant(GivenQuantity(value, unit).text(VALUE_DIGITS), Number(Fraction(value)))


def _as_written(cell: Formula) -> Formula:
    """Return a cell that stays as it is written, also where it is a number alone."""
    return Constant(str(cell.value), cell) if isinstance(cell, Number) else cell


class FoundValue(NamedTuple):
    """A value, and what it measures."""

    value: GivenQuantity
    dimension: Dimension


def on_the_way(
    result: Analysis, values: Values, dimensions: Mapping[str, Dimension], usual: UsualUnits
) -> dict[str, FoundValue]:
    """Return the values of the names that a result rests on, as far as their units are known.

    There are none where the result has another form at these ``values`` than the one printed.
    """
    known, measures = completed(values, result.where), dict(dimensions)
    if not _is_printed(result, known):
        return {}
    found: dict[str, FoundValue] = {}
    for definition in result.where:
        angles = [name for name, dimension in measures.items() if dimension == ANGLE]
        dimension = found_dimension(definition, angles, known, measures)
        if dimension is not None and math.isfinite(known[definition.name]):
            measures[definition.name] = dimension
            value = GivenQuantity(known[definition.name], usual.of(dimension))
            found[definition.name] = FoundValue(value, dimension)
    return found


def _is_printed(result: Analysis, known: Values) -> bool:
    """Return whether the printed formula gives the value of a result."""
    if result.default is None or not symbols(result.formula) <= known.keys():
        return False
    return math.isclose(evaluate(result.formula, known), result.default, rel_tol=SAME_RATIO)
