"""A condition with '=' holds where both sides are equal but for rounding, in code as on paper."""

import numpy as np
import pytest

import mechc
from mechc.emit.c.real import in_single_precision

EQUALITY = """\
param a = 200 mm
param alpha = {given} deg
pivot O
slider K along y
link OB
link BK
OB = a @ 90 deg + alpha
BK = a @ 90 deg - alpha
force P at B along 0 deg
force F at K along -90 deg
find k = P/F
require alpha = {given} deg
"""


@pytest.mark.parametrize("given", ["10", "12.3", "13.7", "17", "23", "29", "41.9"])
def test_it_holds_at_the_value_itself(given):
    mechanism = mechc.loads(EQUALITY.format(given=given))
    expected = 2 * np.tan(np.radians(float(given)))
    space: dict = {"__name__": "module"}
    exec(mechanism.emit("python"), space)
    assert mechanism.evaluate()["k"] == pytest.approx(expected)
    assert space["k"](**space["DEFAULTS"]) == pytest.approx(expected)


def test_it_fails_beside_it():
    mechanism = mechc.loads(EQUALITY.format(given="12.3"))
    near = np.radians(12.3) + np.array([0, 1e-12, 1e-8, -1e-6])
    assert np.isnan(mechanism.evaluate(alpha=near)["k"]).tolist() == [False, False, True, True]
    assert "k_gradient" in mechanism.emit("python", gradient=True)


def test_single_precision_has_slacks_of_its_own():
    code = in_single_precision("x/1073741824.0 + y/1099511627776.0")
    assert code == "x/1e+5f + y/1e+5f"
