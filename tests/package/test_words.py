"""The code speaks the field's words: none of the private ones that were once said for them."""

import ast
import re
from collections.abc import Iterator
from functools import cache

from paths import PACKAGE, TESTS
from sources import tree_of

SAID_BEFORE = {
    "rub": "friction", "rubs": "friction", "rubbing": "with friction", "knee": "toggle",
    "felt": "dual", "told": "shown", "untold": "new", "settle": "solve", "settled": "solved",
    "mend": "fix", "bond": "joint", "entangled": "coupled", "loosened": "released",
    "shelf": "list", "freedoms": "degrees of freedom", "saying": "sentence",
    "astray": "lagging", "course": "range", "courses": "ranges", "pressed": "loaded",
    "tell": "state", "tells": "states", "nil": "zero",
}  # fmt: skip
"""Private words, and what books say."""

FILES = sorted([*PACKAGE.rglob("*.py"), *TESTS.rglob("*.py")])


def names(tree: ast.AST) -> Iterator[str]:
    """Yield the names that a file gives: of functions, classes, arguments, variables."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name) | ast.arg(arg=name):
                yield name
            case ast.Name(id=name, ctx=ast.Store()) | ast.Attribute(attr=name, ctx=ast.Store()):
                yield name


@cache
def parts(name: str) -> list[str]:
    """Return the words of a name.

    >>> parts("_FrictionPair_of")
    ['friction', 'pair', 'of']
    """
    return [part.lower() for part in re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])", name)]


def test_no_name_has_a_private_word() -> None:
    found = {
        f"{path.name}: {name} (say {SAID_BEFORE[word]})"
        for path in FILES
        for name in names(tree_of(path))
        for word in parts(name)
        if word in SAID_BEFORE
    }
    assert not found


RIDDLE = re.compile(r"Return what |Return the same(,| (as|at|by|for|in|of|under|where|with)) ")


def docstrings(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            yield ast.get_docstring(node) or ""


def test_docstrings_say_what_comes_back() -> None:
    """ "Return what" is a riddle, and so is "Return the same" as another function."""
    trees = ((path, tree_of(path)) for path in FILES)
    begun = ((path, text) for path, tree in trees for text in docstrings(tree))
    assert [path.name for path, text in begun if RIDDLE.match(text)] == []
