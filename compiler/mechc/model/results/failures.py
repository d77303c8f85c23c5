"""What is said of a condition that fails, with the values of its sides."""

from collections.abc import Container, Iterator

from ...base.later import pattern
from ...diagnostics import Diagnostic
from ...diagnostics import sheets as messages
from ...diagnostics import uses as uses_messages
from ...diagnostics.model import quantities
from ...formula.evaluate import evaluate
from ...formula.to_text import text
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...source import Source
from ...units import ANGLE, LENGTH, in_unit, si_unit
from ..mechanism import Require, Subject
from ..names.forms import form_of_pose
from ..values import Values


def failure(condition: Require, sides: tuple[float, float], source: Source) -> Diagnostic:
    """Return the diagnostic of a condition that fails at these values of its sides, in SI."""
    span, subject = condition.span, condition.subject
    left, right = _with_values(condition, sides, source)
    match subject:
        case None | Subject("pose" | "ranges"):
            return messages.requirement_fails(span, *_found_first(condition, left, right))
        case Subject("first row", name, _):
            return messages.beyond_the_table(span, name, f"begins at {left}", right)
        case Subject("last row", name, _):
            return messages.beyond_the_table(span, name, f"ends at {right}", left)
        case Subject("row", name, _):
            return messages.between_rows(span, name, left, right.rpartition(" = ")[2])
        case Subject("list", name, _):
            return messages.beyond_the_list(span, name, left, right)
        case Subject("range", _, _, place):
            return uses_messages.outside_used_range(span, left, condition.operator, right, place)
        case Subject(_, name, _):
            return messages.no_single_case(span, name, round(sides[0]))


def broken_formula(condition: Require, values: Values, source: Source) -> str:
    """Return the message of a formula that has no value at these values."""
    sides = evaluate(condition.left, values), evaluate(condition.right, values)
    return failure(condition, sides, source).message


def broken(condition: Require, values: Values, source: Source, lets: Container[str]) -> Diagnostic:
    """Return the warning at a condition of use of a mechanism that fails at these values.

    ``lets`` are the user's own formulas, by their names in the text.
    """
    sides = evaluate(condition.left, values), evaluate(condition.right, values)
    left, right = _with_values(condition, sides, source, lets)
    compared = messages.held_against(*_found_first(condition, left, right))
    return quantities.condition_broken(condition.span, compared)


def _found_first(condition: Require, left: str, right: str) -> tuple[str, str, str]:
    """Return the sides about the operator, a number behind what is held against it."""
    if symbols(condition.left) or not symbols(condition.right):
        return left, condition.operator, right
    return right, condition.operator.translate(_TURNED), left


def _with_values(
    condition: Require, sides: tuple[float, float], source: Source, lets: Container[str] = ()
) -> Iterator[str]:
    """Yield the sides of a condition with their values: ``sigma = 182 MPa``."""
    dimension = condition.dimension
    unit = condition.unit or _USUAL.get(dimension) or si_unit(dimension)
    formulas, spelled = (condition.left, condition.right), _as_written(condition, source, lets)
    for formula, value, words in zip(formulas, sides, spelled, strict=True):
        shown = in_unit(value, unit, 6)
        yield f"{words} = {shown}" if symbols(formula) else shown


def _as_written(condition: Require, source: Source, lets: Container[str]) -> tuple[str, str]:
    """Return the sides of a condition as they stand in the text, else as formulas.

    A condition of a used sheet has names with a prefix, that of a chain has neighbours.
    """
    written = " ".join(source.written(condition.span).split()).removeprefix("require ")
    if found := _ASKED.fullmatch(written):
        return _with_argument(condition, found[1] or found[2], lets)
    formulas = condition.left, condition.right
    sides = [part.strip(" '\"") for part in _OPERATOR.split(written)]
    if len(sides) == len(formulas) and all(
        _mentions(side, formula, lets) for side, formula in zip(sides, formulas, strict=True)
    ):
        return sides[0], sides[1]
    return text(condition.left), text(condition.right)


def _with_argument(condition: Require, argument: str, lets: Container[str]) -> tuple[str, str]:
    """Return the sides of what a table or list demands, its argument as it is in the text."""
    left, right = (
        argument if symbols(side) and _mentions(argument, side, lets) else text(side)
        for side in (condition.left, condition.right)
    )
    return left, right


def _mentions(written: str, formula: Formula, lets: Container[str]) -> bool:
    """Return whether the names of a formula are written, or what it came from: pose, or lets."""
    names = _NAME.findall(written)
    return symbols(formula) <= {*names} or any(n in lets or form_of_pose(n) for n in names)


_USUAL = {ANGLE: "deg", LENGTH: "mm"}
"""Units of values where the text names none."""

_TURNED = str.maketrans("<>", "><")
"""What becomes of a comparison whose sides change places."""

_OPERATOR, _NAME = pattern("[<>=!≤≥≠]+"), pattern(r"[^\W\d]\w*")

_ASKED = pattern(r"\w+ at (?:exactly )?(.+)|(?:next )?(.+) in \w+")
"""How a table is asked, and a list."""
