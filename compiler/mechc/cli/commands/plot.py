"""``mechc plot``: results against a parameter, as a picture or a table."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from ...base.frozen import replace
from ...base.later import pattern
from ...compilation import checked, warnings
from ...diagnostics import MechcError
from ...drawing.plots.from_plot import picture
from ...emit.picture import PLOT_FORMATS, PlotPicture
from ...emit.svg.picture import to_svg
from ...files import write_all
from ...formula.letters import letters
from ...plot.narrowing import ArrayFunction
from ...plot.query import USUAL_ROWS, Query, ZoneCondition, condition
from ...report.languages.registry import locale
from ...syntax.settings import Settings, parse
from ...syntax.vocabulary import LANGUAGES
from .. import usage
from ..collisions import refuse_collisions
from ..inputs import claim_of, description_argument, settings_option, stdin_option
from ..opening import check_names, opened
from ..session import session, session_options
from ..terminal import give, watched
from ..usage import WholeNumber, Word

STANDARD_OUTPUT = Path("-")

NUMBER = pattern(r"^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
"""A number that begins a value; its unit is what stands behind it."""


def _known(paths: tuple[Path, ...]) -> tuple[Path, ...]:
    for path in paths:
        if path != STANDARD_OUTPUT and path.suffix.lower() not in PLOT_FORMATS:
            known = ", ".join(PLOT_FORMATS)
            raise usage.BadParameter(f"{str(path)!r} has none of the suffixes {known}")
    return paths


def _names(given: tuple[str, ...]) -> tuple[str, ...]:
    """Return the names of several options, each of which may list some."""
    return tuple(name.strip() for text in given for name in text.split(",") if name.strip())


def _family(given: tuple[str, ...]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return names with the values they are set to: the last one's unit is that of all."""
    return tuple(map(_member, given))


def _member(text: str) -> tuple[str, tuple[str, ...]]:
    name, sign, values = text.partition("=")
    listed = [value.strip() for value in values.split(",")]
    if not sign or not name.strip() or not all(listed):
        raise usage.BadParameter(f"{text!r} is not NAME=VALUE,VALUE…, as in beta=10,20,30deg")
    unit = NUMBER.sub("", listed[-1])
    bare = (NUMBER.fullmatch(value) is not None for value in listed)
    return name.strip(), tuple(v + unit * b for v, b in zip(listed, bare, strict=True))


def _ends(text: str | None) -> tuple[str, str] | None:
    if text is None:
        return None
    low, dots, high = text.partition("..")
    if not dots or not low.strip() or not high.strip():
        raise usage.BadParameter(f"{text!r} is not LOW .. HIGH, as in '2 deg .. 40 deg'")
    return low.strip(), high.strip()


def _zone(given: tuple[str, ...]) -> tuple[ZoneCondition, ...]:
    try:
        return tuple(map(condition, given))
    except ValueError as error:
        raise usage.BadParameter(str(error)) from None


def _constraints(given: tuple[str, ...]) -> Settings:
    """Return formulas for parameters, which vary along with what the plot runs over."""
    for text in given:
        if "=" not in text:
            example = '--along "theta = 80 deg - alpha"'
            raise usage.BadParameter(f"{text!r} is not NAME = FORMULA, as in {example}")
    try:
        return dict(map(parse, given))
    except MechcError as error:
        raise usage.BadParameter(str(error)) from None


@usage.command("plot")
@description_argument
@usage.option("--x", "x", default="", metavar="NAME", help="What varies; else the drive.")
@usage.option(
    "--y", "ys", multiple=True, check=_names, metavar="NAME,…",
    help="What is shown: results, angles that loops find, x_C, V_C_x; else the first result.",
)  # fmt: skip
@usage.option(
    "--path", "paths", multiple=True, check=_names, metavar="POINT,…",
    help="Show the path of a point instead, while the drive moves.",
)  # fmt: skip
@usage.option(
    "--family", "family", multiple=True, check=_family, metavar="NAME=VALUE,…",
    help="A curve for each value: beta=10,20,30deg.",
)  # fmt: skip
@usage.option(
    "--along", "along", multiple=True, check=_constraints, metavar="NAME=FORMULA",
    help='What else varies: "theta = 80 deg - alpha".',
)  # fmt: skip
@usage.option(
    "--range", "ends", check=_ends, metavar="LOW..HIGH",
    help='From where to where, other than the description says: "0 deg .. 80 deg".',
)  # fmt: skip
@usage.option(
    "--where", "zone", multiple=True, check=_zone, metavar="NAME>=VALUE",
    help='Shade where this holds: "gamma >= 1.5 rad".',
)  # fmt: skip
@usage.option(
    "-n", "--points", kind=WholeNumber(2, 100_000), default=USUAL_ROWS, show_default=True,
    help="How many rows a table has.",
)  # fmt: skip
@usage.option(
    "-o", "--output", "outputs", kind=Path, multiple=True, check=_known,
    metavar="PATH", help=f"A file by its suffix: {', '.join(PLOT_FORMATS)}. May be repeated.",
)  # fmt: skip
@usage.option(
    "--lang", "language", kind=Word(LANGUAGES), default="en",
    help="The language of words, units and decimals.",
)  # fmt: skip
@settings_option
@stdin_option
@session_options
def command(
    file: str,
    x: str,
    ys: tuple[str, ...],
    paths: tuple[str, ...],
    family: tuple[tuple[str, tuple[str, ...]], ...],
    along: Settings,
    ends: tuple[str, str] | None,
    zone: tuple[ZoneCondition, ...],
    points: int,
    outputs: tuple[Path, ...],
    language: str,
    settings: Settings,
    stdin_name: str,
) -> None:
    """Plot results against a parameter over its range, or over the stroke.

    No drive is needed: what has a range can vary. Where a result is infinite its curve is
    broken, and a broken line stands there; where it jumps, a thin upright line; rings mark where
    it is least or greatest nearby and where it is 0, a dot the pose of the description. Zeros
    and poles of a ratio of loads that are dead centres are named so. Beyond the range of the
    description, that range is shaded. Without -o, or with -o -, the picture goes to standard
    output as SVG; .tex is pgfplots; .csv and .xlsx hold the values in the units of the axes.

    \b
    mechc plot clamp.mech --x alpha --family beta=10,20,30deg -o k.svg
    mechc plot karpenko_fig3_inclined_levers --x alpha --y z --along "theta = 80 deg - alpha" \\
        --range "0 deg .. 80 deg" -o z.pdf -o z.xlsx
    mechc plot crank_rocker --path B -o path.svg
    """
    compilation = opened(file, stdin_name, settings)
    check_names(along, compilation.source, "--along")
    query = Query(x, ys, family, ends, paths, zone, points)
    words = locale(language)
    plot = checked(compilation).along(along).plot(query, _watched)
    found = replace(plot, title=compilation.titled(language))
    known = letters(words, compilation.mechanism.texts(language))
    plotted = PlotPicture(found, picture(found, words.pictures), words.pictures, known)
    session().accept(warnings(compilation), compilation.source)
    files = [path for path in outputs if path != STANDARD_OUTPUT]
    contents = {path: plotted.content(path) for path in files}
    printed = len(files) < len(outputs) or not outputs
    refuse_collisions(files, [claim_of(file)], printed)
    write_all(contents)
    if printed:
        give(to_svg(plotted.shown))


def _watched(functions: Sequence[ArrayFunction]) -> Iterator[ArrayFunction]:
    """Return the functions of several curves, watched by a bar."""
    return watched(functions, "plotting") if len(functions) > 1 else iter(functions)
