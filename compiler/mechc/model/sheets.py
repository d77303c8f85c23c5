"""What makes a description a calculation sheet, and what people read of one."""

from collections.abc import Iterable, Iterator, Mapping

from ..diagnostics import Report
from ..diagnostics.model.sheets import links_in_a_sheet
from ..formula.walk import symbols
from ..frozen import replace
from ..syntax import ast
from ..units import ANGLE, UNITS, Dimension
from . import written
from .constants import expressions_in, leaves
from .mechanism import Let, Mechanism, Parameter, Require, Taken
from .statements import every, only

WRITTEN_IN_SHEETS = (
    *(ast.Version, ast.Heading, ast.SourceNote),
    *(ast.Param, ast.Table, ast.Sizes, ast.Let, ast.Taken, ast.Require, ast.Expect),
    *(ast.Translate, ast.Reported),
)
"""The statements of a sheet: a description that has others describes a mechanism."""


def is_sheet(mechanism: Mechanism) -> bool:
    """Return whether a description has formulas only, and nothing that could move."""
    parts = (mechanism.links, mechanism.slides, mechanism.telescopes, mechanism.joints)
    return not (any(parts) or mechanism.loads or mechanism.finds or mechanism.spans)


def written_as_sheet(file: ast.File) -> bool:
    """Return whether a file has statements of a sheet only."""
    return all(isinstance(statement, WRITTEN_IN_SHEETS) for statement in file.statements)


def refuse_links_in_a_sheet(file: ast.File, report: Report) -> None:
    """Report the first statement of a mechanism where the heading says that it is a sheet."""
    if heading := only(file, ast.SheetHeading):
        strange = (s for s in file.statements if not isinstance(s, WRITTEN_IN_SHEETS))
        report.add(links_in_a_sheet(next(strange).span, heading.span))


def as_written(mechanism: Mechanism, file: ast.File) -> Mechanism:
    """Return a sheet whose quantities have the texts and units that people read them with.

    The text of a quantity is its label, or the remark behind its line.
    """
    lines: dict[str, ast.Param | ast.Let] = {p.name.text: p for p in every(file, ast.Param)}
    lines |= {let.name.text: let for let in every(file, ast.Let)}
    remarks = {name: line.label or line.remark for name, line in lines.items()}
    parameters = tuple(replace(p, label=remarks[p.name]) for p in mechanism.parameters)
    units: dict[str, str] = {p.name: p.unit for p in parameters}
    named = [unit for line in lines.values() if isinstance(line, ast.Let) for unit in _units(line)]
    taken = tuple(_taken(file, mechanism.lets, [*units.values(), *named]))
    units |= {result.name: result.unit for result in taken}
    lets: list[Let] = []
    for let in mechanism.lets:
        line = lines[let.name]
        assert isinstance(line, ast.Let)
        unit = let.unit or _unit(let, line, units, mechanism.parameters)
        units[let.name] = unit
        shown = written.let_value(line.value)
        lets.append(replace(let, unit=unit, label=remarks[let.name], written=shown))
    return replace(
        mechanism,
        parameters=parameters,
        lets=tuple(lets),
        taken=taken,
        requires=tuple(_with_sides(mechanism.requires, units, file)),
        tables=written.tables(file.statements),
    )


def _taken(file: ast.File, lets: Iterable[Let], units: Iterable[str]) -> Iterator[Taken]:
    """Yield the results of used mechanisms, in the units of their kind that are written first."""
    known, before = {let.name for let in lets}, 0
    for statement in file.statements:
        match statement:
            case ast.Let(name=name):
                before += name.text in known
            case ast.Taken(name=name, measures=dimension, remark=remark):
                unit = _first(units, dimension)
                yield Taken(name.text, dimension, name.span, before, unit, remark)


def _with_sides(
    requires: Iterable[Require], units: Mapping[str, str], file: ast.File
) -> Iterator[Require]:
    """Yield conditions with their unit and with what was written, if anybody wrote them."""
    sides = (link for statement in every(file, ast.Require) for link in written.sides(statement))
    for require in requires:
        shown = None if require.subject else next(sides)
        own = written.units(shown.left, shown.right) if shown else []
        names = sorted(symbols(require.left) | symbols(require.right))
        unit = _first(
            [*own, *(units.get(n, "") for n in names), *units.values()], require.dimension
        )
        yield replace(require, written=shown, unit=unit)


def _unit(
    let: Let, line: ast.Let, units: Mapping[str, str], parameters: tuple[Parameter, ...]
) -> str:
    """Return the unit of what a formula measures that was written first.

    In the formula itself, in what it uses, or anywhere in the sheet; '' where there is none.
    """
    used = [units.get(name, "") for name in sorted(symbols(let.value))]
    own = [*_units(line), *used, *(p.unit for p in parameters)]
    return _first(own, let.dimension)


def _first(units: Iterable[str], dimension: Dimension) -> str:
    """Return the first unit of a dimension; degrees where there is none of an angle."""
    usual = "deg" if dimension == ANGLE else ""
    return next((unit for unit in units if _measures(unit, dimension)), usual)


def _units(line: ast.Let) -> Iterator[str]:
    """Yield the units written in a formula."""
    for expression in expressions_in(line.value):
        for leaf in leaves(expression):
            if isinstance(leaf, ast.Number):
                yield leaf.unit


def _measures(unit: str, dimension: Dimension) -> bool:
    return bool(unit) and UNITS[unit].dimension == dimension
