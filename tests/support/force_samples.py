"""Random mechanisms with forces, compiled, beside the reference at the same values."""

from collections.abc import Iterator
from random import Random
from typing import NamedTuple

import numpy as np

from force_mechanisms import Sample, given
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError, Report
from mechc.friction.promises import broken_promises
from mechc.routine.evaluate import evaluate
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.notation import read
from reference_forces import Forces, NoBalance, arms_at
from reference_geometry import Values, defaults, defined, every

LARGEST_CONDITION = 1e6
"""Beyond this a mechanism is too near to a singular pose to compare digits."""


def tree_of(text: str) -> ast.File:
    source = Source("sample.mech", text)
    return read(source, Report(source))


def reference(sample: Sample, tree: ast.File, values: Values) -> Forces:
    return Forces(tree, values, arms_at(sample.places) if sample.places else None)


def sizes_of(sample: Sample, forces: Forces, force: float = 1.0) -> Values:
    """Return the sizes of the loads that are given: F, and weights."""
    known = forces.known()
    return {name: known.get(name, force) for name in sample.given.split()}


def pushing(sample: Sample) -> Sample | None:
    """Return the sample with every contact turned so that it pushes; None near singular poses."""
    tree = tree_of(sample.text)
    forces = reference(sample, tree, defaults(tree))
    try:
        found, condition = forces.solve(sample.drive, sizes_of(sample, forces))
    except NoBalance:
        return None
    if condition > LARGEST_CONDITION or abs(found[-1]) < 1e-4:
        return None
    pulling = {
        s.point.text
        for s in every(tree, ast.Contact)
        if forces.value(found, forces.weights(f"N_{s.point.text}")[0]) < 0
    }
    lines = [
        f"{line} + 180 deg" if line.startswith("contact") and line.split()[1] in pulling else line
        for line in sample.text.splitlines()
    ]
    return sample._replace(text="\n".join(lines))


def samples(
    seeds: range, ratio: bool = True, groups: int | None = None
) -> Iterator[tuple[int, Sample]]:
    """Yield the samples of some seeds that can be compared."""
    for seed in seeds:
        sample = pushing(given(seed, groups, ratio))
        if sample is not None:
            yield seed, sample


class Compiled(NamedTuple):
    """A text as the compiler takes it, after the referee has looked at it."""

    tree: ast.File
    compilation: Compilation

    def values(self) -> Values:
        return defaults(self.tree)

    def nearby(self, dice: Random, spread: float = 1.0) -> Values:
        """Return values in the ranges of the parameters that have one."""
        moved = {}
        for parameter in self.compilation.mechanism.parameters:
            value = self.values().get(parameter.name)
            if parameter.range and value is not None:
                half = float(np.radians(40)) * spread
                value += dice.uniform(-half, half)
            if value is not None:
                moved[parameter.name] = value
        return defined(self.tree, moved)

    def results(self, values: Values) -> dict[str, float]:
        """Return all results whose inputs have values, by the interpreter."""
        functions = self.compilation.routine.functions
        ready = [f for f in functions if all(i.name in values for i in f.inputs)]
        return {
            f.name: float(evaluate(f, {i.name: values[i.name] for i in f.inputs})) for f in ready
        }


def compiled(text: str, name: str) -> Compiled:
    compilation = Compilation(Source(name, text))
    verdict = compilation.verdict
    assert verdict.agrees
    assert verdict.trials, verdict.remarks
    assert broken_promises(compilation.solution) == []
    return Compiled(compilation.tree, compilation)


def locked(error: MechcError) -> bool:
    """Tell whether only locking, a contact that pulls or a half by itself was reported."""
    codes = {d.code for d in error.diagnostics if d.code[0] == "E"}
    return codes <= {"E278", "E507", "E604"}


def with_friction(seed: int, sample: Sample, *more: str) -> Compiled | None:
    """Return the sample with friction, None where it locks at the default pose."""
    text = sample.with_friction(Random(seed), *more)
    try:
        return compiled(text, f"friction_{seed}.mech")
    except MechcError as error:
        if locked(error):
            return None
        raise
