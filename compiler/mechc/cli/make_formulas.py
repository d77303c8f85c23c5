"""The sheets and formulas of the library: ``python -m mechc.cli.make_formulas`` lists them anew.

``library/seeds.json`` says which result of which file each formula of the papers is. The
command writes two sections of the library's README, above its pictures.
"""

import json
from collections.abc import Mapping
from typing import Any

from ..base.named import NamedTuple
from ..compilation import Compilation
from ..data_folders import data
from ..files import library, mechanisms, read, write_all
from .make_gallery import HEADING as PICTURES

SHEETS = "## Calculation sheets\n"

FORMULAS = "## Formulas of the papers\n"

MADE = "Made by `python -m mechc.cli.make_formulas`"


class PaperFormula(NamedTuple):
    """Where the library computes a formula of the papers."""

    file: str
    result: str
    inputs: Mapping[str, str]
    """Our names by those of the formula."""


def formulas() -> dict[str, PaperFormula]:
    """Return where each formula is, by its id."""
    text = (data("library") / "seeds.json").read_text(encoding="utf-8")
    return {seed: _formula(entry) for seed, entry in json.loads(text).items()}


def _formula(entry: Mapping[str, Any]) -> PaperFormula:
    return PaperFormula(entry["file"], entry["result"], entry["inputs"])


def sheets() -> str:
    """Return the section of the README that lists the calculation sheets."""
    names = library().keys() - mechanisms().keys()
    described = {name: Compilation(read(library()[name])).mechanism for name in sorted(names)}
    rows = [f"| `{name}` | {m.title} | {m.source} |" for name, m in described.items()]
    intro = f"{MADE} from the files in `library/sheets`."
    return "\n".join((SHEETS, intro, "", "| name | sheet | source |", "|---|---|---|", *rows, ""))


def section() -> str:
    """Return the section of the README that says where the formulas are."""
    intro = f"{MADE} from `library/seeds.json`; `mechc check FILE` shows the result.\n"
    heading = ("| formula | file | result | names that differ |", "|---|---|---|---|")
    rows = (_row(seed, formula) for seed, formula in formulas().items())
    return "\n".join((FORMULAS, intro, *heading, *rows, ""))


def _row(seed: str, formula: PaperFormula) -> str:
    renamed = (f"{theirs} → `{ours}`" for theirs, ours in formula.inputs.items() if theirs != ours)
    return f"| {seed} | `{formula.file}` | `{formula.result}` | {', '.join(renamed)} |"


def made(readme: str) -> str:
    """Return the README with its sections as they are now."""
    above, pictures = readme.split(PICTURES)
    above = above.split(SHEETS)[0].rstrip("\n")
    return f"{above}\n\n{sheets()}\n{section()}\n{PICTURES}{pictures}"


def make() -> None:
    """Write the sections into the README."""
    readme = data("library") / "README.md"
    write_all({readme: made(readme.read_text(encoding="utf-8"))})


if __name__ == "__main__":
    make()
