"""The report of a calculation sheet, ready for its template."""

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence, Set
from itertools import groupby

from ...base.frozen import replace
from ...base.named import NamedTuple
from ...model.parts.written import WrittenTable
from ...report.checks import NoteCheck
from ...report.languages.locale import Locale
from ...report.latex.display import LINE_WIDTH
from ...report.latex.document_style import first_orders
from ...report.latex.given import ParameterRow, parameter_row
from ...report.latex.notation import LatexNotation, name, relation_sign, spellings, translated
from ...report.latex.note import in_numbers, is_plain, measure, remark
from ...report.latex.printer import Box, box, latex
from ...report.latex.quantity import decimal, math, spaced
from ...report.latex.results import LatexSpeller
from ...report.latex.text import begun
from ...report.note import Note, NoteLine, label, note
from ...report.sentences.speller import own_names, plain_names
from ...units import ANGLE
from ..target import Compiled

BETWEEN = 2.0
"""The width between columns of a table, in letters."""


class TableBlock(NamedTuple):
    """A table with two rows of cells, or a list with one; '' for the name of what goes on."""

    name: str
    source: str
    columns: str
    rows: tuple[str, ...]


class LineBlock(NamedTuple):
    """A formula with its value, as a display or behind its text."""

    label: str
    display: str
    remark: str
    is_plain: bool = False


class CheckRow(NamedTuple):
    """A condition in a table of checks."""

    condition: str
    numbers: str
    reserve: str
    verdict: str


class NoteReport(NamedTuple):
    """All that the template of a sheet prints."""

    locale: Locale
    words: Mapping[str, str]
    made_by: str
    section: str
    title: str
    source: str
    parameters: tuple[ParameterRow, ...]
    tables: tuple[TableBlock, ...]
    lines: tuple[LineBlock, ...]
    checks: tuple[CheckRow, ...]
    unused: str


def note_report(
    compiled: Compiled,
    locale: Locale,
    style: LatexNotation,
    fragment: bool,
    derived: Set[str] | None = None,
) -> NoteReport:
    """Return the report of a calculation sheet.

    Of used mechanisms that are reported behind the calculation there are values only; which of
    these are ``derived`` there is said.
    """
    mechanism = compiled.mechanism
    found = note(mechanism, compiled.derivation.results)
    style = _style(compiled, found, style)
    words = locale.calculation
    return NoteReport(
        locale=locale,
        words=words,
        made_by=locale.made_by.format(version=compiled.version),
        section="subsection" if fragment else "section",
        title=translated(mechanism.title or mechanism.name, style),
        source=translated(mechanism.source, style),
        parameters=tuple(parameter_row(p, locale, style) for p in found.given),
        tables=tuple(table_blocks(found.tables, style)),
        lines=tuple(_lines(found.lines, locale, style, derived)),
        checks=tuple(_check(check, words, style) for check in found.checks),
        unused=_unused(found.unused, words, style),
    )


def _unused(names: Iterable[str], words: Mapping[str, str], style: LatexNotation) -> str:
    """Return the sentence about what is not used of other sheets, '' where there is none."""
    said = ", ".join(math(name(n, style)) for n in names)
    return words["unused"].format(names=said) if said else ""


def _style(compiled: Compiled, found: Note, style: LatexNotation) -> LatexNotation:
    """Return the notation with this sheet's angles and with distinct names."""
    parameters = compiled.mechanism.parameters
    angles = {p.name for p in parameters if p.dimension == ANGLE}
    angles |= {line.name for line in found.lines if line.dimension == ANGLE}
    names = [p.name for p in parameters] + [line.name for line in found.lines]
    style = replace(
        style,
        angles=frozenset(angles),
        texts=compiled.mechanism.translations.get(style.language, style.texts),
        pictured=own_names(compiled.mechanism),
        prefixes=compiled.mechanism.prefixes,
        plain=plain_names(compiled.mechanism),
    )
    firsts = first_orders(compiled.derivation.results, style)
    return replace(style, spellings={**spellings(names, style), **firsts})


