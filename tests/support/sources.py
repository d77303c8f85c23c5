"""The sources of the package and of its tests, each read once, and sweeps in parts."""

import ast
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import pytest


@cache
def tree_of(path: Path) -> ast.Module:
    """Return the syntax tree of a source."""
    return ast.parse(path.read_text(encoding="utf-8"))


def in_thirds(items: Iterable[Any]) -> list[Any]:
    """Return the items of a sweep, two of three for the slow tests alone."""
    each = enumerate(items)
    return [item if i % 3 == 0 else pytest.param(item, marks=pytest.mark.slow) for i, item in each]
