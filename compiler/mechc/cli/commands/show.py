"""``mechc show``: what a stage made of a description."""

import json

from ...compilation import VIEWS, Compilation
from ...report.text import free_bodies as bodies_to_text
from ...report.text import verdict as statics
from ...report.text.derivation import render
from ...syntax.settings import Settings
from .. import usage
from ..dump import dump, nested
from ..inputs import description_argument, settings_option, stdin_option
from ..opening import opened
from ..session import session, session_options
from ..terminal import give, say
from ..usage import Word


@usage.command("show")
@usage.argument("stage", kind=Word(tuple(VIEWS)), metavar="STAGE")
@description_argument
@settings_option
@stdin_option
@session_options
def command(stage: str, file: str, settings: Settings, stdin_name: str) -> None:
    """Print what a stage of the compiler made of a description.

    The stages, in order: syntax, model, pose, kinematics, power, friction, calculation, study,
    statics, derivation, routine. Later stages are not run. Formulas are printed in the notation
    of the language, quantities in SI; "as in model.links" is what `mechc show model` prints
    under links. "figure" is what a drawing of the default pose shows, "bodies" the forces on
    each body there, "equilibrium" the sums that give k. With --format json all of it is JSON.

    \b
    mechc show kinematics clamp.mech
    """
    compilation = opened(file, stdin_name, settings)
    if session().form == "json":
        give(
            json.dumps(nested(getattr(compilation, VIEWS[stage])), ensure_ascii=False, indent=2)
            + "\n"
        )
    else:
        say(text_of(stage, compilation).rstrip("\n"))


def text_of(stage: str, compilation: Compilation) -> str:
    """Return the text of a stage: the value that it hands on, as it is.

    Three are results by themselves and have the text in which people read them: the table of
    `mechc check --verbose`, the derivation of `mechc derive`, the forces on free bodies.
    """
    match stage:
        case "statics":
            return statics.to_text(compilation.verdict) + "\n"
        case "derivation":
            return render(compilation.derivation, compilation.mechanism)
        case "bodies":
            return bodies_to_text.describe(compilation.free_bodies)
        case "figure" if compilation.figure is None:
            return "There is no figure: no pose is found at these values.\n"
        case _:
            return dump(stage, getattr(compilation, VIEWS[stage]), _earlier(stage, compilation))


def _earlier(stage: str, compilation: Compilation) -> dict[str, object]:
    """Return the values of the stages that had to run for one, by name."""
    return {name: value for name, value in compilation.so_far().items() if name != stage}
