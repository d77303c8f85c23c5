"""Position: what follows from each loop, in the order in which it follows."""

from collections.abc import Iterator, Sequence

from ...formula.walk import reached, symbols
from ...model.result import Definition
from ...pose.pose import Pose
from ...study.analysis import Analysis
from .steps import Derivation, PositionStep


def position_steps(pose: Pose, derivation: Derivation) -> Iterator[PositionStep]:
    """Yield the loops that a derivation rests on, with what each gives of it."""
    formulas = {d.name: d.formula for d in pose.definitions}
    needed = reached(_mentioned(derivation), formulas)
    for loop in pose.solved:
        names = [n for n in loop.names if n in needed]
        if names:
            found = tuple(Definition(n, formulas[n]) for n in names)
            yield PositionStep(loop.kind, loop.points, loop.is_clockwise, found)


def _mentioned(derivation: Derivation) -> Iterator[str]:
    """Yield the names in everything that a derivation prints."""
    for step in derivation.steps:
        for equation in (*step.relations, *step.results):
            yield from symbols(equation.right) | symbols(equation.left)
    for balance in derivation.balances:
        yield from symbols(balance.left)
    for explanation in derivation.explanations:
        for paragraph in explanation.paragraphs:
            for equation in paragraph.equations:
                yield from symbols(equation.left) | symbols(equation.right)
        yield from _of_definitions(explanation.where)
    for result in derivation.results:
        yield from _of_result(result)


def _of_result(result: Analysis) -> Iterator[str]:
    yield from symbols(result.formula)
    yield from _of_definitions(result.where)


def _of_definitions(where: Sequence[Definition]) -> Iterator[str]:
    for definition in where:
        yield from symbols(definition.formula)
