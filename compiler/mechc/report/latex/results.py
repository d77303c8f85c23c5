"""The report's last part: what was found and what follows from it."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from ...base.named import NamedTuple
from ...formula.layout import decimal as exact_decimal
from ...formula.layout import is_angle
from ...formula.names import split_points
from ...formula.tree import ZERO, Formula, Number, Symbol, product, total
from ...model.mechanism import SpeedRatio
from ...model.result import Definition
from ...statics.verdict import Verdict
from ...study.analysis import Analysis
from ...units import ANGLE, behind
from ..definitions import SolvedSystem, grouped, without_minus
from ..languages.locale import Locale
from ..sections import Section
from ..sentences.remarks import asked, heading, headings, is_nameless, ratio, remarks, said
from ..steps import Equation, Paragraph
from .display import LINE_WIDTH, DisplayLine, balance, display, vanishing
from .notation import LatexNotation, name, points, relation_sign
from .note import alone
from .printer import Box, box, latex, plain
from .quantity import decimal, in_a_line
from .unit_symbols import unit_symbol
from .values_at_pose import short_derivatives, slope

_WIDE = 9.0
"""Em beyond which a left side is no mere name or ratio of speeds."""


class ParagraphBlock(NamedTuple):
    """One paragraph of how results came about: a sentence, and a display or nothing."""

    sentence: str
    equations: str


class Findings(NamedTuple):
    """The remarks on one result in sentences, and its sensitivities."""

    remarks: tuple[str, ...]
    derivatives: str
    sensitivities: str


class SectionBlock(NamedTuple):
    """Results under one heading, ready for LaTeX."""

    heading: str
    paragraphs: tuple[ParagraphBlock, ...]
    displays: tuple[str, ...]
    findings: tuple[Findings, ...]

    @property
    def is_remarked(self) -> bool:
        """Return whether remarks come right behind the last display, on the same page."""
        return bool(self.findings and self.findings[0].remarks)

    @property
    def follows(self) -> bool:
        """Return whether the results follow from equations just above, not from a sentence."""
        return bool(self.paragraphs and self.paragraphs[-1].equations)


def section_blocks(
    sections: Sequence[Section], locale: Locale, style: LatexNotation
) -> Iterator[SectionBlock]:
    """Yield everything a report says of its results, each under its heading."""
    titles = headings((s.results[0] for s in sections), locale, LatexSpeller(style))
    for section, title in zip(sections, titles, strict=True):
        yield section_block(section, locale, style)._replace(heading=title)


def section_block(section: Section, locale: Locale, style: LatexNotation) -> SectionBlock:
    """Return everything the report says of the results of one section.

    Its parts are written in the order in which they are read: a name is defined where it
    comes first.
    """
    paragraphs = tuple(_paragraph(p, locale, style) for p in section.paragraphs)
    units = {n: unit_symbol(unit, locale) for n, unit in section.units.items()}
    first = section.results[0]
    if first.name in section.lines:
        main = tuple(alone(section.lines[first.name], locale, style))
    else:
        main = _components(section.results, style, locale) or _main(first, locale, style, units)
    return SectionBlock(
        heading(first, locale, LatexSpeller(style)),
        paragraphs,
        (*main, *_where(section.where, locale, style, units)),
        tuple(_findings(r, locale, style) for r in section.results),
    )


def width(section: Section, style: LatexNotation) -> float:
    """Return the length in em of the longest equation that a section displays."""
    results = (_left(r, style).width + box(r.formula, style).width for r in section.results)
    where = (box(Symbol(d.name), style).width + box(d.formula, style).width for d in section.where)
    return max((*results, *where))


def _components(
    results: Sequence[Analysis], style: LatexNotation, locale: Locale
) -> tuple[str, ...]:
    """Return the components of one force below each other; nothing for a single result."""
    if len(results) == 1:
        return ()
    lines = tuple(DisplayLine(_left(r, style), r.formula) for r in results)
    return (display(lines, style, locale.where),)


def _paragraph(paragraph: Paragraph, locale: Locale, style: LatexNotation) -> ParagraphBlock:
    shown = "\n".join(_displays(paragraph.equations, locale, style))
    return ParagraphBlock(said(paragraph, locale, LatexSpeller(style)), shown)


def _displays(equations: Iterable[Equation], locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield displays of equations; one with a wide left side stands alone."""
    for _, group in groupby(equations, lambda e: e if _is_wide(e, style) else None):
        part = tuple(group)
        line = DisplayLine(box(part[0].left, style), part[0].right)
        if _is_wide(part[0], style) and line.left.width + box(line.right, style).width > LINE_WIDTH:
            yield _balance(part[0], locale, style)
        else:
            yield _display(part, locale, style)


