"""What a list of the library needs the compiler for."""

from ..driver import Compilation
from ..formula.to_text import text
from ..model.statements import only
from ..source import Source
from ..syntax.ast import Heading


def title(source: Source) -> str:
    """Return the title of a description, for which nothing has to be solved."""
    heading = only(Compilation(source).tree, Heading)
    return heading.title if heading else ""


def title_source_and_result(source: Source) -> tuple[str, str, str]:
    """Return the title of a description, where it is from, and its first result."""
    compilation = Compilation(source)
    mechanism, (first, *_) = compilation.mechanism, compilation.found
    return mechanism.title, mechanism.source, f"{first.name} = {text(first.formula)}"
