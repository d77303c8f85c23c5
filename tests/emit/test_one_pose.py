"""Results on floats are those on arrays, where they have no value too."""

import itertools
import math

import numpy as np
import pytest

from mechc.emit.python.evaluator import Evaluator, on_floats
from mechc.routine.evaluate import evaluate
from mechc.routine.steps import Solve
from routine_samples import SAMPLES, solved
from run_targets import poses

AWKWARD = (0.0, -1.0, math.inf, math.nan, 1e200)


CLOSED = ("crank_rocker", "watt_closed", "karpenko_fig9_with_friction")


@pytest.mark.parametrize("name", [*SAMPLES, *CLOSED])
def test_floats_give_what_arrays_give(name):
    listed = ((f, on_floats(f)) for f in solved(name).routine.functions)
    for function, own in ((f, own) for f, own in listed if own):
        values = {name: array[:3] for name, array in poses(function).items()}
        wanted = np.broadcast_to(evaluate(function, values), 3)
        for i in range(3):
            found = own(*(float(array[i]) for array in values.values()))
            assert found == pytest.approx(wanted[i], rel=1e-9, nan_ok=True)


@pytest.mark.parametrize("name", ["clamp", "crank_rocker", "karpenko_fig9_with_friction"])
def test_where_floats_raise_an_error_arrays_state_it(name):
    routine = solved(name).routine
    evaluator, function = Evaluator(routine), routine.functions[0]
    names = [i.name for i in function.inputs]
    for awkward in itertools.islice(itertools.product(AWKWARD, repeat=len(names)), 0, None, 101):
        given = dict(zip(names, awkward, strict=True))
        wanted = evaluate(function, given)
        found = evaluator.values(given, set())[function.name]
        assert found == pytest.approx(wanted, rel=1e-12, nan_ok=True), given


def test_what_iterates_has_no_form_on_floats():
    (function, *_) = solved("triad_closed").routine.functions
    assert any(isinstance(step, Solve) for step in function.steps)
    assert on_floats(function) is None
