"""Every mechanism of the library: both notations, its references, its second way, its code."""

import math
from functools import cache

import pytest

import reference_geometry
import reference_kinematics
from generators import scissor
from good_mechanisms import compiled
from mechc.diagnostics import Report
from mechc.routine.evaluate import evaluate
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.notation import read
from mechc.syntax.to_dsl import to_dsl
from mechc.syntax.to_yaml import to_yaml
from paths import LIBRARY

PATHS = sorted(p for p in LIBRARY.iterdir() if p.suffix in {".mech", ".yaml"})
NAMES = [p.stem for p in PATHS]

REMARKED = {"roberval_balance": {"W401"}, "claw_with_friction": {"W206"}}
"""Warnings that a mechanism has by its nature."""

every_mechanism = pytest.mark.parametrize("name", NAMES)

BEYOND_PINS = (
    ast.Drive,
    ast.Actuator,
)
"""What the reference by singular values does not read; test_closed and test_joints see to it."""


@cache
def source_of(name: str) -> Source:
    path = next(p for p in PATHS if p.stem == name)
    return Source(path.name, path.read_text(encoding="utf-8"))


@cache
def tree_of(source: Source) -> ast.File:
    report = Report(source)
    tree = read(source, report)
    report.stop_on_errors()
    return tree


# ------------------------------------------------------------------------ the text


def test_no_name_twice() -> None:
    assert len(set(NAMES)) == len(NAMES) >= 25


def test_both_notations_are_in_the_library() -> None:
    assert {p.suffix for p in PATHS} == {".mech", ".yaml"}


@every_mechanism
def test_readme_lists_it(name: str) -> None:
    assert f"`{name}`" in (LIBRARY / "README.md").read_text(encoding="utf-8")


@every_mechanism
def test_file_and_mechanism_have_one_name(name: str) -> None:
    (heading,) = reference_geometry.every(tree_of(source_of(name)), ast.Heading)
    assert heading.name.text == name
    assert heading.title


@every_mechanism
def test_has_source_and_references(name: str) -> None:
    tree = tree_of(source_of(name))
    expects = reference_geometry.every(tree, ast.Expect)
    assert reference_geometry.every(tree, ast.SourceNote)
    numbers = [e for e in expects if e.at]
    assert numbers, "no number is expected"
    is_closed = bool(reference_geometry.every(tree, ast.Drive))
    assert len(numbers) > 1 or any(not e.at for e in expects), "no formula is expected"
    assert is_closed or any(not e.at for e in expects), "no formula is expected"


@every_mechanism
def test_prints_in_both_notations_and_back(name: str) -> None:
    tree = tree_of(source_of(name))
    yaml, dsl = to_yaml(tree), to_dsl(tree)
    assert to_dsl(tree_of(Source("a.mech", dsl))) == dsl
    assert to_yaml(tree_of(Source("a.yaml", yaml))) == yaml
    assert to_yaml(tree_of(Source("a.mech", to_dsl(tree_of(Source("a.yaml", yaml)))))) == yaml


@every_mechanism
def test_is_laid_out_as_fmt_does(name: str) -> None:
    source = source_of(name)
    layout = to_yaml if source.name.endswith(".yaml") else to_dsl
    assert layout(tree_of(source)) == source.text


@pytest.mark.parametrize("n", [1, 2, 4])
def test_scissors_come_from_the_generator(n: int) -> None:
    generated = tree_of(Source("a.mech", scissor(n)))
    filed = tree_of(source_of(f"scissor_{n}"))
    assert generated.statements == filed.statements[: len(generated.statements)]


# --------------------------------------------------------------------- the results


@every_mechanism
def test_expectations_hold(name: str) -> None:
    outcomes = [finding.outcome for finding in compiled(name).findings]
    assert outcomes
    assert set(outcomes) <= {"proved", "agrees"}


@every_mechanism
def test_formulas_are_proved_not_sampled(name: str) -> None:
    formulas = [f for f in compiled(name).findings if not f.expect.at]
    assert {f.outcome for f in formulas} <= {"proved"}


@every_mechanism
def test_free_bodies_agree(name: str) -> None:
    verdict = compiled(name).verdict
    assert verdict.trials
    assert verdict.agrees


@every_mechanism
def test_nothing_is_remarked_upon(name: str) -> None:
    found = {d.code for d in compiled(name).report.diagnostics}
    assert found == REMARKED.get(name, set())


def nearby(tree: ast.File, values: dict[str, float]) -> dict[str, float]:
    """Return a nearby pose, every quantity moved by a step of its own, and the lets with them."""
    lets = {let.name.text for let in reference_geometry.every(tree, ast.Let)}
    given = ((name, value) for name, value in values.items() if name not in lets)
    moved = {name: v * (1 + 0.01 * math.sin(i + 1)) for i, (name, v) in enumerate(given)}
    return reference_geometry.defined(tree, moved)


@cache
def pinned() -> tuple[str, ...]:
    """Return the mechanisms of pins, guides and links at a given pose."""
    trees = {name: tree_of(source_of(name)) for name in NAMES}
    return tuple(
        name
        for name, tree in trees.items()
        if not any(isinstance(s, BEYOND_PINS) for s in tree.statements)
    )


@pytest.mark.parametrize("name", pinned())
@pytest.mark.parametrize("moved", [False, True], ids=["default", "nearby"])
def test_agrees_with_coordinates_and_singular_values(name: str, moved: bool) -> None:
    """Ratios and loads without friction; friction and joint forces have references elsewhere."""
    tree = tree_of(source_of(name))
    values = reference_geometry.defaults(tree)
    values = nearby(tree, values) if moved else values
    expected = reference_kinematics.results(tree, values)
    compared = 0
    for function in compiled(name).routine.functions:
        if function.name in expected and all(i.name in values for i in function.inputs):
            found = evaluate(function, {i.name: values[i.name] for i in function.inputs})
            assert float(found) == pytest.approx(expected[function.name], rel=1e-9)
            compared += 1
    assert compared


@pytest.mark.parametrize("name", pinned())
def test_unknown_lengths_do_not_matter_to_the_reference(name: str) -> None:
    tree = tree_of(source_of(name))
    one, two = (reference_kinematics.results(tree, seed=seed) for seed in (1, 2))
    assert one == pytest.approx(two, rel=1e-9)
