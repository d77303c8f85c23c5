"""How Python writes formulas, for NumPy."""

from ..printer import Printer

_WORDS = """
    False None True and as assert async await break class continue def del elif else except
    finally for from global if import in is lambda nonlocal not or pass raise return try while
    with yield match case type np float print abs all any bin bool bytes chr complex dict dir
    divmod eval exec filter format frozenset hash help hex id input int iter len list map max
    min next object oct open ord pow range repr reversed round set slice sorted str sum super
    tuple vars zip main
"""
RESERVED = frozenset(_WORDS.split())
"""Keywords, the built-ins that a drawing might name, and what the template itself uses."""

_FUNCTIONS = {
    "asin": "np.arcsin",
    "acos": "np.arccos",
    "atan": "np.arctan",
    "atan2": "np.arctan2",
    "min": "np.minimum",
    "max": "np.maximum",
}


class PythonPrinter(Printer):
    """Prints for NumPy."""

    pi = "np.pi"

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of a NumPy function."""
        return f"{_FUNCTIONS.get(function, f'np.{function}')}({', '.join(arguments)})"

    def power(self, base: str, exponent: str) -> str:
        """Return ``np.power``, which gives NaN where ``**`` on floats would be complex."""
        return f"np.power({base}, {exponent})"
