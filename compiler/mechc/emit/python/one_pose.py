"""Functions of a routine on floats, made in memory: for one pose arrays cost more than formulas."""

import math
from collections.abc import Callable, Iterator, Mapping

from ...formula.functions import FUNCTIONS
from ...routine.steps import Function, Solve, Step, names_of
from ..names import Names, Reserved, mangle
from ..printer import Printer
from .printer import KEYWORDS

OnFloats = Callable[..., float]
ERRORS = (ArithmeticError, ValueError)
"""What such a function raises where NumPy has NaN or an infinity."""


class FloatPrinter(Printer):
    """Prints for floats; the functions that it calls begin with an underscore, as no name does."""

    pi = repr(math.pi)

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of one of the functions beside."""
        return f"_{function}({', '.join(arguments)})"

    def power(self, base: str, exponent: str) -> str:
        """Return a call of ``math.pow``, which never is complex."""
        return f"_pow({base}, {exponent})"


def on_floats(function: Function) -> OnFloats | None:
    """Return a result as a function of floats in the order of its inputs; None where it iterates.

    It raises one of :data:`ERRORS` where a step has no finite value, and is NaN where a
    condition fails.
    """
    if function.common or any(isinstance(step, Solve) for step in function.steps):
        return None
    names = (*(i.name for i in function.inputs), *(n for s in function.steps for n in names_of(s)))
    printer = FloatPrinter(mangle(names, Names(Reserved(KEYWORDS))))
    space = {f"_{name}": meaning for name, meaning in _BESIDE.items()}
    exec("\n".join(_lines(function, printer)), space)
    return space["_value"]


def _lines(function: Function, printer: FloatPrinter) -> Iterator[str]:
    yield f"def _value({', '.join(printer.names[i.name] for i in function.inputs)}):"
    for step in function.steps:
        assert isinstance(step, Step)
        yield f"    {printer.names[step.name]} = {printer.print(step.formula)}"
    for guard in function.guards:
        yield f"    if not {printer.condition(guard)}: return _nan()"
    yield f"    return {printer.print(function.output)}"


def _sign(x: float) -> float:
    return 1.0 if x > 0 else -1.0 if x < 0 else x


def _min(x: float, y: float) -> float:
    return x if x < y or x != x else y


def _max(x: float, y: float) -> float:
    return x if x > y or x != x else y


_BESIDE: Mapping[str, OnFloats] = {
    **FUNCTIONS,
    "pow": math.pow,
    "sign": _sign,
    "min": _min,
    "max": _max,
    "nan": lambda: math.nan,
}
"""What a function calls; signs, and what is less or more, keep NaN as arrays do."""
