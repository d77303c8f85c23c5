"""Drawings and plots as files, in every format, by the suffix of a file."""

from collections.abc import Callable, Mapping
from pathlib import Path

from ..base.frozen import frozen
from ..drawing.drawing import Drawing
from ..drawing.language_letters import in_letters
from ..files import write_all
from ..formula.letters import LATIN, Letters
from ..plot.plot import Plot
from .pgfplots.to_pgfplots import to_pgfplots
from .plot_tables import to_csv, to_xlsx
from .svg.picture import to_pdf, to_png, to_svg
from .tikz.picture import to_tikz

FORMATS: Mapping[str, Callable[[Drawing], str | bytes]] = {
    ".svg": to_svg,
    ".tex": to_tikz,
    ".png": to_png,
    ".pdf": to_pdf,
}
"""How a drawing is written, by the suffix of the file."""

OF_DRAWINGS = (".svg", ".pdf", ".png")
"""The suffixes of pictures that are those of any drawing."""

OF_PLOTS: Mapping[str, Callable[[Plot], str | bytes]] = {".csv": to_csv, ".xlsx": to_xlsx}
"""How the values of a plot are written, by the suffix of the file."""

PLOT_FORMATS = (*OF_DRAWINGS, ".tex", *OF_PLOTS)


def in_format_of(path: Path, drawing: Drawing) -> str | bytes:
    """Return the content of a picture file; KeyError where no format has its suffix."""
    return FORMATS[path.suffix.lower()](drawing)


@frozen
class Picture:
    """A drawing that saves itself, and shows itself in notebooks."""

    drawing: Drawing

    def save(self, path: str | Path) -> None:
        """Write a file, whole or not at all: ``.svg``, ``.tex`` (TikZ), ``.png`` or ``.pdf``."""
        target = Path(path)
        if target.suffix.lower() not in FORMATS:
            raise ValueError(f"{str(path)!r} has none of the suffixes {', '.join(FORMATS)}")
        write_all({target: in_format_of(target, self.drawing)})

    def _repr_svg_(self) -> str:
        return to_svg(self.drawing)


@frozen
class PlotPicture:
    """A plot with its drawing, which saves itself and shows itself in notebooks.

    ``words`` and ``letters`` are those of its language.
    """

    plot: Plot
    drawing: Drawing
    words: Mapping[str, str]
    letters: Letters = LATIN

    @property
    def shown(self) -> Drawing:
        """Return the drawing in the letters of its language."""
        return in_letters(self.drawing, self.letters)

    @property
    def alt(self) -> str:
        """Return the description of the plot, for those who cannot see it."""
        return self.shown.description

    def content(self, path: Path) -> str | bytes:
        """Return the content of a file by its suffix; KeyError where no format has it."""
        suffix = path.suffix.lower()
        if suffix in OF_DRAWINGS:
            return in_format_of(path, self.shown)
        if suffix == ".tex":
            return to_pgfplots(self.plot, self.words, self.letters)
        return OF_PLOTS[suffix](self.plot)

    def save(self, path: str | Path) -> None:
        """Write a file, whole or not at all: a picture, or the table of the same values.

        ``.svg``, ``.tex`` (pgfplots), ``.pdf``, ``.png``, ``.csv`` or ``.xlsx``.
        """
        target = Path(path)
        if target.suffix.lower() not in PLOT_FORMATS:
            raise ValueError(f"{str(path)!r} has none of the suffixes {', '.join(PLOT_FORMATS)}")
        write_all({target: self.content(target)})

    def _repr_svg_(self) -> str:
        return to_svg(self.shown)
