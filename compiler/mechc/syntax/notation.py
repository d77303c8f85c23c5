"""Which of the two notations a text is in, and reading it."""

import re
from pathlib import PurePath

from ..diagnostics import Report
from ..source import Source
from . import ast, from_dsl, from_yaml

YAML_SUFFIXES = frozenset({".yaml", ".yml", ".json"})
"""JSON is YAML too."""

SECTION = re.compile(r"(?:---|\{|['\"]?[a-z]+['\"]?:(?:\s|$))")


def read(source: Source, report: Report) -> ast.File:
    """Return the tree of a text in either notation.

    Errors go to the report; raises :class:`MechcError` where nothing can be read.
    """
    if is_yaml(source):
        return from_yaml.parse(source, report)
    return from_dsl.parse(source, report)


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
