"""Imports point down only, and across stages only to the other stage's data."""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from paths import PACKAGE
from sources import tree_of

BASE = [
    "base",
    "version",
    "cache_folder",
    "whole_files",
    "events",
    "source",
    "units",
    "work",
    "diagnostics",
    "data_folders",
    "files",
    "formula",
    "algebra",
]
STAGES = [
    "syntax",
    "model",
    "pose",
    "kinematics",
    "power",
    "friction",
    "calculation",
    "statics",
    "equilibrium",
    "study",
    "figure",
]
OUTPUT = ["routine", "plot", "drawing", "report", "emit"]
TOP = [
    "stage",
    "pipeline",
    "compilation",
    "shown",
    "plotting",
    "evaluation",
    "api",
    "cli",
    "__main__",
]
ORDER = BASE + STAGES + OUTPUT + TOP
VIEWS = ("pipeline.py", "compilation.py", "plotting.py", "evaluation.py", "api.py")
"""Where a module may be imported in a function: for what is made only when it is asked for."""

LATE = {("formula/to_sympy.py", "sympy")}
"""Other imports inside a function; what few descriptions ask for is ``SELDOM`` of its package."""


@cache
def modules() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


def name_of(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


def imported(path: Path, tree: ast.AST) -> Iterator[tuple[str, ast.stmt]]:
    """Yield every module imported, mechc's own by their path below the package."""
    package = path.relative_to(PACKAGE).parts[:-1]
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = list(package[: len(package) + 1 - node.level]) if node.level else []
            stem = [*base, *(node.module.split(".") if node.module else [])]
            for alias in node.names:
                whole = PACKAGE.joinpath(*stem, alias.name)
                is_module = whole.is_dir() or whole.with_suffix(".py").is_file()
                yield ".".join([*stem, alias.name] if is_module else stem), node


@cache
def own(path: Path) -> frozenset[str]:
    """Return the modules of mechc that a module imports."""
    return frozenset(
        name
        for name, node in imported(path, tree_of(path))
        if isinstance(node, ast.ImportFrom) and node.level and name
    )


@cache
def hidden() -> frozenset[tuple[str, str]]:
    """Return every module with what it imports inside a function."""
    return frozenset(
        (name_of(path), name)
        for path in modules()
        for function in ast.walk(tree_of(path))
        if isinstance(function, ast.FunctionDef)
        for name, _ in imported(path, function)
    )


def imports_by_module() -> dict[str, frozenset[str]]:
    """Return the imports of each module; a package is the module of its name."""
    names = ((name_of(p)[:-3].replace("/", "."), own(p)) for p in modules())
    return {name.removesuffix(".__init__"): needs for name, needs in names}


def stage(name: str) -> str:
    return name.split(".")[0].split("/")[0]


def test_imports_point_down() -> None:
    for path in modules():
        here = stage(name_of(path))
        for name in own(path) if here != "__init__" else ():
            assert ORDER.index(stage(name)) <= ORDER.index(here), f"{path.name} imports {name}"


def test_stages_know_only_data_and_tools_of_one_another() -> None:
    """A stage runs no other: it imports no way into one, and nothing that leads to one."""
    graph = imports_by_module()
    for name, needs in graph.items():
        if stage(name) in TOP:
            continue
        for other in needs & graph.keys():
            if stage(other) != stage(name):
                leads_to = {m for m in reached(other, graph) if stage(m) == stage(other)}
                assert not any(map(is_way_in, leads_to)), f"{name} imports {other}"


def is_way_in(name: str) -> bool:
    return name.split(".")[-1].startswith("from_") and stage(name) in [*STAGES, *OUTPUT]


def reached(start: str, graph: dict[str, frozenset[str]]) -> set[str]:
    found, todo = {start}, [start]
    while todo:
        new = (graph[todo.pop()] & graph.keys()) - found
        found |= new
        todo += new
    return found


def test_statics_is_a_second_opinion() -> None:
    for path in (PACKAGE / "statics").glob("*.py"):
        for name in own(path):
            assert stage(name) not in ("kinematics", "power", "friction"), f"{path.name}: {name}"


def test_no_import_hides_in_a_function() -> None:
    assert [found for found in sorted(hidden() - LATE) if found[0] not in VIEWS] == []


def test_no_import_cycle() -> None:
    graph = imports_by_module()
    done: set[str] = set()
    while ready := [
        m for m, needs in graph.items() if m not in done and needs & graph.keys() <= done
    ]:
        done.update(ready)
    assert done == graph.keys(), f"cycle among {sorted(graph.keys() - done)}"


def test_every_folder_says_what_it_promises() -> None:
    for path in PACKAGE.rglob("__init__.py"):
        assert ast.get_docstring(tree_of(path)), path


def test_the_list_above_names_what_there_is() -> None:
    assert hidden() >= LATE


def test_what_waits_in_a_package_is_a_module_of_it_that_somebody_asks_it_for() -> None:
    asked = {name for needs in imports_by_module().values() for name in needs}
    for path in PACKAGE.rglob("__init__.py"):
        package = name_of(path.parent).replace("/", ".")
        for node in ast.walk(tree_of(path)):
            match node:
                case ast.Assign([ast.Name("SELDOM" | "WORDS")], ast.Set() as names):
                    waiting = {str(c.value) for c in ast.walk(names) if isinstance(c, ast.Constant)}
                    assert {f"{package}.{name}" for name in waiting} <= asked, package
