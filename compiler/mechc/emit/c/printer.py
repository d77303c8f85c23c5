"""How C writes formulas and conditions, plainly or for loops that a compiler can vectorise."""

from collections.abc import Iterable, Mapping
from typing import assert_never

from ...formula.choices import SIGNS
from ...formula.sharing import each_part
from ...formula.tree import Call, Formula
from ...routine.steps import Guard
from ..printer import Level, Printer

_FUNCTIONS = {"abs": "fabs", "sign": "mechc_sign", "min": "mechc_min", "max": "mechc_max"} | {
    name: f"mechc_{name}" for name in (*SIGNS, "choose")
}
CIRCULAR = ("sin", "cos", "tan")
"""Functions that the loops compute by a polynomial of their own."""


class CPrinter(Printer):
    """Prints for C99."""

    pi = "MECHC_PI"

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of ``math.h``."""
        if function == "choose" and len(arguments) == 2:
            arguments = [*arguments, "NAN"]
        return f"{_FUNCTIONS.get(function, function)}({', '.join(arguments)})"

    def power(self, base: str, exponent: str) -> str:
        """Return a call of ``pow``."""
        return f"pow({base}, {exponent})"


class QuickPrinter(CPrinter):
    """Prints for loops: sine and cosine are polynomials that a compiler can vectorise.

    Of an angle whose sine and cosine are both asked for in ``formulas``, they share the
    reduction of the angle, which is by quarters; one that stands alone needs one polynomial.
    """

    def __init__(self, names: Mapping[str, str], formulas: Iterable[Formula]) -> None:
        """Take the names of symbols, and all that is to be printed."""
        super().__init__(names)
        called = {p for p in each_part(formulas) if isinstance(p, Call)}
        sines, cosines = (
            {c.arguments for c in called if c.function == name} for name in ("sin", "cos")
        )
        self.paired = sines & cosines

    def _call(self, function: str, arguments: tuple[Formula, ...], level: Level) -> str:
        if function not in CIRCULAR:
            return super()._call(function, arguments, level)
        pair = "_of_pair" if arguments in self.paired else ""
        return f"mechc_{function}{pair}({self.print(arguments[0])})"


def guarded(guard: Guard, printer: Printer, output: str) -> str:
    """Return the output, or NaN where the guard fails, without a branch."""
    left, right = printer.print(guard.left), printer.print(guard.right)
    match guard.operator:
        case "<":
            return f"mechc_if_less({left}, {right}, {output})"
        case ">":
            return f"mechc_if_less({right}, {left}, {output})"
        case "<=":
            return f"mechc_if_no_more({left}, {right}, {output})"
        case ">=":
            return f"mechc_if_no_more({right}, {left}, {output})"
        case "=":
            above = f"mechc_if_no_more({right}, {left}, {output})"
            return f"mechc_if_no_more({left}, {right}, {above})"
        case "!=":
            return f"mechc_if_apart({left}, {right}, {output})"
        case _:
            assert_never(guard.operator)
