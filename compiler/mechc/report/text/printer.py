"""Formulas for the terminal, on one line.

>>> from .character_sets import ASCII, UNICODE
>>> from ...formula.tree import Call, Sum, Symbol, number, product
>>> a, b, alpha, theta = map(Symbol, ("a", "b", "alpha", "theta"))
>>> k = product(
...     [(number(2), 1), (b, 1), (a, -1), (Call("cos", (alpha,)), 1)]
...     + [(Call("sin", (theta,)), 1), (Call("cos", (Sum((alpha, theta)),)), -1)]
... )
>>> print_formula(k, UNICODE)
'2b/a · cos α · sin θ / cos(α + θ)'
>>> print_formula(k, ASCII)
'2*b/a * cos(alpha) * sin(theta) / cos(alpha + theta)'
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise

from ...base.later import pattern
from ...formula.layout import SIZES, TRIGONOMETRIC, decimal, letter_of
from ...formula.names import (
    GREEK,
    MadeRatio,
    corner_of,
    split_force,
    split_made_ratio,
    split_name,
    words_in,
)
from ...formula.tree import ZERO, Formula, Number, Pi, Power, Symbol
from ...formula.typesetting import FormulaRow, Surroundings, Typesetter
from .character_sets import RAISED, TextSigns, tens

_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")

_POWER = pattern(r"\^(\d+)")

_RECIPROCAL = pattern(r" 1/(\w+)(?:\^(\d+))?$")
"""A reciprocal unit behind its number: ``1/m``."""

_WORD = pattern(r"[\w.°₀-₉]+")
"""An argument that needs no parentheses: a letter with its indices, a multiple, a number."""

_MEASURED = pattern(r"[−-]?\d[\d.,·*^⁰¹²³⁴-⁹⁻+−-]* \S+")
"""A number and its unit: ``5 kN``."""

_NUMBERED = pattern(r"(?<=[A-Z])_(?=\d)")
"""What stands between a point and its number: ``W_0``."""

_TENS = pattern(r"(\d[·*])?10[\^⁰¹²³⁴-⁹⁻]")
"""A power of ten, behind its figures if there are any."""

_INVERSE = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}


def print_formula(formula: Formula, signs: TextSigns, angle: bool = False) -> str:
    """Return a formula on one line; one that is an angle has its constants in degrees."""
    return _Terminal(signs).whole(formula, angle)


def print_side(formula: Formula, signs: TextSigns, angle: bool) -> str:
    """Return a side of a relation: a number alone is a decimal, an angle in degrees, if it can be.

    >>> from .character_sets import UNICODE
    >>> print_side(Number(Fraction(3, 4)), UNICODE, False), print_side(ZERO, UNICODE, True)
    ('0.75', '0°')
    """
    if angle and formula == ZERO:
        return _Terminal(signs).degrees("0")
    if isinstance(formula, Number) and not angle:
        return _Terminal(signs).number(formula.value, decimal(formula.value), Surroundings.SUM)
    return print_formula(formula, signs, angle)


def print_name(name: str, signs: TextSigns) -> str:
    """Return a quantity's name.

    >>> from .character_sets import UNICODE
    >>> print_name("R_O_direction_f", UNICODE)
    'φ_R_O_f'
    >>> [print_name(name, UNICODE) for name in ("alpha_1", "omega_O1B", "len_O1B", "turn_ABC")]
    ['α₁', 'ω_O₁B', 'O₁B', '∠ABC']
    >>> [print_name(name, UNICODE) for name in ("y_Q_0", "V_W_0", "l_1_2", "d_max_2")]
    ['y_Q₀', 'V_W₀', 'l₁,₂', 'd_max₂']
    >>> [print_name(name, UNICODE) for name in ("M_over_F", "V_D_over_F_f1", "eta_M_over_F")]
    ['(M/F)', '(V_D/F)_f₁', 'η_(M/F)']
    """
    corner = "" if name in signs.own else corner_of(name)
    if not signs.fancy:
        return f"angle_{corner}" if corner else name
    if corner:
        return f"∠{print_point(corner, signs)}"
    if name.startswith("len_"):
        return print_point(name.removeprefix("len_"), signs)
    if (force := split_force(name)) and force.is_direction and name not in signs.own:
        return f"{GREEK['phi']}_{print_name(force.name, signs)}"
    if name not in signs.own and (ratio := split_made_ratio(name)):
        return _print_ratio(ratio, signs)
    head, primes, indices = split_name(_called(name, signs.texts))
    words = {**GREEK, **{w: signs.texts[w] for w in words_in(name) if w in signs.texts}}
    letter = words.get(head, head) + primes
    words = words if name in signs.own else {**words, **signs.subscripts}
    return letter + "".join(
        _between(before, index) + (words.get(index) or print_point(index, signs))
        for before, index in pairwise(("", *indices))
    )


def _print_ratio(ratio: MadeRatio, signs: TextSigns) -> str:
    """Return the name of a ratio that has none: of its loads, with the index of its friction."""
    whole = f"({print_name(ratio.above, signs)}/{print_name(ratio.below, signs)})"
    if ratio.is_efficiency:
        return f"{GREEK['eta']}_{whole}"
    index = f"k_{ratio.ending}" if ratio.ending else "k"
    return whole + print_name(index, signs).removeprefix("k")


def _between(before: str, index: str) -> str:
    """Return the sign before an index: none before a number, which is lowered."""
    if not index.isdigit():
        return "_"
    return "," if before.isdigit() else ""


def _called(name: str, texts: Mapping[str, str]) -> str:
    """Return a name as texts have it, or with the prefix as they have it.

    >>> texts = {"F_C": "F_з", "rod_pin": "вісь"}
    >>> _called("F_C", texts), _called("rod_pin_d_min", texts), _called("F_D", texts)
    ('F_з', 'вісь_d_min', 'F_D')
    """
    if name in texts:
        return texts[name]
    prefix = max((t for t in texts if name.startswith(f"{t}_")), key=len, default="")
    return texts[prefix] + name.removeprefix(prefix) if "_" in prefix else name


def print_quantity(quantity: str, signs: TextSigns) -> str:
    """Return a number with its unit.

    >>> from .character_sets import UNICODE
    >>> print_quantity("-14.8 N*m", UNICODE), print_quantity("12 mm^3", UNICODE)
    ('−14.8 N·m', '12 mm³')
    >>> print_quantity("25 1/m", UNICODE), print_quantity("25 1/m^2", UNICODE)
    ('25 m⁻¹', '25 m⁻²')
    >>> print_quantity("1.5e-05 m^2", UNICODE)
    '1.5·10⁻⁵ m²'
    """
    written = tens(quantity, signs).replace(" deg", signs.degree).replace("-", signs.minus)
    if not signs.fancy:
        return written
    written = _RECIPROCAL.sub(lambda m: f" {m[1]}{f'-{m[2] or 1}'.translate(RAISED)}", written)
    raised = _POWER.sub(lambda power: power[1].translate(RAISED), written)
    return raised.replace("*", "·")


def print_point(name: str, signs: TextSigns) -> str:
    """Return a point, a link or an index, its numbers lowered.

    >>> from .character_sets import UNICODE
    >>> print_point("W_0W", UNICODE)
    'W₀W'
    """
    return _NUMBERED.sub("", name).translate(_LOWERED) if signs.fancy else name


class _Terminal(Typesetter[str]):
    """Sets formulas as text on one line."""

    built = False

    def __init__(self, signs: TextSigns) -> None:
        self.signs, self.raised, self.angles = signs, signs.fancy, signs.angles

    def numeral(self, figures: str) -> str:
        return figures.replace("-", self.signs.minus)

    def ratio(self, value: Fraction) -> str:
        return self.numeral(str(value))

    def degrees(self, number: str) -> str:
        return number + self.signs.degree

    def pi(self) -> str:
        return self.signs.pi

    def name(self, name: str) -> str:
        quantity = name[0] in "0123456789.-("
        return print_quantity(name, self.signs) if quantity else print_name(name, self.signs)

    def parentheses(self, inner: str) -> str:
        return f"({inner})"

    def minus(self, piece: str) -> str:
        return self.signs.minus + piece

    def joined(self, term: str) -> str:
        if term.startswith(self.signs.minus):
            return f" {self.signs.minus} {term.removeprefix(self.signs.minus)}"
        return f" + {term}"

    def row(self, pieces: Sequence[str]) -> str:
        return "".join(pieces)

    def factors(self, formulas: FormulaRow, pieces: Sequence[str]) -> str:
        """Return factors side by side, letters close together and functions apart."""
        line = pieces[0]
        for (before, factor), piece in zip(pairwise(formulas), pieces[1:], strict=True):
            close = _is_letter(before) and _is_letter(factor) and not _is_apart(before, factor)
            close = close or (isinstance(before, Number) and _is_named_letter(factor))
            line += (self.signs.joint if close else self.signs.times) + piece
        return line

    def over(self, above: str, below: str, several: bool) -> str:
        """Return a quotient on one line: ``F / (5 kN)``, as ``F / 5 kN`` can be read as kN, too.

        So is what has a power of ten: ``1 / (2·10⁶)``.
        """
        sign = " / " if " " in above + below else "/"
        is_enclosed = several or _MEASURED.fullmatch(below) or _TENS.match(below)
        return f"{above}{sign}({below})" if is_enclosed else f"{above}{sign}{below}"

    def beside(self, first: str, second: str) -> str:
        return first + self.signs.times + second

    def scaled(self, lead: str, rest: str) -> str:
        return lead + self.signs.times + rest

    def power(self, base: str, exponent: str) -> str:
        if self.signs.fancy and exponent.isdigit():
            return base + exponent.translate(RAISED)
        return f"{base}^{exponent}"

    def holds(self, call: str) -> bool:
        return call.endswith((")", "|"))

    def root(self, inner: str) -> str:
        if not self.signs.fancy:
            return f"sqrt({inner})"
        return f"√{inner}" if inner.isdigit() else f"√({inner})"

    def absolute(self, inner: str) -> str:
        return f"|{inner}|" if self.signs.fancy else f"abs({inner})"

    def applied(self, function: str, exponent: str, argument: Formula, inner: str) -> str:
        """Return a function of one argument, ``cos α`` without parentheses."""
        word = self._word(function) + exponent.translate(RAISED)
        is_trigonometric = self.signs.fancy and function in TRIGONOMETRIC
        bare = is_trigonometric and _WORD.fullmatch(inner) is not None
        return f"{word} {inner}" if bare else f"{word}({inner})"

    def called(self, function: str, arguments: Sequence[str]) -> str:
        return f"{self._word(function)}({self.signs.between.join(arguments)})"

    def joined_by(self, sign: str, pieces: Sequence[str]) -> str:
        spaced = ", " if sign == "," else f" {self.signs.relations.get(sign, sign)} "
        return spaced.join(pieces)

    def cases(self, rows: Sequence[tuple[str, str]], other: str | None) -> str:
        """Return the cases on one line; after those before it each is meant where none of them."""
        case = self.signs.choices["case"]
        shown = [case.format(value=value, condition=condition) for value, condition in rows]
        last = [self.signs.choices["other"].format(value=other)] if other else []
        return "; ".join([*shown, *last])

    def solution(self, unknown: str, zeros: Sequence[str]) -> str:
        equal = ", ".join(f"{zero} = 0" for zero in zeros)
        return f"{self.name(unknown)}: {equal}"

    def _word(self, function: str) -> str:
        usual = _INVERSE.get(function, function) if self.signs.fancy else function
        return self.signs.functions.get(function, usual)


DIFFERENTIAL = "d"
"""A letter that makes another sign of the next one: ``d·f``, as ``df`` is a differential."""


def _is_apart(before: Formula, factor: Formula) -> bool:
    """Return whether a dot keeps letters from being one sign, ``d·f``, or stands by habit, ``f·d``.

    The latter is a coefficient of friction by a diameter or a radius.
    """
    name = before.name if isinstance(before, Symbol) else ""
    size = letter_of(factor.base if isinstance(factor, Power) else factor)
    return name == DIFFERENTIAL or (name == "f" and size != "" and size in SIZES)


def _is_named_letter(factor: Formula) -> bool:
    """Return whether a factor is a letter with indices, behind which a multiple ends: ``2φ_AB``."""
    if not isinstance(factor, Symbol) or factor.name[0].isdigit():
        return False
    head, _, indices = split_name(factor.name)
    return (head in GREEK or len(head) == 1) and bool(indices)


def _is_letter(factor: Formula) -> bool:
    """Return whether a factor may stand close: a number, a letter, a letter's power.

    A number as it is written, ``5 mm``, may not: behind another one it would be read with it.
    """
    base = factor.base if isinstance(factor, Power) else factor
    if isinstance(base, Symbol):
        if base.name[0].isdigit():
            return False
        head, _, indices = split_name(base.name)
        return (head in GREEK or len(head) == 1) and all(map(str.isdigit, indices))
    return isinstance(base, Number | Pi)
