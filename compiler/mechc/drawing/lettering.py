"""Formulas and names as they are lettered: Greek letters, indices, no signs of multiplication."""

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import groupby

from ..base.later import pattern
from ..formula.names import (
    GREEK,
    JointForceName,
    split_force,
    split_name,
    split_points,
    split_ratio,
)
from ..units import LENGTH, UNITS
from .drawing import TextRun
from .tolerances import ONE

SIZE = 3.9
"""The height of letters' body, in millimetres."""

INDEX_SIZE = 0.7
"""The size of an index to that of its letter."""

SMALLER = 0.55
"""The size of an index of an index."""

_TOKEN = pattern(r"\s*([A-Za-zµμ][A-Za-z0-9_']*|[0-9.]+|\S)")
_OF_ONE = pattern(r"(\b(?:sin|cos|tan|cot|sec|csc))\((?=[A-Za-z])([A-Za-z0-9_']+)\)")
_WHOLE_TIMES = pattern(r"(?<![\w.])([0-9]+)\*(?=[A-Za-z])")
_THIN, _MINUS, _CLOSE = "\u2009", "−", "&"
_SIGNS = {"*": _THIN, "~": _THIN, "-": _MINUS, ",": ", ", _CLOSE: ""}
_UNITS = {unit: f"{_THIN}{unit}" for unit, u in UNITS.items() if u.dimension == LENGTH}
_UNITS["deg"] = "°"
_FUNCTIONS = frozenset(
    [
        "sin",
        "cos",
        "tan",
        "cot",
        "sec",
        "csc",
        "asin",
        "acos",
        "atan",
        "atan2",
        "hypot",
        "abs",
        "min",
        "max",
        "exp",
        "log",
    ]
)
_WIDE, _NARROW = frozenset("mwMWΩ"), frozenset("ijlftrI.,:;'()[]|/ ")


def name(written: str) -> tuple[TextRun, ...]:
    """Return a point or a quantity as it is lettered, points and letters of an index in italics.

    >>> [run.text for run in name("O1'")], [run.text for run in name("alpha_max")]
    (["O'", '1'], ['α', 'max'])
    >>> [(run.text, run.italic, run.level) for run in name("R_O1_x")[1:]]
    [('O', True, -1), ('1', False, -2), (',', False, -1), ('x', True, -1)]
    >>> [run.text for run in name("M_over_F")], [run.text for run in name("len_AB")]
    (['M', '/', 'F'], ['A', 'B'])
    """
    above, *below = (tuple(_one(n)) for n in split_ratio(written))
    return (*above, *(run for part in below for run in (TextRun("/"), *part)))


def times(count: float, written: str) -> tuple[TextRun, ...]:
    """Return a load's name after how often it acts.

    >>> [run.text for run in times(2.0, "P")], [run.text for run in times(1 / 3, "P")]
    (['2', 'P'], ['P', '/3'])
    """
    exact = Fraction(count).limit_denominator(1000)
    above = (TextRun(f"{exact.numerator}"),) if exact.numerator != 1 else ()
    below = (TextRun(f"/{exact.denominator}"),) if exact.denominator != 1 else ()
    return (*above, *name(written), *below)


def _one(written: str) -> Iterator[TextRun]:
    if split_points(written.removeprefix("len_")):
        yield from _points(written.removeprefix("len_"))
    elif force := split_force(written):
        yield from _force(force)
    else:
        yield from _quantity(written)


def _force(force: JointForceName) -> Iterator[TextRun]:
    """Yield a force with its link above, its direction as an angle."""
    if force.is_direction:
        yield TextRun(GREEK["phi"], italic=True)
        yield from lowered(_quantity(force.name))
    else:
        yield from _quantity(force.name)
    if force.link:
        yield from (run._replace(level=1) for run in _points(force.link))


def _points(written: str) -> Iterator[TextRun]:
    for letter, number, primes in split_points(written):
        yield TextRun(letter + primes, italic=True)
        if number:
            yield TextRun(number, level=-1)


def _quantity(written: str) -> Iterator[TextRun]:
    head, primes, indices = split_name(written)
    yield TextRun(GREEK.get(head, head) + primes, italic=True)
    yield from enumerated(map(_index, indices))


def _index(written: str) -> tuple[TextRun, ...]:
    """Return one index: points, a letter, a number, a word."""
    if split_points(written):
        return tuple(_points(written))
    head, primes, numbers = split_name(written)
    letter = TextRun(GREEK.get(head, head) + primes, italic=head in GREEK or len(head) == 1)
    return (
        (TextRun(written),)
        if written.isdigit()
        else (letter, *(TextRun(n, level=-1) for n in numbers))
    )


