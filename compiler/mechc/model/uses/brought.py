"""A used sheet or mechanism as statements under its prefix: what it has, or what is found of it.

What is declared gets the prefix. A parameter to which something is given becomes a ``let``
that keeps to its dimension and range; one that follows from others a ``let``, the others
stay parameters. What is expected there stays behind.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...base.frozen import on_demand, replace
from ...diagnostics import Report
from ...diagnostics import uses as messages
from ...source import Span
from ...syntax import ast, moved
from ..constants import leaves as leaves_of
from ..mechanism import Parameter
from ..result import Result, UsedSolution
from ..statements import declared, is_sheet
from ..translations import spoken, translatable_names
from . import mechanism_statements
from .composed import Used


def brought_in(use: ast.Use, used: Used, report: Report) -> Iterator[ast.Statement]:
    """Yield the statements of a used sheet or mechanism under its prefix."""
    given = given_to(use, used, report)
    sheet = is_sheet(used.mechanism)
    own = used.file.statements if sheet else tuple(_of_a_mechanism(use, used, given))
    names = {name.text for statement in own for name in declared(statement)}
    prefix = use.prefix.text

    def renamed(name: str) -> str:
        return f"{prefix}_{name}" if name in names else name

    for statement in own:
        described = with_origin(labelled(statement), used.mechanism.name)
        there = moved.moved(described, used.start, renamed)
        match statement, there:
            case ast.Param(name=name), ast.Param():
                yield parameter(there, _measured(used, name.text), given.get(name.text), use)
            case _, ast.Translate():
                yield from translated(there, used, own)
            case ((ast.Let() | ast.Table() | ast.Sizes() | ast.Require() | ast.Taken()), _):
                yield there


def _measured(used: Used, name: str) -> Parameter:
    """Return the parameter of a name, or what a load is as one."""
    if name in used.parameters:
        return used.parameters[name]
    load = used.loads[name]
    return Parameter(name, load.dimension, load.span)


def _of_a_mechanism(
    use: ast.Use, used: Used, given: Mapping[str, ast.Expr]
) -> Iterator[ast.Statement]:
    """Yield statements for what a mechanism has, by the names and places that it has there."""
    here = _there(use, used)
    solved = without_given(used, use)
    values = {p.name for p in used.mechanism.parameters}
    yield from (s for s in used.file.statements if _feeds(s, used, values))
    results = {r.name for r in solved.results}
    rows = tuple(
        mechanism_statements.following(solved, given.keys() | (results & used.loads.keys()))
    )
    known = values | results | {row.name for row in rows}
    wanted = (mechanism_statements.needed(solved) | given.keys()) - known
    yield from (
        mechanism_statements.load(load, here) for name, load in used.loads.items() if name in wanted
    )
    yield from (
        mechanism_statements.taken(result, here, used.mechanism) for result in solved.results
    )
    yield from (mechanism_statements.formula(row, here.span) for row in rows)


def _there(use: ast.Use, used: Used) -> ast.Use:
    """Return a use as if its line stood in the used file, all of whose places are moved."""
    return moved.moved(use, -used.start)


def _feeds(statement: ast.Statement, used: Used, values: set[str]) -> bool:
    """Return whether a mechanism rests on a statement that is one of a sheet, too."""
    match statement:
        case ast.Param(name=name):
            return name.text in used.parameters
        case ast.Let(name=name):
            return name.text in values
        case ast.Require(operands=operands):
            leaves = (leaf for operand in operands for leaf in leaves_of(operand))
            return all(leaf.name in values for leaf in leaves if isinstance(leaf, ast.Symbol))
        case _:
            return isinstance(statement, ast.Table | ast.Sizes | ast.Translate)


def without_given(used: Used, use: ast.Use) -> UsedSolution:
    """Return the solution without the values of loads that are given others."""
    given = {name.text for name, _ in use.given} & used.loads.keys()
    if not given:
        return used.solved
    results = (r for r in used.solved.results if r.name not in given)
    return replace(used.solved, results=tuple(_without_given(r, given) for r in results))


def _without_given(result: Result, names: set[str]) -> Result:
    """Return a result in which some names are left open."""
    where = tuple(d for d in result.where if d.name not in names)
    other = on_demand(lambda: _without_given(result.elsewhere, names) if result.elsewhere else None)
    return replace(result, where=where, elsewhere=other)


def given_to(use: ast.Use, used: Used, report: Report) -> Mapping[str, ast.Expr]:
    """Return the values given to parameters, by their names in the used sheet."""
    found: dict[str, ast.Expr] = {}
    places: dict[str, Span] = {}
    for name, value in use.given:
        if name.text in places:
            report.add(messages.given_twice(name.span, name.text, places[name.text]))
        elif name.text not in used.parameters and name.text not in used.loads:
            what, known = use.used.text, [*used.parameters, *used.loads]
            report.add(messages.no_such_parameter(name.span, name.text, what, known, used.span))
        else:
            found[name.text] = value
        places.setdefault(name.text, name.span)
    for above, below in mechanism_statements.ratios(used.solved):
        if above in found and below in found:
            where = places[above], above, below, places[below]
            report.add(messages.given_both_loads(*where))
    return found


def parameter(
    statement: ast.Param, parameter: Parameter, given: ast.Expr | None, use: ast.Use
) -> ast.Statement:
    """Return the statement in place of a parameter of a used sheet."""
    if given is None and not parameter.dependent:
        return statement
    value = given or statement.value
    assert value is not None
    return ast.Given(
        use.span if given else statement.span,
        statement.name,
        value,
        ast.Name(parameter.unit, statement.span) if parameter.unit and not given else None,
        statement.label,
        comments=statement.comments,
        remark=statement.remark,
        parameter=statement,
        measures=parameter.dimension,
    )


def translated(
    line: ast.Translate, used: Used, brought: Sequence[ast.Statement]
) -> Iterator[ast.Translate]:
    """Yield the translations of those texts and names of a used sheet that are brought in."""
    sources = {s.source for s in brought if isinstance(s, ast.Table | ast.Sizes)}
    if line.text in labels(brought):
        own = {"text": line.text, **spoken(line)}
        yield replace(line, **{k: f"{v} ({used.mechanism.name})" for k, v in own.items()})
    if line.text in sources or line.text in translatable_names(brought):
        yield line


def labels(statements: Iterable[ast.Statement]) -> set[str]:
    """Return the texts of quantities, links and conditions."""
    said = set[str]()
    for statement in statements:
        match statement:
            case ast.Param(label=label) | ast.Let(label=label):
                said.add(label or statement.remark)
            case ast.Link(label=label):
                said.add(label)
            case ast.Require() | ast.Taken():
                said.add(statement.remark)
    return said


def labelled(statement: ast.Statement) -> ast.Statement:
    """Return a statement whose remark is its text, as it is in a sheet, also where it is used."""
    if isinstance(statement, ast.Param | ast.Let) and not statement.label:
        return replace(statement, label=statement.remark)
    return statement


def with_origin(statement: ast.Statement, origin: str) -> ast.Statement:
    """Return a statement whose text, in a report, ends with the sheet that it is from.

    A quantity without a text has none there either: its prefix says whose it is.
    """
    if isinstance(statement, ast.Param | ast.Let | ast.Link):
        said = f"{statement.label} ({origin})" if statement.label else ""
        return replace(statement, label=said)
    said = f"{statement.remark} ({origin})" if statement.remark else f"({origin})"
    return replace(statement, remark=said)
