"""How C is written: formulas, heads of functions, comments."""

from collections.abc import Iterable, Mapping
from typing import assert_never

from ...formula.choices import SIGNS, equal_within
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
            gap, slack = map(printer.print, equal_within(guard.left, guard.right))
            return f"mechc_if_no_more({gap}, {slack}, {output})"
        case "!=":
            return f"mechc_if_apart({left}, {right}, {output})"
        case _:
            assert_never(guard.operator)


LONGEST_LINE = 100


def wrapped(head: str, arguments: list[str], indent: str = "    ") -> str:
    """Return a function's head, or a call, on one line or with one argument on each."""
    line = f"{head}{', '.join(arguments)})"
    if len(indent) - 4 + len(line) <= LONGEST_LINE:
        return line
    return f"{head}\n{indent}" + f",\n{indent}".join(arguments) + ")"


def harmless(words: str) -> str:
    """Return text that neither ends a comment nor starts one, a trigraph or a spliced line.

    >>> harmless("a */ b ??/")
    'a * / b ? ?/'
    """
    words = words.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
    return f"{words} ." if words.endswith("\\") else words


def broken(sign: str, parts: list[str]) -> str:
    """Return parts joined by a sign on one line, or with one part on each."""
    line = sign.join(parts)
    return line if len(line) <= LONGEST_LINE - 14 else f"\n        {sign.lstrip()}".join(parts)
