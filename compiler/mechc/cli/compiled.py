"""What a list of the library needs the compiler for."""

from ..driver import Compilation
from ..formula.to_text import text
from ..model.statements import only
from ..source import Source
from ..syntax.ast import Heading, Translate
from ..syntax.vocabulary import LANGUAGES


def titles(source: Source) -> list[str]:
    """Return the title of a description in each language, for which nothing has to be solved."""
    tree = Compilation(source).tree
    heading = only(tree, Heading)
    title = heading.title if heading else ""
    known = [s for s in tree.statements if isinstance(s, Translate) and s.text == title]
    return [next((w for s in known if (w := getattr(s, code))), title) for code in LANGUAGES]


def title_source_and_result(source: Source, language: str) -> tuple[str, str, str]:
    """Return the title of a description, where it is from, and its first result."""
    compilation = Compilation(source)
    mechanism, (first, *_) = compilation.mechanism, compilation.found
    texts = mechanism.translations.get(language, {})
    title, origin = (texts.get(t, t) for t in (mechanism.title, mechanism.source))
    return title, origin, f"{first.name} = {text(first.formula)}"
