"""What a sheet or a mechanism uses: statements of it in place of the line that says so.

What a used sheet declares gets the prefix, ``pin_d``. A parameter to which something is given
becomes a ``let`` that keeps to its dimension and range; one that follows from others a ``let``,
the others stay parameters. What the used sheet expects of itself stays behind.

Of a mechanism that a sheet uses parameters, loads and results come in. The results are those
that the compiler finds of it; they go beside the statements, which name them only. A mechanism
uses sheets only.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from .. import files
from ..diagnostics import Diagnostic, MechcError, Report, Severity
from ..diagnostics import uses as messages
from ..diagnostics.diagnostic import Related
from ..frozen import replace
from ..source import Source, Span
from ..syntax import ast
from ..syntax.moved import moved
from . import put_in
from .constants import leaves as leaves_of
from .forms import FORMS, form_of
from .load_kinds import Load
from .mechanism import Mechanism, Parameter
from .renamed import renamed
from .result import Result, Solved
from .sheets import WRITTEN_IN_SHEETS, is_sheet
from .statements import every
from .translations import spoken

MOST = 64
"""Sheets that one is put together from, itself included."""

DEEPEST = 16
"""Sheets that use one another in a row."""


class Used(NamedTuple):
    """What is used: its tree, what that means, and its text with what it uses itself.

    The text begins at ``start`` in that of the sheet that uses it. ``solved`` is what was found
    of a mechanism, or of those that a sheet uses itself.
    """

    file: ast.File
    mechanism: Mechanism
    source: Source
    solved: Solved
    start: int = 0

    @property
    def span(self) -> Span:
        """Where its heading stands."""
        return self.mechanism.span.moved(self.start)

    @property
    def parameters(self) -> dict[str, Parameter]:
        """Its parameters that a line declares, by their names there.

        What a loop gives is none that anything could be given to.
        """
        declared = {param.name.text for param in every(self.file, ast.Param)}
        declared -= {d.name for d in self.solved.definitions if d.name in declared}
        return {p.name: p for p in self.mechanism.parameters if p.name in declared}

    @property
    def loads(self) -> dict[str, Load]:
        """Its loads that may be given a value, by their names there."""
        return put_in.open_loads(self.mechanism, self.solved)


Users = tuple[Path, ...]
"""A file, behind those that use it, each by way of the next."""

Resolve = Callable[[Source], Used]
"""Reads a sheet or a mechanism; MechcError where it is wrong."""


class Composed(NamedTuple):
    """A file with what it uses put in, and what was found of the mechanisms among that."""

    file: ast.File
    solved: Solved = Solved()


def with_used(file: ast.File, report: Report, users: Users, resolve: Resolve) -> Composed:
    """Return a file in which what it uses is put in, under its prefixes.

    Names that clash, what is not there, and what is given amiss are reported.
    """
    if not every(file, ast.Use):
        return Composed(file)
    sheet = _is_sheet(file)
    taken = {name.text: name.span for s in file.statements for name in _declared(s)}
    statements: list[ast.Statement] = []
    translated = {line.text for line in every(file, ast.Translate)}
    solved = Solved()
    for statement in file.statements:
        if not isinstance(statement, ast.Use):
            statements.append(statement)
            continue
        used = _read(statement, report, users, resolve)
        if used is None:
            break  # what is wrong there would be found again by each that uses it
        if not sheet and (used.solved.results or not is_sheet(used.mechanism)):
            report.add(messages.mechanism_in_a_mechanism(statement.used.span, used.span))
            break
        found = list(_brought_in(statement, used, report))
        _check_names(statement, found, taken, report)
        statements += _not_translated(found, translated)
        solved += renamed(_without_given(used, statement), statement.prefix.text, used.start)
    return Composed(replace(file, statements=tuple(statements)), solved)


def _not_translated(
    found: Iterable[ast.Statement], translated: set[str]
) -> Iterator[ast.Statement]:
    """Yield statements without translations of texts that are translated; note the new ones.

    One sheet used twice brings its texts twice, and a file's own translation is the last word.
    """
    for statement in found:
        if isinstance(statement, ast.Translate):
            if statement.text in translated:
                continue
            translated.add(statement.text)
        yield statement


def _is_sheet(file: ast.File) -> bool:
    """Return whether a file is a sheet, whatever it uses."""
    return all(isinstance(s, (*WRITTEN_IN_SHEETS, ast.Use)) for s in file.statements)


def _declared(statement: ast.Statement) -> Iterator[ast.Name]:
    """Yield the name that a statement of a sheet declares."""
    match statement:
        case ast.Param(name=name) | ast.Let(name=name) | ast.Taken(name=name):
            yield name
        case ast.Table(name=name) | ast.Sizes(name=name):
            yield name


def _check_names(
    use: ast.Use, found: list[ast.Statement], taken: dict[str, Span], report: Report
) -> None:
    """Report the first name that is there already or means something, and note the others."""
    names = dict.fromkeys(name.text for s in found for name in _declared(s))
    prefix = use.prefix.text
    if odd := next((name for name in names if form_of(name)), None):
        meaning = FORMS[prefix]
        report.add(messages.prefix_makes_quantities(use.prefix.span, prefix, odd, meaning))
    elif clash := next((name for name in names if name in taken), None):
        report.add(messages.prefix_clashes(use.prefix.span, clash, taken[clash]))
    taken |= {name: use.prefix.span for name in names if name not in taken}


# ----------------------------------------------------------------------------- reading


def _read(use: ast.Use, report: Report, users: Users, resolve: Resolve) -> Used | None:
    """Return a sheet that is used; None where something is wrong, which is reported."""
    try:
        used = resolve(_text(use, report.source.folder, users))
    except MechcError as error:
        _pass_on(error, use, report)
        return None
    texts = [text for _, text in (*report.source.parts(), *used.source.parts())]
    if len(texts) > MOST or sum(len(part.text) for part in texts) > files.LARGEST:
        report.add(messages.too_much_used(use.used.span, MOST))
        return None
    return used._replace(start=report.attach(used.source))


def _text(use: ast.Use, folder: Path | None, users: Users) -> Source:
    """Return the text of what is used; what is wrong with it has its place in the use."""
    span = use.used.span
    path = files.used(use.used.text, folder, span)
    if files.resolved(path) in users:
        raise MechcError([messages.used_in_a_circle(span, use.used.text)])
    if len(users) >= DEEPEST:
        raise MechcError([messages.too_much_used(span, MOST)])
    try:
        return files.read(path)
    except MechcError as error:
        raise MechcError(replace(d, span=span) for d in error.diagnostics) from None


def _pass_on(error: MechcError, use: ast.Use, report: Report) -> None:
    """Report what is wrong in a used sheet, with the place where it is used."""
    start = report.attach(error.source) if error.source else 0
    for diagnostic in error.diagnostics:
        if diagnostic.severity is Severity.ERROR:
            inside = error.source is not None
            report.add(_placed(diagnostic, start, use) if inside else diagnostic)


def _placed(diagnostic: Diagnostic, start: int, use: ast.Use) -> Diagnostic:
    here = Related(use.used.span, "it is used here")
    related = (r._replace(span=r.span.moved(start)) for r in diagnostic.related)
    span = diagnostic.span.moved(start) if diagnostic.span else use.used.span
    return replace(diagnostic, span=span, related=(*related, here))


# -------------------------------------------------------------------------- putting in


def _brought_in(use: ast.Use, used: Used, report: Report) -> Iterator[ast.Statement]:
    """Yield the statements of a used sheet or mechanism under its prefix."""
    given = _given(use, used, report)
    sheet = is_sheet(used.mechanism)
    own = used.file.statements if sheet else tuple(_of_a_mechanism(use, used, given))
    names = {name.text for statement in own for name in _declared(statement)}
    prefix = use.prefix.text

    def renamed(name: str) -> str:
        return f"{prefix}_{name}" if name in names else name

    for statement in own:
        there = moved(_with_origin(statement, used.mechanism.name), used.start, renamed)
        match statement, there:
            case ast.Param(name=name), ast.Param():
                yield _parameter(there, _measured(used, name.text), given.get(name.text), use)
            case _, ast.Translate():
                yield from _translated(there, used)
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
    solved = _without_given(used, use)
    values = {p.name for p in used.mechanism.parameters}
    yield from (s for s in used.file.statements if _feeds(s, used, values))
    results = {r.name for r in solved.results}
    rows = tuple(put_in.following(solved, given.keys() | (results & used.loads.keys())))
    known = values | results | {row.name for row in rows}
    wanted = (put_in.needed(solved) | given.keys()) - known
    yield from (put_in.load(load, here) for name, load in used.loads.items() if name in wanted)
    yield from (put_in.taken(result, here) for result in solved.results)
    yield from (put_in.formula(row, here.span) for row in rows)


def _there(use: ast.Use, used: Used) -> ast.Use:
    """Return a use as if its line stood in the used file, all of whose places are moved."""
    return moved(use, -used.start)


def _feeds(statement: ast.Statement, used: Used, values: set[str]) -> bool:
    """Tell whether a mechanism rests on a statement that is one of a sheet, too."""
    match statement:
        case ast.Param(name=name):
            return name.text in used.parameters
        case ast.Let(name=name):
            return name.text in values
        case ast.Require(operands=operands):
            leaves = (leaf for operand in operands for leaf in leaves_of(operand))
            return all(leaf.name in values for leaf in leaves if isinstance(leaf, ast.Symbol))
        case _:
            return isinstance(statement, ast.Table | ast.Sizes)


def _without_given(used: Used, use: ast.Use) -> Solved:
    """Return what was found without the values of loads that are given others."""
    given = {name.text for name, _ in use.given} & used.loads.keys()
    if not given:
        return used.solved
    results = (r for r in used.solved.results if r.name not in given)
    return replace(used.solved, results=tuple(_leaving(r, given) for r in results))


def _leaving(result: Result, names: set[str]) -> Result:
    """Return a result in which some names are left open."""
    where = tuple(d for d in result.where if d.name not in names)
    elsewhere = _leaving(result.elsewhere, names) if result.elsewhere else None
    return replace(result, where=where, elsewhere=elsewhere)


def _given(use: ast.Use, used: Used, report: Report) -> Mapping[str, ast.Expr]:
    """Return what is given to parameters by their names in the used sheet."""
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
    for above, below in put_in.ratios(used.solved):
        if above in found and below in found:
            where = places[above], above, below, places[below]
            report.add(messages.given_both_loads(*where))
    return found


def _parameter(
    statement: ast.Param, parameter: Parameter, given: ast.Expr | None, use: ast.Use
) -> ast.Statement:
    """Return what stands here for a parameter of a used sheet."""
    if given is None and not parameter.dependent:
        return statement
    value = given or statement.value
    assert value is not None
    return ast.Given(
        use.span if given else statement.span,
        statement.name,
        value,
        ast.Name(parameter.unit, statement.span) if parameter.unit else None,
        statement.label,
        comments=statement.comments,
        remark=statement.remark,
        parameter=statement,
        measures=parameter.dimension,
    )


def _translated(line: ast.Translate, used: Used) -> Iterator[ast.Translate]:
    """Yield the translations of those texts of a used sheet that are brought in."""
    said, sources = set[str](), set[str]()
    for statement in used.file.statements:
        match statement:
            case ast.Param(label=label) | ast.Let(label=label):
                said.add(label or statement.remark)
            case ast.Table(source=source) | ast.Sizes(source=source):
                sources.add(source)
            case ast.Require():
                said.add(statement.remark)
    if line.text in said:
        own = {"text": line.text, **spoken(line)}
        yield replace(line, **{k: f"{v} ({used.mechanism.name})" for k, v in own.items()})
    if line.text in sources:
        yield line


def _with_origin(statement: ast.Statement, origin: str) -> ast.Statement:
    """Return a statement whose text, in a report, ends with the sheet that it is from."""
    if isinstance(statement, ast.Param | ast.Let) and statement.label:
        return replace(statement, label=f"{statement.label} ({origin})")
    said = f"{statement.remark} ({origin})" if statement.remark else f"({origin})"
    return replace(statement, remark=said)
