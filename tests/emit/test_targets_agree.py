"""The interpreter, the emitted Python, the compiled C and sympy agree."""

import math
from functools import cache
from pathlib import Path

import pytest

from mechc.formula.to_sympy import to_sympy
from mechc.routine.evaluate import evaluate
from mechc.routine.steps import Function
from routine_samples import LIBRARY, SAMPLES, solved
from run_targets import (
    COMPILER,
    ULP,
    Outputs,
    assert_close,
    built,
    by_c_in_batch,
    by_c_singly,
    by_interpreter,
    by_python,
    poses,
)
from sources import in_thirds

EACH = [*SAMPLES, *in_thirds(LIBRARY)]


@cache
def interpreted(sample: str) -> Outputs:
    return by_interpreter(solved(sample))


@pytest.mark.parametrize("sample", [*SAMPLES, *LIBRARY])
def test_python_is_the_interpreter(sample: str) -> None:
    found = solved(sample)
    assert_close(by_python(found), interpreted(sample), 0, found.routine)


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
@pytest.mark.parametrize("sample", EACH)
def test_c_agrees_for_one_pose_and_for_many(sample: str, tmp_path: Path) -> None:
    found = solved(sample)
    expected, made = interpreted(sample), built(found, tmp_path)
    assert_close(by_c_singly(found, made), expected, 16, found.routine)
    assert_close(by_c_in_batch(found, made), expected, 16, found.routine)


@pytest.mark.parametrize("sample", EACH)
def test_sympy_agrees(sample: str) -> None:
    found = solved(sample)
    for function in found.routine.functions:
        columns = poses(function)
        values = {name: column[0] for name, column in columns.items()}
        expected = evaluate(function, values)
        if not math.isnan(expected):
            assert by_sympy(function, values) == pytest.approx(expected, rel=1e-12, abs=1e-14)


def by_sympy(function: Function, values: dict[str, float]) -> float:
    import sympy

    scope = {sympy.Symbol(name): sympy.Float(value, 30) for name, value in values.items()}
    for step in (*function.where, function):
        value = to_sympy(step.formula).subs(scope).evalf(25)
        scope[sympy.Symbol(step.name)] = value
    return float(value)


def test_a_difference_would_be_seen() -> None:
    found = solved("clamp")
    expected = interpreted("clamp")
    off = {name: values * (1 + 256 * ULP) for name, values in expected.items()}
    with pytest.raises(AssertionError):
        assert_close(off, expected, 16, found.routine)
