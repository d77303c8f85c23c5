r"""LaTeX: the report of a mechanism, a document by itself or a fragment to ``\input``.

A fragment needs amsmath, array, booktabs and longtable; where it holds Cyrillic letters,
also the font encoding T2A (pdfTeX) or a font that has them (XeTeX, LuaTeX).
"""

from collections.abc import Iterable, Iterator, Sequence

from ...formula.tree import ZERO
from ...model.mechanism import Mechanism, Parameter
from ...model.statements import is_sheet
from ...report.brief import at_length, needed, relations, short
from ...report.definitions import given_loads, looked_up, stated_above
from ...report.evaluated import (
    Evaluated,
    constants_shown,
    evaluated,
    following,
    has_atan2,
    hides_units,
    named_directions,
)
from ...report.languages import registry
from ...report.languages.locale import Locale
from ...report.latex.display import LINE_WIDTH, DisplayLine, display, vanishing
from ...report.latex.document_style import style_of
from ...report.latex.given import (
    ParameterRow,
    in_vectors,
    parameter_row,
    scheme,
    vector_rows,
)
from ...report.latex.notation import LatexNotation, name, notation, translated
from ...report.latex.printer import Box, box, plain, row
from ...report.latex.quantity import math
from ...report.latex.results import (
    LatexSpeller,
    agreement_with_statics,
    definitions,
    section_block,
    section_blocks,
    untried,
)
from ...report.latex.text import has_cyrillic
from ...report.latex.values_at_pose import in_line, numbers, values
from ...report.roles import with_places, with_roles
from ...report.sections import PositionSection, ReportOutline, chosen, outline
from ...report.sentences.powers import power_remarks
from ...report.sentences.remarks import conditions, subject
from ...report.sentences.wording import (
    EquationSides,
    direction_function,
    directions_named,
    lines,
    position_sentences,
    sentences,
)
from ...report.steps import Derivation, DerivationStep, LastStep
from ..render import render
from ..target import Compiled, Emitted, Options
from . import pictures
from .blocks import (
    NO_PICTURES,
    Brief,
    Document,
    Pictures,
    PositionBlock,
    ReportContext,
    StepBlock,
    UsedMechanismContext,
)
from .note import note_report, table_blocks


