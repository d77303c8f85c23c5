"""The mechanisms that tests compile whole: the library, and a corpus with one construct each."""

from functools import cache
from pathlib import Path

from mechc.diagnostics import Report
from mechc.driver import Compilation, compile_source
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.notation import read

HERE = Path(__file__).parent
CORPUS = sorted((HERE / "corpus" / "good").glob("*.mech"))
SHELF = sorted(p for p in (HERE.parent / "library").iterdir() if p.suffix in {".mech", ".yaml"})
ALL = {path.stem: path for path in (*SHELF, *CORPUS)}


@cache
def compiled(name: str) -> Compilation:
    """Return a mechanism after every stage."""
    path = ALL[name]
    return compile_source(Source(path.name, path.read_text(encoding="utf-8")))


def tree_of(name: str) -> ast.File:
    return read(compiled(name).source, Report(compiled(name).source))
