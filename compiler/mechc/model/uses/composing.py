"""What a sheet or a mechanism uses: statements of it in place of the line that says so.

What a used sheet declares gets the prefix, ``pin_d`` (:mod:`.brought`). Of a mechanism that a
sheet uses parameters, loads and results come in. The results are those that the compiler finds
of it; they go along with the statements, which name them only. A mechanism uses sheets, and other
mechanisms that it is joined to: these become parts of it (:mod:`.joining`).
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path

from ... import files
from ...base.frozen import replace
from ...diagnostics import Diagnostic, MechcError, Report, Severity
from ...diagnostics import joining as join_messages
from ...diagnostics import uses as messages
from ...source import Source
from ...syntax import ast
from ..mechanism import Subassembly
from ..names.forms import FORMS, form_of
from ..result import UsedSolution
from ..statements import WRITTEN_IN_SHEETS, declared, every, is_sheet
from . import part_names
from .brought import brought_in, without_given
from .composed import DOTTED, Composed, Used
from .joining import part_of
from .joint_points import UsedPart, WholeMechanism, points_of_parts, structural
from .part_names import Renaming, spelled_out
from .prefixed import prefixed

MOST_SHEETS = 64
"""Sheets that one is put together from, itself included."""

MOST_NESTED_SHEETS = 16
"""Sheets that use one another in a row."""


Users = tuple[Path, ...]
"""A file, behind those that use it, each by way of the next."""

Resolve = Callable[[Source, bool], Used]
"""Reads a sheet or a mechanism, or one that becomes a part; MechcError where it is wrong."""


def with_used(file: ast.File, report: Report, users: Users, resolve: Resolve) -> Composed:
    """Return a file in which what it uses is put in, under its prefixes.

    Names that clash, what is not there, and what is given amiss are reported.
    """
    if every(file, ast.Use):
        return _Composing(file, report, users, resolve).composed()
    named = _without_dots(file.statements, spelled_out(points_of_parts({}, report)))
    return Composed(replace(file, statements=tuple(named)))


class _Composing:
    """Puts what a file uses in its place, one line after another."""

    def __init__(self, file: ast.File, report: Report, users: Users, resolve: Resolve) -> None:
        self._file, self._report, self._users, self._resolve = file, report, users, resolve
        self._own = tuple(s for s in file.statements if not isinstance(s, ast.Use))
        self._taken = {name.text: name.span for s in self._own for name in declared(s)}
        self._translated = {line.text for line in every(file, ast.Translate)}
        self._joined = structural(file)
        self._parts: dict[str, UsedPart] = {}
        self._solved = UsedSolution()
        self._mechanisms: list[tuple[str, Source]] = []
        self._prefixes: list[str] = []

    def composed(self) -> Composed:
        """Return the file with all that it uses, as far as nothing is wrong."""
        lines = list(self._lines())
        if len(lines) == len(self._file.statements):  # no `use` was wrong, at which lines end
            lines = self._with_whole_names(lines)
        file = replace(self._file, statements=tuple(chain.from_iterable(lines)))
        parts = tuple(
            Subassembly(prefix, part.used.mechanism.name, tuple(part.points.items()))
            for prefix, part in self._parts.items()
        )
        mechanisms, prefixes = tuple(self._mechanisms), tuple(self._prefixes)
        return Composed(file, self._solved, parts, mechanisms, prefixes)

    def _lines(self) -> Iterator[Sequence[ast.Statement]]:
        """Yield each line of the file, or what it brings in.

        None after a use in which something is wrong: each that uses it would find that again.
        """
        for statement in self._file.statements:
            if not isinstance(statement, ast.Use):
                yield (statement,)
                continue
            found = self._brought(statement)
            if found is None:
                return
            self._check_names(statement, found)
            yield tuple(self._not_translated(found))

    def _with_whole_names(
        self, lines: Sequence[Sequence[ast.Statement]]
    ) -> list[Sequence[ast.Statement]]:
        """Return the lines; those of the file itself name points of parts as the whole has them."""
        names = spelled_out(points_of_parts(self._parts, self._report))
        if not self._parts and not DOTTED.search(self._report.source.text):
            return list(lines)
        both = zip(self._file.statements, lines, strict=True)
        return [s if isinstance(at, ast.Use) else _without_dots(s, names) for at, s in both]

    def _brought(self, use: ast.Use) -> Sequence[ast.Statement] | None:
        """Return the statements that a line brings in; None where an error is reported."""
        is_part = use.prefix.text in self._joined
        used = _read(use, self._report, self._users, lambda source: self._resolve(source, is_part))
        if used is None:
            return None
        if is_part:
            return self._part(use, used)
        if word := _of_a_part(use):
            self._report.add(join_messages.part_without_joint(use.prefix.span, word))
            return None
        if not _is_sheet(self._file) and (used.solved.results or not is_sheet(used.mechanism)):
            self._report.add(messages.mechanism_in_a_mechanism(use.used.span, used.span))
            return None
        self._solved += prefixed(without_given(used, use), use.prefix.text, used.start)
        self._mechanisms += _mechanisms(use.prefix.text, used)
        self._prefixes += _prefixes(use.prefix.text, used)
        found = tuple(brought_in(use, used, self._report))
        names = {name.text for statement in found for name in declared(statement)}
        prefix = use.prefix.text
        loads = tuple(name for name in used.loads if f"{prefix}_{name}" not in names)
        own = (load.name for load in used.mechanism.loads if load.name not in used.loads)
        inner = tuple(name for name in own if f"{prefix}_{name}" not in names)
        points = dict.fromkeys(p for body in used.mechanism.bodies for p in body.points)
        return ast.Brought(use.span, prefix, use.used.text, loads, inner, tuple(points)), *found

    def _part(self, use: ast.Use, used: Used) -> Sequence[ast.Statement] | None:
        """Return the statements of a used mechanism as a part; None where an error was reported."""
        parts = [s for part in self._parts.values() for s in part.statements]
        whole, met = (
            WholeMechanism((*self._own, *parts), self._parts),
            self._joined[use.prefix.text],
        )
        part = part_of(use, used, whole, met, self._report)
        if part is None:
            return None
        self._parts[use.prefix.text] = part
        return part.statements

    def _not_translated(self, found: Iterable[ast.Statement]) -> Iterator[ast.Statement]:
        """Yield statements without translations of texts that are translated; note the new ones.

        One sheet used twice brings its texts twice, and a file's own translation is the last word.
        """
        for statement in found:
            if isinstance(statement, ast.Translate):
                if statement.text in self._translated:
                    continue
                self._translated.add(statement.text)
            yield statement

    def _check_names(self, use: ast.Use, found: Iterable[ast.Statement]) -> None:
        """Report the first name that is there already or means something, and note the others."""
        names = dict.fromkeys(name.text for s in found for name in declared(s))
        prefix, span = use.prefix.text, use.prefix.span
        if odd := next((name for name in names if form_of(name)), None):
            self._report.add(messages.prefix_makes_quantities(span, prefix, odd, FORMS[prefix]))
        elif clash := next((name for name in names if name in self._taken), None):
            self._report.add(messages.prefix_clashes(span, clash, self._taken[clash]))
        self._taken |= {name: span for name in names if name not in self._taken}


def _mechanisms(prefix: str, used: Used) -> Iterator[tuple[str, Source]]:
    """Yield the text of a mechanism that is used, or those that a sheet uses, by their prefixes."""
    if not is_sheet(used.mechanism):
        yield prefix, replace(used.source, attached=())
    for inner, source in used.mechanisms:
        yield f"{prefix}_{inner}", source


def _prefixes(prefix: str, used: Used) -> Iterator[str]:
    """Yield the prefix of what is used, and those of what that uses itself."""
    yield prefix
    yield from (f"{prefix}_{inner}" for inner in used.mechanism.prefixes)


def _without_dots(statements: Iterable[ast.Statement], names: Renaming) -> list[ast.Statement]:
    """Return statements in which points of parts have the names that they have in the whole."""
    return [part_names.renamed(statement, names) for statement in statements]


def _of_a_part(use: ast.Use) -> str:
    """Return the first word of a line that is said of a part only; '' where there is none."""
    words = {"at": use.at, "turned": use.turned, "without": use.without}
    return next((word for word, value in words.items() if value), "")


def _is_sheet(file: ast.File) -> bool:
    """Return whether a file is a sheet, whatever it uses."""
    uses = every(file, ast.Use)
    joins = any(use.joining for use in uses)
    return not joins and all(isinstance(s, (*WRITTEN_IN_SHEETS, ast.Use)) for s in file.statements)


# ----------------------------------------------------------------------------- reading


def _read(
    use: ast.Use, report: Report, users: Users, resolve: Callable[[Source], Used]
) -> Used | None:
    """Return a sheet that is used; None where something is wrong, which is reported."""
    try:
        used = resolve(_text(use, report.source.folder, users))
    except MechcError as error:
        _pass_on(error, use, report)
        return None
    texts = [text for _, text in (*report.source.parts(), *used.source.parts())]
    if (
        len(texts) > MOST_SHEETS
        or sum(len(part.text) for part in texts) > files.LARGEST_DESCRIPTION
    ):
        report.add(messages.too_much_used(use.used.span, MOST_SHEETS))
        return None
    return used._replace(start=report.attach(used.source, use.used.span))


def _text(use: ast.Use, folder: Path | None, users: Users) -> Source:
    """Return the text of what is used; what is wrong with it has its place in the use."""
    span = use.used.span
    path = files.used(use.used.text, folder, span)
    if files.resolved(path) in users:
        raise MechcError([messages.used_in_a_circle(span, use.used.text)])
    if len(users) >= MOST_NESTED_SHEETS:
        raise MechcError([messages.too_much_used(span, MOST_SHEETS)])
    try:
        return files.read(path)
    except MechcError as error:
        raise MechcError(replace(d, span=span) for d in error.diagnostics) from None


def _pass_on(error: MechcError, use: ast.Use, report: Report) -> None:
    """Report what is wrong in a used sheet, with the place where it is used."""
    start = report.attach(error.source, use.used.span) if error.source else 0
    for diagnostic in error.diagnostics:
        if diagnostic.severity is Severity.ERROR:
            inside = error.source is not None
            report.add(_placed(diagnostic, start, use) if inside else diagnostic)


def _placed(diagnostic: Diagnostic, start: int, use: ast.Use) -> Diagnostic:
    related = tuple(r._replace(span=r.span.moved(start)) for r in diagnostic.related)
    span = diagnostic.span.moved(start) if diagnostic.span else use.used.span
    return replace(diagnostic, span=span, related=related)