class Latex:
    """The target ``latex``."""

    name = "latex"
    suffixes = (".tex",)

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return one ``.tex`` file."""
        locale = registry.locale(options.language)
        body = _body(compiled, locale, notation(options.language), options)
        pictured = options.pictures or compiled.mechanism.reported or compiled.used_mechanisms
        drawn = _preamble() if pictured and not options.brief else ()
        text = body if options.fragment else document(body, locale, drawn)
        return (Emitted(f"{options.stem}.tex", text),)


TARGET = Latex()


def _body(compiled: Compiled, locale: Locale, style: LatexNotation, options: Options) -> str:
    """Return the report of a mechanism, or the calculation note of a sheet."""
    derivation = compiled.by_equilibrium if options.by == "equilibrium" else compiled.reported
    if is_sheet(compiled.mechanism):
        used = () if options.brief else compiled.used_mechanisms
        derived = _derived(used) if used else None
        note = note_report(compiled, locale, style, options.fragment, derived)
        parts = (_used(prefix, part, locale, options) for prefix, part in used)
        return "\n".join((render("latex/note.jinja", note), *parts))
    style = style_of(compiled.mechanism, derivation.results, style)
    derivation = chosen(derivation, compiled.mechanism)
    if options.brief:
        in_brief = brief(compiled, derivation, locale, style, options)
        return render("latex/brief.jinja", in_brief)
    whole = report(compiled, derivation, locale, style, options)
    return render("latex/body.jinja", whole)


def _derived(used: Iterable[tuple[str, Compiled]]) -> frozenset[str]:
    """Return the results that reports of used mechanisms derive, by their names in the sheet."""
    reports = ((prefix, chosen(part.reported, part.mechanism)) for prefix, part in used)
    return frozenset(f"{prefix}_{r.name}" for prefix, found in reports for r in found.results)


def _used(prefix: str, compiled: Compiled, locale: Locale, options: Options) -> str:
    """Return the report of a mechanism that a sheet uses, with its scheme."""
    known, derivation = compiled.reported.results, chosen(compiled.reported, compiled.mechanism)
    style = style_of(compiled.mechanism, known, notation(options.language))
    whole = report(compiled, derivation, locale, style, options._replace(fragment=True))
    if whole.pictures == NO_PICTURES and not options.fragment:
        whole = whole._replace(pictures=_scheme(compiled, locale, style))
    words = (locale.calculation[key] for key in ("mechanism", "index"))
    heading, sentence = (said.format(prefix=math(name(prefix, style))) for said in words)
    part = UsedMechanismContext(
        _section(options), heading, sentence, render("latex/body.jinja", whole)
    )
    return render("latex/used.jinja", part)


def _section(options: Options) -> str:
    return "subsection" if options.fragment else "section"


def _scheme(compiled: Compiled, locale: Locale, style: LatexNotation) -> Pictures:
    return pictures.scheme_alone(compiled, locale, style)


def document(body: str, locale: Locale, pictures: Iterable[str] = ()) -> str:
    """Return the body within a preamble that loads no more than it needs.

    ``pictures`` are the lines by which it knows how pictures are drawn.
    """
    eastern = locale.cyrillic
    cyrillic = eastern or has_cyrillic(body)
    whole = Document(body, locale.babel, eastern, cyrillic, tuple(pictures))
    return render("latex/report.jinja", whole)


def _given(compiled: Compiled) -> Iterator[Parameter]:
    """Yield the parameters that are given; those that a loop gives stand with the results.

    Behind them the numbers that the description gives lengths by, but for those that the table of
    vectors has, and loads by.
    """
    found = {d.name for result in compiled.derivation.results for d in result.where}
    for parameter in compiled.mechanism.parameters:
        if parameter.value is not None or parameter.name not in found:
            yield parameter
    shown = in_vectors(compiled.mechanism)
    yield from (p for p in compiled.mechanism.literals if p.name not in shown)
    yield from given_loads(compiled.mechanism)


def _parameters(
    compiled: Compiled, locale: Locale, style: LatexNotation, found: Sequence[Evaluated] | None
) -> Iterator[ParameterRow]:
    """Yield the rows of what is given, with values that are not ``found`` among the numbers."""
    drive = compiled.mechanism.drive_name
    apart = {} if found is None else following(compiled.mechanism, {item.left for item in found})
    known = with_roles(_given(compiled), compiled.mechanism, locale.roles)
    for parameter in with_places(known, compiled.mechanism, locale.roles):
        yield parameter_row(parameter, locale, style, drive, apart.get(parameter.name))


def report(
    compiled: Compiled,
    derivation: Derivation,
    locale: Locale,
    style: LatexNotation,
    options: Options,
) -> ReportContext:
    """Return all that a report says, with a derivation of what was asked for."""
    mechanism, verdict = compiled.mechanism, compiled.verdict
    whole = outline(derivation, mechanism, stated_above(mechanism))
    found = tuple(evaluated(whole, mechanism)) if options.numbers else ()
    aside, full = at_length(found, whole)
    shown = {*constants_shown(whole, mechanism), *(e.left for e in full)}
    is_illustrated = bool(options.pictures or mechanism.reported)
    return ReportContext(
        locale=locale,
        made_by=locale.made_by.format(version=compiled.version),
        conventions=_conventions(whole, mechanism, locale, style),
        convention_of_speeds=_convention(derivation, locale),
        section=_section(options),
        kind=subject(derivation.results, locale),
        title=translated(mechanism.title or mechanism.name, style),
        source=translated(mechanism.source, style),
        parameters=tuple(_parameters(compiled, locale, style, found if options.numbers else None)),
        words=locale.calculation,
        tables=tuple(table_blocks(mechanism.tables, style)),
        scheme=scheme(mechanism, locale, style),
        vectors=tuple(vector_rows(mechanism, locale, style)),
        position=tuple(_position(whole.position, locale, style)),
        steps=tuple(_steps(derivation.steps, locale, style)),
        explained=power_remarks(derivation, mechanism, locale, LatexSpeller(style)),
        balances=_equations(derivation.balances, locale, style),
        last=_last(derivation.last_steps, locale, style),
        results=tuple(section_blocks(whole.results, locale, style)),
        conditions=conditions(derivation.requires, LatexSpeller(style)),
        values=values(full, locale, style),
        of_position=tuple(in_line(item, locale, style) for item in aside),
        numbers=numbers(derivation.results, shown, locale, style),
        check=agreement_with_statics(verdict, locale, style),
        remarks=untried(verdict, locale, style),
        pictures=_pictures(compiled, locale, style) if is_illustrated else NO_PICTURES,
    )


def _conventions(
    whole: ReportOutline, mechanism: Mechanism, locale: Locale, style: LatexNotation
) -> str:
    said = [locale.conventions.format(x="$x$")]
    if named := directions_named(named_directions(whole, mechanism), locale, LatexSpeller(style)):
        said.append(named)
    if has_atan2(whole):
        said.append(direction_function(locale, LatexSpeller(style)))
    if hides_units(whole, mechanism):
        said.append(locale.plain_numbers)
    return " ".join(said)


def _pictures(compiled: Compiled, locale: Locale, style: LatexNotation) -> Pictures:
    return pictures.pictures(compiled, locale, style)


def _preamble() -> Iterable[str]:
    return pictures.preamble()


def brief(
    compiled: Compiled,
    derivation: Derivation,
    locale: Locale,
    style: LatexNotation,
    options: Options,
) -> Brief:
    """Return the formulas of a report alone: of the position, the speeds, the loads, results."""
    mechanism = compiled.mechanism
    whole = outline(derivation, mechanism, looked_up(mechanism))
    found = (
        tuple(short(evaluated(whole, mechanism), derivation, mechanism)) if options.numbers else ()
    )
    bare = [item for item in found if item.numbers is None]
    position = definitions([d for s in whole.position for d in s.where], locale, style, {})
    steps = [_equations(relations(derivation), locale, style)]
    loads = [_equations(map(tuple, needed(derivation)), locale, style)]
    sections = [section_block(s, locale, style) for s in whole.results]
    results = [d for s in sections for d in (*(p.equations for p in s.paragraphs), *s.displays)]
    return Brief(
        locale=locale,
        made_by=locale.made_by.format(version=compiled.version),
        section=_section(options),
        kind=subject(derivation.results, locale),
        title=translated(mechanism.title or mechanism.name, style),
        source=translated(mechanism.source, style),
        displays=tuple(filter(None, (*position, *steps, *loads, *results))),
        numbers=tuple(in_line(item, locale, style) for item in bare),
        values=values([item for item in found if item not in bare], locale, style),
    )


def _position(
    sections: Sequence[PositionSection], locale: Locale, style: LatexNotation
) -> Iterator[PositionBlock]:
    said = position_sentences((s.step for s in sections), locale, LatexSpeller(style))
    for section, words in zip(sections, said, strict=True):
        yield PositionBlock(words, definitions(section.where, locale, style, {}))


def _steps(
    steps: Sequence[DerivationStep], locale: Locale, style: LatexNotation
) -> Iterator[StepBlock]:
    words = sentences(steps, locale, LatexSpeller(style).point)
    for step, sentence in zip(steps, words, strict=True):
        said, hence = (_equations(part, locale, style) for part in lines(step))
        yield StepBlock(sentence, said, hence)


def _equations(equations: Iterable[EquationSides], locale: Locale, style: LatexNotation) -> str:
    """Return equations below each other, each by itself where a sum that is zero is too wide."""
    rows = [(sides, DisplayLine(_chained(sides[:-1], style), sides[-1])) for sides in equations]
    if any(_is_wide(line) for _, line in rows):
        return "\n".join(
            vanishing(sides[0], style, locale.where)
            if _is_wide(line)
            else display((line,), style, locale.where)
            for sides, line in rows
        )
    return display(tuple(line for _, line in rows), style, locale.where) if rows else ""


def _is_wide(line: DisplayLine) -> bool:
    return line.right == ZERO and line.left.width > LINE_WIDTH


def _last(steps: tuple[LastStep, ...], locale: Locale, style: LatexNotation) -> str:
    """Return the solution of the power equation, behind the ratios of speeds that are put in."""
    lines: list[DisplayLine] = []
    for step in steps:
        if step.chain:
            ratio, links, product = step.chain
            between = (part for link in links for part in (plain(r"\cdot "), box(link, style)))
            _, *product_of_links = between
            lines.append(
                DisplayLine(box(ratio, style), product, chain=row(tuple(product_of_links)))
            )
        lines.append(DisplayLine(_chained((step.ratio.left,), style), step.ratio.right))
    return display(tuple(lines), style, locale.where) if lines else ""


def _chained(sides: EquationSides, style: LatexNotation) -> Box:
    first, *others = (box(side, style) for side in sides)
    return row((first, *(part for b in others for part in (plain("="), b))))


def _convention(derivation: Derivation, locale: Locale) -> str:
    return locale.signed if len(derivation.balances) > 1 else locale.magnitudes
