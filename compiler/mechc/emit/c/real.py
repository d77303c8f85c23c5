"""The type of C's real numbers: ``double``, or ``float`` for processors that have no other.

Code is written with ``double`` throughout and put into single precision word by word: types,
literals and the functions of ``math.h`` change, comments and names do not.
"""

import re

from ...base.later import pattern
from ...base.named import NamedTuple
from ...diagnostics import emission as messages
from ...diagnostics.diagnostic import MechcError
from ...formula.numeric import arcs, newton


class Real(NamedTuple):
    """A type of real numbers, as far as the templates depend on it.

    ``bits`` is the unsigned type of the same width, ``top`` the place of the sign in it,
    ``infinity`` and ``size`` are the bits of infinity and of all but the sign. ``tiny``,
    ``rounding``, ``least`` and ``sharp`` are for this type what they are in
    :mod:`~mechc.formula.numeric.newton` and :mod:`~mechc.formula.numeric.arcs` for ``double``;
    only code that solves equations needs them.
    """

    name: str
    bits: str
    top: int
    infinity: str
    size: str

    @property
    def tiny(self) -> float:
        """Return the correction behind which no other is needed.

        One of 3e-4 leaves some 1e-7, which is the rounding of ``float``.
        """
        return 3e-4 if self is FLOAT else newton.TINY

    @property
    def rounding(self) -> float:
        """Return the expected correction below which none is needed."""
        return 1e-8 if self is FLOAT else newton.NEGLIGIBLE_CORRECTION

    @property
    def least(self) -> float:
        """Return the length of an arc below which it leads nowhere."""
        return 2.0**-10 if self is FLOAT else arcs.LEAST

    @property
    def sharp(self) -> float:
        """Return the length of an arc that may lead round a corner behind which the share falls."""
        return 2.0**-8 if self is FLOAT else arcs.SHARP


DOUBLE = Real(
    name="double",
    bits="uint64_t",
    top=63,
    infinity="0x7ff0000000000000u",
    size="0x7fffffffffffffffu",
)
FLOAT = Real(
    name="float",
    bits="uint32_t",
    top=31,
    infinity="0x7f800000u",
    size="0x7fffffffu",
)

REALS = {real.name: real for real in (DOUBLE, FLOAT)}

OF_ROUNDING = {
    "1e+60": "1e+36",
    "70368744177664.0": "1e+8",
    "1099511627776.0": "1e+5",
    "1073741824.0": "1e+5",
}
"""Numbers that stand for the rounding of ``double``, and those that do so for ``float``.

They keep a friction circle's root off zero, 1/(10^30)^2, and friction from being solved where
rounding decides, 1/:data:`~mechc.friction.coupled.TOO_LARGE`: where forces of 1e4 times their
sum cancel, ``float`` leaves three digits. A slip has no sense below
:data:`~mechc.formula.choices.SENSELESS` of its size, 1e-5 there, and by
:data:`~mechc.formula.choices.EQUAL`, 1e-5 too, equal sides may differ.
"""
_LARGEST, _LEAST = 3.4e38, 1.2e-38
"""The largest number of ``float``, and the least that has all of its digits."""

_FUNCTIONS = """
    sin cos tan asin acos atan atan2 sqrt hypot fabs exp log pow fmin fmax floor
"""
_SINGLE = {name: f"{name}f" for name in _FUNCTIONS.split()}
_WORDS = {"double": "float", "HUGE_VAL": "HUGE_VALF"}
_TOKEN = pattern(
    r"(?P<kept>/\*.*?\*/|\"[^\"\n]*\"|0[xX][0-9a-fA-F]+)"
    r"|(?P<number>(?:\d+\.\d*|\.\d+)(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+)"
    r"|(?P<word>[A-Za-z_]\w*)(?P<called>\()?",
    re.DOTALL,
)


def named(name: str) -> Real:
    """Return a type by its name; LookupError where there is none."""
    if name not in REALS:
        raise LookupError(f"no type is called {name!r}; there are {', '.join(REALS)}")
    return REALS[name]


def in_single_precision(code: str) -> str:
    """Return C that was written for ``double``, for ``float``.

    Raises:
        MechcError: for a number that ``float`` does not hold (E705).

    >>> in_single_precision("const double s = 2.0*sqrt(x) + y_2; /* a double */")
    'const float s = 2.0f*sqrtf(x) + y_2; /* a double */'
    """
    return _TOKEN.sub(_single, code)


def _single(token: re.Match[str]) -> str:
    if token["number"]:
        return f"{_held(token['number'])}f"
    word, called = token["word"], token["called"] or ""
    if word is None:
        return token[0]
    renamed = _SINGLE if called else _WORDS
    return f"{renamed.get(word, word)}{called}"


def _held(number: str) -> str:
    number = OF_ROUNDING.get(number, number)
    if float(number) > _LARGEST or 0.0 < float(number) < _LEAST:
        raise MechcError([messages.beyond_single_precision(number)])
    return number
