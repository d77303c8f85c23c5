"""``mechc check``: mistakes found, expectations proved or refuted, the second opinion."""

from collections.abc import Iterable

from ...compilation import Compilation, complete, warnings
from ...diagnostics import MechcError
from ...syntax.settings import Settings
from ...syntax.vocabulary import LANGUAGES
from .. import usage
from ..check_lines import failing, overview_of, report
from ..exit_status import status
from ..inputs import expanded, settings_option, stdin_option
from ..opening import opened
from ..session import session, session_options
from ..terminal import line_width, say
from ..usage import Word, descriptions


@usage.command("check", repeatable=True)
@usage.argument("files", several=True, metavar="FILE|FOLDER|NAME|-...", complete=descriptions)
@usage.option("-v", "--verbose", is_flag=True, help="Show what is given, and every pose.")
@usage.option("-q", "--quiet", is_flag=True, help="Print errors and warnings only.")
@usage.option(
    "--lang", "language", kind=Word(LANGUAGES), default="en", show_default=True,
    help="The language of what is found; errors and warnings are in English.",
)  # fmt: skip
@settings_option
@stdin_option
@session_options
def command(
    files: tuple[str, ...],
    verbose: bool,
    quiet: bool,
    language: str,
    settings: Settings,
    stdin_name: str,
) -> int:
    """Find mistakes; prove or refute expectations.

    Every `expect` is proved by algebra, or refuted by a pose with both numbers. Every
    result is compared with the equilibrium of the free bodies at several poses. A folder
    stands for all descriptions below it, hidden folders left out. --verbose lists points,
    parameters and vectors, of a wrong description too: what has no value, place or direction.

    \b
    mechc check clamp.mech
    mechc check --verbose toggle_press
    mechc check --lang uk toggle_press
    mechc check --format concise drawings/
    """
    worst = 0
    for file in list(expanded(files)):
        compilation: Compilation | None = None
        try:
            compilation = opened(file, stdin_name, settings)
            complete(compilation)
        except MechcError as error:
            session().show(error.diagnostics, error.source)
            worst = max(worst, status(error.diagnostics))
            if compilation and not quiet:
                _say(failing(compilation, error.diagnostics, language, line_width()))
            if compilation and verbose:
                _say(overview_of(compilation, language))
            continue
        worst = max(worst, _warned(compilation))
        if not quiet:
            _say(report(compilation, verbose, language, line_width()))
    return worst


def _warned(compilation: Compilation) -> int:
    """Show the warnings of a description and of what it uses; return the status they ask for."""
    found = 0
    for checked in (compilation, *(used for _, used in compilation.used_mechanisms)):
        session().show(warnings(checked), checked.source)
        if session().werror and warnings(checked):
            found = 1
    return found


def _say(lines: Iterable[str]) -> None:
    for line in lines:
        say(line)
