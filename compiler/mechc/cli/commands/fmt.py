"""``mechc fmt``: the usual layout, in place; or the other notation."""

from difflib import unified_diff
from pathlib import Path
from typing import Literal

from ...base.named import NamedTuple
from ...diagnostics import MechcError
from ...files import write_all
from ...source import Source
from ...syntax import ast
from ...syntax.notation import is_yaml, read, report_on
from ...syntax.to_dsl import to_dsl
from ...syntax.to_yaml import in_yaml_order, to_yaml
from .. import usage
from ..exit_status import status
from ..inputs import expanded, source_of, stdin_option
from ..session import session, session_options
from ..terminal import give, warn
from ..usage import Word, paths

SourceNotation = Literal["mech", "yaml"]


class Formatted(NamedTuple):
    """One file before and after; ``path`` is None for standard input."""

    path: Path | None
    source: Source
    text: str

    @property
    def changed(self) -> bool:
        """Return whether formatting changes anything."""
        return self.text != self.source.text


@usage.command("fmt")
@usage.argument("files", several=True, metavar="FILE|FOLDER|-...", complete=paths)
@usage.option("--check", is_flag=True, help="Write nothing; status 1 if a file would change.")
@usage.option("--diff", is_flag=True, help="Write nothing; print what would change, status 1.")
@usage.option("--to", kind=Word(("mech", "yaml")), help="Print in the other notation.")
@stdin_option
@session_options
def command(
    files: tuple[str, ...], check: bool, diff: bool, to: SourceNotation | None, stdin_name: str
) -> int:
    """Lay out descriptions in place; turn one notation into the other.

    Comments are kept. With --to the result goes to standard output, and so does
    standard input (-). A folder stands for all descriptions below it, hidden folders
    left out; each that changes is named.

    \b
    mechc fmt clamp.mech
    mechc fmt --diff .
    mechc fmt --to yaml clamp.mech > clamp.yaml
    """
    worst, done = 0, []
    names = list(expanded(files))
    if to and len(names) > 1 and not (check or diff):
        raise usage.UsageError(f"--to prints one description, {len(names)} are given")
    if names.count("-") > 1:
        raise usage.UsageError("standard input (-) is read once")
    for name in names:
        try:
            done.append(_formatted(name, stdin_name, to))
        except MechcError as error:
            session().show(error.diagnostics, error.source)
            worst = max(worst, status(error.diagnostics))
    if check or diff:
        worst = max([worst, *(_remarked(f, diff) for f in done)])
    else:
        _put(done, to)
        if not to and any(Path(name).is_dir() for name in files):
            for file in (f for f in done if f.changed and f.path):
                warn(f"changed {file.source.name}")
    return worst


def _formatted(name: str, stdin_name: str, to: SourceNotation | None) -> Formatted:
    source = source_of(name, stdin_name)
    path = Path(name) if name != "-" and Path(name).exists() else None
    return Formatted(path, source, layout(source, to))


def layout(source: Source, to: SourceNotation | None = None) -> str:
    """Return the description in the usual layout, in its own notation or another.

    The result is read again, and must be the same tree: nothing is lost by formatting.
    """
    tree = _tree(source)
    yaml = is_yaml(source) if to is None else to == "yaml"
    text = to_yaml(tree) if yaml else to_dsl(tree)
    if not _says(text, tree, yaml):
        raise RuntimeError(f"the layout of {source.name} would change its meaning")
    return text


def _says(text: str, tree: ast.File, yaml: bool) -> bool:
    """Return whether a text is read as this tree (places and YAML's order aside)."""
    try:
        again = _tree(Source("layout.yaml" if yaml else "layout.mech", text))
    except MechcError:
        return False
    return _by_kind(again) == _by_kind(in_yaml_order(tree) if yaml else tree)


def _by_kind(tree: ast.File) -> dict[str, list[ast.Statement]]:
    """Group statements as YAML does: the order among kinds has no meaning."""
    groups: dict[str, list[ast.Statement]] = {}
    for statement in tree.statements:
        groups.setdefault(type(statement).__name__, []).append(statement)
    return groups


def _tree(source: Source) -> ast.File:
    report = report_on(source)
    tree = read(source, report)
    report.stop_on_errors()
    return tree


def _remarked(file: Formatted, diff: bool) -> int:
    if file.changed and diff:
        name = file.source.name
        before, after = (t.splitlines(keepends=True) for t in (file.source.text, file.text))
        give("".join(unified_diff(before, after, name, name)))
    elif file.changed:
        warn(f"would change {file.source.name}")
    return int(file.changed)


def _put(files: list[Formatted], to: SourceNotation | None) -> None:
    """Print what was asked for on standard output; write the others where they changed."""
    write_all({f.path: f.text for f in files if f.path and f.changed and not to})
    for file in files:
        if to or not file.path:
            give(file.text)