def _is_wide(equation: Equation, style: LatexNotation) -> bool:
    return box(equation.left, style).width > _WIDE


def _display(equations: Iterable[Equation], locale: Locale, style: LatexNotation) -> str:
    lines = [
        DisplayLine(box(e.left, style), e.right, is_angle(e.right, style.angles)) for e in equations
    ]
    return display(tuple(lines), style, locale.where)


def _balance(equation: Equation, locale: Locale, style: LatexNotation) -> str:
    if equation.right == ZERO:
        return vanishing(equation.left, style, locale.where)
    return balance(*equation, style, locale.where)


def _findings(result: Analysis, locale: Locale, style: LatexNotation) -> Findings:
    return Findings(
        remarks(result, locale, LatexSpeller(style)),
        _derivatives(result, locale, style),
        locale.slope if result.where else locale.derivatives,
    )


def _left(result: Analysis, style: LatexNotation) -> Box:
    """Return the left side, ``k = P/F`` for a ratio with a name of its own."""
    symbol, asked_for = box(asked(result), style), ratio(result)
    if asked_for is None or is_nameless(result):
        return symbol
    whole = box(asked_for, style)
    return Box(f"{symbol.tex}={whole.tex}", symbol.width + whole.width + 1.2, tall=True)


def _main(
    result: Analysis, locale: Locale, style: LatexNotation, units: Mapping[str, str]
) -> tuple[str, ...]:
    left = _left(result, style)
    short = left.width + box(result.formula, style).width <= LINE_WIDTH
    if result.coefficients and not short:
        return _as_form(left, result.coefficients, locale, style)
    angle = result.dimension == ANGLE
    line = DisplayLine(left, result.formula, angle, units.get(result.name, ""))
    return (display((line,), style, locale.where, boxed=True),)


def _as_form(
    left: Box, coefficients: Mapping[str, Formula], locale: Locale, style: LatexNotation
) -> tuple[str, ...]:
    """Return a long linear form with a name for the coefficient of every load."""
    made: list[DisplayLine] = []
    terms = []
    for load, formula in coefficients.items():
        named = style.made.known(formula)
        if named is None:
            named = style.made.of_coefficient(formula, load)
            made.append(DisplayLine(box(named, style), formula))
        terms.append(product([(named, 1), (Symbol(load), 1)]))
    first = display((DisplayLine(left, total(terms)),), style, locale.where, boxed=True)
    return (first, locale.where, display(tuple(made), style, locale.where)) if made else (first,)


def _where(
    where: Iterable[Definition], locale: Locale, style: LatexNotation, units: Mapping[str, str]
) -> tuple[str, ...]:
    shown = definitions(where, locale, style, units)
    return (locale.where, *shown) if shown else ()


def definitions(
    where: Iterable[Definition], locale: Locale, style: LatexNotation, units: Mapping[str, str]
) -> tuple[str, ...]:
    """Return definitions, neighbours in one display; a system's names before its equations."""
    parts: list[str] = []
    for solved, groups in groupby(grouped(where), lambda group: isinstance(group, SolvedSystem)):
        if solved:
            parts += (part for group in groups for part in _solved(group, locale, style))
        else:
            parts.append(
                display(tuple(_line(g, style, units) for g in groups), style, locale.where)
            )
    return tuple(parts)


def _line(
    definition: Definition | SolvedSystem, style: LatexNotation, units: Mapping[str, str]
) -> DisplayLine:
    assert isinstance(definition, Definition)
    own = definition.name
    unit = units.get(own, "")
    in_radians = not unit and is_angle(Symbol(own), style.angles)
    return DisplayLine(plain(name(own, style)), definition.formula, in_radians, unit)


