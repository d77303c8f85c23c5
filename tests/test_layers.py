"""Imports point down only, and across stages only to the other stage's data."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "compiler" / "mechc"

BASE = [
    "frozen",
    "source",
    "units",
    "work",
    "diagnostics",
    "data",
    "files",
    "words",
    "formula",
    "algebra",
]
STAGES = ["syntax", "model", "pose", "kinematics", "power", "statics", "check", "stroke", "figure"]
OUTPUT = ["derivation", "routine", "emit"]
TOP = ["stage", "driver", "api", "cli", "__main__"]
ORDER = BASE + STAGES + OUTPUT + TOP
DATA = {
    "syntax.ast",
    "model.locking",
    "model.mechanism",
    "model.parts",
    "model.rubbing",
    "model.targets",
    "pose.pose",
    "kinematics.graph",
    "kinematics.plan",
    "power.balance",
    "power.friction.solution",
    "power.friction.steps",
    "model.result",
    "statics.diagram",
    "statics.verdict",
    "stroke.stroke",
    "figure.figure",
    "derivation.steps",
    "routine.steps",
    "emit.target",
}
"""What one stage may know of another; the driver and what is above it know all."""

VOCABULARY = {
    "derivation.definitions",
    "derivation.remarks",
    "derivation.sections",
    "derivation.wording",
    "kinematics.forms",
    "model.forms",
    "model.values",
    "pose.places",
    "power.definitions",
    "power.numbers",
    "routine.quotient",
    "syntax.words",
}
"""Small functions on a stage's words or data, which lead to no other stage."""

AGAIN = {"kinematics.release"}
"""A stage that is run once more, on a mechanism that was changed for it."""

LATE = {
    ("driver.py", "figure.from_pose"),
    ("driver.py", "statics.diagrams"),
    ("driver.py", "stroke.from_balance"),
    ("api.py", "routine.evaluate"),
    ("api.py", "sympy"),
    ("formula/to_sympy.py", "sympy"),
    ("power/from_plan.py", "kinematics.release"),
    ("power/conclusions.py", "power.friction.course"),
    ("power/conclusions.py", "power.friction.locking"),
    ("power/conclusions.py", "power.friction.study"),
    ("driver.py", "power.friction.constant"),
    ("power/friction/from_balance.py", "power.friction.results"),
    ("power/from_plan.py", "power.joint_forces"),
    ("power/from_plan.py", "power.reactions"),
    ("statics/referee.py", "statics.friction"),
    ("statics/referee.py", "statics.joint_forces"),
}
"""Imports inside a function: what few descriptions ask for, and numbers and sympy."""


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


def own(path: Path) -> Iterator[str]:
    """Yield the modules of mechc that a module imports."""
    for name, node in imported(path, ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.level and name:
            yield name


def stage(name: str) -> str:
    return name.split(".")[0].split("/")[0]


@pytest.mark.parametrize("path", modules(), ids=name_of)
def test_imports_point_down(path: Path) -> None:
    here = stage(name_of(path))
    if here == "__init__":
        return
    for name in own(path):
        assert ORDER.index(stage(name)) <= ORDER.index(here), f"{here} imports {name}"
        if here not in TOP and stage(name) not in [*BASE, here]:
            known = DATA | VOCABULARY | AGAIN
            assert name in known, f"{here} imports {name}, which is no data module"


def test_statics_is_a_second_opinion() -> None:
    for path in (PACKAGE / "statics").glob("*.py"):
        for name in own(path):
            assert stage(name) not in ("kinematics", "power"), f"{path.name}: {name}"


def test_no_import_hides_in_a_function() -> None:
    for path in modules():
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for function in ast.walk(tree):
            if isinstance(function, ast.FunctionDef):
                for name, _ in imported(path, function):
                    assert (name_of(path), name) in LATE


def test_no_import_cycle() -> None:
    graph = {name_of(p)[:-3].replace("/", "."): set(own(p)) for p in modules()}
    done: set[str] = set()
    while ready := [
        m for m, needs in graph.items() if m not in done and needs & graph.keys() <= done
    ]:
        done.update(ready)
    assert done == graph.keys(), f"cycle among {sorted(graph.keys() - done)}"


def test_every_folder_says_what_it_promises() -> None:
    for path in PACKAGE.rglob("__init__.py"):
        assert ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))), path


def test_the_lists_above_name_what_there_is() -> None:
    used = {name for path in modules() for name in own(path) if stage(name) != stage(name_of(path))}
    assert used >= VOCABULARY
    for name in DATA | VOCABULARY:
        assert PACKAGE.joinpath(*name.split(".")).with_suffix(".py").is_file(), name
