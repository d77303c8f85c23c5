"""Which of the two notations a text is in, and reading it."""

import re
from collections.abc import Callable
from importlib import import_module
from pathlib import PurePath
from typing import cast

from ..diagnostics import Report
from ..source import Source
from . import ast

YAML_SUFFIXES = frozenset({".yaml", ".yml", ".json"})
"""JSON is YAML too."""

SECTION = re.compile(r"(?:---|\{|['\"]?[a-z]+['\"]?:(?:\s|$))")


def read(source: Source, report: Report) -> ast.File:
    """Return the tree of a text in either notation.

    Errors go to the report; raises :class:`MechcError` where nothing can be read.
    """
    return _parser("from_yaml" if is_yaml(source) else "from_dsl")(source, report)


def _parser(module: str) -> Callable[[Source, Report], ast.File]:
    """Return a notation's parser; the other notation's libraries are not imported."""
    return cast(
        Callable[[Source, Report], ast.File], import_module(f".{module}", __package__).parse
    )


def is_yaml(source: Source) -> bool:
    r"""Tell the notation by the name's suffix; without one, by the first line that counts.

    >>> is_yaml(Source("a.yaml", "")), is_yaml(Source("<stdin>", "# x\nparams:\n  a: 1"))
    (True, True)
    >>> is_yaml(Source("<stdin>", "param a: length"))
    False
    """
    suffix = PurePath(source.name).suffix
    if suffix in YAML_SUFFIXES or suffix == ".mech":
        return suffix in YAML_SUFFIXES
    lines = (line.strip() for line in source.text.removeprefix("\ufeff").splitlines())
    first = next((line for line in lines if line and not line.startswith(("#", "%"))), "")
    return SECTION.match(first) is not None
