"""``mechc derive``: the derivation, for the terminal."""

import click

from ..driver import complete, warnings
from ..report.text.derivation import render
from ..syntax.settings import Settings
from .inputs import description_argument, settings_option, stdin_option
from .open import begin
from .session import Command, session, session_options
from .terminal import say, speaks_unicode


@click.command("derive", cls=Command)
@description_argument
@settings_option
@stdin_option
@session_options
def command(file: str, settings: Settings, stdin_name: str) -> None:
    """Print the derivation of k step by step.

    Each velocity relation with the rule that gives it, the power equation, k, and where
    it vanishes and blows up.

    \b
    mechc derive clamp.mech
    """
    compilation = complete(begin(file, stdin_name, settings))
    session().accept(warnings(compilation), compilation.source)
    text = render(compilation.derivation, compilation.mechanism, unicode=speaks_unicode())
    say(text, end="")
