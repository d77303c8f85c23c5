"""``mechc draw``: the picture of a mechanism."""

from pathlib import Path

import click

from ..diagnostics import MechcError
from ..diagnostics.drawing import no_free_bodies, nothing_to_draw
from ..driver import checked, warnings
from ..emit.picture import FORMATS, in_format_of
from ..emit.svg.picture import to_svg
from ..files import write_all
from ..syntax.settings import Settings
from .collisions import refuse_collisions
from .inputs import claim_of, description_argument, settings_option, stdin_option
from .open import begin
from .session import Command, session, session_options
from .terminal import give

STANDARD_OUTPUT = Path("-")


def _known(
    ctx: click.Context, parameter: click.Parameter, paths: tuple[Path, ...]
) -> tuple[Path, ...]:
    for path in paths:
        if path != STANDARD_OUTPUT and path.suffix.lower() not in FORMATS:
            known = ", ".join(FORMATS)
            raise click.BadParameter(f"{str(path)!r} has none of the suffixes {known}")
    return paths


@click.command("draw", cls=Command)
@description_argument
@click.option(
    "-o",
    "--output",
    "paths",
    type=click.Path(path_type=Path),
    multiple=True,
    callback=_known,
    metavar="PATH",
    help="A file whose suffix tells the format: .svg, .tex (TikZ), .png or .pdf. May be repeated.",
)
@click.option("--bodies", is_flag=True, help="Draw every body cut free, with the forces on it.")
@settings_option
@stdin_option
@session_options
def command(
    file: str, paths: tuple[Path, ...], bodies: bool, settings: Settings, stdin_name: str
) -> None:
    """Draw the kinematic scheme, or the free bodies.

    The mechanism at its default pose, or at values set with -D: links, joints in the symbols
    of ISO 3952, loads, lengths and angles by their names. Without -o, or with -o -, the
    picture goes to standard output as SVG. PNG needs `pip install 'mechc[png]'`, PDF `mechc[pdf]`.

    With --bodies each link is drawn by itself, without friction and then with it, with the
    forces on it to one scale: in newtons, or in units of a load whose size nothing gives. Of
    a mirrored mechanism one half is shown.

    \b
    mechc draw clamp.mech -o clamp.svg
    mechc draw clamp.mech --bodies -o forces.svg
    mechc draw crank_rocker -D phi=120deg -o rocker.tex -o rocker.png
    """
    compilation = begin(file, stdin_name, settings)
    drawing = checked(compilation).free_body_diagrams if bodies else compilation.scheme
    if drawing is None:
        raise MechcError([no_free_bodies() if compilation.figure else nothing_to_draw()])
    session().accept(warnings(compilation), compilation.source)
    files = [path for path in paths if path != STANDARD_OUTPUT]
    pictures = {path: in_format_of(path, drawing) for path in files}
    printed = len(files) < len(paths) or not paths
    refuse_collisions(files, [claim_of(file)], printed)
    write_all(pictures)
    if printed:
        give(to_svg(drawing))
