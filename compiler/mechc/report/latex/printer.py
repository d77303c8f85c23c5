r"""Formulas as LaTeX, as a textbook would set them.

Arms as one fraction and angles as another, ``\cos\alpha`` without parentheses,
constant angles in degrees. Every piece is a :class:`Box` that knows how wide it will
be, so that ``latex_display`` can break what no line would hold.

>>> from ...formula.tree import Symbol, quotient, number, product
>>> from .notation import notation
>>> a, b, alpha = Symbol("a"), Symbol("b"), Symbol("alpha")
>>> k = product([(number(2), 1), (b, 1), (a, -1), (Call("cot", (alpha,)), 1)])
>>> print(latex(k, notation("en")))
\frac{2b}{a}\cot\alpha
>>> print(latex(k, notation("uk")))
\frac{2b}{a}\operatorname{ctg}\alpha
"""

import re
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise

from ...base.later import pattern
from ...base.named import NamedTuple
from ...formula.layout import SIZES, TRIGONOMETRIC, in_degrees
from ...formula.tree import Call, Constant, Formula, Number, Pi, Power, Product, Symbol
from ...formula.typesetting import FormulaRow, Surroundings, Typesetter
from ...syntax.vocabulary import split_quantity
from .notation import LatexNotation, relation_sign
from .notation import name as name_of
from .unit_symbols import unit_symbol

EM_PER_GLYPH = 0.58
"""Mean width of an italic letter with its share of space, in em of the text font."""

EM_PER_CAPITAL = 0.18
"""By how much a capital letter is wider than that."""

EULER = r"\mathrm{e}"
"""The base of exponents, upright as standards set it: an eccentricity is an italic ``e``."""


class Box(NamedTuple):
    """A piece of mathematics: its LaTeX, its estimated width in em, whether it is tall.

    ``open`` is True for a function with a bare argument and for a distance ``OA``, behind
    which a letter would be read as part of them.
    """

    tex: str
    width: float
    tall: bool = False
    open: bool = False


def latex(formula: Formula, style: LatexNotation, angle: bool = False) -> str:
    """Return a formula as LaTeX mathematics, without delimiters."""
    return box(formula, style, angle).tex


def box(formula: Formula, style: LatexNotation, angle: bool = False) -> Box:
    """Set a formula; one that is an angle, or is said to be one, has constants in degrees."""
    return _Latex(style).whole(formula, angle)


def signed(term: Formula, style: LatexNotation, first: bool, angle: bool = False) -> Box:
    """Return a term of a sum with the sign that joins it to what stands before."""
    return _Latex(style).term(term, first, angle)


@lru_cache(maxsize=4096)
def plain(tex: str, tall: bool = False) -> Box:
    r"""Return a box for ready LaTeX, its width counted from what will be seen.

    >>> round(plain(r"\cos\alpha").width, 2)
    2.32
    """
    locale = re.sub(r"\\(?:sin|cos|tan|cot|sec|csc|ln|min|max)(?![a-z])", "xxx", tex)
    locale = re.sub(r"\\(?:operatorname|mathrm|mathit|left|right|,)", "", locale)
    locale = re.sub(r"\\arc([a-z]+)", r"arc\1", locale)
    glyphs = re.sub(r"[{}_^]", "", re.sub(r"\\[A-Za-z]+", "x", locale))
    capitals = sum(map(str.isupper, glyphs))
    return Box(tex, EM_PER_GLYPH * len(glyphs) + EM_PER_CAPITAL * capitals, tall)


def scientific(figures: str, style: LatexNotation) -> str:
    r"""Return a number with the language's decimal sign, a power of ten as one.

    >>> from .notation import notation
    >>> scientific("1.5e+06", notation("en")), scientific("-1e-07", notation("en"))
    ('1.5\\cdot 10^{6}', '-10^{-7}')
    """
    mantissa, _, exponent = figures.partition("e")
    digits = mantissa.replace(".", style.decimal)
    if not exponent:
        return digits
    sign = digits.removesuffix("1")
    lead = sign if sign in ("", "-") else rf"{digits}\cdot "
    return rf"{lead}10^{{{int(exponent)}}}"


def row(boxes: Iterable[Box]) -> Box:
    """Return boxes side by side."""
    parts = tuple(boxes)
    tex = ""
    for part in parts:
        glued = re.search(r"\\[A-Za-z]+$", tex) and re.match("[A-Za-z]", part.tex)
        tex += (" " if glued else "") + part.tex
    is_open = bool(parts) and parts[-1].open
    return Box(tex, sum(p.width for p in parts), any(p.tall for p in parts), is_open)


