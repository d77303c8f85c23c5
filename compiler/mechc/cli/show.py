"""``mechc show``: what a stage made of a description."""

import click

from ..driver import STAGES
from ..syntax.settings import Settings
from .inputs import begin, description_argument, settings_option, stdin_option
from .pretty import pretty
from .session import Command, session_options


@click.command("show", cls=Command)
@click.argument("stage", type=click.Choice(list(STAGES)))
@description_argument
@settings_option
@stdin_option
@session_options
def command(stage: str, file: str, settings: Settings, stdin_name: str) -> None:
    """Print what a stage of the compiler made of a description.

    The stages, in order: syntax, model, pose, kinematics, power, statics, derivation,
    routine. Later stages are not run. Formulas are printed in the notation of the
    language, in SI and radians; what is empty or as usual is left out.

    \b
    mechc show kinematics clamp.mech
    """
    compilation = begin(file, stdin_name, settings)
    click.echo(pretty(getattr(compilation, STAGES[stage])))
