"""``mechc draw``: the picture of a mechanism."""

from collections.abc import Mapping
from pathlib import Path

from ...compilation import Compilation, checked, warnings
from ...diagnostics import MechcError
from ...diagnostics.drawing import no_free_bodies, no_plans, nothing_to_draw
from ...drawing.drawing import Drawing
from ...drawing.language_letters import in_letters
from ...drawing.moving import Marks
from ...emit.picture import FORMATS, in_format_of
from ...emit.svg.picture import to_svg
from ...files import write_all
from ...formula.letters import letters
from ...report.languages.registry import locale
from ...statics.diagrams.diagram import friction_circles
from ...syntax.settings import Settings
from ...syntax.vocabulary import LANGUAGES
from .. import usage
from ..collisions import refuse_collisions
from ..inputs import claim_of, description_argument, settings_option, stdin_option
from ..opening import opened
from ..session import session, session_options
from ..terminal import give
from ..usage import Word

STANDARD_OUTPUT = Path("-")

ALONE, MARKS = ("bodies", "plans"), ("velocities", "centres", "friction_circles")
"""What is a picture of its own, and what is marked in the scheme."""


def _known(paths: tuple[Path, ...]) -> tuple[Path, ...]:
    for path in paths:
        if path != STANDARD_OUTPUT and path.suffix.lower() not in FORMATS:
            known = ", ".join(FORMATS)
            raise usage.BadParameter(f"{str(path)!r} has none of the suffixes {known}")
    return paths


@usage.command("draw")
@description_argument
@usage.option(
    "-o",
    "--output",
    "paths",
    kind=Path,
    multiple=True,
    check=_known,
    metavar="PATH",
    help="A file; its suffix decides the format: .svg, .tex (TikZ), .png or .pdf. May be repeated.",
)
@usage.option("--bodies", is_flag=True, help="Draw every body cut free, with the forces on it.")
@usage.option("--plans", is_flag=True, help="Draw the plans of velocities and of forces.")
@usage.option("--velocities", is_flag=True, help="Draw the velocities of points in the scheme.")
@usage.option("--centres", is_flag=True, help="Draw the instantaneous centres of links in it.")
@usage.option("--friction-circles", is_flag=True, help="Draw the friction circles in it.")
@usage.option(
    "--lang", "language", kind=Word(LANGUAGES), default="en", help="The language of the words."
)
@settings_option
@stdin_option
@session_options
def command(
    file: str,
    paths: tuple[Path, ...],
    language: str,
    settings: Settings,
    stdin_name: str,
    **asked: bool,
) -> None:
    """Draw the kinematic scheme, the free bodies, or plans.

    The mechanism at its default pose, or at values set with -D: links, joints in the symbols
    of ISO 3952, loads, lengths and angles by their names. Without -o, or with -o -, the
    picture goes to standard output as SVG. PNG and PDF need `pip install 'mechc[pdf]'`.

    With --bodies each link is drawn by itself, without friction and then with it, with the
    forces on it to one scale: in newtons or kilonewtons, in pounds where the description has
    these, or in units of a load whose size nothing gives. Of a mirrored mechanism one half is
    shown.

    With --plans the velocities go out from a pole p to the points a, b, c, with those relative
    to other points between them, and the forces on each body follow head to tail: in metres a
    second and newtons or kilonewtons, or in units of a speed and a load whose size nothing gives.

    \b
    mechc draw clamp.mech -o clamp.svg
    mechc draw clamp.mech --bodies -o forces.svg
    mechc draw clamp.mech --plans -o plans.svg
    mechc draw crank_rocker --velocities --centres -D phi=120deg -o rocker.tex -o rocker.png
    """
    _refuse_several(asked)
    compilation = opened(file, stdin_name, settings)
    texts = compilation.mechanism.texts(language)
    drawing = in_letters(_drawing(compilation, asked, language), letters(locale(language), texts))
    session().accept(warnings(compilation), compilation.source)
    files = [path for path in paths if path != STANDARD_OUTPUT]
    pictures = {path: in_format_of(path, drawing) for path in files}
    printed = len(files) < len(paths) or not paths
    refuse_collisions(files, [claim_of(file)], printed)
    write_all(pictures)
    if printed:
        give(to_svg(drawing))


def _refuse_several(asked: Mapping[str, bool]) -> None:
    """Raise a usage error where two pictures are asked for at once."""
    given = [f"--{name}" for name in ALONE if asked[name]]
    given += [f"--{name.replace('_', '-')}" for name in MARKS if asked[name]][:1]
    if len(given) > 1:
        raise usage.UsageError(f"{given[0]} and {given[1]} are two pictures; draw one at a time")


def _drawing(compilation: Compilation, asked: Mapping[str, bool], language: str) -> Drawing:
    """Return the picture that is asked for; what it says has been checked."""
    if not any(asked.values()):
        drawing, trouble = compilation.drawn_scheme(language), nothing_to_draw()
    elif asked["bodies"]:
        drawing, trouble = checked(compilation).drawn_bodies(language), no_free_bodies()
    elif asked["plans"]:
        drawing, trouble = checked(compilation).drawn_plans(language), no_plans()
    else:
        drawing, trouble = _marked(checked(compilation), asked, language), nothing_to_draw()
    if drawing is None:
        raise MechcError([trouble if compilation.figure else nothing_to_draw()])
    return drawing


def _marked(compilation: Compilation, asked: Mapping[str, bool], language: str) -> Drawing | None:
    """Return the scheme with the marks that are asked for."""
    moving = compilation.velocities if asked["velocities"] or asked["centres"] else ()
    first = moving[0] if moving else None
    marks = Marks(
        velocities=first if asked["velocities"] else None,
        centres=first if asked["centres"] else None,
        circles=friction_circles(compilation.free_bodies) if asked["friction_circles"] else {},
    )
    return compilation.drawn_scheme(language, marks)
