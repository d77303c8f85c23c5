"""``mechc draw``: the picture of a mechanism."""

from collections.abc import Callable
from pathlib import Path

import click

from ..diagnostics import MechcError
from ..diagnostics.drawing import nothing_to_draw
from ..drawing.drawing import Drawing
from ..driver import warnings
from ..emit.png.picture import to_png
from ..emit.svg.picture import to_svg
from ..emit.tikz.picture import to_tikz
from ..files import write_all
from ..syntax.settings import Settings
from .collisions import refuse_collisions
from .inputs import claim_of, description_argument, settings_option, stdin_option
from .open import begin
from .session import Command, session, session_options
from .terminal import give

FORMATS: dict[str, Callable[[Drawing], str | bytes]] = {
    ".svg": to_svg,
    ".tex": to_tikz,
    ".png": to_png,
}


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
    help="A file whose suffix tells the format: .svg, .tex (TikZ) or .png. May be repeated.",
)
@settings_option
@stdin_option
@session_options
def command(file: str, paths: tuple[Path, ...], settings: Settings, stdin_name: str) -> None:
    """Draw the kinematic scheme.

    The mechanism at its default pose, or at values set with -D: links, joints in the symbols
    of ISO 3952, loads, lengths and angles by their names. Without -o, or with -o -, the
    picture goes to standard output as SVG. PNG needs `pip install 'mechc[png]'`.

    \b
    mechc draw clamp.mech -o clamp.svg
    mechc draw crank_rocker -D phi=120deg -o rocker.tex -o rocker.png
    """
    compilation = begin(file, stdin_name, settings)
    drawing = compilation.scheme
    if drawing is None:
        raise MechcError([nothing_to_draw()])
    session().accept(warnings(compilation), compilation.source)
    files = [path for path in paths if path != STANDARD_OUTPUT]
    pictures = {path: FORMATS[path.suffix.lower()](drawing) for path in files}
    printed = len(files) < len(paths) or not paths
    refuse_collisions(files, claim_of(file), printed)
    write_all(pictures)
    if printed:
        give(to_svg(drawing))
