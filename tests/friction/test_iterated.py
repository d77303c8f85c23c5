"""The coupled equations as they are printed: the forces that are found by iteration solve them."""

import pytest

from mechc.compilation import Compilation
from mechc.formula.evaluate import evaluate
from mechc.friction.solution import FrictionStep, SolvedWithFriction
from mechc.model.values import completed
from mechc.power.numbers import pose_values
from mechc.source import Source
from small_mechanisms import LOADED_COUPLER

SLOT = """
param r = 50 mm
param phi = 60 deg
drive phi from 40 deg to 140 deg
pivot O at (0 mm, 0 mm)
link OA
OA = r @ phi
slot T in OA
slider T along 180 deg through (0 mm, 80 mm)
torque M on OA
force F at T along 180 deg
friction pins 0.1 diameter 6 mm
friction contact T 0.1
friction slider T 0.1
find k = M/F
"""


def solved(text: str) -> dict[str, tuple[SolvedWithFriction, FrictionStep, dict[str, float]]]:
    """Return each result that is iterated, the step that says so, and all values at the pose."""
    compilation, found = Compilation(Source("made.mech", text)), {}
    for one in compilation.solution.solved:
        if isinstance(one, SolvedWithFriction) and one.steps and one.steps[0].kind == "iterated":
            values = completed(pose_values(compilation.pose), one.result.where)
            printed = completed(values, one.result.case.where)
            found[one.result.name] = one, one.steps[0], printed
    return found


@pytest.mark.parametrize("mechanism", [LOADED_COUPLER, SLOT], ids=["coupler", "slot"])
def test_the_forces_that_are_found_solve_the_equations_that_are_printed(mechanism):
    found = solved(mechanism)
    assert {"k_f", "k_hold"} <= found.keys()
    for name, (_, step, values) in found.items():
        assert step.equations, name
        for force, components in step.equations:
            known = evaluate(force, values)
            assert known > 0
            assert evaluate(components, values) == pytest.approx(known, rel=1e-9), name
