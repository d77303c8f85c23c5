"""Everything that library and examples say in their own words is there in Ukrainian and Russian."""

import re

import pytest

from mechc.diagnostics import Report
from mechc.files import read as text_of
from mechc.formula.names import GREEK, words_in
from mechc.model.statements import declared
from mechc.syntax import ast
from mechc.syntax.notation import read
from paths import LIBRARY, ROOT

FILES = sorted(
    path
    for folder, pattern in ((LIBRARY, "*"), (LIBRARY, "sheets/*"), (ROOT / "examples", "**/*"))
    for path in folder.glob(pattern)
    if path.suffix in (".mech", ".yaml")
)
STANDARD = re.compile(r"ISO \d+|(Norton|Walsh)[^;=]*|[a-z]|[A-Z]{2}")
"""What is the same in every language: a standard, a book by its author, a letter, a line."""

LETTERS = "|".join(sorted(GREEK, key=len, reverse=True))
AS_TYPED = re.compile(
    rf"\b({LETTERS})(?![a-z])|\b(tan|cot|atan)\(|\d\*|\^2| deg\b|(?<=[а-яіїєґ])'(?=[а-яіїєґ])"
)
"""What a page does not have: letters and functions as they are typed, a straight apostrophe."""


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_titles_labels_and_sources_are_translated(file) -> None:
    source = text_of(file)
    statements = read(source, Report(source)).statements
    translated = {s.text for s in statements if isinstance(s, ast.Translate) and s.uk and s.ru}
    said = {text for s in statements for text in printed(s) if text}
    assert not {text for text in said - translated if not STANDARD.fullmatch(text)}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_translations_are_written_as_books_print_them(file) -> None:
    source = text_of(file)
    statements = read(source, Report(source)).statements
    said = [t for s in statements if isinstance(s, ast.Translate) for t in (s.uk, s.ru) if t]
    assert not [text for text in said if AS_TYPED.search(text)]


def printed(statement: ast.Statement) -> list[str]:
    """Return the words of a statement's own that reports print."""
    match statement:
        case ast.Heading(title=title):
            return [title]
        case ast.SourceNote(text=text):
            return [text]
        case ast.Table(source=source) | ast.Sizes(source=source):
            return [source]
        case ast.Param() | ast.Let():
            return [statement.label or statement.remark, getattr(statement, "about", "")]
        case ast.Link(label=label):
            return [label]
        case _:
            return []


WORDS_EVERYWHERE = {"min", "max", "cr", "dP", "dH", "dx"}
"""Indices that all three languages write alike, and differences."""


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_words_in_names_are_translated(file) -> None:
    source = text_of(file)
    statements = read(source, Report(source)).statements
    translated = {s.text for s in statements if isinstance(s, ast.Translate) and s.uk and s.ru}
    given = {name.text for statement in statements for name in declared(statement)}
    assert {word for name in given for word in words_in(name)} <= translated | WORDS_EVERYWHERE


IN_LIBRARY = [path for path in FILES if LIBRARY in path.parents]


@pytest.mark.parametrize("file", IN_LIBRARY, ids=lambda file: file.stem)
def test_a_parameter_says_what_it_is(file) -> None:
    """The table of a report has a column for it; the driving coordinate is called so there."""
    source = text_of(file)
    statements = read(source, Report(source)).statements
    drives = {s.name.text for s in statements if isinstance(s, ast.Drive)}
    given = (s for s in statements if isinstance(s, ast.Param) and s.value)
    silent = {p.name.text for p in given if not any(printed(p))}
    assert silent <= drives
