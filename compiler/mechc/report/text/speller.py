"""How a report for the terminal is written: its mathematics, its language, its lines."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from ...base.frozen import replace
from ...base.later import Later, pattern
from ...base.named import NamedTuple
from ...formula.evaluate import evaluate
from ...formula.layout import is_angle
from ...formula.names import split_points
from ...formula.tree import Formula, Symbol
from ...model.mechanism import Mechanism, Parameter
from ...model.result import Result
from ...units import behind, in_unit
from ..digits import VALUE_DIGITS
from ..languages.locale import Locale
from ..languages.registry import locale as locale_of
from ..made_names import MadeNames
from ..put_in import GivenQuantity, in_degrees
from ..sentences.speller import angles_of, couples_of, guided_of, own_names
from . import printer
from .character_sets import ASCII, UNICODE, TextSigns, tens
from .repeated import RepeatedSums

textwrap = Later("textwrap")
"""Breaks lines; most of what ``check`` says fits into one."""

LINE_COLUMNS = 80
"""Columns that lines keep to where they can."""

LINES = 2
"""A formula that takes no more lines than this is read as a whole."""

DEEP = " " * 8
"""What stands before a formula."""

_TIED = pattern(
    r"\([^()]{,40}\)|(?<=[\d⁰¹²³⁴-⁹]) (?=[^\W\d_])"
    r"|\b(?:sin|cos|tan|cot|tg|ctg)[⁰¹²³⁴-⁹]* (?=[^\s·+−=])"
)
_OPERATOR = pattern(r"\\operatorname\{(\w+)\}")
_UNIT = pattern(r"(?<=[\d⁰¹²³⁴-⁹] )(?:1/)?[A-Za-z][\w^*/·]*")
"""A unit behind its number."""

_POINT = pattern(r"(?<=\d)\.(?=\d)")

_WORD = pattern(r"[A-Za-z]+")


class TextSpeller(NamedTuple):
    """Mathematics inside a sentence, with the signs of a terminal, the words of a language.

    Lines keep to ``width`` columns where they can; ``texts`` are what those of the description
    are in the language, ``parts`` the names of what formulas have more than once.
    """

    signs: TextSigns
    locale: Locale
    width: int = LINE_COLUMNS
    texts: Mapping[str, str] = MappingProxyType({})
    parts: RepeatedSums | None = None

    @property
    def angles(self) -> frozenset[str]:
        """Return the names that are angles."""
        return self.signs.angles

    @property
    def couples(self) -> frozenset[str]:
        """Return the loads that are couples."""
        return self.signs.couples

    @property
    def guided(self) -> frozenset[str]:
        """Return the points that a guide of the ground holds."""
        return self.signs.guided

    def relation(self, sides: tuple[Formula, ...], signs: tuple[str, ...], angle: bool) -> str:
        """Return sides joined by signs."""
        sides = self.parts.sides(sides) if self.parts else sides
        line = printer.print_side(sides[0], self.signs, angle)
        for sign, side in zip(signs, sides[1:], strict=True):
            shown = self.signs.relations.get(sign, sign)
            line += f" {shown} {printer.print_side(side, self.signs, angle)}"
        return self.decimals(line)

    def number(self, value: float) -> str:
        """Return a number that was computed."""
        figures = tens(f"{value:.{VALUE_DIGITS}g}", self.signs)
        return self.decimals(figures.replace("-", self.signs.minus))

    def measured(self, value: float, unit: str, digits: int) -> str:
        """Return a value in SI in a unit, as a description has it but for powers of ten."""
        return self.units(tens(in_unit(value, unit, digits), self.signs))

    def quantity(self, quantity: GivenQuantity) -> str:
        """Return a value in its unit, an angle in degrees."""
        if quantity.unit != "deg":
            return printer.print_quantity(quantity.text(VALUE_DIGITS), self.signs)
        return printer.print_side(in_degrees(quantity.value, VALUE_DIGITS), self.signs, True)

    def unit_behind(self, unit: str) -> str:
        """Return a unit behind its number."""
        return self.unit(printer.print_quantity(behind(unit), self.signs))

    def point(self, names: str) -> str:
        """Return a point, a link or a vector; what is named otherwise is a quantity."""
        is_drawn = not names or split_points(names.partition("_")[0])
        set_name = printer.print_point if is_drawn else printer.print_name
        return set_name(names, self.signs)

    def text(self, text: str) -> str:
        """Return a text of the description in the language, where it is translated."""
        return self.texts.get(text, text)

    def units(self, said: str) -> str:
        """Return text in which units stand in the letters of the language, and its decimals."""
        if not self.locale.units:
            return said
        return self.decimals(_UNIT.sub(lambda unit: self.unit(unit[0]), said))

    def decimals(self, said: str) -> str:
        """Return numbers with the decimal sign of the language."""
        sign = self.locale.decimal.strip("{}")
        return said if sign == "." else _POINT.sub(sign, said)

    def as_described(self, said: str) -> str:
        """Return text in the notation of descriptions with the commas and units of the language."""
        is_plain = self.locale.decimal == "."
        return said if is_plain else self.units(_with_semicolons(said))

    def unit(self, unit: str) -> str:
        """Return a unit in the letters of the language."""
        return _WORD.sub(lambda word: self.locale.units.get(word[0], word[0]), unit)

    def wrapped(self, text: str, lead: str) -> list[str]:
        """Return a text in lines, behind ``lead``."""
        hanging = " " * len(lead)
        lines: list[str] = textwrap.wrap(
            text,
            self.width,
            initial_indent=lead,
            subsequent_indent=hanging,
            break_long_words=False,
        )
        return lines

    def broken(self, equation: str, deep: str = DEEP) -> list[str]:
        """Break a long equation at the spaces around its signs.

        What is short and in brackets stays together, ``sin(α + β)``, and so do ``5 mm``, ``cos α``.
        """
        whole = (deep + equation).rstrip(" ")
        if equation.strip() and equation.isprintable() and len(whole) <= self.width:
            return [whole]
        indent = deep + " " * (len(equation) - len(equation.lstrip()))
        tied = _TIED.sub(lambda m: m[0].replace(" ", "\u00a0"), equation.lstrip())
        lines = textwrap.wrap(
            tied,
            self.width,
            initial_indent=indent,
            subsequent_indent=indent + "    ",
            break_long_words=False,
            break_on_hyphens=False,
        )
        return [line.replace("\u00a0", " ") for line in lines]

    def naming(self, formulas: Iterable[Formula], made: MadeNames) -> "TextSpeller":
        """Return the speller of a page, which has names for what its formulas have repeatedly."""
        page = tuple(formulas)
        many = (f for f in page if self._width(f) > LINES * LINE_COLUMNS)
        repeated = RepeatedSums(many, made, self._is_long, page)
        return self._replace(parts=repeated) if repeated.sums else self

    def _is_long(self, part: Formula) -> bool:
        """Return whether a part of a formula takes more than half a line."""
        return not is_angle(part, self.angles) and self._width(part) > LINE_COLUMNS // 2

    def _width(self, formula: Formula) -> int:
        return len(self.relation((formula,), (), False))

    def literal(self, literal: Parameter) -> str:
        """Return the line on a length that is given by a number."""
        assert literal.value
        name = self.relation((Symbol(literal.name),), (), False)
        value = self.measured(evaluate(literal.value, {}), literal.unit, 10)
        return f"{DEEP}{name} = {value.replace('-', self.signs.minus)}"


def _with_semicolons(said: str) -> str:
    """Return a formula with semicolons between arguments, as its decimals have commas.

    >>> _with_semicolons("k = 0.5*max(a, (b)) at a = 1, b = 2")
    'k = 0.5*max(a; (b)) at a = 1, b = 2'
    """
    depth, shown = 0, ""
    for letter in said:
        depth += (letter == "(") - (letter == ")")
        shown += ";" if letter == "," and depth else letter
    return shown


def speller(
    results: Iterable[Result],
    mechanism: Mechanism,
    unicode: bool,
    language: str = "en",
    width: int = LINE_COLUMNS,
) -> TextSpeller:
    """Return the speller of mathematics, with the names that are angles in this mechanism."""
    words = locale_of(language)
    signs = UNICODE if unicode else ASCII
    texts = mechanism.texts(language)
    functions = {name: _OPERATOR.sub(r"\1", word) for name, word in words.functions.items()}
    signs = replace(
        signs,
        angles=angles_of(mechanism, results),
        couples=couples_of(mechanism),
        guided=guided_of(mechanism),
        functions=functions if language != "en" else {},
        choices=words.calculation,
        between=", " if words.decimal == "." else "; ",
        subscripts=words.subscripts,
        own=own_names(mechanism),
        texts=texts,
    )
    return TextSpeller(signs, words, width, texts)