class _Latex(Typesetter[Box]):
    """Sets formulas as boxes of LaTeX."""

    built = True
    raised = True

    def __init__(self, style: LatexNotation) -> None:
        self.style, self.angles = style, style.angles

    def numeral(self, figures: str) -> Box:
        return plain(figures.replace(".", self.style.decimal))

    def ratio(self, value: Fraction) -> Box:
        sign = "-" if value < 0 else ""
        return plain(rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}", tall=True)

    def degrees(self, number: Box) -> Box:
        """Return a number with its degree sign, above the line of a fraction."""
        ends = number.tex.find("}") if number.tall else len(number.tex)
        whole = rf"{number.tex[:ends]}^\circ{number.tex[ends:]}"
        return number._replace(tex=whole, width=number.width + 0.4)

    def pi(self) -> Box:
        return plain(r"\pi")

    def name(self, name: str) -> Box:
        if name[0] in "0123456789.-(":
            return self._quantity(name)
        return plain(name_of(name, self.style))._replace(open=name.startswith("len_"))

    def _quantity(self, text: str) -> Box:
        """Return a number with its unit; what is next to it is a factor of its own."""
        inner = text.removeprefix("(").removesuffix(")")
        digits, unit = split_quantity(inner.removeprefix("-"))
        digits = "-" + digits if inner.startswith("-") else digits
        tex = scientific(digits.lower(), self.style) + unit_symbol(unit, self.style)
        return plain(f"({tex})" if inner != text else tex)._replace(open=bool(unit))

    def parentheses(self, inner: Box) -> Box:
        """Return a box in parentheses of its own height."""
        left, right = (r"\left(", r"\right)") if inner.tall else ("(", ")")
        return Box(left + inner.tex + right, inner.width + 0.9, inner.tall)

    def minus(self, piece: Box) -> Box:
        return row((plain("-"), piece))

    def joined(self, term: Box) -> Box:
        if term.tex.startswith("-"):
            return term
        return term._replace(tex="+" + term.tex, width=term.width + 1.2)

    def row(self, pieces: Sequence[Box]) -> Box:
        return row(pieces)

    def factors(self, formulas: FormulaRow, pieces: Sequence[Box]) -> Box:
        """Return factors side by side, with a dot where they would run together."""
        boxes = [pieces[0]]
        for (before, piece), (lead, formula) in zip(
            pairwise(pieces), pairwise(formulas), strict=True
        ):
            if _runs_together(before, formula, piece) or (
                _is_figure(lead) and _BRACKET.match(piece.tex)
            ):
                boxes.append(plain(r"\cdot "))
            elif _are_words(before, piece):
                boxes.append(plain(r"\,"))
            boxes.append(piece)
        return row(boxes)

    def over(self, above: Box, below: Box, several: bool) -> Box:
        width = max(above.width, below.width) + 0.3
        return Box(rf"\frac{{{above.tex}}}{{{below.tex}}}", width, tall=True)

    def beside(self, first: Box, second: Box) -> Box:
        both = first.tall and second.tall
        return row((first, plain(r"\cdot" if both else r"\," if second.tall else ""), second))

    def scaled(self, lead: Box, rest: Box) -> Box:
        return row((lead, plain(r"\cdot " if rest.tex[0].isdigit() else r"\,"), rest))

    def power(self, base: Box, exponent: Box) -> Box:
        width = base.width + 0.7 * exponent.width
        return Box(f"{base.tex}^{{{exponent.tex}}}", width, base.tall)

    def holds(self, call: Box) -> bool:
        return call.tex.startswith(r"\left|")

    def root(self, inner: Box) -> Box:
        return Box(rf"\sqrt{{{inner.tex}}}", inner.width + 0.9, tall=True)

    def absolute(self, inner: Box) -> Box:
        return Box(rf"\left|{inner.tex}\right|", inner.width + 0.6, inner.tall)

    def applied(self, function: str, exponent: str, argument: Formula, inner: Box) -> Box:
        """Return a function of one argument, without parentheses where none are needed."""
        if function == "exp":
            return self.power(plain(EULER), _Raised(self.style).whole(argument))
        written = self.style.functions[function] + (f"^{{{exponent}}}" if exponent else "")
        if inner.tall or not _is_bare(argument, function in TRIGONOMETRIC):
            return row((plain(written), self.parentheses(inner)))
        return row((plain(written), inner))._replace(open=True)

    def called(self, function: str, arguments: Sequence[Box]) -> Box:
        """Return a function of several arguments."""
        parts = (
            Box((self.style.between if i else "") + part.tex, part.width + 0.5, part.tall)
            for i, part in enumerate(arguments)
        )
        return row((plain(self.style.functions[function]), self.parentheses(row(parts))))

    def joined_by(self, sign: str, pieces: Sequence[Box]) -> Box:
        written = r",\; " if sign == "," else relation_sign(sign)
        first, *others = pieces
        return row((first, *(part for piece in others for part in (plain(written), piece))))

    def cases(self, rows: Sequence[tuple[Box, Box]], other: Box | None) -> Box:
        """Return the cases below each other; each is meant where none above it is."""
        lines = [rf"{value.tex}, & {condition.tex}" for value, condition in rows]
        lines += [rf"{other.tex} & \text{{{self.style.otherwise}}}"] if other else []
        width = max(value.width + condition.width for value, condition in rows) + 3.0
        inner = r" \\ ".join(lines)
        return Box(rf"\begin{{cases}} {inner} \end{{cases}}", width, tall=True)

    def solution(self, unknown: str, zeros: Sequence[Box]) -> Box:
        """Set an unknown and its equations in a row; where they are defined they have lines."""
        first, *others = (row((zero, plain("=0"))) for zero in zeros)
        rest = (row((plain(r",\;"), line)) for line in others)
        return row((plain(name_of(unknown, self.style) + r":\;"), first, *rest))


