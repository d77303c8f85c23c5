"""``mechc compile``: one description, any number of outputs."""

from pathlib import Path
from typing import Literal

import click

from ..driver import Compilation, checked, emit, warnings
from ..emit import registry
from ..emit.target import Emitted, Options
from ..files import make_folder, write_all
from ..syntax.settings import Settings
from .begin import begin
from .inputs import description_argument, path_of, settings_option, stdin_option
from .outputs import Output, makefile_rule, outputs, placed
from .session import Command, session, session_options


def _known(ctx: click.Context, parameter: click.Parameter, name: str | None) -> str | None:
    if name is not None and name not in registry.BUILT_IN and name not in registry.names():
        raise click.BadParameter(f"{name!r} is not one of {', '.join(registry.names())}")
    return name


@click.command("compile", cls=Command)
@description_argument
@click.option(
    "--emit",
    "target",
    metavar="FORMAT",
    callback=_known,
    help="latex, python, c or json; with -o the suffix says it.",
)
@click.option(
    "-o",
    "--output",
    "paths",
    multiple=True,
    metavar="PATH",
    help="A file (x.c writes x.c and x.h), a folder, or - for standard output. May be repeated.",
)
@click.option("--fragment", is_flag=True, help="LaTeX without preamble, to \\input.")
@click.option(
    "--lang",
    "language",
    type=click.Choice(["en", "uk", "ru"]),
    default="en",
    help="The language of LaTeX output.",
)
@settings_option
@click.option(
    "--deps",
    metavar="FILE",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Write a rule for make: the outputs depend on the description.",
)
@stdin_option
@session_options
def command(
    file: str,
    target: str | None,
    paths: tuple[str, ...],
    fragment: bool,
    language: Literal["en", "uk", "ru"],
    settings: Settings,
    deps: Path | None,
    stdin_name: str,
) -> None:
    """Write the formula, its derivation or code.

    FILE is a description (.mech or .yaml), - for standard input, or the NAME of a
    mechanism of the library. Without -o one self-contained file goes to standard output.
    A wrong description writes nothing and leaves existing files as they were.

    \b
    mechc compile clamp.yaml --emit latex > clamp.tex
    mechc compile clamp.mech -o clamp.c -o clamp.py
    mechc compile toggle_press --emit c -o build/ -D theta=5deg
    """
    wanted = outputs(paths, target)
    compilation = checked(begin(file, stdin_name, settings))
    session().accept(warnings(compilation), compilation.source)
    options = Options(stem="", fragment=fragment, language=language)
    made = [(output, _emitted(compilation, output, options)) for output in wanted]
    _deliver(made, deps, path_of(file))


def _emitted(compilation: Compilation, output: Output, options: Options) -> tuple[Emitted, ...]:
    stem = output.stem(compilation.mechanism.name)
    asked = options._replace(stem=stem, single=output.path is None)
    return emit(compilation, registry.load(output.target), asked)


def _deliver(
    made: list[tuple[Output, tuple[Emitted, ...]]], deps: Path | None, read: Path | None
) -> None:
    """Write all files, or none; then print what goes to standard output."""
    files: dict[Path, str] = {}
    for output, emitted in made:
        if output.folder and output.path:
            make_folder(output.path)
        files |= placed(output, emitted)
    if read and any(path.resolve() == read.resolve() for path in files):
        raise click.UsageError(f"the output would overwrite the description {str(read)!r}")
    if deps and read:
        files[deps] = makefile_rule(files, read)
    write_all(files)
    for output, emitted in made:
        if output.path is None:
            click.echo(emitted[0].text, nl=False)
