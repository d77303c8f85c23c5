"""The formulas of calculation sheets, and those of the user's own in mechanisms, as displays."""

from collections.abc import Iterator, Mapping, Sequence

from ...formula.tree import Formula, Symbol
from ...model.parts.written import WrittenFormula
from ...units import ANGLE
from ..languages.locale import Locale
from ..note import NoteLine
from ..put_in import GivenQuantity
from .display import LINE_WIDTH, DisplayLine, display
from .notation import LatexNotation, name, translated
from .printer import Box, box, latex, plain, row
from .quantity import in_unit, math
from .text import begun


def alone(line: NoteLine, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield the text of a formula, the formula as it is written, and what there is to say of it."""
    if line.label:
        yield rf"\noindent {begun(translated(line.label, style))}:"
    assert line.formula
    left, angle = box(Symbol(line.name), style), line.dimension == ANGLE
    if line.of:
        shown = side(line, line.formula, style, angle)
        yield rf"\[ \boxed{{{left.tex}={shown.tex}}} \]"
    else:
        yield display((DisplayLine(left, line.formula, angle),), style, locale.where, boxed=True)
    if said := remark(line, locale.calculation, style):
        yield rf"\noindent ({said})\par"


def remark(line: NoteLine, words: Mapping[str, str], style: LatexNotation) -> str:
    """Return which list a size is of, where a table is from, which of several things decides."""
    looked_up = line.kind in ("row", "list")
    remarks = [words[line.kind].format(name=math(name(line.of, style)))] if looked_up else []
    if line.between and line.source:
        remarks.append(words["between"].format(source=translated(line.source, style)))
    if line.decides:
        remarks.append(words["decides"].format(formula=math(latex(line.decides, style))))
    return "; ".join(remarks)


def in_numbers(line: NoteLine, where: str, style: LatexNotation) -> str:
    """Return a formula, the numbers put in and its value, as one display."""
    left = box(Symbol(line.name), style)
    if is_plain(line):
        return _in_the_line(line, left, style)
    if line.kind == "list" and line.formula and line.value and line.asked:
        found, asked = measure(line.value, style), measure(line.asked, style)
        needed = box(line.formula, style)
        return rf"\[ {left.tex}={found.tex}\geq {needed.tex}={asked.tex} \]"
    sides = list(_sides(line, style))
    if line.formula and max(side.width for side in sides) > LINE_WIDTH:
        return _broken(line, line.formula, left, sides[-1], where, style)
    if r"\end{cases}" in sides[0].tex and len(sides) > 1:
        return _behind_cases(left, sides)
    if left.width + sum(side.width + 1.2 for side in sides) <= LINE_WIDTH or len(sides) == 1:
        return rf"\[ {'='.join(side.tex for side in (left, *sides))} \]"
    rows = r" \\ ".join(rf"&={side.tex}" for side in sides)
    return rf"\begin{{align*}} {left.tex}{rows} \end{{align*}}"


def _behind_cases(left: Box, sides: Sequence[Box]) -> str:
    """Return a choice and apart from it its value, which would seem to belong to one of its cases.

    It is below the choice where a line does not hold both.
    """
    value = "=".join(side.tex for side in (left, *sides[1:]))
    width = sum(side.width + 1.2 for side in (left, left, *sides))
    between = r"\qquad " if width <= LINE_WIDTH else "\\]\n\\[ "
    return rf"\[ {left.tex}={sides[0].tex}{between}{value} \]"


def _sides(line: NoteLine, style: LatexNotation) -> Iterator[Box]:
    """Yield what a name is equal to: its formula, that in numbers, the rows between, its value."""
    angle = line.dimension == ANGLE
    for formula in (line.formula, line.numbers):
        if formula:
            yield side(line, formula, style, angle)
    if line.between:
        yield box(line.between, style, angle)
    if line.value and not line.is_number:
        yield measure(line.value, style)


def is_plain(line: NoteLine) -> bool:
    """Return whether nothing is calculated in a line that has a text: a number, another name."""
    named = isinstance(line.formula, Symbol) or line.is_number
    return bool(line.label and line.formula and line.value and named and not line.kind)


def _in_the_line(line: NoteLine, left: Box, style: LatexNotation) -> str:
    """Return a value that is taken as it is, to stand behind its text."""
    assert line.formula
    assert line.value
    sides = [] if line.is_number else [box(line.formula, style, line.dimension == ANGLE)]
    sides.append(measure(line.value, style))
    return math("=".join(side.tex for side in (left, *sides)))


def _broken(
    line: NoteLine, formula: Formula, left: Box, value: Box, where: str, style: LatexNotation
) -> str:
    """Return a formula that no line holds, broken, and its value, without the numbers."""
    broken = display((DisplayLine(left, formula, line.dimension == ANGLE),), style, where)
    return f"{broken}\n\\[ {left.tex}={value.tex} \\]" if line.value else broken


def side(
    line: NoteLine | WrittenFormula, formula: Formula, style: LatexNotation, angle: bool
) -> Box:
    """Return a formula; of a table its name, applied to what it is asked for."""
    if not line.of:
        return box(formula, style, angle)
    inner = box(formula, style)
    table = box(Symbol(line.of), style)
    return row((table, Box(rf"\left({inner.tex}\right)", inner.width + 1.0, inner.tall)))


def measure(quantity: GivenQuantity, style: LatexNotation) -> Box:
    """Return a value in its unit."""
    return plain(in_unit(quantity.value, quantity.unit, style, style))
