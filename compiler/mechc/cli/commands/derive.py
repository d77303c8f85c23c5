"""``mechc derive``: the derivation, for the terminal."""

from ...calculation.calculation import Calculation
from ...compilation import complete, warnings
from ...diagnostics import MechcError
from ...report.text import note
from ...report.text.derivation import render, render_brief
from ...report.text.speller import speller
from ...syntax.settings import Settings
from ...syntax.vocabulary import LANGUAGES
from .. import usage
from ..check_lines import refused
from ..inputs import by_option, description_argument, settings_option, stdin_option
from ..opening import opened
from ..session import session, session_options
from ..terminal import columns, say, speaks_unicode
from ..usage import Word


@usage.command("derive", repeatable=True)
@description_argument
@usage.option("--numbers/--no-numbers", default=True, help="Put the values given into formulas.")
@usage.option("--brief", is_flag=True, help="Print the formulas alone.")
@usage.option(
    "--lang", "language", kind=Word(LANGUAGES), default="en", show_default=True,
    help="The language of the derivation.",
)  # fmt: skip
@by_option
@settings_option
@stdin_option
@session_options
def command(
    file: str,
    numbers: bool,
    brief: bool,
    language: str,
    method: str,
    settings: Settings,
    stdin_name: str,
) -> None:
    """Print the derivation of k step by step.

    Each velocity relation with the rule that gives it, the power equation, k, and where
    it vanishes and blows up, then the same with the values given put in.

    \b
    mechc derive clamp.mech
    mechc derive clamp.mech --brief --lang uk
    mechc derive clamp.mech --by equilibrium
    """
    compilation = opened(file, stdin_name, settings)
    try:
        complete(compilation)
    except MechcError as error:
        if calculation := refused(compilation, error.diagnostics):
            say(_note(calculation, language), end="")
        raise
    session().accept(warnings(compilation), compilation.source)
    shown = render_brief if brief else render
    mechanism = compilation.mechanism
    by_sums = method == "equilibrium"
    derivation = compilation.by_equilibrium if by_sums else compilation.reported
    text = shown(
        derivation,
        mechanism,
        unicode=speaks_unicode(),
        numbers=numbers,
        language=language,
        width=columns(),
    )
    say(text, end="")


def _note(calculation: Calculation, language: str) -> str:
    """Return the note of a calculation of which conditions fail."""
    mechanism, results = calculation.pose.mechanism, calculation.results
    return note.render(
        mechanism, results, speller(results, mechanism, speaks_unicode(), language, columns())
    )
