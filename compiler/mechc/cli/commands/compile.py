"""``mechc compile``: one description, any number of outputs."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from ... import events
from ...compilation import Compilation, checked, emit, warnings
from ...diagnostics import near_miss
from ...emit import registry
from ...emit.target import Emitted, Options
from ...files import make_folder, write_all
from ...syntax.settings import Settings
from ...syntax.vocabulary import LANGUAGES
from .. import usage
from ..collisions import claim, refuse_collisions
from ..inputs import (
    by_option,
    claim_of,
    description_argument,
    path_of,
    settings_option,
    stdin_option,
)
from ..opening import opened
from ..output_paths import OutputPath, makefile_rule, outputs, placed, refuse_idle
from ..session import session, session_options
from ..terminal import give
from ..usage import Word, beginning, paths

Text = tuple[Path, str]
"""A file to be written."""


def _known(name: str | None) -> str | None:
    if name is not None and name not in registry.BUILT_IN and name not in registry.names():
        known = registry.names()
        hint = near_miss(name, known)
        raise usage.BadParameter(
            f"{name!r} is not one of {', '.join(known)}{f'; {hint}' if hint else ''}"
        )
    return name


def _formats(begun: str) -> Iterator[usage.Proposal]:
    return beginning(begun, registry.names())


@usage.command("compile", repeatable=True)
@description_argument
@usage.option(
    "--emit",
    "target",
    metavar="FORMAT",
    check=_known,
    complete=_formats,
    help="latex, python, c or json; with -o the suffix says it.",
)
@usage.option(
    "-o",
    "--output",
    "paths",
    multiple=True,
    metavar="PATH",
    complete=paths,
    help="A file (x.c writes x.c and x.h), a folder, or - for standard output. May be repeated.",
)
@usage.option("--fragment", is_flag=True, help="LaTeX without preamble, to \\input.")
@usage.option(
    "--numbers/--no-numbers",
    default=True,
    help="Put the values given into the formulas of LaTeX output.",
)
@usage.option("--brief", is_flag=True, help="LaTeX of the formulas alone, on about a page.")
@usage.option(
    "--pictures",
    is_flag=True,
    help="LaTeX with the scheme, the free bodies, a plot of the first result and its table.",
)
@usage.option(
    "--lang",
    "language",
    kind=Word(LANGUAGES),
    default="en",
    help="The language of LaTeX output.",
)
@usage.option(
    "--gradient",
    is_flag=True,
    help="In C and Python, functions that give results with their slopes by each argument.",
)
@usage.option(
    "--c-real",
    kind=Word(("double", "float")),
    default="double",
    help="The type of real numbers in C: float for processors without double.",
)
@usage.option(
    "--c-openmp",
    is_flag=True,
    help="In C, forms for many poses that use all processors where built with -fopenmp.",
)
@by_option
@settings_option
@usage.option(
    "--deps",
    metavar="FILE",
    complete=paths,
    help="Write a rule for make: the outputs depend on the description. - prints it.",
)
@stdin_option
@session_options
def command(
    file: str,
    target: str | None,
    paths: tuple[str, ...],
    fragment: bool,
    numbers: bool,
    brief: bool,
    pictures: bool,
    language: str,
    gradient: bool,
    c_real: str,
    c_openmp: bool,
    method: str,
    settings: Settings,
    deps: str | None,
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
    given = {
        "--gradient": gradient, "--c-real": c_real != "double", "--c-openmp": c_openmp,
        "--fragment": fragment, "--brief": brief, "--pictures": pictures,
    }  # fmt: skip
    refuse_idle(given, wanted)
    compilation = checked(opened(file, stdin_name, settings))
    session().accept(warnings(compilation), compilation.source)
    options = Options(
        stem="",
        fragment=fragment,
        language=language,
        numbers=numbers,
        brief=brief,
        pictures=pictures,
        gradient=gradient,
        c_real=c_real,
        c_openmp=c_openmp,
        by=method,
    )
    texts, printed = _made(compilation, wanted, options)
    used = compilation.source.used()
    if deps:
        read = filter(None, [path_of(file, stdin_name), *used])
        _add_rule(deps, list(read), texts, printed)
    claims = [claim_of(file), *map(claim, used)]
    refuse_collisions([path for path, _ in texts], claims, bool(printed))
    _deliver(texts, printed, [output.path for output in wanted if output.folder])


def _made(
    compilation: Compilation, wanted: Sequence[OutputPath], options: Options
) -> tuple[list[Text], list[str]]:
    """Return the files to be written, and the texts that go to standard output."""
    made = [(output, _emitted(compilation, output, options)) for output in wanted]
    texts = [file for output, emitted in made for file in placed(output, emitted).items()]
    return texts, [emitted[0].text for output, emitted in made if output.path is None]


def _emitted(compilation: Compilation, output: OutputPath, options: Options) -> tuple[Emitted, ...]:
    if output.target not in registry.BUILT_IN:
        events.report("asked another package", output.target)
    stem = output.stem(compilation.mechanism.name)
    single = output.path is None
    asked = options._replace(stem=stem, single=single, named=not (single or output.folder))
    return emit(compilation, registry.load(output.target), asked)


def _add_rule(deps: str, read: list[Path], texts: list[Text], printed: list[str]) -> None:
    """Add a rule for make to the files, or to what is printed if nothing else is."""
    rule = makefile_rule([path for path, _ in texts], read)
    if deps != "-":
        texts.append((Path(deps), rule))
    elif printed:
        raise usage.UsageError("standard output cannot take both the output and the rule for make")
    else:
        printed.append(rule)


def _deliver(texts: list[Text], printed: list[str], folders: list[Path | None]) -> None:
    """Write all files, or none; then print what goes to standard output."""
    for folder in filter(None, folders):
        make_folder(folder)
    write_all(dict(texts))
    for text in printed:
        give(text)
