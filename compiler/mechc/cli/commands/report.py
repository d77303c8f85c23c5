"""``mechc report``: several mechanisms in one table."""

from pathlib import Path

from ...compilation import Compilation, checked, warnings
from ...emit.latex.comparison import Compared, to_table
from ...files import write_all
from ...syntax.vocabulary import LANGUAGES
from .. import usage
from ..collisions import refuse_collisions
from ..inputs import NAMELESS, claim_of, expanded
from ..opening import opened
from ..output_paths import refuse_other_texts
from ..session import session, session_options
from ..terminal import give
from ..usage import Word, descriptions, paths


@usage.command("report")
@usage.argument("files", metavar="FILE|NAME…", several=True, complete=descriptions)
@usage.option(
    "-o", "--output", "path", kind=Path, metavar="PATH", complete=paths,
    help="A LaTeX file; without it the table goes to standard output.",
)  # fmt: skip
@usage.option("--schemes/--no-schemes", default=True, help="Draw each mechanism in its row.")
@usage.option("--fragment", is_flag=True, help="LaTeX without preamble, to \\input.")
@usage.option(
    "--lang", "language", kind=Word(LANGUAGES), default="en",
    help="The language of the table.",
)  # fmt: skip
@session_options
def command(
    files: tuple[str, ...], path: Path | None, schemes: bool, fragment: bool, language: str
) -> None:
    """Set several mechanisms in one table: scheme beside formulas.

    A folder stands for all descriptions below it. A fragment needs amsmath, array, booktabs,
    longtable, graphicx, tikz and the colours and styles of the whole document's preamble.

    \b
    mechc report karpenko_fig1_parallel_levers karpenko_fig2_scissor_tongs -o table.tex
    """
    if path is not None:
        refuse_other_texts(path)
    names = list(expanded(files))
    table = [_compared(checked(opened(name, NAMELESS, {})), schemes) for name in names]
    text = to_table(table, language, fragment)
    refuse_collisions([path] if path else [], list(map(claim_of, names)), path is None)
    if path is None:
        give(text)
    else:
        write_all({path: text})


def _compared(compilation: Compilation, schemes: bool) -> Compared:
    session().accept(warnings(compilation), compilation.source)
    return Compared(compilation, compilation.scheme if schemes else None)