def enumerated(parts: Iterable[Iterable[TextRun]]) -> tuple[TextRun, ...]:
    """Return text as one index, commas between its parts."""
    runs: list[TextRun] = []
    for part in parts:
        runs += [*([TextRun(",")] if runs else []), *part]
    return lowered(_joined(runs))


def lowered(runs: Iterable[TextRun]) -> tuple[TextRun, ...]:
    """Return text as an index."""
    return tuple(run._replace(level=run.level - 1) for run in runs)


def figures(value: float) -> str:
    """Return a number to three figures.

    >>> figures(-0.12345), figures(1234.5), figures(2.0), figures(1.5e-7)
    ('−0.123', '1230', '2', '1.5e−07')
    """
    written = f"{value:.3g}"
    if 1e3 <= abs(value) < 1e6:
        written = f"{round(value, 2 - math.floor(math.log10(abs(value)))):.0f}"
    return written.replace("-", "−")


def measured(value: float, of_another: bool = False) -> tuple[TextRun, ...]:
    """Return that something is a number, to three figures, as it stands before a unit.

    Before the name of another quantity, 1 is not written, and what is nearly 1 has its figures.

    >>> [run.text for run in measured(2.5e-7)], [run.text for run in measured(1.0, of_another=True)]
    ([' = 2.5 · 10', '−7', ' '], [' = '])
    >>> measured(1.002, of_another=True)[0].text
    ' = 1.00\u2009'
    """
    if of_another and math.isclose(value, 1.0, rel_tol=ONE):
        return (TextRun(" = "),)
    digits, _, power = figures(value).partition("e")
    if not power:
        nearly = of_another and digits == "1"
        return (TextRun(f" = {'1.00' if nearly else digits}{_THIN}"),)
    exponent = str(int(power.replace(_MINUS, "-"))).replace("-", _MINUS)
    return TextRun(f" = {digits}{_THIN}·{_THIN}10"), TextRun(exponent, level=1), TextRun(_THIN)


def formula(text: str) -> tuple[TextRun, ...]:
    """Return a formula in the notation of the language as it is lettered.

    A whole number stands close to its letter: 2 N with a space would be two newtons.

    >>> [run.text for run in formula("2*l_A - 40 mm")]
    ['2', 'l', 'A', ' − 40\u2009mm']
    """
    spaced = _WHOLE_TIMES.sub(rf"\1{_CLOSE}", _OF_ONE.sub(r"\1~\2", text))
    return tuple(_joined(_runs(_TOKEN.findall(spaced))))


def _runs(tokens: list[str]) -> Iterator[TextRun]:
    """Yield the runs of text of a formula: names in italics, powers raised."""
    level = 0
    for before, token in zip(["", *tokens], tokens, strict=False):
        if token == "^":
            level = 1
            continue
        if token in _UNITS and before[-1:].isdigit():
            yield TextRun(_UNITS[token])
        elif token == "pi" or token in _FUNCTIONS:
            yield TextRun("π" if token == "pi" else token, level=level)
        elif token[0].isalpha() and token != "sqrt":
            yield from (run._replace(level=run.level or level) for run in name(token))
        else:
            yield TextRun(_sign(token, before), level=level)
        level = 0


def _sign(token: str, before: str) -> str:
    """Return a number or a sign; one of a sum stands between spaces."""
    if token in "+-" and before not in ("", "(", "^"):
        return f" {_SIGNS.get(token, token)} "
    return "√" if token == "sqrt" else _SIGNS.get(token, token)


def _joined(runs: Iterable[TextRun]) -> Iterator[TextRun]:
    """Yield runs of the same type as one."""
    for _, group in groupby(runs, key=lambda run: (run.italic, run.level)):
        first, *others = group
        yield first._replace(text="".join(run.text for run in (first, *others)))


def text_size(runs: tuple[TextRun, ...], size: float) -> tuple[float, float]:
    """Return the width and the height of text, on the safe side in every usual type."""
    width = sum(_width(c) * (INDEX_SIZE if r.level else 1.0) for r in runs for c in r.text)
    height = 0.95 + 0.2 * any(r.level for r in runs)
    return size * (width + 0.1), size * height


def _width(character: str) -> float:
    if character in _NARROW or character == _THIN:
        return 0.36
    if character in _WIDE:
        return 0.9
    return 0.75 if character.isupper() else 0.56
