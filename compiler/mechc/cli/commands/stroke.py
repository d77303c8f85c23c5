"""``mechc stroke``: k along the stroke, its singular poses and extrema."""

from collections.abc import Iterator, Sequence

from ...compilation import checked, warnings
from ...report.text.csv_of_stroke import DIALECTS, to_csv
from ...report.text.stroke import to_table
from ...syntax.settings import Settings
from ...syntax.vocabulary import LANGUAGES
from .. import usage
from ..inputs import description_argument, settings_option, stdin_option
from ..opening import opened
from ..session import session, session_options
from ..terminal import give, line_width, say, watched
from ..usage import WholeNumber, Word

UNWATCHED_ROWS = 200
"""More rows than this take long enough to be watched."""


@usage.command("stroke", repeatable=True)
@description_argument
@usage.option(
    "-n", "--points", kind=WholeNumber(2, 100_000), default=19, show_default=True,
    help="How many places along the stroke.",
)  # fmt: skip
@usage.option("--csv", "as_csv", is_flag=True, help="Print comma-separated values.")
@usage.option(
    "--csv-dialect", "dialect", kind=Word(tuple(DIALECTS)),
    help="CSV with a decimal point, or a decimal comma and semicolons.",
)  # fmt: skip
@usage.option("--velocities", is_flag=True, help="Show dk/dφ and velocity ratios in the table.")
@usage.option(
    "--path", "paths", multiple=True, metavar="NAME",
    help="A point or link whose coordinates, direction and rates are shown; all for all.",
)  # fmt: skip
@usage.option(
    "--drive", default="", metavar="NAME",
    help="Which of several drives moves, the others being held at their values.",
)  # fmt: skip
@usage.option(
    "--lang", "language", kind=Word(LANGUAGES), default="en", show_default=True,
    help="The language of the table; CSV, errors and warnings are in English.",
)  # fmt: skip
@settings_option
@stdin_option
@session_options
def command(
    file: str,
    points: int,
    as_csv: bool,
    dialect: str | None,
    velocities: bool,
    paths: tuple[str, ...],
    drive: str,
    language: str,
    settings: Settings,
    stdin_name: str,
) -> None:
    """Print k along the stroke of the drive.

    Every result, and the transmission angle at each pin between a rod and what it drives;
    under the table where there is no pose, branch points, the singular poses told apart,
    and where each result is least and greatest. CSV, and the table with --velocities, has
    the slopes of the results and how fast the points of the loads move along them and the
    links of torques turn, by the speed of what is driven: V_B/omega_OA. With --path C the
    path of a point, with --path BC the direction of a link, and how both change with the drive.

    \b
    mechc stroke crank_rocker --path B
    mechc stroke --lang uk toggle_press
    mechc stroke --points 101 --csv clamp.mech > clamp.csv
    """
    compilation = checked(opened(file, stdin_name, settings, drive))
    found = compilation.stroke(points, paths, _watched)
    session().accept(warnings(compilation), compilation.source)
    if as_csv or dialect:
        give(to_csv(found, DIALECTS[dialect or "point"]))
    else:
        say(to_table(found, velocities, language, line_width()), end="")


def _watched(drives: Sequence[float]) -> Iterator[float]:
    """Return the values of the drive, watched by a bar where they are many."""
    return watched(drives, "stroke") if len(drives) > UNWATCHED_ROWS else iter(drives)
