"""What the texts of a description are in other languages."""

from collections.abc import Iterable, Iterator, Mapping, Set
from types import MappingProxyType

from ..base.later import pattern
from ..diagnostics import Report, near_miss
from ..diagnostics.model import translations as messages
from ..formula.names import words_in
from ..source import Span
from ..syntax import ast
from ..syntax.vocabulary import LANGUAGES
from .statements import declared, every

Translations = Mapping[str, Mapping[str, str]]
"""By language, what a text of the description is in it, a name, or a word in names."""

TEXTS = ("title", "text", "source", "label", "about", "remark")
"""The fields of statements that hold what people wrote in their own words."""

_UNDERSCORE = pattern("_")


def read_translations(file: ast.File, report: Report) -> Translations:
    """Return the translations of a description; report those of texts that it does not have."""
    known = texts(file) | translatable_names(file.statements)
    first: dict[tuple[str, str], Span] = {}
    found: dict[str, dict[str, str]] = {}
    for line in every(file, ast.Translate):
        if line.text not in known:
            hint = near_miss(line.text, known)
            report.add(messages.of_no_text(line.span, line.text, hint))
        for language, text in spoken(line).items():
            if before := first.get((line.text, language)):
                report.add(messages.translated_twice(line.span, line.text, language, before))
            first.setdefault((line.text, language), line.span)
            found.setdefault(language, {})[line.text] = text
        if not spoken(line):
            report.add(messages.into_no_language(line.span, line.text, LANGUAGES))
    return MappingProxyType({k: MappingProxyType(v) for k, v in found.items()})


def spoken(line: ast.Translate) -> dict[str, str]:
    """Return the translations on a line, by language."""
    return {language: text for language in LANGUAGES if (text := getattr(line, language))}


def texts(file: ast.File) -> Set[str]:
    """Return all that people wrote in their own words in a description."""
    return {text for statement in file.statements for text in _texts(statement) if text}


def translatable_names(statements: Iterable[ast.Statement]) -> Set[str]:
    """Return the names that statements give, and the words in them: ``dP_far``, ``far``.

    A name that something else brings in has a prefix, and stands as it does there.
    """
    statements = tuple(statements)
    given = {name.text for statement in statements for name in _named(statement)}
    given |= {s.prefix for s in statements if isinstance(s, ast.Brought)}
    ends = {name[at.end() :] for name in given for at in _UNDERSCORE.finditer(name)}
    return given | ends | {word for name in given for word in words_in(name)}


def _named(statement: ast.Statement) -> Iterator[ast.Name]:
    yield from declared(statement)
    if isinstance(statement, ast.Find) and statement.name:
        yield statement.name


def _texts(statement: ast.Statement) -> Iterator[str]:
    if not isinstance(statement, ast.Translate):
        yield from (getattr(statement, field, "") for field in TEXTS)
