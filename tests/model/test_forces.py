"""What forces and friction may be: coefficients within sense, loads on a mirror line."""

import pytest

from mechc.diagnostics import MechcError
from mechc.driver import Compilation
from mechc.source import Source

LEVER = """
pivot O
link OAB
OA = 60 mm @ 20 deg
OB = 90 mm @ 200 deg
force P at A along -y
force F at B along -y
find k = P/F
friction pins {coefficient} diameter 10 mm
"""


def codes(text: str) -> list[str]:
    """Return the codes of what the model says of a description."""
    compilation = Compilation(Source("forces.mech", text))
    try:
        assert compilation.mechanism
    except MechcError as error:
        return [d.code for d in error.diagnostics]
    return [d.code for d in compilation.report.sorted()]


@pytest.mark.parametrize(
    ("coefficient", "found"), [("0", []), ("0.1", []), ("-0.1", ["E274"]), ("1.5", ["W251"])]
)
def test_a_coefficient_of_friction_is_not_negative(coefficient, found):
    assert codes(LEVER.format(coefficient=coefficient)) == found


JAWS = """
slider K along 120 deg
pivot O
link KA
link OA
KA = 80 mm @ 150 deg
OA = 60 mm @ 35 deg
mirror across 120 deg sharing K
force F at K along {along} deg
torque M on OA
find k = M/F
"""


@pytest.mark.parametrize(("along", "found"), [(120, []), (300, []), (100, ["E263"])])
def test_a_force_on_a_shared_point_is_along_the_mirror_line_and_a_couple_may_be_anywhere(
    along, found
):
    assert codes(JAWS.format(along=along)) == found
