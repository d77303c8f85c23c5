"""Quantities with the texts and units that people read them with, and formulas as written."""

from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import chain

from ...base.frozen import replace
from ...formula.walk import symbols
from ...source import Source, Span
from ...syntax import ast
from ...units import ANGLE, LENGTH, UNITS, USUAL_UNITS, Dimension, of_length, si_unit
from ..constants import expressions_in, leaves
from ..mechanism import Let, Mechanism, Parameter, Require, Taken
from ..parts import written
from ..statements import every

ParamOrLet = ast.Param | ast.Let
"""A line that says what a quantity is."""

TableOrSizes = ast.Table | ast.Sizes
"""What values are looked up in."""

PUT_IN = (ast.Given, ast.Follows)
"""The lines that stand for what is given to a used sheet."""


def for_readers(mechanism: Mechanism, file: ast.File, source: Source) -> Mechanism:
    """Return a mechanism, or a sheet, whose quantities have their units and texts.

    The text of a quantity is its label, or else the remark behind its line.

    A formula that names no unit is given in one of those that are written: in it, in the table or
    list that it is looked up in, in what it uses, or anywhere; those of the user's own lines come
    before those of what is used.
    """
    of_lines: tuple[ParamOrLet, ...] = (*every(file, ast.Param), *every(file, ast.Let))
    lines: Mapping[str, ParamOrLet] = {line.name.text: line for line in of_lines}
    of_columns: tuple[TableOrSizes, ...] = (*every(file, ast.Table), *every(file, ast.Sizes))
    columns: Mapping[str, TableOrSizes] = {column.name.text: column for column in of_columns}
    named: Mapping[str, ParamOrLet | TableOrSizes] = {**lines, **columns}
    parameters = tuple(_parameter(p, lines.get(p.name)) for p in mechanism.parameters)
    starts = [start for start, _ in source.parts()]

    def text_of(span: Span) -> int:
        return bisect_right(starts, span.start) - 1

    units = _Units(parameters, named.values(), text_of)
    taken = tuple(_taken(file, mechanism.lets, units))
    put_in = (n for n, s in named.items() if isinstance(s, PUT_IN) or text_of(s.span))
    return replace(
        mechanism,
        parameters=parameters,
        lets=tuple(_let(let, lines[let.name], columns, units) for let in mechanism.lets),
        taken=taken,
        requires=tuple(_with_sides(mechanism.requires, columns, units, file)),
        tables=written.tables(file.statements),
        brought=frozenset((*put_in, *(known.name for known in taken))),
    )


class _Units:
    """The units that quantities are given in, as far as they are known.

    ``text`` says which text a line stands in: the user's own is 0, others are used.
    """

    def __init__(
        self,
        parameters: Iterable[Parameter],
        lines: Iterable[ParamOrLet | TableOrSizes],
        text: Callable[[Span], int],
    ) -> None:
        self._known = {p.name: p.unit for p in parameters}
        self._text_of = {line.name.text: text(line.span) for line in lines}
        self._in_text: dict[int, dict[str, None]] = {}
        for line in lines:
            self._in_text.setdefault(text(line.span), {}).update(dict.fromkeys(_units(line)))

    def given(
        self,
        name: str,
        asked: str,
        dimension: Dimension,
        line: Iterable[str],
        rests_on: Iterable[str],
    ) -> str:
        """Return, and note, the unit of a quantity: the one ``asked`` for, if any.

        Else that of what its line has units of, and mentions, comes first.

        Degrees for an angle where there is none, a power of a unit of length for an area or the
        like, else ''.
        """
        text = self._text_of.get(name, 0)
        unit = asked or self.first(dimension, line, rests_on, text)
        self._known[name] = unit or si_unit(dimension)
        return unit

    def first(
        self, dimension: Dimension, line: Iterable[str], rests_on: Iterable[str], text: int = 0
    ) -> str:
        """Return the first unit of a dimension: of a line, of what it mentions, of the text.

        What stands in the user's own text comes before what is mentioned of others. An angle is
        in degrees unless its line has another unit: formulas around it have degrees.
        """
        if dimension == ANGLE:
            return next((u for u in line if _measures(u, dimension)), "deg")
        names = sorted(rests_on)
        near = [self._known.get(n, "") for n in names if self._text_of.get(n, 0) == text]
        far = [self._known.get(n, "") for n in names if self._text_of.get(n, 0) != text]
        own, around = self._in_text.get(0, ()), self._in_text.get(text, ())
        units = [*line, *near, *own, *far, *around, *self._elsewhere(dimension)]
        powers = (of_length(unit, dimension) for unit in units if _measures(unit, LENGTH))
        return next((u for u in chain(units, powers) if _measures(u, dimension)), "")

    def _elsewhere(self, dimension: Dimension) -> list[str]:
        """Return the units of all texts, the usual one first; none where that is of the SI."""
        usual = USUAL_UNITS.get(dimension, "")
        if usual == si_unit(dimension):
            return []
        return sorted(chain.from_iterable(self._in_text.values()), key=lambda unit: unit != usual)


