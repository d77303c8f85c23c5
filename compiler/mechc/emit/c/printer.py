"""How C writes formulas and conditions, plainly or for loops that a compiler can vectorise."""

from typing import assert_never

from ...routine.steps import Guard
from ..printer import Printer

_WORDS = """
    auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef
    union unsigned void volatile while _Bool _Complex _Imaginary bool true false complex
    imaginary I alignas alignof asm atomic_cancel atomic_commit atomic_noexcept and and_eq
    bitand bitor catch char8_t char16_t char32_t class co_await co_return co_yield compl concept
    const_cast consteval constexpr constinit decltype delete dynamic_cast explicit export friend
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public
    reflexpr reinterpret_cast requires static_assert static_cast synchronized template this
    thread_local throw try typeid typename typeof typeof_unqual using virtual wchar_t xor xor_eq
    sin cos tan asin acos atan atan2 sqrt hypot fabs exp log pow abs fmin fmax
    size_t ptrdiff_t NULL NAN INFINITY HUGE_VAL EOF errno assert offsetof main
    near far min max small interface unix linux stdin stdout stderr
"""
RESERVED = frozenset(_WORDS.split())
"""Keywords of C and C++, the functions called, and what common headers define as macros."""

_FUNCTIONS = {"abs": "fabs", "sign": "mechc_sign", "min": "mechc_min", "max": "mechc_max"}
CIRCULAR = ("sin", "cos", "tan")
"""Functions that the loops compute by a polynomial of their own."""


class CPrinter(Printer):
    """Prints for C99."""

    pi = "MECHC_PI"

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of ``math.h``."""
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
