"""``mechc show``: what a stage made of a description."""

import click

from ..derivation.to_text import render
from ..driver import VIEWS, Compilation
from ..figure import to_text as figure
from ..kinematics import to_text as kinematics
from ..model import to_text as model
from ..pose import to_text as pose
from ..power import to_text as power
from ..routine import to_text as routine
from ..statics import bodies_to_text
from ..statics import to_text as statics
from ..syntax.settings import Settings
from .begin import begin
from .inputs import description_argument, settings_option, stdin_option
from .pretty import pretty
from .session import Command, session_options
from .terminal import say


@click.command("show", cls=Command)
@click.argument("stage", type=click.Choice(list(VIEWS)), metavar="STAGE")
@description_argument
@settings_option
@stdin_option
@session_options
def command(stage: str, file: str, settings: Settings, stdin_name: str) -> None:
    """Print what a stage of the compiler made of a description.

    The stages, in order: syntax, model, pose, kinematics, power, statics, derivation,
    routine. Later stages are not run. Formulas are printed in the notation of the
    language, quantities in SI. "figure" is what a drawing of the default pose shows,
    "bodies" the forces on each body there.

    \b
    mechc show kinematics clamp.mech
    """
    compilation = begin(file, stdin_name, settings)
    say(_text(stage, compilation).rstrip("\n"))


def _text(stage: str, compilation: Compilation) -> str:
    """Return a stage's own text where it has one, else its record."""
    match stage:
        case "model":
            return model.describe(compilation.mechanism)
        case "pose":
            return pose.describe(compilation.pose)
        case "kinematics":
            return kinematics.describe(compilation.plan)
        case "power":
            return power.describe(compilation.balance, compilation.results)
        case "statics":
            return statics.to_text(compilation.verdict)
        case "derivation":
            return render(compilation.derivation, compilation.mechanism)
        case "routine":
            return routine.to_text(compilation.routine)
        case "figure":
            return figure.describe(compilation.figure)
        case "bodies":
            return bodies_to_text.describe(compilation.free_bodies)
        case _:
            return pretty(getattr(compilation, VIEWS[stage]))
