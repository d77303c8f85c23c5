"""How C writes formulas and conditions, plainly or for loops that a compiler can vectorise."""

from typing import assert_never

from ...formula.choices import SIGNS
from ...routine.steps import Guard
from ..printer import Printer

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
    """Prints for loops: sine and cosine are polynomials that a compiler can vectorise."""

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call, of the inlined function where there is one."""
        if function in CIRCULAR:
            return f"mechc_{function}({arguments[0]})"
        return super().call(function, arguments)


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