class Boxes(_Latex):
    """Sets formulas that have much in common, each part of them once."""

    def __init__(self, style: LatexNotation) -> None:
        super().__init__(style)
        self._known: dict[tuple[Formula, Surroundings, bool], Box] = {}

    def set(self, formula: Formula, around: Surroundings, angle: bool) -> Box:
        """Return a formula as it stands inside another."""
        key = formula, around, angle
        if key not in self._known:
            self._known[key] = super().set(formula, around, angle)
        return self._known[key]


class _Raised(_Latex):
    """Sets an exponent, where a fraction with a line would be too small to read."""

    built = False

    def over(self, above: Box, below: Box, several: bool) -> Box:
        return row((above, plain("/"), self.parentheses(below) if several else below))

    def beside(self, first: Box, second: Box) -> Box:
        return row((first, plain(r"\cdot "), second))


def _runs_together(before: Box, formula: Formula, after: Box) -> bool:
    """Return whether factors side by side would be read as one: figures, ``df``, ``aAB``."""
    is_function = isinstance(formula, Call) and not after.tex.startswith(("(", r"\left", EULER))
    raised = isinstance(formula, Power) and isinstance(formula.base, Call)
    is_letter = isinstance(formula, Symbol)
    if isinstance(formula, Constant) and after.tex[0].isdigit():
        return True
    if _is_distance(formula) and not _ENDS_APART.search(before.tex):
        return True
    return (before.open and not (is_function or raised)) or (
        (before.tex[-1].isdigit() and after.tex[0].isdigit())
        or (before.tex == "d" and is_letter)
        or (before.tex == "f" and after.tex[:1] in {*SIZES})
    )


_ENDS_APART = pattern(r"(\)|^[-\d.,{}]+)$")
"""The end of a factor that no letter behind it is read with: a bracket, or figures alone."""


def _is_distance(formula: Formula) -> bool:
    """Return whether a factor is a distance between two points, ``AB``, or a power of one."""
    base = formula.base if isinstance(formula, Power) else formula
    return isinstance(base, Symbol) and base.name.startswith("len_")


_BRACKET = pattern(r"\(|\\left\(")


def _is_figure(formula: Formula) -> bool:
    """Return whether a factor is a number that is put in, ``0.3``, not a multiple, ``2``."""
    return isinstance(formula, Constant) and formula.name[0].isdigit()


def _are_words(before: Box, after: Box) -> bool:
    """Return whether a word, or one in an index, would be read as one with the next letter."""
    if before.tex[-1] in ")]" or after.tex[0] in "([":
        return False
    if _WORD.match(before.tex) or _WORD.match(after.tex):
        return True
    return bool(_WORD_BELOW.search(before.tex)) and not _OPERATOR.match(after.tex)


_OPERATOR = pattern(r"\\(sin|cos|tan|cot|sec|csc|ln|arc|operatorname|left)")
"""What TeX sets apart from a letter before it by itself."""

_WORD = pattern(r"\\math(rm|it)")
_WORD_BELOW = pattern(r"\\(mathrm|text)\{[^{}]*\}\}$")
"""The end of a name with an index of several letters."""


def _is_bare(argument: Formula, angle: bool) -> bool:
    """Return whether a function's argument needs no brackets: a name, a multiple of one, a number.

    One that is an ``angle`` may be written in degrees.
    """
    match argument:
        case Symbol(name):
            return not name.startswith("-")
        case Pi():
            return True
        case Number(value):
            return value >= 0
        case Product((Number(value), Symbol())):
            return value > 0 and value.denominator == 1
        case _:
            constant = in_degrees(argument) if angle else None
            return constant is not None and constant >= 0
