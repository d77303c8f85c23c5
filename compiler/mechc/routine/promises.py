"""What a routine promises, as a check for tests and for whoever builds routines."""

from collections import Counter
from collections.abc import Iterator

from ..formula.to_text import text
from ..formula.tree import Call, Formula, Number, Power, Sum
from ..formula.walk import symbols, walk
from .steps import Function, formulas_of, names_in, names_of, sides_of


def broken_promises(function: Function) -> list[str]:
    """Return a sentence for each promise of this folder that a function breaks."""
    return [*_open_names(function), *_idle_inputs(function), *_repeated(function)]


def _formulas(function: Function) -> list[Formula]:
    return [*(f for step in function.steps for f in formulas_of(step)), function.output]


def _compared(function: Function) -> list[Formula]:
    return list(sides_of(function.guards))


def _open_names(function: Function) -> Iterator[str]:
    known = {i.name for i in function.inputs}
    for step in function.steps:
        names, used = names_of(step), names_in(formulas_of(step))
        yield from (f"{', '.join(names)} uses {n} too early" for n in used - known)
        yield from (f"{name} means two things" for name in names if name in known)
        known.update(names)
    for formula in (function.output, *_compared(function)):
        yield from (f"{n} is not defined" for n in names_in([formula]) - known)


def _idle_inputs(function: Function) -> Iterator[str]:
    formulas = [*_formulas(function), *_compared(function)]
    used = names_in(formulas)
    yield from (f"input {i.name} is not used" for i in function.inputs if i.name not in used)


def _repeated(function: Function) -> Iterator[str]:
    parts = [part for formula in _formulas(function) for part in walk(formula)]
    counted = Counter(part for part in parts if isinstance(part, Call | Sum) and symbols(part))
    yield from (f"{text(part)} is computed twice" for part, n in counted.items() if n > 1)
    for part in parts:
        if isinstance(part, Power) and _is_small(part.exponent) and symbols(part):
            yield f"{text(part)} is no product"


def _is_small(exponent: Formula) -> bool:
    return isinstance(exponent, Number) and exponent.value.denominator == 1 and exponent.value != -1
