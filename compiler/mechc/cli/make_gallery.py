"""The gallery of the library: ``python -m mechc.cli.make_gallery`` draws every mechanism anew.

Pictures go into ``library/pictures``, their table into the last section of its README, and all
titles into the file that ``mechc list`` reads.
"""

from collections.abc import Iterator
from html import escape
from pathlib import Path

from ..compilation import Compilation
from ..data_folders import data
from ..emit.svg.picture import to_svg
from ..files import make_folder, mechanisms, read, write_all
from .commands.list import NOTED, noted

HEADING = "## Pictures\n"

COLUMNS = 3
"""How many pictures there are beside each other."""

PICTURE_POINTS = 260
"""How wide each is shown, in points of the screen."""


def folder() -> Path:
    """Return where the pictures are."""
    return data("library") / "pictures"


def picture(path: Path) -> tuple[str, str]:
    """Return the title and the picture of a description."""
    drawing = Compilation(read(path)).scheme
    assert drawing is not None, f"{path.name} cannot be assembled"
    return drawing.title, to_svg(drawing)


def table(titles: dict[str, str]) -> str:
    """Return the table of pictures by name, in rows."""
    cells = [_cell(name, title) for name, title in titles.items()]
    cells += [""] * (-len(cells) % COLUMNS)
    return "\n".join(
        (
            f"| {' | '.join([' '] * COLUMNS)} |",
            f"|{'---|' * COLUMNS}",
            *_rows(cells),
        )
    )


def _rows(cells: list[str]) -> Iterator[str]:
    for start in range(0, len(cells), COLUMNS):
        yield f"| {' | '.join(cells[start : start + COLUMNS])} |"


def _cell(name: str, title: str) -> str:
    shown = escape(title, quote=True).replace("|", "&#124;")
    return f'<img src="pictures/{name}.svg" width="{PICTURE_POINTS}" alt="{shown}"><br>`{name}`'


def section(titles: dict[str, str]) -> str:
    """Return the section of the README."""
    made = "Drawn by `python -m mechc.cli.make_gallery`; `mechc draw NAME -o NAME.svg` draws one."
    return f"{HEADING}\n{made}\n\n{table(titles)}\n"


def make() -> None:
    """Draw all, and remove pictures of what is no longer there."""
    drawn = {name: picture(path) for name, path in mechanisms().items()}
    make_folder(folder())
    for old in folder().glob("*.svg"):
        if old.stem not in drawn:
            old.unlink()
    readme = data("library") / "README.md"
    text = readme.read_text(encoding="utf-8").split(HEADING)[0].rstrip("\n")
    titles = {name: title for name, (title, _) in drawn.items()}
    pictures = {folder() / f"{name}.svg": svg for name, (_, svg) in drawn.items()}
    write_all({**pictures, readme: f"{text}\n\n{section(titles)}"})


if __name__ == "__main__":
    (data("library") / NOTED).write_text(noted(), "utf-8")
    make()
