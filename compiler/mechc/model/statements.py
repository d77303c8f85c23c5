"""The statements of a file by kind."""

from typing import TypeVar

from ..syntax import ast

S = TypeVar("S", bound=ast.Statement)


def every(file: ast.File, kind: type[S]) -> list[S]:
    """Return all statements of a kind, in order."""
    return [statement for statement in file.statements if isinstance(statement, kind)]


def only(file: ast.File, kind: type[S]) -> S | None:
    """Return the statement of a kind that stands at most once (the parsers see to it)."""
    return next(iter(every(file, kind)), None)
