"""Parameters set from outside (``-D alpha=30deg``): put into the tree in place of the file's.

A setting is read with the project's own grammar, as the value of a ``param`` line of
its own, so that what may stand there is exactly what may stand in a file.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import assert_never

from ..base.frozen import replace
from ..base.later import pattern
from ..base.named import NamedTuple
from ..diagnostics import Report, syntax
from ..source import Source, Span
from ..units import DIMENSIONS, NUMBER, UNITS
from . import ast, moved
from .notation import read
from .vocabulary import points_of


class Setting(NamedTuple):
    """A new value of a parameter, and the text that it was read from."""

    value: ast.Expr
    source: Source


Settings = Mapping[str, Setting]
"""New values of parameters, by name."""

COMMAND_LINE = "-D"
"""What messages call the text of a setting."""

_WORD = "param "
_UNIT = pattern(r"(?<=[\d.])(?=[a-zA-Z])(?![eE][+-]?\d)")


def parse(text: str, origin: str = COMMAND_LINE) -> tuple[str, Setting]:
    """Return name and setting of ``NAME=VALUE``; the space before a unit may be left out.

    ``origin`` is what messages call the place where it was written.

    Raises :class:`MechcError` where the value is no expression.

    >>> name, (value, source) = parse("alpha=30deg")
    >>> name, value.digits, value.unit, source.text
    ('alpha', '30', 'deg', 'alpha = 30 deg')
    """
    name, _, value = text.partition("=")
    setting = f"{name.strip()} = {_UNIT.sub(' ', ' '.join(value.split()))}"
    report = Report(Source(f"{origin} {text}", f"{_WORD}{setting}\n"))
    tree = read(report.source, report)
    report.stop_on_errors()
    found = next(s for s in params(tree.statements) if s.value)
    assert found.value is not None
    if found.low or found.tolerance or found.label or found.about:
        place = Span(found.value.span.end, found.span.end)
        words = f"'{report.source.written(place).strip()}'"
        hint = "a value alone is set; its range stands where the parameter is declared"
        raise report.fail(syntax.unexpected_text(place, words, ["the end"], hint))
    alone = moved.moved(found.value, -len(_WORD))
    return name.strip(), Setting(alone, Source(origin, setting))


def attached(source: Source, settings: Settings) -> Source:
    """Return a description with the texts of settings behind it, where messages find them."""
    return replace(source, attached=tuple(s.source for s in settings.values()))


def with_settings(tree: ast.File, settings: Settings, source: Source) -> ast.File:
    """Return the tree with the values of the named parameters replaced, and named loads given.

    Their places are those of the settings' texts in the source that they are attached to.
    """
    if not settings:
        return tree
    starts = (start for start, _ in list(source.parts())[1:])  # what is used stands behind them
    values = {
        name: moved.moved(setting.value, start)
        for (name, setting), start in zip(settings.items(), starts, strict=False)
    }
    changed = tuple(_set(s, values) for s in tree.statements)
    return replace(tree, statements=(*changed, *_given_loads(changed, values)))


def _given_loads(
    statements: tuple[ast.Statement, ...], values: Mapping[str, ast.Expr]
) -> Iterator[ast.Let]:
    """Yield ``let F = 2 kN`` for each load with a value from outside that no line gives it."""
    names = dict.fromkeys(s.name.text for s in statements if isinstance(s, ast.NamedLoad))
    lets = {s.name.text for s in statements if isinstance(s, ast.Let)}
    for name in names:
        if name in values and name not in lets:
            yield ast.Let(values[name].span, ast.Name(name, values[name].span), values[name])


def drives(statements: Iterable[ast.Statement]) -> tuple[ast.Drive, ...]:
    """Return the drives among statements, in order: the first one moves."""
    return tuple(s for s in statements if isinstance(s, ast.Drive))


def driven_by(tree: ast.File, name: str) -> ast.File:
    """Return the tree with the drive of a name before the others, so that it moves."""
    found = drives(tree.statements)
    order = iter(sorted(found, key=lambda drive: drive.name.text != name))
    changed = tuple(next(order) if isinstance(s, ast.Drive) else s for s in tree.statements)
    return replace(tree, statements=changed)


def params(statements: Iterable[ast.Statement]) -> tuple[ast.Param, ...]:
    """Return the parameter declarations among statements, in order."""
    return tuple(s for s in statements if isinstance(s, ast.Param))


def driven(statements: Iterable[ast.Statement]) -> tuple[str, ...]:
    """Return the names of what is driven by points: ``phi_OA``, of a telescope ``len_OA``."""
    nodes = tuple(statements)
    slack = [{*points_of(t.points.text)} for t in nodes if isinstance(t, ast.Telescope)]
    drives = (s.name.text for s in nodes if isinstance(s, ast.Drive))
    linked = ((name, {*points_of(name)}) for name in drives if len(points_of(name)) == 2)
    return tuple(f"{'len' if ends in slack else 'phi'}_{name}" for name, ends in linked)


def _set(statement: ast.Statement, values: Mapping[str, ast.Expr]) -> ast.Statement:
    """Return a line with the value that the command line sets, if it sets one.

    A parameter that follows from others by it loses its range and its tolerance.
    """
    if isinstance(statement, ast.Drive):
        start = values.get(f"phi_{statement.name.text}", values.get(f"len_{statement.name.text}"))
        return replace(statement, start=start) if start else statement
    if isinstance(statement, ast.Let):
        return replace(statement, value=values.get(statement.name.text, statement.value))
    if not isinstance(statement, ast.Param) or statement.name.text not in values:
        return statement
    dimension = statement.dimension or _dimension(statement.value)
    value = values[statement.name.text]
    found = replace(statement, value=value, replaced=statement.value, dimension=dimension)
    follows = _names_something(value)
    return replace(found, low=None, high=None, tolerance=None) if follows else found


def _names_something(value: ast.Expr) -> bool:
    """Return whether a value follows from others: what then varies has no range of its own."""
    match value:
        case ast.Symbol(name):
            return name != "pi"
        case ast.Number():
            return False
        case ast.Sum(terms=parts) | ast.Product(factors=parts):
            return any(_names_something(part) for _, part in parts)
        case ast.Power(base, exponent):
            return _names_something(base) or _names_something(exponent)
        case ast.Call(arguments=arguments):
            return any(map(_names_something, arguments))
        case _:
            assert_never(value)


def _dimension(value: ast.Expr | None) -> ast.Name | None:
    """Return the dimension of the value in the file, so that one without its unit is noticed."""
    match value:
        case ast.Number(unit=unit) | ast.Sum(terms=((_, ast.Number(unit=unit)),)):
            measured = UNITS[unit].dimension if unit else NUMBER
            names = (name for name, known in DIMENSIONS.items() if known == measured)
            return next((ast.Name(name, value.span) for name in names), None)
    return None
