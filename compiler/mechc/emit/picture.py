"""A drawing as a picture: in every format, by the suffix of a file."""

from collections.abc import Callable, Mapping
from pathlib import Path

from ..drawing.drawing import Drawing
from ..files import write_all
from ..frozen import frozen
from .svg.picture import to_svg
from .tikz.picture import to_tikz
from .typst.picture import to_pdf, to_png

FORMATS: Mapping[str, Callable[[Drawing], str | bytes]] = {
    ".svg": to_svg,
    ".tex": to_tikz,
    ".png": to_png,
    ".pdf": to_pdf,
}
"""How a drawing is written, by the suffix of the file."""


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
