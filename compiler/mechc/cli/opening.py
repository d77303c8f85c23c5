"""Compilations of what a command was given, and what a list of the library needs of them."""

from ..compilation import Compilation
from ..diagnostics import near_miss
from ..formula.to_text import text
from ..model.statements import only
from ..source import Source
from ..syntax.ast import Heading, NamedLoad, Translate
from ..syntax.settings import Settings, driven, drives, params
from ..syntax.vocabulary import LANGUAGES
from . import usage
from .inputs import source_of


def opened(name: str, stdin_name: str, settings: Settings, drive: str = "") -> Compilation:
    """Open a compilation, refusing settings of parameters that the description lacks.

    Of several drives the one of the name given moves.
    """
    source = source_of(name, stdin_name)
    if drive:
        _check_drive(drive, source)
    check_names(settings, source, "-D")
    return Compilation(source, settings, drive)


def check_names(settings: Settings, source: Source, option: str) -> None:
    """Refuse settings of parameters that a description lacks."""
    if not settings:
        return
    statements = Compilation(source).composed.statements
    declared = [p.name.text for p in params(statements)]
    declared += driven(statements)
    loads = {s.name.text for s in statements if isinstance(s, NamedLoad)}
    for unknown in (name for name in settings if name not in declared):
        hint = near_miss(unknown, declared) or f"it has {', '.join(declared) or 'none'}"
        if unknown in loads:
            hint = f"a load has its value by a line `let {settings[unknown].source.text}`"
        raise usage.BadParameter(
            f"{source.name} has no parameter {unknown!r}; {hint}", where=option
        )


def _check_drive(drive: str, source: Source) -> None:
    declared = [d.name.text for d in drives(Compilation(source).tree.statements)]
    if drive not in declared:
        hint = near_miss(drive, declared) or f"it has {', '.join(declared) or 'none'}"
        raise usage.BadParameter(f"{source.name} has no drive {drive!r}; {hint}", where="--drive")


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
    texts = mechanism.texts(language)
    title, origin = (texts.get(t, t) for t in (mechanism.title, mechanism.source))
    return title, origin, f"{first.name} = {text(first.formula)}"
