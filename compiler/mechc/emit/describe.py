"""What headers and comments say of a mechanism and its functions, in plain words.

Text of the user's goes through :func:`one_line` first: it may hold anything.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING
from unicodedata import category

from ..formula.to_text import text
from ..formula.tree import Constant, Formula, Number, Product
from ..formula.walk import symbols
from ..model.mechanism import GRAVITY, Mechanism
from ..model.result import Definition
from ..report.definitions import SolvedSystem, grouped
from ..routine.steps import Checks, Function, Guard, Input, Routine
from ..units import DIMENSIONS, Dimension, in_unit, si_unit

if TYPE_CHECKING:
    from ..pose.motion import MotionQuantity


def one_line(words: str) -> str:
    r"""Return the text on one line, without control, format and private characters.

    >>> one_line("a\nb\u202ec")
    'a b c'
    """
    plain = "".join(" " if category(c)[0] in "CZ" else c for c in words)
    return " ".join(plain.split())


def dimension_name(dimension: Dimension) -> str:
    """Return a dimension's name in the language, or its SI unit where it has none."""
    names = {d: name for name, d in DIMENSIONS.items()}
    return names.get(dimension) or si_unit(dimension)


def in_user_unit(value: float, item: Input) -> str:
    """Return an SI value in the unit the user wrote.

    >>> in_user_unit(0.1, Input("a", DIMENSIONS["length"], "mm"))
    '100 mm'
    """
    return in_unit(value, item.unit or si_unit(item.dimension), 6)


def input_words(item: Input, name: str = "") -> str:
    """Return one line on an input: SI unit, label, default and range as the user wrote them.

    ``name`` is what the target calls it.

    >>> import math
    >>> from mechc.units import ANGLE
    >>> input_words(Input("a", ANGLE, "deg", math.pi / 6, 0.0, math.pi / 4))
    'rad; 30 deg, in 0 deg .. 45 deg'
    """
    parts = [
        one_line(item.label),
        f"{item.name} in the formula" if name not in ("", item.name) else "",
        _default_words(item),
        _range_words(item),
    ]
    words = ", ".join(part for part in parts if part)
    unit = si_unit(item.dimension) or "number"
    return f"{unit}; {words}" if words else unit


POINTS = "coordinates of points and directions of links"
"""What the function of a mechanism's points returns."""


def quantity_words(quantity: "MotionQuantity") -> str:
    """Return one line on what a number of a motion is, with its SI unit."""
    point = one_line(quantity.of)
    match quantity.kind, quantity.axis:
        case "place", "":
            words = f"the direction of link {point}"
        case "place", axis:
            words = f"the {axis} of point {point}"
        case "slope", _:
            words = quantity.shown
        case kind, "":
            words = f"the angular {kind} of link {point}"
        case kind, axis:
            words = f"the {kind} of point {point} along {axis}"
    return measured_words(words, quantity.dimension)


def quantity_lines(quantities: "Iterable[MotionQuantity]") -> list[str]:
    """Return a line on each number of a motion."""
    return [f"{q.name}: {quantity_words(q)}" for q in quantities]


def measured_words(name: str, dimension: Dimension) -> str:
    """Return the name of what a function fills, or words on it, with its SI unit."""
    unit = si_unit(dimension)
    return f"{name}, in {unit}" if unit else f"{name}, a number"


def counted(operations: int) -> str:
    """Return how many operations there are.

    >>> counted(0), counted(1)
    ('0 operations', '1 operation')
    """
    return f"{operations} operation{'' if operations == 1 else 's'}"


def _default_words(item: Input) -> str:
    """Return the default with its tolerance, '' where there is none."""
    if item.default is None:
        return ""
    value = in_user_unit(item.default, item)
    return value if item.tolerance is None else f"{value} +- {in_user_unit(item.tolerance, item)}"


def _range_words(item: Input) -> str:
    if item.low is None or item.high is None:
        return ""
    return f"in {in_user_unit(item.low, item)} .. {in_user_unit(item.high, item)}"


def formula_lines(function: Function) -> list[str]:
    """Return the result as a reader writes it: ``k = …`` and the intermediates it mentions."""
    pairs = ((step.name, step.formula) for step in function.where if step.name != function.name)
    where = (line for group in grouped(pairs) for line in _group_lines(group, function.units))
    others = [f"where {', '.join(function.others)} are results, too"] if function.others else []
    first = f"{function.name} = {text(function.formula)}"
    return [first, *where, *others, *_case_lines(function)]