def _parameter(parameter: Parameter, line: ParamOrLet | None) -> Parameter:
    """Return a parameter with its label, or the remark of its line, and its formula as written."""
    if line is None:
        return parameter
    shown = written.let_value(line.value) if parameter.dependent and line.value else None
    return replace(parameter, label=line.label or line.remark, written=shown)


def _let(let: Let, line: ParamOrLet, columns: Mapping[str, TableOrSizes], units: _Units) -> Let:
    assert isinstance(line, ast.Let)
    shown = written.let_value(line.value)
    looked_up = _units(columns[shown.of]) if shown.of in columns else ()
    near = chain(_units(line), looked_up)
    unit = units.given(let.name, let.unit, let.dimension, near, symbols(let.value))
    return replace(let, unit=unit, label=line.label or line.remark, written=shown)


def _taken(file: ast.File, lets: Iterable[Let], units: _Units) -> Iterator[Taken]:
    """Yield the results of used mechanisms."""
    known, before = {let.name for let in lets}, 0
    for statement in file.statements:
        match statement:
            case ast.Let(name=name):
                before += name.text in known
            case ast.Taken(
                name=name, measures=dimension, rests_on=used, asked=asked, remark=remark
            ):
                rests_on = [symbol.name for symbol in used]
                unit = units.given(name.text, "", dimension, (), rests_on)
                yield Taken(name.text, dimension, name.span, asked, before, unit, remark)


def _with_sides(
    requires: Iterable[Require], columns: Mapping[str, TableOrSizes], units: _Units, file: ast.File
) -> Iterator[Require]:
    """Yield conditions with their unit and with what was written, if anybody wrote them."""
    sides = (link for statement in every(file, ast.Require) for link in written.sides(statement))
    for require in requires:
        has_own = require.written or require.subject
        shown = require.written if has_own else next(sides)
        line = written.units(shown.left, shown.right) if shown else []
        if require.subject and require.subject.name in columns:
            line = list(_units(columns[require.subject.name]))
        names = symbols(require.left) | symbols(require.right)
        yield replace(require, written=shown, unit=units.first(require.dimension, line, names))


def _units(line: ParamOrLet | TableOrSizes) -> Iterator[str]:
    """Yield the units written in a line: that of its result, those of its numbers."""
    if isinstance(line, ast.Let) and line.unit:
        yield line.unit.text
    yield from (unit for e in _expressions(line) for unit in _in_numbers(e))


def _expressions(line: ParamOrLet | TableOrSizes) -> Iterable[ast.Expr]:
    match line:
        case ast.Table(rows=rows):
            return chain.from_iterable(rows)
        case ast.Sizes(sizes=sizes):
            return sizes
        case _:
            return expressions_in(line.value) if line.value is not None else ()


def _in_numbers(expression: ast.Expr) -> Iterator[str]:
    return (leaf.unit for leaf in leaves(expression) if isinstance(leaf, ast.Number))


def _measures(unit: str, dimension: Dimension) -> bool:
    """Return whether a unit is one to give a quantity in: ``N*m/rad`` measures no torque."""
    return unit in UNITS and UNITS[unit].dimension == dimension and not unit.endswith("/rad")
