"""Which of the two notations a text is in, and reading it."""

from collections.abc import Callable
from importlib import import_module
from pathlib import PurePath
from typing import cast

from ..base.later import pattern
from ..diagnostics import Diagnostic, Report, syntax
from ..source import Source, Span
from . import ast
from .parser.grammar import statement_words

YAML_SUFFIXES = frozenset({".yaml", ".yml", ".json"})
"""JSON is YAML too."""

SECTION = pattern(r"(?:---|\{|['\"]?[a-z]+['\"]?:(?:\s|$))")


def read(source: Source, report: Report) -> ast.File:
    """Return the tree of a text in either notation.

    Errors go to the report; raises :class:`MechcError` where nothing can be read.
    """
    yaml = is_yaml(source)
    if yaml != _reads_as_yaml(source.text, yaml):
        raise report.fail(_other_notation(source, yaml))
    return _parser("from_yaml" if yaml else "from_dsl")(source, report)


def report_on(source: Source) -> Report:
    """Return an empty report, whose hints are in the notation of a text.

    >>> from ..diagnostics import syntax
    >>> hinted = syntax.empty_parameter(Span(0, 1), "a")
    >>> report_on(Source("a.mech", "")).fail(hinted).diagnostics[0].hint
    "write 'param a = 40 mm' or 'param a: length'"
    >>> report_on(Source("a.yaml", "")).fail(hinted).diagnostics[0].hint
    "write 'params: {a: 40 mm}' or 'params: {a: {dimension: length}}'"
    """
    return Report(source, _in_yaml if is_yaml(source) else None)


def _in_yaml(hint: str) -> str:
    """Return a hint in YAML: only a fault takes the parser of the other notation."""
    return cast(Callable[[str], str], import_module(".hints", __package__).in_yaml)(hint)


def _parser(module: str) -> Callable[[Source, Report], ast.File]:
    """Return a notation's parser; the other notation's libraries are not imported."""
    return cast(
        Callable[[Source, Report], ast.File], import_module(f".{module}", __package__).parse
    )


def is_yaml(source: Source) -> bool:
    r"""Return the notation by the name's suffix; without one, by the first line that counts.

    >>> is_yaml(Source("a.yaml", "")), is_yaml(Source("<stdin>", "# x\nparams:\n  a: 1"))
    (True, True)
    >>> is_yaml(Source("<stdin>", "param a: length"))
    False
    """
    suffix = PurePath(source.name).suffix
    if suffix in YAML_SUFFIXES or suffix == ".mech":
        return suffix in YAML_SUFFIXES
    return SECTION.match(_first_line(source.text)) is not None


def _first_line(text: str) -> str:
    """Return the first line that is no comment; ``%`` is one of the directives of YAML."""
    lines = (line.strip() for line in text.removeprefix("\ufeff").splitlines())
    return next((line for line in lines if line and not line.startswith(("#", "%"))), "")


def _reads_as_yaml(text: str, named: bool) -> bool:
    """Return the notation by the first line, by the file's name where that is of neither."""
    first = _first_line(text)
    if SECTION.match(first):
        return True
    word, _, rest = first.partition(" ")
    return named and not (word in statement_words() and rest and ":" not in first)


def _other_notation(source: Source, yaml: bool) -> Diagnostic:
    """Return the error about a file whose suffix is that of the other notation."""
    first = _first_line(source.text)
    start = source.text.index(first)
    found = "the notation of lines" if yaml else "YAML"
    name = PurePath(source.name).with_suffix(".mech" if yaml else ".yaml").name
    return syntax.other_notation(Span(start, start + len(first)), found, name)