def _case_lines(function: Function) -> Iterator[str]:
    """Yield the lines on what a printed case leaves out: other signs, a system's coefficients."""
    if function.iterated:
        yield f"where {', '.join(function.iterated)} press the joints: n = |r + D*n|,"
        yield "    by Newton's method"
    if function.holds:
        yield "while"
        yield from (f"    {_condition(g)}" for g in function.holds)
        yield "and elsewhere with the signs of the pose"


def _group_lines(group: Definition | SolvedSystem, units: Mapping[str, str]) -> list[str]:
    if isinstance(group, Definition):
        unit = units.get(group.name, "")
        return [f"where {group.name} = {_value(group.formula)} {unit}".rstrip()]
    names = ", ".join(group.names)
    return [f"where {names} solve", *(f"    {text(zero)} = 0" for zero in group.zeros)]


def _value(formula: Formula) -> str:
    """Return a formula in a comment: a number, and the usual g in a weight, as decimals.

    >>> from ..formula.tree import Symbol, product
    >>> _value(product([(Symbol("m"), 1), (GRAVITY, 1)]))
    '9.80665*m'
    """
    match formula:
        case Number(value):
            return f"{float(value):.9g}"
        case Product((Number() as g, *others)) if g == GRAVITY:
            return text(Product((Constant(f"{float(g.value):.9g}", g), *others)))
        case _:
            return text(formula)


def condition_lines(function: Function) -> list[str]:
    """Return the conditions outside which the function gives NaN."""
    known = {*(i.name for i in function.inputs), *(step.name for step in function.where)}
    known.update(function.others)
    closing = [f"the loop {guard.loop} closes" for guard in function.guards if guard.loop]
    others = [guard for guard in function.guards if not guard.loop and not guard.balance]
    known_guards = [g for g in others if symbols(g.left) | symbols(g.right) <= known]
    lines = [*closing, *(_condition(guard) for guard in known_guards)]
    if any(guard.direction for guard in function.guards):
        lines.append("the force is more than what rounding leaves of one that is zero")
    if any(guard.balance and not guard.direction for guard in function.guards):
        lines.append("some force of the drive balances the loads and all friction")
    return lines


def slope_remarks(function: Function) -> list[str]:
    """Return the remarks in code on slopes that are missing."""
    if function.otherwise:
        return [
            "NaN where friction turns the force at a joint round: this form has no value there."
        ]
    return ["NaN where a condition of the result fails."] if function.guards else []


def status_lines(checks: Checks) -> list[str]:
    """Return the conditions of a sheet by their numbers."""
    return [f"{i}: {_condition(guard)}" for i, guard in enumerate(checks.guards, 1)]


def remarks(function: Function, names: Mapping[str, str]) -> list[str]:
    """Return the remarks in code on a function's companions, which it calls by these names."""
    lines = []
    if function.otherwise:
        lines.append("Where friction turns the force at a joint round, so that this form has no")
        lines.append(f"value, it is that of {names[function.otherwise.name]}.")
    if function.status:
        lines.append(f"What a number or NaN means, {names[function.status.name]} tells.")
    return lines


def numbered(sentences: Iterable[str]) -> Iterator[str]:
    """Yield sentences as they are counted from 0."""
    yield from (f"{i}: {sentence}" for i, sentence in enumerate(sentences))


def _condition(guard: Guard) -> str:
    return f"{_value(guard.left)} {guard.operator} {_value(guard.right)}"


def unchecked(routine: Routine) -> list[str]:
    """Return the conditions of use that no function can check from its inputs.

    Of a calculation sheet the status has them all.
    """
    conditions = (f"{text(r.left)} {r.operator} {text(r.right)}" for r in routine.unchecked)
    return list(dict.fromkeys(conditions))


def heading(mechanism: Mechanism) -> str:
    """Return the title of a mechanism, its name where it has none."""
    return one_line(mechanism.title) or one_line(mechanism.name)


def call(function: Function, names: Mapping[str, str], own: Mapping[str, str]) -> str:
    """Return a call of a function with arguments of these names."""
    return f"{names[function.name]}({', '.join(own[i.name] for i in function.inputs)})"
