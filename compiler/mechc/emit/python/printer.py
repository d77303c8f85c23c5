"""How Python writes formulas, for NumPy."""

from ...formula.choices import SIGNS
from ...formula.tree import Formula, Product, Sum
from ...routine.quotient import quotient_of
from ..names import Reserved
from ..printer import Level, Printer

_KEYWORDS = """
    False None True and as assert async await break class continue def del elif else except
    finally for from global if import in is lambda nonlocal not or pass raise return try while
    with yield match case type
"""
_BUILT_IN = """
    abs aiter all anext any ascii bin bool breakpoint bytearray bytes callable chr classmethod
    compile complex copyright credits delattr dict dir divmod enumerate eval exec exit filter float
    format frozenset getattr globals hasattr hash help hex id input int isinstance issubclass iter
    len license list locals map max memoryview min next object oct open ord pow print property quit
    range repr reversed round set setattr slice sorted staticmethod str sum super tuple vars zip
"""
KEYWORDS = frozenset(_KEYWORDS.split())
RESERVED = Reserved([*KEYWORDS, *_BUILT_IN.split(), "np", "main", "DEFAULTS", "RANGES"])
"""Keywords, built-in functions, and what the template itself uses."""

_MODULES = """
    abc argparse array ast asyncio atexit base64 binascii bisect builtins bz2 calendar cmath codecs
    collections concurrent contextlib contextvars copy copyreg csv ctypes dataclasses datetime
    decimal difflib dis email encodings enum errno faulthandler fcntl fnmatch fractions functools gc
    genericpath getpass gettext glob grp gzip hashlib heapq hmac html http importlib inspect io
    ipaddress itertools json keyword linecache locale logging lzma marshal math mmap multiprocessing
    nt ntpath numbers numpy opcode operator os pathlib pickle pkgutil platform posix posixpath
    pprint pwd queue random re reprlib runpy secrets select selectors shlex shutil signal site
    socket sre_compile sre_constants sre_parse ssl stat statistics string struct subprocess sys
    sysconfig tempfile textwrap threading time token tokenize traceback tracemalloc types typing
    unittest urllib uuid warnings weakref zipfile zipimport zlib
"""
MODULES = frozenset(_MODULES.split())
"""The modules that Python and NumPy load: one of that name next to a script is loaded instead."""

_FUNCTIONS = {
    "asin": "np.arcsin",
    "acos": "np.arccos",
    "atan": "np.arctan",
    "atan2": "np.arctan2",
    "min": "np.minimum",
    "max": "np.maximum",
    **{name: f"_{name}" for name in (*SIGNS, "choose")},
}


class PythonPrinter(Printer):
    """Prints for NumPy."""

    pi = "np.pi"

    def print(self, formula: Formula, level: Level = Level.SUM) -> str:
        """Return a formula; a difference of two begins without a minus sign, one pass less."""
        match formula:
            case Sum((first, other)) if _is_negative(first) and not _is_negative(other):
                formula = Sum((other, first))
        return super().print(formula, level)

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of a NumPy function."""
        if function == "choose" and len(arguments) == 2:
            arguments = [*arguments, "np.nan"]
        return f"{_FUNCTIONS.get(function, f'np.{function}')}({', '.join(arguments)})"

    def power(self, base: str, exponent: str) -> str:
        """Return ``np.power``, which gives NaN where ``**`` on floats would be complex."""
        return f"np.power({base}, {exponent})"


def _is_negative(formula: Formula) -> bool:
    return isinstance(formula, Product) and quotient_of(formula).negative