def _solved(
    group: Definition | SolvedSystem, locale: Locale, style: LatexNotation
) -> tuple[str, str]:
    assert isinstance(group, SolvedSystem)
    names = ", ".join(f"${name(n, style)}$" for n in group.names)
    both = map(without_minus, group.zeros)
    lines = tuple(DisplayLine(box(left, style), right) for left, right in both)
    return locale.solve.format(names=names), display(lines, style, locale.where)


def _derivatives(result: Analysis, locale: Locale, style: LatexNotation) -> str:
    if isinstance(result.target, SpeedRatio):
        return ""
    symbol = latex(asked(result), style)
    lines = tuple(
        DisplayLine(slope(symbol, parameter, style, total=bool(result.where)), formula)
        for parameter, formula in short_derivatives(result)
    )
    return display(lines, style, locale.where) if lines else ""


class LatexSpeller(NamedTuple):
    """Mathematics inside a sentence, between dollar signs."""

    style: LatexNotation

    @property
    def angles(self) -> frozenset[str]:
        """Return the names that are angles."""
        return self.style.angles

    @property
    def couples(self) -> frozenset[str]:
        """Return the loads that are couples."""
        return self.style.couples

    @property
    def guided(self) -> frozenset[str]:
        """Return the points that a guide of the ground holds."""
        return self.style.guided

    def relation(self, sides: tuple[Formula, ...], signs: tuple[str, ...], angle: bool) -> str:
        """Return sides joined by signs."""
        tex = [self._side(side, angle) for side in sides]
        tail = (relation_sign(sign) + side for sign, side in zip(signs, tex[1:], strict=True))
        return f"${tex[0]}{''.join(tail)}$"

    def _side(self, side: Formula, angle: bool) -> str:
        """Return a side; a number alone is a decimal where it can be."""
        if angle and side == ZERO:
            return r"0^\circ"
        if isinstance(side, Number) and not angle and (figures := exact_decimal(side.value)):
            return figures.replace(".", self.style.decimal)
        return latex(self.style.made.sums.get(side, side), self.style, angle)

    def number(self, value: float) -> str:
        """Return a number that was computed, its power on the same line."""
        return in_a_line(decimal(value, self.style))

    def unit_behind(self, unit: str) -> str:
        """Return a unit behind its number; a reciprocal has an exponent."""
        if unit.startswith("1/"):
            letters = unit_symbol(unit, self.style).removeprefix(r"\,")
            return f"~${letters}$"
        return behind(self.style.units.get(unit, unit))

    def point(self, names: str) -> str:
        """Return a point, a link or a vector."""
        is_drawn = not names or split_points(names.partition("_")[0])
        return f"${points(names) if is_drawn else latex(Symbol(names), self.style)}$"


def agreement_with_statics(verdict: Verdict, locale: Locale, style: LatexNotation) -> str:
    """Return at how many poses statics agrees, and how closely, or that it does not."""
    if not verdict.trials:
        return locale.pending
    poses = {tuple(sorted(trial.values.items())) for trial in verdict.trials}
    agrees = locale.agrees_once if len(poses) == 1 else locale.agrees
    template = agrees if verdict.agrees else locale.disagrees
    return template.format(count=len(poses), error=_error(verdict.worst, style))


def untried(verdict: Verdict, locale: Locale, style: LatexNotation) -> tuple[str, ...]:
    """Return a sentence on each result that was checked at fewer poses than are wanted."""
    spell = LatexSpeller(style)
    return tuple(
        locale.checked["judged"].format(
            name=spell.relation((Symbol(one.result),), (), False),
            count=one.judged,
            poses=one.poses,
            reason=locale.checked[one.reason],
        )
        + "."
        for one in verdict.remarks
    )


def _error(worst: float, style: LatexNotation) -> str:
    """Return a difference to two figures; of none at all what it is below."""
    return in_a_line(decimal(float(f"{worst:.1e}"), style)) if worst else "${<}10^{-16}$"
