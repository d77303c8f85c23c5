"""Functions, their twins, and the shape of names: what both notations agree on."""

import re

from ..base.later import pattern
from ..base.named import NamedTuple

GROUND = "ground"
"""What a wheel is fixed to that is fast in the ground."""


METHODS = ("power", "equilibrium")
"""How a derivation finds loads: by virtual power, or by the equilibrium of free bodies."""

LANGUAGES = ("en", "uk", "ru")
"""The languages that texts may be translated into: those of reports."""


class Arity(NamedTuple):
    """How many arguments a function takes; ``most`` None means any number."""

    least: int
    most: int | None


ONE, TWO, SEVERAL = Arity(1, 1), Arity(2, 2), Arity(2, None)

FUNCTIONS: dict[str, Arity] = {
    "sin": ONE,
    "cos": ONE,
    "tan": ONE,
    "cot": ONE,
    "sec": ONE,
    "csc": ONE,
    "asin": ONE,
    "acos": ONE,
    "atan": ONE,
    "atan2": TWO,
    "sqrt": ONE,
    "hypot": SEVERAL,
    "abs": ONE,
    "min": SEVERAL,
    "max": SEVERAL,
    "exp": ONE,
    "log": ONE,
}
"""The functions of the language by their canonical names."""

TWINS = {
    "tg": "tan",
    "ctg": "cot",
    "cosec": "csc",
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctg": "atan",
    "arctan2": "atan2",
    "ln": "log",
}
"""Other spellings, read as the function on the right."""

RANGE = "a range has two dots: in LOW .. HIGH"
"""What is said where ``in`` is followed by what is no range."""

DIAMETER = "of a pin the diameter is given: friction pins 0.1 diameter 10 mm"

ROUTE = 'in YAML each rope is one text in quotes: ropes: ["A, K along -y, B along y"]'
"""What is said of a rope whose points are parted by the commas of a list."""

WRAP = "what slides around a drum is a rope: friction rope O 0.2 wrap 180 deg"

OF_A_PIN = ("radius", "r", "R", "d", "D", "dia", "diam")
"""What people write behind the coefficient of a pin, in place of ``diameter``."""

FIT = "a fit is no part of a value: its deviations are a tolerance, 10 mm +- 0.01 mm"

FIT_OF_A_HOLE = pattern(r"(?:[A-HJ-NP-Z]|[a-hj-np-z]|JS|js)\d{1,2}")
"""A fit of ISO 286 behind a number, as in ``10H7``."""


def reads_as_value(text: str) -> bool:
    """Return whether a text is a number with a unit, or a number.

    >>> reads_as_value("200 mm"), reads_as_value("lever 2"), reads_as_value("")
    (True, False, False)
    """
    return _VALUE.fullmatch(text) is not None


_VALUE = pattern(r"\s*\d+(?:[.,]\d+)?\s*(?:[a-zµ]?m|in|ft)?\s*")

IN_A_UNIT = "`in` gives the unit of a `let` line; in YAML it is a key: {value: …, unit: mm^2}"

CHOICE = "a choice is written with 'when', as in 1.1 when v < 1 m/s else 1.3"
"""What is said where ``if`` follows a number."""

CONSTANTS = frozenset({"pi"})

POINT = pattern(r"[A-Z][0-9]*'*")
POINTS = pattern(r"(?:[A-Z][0-9]*'*)+")
NAME = pattern(r"[A-Za-z][A-Za-z0-9_']*")
QUANTITY = pattern(r"([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*(.*)", re.DOTALL)


def points_of(text: str) -> tuple[str, ...]:
    """Split a word into its points; empty if it is not made of points.

    >>> points_of("O1B2K'"), points_of("crank")
    (('O1', 'B2', "K'"), ())
    """
    return tuple(POINT.findall(text)) if POINTS.fullmatch(text) else ()


def of_used(text: str) -> tuple[str, str]:
    """Return the prefix and the points of what is used, '' and the text of any other name.

    >>> of_used("T.OB"), of_used("OB")
    (('T', 'OB'), ('', 'OB'))
    """
    prefix, dot, points = text.partition(".")
    return (prefix, points) if dot else ("", text)


def split_quantity(text: str) -> tuple[str, str]:
    """Return the digits and the unit of a number as it was read.

    >>> split_quantity("1e-3 N*m"), split_quantity("90")
    (('1e-3', 'N*m'), ('90', ''))
    """
    match = QUANTITY.fullmatch(text)
    assert match is not None
    return match[1], match[2]


def counted(arity: Arity) -> str:
    """Return how many arguments a function takes, in words.

    >>> counted(ONE), counted(SEVERAL)
    ('1 argument', '2 arguments or more')
    """
    words = "1 argument" if arity.least == 1 else f"{arity.least} arguments"
    return words if arity.most is not None else f"{words} or more"


BETWEEN_POINTS = " \t,;–-"
"""What may stand between points that are to be written together."""


def in_capitals(text: str) -> str:
    """Return a hint at up to three points that are written in small letters, not at a word.

    >>> in_capitals("k"), in_capitals("oba"), in_capitals("left")
    ('points have capital letters: K', 'points have capital letters: OBA', '')
    """
    capitals = text.upper()
    is_meant = 0 < len(points_of(capitals)) <= 3 and text != capitals
    return f"points have capital letters: {capitals}" if is_meant else ""


def apart(text: str, one_each: bool = False) -> str:
    """Return a hint at points that are not written together, or not in a list.

    >>> apart("O B"), apart("OB, BK"), apart("O at (0, 0)")
    ('points are written together: OB', 'a list stands in brackets: [OB, BK]', '')
    """
    if text.startswith("-") and points_of(text[1:]):
        return f"an entry of a list has a space behind its '-': - {text[1:]}"
    parts = [part for part in re.split(f"[{BETWEEN_POINTS}]+", text) if part]
    counts = [len(points_of(part)) for part in parts]
    if len(parts) < 2 or not all(counts):
        return ""
    if max(counts) == 1 and not one_each:
        return f"points are written together: {''.join(parts)}"
    return f"a list stands in brackets: [{', '.join(parts)}]"
