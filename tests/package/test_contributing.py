"""CONTRIBUTING and the heads of folders name places that are there: a map of the tree."""

import ast
import re
from collections.abc import Collection
from pathlib import Path
from types import UnionType
from typing import get_args

import pytest

from mechc.model.parts import joints, loads
from paths import PACKAGE, ROOT, TESTS
from sources import tree_of

TEXT = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
PLACES = sorted(set(re.findall(r"`([\w.*]+/[\w./*]*|\w+\.py)`", TEXT)))
MADE_UP = ("NAME", "CODE")
"""What stands for a name of the reader's own."""


@pytest.mark.parametrize("place", [p for p in PLACES if not any(n in p for n in MADE_UP)])
def test_places_exist(place: str) -> None:
    """From the root or below the package; one without a folder anywhere in the code."""
    near = (ROOT.glob(place), PACKAGE.glob(place))
    anywhere = () if "/" in place.rstrip("/") else (PACKAGE.rglob(place), TESTS.rglob(place))
    assert any(path for paths in (*near, *anywhere) for path in paths)


FOLDERS = sorted(path.parent for path in PACKAGE.rglob("__init__.py"))
MODULE = re.compile(r"``(\.*)((?:\w+\.)*\w+)``")


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_modules_at_the_head_of_a_folder_exist(folder: Path) -> None:
    """A name between two backquotes is a module beside it, or as many folders up as it has dots."""
    head = (ast.get_docstring(tree_of(folder / "__init__.py")) or "").split("Promises")[0]
    named = [(dots, name.replace(".", "/")) for dots, name in MODULE.findall(head)]
    places = [(folder, *folder.parents)[max(len(dots) - 1, 0)] / name for dots, name in named]
    assert [p for p in places if not (p.is_dir() or p.with_suffix(".py").is_file())] == []


def section(title: str) -> str:
    return TEXT.split(f"## {title}\n")[1].split("\n## ")[0]


def whole_matches(kinds: Collection[type]) -> set[str]:
    """Return the modules in which a ``match`` has a case for every one of some classes.

    A case for a base class is one for each kind of it.
    """
    wanted = [{base.__name__ for base in kind.__mro__} for kind in kinds]
    found = set()
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.Match):
                parts = (part for case in node.cases for part in ast.walk(case.pattern))
                classes = (p.cls for p in parts if isinstance(p, ast.MatchClass))
                cases = {ast.unparse(cls).rpartition(".")[2] for cls in classes}
                if all(names & cases for names in wanted):
                    found.add(path.relative_to(PACKAGE).as_posix())
    return found


@pytest.mark.parametrize(
    ("title", "union"), [("To add a joint", joints.Joint), ("To add a load", loads.Load)]
)
def test_a_list_names_every_pass_that_has_a_case_for_each(title: str, union: UnionType) -> None:
    named = set(re.findall(r"`([\w/]+/(?:\w+\.py)?)`", section(title)))
    folders = tuple(place for place in named if place.endswith("/"))
    passes = whole_matches(get_args(union))
    assert passes
    assert {p for p in passes - named if not p.startswith(folders)} == set()