def table_blocks(tables: Iterable[WrittenTable], style: LatexNotation) -> Iterator[TableBlock]:
    """Yield tables and lists of sizes, in parts that a line holds."""
    for table in tables:
        called, source = math(name(table.name, style)), translated(table.source, style)
        for part in _parts([tuple(box(c, style) for c in cells) for cells in table.rows]):
            rows = tuple(
                " & ".join(math(c.tex) for c in cells) for cells in zip(*part, strict=True)
            )
            yield TableBlock(called, source, "l" * len(part), rows)
            called = source = ""


def _parts(columns: Sequence[tuple[Box, ...]]) -> Iterator[list[tuple[Box, ...]]]:
    """Yield the columns of a table in parts that a line holds."""
    part: list[tuple[Box, ...]] = []
    width = 0.0
    for column in columns:
        widest = max(cell.width for cell in column) + BETWEEN
        if part and width + widest > LINE_WIDTH:
            yield part
            part, width = [], 0.0
        part.append(column)
        width += widest
    yield part


def _lines(
    lines: Iterable[NoteLine], locale: Locale, style: LatexNotation, derived: Set[str] | None
) -> Iterator[LineBlock]:
    """Yield the formulas; what used mechanisms give in a row, where they are reported elsewhere."""
    for is_taken, group in groupby(lines, lambda line: line.is_taken and derived is not None):
        if is_taken:
            yield from _taken([line for line in group if line.result], locale, style, derived or ())
        else:
            yield from (_line(line, locale, style) for line in group)


def _taken(
    lines: Sequence[NoteLine], locale: Locale, style: LatexNotation, derived: Container[str]
) -> Iterator[LineBlock]:
    """Yield results of a mechanism in a row: those that its report derives, then the others."""
    parts = {
        "derived": [line for line in lines if line.name in derived],
        "taken": [line for line in lines if line.name not in derived],
    }
    for key, part in parts.items():
        if said := _values(part, style):
            yield LineBlock(locale.calculation[key], rf"{said}.\par\medskip", "")


def _values(lines: Iterable[NoteLine], style: LatexNotation) -> str:
    """Return the values of results, '' where there are none."""
    return ", ".join(
        math(f"{name(line.name, style)}={measure(line.value, style).tex}")
        for line in lines
        if line.value
    )


def _line(line: NoteLine, locale: Locale, style: LatexNotation) -> LineBlock:
    return LineBlock(
        begun(label(line, translated(line.label, style), locale, LatexSpeller(style))),
        in_numbers(line, locale.where, style),
        remark(line, locale.calculation, style),
        is_plain(line),
    )


def _check(check: NoteCheck, words: Mapping[str, str], style: LatexNotation) -> CheckRow:
    sign = relation_sign(check.operator)
    sides = (latex(side, style) for side in (check.left, check.right))
    values = [measure(side, style).tex for side in check.values or ()]
    reserve = math(decimal(float(f"{check.reserve:.3g}"), style)) if check.reserve else ""
    verdict = words["least" if check.decides else "holds"] if values else ""
    condition = spaced(math(sign.join(sides)))
    label = f"{_called(check.label, style)}: " if check.label else ""
    numbers = math(sign.join(values)) if values else _unknown(check.missing, words, style)
    return CheckRow(label + condition, numbers, reserve, verdict)


def _called(label: str, style: LatexNotation) -> str:
    """Return the text of a condition; of one without it that a used sheet has, this sheet alone."""
    text = translated(label, style)
    return text[1:-1] if text.startswith("(") and text.endswith(")") else text


def _unknown(missing: Iterable[str], words: Mapping[str, str], style: LatexNotation) -> str:
    """Return that a condition has no numbers, and what it lacks."""
    names = ", ".join(math(name(n, style)) for n in missing)
    return words["missing"].format(names=names) if names else words["unknown"]
